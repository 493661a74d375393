//! Calls that name their vertex array object: `ARB_direct_state_access`, section 10.3. Each gives the call of the same
//! subject an object that need not be bound.

use crate::base::error::{Result, invalid_operation, not_negative};
use crate::base::limits::MAX_VERTEX_ATTRIB_BINDINGS;
use crate::base::types::*;
use crate::calls::buffer::data::named as named_buffer;
use crate::calls::vertex::array_objects::ChosenArrays;
use crate::calls::vertex::arrays::{Enabled, enable_array};
use crate::calls::vertex::bindings::{
    set_binding, set_buffer, set_divisor, set_double_format, set_integer_format, set_plain_format,
};
use crate::context::Context;
use crate::objects::arrays::VertexArray;
use crate::objects::bound::Bound;

const SECTION: &str = "ARB_direct_state_access, section 10.3";
const SEVERAL: &str = "ARB_multi_bind, section 10.3.1";

pub(crate) fn create_vertex_arrays(
    context: &mut Context,
    n: GLsizei,
    arrays: &mut [GLuint],
) -> Result<()> {
    context.objects.vertex_arrays.add_each(SECTION, n, arrays, VertexArray::default)
}

pub(crate) fn enable_vertex_array_attrib(
    context: &mut Context,
    vaobj: GLuint,
    index: GLuint,
) -> Result<()> {
    let chosen = ChosenArrays::named(context, vaobj)?;
    enable_array(context, chosen, index, Enabled::Yes)
}

pub(crate) fn disable_vertex_array_attrib(
    context: &mut Context,
    vaobj: GLuint,
    index: GLuint,
) -> Result<()> {
    let chosen = ChosenArrays::named(context, vaobj)?;
    enable_array(context, chosen, index, Enabled::No)
}

pub(crate) fn vertex_array_element_buffer(
    context: &mut Context,
    vaobj: GLuint,
    buffer: GLuint,
) -> Result<()> {
    let chosen = ChosenArrays::named(context, vaobj)?;
    let buffer = match buffer {
        0 => Bound::default(),
        buffer => named_buffer(context, "buffer", buffer)?,
    };
    *chosen.element_array_buffer_mut(context) = buffer;
    Ok(())
}

pub(crate) fn vertex_array_vertex_buffer(
    context: &mut Context,
    vaobj: GLuint,
    bindingindex: GLuint,
    buffer: GLuint,
    offset: GLintptr,
    stride: GLsizei,
) -> Result<()> {
    let chosen = ChosenArrays::named(context, vaobj)?;
    set_buffer(context, (chosen, bindingindex), buffer, (offset, stride))
}

/// Attaches buffers to binding points one by one: what is wrong with one leaves the others (`ARB_multi_bind`, issue 8).
pub(crate) fn vertex_array_vertex_buffers(
    context: &mut Context,
    vaobj: GLuint,
    first: GLuint,
    count: GLsizei,
    buffers: &[GLuint],
    offsets: &[GLintptr],
    strides: &[GLsizei],
) -> Result<()> {
    let chosen = ChosenArrays::named(context, vaobj)?;
    let count = not_negative(SEVERAL, "count", count.into())?;
    if first as usize + count > MAX_VERTEX_ATTRIB_BINDINGS {
        return invalid_operation(
            SEVERAL,
            format!(
                "first = {first} and count = {count} reach past GL_MAX_VERTEX_ATTRIB_BINDINGS, \
                 {MAX_VERTEX_ATTRIB_BINDINGS}"
            ),
        );
    }
    // NULL detaches all, and gives the initial offsets and strides.
    let is_null = buffers.is_empty();
    if !is_null && [buffers.len(), offsets.len(), strides.len()].iter().any(|has| *has < count) {
        let (buffers, offsets, strides) = (buffers.len(), offsets.len(), strides.len());
        let rule = format!("count = {count}, but there are {buffers}, {offsets} and {strides}");
        return invalid_operation(SEVERAL, rule);
    }
    let mut problem = Ok(());
    for at in 0..count {
        let point = (chosen, first + at as GLuint);
        let done = match is_null {
            true => set_buffer(context, point, 0, (0, 16)),
            false if buffers[at] == 0 => set_buffer(context, point, 0, (offsets[at], strides[at])),
            false => named_buffer(context, "buffers", buffers[at])
                .and_then(|_| set_buffer(context, point, buffers[at], (offsets[at], strides[at]))),
        };
        problem = problem.and(done);
    }
    problem
}

pub(crate) fn vertex_array_attrib_format(
    context: &mut Context,
    vaobj: GLuint,
    attribindex: GLuint,
    size: GLint,
    ty: GLenum,
    normalized: bool,
    relativeoffset: GLuint,
) -> Result<()> {
    let attribute = (ChosenArrays::named(context, vaobj)?, attribindex);
    set_plain_format(context, attribute, (size, ty), normalized, relativeoffset)
}

pub(crate) fn vertex_array_attrib_i_format(
    context: &mut Context,
    vaobj: GLuint,
    attribindex: GLuint,
    size: GLint,
    ty: GLenum,
    relativeoffset: GLuint,
) -> Result<()> {
    let attribute = (ChosenArrays::named(context, vaobj)?, attribindex);
    set_integer_format(context, attribute, (size, ty), relativeoffset)
}

pub(crate) fn vertex_array_attrib_l_format(
    context: &mut Context,
    vaobj: GLuint,
    attribindex: GLuint,
    size: GLint,
    ty: GLenum,
    relativeoffset: GLuint,
) -> Result<()> {
    let attribute = (ChosenArrays::named(context, vaobj)?, attribindex);
    set_double_format(context, attribute, (size, ty), relativeoffset)
}

pub(crate) fn vertex_array_attrib_binding(
    context: &mut Context,
    vaobj: GLuint,
    attribindex: GLuint,
    bindingindex: GLuint,
) -> Result<()> {
    let attribute = (ChosenArrays::named(context, vaobj)?, attribindex);
    set_binding(context, attribute, bindingindex)
}

pub(crate) fn vertex_array_binding_divisor(
    context: &mut Context,
    vaobj: GLuint,
    bindingindex: GLuint,
    divisor: GLuint,
) -> Result<()> {
    let point = (ChosenArrays::named(context, vaobj)?, bindingindex);
    set_divisor(context, point, divisor)
}
