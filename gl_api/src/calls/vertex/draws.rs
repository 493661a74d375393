//! `glDrawArrays` and `glArrayElement`, and what draws by index ([`super::elements`]) have in common with them: GL 2.1,
//! section 2.8.

use crate::base::error::{Result, invalid_operation, not_negative};
use crate::base::limits::LOCATIONS;
use crate::base::topology::topology;
use crate::base::types::*;
use crate::calls::buffer::map::take_client_writes;
use crate::calls::vertex::array_objects::require_vertex_array;
use crate::calls::vertex::immediate::attribute;
use crate::context::Context;
use crate::context::immediate::Slot;
use crate::context::recorder::elements::Elements;
use crate::draw::array_names::{array_of, extent};
use crate::draw::assembly_words::has_vertex_program;
use crate::draw::batching::{remember_last_draw, try_append};
use crate::draw::es_capture;
use crate::draw::record::{constants_needed, draw};
use crate::draw::vertex_range::{VertexRange, needs_vertex_range, vertex_source};
use crate::draw::warnings;
use crate::interface::ATTRIB_VERTEX;
use rasterizer::driver::{Topology, VertexBinding, VertexSource};

pub(crate) const SECTION: &str = "GL 2.1, section 2.8";
const INSTANCED: &str = "ARB_draw_instanced";

/// The instances of a draw.
#[derive(Clone, Copy)]
pub(crate) struct Instances {
    pub count: GLsizei,
    /// The first element of arrays with a divisor (`ARB_base_instance`).
    pub base: GLuint,
}

impl Instances {
    pub const ONE: Self = Self::new(1);

    pub const fn new(count: GLsizei) -> Self {
        Self { count, base: 0 }
    }

    pub(super) fn checked(self) -> Result<CheckedInstances> {
        let count = not_negative(INSTANCED, "primcount", self.count.into())? as u32;
        Ok(CheckedInstances { count, base: self.base })
    }
}

/// The instances of a draw, no negative number of them.
#[derive(Clone, Copy)]
pub(super) struct CheckedInstances {
    pub count: u32,
    pub base: u32,
}

/// Where every attribute of an array draw comes from, of those that matter.
pub(super) fn bindings(
    context: &mut Context,
    vertex_range: VertexRange<'_>,
) -> Result<Vec<VertexBinding>> {
    let mut bindings = context.recorder.empty_bindings();
    let arrays = &context.state.arrays.by_location;
    let constants = constants_needed(context);
    for location in 0..LOCATIONS {
        let from = array_of(context, location);
        let source = if arrays[from].enabled {
            vertex_source(context, from, vertex_range)?
        } else if constants >> location & 1 == 1 {
            VertexSource::Constant(context.state.current[location])
        } else {
            continue;
        };
        bindings.push(VertexBinding { location: location as u8, source });
    }
    Ok(bindings)
}

/// Whether there are positions to draw; without, nothing is drawn.
pub(crate) fn has_positions(context: &mut Context, topology: Topology) -> bool {
    crate::draw::program_pipeline::prepare(context);
    let arrays = &context.state.arrays.by_location;
    let program = context.has_program();
    if program && !arrays.iter().any(|array| array.enabled) {
        warnings::arrays::none(context, topology);
        return true;
    }
    if !context.profile.is_compatibility() && !program {
        context.debug.warn(
            "draw: nothing is drawn, as no program is in use, and there is no fixed function: call \
             glUseProgram"
                .into(),
        );
        return false;
    }
    let any = program
        || arrays[0].enabled
        || arrays[usize::from(ATTRIB_VERTEX)].enabled
        || has_vertex_program(context);
    if !any {
        context.debug.warn(
            "draw: nothing is drawn, as no array of positions is enabled: call \
             glEnableClientState(GL_VERTEX_ARRAY) or glEnableVertexAttribArray(0)"
                .into(),
        );
    }
    any
}

/// Checks that the array of positions has all vertices of a draw; without one, the first array.
/// Other arrays that are too short read as zeros.
fn check_range(
    context: &Context,
    vertices: &[VertexBinding],
    first: usize,
    count: usize,
) -> Result<()> {
    let arrays = vertices.iter().filter_map(|binding| match &binding.source {
        VertexSource::Array { offset, stride, ty, components, divisor: 0, .. } => {
            let vertex = ty.bytes(*components);
            Some((binding.location, binding.source.end(), *offset, *stride, vertex))
        }
        // Elements of instances are as many as there are instances.
        VertexSource::Array { .. } | VertexSource::Constant(_) => None,
    });
    let by_rank = arrays.min_by_key(|array| (array.0 != ATTRIB_VERTEX, array.0));
    let Some((location, length, offset, stride, vertex)) = by_rank else { return Ok(()) };
    let last = first as u128 + count as u128 - 1;
    let needed = offset as u128 + last * stride as u128 + vertex as u128;
    if needed > length as u128 {
        return invalid_operation(
            SECTION,
            format!(
                "vertices {first} to {last} end at byte {needed}, but {}",
                extent(context, location, length)
            ),
        );
    }
    Ok(())
}

/// Checks that the arrays have the vertices of a draw, which is not drawn yet.
pub(crate) fn check_arrays(context: &mut Context, first: GLint, count: GLsizei) -> Result<()> {
    let first = not_negative(SECTION, "first", first.into())?;
    let count = not_negative(SECTION, "count", count.into())?;
    let last = (first + count - 1) as u32;
    let vertex_range =
        VertexRange { first: last, last, instances: 1, base_instance: 0, scattered: None };
    let vertices = bindings(context, vertex_range)?;
    let checked = check_range(context, &vertices, first, count);
    context.recorder.bindings = vertices;
    checked
}

/// Draws, or adds the draw to the list that is compiled.
pub(super) fn draw_or_record(
    context: &mut Context,
    topology: Topology,
    vertices: Vec<VertexBinding>,
    (elements, base_instance): (Elements, u32),
) -> Result<()> {
    let (before, is_whole) = (context.recorder.draws, !needs_vertex_range(context));
    let (count, _) = elements.counts();
    if let Some((vertices, elements)) = context.record_arrays(topology, vertices, elements) {
        draw(context, topology, vertices, &elements)?;
        // Later draws that repeat its arrays begin with element 0.
        if is_whole && base_instance == 0 && context.recorder.draws > before {
            remember_last_draw(context, topology, count);
        }
    }
    Ok(())
}

pub(crate) fn draw_arrays(
    context: &mut Context,
    mode: GLenum,
    first: GLint,
    count: GLsizei,
) -> Result<()> {
    draw_range(context, mode, [first, count], Instances::ONE)
}

/// Refuses an instanced draw while a list is compiled (`ARB_draw_instanced`).
pub(crate) fn refuse_in_list(context: &Context) -> Result<()> {
    if context.compiling.is_some() {
        return invalid_operation(INSTANCED, "draws of instances are not compiled into lists");
    }
    Ok(())
}

pub(crate) fn draw_arrays_instanced(
    context: &mut Context,
    mode: GLenum,
    first: GLint,
    count: GLsizei,
    instances: GLsizei,
) -> Result<()> {
    refuse_in_list(context)?;
    draw_range(context, mode, [first, count], Instances::new(instances))
}

pub(crate) fn draw_arrays_instanced_base_instance(
    context: &mut Context,
    mode: GLenum,
    first: GLint,
    count: GLsizei,
    instances: GLsizei,
    base: GLuint,
) -> Result<()> {
    refuse_in_list(context)?;
    draw_range(context, mode, [first, count], Instances { count: instances, base })
}

/// Draws vertices in their order: the first, and how many.
pub(crate) fn draw_range(
    context: &mut Context,
    mode: GLenum,
    [first, count]: [GLint; 2],
    instances: Instances,
) -> Result<()> {
    let topology = topology(mode)?;
    require_vertex_array(context)?;
    let first = not_negative(SECTION, "first", first.into())?;
    let count = not_negative(SECTION, "count", count.into())?;
    let instances = instances.checked()?;
    let vertices = (count, u64::from(instances.count));
    es_capture::check_draw(context, topology, vertices)?;
    take_client_writes(context);
    if count > 0 && instances.count > 0 && has_positions(context, topology) {
        let last = (first + count - 1) as u32;
        let range = (first as u32, count as u32);
        let elements =
            Elements::Range { first: range.0, count: range.1, instances: 0..instances.count };
        if instances.base == 0 && try_append(context, topology, &elements) {
            return Ok(());
        }
        let vertex_range = VertexRange {
            first: range.0,
            last,
            instances: instances.count,
            base_instance: instances.base,
            scattered: None,
        };
        let vertices = bindings(context, vertex_range)?;
        check_range(context, &vertices, first, count)?;
        return draw_or_record(context, topology, vertices, (elements, instances.base));
    }
    warnings::picture::note_empty(context, "glDrawArrays", [count as u64, instances.count.into()]);
    context.empty_draw("glDrawArrays")
}

/// GL 2.1, section 2.8: an element of every array that is enabled, the position last.
pub(crate) fn array_element(context: &mut Context, index: GLint) -> Result<()> {
    let index = not_negative(SECTION, "i", index.into())? as u32;
    if crate::calls::vertex::restart::is_restart(context, index) {
        return crate::calls::vertex::restart::primitive_restart(context);
    }
    let arrays = &context.state.arrays.by_location;
    let enabled: Vec<usize> = (0..LOCATIONS).filter(|&at| arrays[at].enabled).collect();
    let position = usize::from(ATTRIB_VERTEX);
    let vertex_range =
        VertexRange { first: index, last: index, instances: 1, base_instance: 0, scattered: None };
    let of_position = |location: &usize| *location == 0 || *location == position;
    for &location in enabled.iter().filter(|location| !of_position(location)) {
        let value = vertex_source(context, location, vertex_range)?.read(index);
        attribute(context, Slot::Location(location as u8), value)?;
    }
    if let Some(&location) = enabled.iter().find(|location| of_position(location)) {
        let value = vertex_source(context, location, vertex_range)?.read(index);
        attribute(context, Slot::Vertex, value)?;
    }
    Ok(())
}
