//! `glDrawElements` and the other draws by index: GL 2.1, section 2.8.

use crate::base::args::Data;
use crate::base::error::{Result, invalid_value, not_negative};
use crate::base::topology::topology;
use crate::base::types::*;
use crate::calls::buffer::map::take_client_writes;
use crate::calls::vertex::array_objects::require_vertex_array;
use crate::calls::vertex::draws::{
    CheckedInstances, Instances, SECTION, bindings, draw_or_record, has_positions, refuse_in_list,
};
use crate::calls::vertex::indices::{INDEX_TYPE, index_buffer};
use crate::calls::vertex::restart;
use crate::context::Context;
use crate::context::recorder::elements::Elements;
use crate::draw::batching::try_append;
use crate::draw::es_capture;
use crate::draw::vertex_range::{VertexRange, needs_vertex_range, scattered_vertices};
use rasterizer::driver::{Buffer, IndexType, Indices, Topology, primitives};
use std::ops::Range;

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
        let counts = [count as u64, instances.count.into()];
        crate::draw::warnings::picture::note_empty(context, "glDrawElements", counts);
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
    let runs = restart::runs(context, buffer, offset, ty, count);
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
    let drawn = restart::instances_drawn(instances.count, runs.len());
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
    draw_elements_base_vertex(context, mode, count, ty, indices, 0)
}

pub(crate) fn draw_elements_instanced(
    context: &mut Context,
    mode: GLenum,
    count: GLsizei,
    ty: GLenum,
    indices: Data<'_>,
    instances: GLsizei,
) -> Result<()> {
    draw_elements_instanced_base_vertex(context, mode, count, ty, indices, instances, 0)
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
