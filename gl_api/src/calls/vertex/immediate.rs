//! `glBegin`, `glEnd` and the attributes of immediate mode: GL 2.1, sections 2.6 and 2.7.
//!
//! `glBegin` opens a collection of vertices: positions, and a column for each attribute that is set
//! before `glEnd`, which draws them. Attributes that are not set are constants of the draw. Consecutive
//! `glBegin` to `glEnd` with no other call in between become one draw.

use crate::base::error::{Result, invalid_operation};
use crate::base::limits::LOCATIONS;
use crate::base::memory::out_of_memory;
use crate::base::topology::topology;
use crate::base::types::*;
use crate::context::Context;
use crate::context::immediate::{
    COLUMNS, Column, ColumnComponents, Columns, Immediate, NO_COLUMN, Slot, VALUE, current,
    location,
};
use crate::context::pending_primitives::PendingPrimitives;
use crate::context::recorder::elements::Elements;
use crate::draw::assembly_words as assembly;
use crate::draw::completeness::checked_drawable;
use crate::draw::no_effect;
use crate::draw::pending_primitives::{append_pending, draw_pending, keep_pending};
use crate::draw::record::{constants_needed, draw};
use crate::interface::{
    ATTRIB_COLOR, ATTRIB_EDGE_FLAG, ATTRIB_MATERIAL, ATTRIB_SECONDARY_COLOR, ATTRIB_TEX_COORD,
    ATTRIB_VERTEX,
};
use crate::state::enable::Flag;
use rasterizer::driver::{Buffer, Topology, VertexBinding, VertexFormat, VertexSource, VertexType};
use texunit::lanes::FloatEnv;

const SECTION: &str = "GL 2.1, section 2.6.3";
const VERTICES: &str = "the vertices since glBegin";
/// More vertices than this between `glBegin` and `glEnd` are an error.
const MAX_VERTICES: usize = 1 << 26;

pub(crate) fn begin(context: &mut Context, mode: GLenum) -> Result<()> {
    if context.record_begin(mode) {
        return Ok(());
    }
    if context.immediate.is_some() {
        return invalid_operation(SECTION, "glBegin was called before: glEnd is missing");
    }
    let topology = topology(mode)?;
    crate::draw::program_pipeline::prepare(context);
    crate::draw::program_pipeline::check(context)?;
    assembly::check(context)?;
    context.immediate = Some(Immediate::new(topology));
    Ok(())
}

impl Immediate {
    /// Draws the vertices, of which there are some.
    pub(crate) fn draw(&self, context: &mut Context) -> Result<()> {
        let count = self.positions.len();
        let mut bytes = Vec::new();
        let needed = (self.columns.len() + 1) * count * VALUE;
        bytes.try_reserve_exact(needed).map_err(out_of_memory(SECTION, VERTICES))?;
        bytes.extend_from_slice(bytemuck::cast_slice(&self.positions));
        for column in &self.columns {
            bytes.extend_from_slice(bytemuck::cast_slice(&column.values));
        }
        context.recorder.hold(bytes.len());
        let buffer = Buffer::new(bytes);
        let mut components = [ColumnComponents::of(&self.positions); COLUMNS + 1];
        for (components, column) in components[1..].iter_mut().zip(&self.columns) {
            *components = ColumnComponents::of(&column.values);
        }
        let columns = Columns { buffer: &buffer, components, count, range: 0..count };
        draw_columns(context, self.topology, columns, |location| self.column_of(location))
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

/// Draws what was collected, or has it wait for more.
fn finish(context: &mut Context) -> Result<()> {
    let Some(mut immediate) = context.immediate.take() else {
        return invalid_operation(SECTION, "no glBegin is open: it was not called, or was refused");
    };
    if append_pending(context, &mut immediate) {
        return Ok(());
    }
    draw_pending(context);
    if immediate.positions.is_empty() {
        return checked_drawable(context);
    }
    // A program reads the materials that were current before: a change is sure to have an effect on
    // what comes after `glEnd` only (section 2.14.2), and everywhere it is left at that.
    let mut materials = immediate.materials.take();
    let mut exchange = |context: &mut Context| {
        if let Some(others) = &mut materials {
            std::mem::swap(&mut context.state.materials, others);
        }
    };
    exchange(context);
    let result = immediate.draw(context);
    exchange(context);
    if result.is_ok() && materials.is_none() {
        keep_pending(context, immediate);
    }
    result
}

/// Draws vertices of a buffer of columns; `column_of` gives the number of an attribute's. The others
/// are the current values.
///
/// # Errors
/// As a draw.
pub(crate) fn draw_columns(
    context: &mut Context,
    topology: Topology,
    Columns { buffer, components, count, range: part }: Columns<'_>,
    column_of: impl Fn(usize) -> Option<usize>,
) -> Result<()> {
    let mut vertices = context.recorder.empty_bindings();
    let constants = constants_needed(context);
    for location in 0..COLUMNS {
        let index = match location == 0 || location == usize::from(ATTRIB_VERTEX) {
            true => Some(0),
            false => column_of(location).map(|index| index + 1),
        };
        let source = match (index, context.state.current.get(location)) {
            (Some(index), _) => VertexSource::Array {
                buffer: buffer.clone(),
                first: 0,
                offset: (index * count + part.start) * VALUE,
                stride: VALUE,
                ty: VertexType::F32,
                components: components[index].count(),
                format: VertexFormat::Plain,
                divisor: 0,
            },
            (None, Some(&value)) if constants >> location & 1 == 1 => VertexSource::Constant(value),
            (None, _) => continue,
        };
        vertices.push(VertexBinding { location: location as u8, source });
    }
    let elements = Elements::Range { first: 0, count: part.len() as u32, instances: 0..1 };
    draw(context, topology, vertices, &elements)
}

/// Sets an attribute; a position ends the vertex.
pub(crate) fn attribute(context: &mut Context, slot: Slot, value: [f32; 4]) -> Result<()> {
    if context.record_attribute(slot, value) {
        return Ok(());
    }
    let Some(location) = location(slot)? else {
        // Outside of glBegin and glEnd, generic attribute 0 has a value as others do.
        if matches!(slot, Slot::Generic(_)) && context.immediate.is_none() {
            context.attributes_set |= 1;
            set_current(context, 0, value);
        }
        return vertex(context, value);
    };
    if let Some(immediate) = &mut context.immediate
        && immediate.column_by_location[location] == NO_COLUMN
    {
        // The vertices so far had the value from before.
        let (count, mut values) = (immediate.positions.len(), Vec::new());
        if let Err(error) = values.try_reserve_exact(count) {
            immediate.lose();
            return Err(out_of_memory(SECTION, VERTICES)(error));
        }
        values.resize(count, current(&context.state, location));
        immediate.column_by_location[location] = immediate.columns.len() as u8;
        immediate.columns.push(Column { location, values });
        if location >= LOCATIONS && immediate.materials.is_none() {
            immediate.materials = Some(Box::new(context.state.materials.clone()));
        }
    }
    if context.immediate.is_none() && location < LOCATIONS {
        context.attributes_set |= 1 << location;
    }
    set_current(context, location, value);
    Ok(())
}

/// Changes the current value of an attribute, or of a part of a material.
pub(crate) fn set_current(context: &mut Context, location: usize, value: [f32; 4]) {
    if current(&context.state, location).map(f32::to_bits) == value.map(f32::to_bits) {
        return;
    }
    if let Some(PendingPrimitives::Vertices(pending)) = &context.pending
        && pending.column_of(location).is_none()
    {
        // Attributes are set in the host's floating-point state. What ended has the value from before as a constant.
        let _float_env = FloatEnv::enter();
        draw_pending(context);
    }
    context.state_changes.count_call();
    if is_number(context, location, value) {
        context.state_changes.values_only();
    }
    match context.state.current.get_mut(location) {
        Some(current) => *current = value,
        None => context.state.materials.set_column(location, value),
    }
}

/// Whether draws are decided alike with the current value of an attribute and with another one.
fn is_number(context: &Context, location: usize, value: [f32; 4]) -> bool {
    // Whether a material shines depends on its colours.
    let is_tracked = context.state.enables.has(Flag::ColorMaterial);
    match u8::try_from(location) {
        Ok(ATTRIB_COLOR) => !is_tracked,
        Ok(ATTRIB_EDGE_FLAG | ATTRIB_MATERIAL..) | Err(_) => false,
        // Whether there is a sum depends on whether one of its colours is black.
        Ok(ATTRIB_SECONDARY_COLOR) => {
            let is_black =
                |[red, green, blue, _]: [f32; 4]| no_effect::is_black([red, green, blue]);
            is_black(context.state.current[location]) == is_black(value)
        }
        // Whether coordinates are divided depends on the last one.
        Ok(ATTRIB_TEX_COORD..) => {
            context.state.current[location][3].to_bits() == value[3].to_bits()
        }
        Ok(_) => true,
    }
}

/// Ends a vertex. Outside `glBegin` and `glEnd` it has no effect.
fn vertex(context: &mut Context, position: [f32; 4]) -> Result<()> {
    let Some(immediate) = &mut context.immediate else { return Ok(()) };
    if immediate.positions.len() == MAX_VERTICES {
        return invalid_operation(SECTION, format!("more than {MAX_VERTICES} vertices"));
    }
    if immediate.is_lost {
        return Ok(());
    }
    if let Err(error) = immediate.make_room(1) {
        immediate.lose();
        return Err(out_of_memory(SECTION, VERTICES)(error));
    }
    for column in &mut immediate.columns {
        column.values.push(current(&context.state, column.location));
    }
    immediate.positions.push(position);
    Ok(())
}
