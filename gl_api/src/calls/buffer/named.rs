//! Calls that name their buffer: `ARB_direct_state_access`, chapter 6. Each gives the call of the same subject a buffer
//! that need not be bound.

use crate::base::args::{Data, DataOut};
use crate::base::error::Result;
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::buffer::clear::clear;
use crate::calls::buffer::data::{named, read_data, replace_data, set_data, set_storage};
use crate::calls::buffer::map::{
    check_pointer, copy, flush_range, map_all, map_range, parameter, pointer, unmap,
};
use crate::context::Context;
use crate::objects::buffers::BufferObject;

const SECTION: &str = "ARB_direct_state_access, section 6.1";

pub(crate) fn create_buffers(
    context: &mut Context,
    n: GLsizei,
    buffers: &mut [GLuint],
) -> Result<()> {
    context.objects.shared.buffers.add_each(SECTION, n, buffers, BufferObject::new)
}

pub(crate) fn named_buffer_storage(
    context: &mut Context,
    buffer: GLuint,
    size: GLsizeiptr,
    data: Data<'_>,
    flags: GLbitfield,
) -> Result<()> {
    let buffer = named(context, "buffer", buffer)?;
    set_storage(context, &buffer, size, data, flags)
}

pub(crate) fn named_buffer_data(
    context: &mut Context,
    buffer: GLuint,
    size: GLsizeiptr,
    data: Data<'_>,
    usage: GLenum,
) -> Result<()> {
    let buffer = named(context, "buffer", buffer)?;
    set_data(context, &buffer, size, data, usage)
}

pub(crate) fn named_buffer_sub_data(
    context: &mut Context,
    buffer: GLuint,
    offset: GLintptr,
    size: GLsizeiptr,
    data: Data<'_>,
) -> Result<()> {
    let buffer = named(context, "buffer", buffer)?;
    replace_data(context, &buffer, (offset, size), data)
}

pub(crate) fn copy_named_buffer_sub_data(
    context: &mut Context,
    read_buffer: GLuint,
    write_buffer: GLuint,
    read_offset: GLintptr,
    write_offset: GLintptr,
    size: GLsizeiptr,
) -> Result<()> {
    let from = named(context, "readBuffer", read_buffer)?;
    let to = named(context, "writeBuffer", write_buffer)?;
    copy(context, (&from, &to), (read_offset, write_offset), size)
}

pub(crate) fn clear_named_buffer_data(
    context: &mut Context,
    buffer: GLuint,
    internalformat: GLenum,
    format: GLenum,
    ty: GLenum,
    data: Data<'_>,
) -> Result<()> {
    let buffer = named(context, "buffer", buffer)?;
    clear(context, (&buffer, internalformat), None, (format, ty), data)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn clear_named_buffer_sub_data(
    context: &mut Context,
    buffer: GLuint,
    internalformat: GLenum,
    offset: GLintptr,
    size: GLsizeiptr,
    format: GLenum,
    ty: GLenum,
    data: Data<'_>,
) -> Result<()> {
    let buffer = named(context, "buffer", buffer)?;
    clear(context, (&buffer, internalformat), Some((offset, size)), (format, ty), data)
}

pub(crate) fn map_named_buffer(
    context: &mut Context,
    buffer: GLuint,
    access: GLenum,
) -> Result<*mut GLvoid> {
    let buffer = named(context, "buffer", buffer)?;
    map_all(context, &buffer, access)
}

pub(crate) fn map_named_buffer_range(
    context: &mut Context,
    buffer: GLuint,
    offset: GLintptr,
    length: GLsizeiptr,
    access: GLbitfield,
) -> Result<*mut GLvoid> {
    let buffer = named(context, "buffer", buffer)?;
    map_range(context, &buffer, (offset, length), access)
}

pub(crate) fn unmap_named_buffer(context: &mut Context, buffer: GLuint) -> Result<bool> {
    let buffer = named(context, "buffer", buffer)?;
    unmap(context, &buffer)
}

pub(crate) fn flush_mapped_named_buffer_range(
    context: &mut Context,
    buffer: GLuint,
    offset: GLintptr,
    length: GLsizeiptr,
) -> Result<()> {
    let buffer = named(context, "buffer", buffer)?;
    flush_range(context, &buffer, (offset, length))
}

/// Of sizes that an integer cannot hold, the largest one.
pub(crate) fn get_named_buffer_parameteriv(
    context: &mut Context,
    buffer: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let buffer = named(context, "buffer", buffer)?;
    let value = parameter(context, &buffer, pname)?;
    put(params, &[value.min(GLint::MAX.into()) as GLint])
}

pub(crate) fn get_named_buffer_parameteri64v(
    context: &mut Context,
    buffer: GLuint,
    pname: GLenum,
    params: &mut [GLint64],
) -> Result<()> {
    let buffer = named(context, "buffer", buffer)?;
    let value = parameter(context, &buffer, pname)?;
    put(params, &[value])
}

pub(crate) fn get_named_buffer_pointerv(
    context: &mut Context,
    buffer: GLuint,
    pname: GLenum,
    params: &mut [*mut GLvoid],
) -> Result<()> {
    let buffer = named(context, "buffer", buffer)?;
    check_pointer(pname)?;
    pointer(context, &buffer, params)
}

pub(crate) fn get_named_buffer_sub_data(
    context: &mut Context,
    buffer: GLuint,
    offset: GLintptr,
    size: GLsizeiptr,
    data: DataOut<'_>,
) -> Result<()> {
    let buffer = named(context, "buffer", buffer)?;
    read_data(context, &buffer, (offset, size), data)
}
