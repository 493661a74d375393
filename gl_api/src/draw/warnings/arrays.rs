//! Warnings of vertex arrays that are missing or too short.

use crate::base::constants::*;
use crate::context::Context;
use crate::context::recorder::elements::Elements;
use crate::context::warnings::DrawWarning;
use crate::draw::array_names::extent;
use crate::state::enable::CLIENT_ARRAY;
use rasterizer::driver::{IndexType, Topology, VertexBinding, VertexSource};
use rasterizer::ir::{Expr, Input, Stage};

/// Warns of arrays that a draw reads past their end. `glDrawArrays` refuses a draw where array 0 is too short; others,
/// and all that indices reach, read as zeros. Indices are searched only while messages are wanted.
pub(crate) fn short(context: &mut Context, vertices: &[VertexBinding], elements: &Elements) {
    let mut last = None;
    let (_, instances) = elements.counts();
    for binding in vertices {
        let VertexSource::Array { offset, stride, ty, components, divisor, .. } = &binding.source
        else {
            continue;
        };
        let last = match instances.end.saturating_sub(1).checked_div(*divisor) {
            Some(last) => Some(last),
            None => *last.get_or_insert_with(|| last_vertex(context, elements)),
        };
        let Some(last) = last else { continue };
        let (begin, size) = (*offset as u64, ty.bytes(*components) as u64);
        let needed = begin.saturating_add(u64::from(last) * *stride as u64).saturating_add(size);
        let bytes = binding.source.end();
        if needed > bytes as u64
            && context.is_first_warning(DrawWarning::ShortArray, binding.location.into())
        {
            let extent = extent(context, binding.location, bytes);
            context.debug.warn(format!(
                "draw: element {last} ends at byte {needed}, but {extent}; what lies beyond reads \
                 as 0 (GL 3.1, section 2.9.4)"
            ));
        }
    }
}

/// The last vertex of a draw; of a draw by index only while messages are wanted.
fn last_vertex(context: &Context, elements: &Elements) -> Option<u32> {
    match elements {
        Elements::Range { first, count, .. } => Some(first.saturating_add(count.checked_sub(1)?)),
        Elements::Indexed { indices, count, .. } => {
            let size = indices.ty.size();
            let bytes = indices.buffer.bytes().get(indices.offset..)?;
            let bytes = bytes.get(..*count as usize * size).filter(|_| context.debug.listens())?;
            let vertices = bytes.chunks_exact(size).map(IndexType::index);
            vertices.map(|index| index.wrapping_add_signed(indices.base_vertex)).max()
        }
    }
}

/// Warns of a draw whose vertices are all alike: the program has attributes, and no array is enabled.
pub(crate) fn none(context: &mut Context, topology: Topology) {
    let name = context.program_of(Stage::Vertex);
    let linked = context.executable();
    // A point may be drawn with constants.
    if topology != Topology::Points
        && linked.is_some_and(|linked| !linked.program.attributes.is_empty())
        && context.is_first_warning(DrawWarning::NoArray, name)
    {
        all_alike(context);
    }
}

#[cold]
#[inline(never)]
fn all_alike(context: &mut Context) {
    let Some(linked) = context.executable() else { return };
    let (Some(vertex), Some(attribute)) = (&linked.vertex, linked.program.attributes.first())
    else {
        return;
    };
    // The vertices may differ by their numbers.
    let mut values = vertex.module().values.iter();
    if values.any(|value| matches!(value, Expr::Input(Input::VertexId))) {
        return;
    }
    let location = attribute.location;
    let call = match CLIENT_ARRAY.rows.iter().find(|row| row.1 == location) {
        Some((array, _)) => format!("glEnableClientState({})", enum_name(*array)),
        None => format!("glEnableVertexAttribArray({location})"),
    };
    context.debug.warn(format!(
        "draw: no vertex array is enabled, so \"{}\" is the same at all vertices and nothing is \
         seen: call {call}",
        attribute.name
    ));
}
