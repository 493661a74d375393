//! `glBitmap`: GL 2.1, section 3.7.

use super::position;
use super::rectangle::{self, Holds};
use crate::context::Context;
use crate::entry::Data;
use crate::error::{Result, not_negative};
use crate::feedback::record::Kind;
use crate::feedback::{self, Mode};
use crate::framebuffer::complete::checked_drawable;
use crate::texture::client::Pixel;
use crate::texture::layout::{Extent, Layout};
use crate::texture::memory;
use crate::types::*;
use texunit::format::Format;

const SECTION: &str = "GL 2.1, section 3.7";

/// A window coordinate on the subpixel grid, as vertices have it: a position that was meant to be a
/// whole pixel is one, whatever the transformation's rounding was.
fn snapped(coordinate: f64) -> f64 {
    const SUBPIXEL: f64 = 256.0;
    (coordinate * SUBPIXEL).round_ties_even() / SUBPIXEL
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn bitmap(
    context: &mut Context,
    width: GLsizei,
    height: GLsizei,
    xorig: GLfloat,
    yorig: GLfloat,
    xmove: GLfloat,
    ymove: GLfloat,
    bitmap: Data<'_>,
) -> Result<()> {
    let width = not_negative(SECTION, "width", width.into())?;
    let height = not_negative(SECTION, "height", height.into())?;
    checked_drawable(context)?;
    let size = [width, height, 1];
    let layout = Layout::new(&context.state.unpack, Pixel::BIT, size, Extent::Flat)?;
    let source = memory::source(context, bitmap, layout.needed)?;
    if !context.state.raster_position.valid {
        return Ok(());
    }
    let source = source.filter(|_| layout.needed > 0);
    if let Some(source) = &source {
        layout.check_length(source.bytes().len(), "GL_UNPACK_ALIGNMENT")?;
    }
    // An empty one is a bitmap, too (section 5.3).
    if feedback::record::pixels(context, Kind::Bitmap) != Mode::Render {
        position::advance(context, [xmove, ymove]);
        return Ok(());
    }
    if let (Some(source), Some(bits)) = (source, layout.bits) {
        let bytes = source.bytes();
        // The rectangle begins at a whole pixel, and is not zoomed.
        let before = context.state.raster_position.window;
        let zoom = std::mem::replace(&mut context.state.pixel_zoom, [1.0; 2]);
        let origin = [xorig, yorig].map(f64::from);
        let start = &mut context.state.raster_position.window;
        for axis in 0..2 {
            start[axis] = snapped(before[axis] - origin[axis]).floor();
        }
        let drawn = rectangle::draw(context, [width, height], (Holds::Coverage, Format::R8), |y| {
            let row = &bytes[layout.start + y * layout.stride..];
            (0..width).map(|x| bits.at(row, x)).collect()
        });
        context.state.raster_position.window = before;
        context.state.pixel_zoom = zoom;
        drawn?;
    }
    position::advance(context, [xmove, ymove]);
    Ok(())
}
