//! `glDrawArrays`, `glDrawElements` and `glArrayElement`: GL 2.1, section 2.8.

use crate::base::args::Data;
use crate::base::error::{Result, invalid_operation, invalid_value, not_negative};
use crate::base::limits::LOCATIONS;
use crate::base::topology::topology;
use crate::base::types::*;
use crate::calls::buffer::map::take_client_writes;
use crate::calls::vertex::array_objects::require_vertex_array;
use crate::calls::vertex::immediate::attribute;
use crate::calls::vertex::indices::{INDEX_TYPE, index_buffer};
use crate::context::Context;
use crate::context::immediate::Slot;
use crate::context::recorder::elements::Elements;
use crate::draw::array_names::{array_of, extent};
use crate::draw::assembly_words::has_vertex_program;
use crate::draw::batching::{remember_last_draw, try_append};
use crate::draw::es_capture;
use crate::draw::record::{constants_needed, draw};
use crate::draw::vertex_range::{
    VertexRange, needs_vertex_range, scattered_vertices, vertex_source,
};
use crate::draw::warnings;
use crate::interface::ATTRIB_VERTEX;
use rasterizer::driver::{
    Buffer, IndexType, Indices, Topology, VertexBinding, VertexSource, primitives,
};
use std::ops::Range;

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

    fn checked(self) -> Result<CheckedInstances> {
        let count = not_negative(INSTANCED, "primcount", self.count.into())? as u32;
        Ok(CheckedInstances { count, base: self.base })
    }
}

/// The instances of a draw, no negative number of them.
#[derive(Clone, Copy)]
struct CheckedInstances {
    count: u32,
    base: u32,
}

/// The range of vertices that an indexed draw reads; computed only if the vertex source needs it.
fn indexed_vertex_range(
    context: &Context,
    bytes: &[u8],
    (ty, base_vertex): (IndexType, GLint),
    instances: CheckedInstances,
) -> VertexRange<'static> {
    let mut vertex_range = VertexRange {
        first: 0,
        last: 0,
        instances: instances.count,
        base_instance: instances.base,
        scattered: None,
    };
    if needs_vertex_range(context) {
        let indices = bytes.chunks_exact(ty.size()).map(IndexType::index);
        // Sums wrap (ARB_draw_elements_base_vertex, section 2.8).
        let vertices = indices.map(|index| index.wrapping_add_signed(base_vertex));
        let (low, high) =
            vertices.fold((u32::MAX, 0), |(low, high), at| (low.min(at), high.max(at)));
        vertex_range.last = high;
        vertex_range.first = low.min(high);
    }
    vertex_range
}

/// Where every attribute of an array draw comes from, of those that matter.
fn bindings(context: &mut Context, vertex_range: VertexRange<'_>) -> Result<Vec<VertexBinding>> {
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
fn draw_or_record(
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
    context.empty_draw("glDrawArrays")
}

/// The indices of a draw: where they are, and how many of them there must be.
pub(crate) struct IndexRequest<'a> {
    pub count: GLsizei,
    pub ty: GLenum,
    pub indices: Data<'a>,
    pub base_vertex: GLint,
}

/// Draws by index.
pub(crate) fn draw_indexed(
    context: &mut Context,
    mode: GLenum,
    request: IndexRequest<'_>,
    instances: Instances,
) -> Result<()> {
    let topology = topology(mode)?;
    require_vertex_array(context)?;
    let count = not_negative(SECTION, "count", request.count.into())?;
    let instances = instances.checked()?;
    let ty = INDEX_TYPE.decode("type", request.ty)?;
    es_capture::check_indices(context)?;
    take_client_writes(context);
    let needed = if instances.count == 0 { 0 } else { count.saturating_mul(ty.size()) };
    let (buffer, offset) = index_buffer(context, request.indices, count, needed)?;
    if count == 0 || instances.count == 0 || !has_positions(context, topology) {
        return context.empty_draw("glDrawElements");
    }
    let request =
        RunsRequest { topology, buffer, offset, ty, count, base_vertex: request.base_vertex };
    let drawn = draw_runs(context, &request, instances);
    context.recorder.first_primitive = 0;
    drawn
}

/// Checked indices of a draw.
struct RunsRequest {
    topology: Topology,
    buffer: Buffer,
    /// Where in the buffer they begin.
    offset: usize,
    ty: IndexType,
    count: usize,
    base_vertex: GLint,
}

/// Draws each run of indices between restart indices. `gl_PrimitiveID` counts on from run to run.
fn draw_runs(
    context: &mut Context,
    request: &RunsRequest,
    instances: CheckedInstances,
) -> Result<()> {
    let &RunsRequest { topology, ref buffer, offset, ty, count, base_vertex } = request;
    let runs = crate::calls::vertex::restart::runs(context, buffer, offset, ty, count);
    let indexed =
        |run: &Range<usize>| &buffer.bytes()[offset..][run.start * ty.size()..run.end * ty.size()];
    let vertex_range = |context: &Context, run| {
        indexed_vertex_range(context, indexed(run), (ty, base_vertex), instances)
    };
    // What several runs read is taken once.
    let all = runs.iter().map(|run| vertex_range(context, run)).reduce(VertexRange::union);
    let all = all.filter(|all| runs.len() > 1 && all.is_dense(count));
    let shared = all.map(|all| bindings(context, all)).transpose()?;
    // ARB_draw_instanced: each instance is drawn whole, all its runs, before the next one.
    let step = if runs.len() > 1 { 1 } else { instances.count };
    let drawn = crate::calls::vertex::restart::instances_drawn(instances.count, runs.len());
    for first in (0..drawn).step_by(step as usize) {
        context.recorder.first_primitive = 0;
        for run in &runs {
            let offset = offset + run.start * ty.size();
            let indices = Indices { buffer: buffer.clone(), offset, ty, base_vertex };
            let (count, last) = (run.len() as u32, first + step);
            let mut elements = Elements::Indexed { indices, count, instances: first..last };
            if instances.base == 0 && try_append(context, topology, &elements) {
                // Nothing reads the number of a primitive.
            } else if let Some(vertices) = &shared {
                draw_or_record(context, topology, vertices.clone(), (elements, instances.base))?;
            } else {
                let mut vertex_range = vertex_range(context, run);
                let scattered =
                    scattered_vertices(context, indexed(run), (ty, base_vertex), vertex_range);
                if scattered.is_some() {
                    elements = Elements::Range { first: 0, count, instances: first..last };
                }
                vertex_range.scattered = scattered.as_deref();
                let vertices = bindings(context, vertex_range)?;
                draw_or_record(context, topology, vertices, (elements, instances.base))?;
            }
            let made = primitives(topology, context.state.raster.provoking, count);
            let numbered = made.numbered_from(context.recorder.first_primitive);
            context.recorder.first_primitive = numbered.next_number();
        }
    }
    if drawn < instances.count {
        crate::draw::pass::stopped(context);
    }
    Ok(())
}

pub(crate) fn draw_elements(
    context: &mut Context,
    mode: GLenum,
    count: GLsizei,
    ty: GLenum,
    indices: Data<'_>,
) -> Result<()> {
    draw_indexed(context, mode, IndexRequest { count, ty, indices, base_vertex: 0 }, Instances::ONE)
}

pub(crate) fn draw_elements_instanced(
    context: &mut Context,
    mode: GLenum,
    count: GLsizei,
    ty: GLenum,
    indices: Data<'_>,
    instances: GLsizei,
) -> Result<()> {
    refuse_in_list(context)?;
    draw_indexed(
        context,
        mode,
        IndexRequest { count, ty, indices, base_vertex: 0 },
        Instances::new(instances),
    )
}

pub(crate) fn draw_elements_base_vertex(
    context: &mut Context,
    mode: GLenum,
    count: GLsizei,
    ty: GLenum,
    indices: Data<'_>,
    base_vertex: GLint,
) -> Result<()> {
    draw_indexed(context, mode, IndexRequest { count, ty, indices, base_vertex }, Instances::ONE)
}

/// Checks the range that indices are promised to be in.
fn checked_range(start: GLuint, end: GLuint) -> Result<()> {
    if end < start {
        return invalid_value(SECTION, format!("end = {end} must not be below start = {start}"));
    }
    Ok(())
}

pub(crate) fn draw_range_elements(
    context: &mut Context,
    mode: GLenum,
    start: GLuint,
    end: GLuint,
    count: GLsizei,
    ty: GLenum,
    indices: Data<'_>,
) -> Result<()> {
    checked_range(start, end)?;
    draw_elements(context, mode, count, ty, indices)
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

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn draw_range_elements_base_vertex(
    context: &mut Context,
    mode: GLenum,
    start: GLuint,
    end: GLuint,
    count: GLsizei,
    ty: GLenum,
    indices: Data<'_>,
    base_vertex: GLint,
) -> Result<()> {
    checked_range(start, end)?;
    draw_elements_base_vertex(context, mode, count, ty, indices, base_vertex)
}

pub(crate) fn draw_elements_instanced_base_vertex(
    context: &mut Context,
    mode: GLenum,
    count: GLsizei,
    ty: GLenum,
    indices: Data<'_>,
    instances: GLsizei,
    base_vertex: GLint,
) -> Result<()> {
    refuse_in_list(context)?;
    draw_indexed(
        context,
        mode,
        IndexRequest { count, ty, indices, base_vertex },
        Instances::new(instances),
    )
}
