//! Textures whose texels are the bytes of a buffer object: `glTexBuffer`, `glTexBufferRange`
//! (`ARB_texture_buffer_object`, `ARB_texture_buffer_object_rgb32`, `ARB_texture_buffer_range`; GL
//! 3.1, section 3.8.4).
//!
//! A draw makes a row of texels of the bytes that the buffer has then, and keeps it until somebody
//! asks to write to the buffer.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum, invalid_operation, invalid_value};
use crate::base::limits;
use crate::base::types::*;
use crate::calls::texture::bound::ChosenTexture;
use crate::context::Context;
use crate::objects::target::TextureTarget;
use crate::objects::texture_buffer::DataStore;
use crate::pixel::formats;
use std::ops::Range;

const SECTION: &str = "GL 3.1, section 3.8.4";
const RANGE: &str = "ARB_texture_buffer_range, section 3.8.4";

const TARGET: Table<()> = Table { section: SECTION, rows: &[(GL_TEXTURE_BUFFER, ())] };

/// The bound texture.
fn bound(context: &Context, target: GLenum) -> Result<ChosenTexture> {
    TARGET.decode("target", target)?;
    Ok(ChosenTexture::bound(context, TextureTarget::Buffer))
}

/// Gives a texture its texels, if the arguments are right.
fn attach(
    context: &mut Context,
    texture: &ChosenTexture,
    internal: GLenum,
    buffer: GLuint,
    range: impl FnOnce(usize) -> Result<Option<Range<usize>>>,
) -> Result<()> {
    let format = formats::find(internal).filter(|format| format.is_for_texel_buffers());
    let Some(format) = format.map(|format| format.stored) else {
        return invalid_enum(
            SECTION,
            format!(
                "internalformat = {} must be one of table 3.15, as GL_RGBA8 or GL_R32F",
                enum_name(internal)
            ),
        );
    };
    let range = match context.objects.shared.buffers.get(buffer) {
        _ if buffer == 0 => None,
        Some(object) => range(object.len())?,
        None => {
            let rule =
                format!("buffer = {buffer} is no buffer object: bind it once, to any target");
            return invalid_operation(SECTION, rule);
        }
    };
    let buffer = context.objects.shared.buffers.hold(buffer);
    texture.get_mut(context).store =
        DataStore { internal, format, buffer, range, ..DataStore::default() };
    Ok(())
}

pub(crate) fn tex_buffer(
    context: &mut Context,
    target: GLenum,
    internalformat: GLenum,
    buffer: GLuint,
) -> Result<()> {
    let texture = bound(context, target)?;
    attach_all(context, &texture, internalformat, buffer)
}

/// Gives a texture all bytes of a buffer.
pub(crate) fn attach_all(
    context: &mut Context,
    texture: &ChosenTexture,
    internal: GLenum,
    buffer: GLuint,
) -> Result<()> {
    attach(context, texture, internal, buffer, |_| Ok(None))
}

pub(crate) fn tex_buffer_range(
    context: &mut Context,
    target: GLenum,
    internalformat: GLenum,
    buffer: GLuint,
    offset: GLintptr,
    size: GLsizeiptr,
) -> Result<()> {
    let texture = bound(context, target)?;
    attach_range(context, &texture, internalformat, buffer, (offset, size))
}

/// Gives a texture some bytes of a buffer.
pub(crate) fn attach_range(
    context: &mut Context,
    texture: &ChosenTexture,
    internal: GLenum,
    buffer: GLuint,
    (offset, size): (GLintptr, GLsizeiptr),
) -> Result<()> {
    attach(context, texture, internal, buffer, |length| {
        let alignment = limits::TEXTURE_BUFFER_OFFSET_ALIGNMENT;
        let range = usize::try_from(offset).ok().zip(usize::try_from(size).ok());
        match range.and_then(|(offset, size)| Some(offset..offset.checked_add(size)?)) {
            Some(range) if !range.start.is_multiple_of(alignment) => invalid_value(
                RANGE,
                format!(
                    "offset = {offset} must be a multiple of {alignment}, \
                     GL_TEXTURE_BUFFER_OFFSET_ALIGNMENT"
                ),
            ),
            Some(range) if !range.is_empty() && range.end <= length => Ok(Some(range)),
            Some(_) | None => invalid_value(
                RANGE,
                format!(
                    "offset = {offset} and size = {size} must name bytes of the {length} that the \
                     buffer has, at least one"
                ),
            ),
        }
    })
}
