//! Reading texels back: `glGetTexImage`, GL 2.1, section 6.1.4.

use crate::base::args::DataOut;
use crate::base::error::{Result, invalid_enum, invalid_operation};
use crate::base::types::*;
use crate::calls::texture::bound::ChosenTexture;
use crate::calls::texture::get_sub::check_size;
use crate::calls::texture::specify::kinds_match;
use crate::context::Context;
use crate::objects::target::{TextureTarget, any_bound, checked_level};
use crate::pixel::client::Pixel;
use crate::pixel::client::format::{ClientFormat, LuminanceOf};
use crate::pixel::convert::FinalConversion;
use crate::pixel::layout::{Extent, Layout};
use crate::pixel::transfer::Transfer;
use crate::pixel::{blocks, convert};
use texunit::format::Format;

const SECTION: &str = "GL 2.1, section 6.1.4";

/// Checks that texels of a format can be read as these pixels.
pub(crate) fn check_readable(pixel: Pixel, format: Format, internal: GLenum) -> Result<()> {
    // Of textures with depth and stencil, too (ARB_texture_stencil8, section 6.1.4).
    if pixel.format == ClientFormat::Stencil && format.has_stencil() {
        return Ok(());
    }
    kinds_match(pixel, format, internal)?;
    if pixel.format == ClientFormat::DepthStencil && !format.has_stencil() {
        return invalid_operation(
            "EXT_packed_depth_stencil, section 6.1.4",
            "format GL_DEPTH_STENCIL: the texture has no stencils, ask for GL_DEPTH_COMPONENT",
        );
    }
    Ok(())
}

/// The pixels that a call asks for.
pub(crate) fn requested_pixel(section: &'static str, format: GLenum, ty: GLenum) -> Result<Pixel> {
    let pixel = Pixel::new(format, ty)?;
    if pixel.format == ClientFormat::ColorIndex {
        return invalid_enum(section, "format = GL_COLOR_INDEX: texels have colours, no indices");
    }
    Ok(pixel)
}

/// Which parts of the pixel store count for an image of a target.
pub(crate) fn extent(target: TextureTarget) -> Extent {
    match target {
        TextureTarget::D3 | TextureTarget::D2Array | TextureTarget::CubeArray => Extent::Volume,
        TextureTarget::D1
        | TextureTarget::D2
        | TextureTarget::Rect
        | TextureTarget::External
        | TextureTarget::Cube
        | TextureTarget::D1Array
        | TextureTarget::D2Multisample
        | TextureTarget::D2MultisampleArray
        | TextureTarget::Buffer => Extent::Flat,
    }
}

pub(crate) fn get_tex_image(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    format: GLenum,
    ty: GLenum,
    pixels: DataOut<'_>,
) -> Result<()> {
    let face = any_bound(target)?;
    let texture = ChosenTexture::bound(context, face.target);
    read_level(context, (&texture, face.face), level, (format, ty), (None, pixels))
}

/// Reads a level, its border too.
pub(crate) fn read_level(
    context: &mut Context,
    (texture, face): (&ChosenTexture, u8),
    level: GLint,
    (format, ty): (GLenum, GLenum),
    (buf_size, pixels): (Option<GLsizei>, DataOut<'_>),
) -> Result<()> {
    let target = texture.target;
    let level = checked_level(SECTION, target, level)?;
    let pixel = requested_pixel(SECTION, format, ty)?;
    let image = texture.get(context).image.clone();
    crate::draw::pass::submit_draws_to(context, &image);
    let texture = texture.get(context);
    let internal = texture.internal(face.into(), level);
    let texels = texture.image.texels();
    let Some(level) = texels.level(face.into(), level) else { return Ok(()) };
    check_readable(pixel, level.format, internal)?;
    let size = target.level_box(level.stored_size()).map(|side| side as usize);
    let layout = Layout::new(&context.state.pack, pixel, size, extent(target))?;
    buf_size.map_or(Ok(()), |size| check_size(layout.needed, size))?;
    // No transfer operations are performed on images that are read back.
    let (isa, transfer) = (context.recorder.isa(), Transfer::default());
    if level.format.block().is_some() {
        return crate::calls::pixels::memory::write_pixels(context, &layout, pixels, |bytes| {
            let rows = layout.rows().zip(blocks::rows(isa, level));
            let last = FinalConversion::of(blocks::COLORS, LuminanceOf::Red);
            convert::pack_rows(isa, &layout, blocks::COLORS, &transfer, last, rows, bytes);
        });
    }
    crate::calls::pixels::memory::write_pixels(context, &layout, pixels, |bytes| {
        let texels = convert::texels(level);
        convert::pack(isa, &layout, level.format, &transfer, LuminanceOf::Red, texels, bytes);
    })
}
