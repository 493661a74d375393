//! `glReadPixels`: GL 2.1, section 4.3.2.

use super::Region;
use super::complete::read_attachment;
use crate::context::Context;
use crate::entry::DataOut;
use crate::error::{Result, invalid_operation, not_negative};
use crate::texture::client::{ClientFormat, Layout, format_and_type};
use crate::texture::convert;
use crate::texture::get::destination;
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
    let (format, ty) = format_and_type(format, ty)?;
    let layout = Layout::new(&context.state.pack, format, ty, width, height)?;
    let bytes = destination(&layout, pixels)?;
    let source = match format {
        ClientFormat::Depth => depth_source(context)?,
        ClientFormat::Red
        | ClientFormat::Green
        | ClientFormat::Blue
        | ClientFormat::Alpha
        | ClientFormat::Rg
        | ClientFormat::Rgb
        | ClientFormat::Bgr
        | ClientFormat::Rgba
        | ClientFormat::Bgra
        | ClientFormat::Luminance
        | ClientFormat::LuminanceAlpha => color_source(context)?,
    };
    convert::pack(&source, Region::new(x, y, width, height), &layout, bytes);
    Ok(())
}
