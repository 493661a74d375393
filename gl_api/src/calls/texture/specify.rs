//! `glTexImage1D`, `glTexImage2D` and `glTexImage3D` (GL 2.1, section 3.8.1).

use crate::base::args::Data;
use crate::base::constants::*;
use crate::base::error::{Result, invalid_operation, invalid_value, must_be};
use crate::base::types::*;
use crate::calls::pixels::memory::pixel_source;
use crate::calls::texture::level_request::{ImageRequest, LevelDesc, LevelRequest};
use crate::context::Context;
use crate::objects::target::Dimensions;
use crate::pixel::client::Pixel;
use crate::pixel::client::format::{ClientFormat, Numbers};
use crate::pixel::formats::{self, UNCOMPRESSED, texture_format};
use crate::pixel::layout::{Extent, Layout};
use crate::pixel::scratch::scratch;
use crate::pixel::{blocks, convert, es_texels};
use texunit::format::Format;

const SECTION: &str = "GL 2.1, section 3.8.1";

/// The format that a texture image was asked to have.
pub(crate) fn checked_internal(internal: GLenum) -> Result<Format> {
    match texture_format(internal) {
        Some(format) => Ok(format),
        None => invalid_value(
            SECTION,
            match internal {
                0..=9 => format!("internalformat = {internal} must be 1 to 4, or a format's name"),
                _ => format!(
                    "internalformat = {} {}",
                    enum_name(internal),
                    must_be(internal, &UNCOMPRESSED.values())
                ),
            },
        ),
    }
}

/// Depth pixels go to depth textures, stencils to those of stencils alone, integers to integer textures, colours to the
/// others. `internal` is the internal format of a texture, or `GL_NONE`.
pub(crate) fn kinds_match(pixel: Pixel, stored: Format, internal: GLenum) -> Result<()> {
    let (is_stencil, of_stencils) =
        (pixel.format == ClientFormat::Stencil, formats::is_of_stencils(internal));
    if is_stencil != of_stencils {
        return invalid_operation(
            "ARB_texture_stencil8, section 3.8.3",
            "format GL_STENCIL_INDEX and a stencil internalformat go together, and not with others",
        );
    }
    if is_stencil {
        return Ok(());
    }
    if pixel.format.is_depth() != stored.is_depth() {
        return invalid_operation(
            SECTION,
            "format GL_DEPTH_COMPONENT and a depth internalformat go together, and not with colours",
        );
    }
    if (pixel.numbers == Numbers::Integer) != stored.is_integer() {
        return invalid_operation(
            "EXT_texture_integer, section 3.8.1",
            "formats of integers (GL_RGBA_INTEGER) and integer internalformats go together, and \
             not with others",
        );
    }
    Ok(())
}

/// A call's format, type and pixels.
struct Pixels<'a> {
    format: GLenum,
    ty: GLenum,
    data: Data<'a>,
}

/// Checks the pixels of a level, and replaces the level by them, or by zeros where there are none.
fn replace_level(
    context: &mut Context,
    request: LevelRequest,
    (pixel, data): (Pixel, Data<'_>),
    extent: Extent,
) -> Result<()> {
    let LevelDesc { format, size, given, .. } = request.desc;
    // Before its pixels: of a level that is too large there may be more than memory has addresses.
    let mut texels = request.storage()?;
    let layout =
        Layout::new(&context.state.unpack, pixel, given.map(|side| side as usize), extent)?;
    let source = pixel_source(context, "glTexImage", &layout, data)?;
    let (isa, transfer) = (context.recorder.isa(), &context.state.transfer);
    match (source, format.block()) {
        (None, _) => {}
        (Some(source), None) => {
            let end = texels.texels.len() - texunit::image::PADDING;
            let out = &mut texels.texels[..end];
            convert::unpack(isa, &layout, source.bytes(), format, transfer, out);
        }
        (Some(source), Some(_)) => {
            let (bytes, stored) = (source.bytes(), blocks::COLORS);
            let mut colors = scratch(stored, layout.size)?;
            convert::unpack(isa, &layout, bytes, stored, transfer, &mut colors);
            texels = blocks::compress(format, size, &colors)?;
        }
    }
    request.apply(context, texels)
}

fn tex_image(
    context: &mut Context,
    (dimensions, target): (Dimensions, GLenum),
    level: GLint,
    internal: GLint,
    given: [GLsizei; 3],
    border: GLint,
    pixels: Pixels<'_>,
) -> Result<()> {
    let image = dimensions.image(target)?;
    context.lists.charge_image(given);
    let internal = internal as GLenum;
    let (format, pixel) = if context.profile.is_es() {
        let pixel = Pixel::new_in_es(es_texels::plain_format(pixels.format), pixels.ty)?;
        (es_texels::stored(internal, pixels.format, pixels.ty)?, pixel)
    } else {
        (checked_internal(internal)?, Pixel::new(pixels.format, pixels.ty)?)
    };
    let desc = LevelDesc::new(image, level, internal, format, given, border)?;
    kinds_match(pixel, format, internal)?;
    match desc.request(context)? {
        ImageRequest::Texture(request) => {
            replace_level(context, request, (pixel, pixels.data), extent(dimensions))
        }
        ImageRequest::Proxy(proxy) => {
            proxy.apply(context);
            Ok(())
        }
    }
}

/// Which parts of the pixel store count for a call of so many dimensions.
pub(crate) fn extent(dimensions: Dimensions) -> Extent {
    match dimensions {
        Dimensions::One | Dimensions::Two => Extent::Flat,
        Dimensions::Three => Extent::Volume,
    }
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn tex_image_1d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    internalformat: GLint,
    width: GLsizei,
    border: GLint,
    format: GLenum,
    ty: GLenum,
    data: Data<'_>,
) -> Result<()> {
    let pixels = Pixels { format, ty, data };
    let target = (Dimensions::One, target);
    tex_image(context, target, level, internalformat, [width, 1, 1], border, pixels)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn tex_image_2d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    internalformat: GLint,
    width: GLsizei,
    height: GLsizei,
    border: GLint,
    format: GLenum,
    ty: GLenum,
    data: Data<'_>,
) -> Result<()> {
    let pixels = Pixels { format, ty, data };
    let target = (Dimensions::Two, target);
    tex_image(context, target, level, internalformat, [width, height, 1], border, pixels)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn tex_image_3d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    internalformat: GLint,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
    border: GLint,
    format: GLenum,
    ty: GLenum,
    data: Data<'_>,
) -> Result<()> {
    let pixels = Pixels { format, ty, data };
    let target = (Dimensions::Three, target);
    tex_image(context, target, level, internalformat, [width, height, depth], border, pixels)
}
