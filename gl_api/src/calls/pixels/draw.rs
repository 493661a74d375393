//! `glDrawPixels`: GL 2.1, section 3.6.4.

use crate::base::args::Data;
use crate::base::constants::enum_name;
use crate::base::error::{Result, invalid_operation, not_negative};
use crate::base::types::*;
use crate::calls::pixels::memory::pixel_source;
use crate::calls::pixels::stencil;
use crate::context::feedback::RenderMode;
use crate::context::feedback::record::PrimitiveToken;
use crate::context::recorder::pixel_rectangle::ReplacedValue;
use crate::context::{Context, feedback};
use crate::draw::completeness::{checked_drawable, draw_planes};
use crate::draw::pixel_rectangle;
use crate::pixel::client::Pixel;
use crate::pixel::client::format::{ClientFormat, FORMAT, Numbers};
use crate::pixel::convert;
use crate::pixel::convert::Conversion;
use crate::pixel::layout::{Extent, Layout};
use crate::pixel::memory::Source;
use crate::pixel::scratch::scratch;
use crate::pixel::transfer::TransferKind;
use std::borrow::Cow;
use texunit::format::Format;

const SECTION: &str = "GL 2.1, section 3.6.4";

/// The rows of a rectangle of texels that lie one after the other.
pub(crate) fn rows<'a>(texels: &'a [u8], row_bytes: usize) -> impl Fn(usize) -> Cow<'a, [u8]> {
    move |y| Cow::Borrowed(&texels[y * row_bytes..][..row_bytes])
}

/// The format of a rectangle of depths, which its fragments read as red.
pub(crate) const DEPTHS: (ReplacedValue, Format) = (ReplacedValue::Depth, Format::R32F);

/// Whether what is drawn to takes these pixels.
fn check_target(context: &Context, pixel: Pixel) -> Result<()> {
    let planes = draw_planes(context);
    let missing = match pixel.format.kind() {
        TransferKind::Depth => !planes.depth,
        TransferKind::Stencil => !planes.stencil,
        TransferKind::DepthStencil => !planes.depth || !planes.stencil,
        TransferKind::Color | TransferKind::ColorIndex => false,
    };
    if missing {
        return invalid_operation(
            SECTION,
            "the framebuffer that is drawn to has no such depth or stencil buffer",
        );
    }
    Ok(())
}

/// Integers are not drawn, whatever their type.
fn check_numbers(format: GLenum) -> Result<()> {
    match FORMAT.get(format) {
        Some((ClientFormat::Stencil, _) | (_, Numbers::Fixed | Numbers::SignedNormalized)) => {
            Ok(())
        }
        Some((_, Numbers::Integer)) => invalid_operation(
            "EXT_texture_integer, section 3.6.4",
            format!("format = {}: integers are not drawn", enum_name(format)),
        ),
        None => Ok(()),
    }
}

/// A checked `glDrawPixels`.
struct DrawPixelsRequest<'a> {
    layout: Layout,
    /// `None` where nothing is drawn.
    source: Option<Source<'a>>,
}

impl<'a> DrawPixelsRequest<'a> {
    fn new(
        context: &mut Context,
        pixel: Pixel,
        [width, height]: [usize; 2],
        pixels: Data<'a>,
    ) -> Result<Self> {
        let layout = Layout::new(&context.state.unpack, pixel, [width, height, 1], Extent::Flat)?;
        checked_drawable(context)?;
        check_target(context, pixel)?;
        let source = pixel_source(context, "glDrawPixels", &layout, pixels)?;
        Ok(Self { layout, source })
    }

    fn apply(self, context: &mut Context) -> Result<()> {
        let Self { layout, source: Some(source) } = self else { return Ok(()) };
        if feedback::pixels(context, PrimitiveToken::DrawPixels) != RenderMode::Render {
            return Ok(());
        }
        let kind = layout.pixel.format.kind();
        let (isa, transfer) = (context.recorder.isa(), context.state.transfer);
        let to = |format: Format| Conversion::unpack(isa, &layout, format, &transfer);
        let format = match kind {
            TransferKind::Depth => Format::D32F,
            TransferKind::Stencil => Format::R8UI,
            TransferKind::DepthStencil => match stencil::target(context)? {
                Some(format) => format,
                None => return Ok(()),
            },
            // Bytes stay bytes, where nothing is done to them.
            TransferKind::Color | TransferKind::ColorIndex => {
                if to(Format::Rgba8).is_moved() {
                    Format::Rgba8
                } else {
                    Format::Rgba32F
                }
            }
        };
        let ([width, height, _], bytes) = (layout.size, source.bytes());
        let size = [width, height];
        let all = || -> Result<Vec<u8>> {
            let mut texels = scratch(format, layout.size)?;
            convert::unpack(isa, &layout, bytes, format, &transfer, &mut texels);
            Ok(texels)
        };
        // Row by row: all of them would be written and read once more.
        let conversion = to(format);
        if !conversion.is_copy(&layout) {
            // So large a row as the client names may have no memory.
            drop(scratch(format, [width, 1, 1])?);
        }
        let rows = |y: usize| {
            let row = &bytes[layout.start + y * layout.stride..][..layout.row_bytes()];
            if conversion.is_copy(&layout) {
                return Cow::Borrowed(row);
            }
            let mut texels = vec![0; width * format.bytes()];
            conversion.unpack_row(&layout, row, &mut texels);
            Cow::Owned(texels)
        };
        match kind {
            TransferKind::Stencil => stencil::draw_stencils(context, size, &all()?),
            TransferKind::DepthStencil => {
                let depth = context.state.fragment.depth_write;
                stencil::draw(context, size, &all()?, depth)
            }
            TransferKind::Depth => pixel_rectangle::draw(context, size, DEPTHS, &rows),
            TransferKind::Color | TransferKind::ColorIndex => {
                pixel_rectangle::draw(context, size, (ReplacedValue::Color, format), &rows)
            }
        }
    }
}

pub(crate) fn draw_pixels(
    context: &mut Context,
    width: GLsizei,
    height: GLsizei,
    format: GLenum,
    ty: GLenum,
    pixels: Data<'_>,
) -> Result<()> {
    let width = not_negative(SECTION, "width", width.into())?;
    let height = not_negative(SECTION, "height", height.into())?;
    check_numbers(format)?;
    let pixel = Pixel::new(format, ty)?;
    crate::draw::pass::charge_surface(context);
    DrawPixelsRequest::new(context, pixel, [width, height], pixels)?.apply(context)
}
