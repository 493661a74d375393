//! Calls that name their texture: `ARB_direct_state_access`, chapter 8. Each gives the call of the same subject a texture
//! that need not be bound.

use crate::base::args::{Data, DataOut};
use crate::base::error::{Result, Table, invalid_value};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::texture::bound::{ChosenImage, ChosenTexture, Faces, bindable};
use crate::calls::texture::compressed::{read_blocks, replace_blocks};
use crate::calls::texture::copy::copy_to;
use crate::calls::texture::get::read_level;
use crate::calls::texture::get_sub::{TexelBox, read_blocks_of_box, read_box};
use crate::calls::texture::mipmap::generate_all;
use crate::calls::texture::query::property_of_texture;
use crate::calls::texture::sub::replace_box;
use crate::context::Context;
use crate::interface::MAX_COMBINED_TEXTURE_IMAGE_UNITS;
use crate::objects::bound::Bound;
use crate::objects::target::{Dimensions, ImageTarget, TextureTarget};
use crate::objects::texture::Texture;

const SECTION: &str = "ARB_direct_state_access, section 8.1";
const IMAGES: &str = "ARB_direct_state_access, section 8.6";
const READING: &str = "ARB_direct_state_access, section 8.11";

pub(crate) fn create_textures(
    context: &mut Context,
    target: GLenum,
    n: GLsizei,
    textures: &mut [GLuint],
) -> Result<()> {
    let target = bindable(context.profile).decode("target", target)?;
    let depth_mode = context.profile.depth_mode();
    context.objects.shared.textures.add_each(SECTION, n, textures, || {
        let mut texture = Texture::new(target);
        texture.state.sampler.depth_mode = depth_mode;
        texture
    })
}

/// Binds a texture to its target of a unit; 0 unbinds what is bound to any target.
pub(crate) fn bind_texture_unit(context: &mut Context, unit: GLuint, name: GLuint) -> Result<()> {
    if unit >= u32::from(MAX_COMBINED_TEXTURE_IMAGE_UNITS) {
        let rule = format!(
            "unit = {unit} must be below {MAX_COMBINED_TEXTURE_IMAGE_UNITS}: it is a number, not GL_TEXTURE0 + i"
        );
        return invalid_value(SECTION, rule);
    }
    if name == 0 {
        context.state.units.unit_mut(unit as usize).bound.fill(Bound::default());
        return Ok(());
    }
    let target = ChosenTexture::named(context, name)?.target;
    let bound = context.objects.shared.textures.hold(name);
    context.state.units.unit_mut(unit as usize).bound[target as usize] = bound;
    Ok(())
}

/// A texture whose target must be in the table of a call.
pub(crate) fn of_table(
    texture: ChosenTexture,
    (section, table): (&'static str, &Table<ImageTarget>),
) -> Result<ChosenTexture> {
    let is_taken = table.rows.iter().any(|(_, image)| match image {
        ImageTarget::Bound(face) => face.target == texture.target,
        ImageTarget::Proxy(_) => false,
    });
    match is_taken {
        true => Ok(texture),
        false => texture.wrong_target(section, "this call does not take"),
    }
}

/// The image of a texture that a call of so many dimensions works on. The faces of cube maps are layers.
fn image(context: &mut Context, dimensions: Dimensions, name: GLuint) -> Result<ChosenImage> {
    let texture = ChosenTexture::named(context, name)?;
    if texture.target != TextureTarget::Cube {
        return Ok(of_table(texture, (IMAGES, dimensions.table()))?.face(0));
    }
    match dimensions {
        Dimensions::Three => Ok(ChosenImage { texture, faces: Faces::Layers }),
        Dimensions::One | Dimensions::Two => {
            texture.wrong_target(IMAGES, "only calls of three dimensions take, its faces as layers")
        }
    }
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn texture_sub_image_1d(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    xoffset: GLint,
    width: GLsizei,
    format: GLenum,
    ty: GLenum,
    pixels: Data<'_>,
) -> Result<()> {
    let image = (Dimensions::One, image(context, Dimensions::One, texture)?);
    replace_box(context, image, level, [xoffset, 0, 0], [width, 1, 1], (format, ty), pixels)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn texture_sub_image_2d(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    width: GLsizei,
    height: GLsizei,
    format: GLenum,
    ty: GLenum,
    pixels: Data<'_>,
) -> Result<()> {
    let image = (Dimensions::Two, image(context, Dimensions::Two, texture)?);
    let (offset, size) = ([xoffset, yoffset, 0], [width, height, 1]);
    replace_box(context, image, level, offset, size, (format, ty), pixels)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn texture_sub_image_3d(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    zoffset: GLint,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
    format: GLenum,
    ty: GLenum,
    pixels: Data<'_>,
) -> Result<()> {
    let image = (Dimensions::Three, image(context, Dimensions::Three, texture)?);
    let (offset, size) = ([xoffset, yoffset, zoffset], [width, height, depth]);
    replace_box(context, image, level, offset, size, (format, ty), pixels)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn compressed_texture_sub_image_1d(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    xoffset: GLint,
    width: GLsizei,
    format: GLenum,
    image_size: GLsizei,
    data: Data<'_>,
) -> Result<()> {
    let image = image(context, Dimensions::One, texture)?;
    let part = ([xoffset, 0, 0], [width, 1, 1]);
    replace_blocks(context, image, level, part, format, (image_size, data))
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn compressed_texture_sub_image_2d(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    width: GLsizei,
    height: GLsizei,
    format: GLenum,
    image_size: GLsizei,
    data: Data<'_>,
) -> Result<()> {
    let image = image(context, Dimensions::Two, texture)?;
    let part = ([xoffset, yoffset, 0], [width, height, 1]);
    replace_blocks(context, image, level, part, format, (image_size, data))
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn compressed_texture_sub_image_3d(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    zoffset: GLint,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
    format: GLenum,
    image_size: GLsizei,
    data: Data<'_>,
) -> Result<()> {
    let image = image(context, Dimensions::Three, texture)?;
    let part = ([xoffset, yoffset, zoffset], [width, height, depth]);
    replace_blocks(context, image, level, part, format, (image_size, data))
}

pub(crate) fn copy_texture_sub_image_1d(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    xoffset: GLint,
    x: GLint,
    y: GLint,
    width: GLsizei,
) -> Result<()> {
    let image = image(context, Dimensions::One, texture)?;
    copy_to(context, image, level, [xoffset, 0, 0], [x, y], [width, 1])
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn copy_texture_sub_image_2d(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    x: GLint,
    y: GLint,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    let image = image(context, Dimensions::Two, texture)?;
    copy_to(context, image, level, [xoffset, yoffset, 0], [x, y], [width, height])
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn copy_texture_sub_image_3d(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    zoffset: GLint,
    x: GLint,
    y: GLint,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    let image = image(context, Dimensions::Three, texture)?;
    copy_to(context, image, level, [xoffset, yoffset, zoffset], [x, y], [width, height])
}

pub(crate) fn generate_texture_mipmap(context: &mut Context, texture: GLuint) -> Result<()> {
    let texture = ChosenTexture::named(context, texture)?;
    generate_all(context, &texture)
}

/// The texture of a name, whose texels can be read.
fn readable(context: &mut Context, name: GLuint) -> Result<ChosenTexture> {
    let texture = ChosenTexture::named(context, name)?;
    match texture.target.is_multisample() || texture.target == TextureTarget::Buffer {
        true => texture.wrong_target(READING, "has no texels to read"),
        false => Ok(texture),
    }
}

pub(crate) fn get_texture_image(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    format: GLenum,
    ty: GLenum,
    buf_size: GLsizei,
    pixels: DataOut<'_>,
) -> Result<()> {
    let texture = readable(context, texture)?;
    if texture.target == TextureTarget::Cube {
        let faces = TexelBox::level(context, &texture, level)?;
        return read_box(context, &faces, (format, ty), (buf_size, pixels));
    }
    read_level(context, (&texture, 0), level, (format, ty), (Some(buf_size), pixels))
}

pub(crate) fn get_compressed_texture_image(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    buf_size: GLsizei,
    pixels: DataOut<'_>,
) -> Result<()> {
    let texture = readable(context, texture)?;
    if texture.target == TextureTarget::Cube {
        let faces = TexelBox::level(context, &texture, level)?;
        return read_blocks_of_box(context, &faces, (buf_size, pixels));
    }
    read_blocks(context, (&texture, 0), level, Some(buf_size), pixels)
}

fn level_property(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    pname: GLenum,
) -> Result<GLint> {
    let texture = ChosenTexture::named(context, texture)?;
    property_of_texture(context, texture, level, pname)
}

pub(crate) fn get_texture_level_parameteriv(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    put(params, &[level_property(context, texture, level, pname)?])
}

pub(crate) fn get_texture_level_parameterfv(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    pname: GLenum,
    params: &mut [GLfloat],
) -> Result<()> {
    put(params, &[level_property(context, texture, level, pname)? as GLfloat])
}
