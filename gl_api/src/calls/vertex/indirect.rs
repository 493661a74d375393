//! Draws whose arguments lie in a buffer (`ARB_draw_indirect`, `ARB_multi_draw_indirect`), and by index with a first
//! instance (`ARB_base_instance`).

use crate::base::args::{Data, Located};
use crate::base::error::{Result, invalid_operation, invalid_value, not_negative};
use crate::base::topology::topology;
use crate::base::types::*;
use crate::calls::buffer::map::take_client_writes;
use crate::calls::vertex::array_objects::require_vertex_array;
use crate::calls::vertex::draws::{Instances, draw_range, refuse_in_list};
use crate::calls::vertex::elements::{IndexRequest, draw_indexed};
use crate::calls::vertex::indices::INDEX_TYPE;
use crate::context::Context;

const SECTION: &str = "ARB_draw_indirect, section 2.8.3";

/// Words of the arguments of `glDrawArraysIndirect`: count, instances, first vertex, base instance.
const ARRAYS: usize = 4;
/// Words of the arguments of `glDrawElementsIndirect`: count, instances, first index, base vertex, base instance.
const ELEMENTS: usize = 5;

/// The arguments of `count` draws of `N` words, `stride` bytes apart (0: without gaps).
fn arguments<const N: usize>(
    context: &Context,
    indirect: Data<'_>,
    count: GLsizei,
    stride: GLsizei,
) -> Result<Vec<[u32; N]>> {
    let count = not_negative(SECTION, "drawcount", count.into())?;
    let stride = not_negative(SECTION, "stride", stride.into())?;
    if !stride.is_multiple_of(4) {
        return invalid_value(SECTION, format!("stride = {stride} must be a multiple of 4"));
    }
    let stride = if stride == 0 { 4 * N } else { stride };
    let needed = if count == 0 { 0 } else { (count - 1).saturating_mul(stride) + 4 * N };
    let bound = &context.state.bindings.draw_indirect_buffer;
    let object = context.objects.shared.buffers.bound(bound);
    let bytes = match (indirect.locate(bound.name(), needed), object) {
        (Located::Bytes(bytes), None) if !context.profile.is_core() => bytes.get(..needed),
        (_, None) => {
            return invalid_operation(
                SECTION,
                "no buffer is bound to GL_DRAW_INDIRECT_BUFFER: call glBindBuffer",
            );
        }
        (_, Some(object)) if object.is_mapped_alone() => {
            return invalid_operation(
                SECTION,
                "the buffer of GL_DRAW_INDIRECT_BUFFER is mapped: call glUnmapBuffer",
            );
        }
        (Located::Bytes(_), Some(_)) => {
            return invalid_operation(
                SECTION,
                "indirect is memory, but a buffer is bound to GL_DRAW_INDIRECT_BUFFER",
            );
        }
        (Located::Null, Some(object)) => object.buffer().bytes().get(..needed),
        (Located::Offset(offset), Some(object)) => {
            if !offset.is_multiple_of(4) {
                return invalid_value(
                    SECTION,
                    format!("indirect = {offset} must be a multiple of 4"),
                );
            }
            offset.checked_add(needed).and_then(|end| object.buffer().bytes().get(offset..end))
        }
    };
    let Some(bytes) = bytes else {
        return invalid_operation(
            SECTION,
            format!("the arguments of {count} draws take {needed} bytes, which are not there"),
        );
    };
    let word = |at: usize| bytes[at..at + 4].try_into().map_or(0, u32::from_ne_bytes);
    let of = |draw: usize| std::array::from_fn(|at| word(draw * stride + 4 * at));
    Ok((0..count).map(of).collect())
}

/// A number of vertices, indices or instances; what is too large for one is larger than any buffer.
fn number(word: u32) -> GLsizei {
    GLsizei::try_from(word).unwrap_or(GLsizei::MAX)
}

pub(crate) fn draw_arrays_indirect(
    context: &mut Context,
    mode: GLenum,
    indirect: Data<'_>,
) -> Result<()> {
    multi_draw_arrays_indirect(context, mode, indirect, 1, 0)
}

pub(crate) fn multi_draw_arrays_indirect(
    context: &mut Context,
    mode: GLenum,
    indirect: Data<'_>,
    draw_count: GLsizei,
    stride: GLsizei,
) -> Result<()> {
    refuse_in_list(context)?;
    topology(mode)?;
    require_vertex_array(context)?;
    take_client_writes(context);
    let draws = arguments::<ARRAYS>(context, indirect, draw_count, stride)?;
    draws.into_iter().try_for_each(|[count, instances, first, base]| {
        let instances = Instances { count: number(instances), base };
        draw_range(context, mode, [number(first), number(count)], instances)
    })
}

pub(crate) fn draw_elements_indirect(
    context: &mut Context,
    mode: GLenum,
    ty: GLenum,
    indirect: Data<'_>,
) -> Result<()> {
    multi_draw_elements_indirect(context, mode, ty, indirect, 1, 0)
}

pub(crate) fn multi_draw_elements_indirect(
    context: &mut Context,
    mode: GLenum,
    ty: GLenum,
    indirect: Data<'_>,
    draw_count: GLsizei,
    stride: GLsizei,
) -> Result<()> {
    refuse_in_list(context)?;
    topology(mode)?;
    let size = INDEX_TYPE.decode("type", ty)?.size();
    require_vertex_array(context)?;
    let name = context.state.bindings.element_array_buffer.name();
    if name == 0 {
        return invalid_operation(
            SECTION,
            "no buffer is bound to GL_ELEMENT_ARRAY_BUFFER: call glBindBuffer",
        );
    }
    take_client_writes(context);
    let draws = arguments::<ELEMENTS>(context, indirect, draw_count, stride)?;
    draws.into_iter().try_for_each(|[count, instances, first, base_vertex, base]| {
        let instances = Instances { count: number(instances), base };
        let indices = Data::Offset(first as usize * size);
        let (count, base_vertex) = (number(count), base_vertex.cast_signed());
        draw_indexed(context, mode, IndexRequest { count, ty, indices, base_vertex }, instances)
    })
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn draw_elements_instanced_base_vertex_base_instance(
    context: &mut Context,
    mode: GLenum,
    count: GLsizei,
    ty: GLenum,
    indices: Data<'_>,
    instances: GLsizei,
    base_vertex: GLint,
    base: GLuint,
) -> Result<()> {
    refuse_in_list(context)?;
    let instances = Instances { count: instances, base };
    draw_indexed(context, mode, IndexRequest { count, ty, indices, base_vertex }, instances)
}

pub(crate) fn draw_elements_instanced_base_instance(
    context: &mut Context,
    mode: GLenum,
    count: GLsizei,
    ty: GLenum,
    indices: Data<'_>,
    instances: GLsizei,
    base: GLuint,
) -> Result<()> {
    draw_elements_instanced_base_vertex_base_instance(
        context, mode, count, ty, indices, instances, 0, base,
    )
}
