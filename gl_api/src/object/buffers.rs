//! Buffer objects: GL 2.1, section 2.9.

use super::doomed;
use crate::constants::*;
use crate::context::{Context, limits};
use crate::entry::{Data, DataOut, Located, LocatedOut};
use crate::error::{
    ErrorCode, GlError, Result, Table, invalid_operation, invalid_value, not_negative,
};
use crate::query::put;
use crate::types::*;
use rasterizer::driver::Buffer;

const SECTION: &str = "GL 2.1, section 2.9";

/// A buffer object.
#[derive(Clone, Debug)]
pub(crate) struct BufferObject {
    pub buffer: Buffer,
    pub usage: GLenum,
}

/// What a buffer can be bound to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BufferTarget {
    Array,
    ElementArray,
    PixelPack,
    PixelUnpack,
}

impl BufferTarget {
    const ALL: [Self; 4] = [Self::Array, Self::ElementArray, Self::PixelPack, Self::PixelUnpack];
}

pub(crate) const BUFFER_TARGET: Table<BufferTarget> = Table {
    section: SECTION,
    rows: &[
        (GL_ARRAY_BUFFER, BufferTarget::Array),
        (GL_ELEMENT_ARRAY_BUFFER, BufferTarget::ElementArray),
        (GL_PIXEL_PACK_BUFFER, BufferTarget::PixelPack),
        (GL_PIXEL_UNPACK_BUFFER, BufferTarget::PixelUnpack),
    ],
};

/// Kept for queries; it changes nothing.
const USAGE: Table<GLenum> = Table {
    section: "GL 2.1, table 2.6",
    rows: &[
        (GL_STREAM_DRAW, GL_STREAM_DRAW),
        (GL_STREAM_READ, GL_STREAM_READ),
        (GL_STREAM_COPY, GL_STREAM_COPY),
        (GL_STATIC_DRAW, GL_STATIC_DRAW),
        (GL_STATIC_READ, GL_STATIC_READ),
        (GL_STATIC_COPY, GL_STATIC_COPY),
        (GL_DYNAMIC_DRAW, GL_DYNAMIC_DRAW),
        (GL_DYNAMIC_READ, GL_DYNAMIC_READ),
        (GL_DYNAMIC_COPY, GL_DYNAMIC_COPY),
    ],
};

fn binding(context: &mut Context, target: BufferTarget) -> &mut GLuint {
    match target {
        BufferTarget::Array => &mut context.state.bindings.array_buffer,
        BufferTarget::ElementArray => &mut context.state.bindings.element_array_buffer,
        BufferTarget::PixelPack => &mut context.state.bindings.pixel_pack_buffer,
        BufferTarget::PixelUnpack => &mut context.state.bindings.pixel_unpack_buffer,
    }
}

/// The buffer that is bound to a target.
fn bound(context: &mut Context, target: GLenum) -> Result<&mut BufferObject> {
    let name = *binding(context, BUFFER_TARGET.decode("target", target)?);
    match context.objects.buffers.get_mut(name) {
        Some(object) => Ok(object),
        None => invalid_operation(
            SECTION,
            format!("no buffer is bound to {}: call glBindBuffer", enum_name(target)),
        ),
    }
}

pub(crate) fn gen_buffers(context: &mut Context, n: GLsizei, buffers: &mut [GLuint]) -> Result<()> {
    context.objects.buffers.reserve(SECTION, n, buffers)
}

pub(crate) fn delete_buffers(context: &mut Context, n: GLsizei, buffers: &[GLuint]) -> Result<()> {
    for &name in doomed(SECTION, n, buffers)?.iter().filter(|&&name| name != 0) {
        for target in BufferTarget::ALL {
            let bound = binding(context, target);
            if *bound == name {
                *bound = 0;
            }
        }
        context.state.arrays.forget_buffer(name);
        context.objects.buffers.remove(name);
    }
    Ok(())
}

pub(crate) fn bind_buffer(context: &mut Context, target: GLenum, buffer: GLuint) -> Result<()> {
    let target = BUFFER_TARGET.decode("target", target)?;
    context
        .objects
        .buffers
        .create(buffer, || BufferObject { buffer: Buffer::default(), usage: GL_STATIC_DRAW });
    *binding(context, target) = buffer;
    Ok(())
}

pub(crate) fn is_buffer(context: &mut Context, buffer: GLuint) -> Result<bool> {
    Ok(context.objects.buffers.get(buffer).is_some())
}

pub(crate) fn buffer_data(
    context: &mut Context,
    target: GLenum,
    size: GLsizeiptr,
    data: Data<'_>,
    usage: GLenum,
) -> Result<()> {
    let object = bound(context, target)?;
    let size = not_negative(SECTION, "size", size as i64)?;
    let usage = USAGE.decode("usage", usage)?;
    let no_memory = || GlError {
        code: ErrorCode::OutOfMemory,
        rule: format!("size = {size}: there is no memory for so many bytes"),
        section: SECTION,
    };
    if size > limits::MAX_BUFFER_SIZE {
        return Err(no_memory());
    }
    let mut bytes = Vec::new();
    match data.locate(0, size) {
        Located::Bytes(source) => match source.get(..size) {
            Some(source) => {
                bytes.try_reserve_exact(size).map_err(|_| no_memory())?;
                bytes.extend_from_slice(source);
            }
            None => {
                return invalid_operation(
                    SECTION,
                    format!("size = {size}, but the slice has {} bytes", source.len()),
                );
            }
        },
        Located::Null | Located::Offset(0) => {
            bytes.try_reserve_exact(size).map_err(|_| no_memory())?;
            bytes.resize(size, 0);
        }
        Located::Offset(_) => return invalid_operation(SECTION, "data must be a slice or NULL"),
    }
    object.buffer = Buffer::new(bytes);
    object.usage = usage;
    Ok(())
}

/// The byte range of a call on a part of a buffer.
fn range(
    object: &BufferObject,
    offset: GLintptr,
    size: GLsizeiptr,
) -> Result<std::ops::Range<usize>> {
    let length = object.buffer.bytes().len();
    let offset = not_negative(SECTION, "offset", offset as i64)?;
    let size = not_negative(SECTION, "size", size as i64)?;
    match offset.checked_add(size) {
        Some(end) if end <= length => Ok(offset..end),
        _ => invalid_value(
            SECTION,
            format!("offset = {offset} and size = {size} reach past the buffer's {length} bytes"),
        ),
    }
}

pub(crate) fn buffer_sub_data(
    context: &mut Context,
    target: GLenum,
    offset: GLintptr,
    size: GLsizeiptr,
    data: Data<'_>,
) -> Result<()> {
    let object = bound(context, target)?;
    let range = range(object, offset, size)?;
    match data.locate(0, range.len()) {
        Located::Bytes(source) if source.len() >= range.len() => {
            let source = &source[..range.len()];
            object.buffer.bytes_mut()[range].copy_from_slice(source);
            Ok(())
        }
        Located::Bytes(source) => invalid_operation(
            SECTION,
            format!("size = {size}, but the slice has {} bytes", source.len()),
        ),
        Located::Null | Located::Offset(_) => invalid_operation(SECTION, "data must be a slice"),
    }
}

pub(crate) fn get_buffer_sub_data(
    context: &mut Context,
    target: GLenum,
    offset: GLintptr,
    size: GLsizeiptr,
    data: DataOut<'_>,
) -> Result<()> {
    let object = bound(context, target)?;
    let range = range(object, offset, size)?;
    match data.locate(0, range.len()) {
        LocatedOut::Bytes(out) if out.len() >= range.len() => {
            out[..range.len()].copy_from_slice(&object.buffer.bytes()[range]);
            Ok(())
        }
        LocatedOut::Bytes(out) => invalid_operation(
            SECTION,
            format!("size = {size}, but the slice has {} bytes", out.len()),
        ),
        LocatedOut::Null | LocatedOut::Offset(_) => invalid_operation(SECTION, "data must be a slice"),
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Size,
    Usage,
    Access,
    Mapped,
}

pub(crate) fn get_buffer_parameteriv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    const PROPERTY: Table<Property> = Table {
        section: "GL 2.1, section 6.1.13",
        rows: &[
            (GL_BUFFER_SIZE, Property::Size),
            (GL_BUFFER_USAGE, Property::Usage),
            (GL_BUFFER_ACCESS, Property::Access),
            (GL_BUFFER_MAPPED, Property::Mapped),
        ],
    };
    let object = bound(context, target)?;
    let value = match PROPERTY.decode("pname", pname)? {
        Property::Size => object.buffer.bytes().len() as GLint,
        Property::Usage => object.usage as GLint,
        Property::Access => GL_READ_WRITE as GLint,
        Property::Mapped => 0,
    };
    put(params, &[value])
}
