//! Immediate mode: GL 2.1, sections 2.6 and 2.7.
//!
//! `glBegin` opens a collection of vertices: positions, and a column for each attribute that is set
//! before `glEnd`, which draws them. Attributes that are not set are constants of the draw.

use super::arrays::generic;
use super::calls::topology;
use super::translate::{Elements, draw};
use crate::assembly::running as assembly;
use crate::context::Context;
use crate::error::{Result, invalid_operation};
use crate::framebuffer::complete::checked_drawable;
use crate::interface::{ATTRIB_TEX_COORD, ATTRIB_VERTEX};
use crate::object::textures::texture_unit;
use crate::state::material::{MATERIAL_COLUMNS, Materials};
use crate::state::{LOCATIONS, State};
use crate::types::*;
use rasterizer::driver::{Buffer, Topology, VertexBinding, VertexFormat, VertexSource, VertexType};

const SECTION: &str = "GL 2.1, section 2.6.3";
/// What can have a column: the attributes, and behind them the parts of the materials.
const COLUMNS: usize = LOCATIONS + MATERIAL_COLUMNS;
/// Bytes of a value in a column.
pub(crate) const VALUE: usize = 16;
/// More vertices than this between `glBegin` and `glEnd` are an error.
const MAX_VERTICES: usize = 1 << 26;

/// The vertices since `glBegin`.
#[derive(Debug)]
pub(crate) struct Immediate {
    topology: Topology,
    positions: Vec<[f32; 4]>,
    /// By location; empty until the attribute is set.
    columns: Vec<Vec<[f32; 4]>>,
    /// The locations whose columns are in use.
    used: Vec<usize>,
    /// What the materials were before the first `glMaterial` since `glBegin`.
    materials: Option<Box<Materials>>,
}

/// What an attribute call sets.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Slot {
    /// The position: ends the vertex.
    Vertex,
    /// A conventional attribute, or a part of a material, by its location.
    Location(u8),
    /// The coordinates of a texture unit, as `GL_TEXTUREi`.
    TexCoord(GLenum),
    /// A generic attribute by its index; 0 is the position.
    Generic(GLuint),
}

pub(crate) fn begin(context: &mut Context, mode: GLenum) -> Result<()> {
    if context.record_begin(mode) {
        return Ok(());
    }
    if context.immediate.is_some() {
        return invalid_operation(SECTION, "glBegin was called before: glEnd is missing");
    }
    let topology = topology(mode)?;
    assembly::check(context)?;
    context.immediate = Some(Immediate::new(topology));
    Ok(())
}

impl Immediate {
    fn new(topology: Topology) -> Self {
        Self {
            topology,
            positions: Vec::new(),
            columns: vec![Vec::new(); COLUMNS],
            used: Vec::new(),
            materials: None,
        }
    }
}

/// Ends the primitive and begins another of its kind; false where none was begun.
///
/// # Errors
/// As `glEnd`.
pub(crate) fn restart(context: &mut Context) -> Result<bool> {
    let Some(topology) = context.immediate.as_ref().map(|immediate| immediate.topology) else {
        return Ok(false);
    };
    end(context)?;
    context.immediate = Some(Immediate::new(topology));
    Ok(true)
}

pub(crate) fn end(context: &mut Context) -> Result<()> {
    if context.record_end() {
        return Ok(());
    }
    finish(context)
}

/// Draws what was collected.
fn finish(context: &mut Context) -> Result<()> {
    let Some(immediate) = context.immediate.take() else {
        return invalid_operation(SECTION, "no glBegin is open: it was not called, or was refused");
    };
    let count = immediate.positions.len();
    if count == 0 {
        return checked_drawable(context);
    }
    let mut bytes = Vec::with_capacity((immediate.used.len() + 1) * count * VALUE);
    bytes.extend_from_slice(bytemuck::cast_slice(&immediate.positions));
    for &location in &immediate.used {
        bytes.extend_from_slice(bytemuck::cast_slice(&immediate.columns[location]));
    }
    context.recorder.hold(bytes.len());
    let buffer = Buffer::new(bytes);
    // A program reads the materials that were current before: a change is sure to have an effect on
    // what comes after `glEnd` only (section 2.14.2), and everywhere it is left at that.
    let mut materials = immediate.materials;
    let mut exchange = |context: &mut Context| {
        if let Some(others) = &mut materials {
            std::mem::swap(&mut context.state.materials, others);
        }
    };
    exchange(context);
    let result = draw_columns(context, immediate.topology, &buffer, count, |location| {
        immediate.used.iter().position(|used| *used == location)
    });
    exchange(context);
    result
}

/// Draws `count` vertices of a buffer of columns: positions, then a column for each attribute that
/// `column_of` gives a number. The others are the current values.
///
/// # Errors
/// As a draw.
pub(crate) fn draw_columns(
    context: &mut Context,
    topology: Topology,
    buffer: &Buffer,
    count: usize,
    column_of: impl Fn(usize) -> Option<usize>,
) -> Result<()> {
    let column = |index: usize| VertexSource::Array {
        buffer: buffer.clone(),
        offset: index * count * VALUE,
        stride: VALUE,
        ty: VertexType::F32,
        components: 4,
        format: VertexFormat::Plain,
        divisor: 0,
    };
    let attributes = (0..LOCATIONS).map(|location| {
        let source = if location == 0 || location == usize::from(ATTRIB_VERTEX) {
            column(0)
        } else {
            match column_of(location) {
                Some(index) => column(index + 1),
                None => VertexSource::Constant(context.state.current[location]),
            }
        };
        VertexBinding { location: location as u8, source }
    });
    let materials = (LOCATIONS..COLUMNS).filter_map(|location| {
        let source = column(column_of(location)? + 1);
        Some(VertexBinding { location: location as u8, source })
    });
    let vertices = attributes.chain(materials).collect();
    let elements = Elements::Range { first: 0, count: count as u32, instances: 1 };
    draw(context, topology, vertices, &elements)
}

/// The location that an attribute call sets; `None` for the position.
///
/// # Errors
/// When there is no such unit or generic attribute.
pub(crate) fn location(slot: Slot) -> Result<Option<usize>> {
    Ok(match slot {
        Slot::Vertex => None,
        Slot::Location(location) => Some(usize::from(location)),
        Slot::TexCoord(texture) => {
            let unit = texture_unit("GL 2.1, section 2.7", texture)?;
            Some(usize::from(ATTRIB_TEX_COORD + unit))
        }
        Slot::Generic(index) => Some(usize::from(generic(index)?)).filter(|&index| index != 0),
    })
}

/// Sets an attribute; a position ends the vertex.
pub(crate) fn attribute(context: &mut Context, slot: Slot, value: [f32; 4]) -> Result<()> {
    if context.record_attribute(slot, value) {
        return Ok(());
    }
    let Some(location) = location(slot)? else {
        // Outside of glBegin and glEnd, generic attribute 0 has a value as others do.
        if matches!(slot, Slot::Generic(_)) && context.immediate.is_none() {
            set_current(context, 0, value);
        }
        return vertex(context, value);
    };
    if let Some(immediate) = &mut context.immediate {
        let column = &mut immediate.columns[location];
        if !immediate.used.contains(&location) {
            // The vertices so far had the value from before.
            let before = current(&context.state, location);
            column.resize(immediate.positions.len(), before);
            immediate.used.push(location);
            if location >= LOCATIONS && immediate.materials.is_none() {
                immediate.materials = Some(Box::new(context.state.materials.clone()));
            }
        }
    }
    set_current(context, location, value);
    Ok(())
}

/// The current value of an attribute, or of a part of a material.
pub(crate) fn current(state: &State, location: usize) -> [f32; 4] {
    match state.current.get(location) {
        Some(value) => *value,
        None => state.materials.column(location),
    }
}

/// Changes the current value of an attribute, or of a part of a material.
pub(crate) fn set_current(context: &mut Context, location: usize, value: [f32; 4]) {
    match context.state.current.get_mut(location) {
        Some(current) => *current = value,
        None => context.state.materials.set_column(location, value),
    }
}

/// Ends a vertex. Outside `glBegin` and `glEnd` it has no effect.
fn vertex(context: &mut Context, position: [f32; 4]) -> Result<()> {
    let Some(immediate) = &mut context.immediate else { return Ok(()) };
    if immediate.positions.len() == MAX_VERTICES {
        return invalid_operation(SECTION, format!("more than {MAX_VERTICES} vertices"));
    }
    for &location in &immediate.used {
        immediate.columns[location].push(current(&context.state, location));
    }
    immediate.positions.push(position);
    Ok(())
}
