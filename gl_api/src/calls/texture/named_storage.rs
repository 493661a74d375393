//! Storage of textures that calls name: `ARB_direct_state_access`, sections 8.9 and 8.19.

use crate::base::error::{Result, Table};
use crate::base::types::*;
use crate::calls::texture::bound::ChosenTexture;
use crate::calls::texture::buffer::{attach_all, attach_range};
use crate::calls::texture::level_request::Destination;
use crate::calls::texture::multisample::{Arguments, Lifetime, specify_of};
use crate::calls::texture::named::of_table;
use crate::calls::texture::storage::{STORAGE_1D, STORAGE_2D, STORAGE_3D, StorageRequest};
use crate::context::Context;
use crate::objects::target::{
    IMAGE_2D_MULTISAMPLE, IMAGE_3D_MULTISAMPLE, ImageTarget, TextureTarget,
};

const BUFFERS: &str = "ARB_direct_state_access, section 8.9";
const STORAGE: &str = "ARB_direct_state_access, section 8.19";

fn storage(
    context: &mut Context,
    (table, name): (&Table<ImageTarget>, GLuint),
    levels: GLsizei,
    internal: GLenum,
    size: [GLsizei; 3],
) -> Result<()> {
    let texture = ChosenTexture::named(context, name)?;
    let destination = Destination::Texture(of_table(texture, (STORAGE, table))?);
    StorageRequest::new(context, destination, levels, internal, size)?.apply(context);
    Ok(())
}

pub(crate) fn texture_storage_1d(
    context: &mut Context,
    texture: GLuint,
    levels: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
) -> Result<()> {
    storage(context, (&STORAGE_1D, texture), levels, internalformat, [width, 1, 1])
}

pub(crate) fn texture_storage_2d(
    context: &mut Context,
    texture: GLuint,
    levels: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    storage(context, (&STORAGE_2D, texture), levels, internalformat, [width, height, 1])
}

pub(crate) fn texture_storage_3d(
    context: &mut Context,
    texture: GLuint,
    levels: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
) -> Result<()> {
    storage(context, (&STORAGE_3D, texture), levels, internalformat, [width, height, depth])
}

fn storage_multisample(
    context: &mut Context,
    (table, name): (&Table<ImageTarget>, GLuint),
    arguments: &Arguments,
) -> Result<()> {
    let texture = ChosenTexture::named(context, name)?;
    let destination = Destination::Texture(of_table(texture, (STORAGE, table))?);
    specify_of(context, &destination, arguments, Lifetime::Immutable)
}

pub(crate) fn texture_storage_2d_multisample(
    context: &mut Context,
    texture: GLuint,
    samples: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
    fixedsamplelocations: bool,
) -> Result<()> {
    let (size, fixed_locations) = ([width, height, 1], fixedsamplelocations);
    let arguments = Arguments { samples, internal: internalformat, size, fixed_locations };
    storage_multisample(context, (&IMAGE_2D_MULTISAMPLE, texture), &arguments)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn texture_storage_3d_multisample(
    context: &mut Context,
    texture: GLuint,
    samples: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
    fixedsamplelocations: bool,
) -> Result<()> {
    let (size, fixed_locations) = ([width, height, depth], fixedsamplelocations);
    let arguments = Arguments { samples, internal: internalformat, size, fixed_locations };
    storage_multisample(context, (&IMAGE_3D_MULTISAMPLE, texture), &arguments)
}

/// The texture of a name, whose texels are a buffer's.
fn of_buffer(context: &mut Context, name: GLuint) -> Result<ChosenTexture> {
    let texture = ChosenTexture::named(context, name)?;
    match texture.target == TextureTarget::Buffer {
        true => Ok(texture),
        false => texture.wrong_target(BUFFERS, "does not take its texels from a buffer"),
    }
}

pub(crate) fn texture_buffer(
    context: &mut Context,
    texture: GLuint,
    internalformat: GLenum,
    buffer: GLuint,
) -> Result<()> {
    let texture = of_buffer(context, texture)?;
    attach_all(context, &texture, internalformat, buffer)
}

pub(crate) fn texture_buffer_range(
    context: &mut Context,
    texture: GLuint,
    internalformat: GLenum,
    buffer: GLuint,
    offset: GLintptr,
    size: GLsizeiptr,
) -> Result<()> {
    let texture = of_buffer(context, texture)?;
    attach_range(context, &texture, internalformat, buffer, (offset, size))
}
