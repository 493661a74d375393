//! Compressed images as the client has them: `glCompressedTexImage`, `glCompressedTexSubImage` and
//! `glGetCompressedTexImage`; GL 2.1, sections 3.8.3 and 6.1.4.

use crate::base::args::{Data, DataOut};
use crate::base::constants::*;
use crate::base::error::{Result, invalid_operation, invalid_value};
use crate::base::types::*;
use crate::calls::pixels::memory::{source, write_bytes};
use crate::calls::texture::bound::{ChosenImage, ChosenTexture};
use crate::calls::texture::get_sub::check_size;
use crate::calls::texture::level_request::{ImageRequest, LevelDesc};
use crate::calls::texture::sub::BoxRequest;
use crate::context::Context;
use crate::objects::target::{Dimensions, ImageTarget, TextureTarget, any_bound, checked_level};
use crate::pixel::convert;
use crate::pixel::etc::{self, EtcFormat};
use crate::pixel::formats::{COMPRESSED, COMPRESSED_IN_ES};
use crate::pixel::scratch::scratch;
use texunit::format::Format;
use texunit::image::Level;

const SECTION: &str = "GL 2.1, section 3.8.3";
const ETC: &str = "OpenGL ES 3.0, section 3.8.6";

/// Checks that `imageSize` is what a box of this size takes.
fn checked_bytes(format: Format, size: [u32; 3], image_size: GLsizei) -> Result<usize> {
    let [width, height, depth] = size;
    let bytes = Level::required_bytes(format, width, height, depth).unwrap_or(usize::MAX);
    if usize::try_from(image_size) == Ok(bytes) {
        return Ok(bytes);
    }
    invalid_value(
        SECTION,
        format!("imageSize = {image_size}, but {width}×{height}×{depth} texels take {bytes} bytes"),
    )
}

fn compressed_tex_image(
    context: &mut Context,
    (dimensions, target): (Dimensions, GLenum),
    level: GLint,
    internal: GLenum,
    given: [GLsizei; 3],
    border: GLint,
    (image_size, data): (GLsizei, Data<'_>),
) -> Result<()> {
    let image = dimensions.image(target)?;
    context.lists.charge_image(given);
    if let Some(format) = of_es(context, internal) {
        let box_ = (image, level, given);
        return etc_image(context, format, box_, (image_size, data));
    }
    let formats = if context.profile.is_es() { &COMPRESSED_IN_ES } else { &COMPRESSED };
    let format = formats.decode("internalformat", internal)?.stored;
    if border != 0 {
        return invalid_value(SECTION, format!("border = {border} of compressed images must be 0"));
    }
    let desc = LevelDesc::new(image, level, internal, format, given, border)?;
    let request = match desc.request(context)? {
        ImageRequest::Texture(request) => request,
        ImageRequest::Proxy(proxy) => {
            proxy.apply(context);
            return Ok(());
        }
    };
    let bytes = checked_bytes(format, request.desc.size, image_size)?;
    let source = source(context, data, bytes)?;
    let mut texels = request.storage()?;
    if let Some(source) = source {
        texels.texels[..bytes].copy_from_slice(checked_slice(source.bytes(), bytes)?);
    }
    request.apply(context, texels)
}

/// The format of ETC2 or EAC of that name, which contexts of OpenGL ES have.
fn of_es(context: &Context, name: GLenum) -> Option<&'static EtcFormat> {
    etc::find(name).filter(|_| context.profile.is_es())
}

fn checked_etc_bytes(format: &EtcFormat, size: [u32; 3], image_size: GLsizei) -> Result<usize> {
    let bytes = format.bytes(size);
    if usize::try_from(image_size) == Ok(bytes) {
        return Ok(bytes);
    }
    let [width, height, depth] = size;
    invalid_value(
        ETC,
        format!("imageSize = {image_size}, but {width}×{height}×{depth} texels take {bytes} bytes"),
    )
}

/// A level of ETC2 or EAC, which is stored decoded.
fn etc_image(
    context: &mut Context,
    format: &EtcFormat,
    (image, level, given): (ImageTarget, GLint, [GLsizei; 3]),
    (image_size, data): (GLsizei, Data<'_>),
) -> Result<()> {
    let is_array = given[2] > 1 || image.target() == TextureTarget::D2Array;
    if image.target() == TextureTarget::D3 || is_array && format.name == GL_ETC1_RGB8_OES {
        let name = enum_name(format.name);
        return invalid_operation(ETC, format!("this target takes no images of {name}"));
    }
    let desc = LevelDesc::new(image, level, format.name, format.stored, given, 0)?;
    let request = match desc.request(context)? {
        ImageRequest::Texture(request) => request,
        ImageRequest::Proxy(proxy) => {
            proxy.apply(context);
            return Ok(());
        }
    };
    let size = request.desc.size;
    let bytes = checked_etc_bytes(format, size, image_size)?;
    let source = source(context, data, bytes)?;
    let mut texels = request.storage()?;
    if let Some(source) = source {
        let blocks = checked_slice(source.bytes(), bytes)?;
        let end = texels.texels.len() - texunit::image::PADDING;
        format.decode(size, blocks, &mut texels.texels[..end]);
    }
    request.apply(context, texels)
}

/// Blocks over a box of a level of ETC2 or EAC.
fn etc_sub_image(
    context: &mut Context,
    format: &EtcFormat,
    (image, level, offset, size): (ChosenImage, GLint, [GLint; 3], [GLsizei; 3]),
    (image_size, data): (GLsizei, Data<'_>),
) -> Result<()> {
    let area = BoxRequest::new(context, image, level, offset, size)?;
    let requested = area.internal(context);
    if requested != format.name || requested == GL_ETC1_RGB8_OES {
        let [format, requested] = [format.name, requested].map(enum_name);
        let rule = format!(
            "format = {format}, but the level is of {requested} (of ETC1, levels are given whole)"
        );
        return invalid_operation(ETC, rule);
    }
    let pixels = area.pixels_size();
    let bytes = checked_etc_bytes(format, pixels, image_size)?;
    let Some(source) = source(context, data, bytes)? else {
        let rule = format!("data must not be NULL: {bytes} bytes are needed");
        return invalid_operation(ETC, rule);
    };
    let blocks = checked_slice(source.bytes(), bytes)?;
    area.check_blocks_of(etc::SIDE)?;
    let mut texels = scratch(format.stored, pixels.map(|side| side as usize))?;
    format.decode(pixels, blocks, &mut texels);
    area.apply(context, &texels)
}

fn checked_slice(has: &[u8], bytes: usize) -> Result<&[u8]> {
    match has.get(..bytes) {
        Some(blocks) => Ok(blocks),
        None => invalid_operation(
            SECTION,
            format!("imageSize = {bytes}, but the memory has {} bytes", has.len()),
        ),
    }
}

fn compressed_tex_sub_image(
    context: &mut Context,
    (dimensions, target): (Dimensions, GLenum),
    level: GLint,
    offset: [GLint; 3],
    size: [GLsizei; 3],
    format: GLenum,
    data: (GLsizei, Data<'_>),
) -> Result<()> {
    let image = ChosenImage::bound(context, dimensions.bound(target)?);
    replace_blocks(context, image, level, (offset, size), format, data)
}

/// Replaces the blocks of a box of a level by the client's.
pub(crate) fn replace_blocks(
    context: &mut Context,
    image: ChosenImage,
    level: GLint,
    (offset, size): ([GLint; 3], [GLsizei; 3]),
    format: GLenum,
    (image_size, data): (GLsizei, Data<'_>),
) -> Result<()> {
    context.lists.charge_image(size);
    if let Some(format) = of_es(context, format) {
        return etc_sub_image(context, format, (image, level, offset, size), (image_size, data));
    }
    let format = COMPRESSED.decode("format", format)?.stored;
    let area = BoxRequest::new(context, image, level, offset, size)?;
    if area.format != format {
        return invalid_operation(SECTION, "format must be the level's internalformat");
    }
    let bytes = checked_bytes(format, area.pixels_size(), image_size)?;
    let Some(source) = source(context, data, bytes)? else {
        return invalid_operation(
            SECTION,
            format!("data must not be NULL: {bytes} bytes are needed"),
        );
    };
    let blocks = checked_slice(source.bytes(), bytes)?;
    area.check_blocks()?;
    area.apply(context, blocks)
}

pub(crate) fn get_compressed_tex_image(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    img: DataOut<'_>,
) -> Result<()> {
    let face = any_bound(target)?;
    let texture = ChosenTexture::bound(context, face.target);
    read_blocks(context, (&texture, face.face), level, None, img)
}

/// Reads the blocks of a compressed level.
pub(crate) fn read_blocks(
    context: &mut Context,
    (texture, face): (&ChosenTexture, u8),
    level: GLint,
    buf_size: Option<GLsizei>,
    img: DataOut<'_>,
) -> Result<()> {
    const SECTION: &str = "GL 2.1, section 6.1.4";
    let level = checked_level(SECTION, texture.target, level)?;
    let image = texture.get(context).image.texels();
    let found = image.level(face.into(), level);
    let Some(level) = found.filter(|level| level.format.block().is_some()) else {
        return invalid_operation(SECTION, "the level is not compressed: use glGetTexImage");
    };
    let blocks = convert::texels(level);
    buf_size.map_or(Ok(()), |size| check_size(blocks.len(), size))?;
    write_bytes(context, img, blocks.len(), |out| {
        out[..blocks.len()].copy_from_slice(blocks);
    })
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn compressed_tex_image_1d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    internalformat: GLenum,
    width: GLsizei,
    border: GLint,
    image_size: GLsizei,
    data: Data<'_>,
) -> Result<()> {
    let (target, size) = ((Dimensions::One, target), [width, 1, 1]);
    compressed_tex_image(context, target, level, internalformat, size, border, (image_size, data))
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn compressed_tex_image_2d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
    border: GLint,
    image_size: GLsizei,
    data: Data<'_>,
) -> Result<()> {
    let (target, size) = ((Dimensions::Two, target), [width, height, 1]);
    compressed_tex_image(context, target, level, internalformat, size, border, (image_size, data))
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn compressed_tex_image_3d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
    border: GLint,
    image_size: GLsizei,
    data: Data<'_>,
) -> Result<()> {
    let (target, size) = ((Dimensions::Three, target), [width, height, depth]);
    compressed_tex_image(context, target, level, internalformat, size, border, (image_size, data))
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn compressed_tex_sub_image_1d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    xoffset: GLint,
    width: GLsizei,
    format: GLenum,
    image_size: GLsizei,
    data: Data<'_>,
) -> Result<()> {
    let (target, size) = ((Dimensions::One, target), [width, 1, 1]);
    let data = (image_size, data);
    compressed_tex_sub_image(context, target, level, [xoffset, 0, 0], size, format, data)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn compressed_tex_sub_image_2d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    width: GLsizei,
    height: GLsizei,
    format: GLenum,
    image_size: GLsizei,
    data: Data<'_>,
) -> Result<()> {
    let (target, size) = ((Dimensions::Two, target), [width, height, 1]);
    let (offset, data) = ([xoffset, yoffset, 0], (image_size, data));
    compressed_tex_sub_image(context, target, level, offset, size, format, data)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn compressed_tex_sub_image_3d(
    context: &mut Context,
    target: GLenum,
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
    let (target, size) = ((Dimensions::Three, target), [width, height, depth]);
    let (offset, data) = ([xoffset, yoffset, zoffset], (image_size, data));
    compressed_tex_sub_image(context, target, level, offset, size, format, data)
}
