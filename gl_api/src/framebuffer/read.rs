//! `glReadPixels`: GL 2.1, section 4.3.2.

use super::Region;
use super::complete::read_attachment;
use crate::context::Context;
use crate::entry::DataOut;
use crate::error::{Result, invalid_operation, not_negative};
use crate::texture::client::Pixel;
use crate::texture::layout::{Extent, Layout};
use crate::texture::specify::kinds_match;
use crate::texture::transfer::Transfer;
use crate::texture::{convert, memory};
use crate::types::*;
use rasterizer::driver::Attachment;
use std::sync::Arc;
use texunit::image::Level;

const SECTION: &str = "GL 2.1, section 4.3.2";

/// The texels of an attachment as everything recorded leaves them.
fn settled(
    context: &mut Context,
    attachment: Option<Attachment>,
    kind: &str,
) -> Result<Arc<Level>> {
    let level = attachment.and_then(|attachment| {
        crate::draw::settle(context, &attachment.image);
        let texels = attachment.image.texels();
        texels.level(attachment.face.into(), attachment.level.into()).cloned()
    });
    match level {
        Some(level) => Ok(level),
        None => invalid_operation(
            SECTION,
            format!("the framebuffer that is read from has no {kind} buffer"),
        ),
    }
}

/// The colours that are read.
pub(crate) fn color_source(context: &mut Context) -> Result<Arc<Level>> {
    let attachment = read_attachment(context, false)?;
    settled(context, attachment, "colour")
}

/// The depths that are read.
pub(crate) fn depth_source(context: &mut Context) -> Result<Arc<Level>> {
    let attachment = read_attachment(context, true)?;
    settled(context, attachment, "depth")
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn read_pixels(
    context: &mut Context,
    x: GLint,
    y: GLint,
    width: GLsizei,
    height: GLsizei,
    format: GLenum,
    ty: GLenum,
    pixels: DataOut<'_>,
) -> Result<()> {
    let width = not_negative(SECTION, "width", width.into())?;
    let height = not_negative(SECTION, "height", height.into())?;
    let pixel = Pixel::new(format, ty)?;
    let layout = Layout::new(&context.state.pack, pixel, [width, height, 1], Extent::Flat)?;
    let source =
        if pixel.format.is_depth() { depth_source(context)? } else { color_source(context)? };
    kinds_match(pixel, source.format)?;
    let region = Region::new(x, y, width, height);
    let transfer = context.state.transfer;
    memory::write_pixels(context, &layout, pixels, |bytes| {
        pack(&source, region, &layout, &transfer, bytes);
    })
}

/// A region of a level into the client's memory. Pixels outside the level are left as they are.
fn pack(level: &Level, region: Region, layout: &Layout, transfer: &Transfer, bytes: &mut [u8]) {
    let Some(visible) = region.within(level.width, level.height) else { return };
    let size = level.format.bytes();
    let from = (visible.y as i64 - region.y) as usize * layout.stride
        + (visible.x as i64 - region.x) as usize * layout.pixel.bytes();
    let row = Layout {
        size: [visible.width, 1, 1],
        needed: visible.width * layout.pixel.bytes(),
        start: 0,
        ..*layout
    };
    for y in 0..visible.height {
        let texels = &level.texels[(visible.y + y) * level.row_bytes() + visible.x * size..];
        let at = layout.start + from + y * layout.stride;
        let texels = &texels[..visible.width * size];
        convert::pack(&row, level.format, transfer, texels, &mut bytes[at..]);
    }
}
