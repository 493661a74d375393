//! `glCopyPixels`: GL 2.1, section 4.3.3.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, not_negative};
use crate::base::types::*;
use crate::calls::framebuffer::read::ReadBuffer;
use crate::calls::pixels::draw::{DEPTHS, rows};
use crate::calls::pixels::stencil;
use crate::context::feedback::RenderMode;
use crate::context::feedback::record::PrimitiveToken;
use crate::context::recorder::pixel_rectangle::ReplacedValue;
use crate::context::window::Region;
use crate::context::{Context, feedback};
use crate::draw::completeness::{Aspect, checked_drawable, draw_planes};
use crate::draw::pixel_rectangle;
use crate::pixel::convert;
use crate::pixel::convert::Conversion;
use crate::pixel::scratch::scratch;
use texunit::format::Format;

const SECTION: &str = "GL 2.1, section 4.3.3";

/// What is copied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum CopiedBuffer {
    Color,
    Depth,
    Stencil,
    DepthStencil,
}

const BUFFER: Table<CopiedBuffer> = Table {
    section: SECTION,
    rows: &[
        (GL_COLOR, CopiedBuffer::Color),
        (GL_DEPTH, CopiedBuffer::Depth),
        (GL_STENCIL, CopiedBuffer::Stencil),
        (GL_DEPTH_STENCIL, CopiedBuffer::DepthStencil),
    ],
};

/// A checked `glCopyPixels`.
struct CopyPixelsRequest {
    kind: CopiedBuffer,
    from: ReadBuffer,
    region: Region,
}

impl CopyPixelsRequest {
    fn new(context: &Context, kind: CopiedBuffer, region: Region) -> Result<Self> {
        checked_drawable(context)?;
        let planes = draw_planes(context);
        let missing = match kind {
            CopiedBuffer::Color => false,
            CopiedBuffer::Depth => !planes.depth,
            CopiedBuffer::Stencil => !planes.stencil,
            CopiedBuffer::DepthStencil => !planes.depth || !planes.stencil,
        };
        if missing {
            return invalid_operation(
                SECTION,
                "the framebuffer that is drawn to has no such depth or stencil buffer",
            );
        }
        let from = match kind {
            CopiedBuffer::Color => ReadBuffer::new(context, Aspect::Color)?,
            CopiedBuffer::Depth => ReadBuffer::new(context, Aspect::Depth)?,
            CopiedBuffer::Stencil => ReadBuffer::new(context, Aspect::Stencil)?,
            CopiedBuffer::DepthStencil => ReadBuffer::depth_stencil(context)?,
        };
        if from.format.is_integer() {
            return invalid_operation(
                "EXT_texture_integer, section 4.3.3",
                "integers are not copied: call glBlitFramebuffer",
            );
        }
        Ok(Self { kind, from, region })
    }

    fn apply(self, context: &mut Context) -> Result<()> {
        let Self { kind, from, region } = self;
        if feedback::pixels(context, PrimitiveToken::CopyPixels) != RenderMode::Render {
            return Ok(());
        }
        let (width, size) = (region.width, [region.width, region.height]);
        let stored = from.pixels(context)?.region(region)?;
        let (isa, transfer) = (context.recorder.isa(), &context.state.transfer);
        let as_format = |to: Format| convert::transcode(isa, from.format, &stored, to, transfer);
        match kind {
            CopiedBuffer::Color => {
                let is_moved =
                    Conversion::between(isa, from.format, Format::Rgba8, transfer).is_moved();
                let to = if is_moved { Format::Rgba8 } else { Format::Rgba32F };
                let texels = as_format(to)?;
                let rows = rows(&texels, width * to.bytes());
                pixel_rectangle::draw(context, size, (ReplacedValue::Color, to), &rows)
            }
            CopiedBuffer::Depth => {
                let texels = as_format(Format::D32F)?;
                pixel_rectangle::draw(context, size, DEPTHS, &rows(&texels, width * 4))
            }
            CopiedBuffer::Stencil => {
                let mut stencils = scratch(Format::R8UI, [region.width, region.height, 1])?;
                Conversion::stencils(isa, from.format, transfer).run(&stored, &mut stencils);
                stencil::draw_stencils(context, size, &stencils)
            }
            CopiedBuffer::DepthStencil => {
                let Some(to) = stencil::target(context)? else { return Ok(()) };
                let (texels, depth) = (as_format(to)?, context.state.fragment.depth_write);
                stencil::draw(context, size, &texels, depth)
            }
        }
    }
}

pub(crate) fn copy_pixels(
    context: &mut Context,
    x: GLint,
    y: GLint,
    width: GLsizei,
    height: GLsizei,
    ty: GLenum,
) -> Result<()> {
    let width = not_negative(SECTION, "width", width.into())?;
    let height = not_negative(SECTION, "height", height.into())?;
    let kind = BUFFER.decode("type", ty)?;
    crate::draw::pass::charge_surface(context);
    let region = Region::new(x, y, width, height);
    CopyPixelsRequest::new(context, kind, region)?.apply(context)
}
