//! `glBitmap`: GL 2.1, section 3.7.

use crate::base::args::Data;
use crate::base::error::{Result, not_negative};
use crate::base::types::*;
use crate::context::Context;
use crate::context::feedback::RenderMode;
use crate::context::feedback::record::PrimitiveToken;
use crate::draw::completeness::checked_drawable;
use crate::draw::pending_bitmaps::{Bitmap, draw};
use crate::pixel::client::Pixel;
use crate::pixel::layout::{Extent, Layout};

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
    // Draws do not depend on the raster position, and are told anew what a bitmap was drawn with.
    context.state_changes.no_change();
    let width = not_negative(SECTION, "width", width.into())?;
    let height = not_negative(SECTION, "height", height.into())?;
    checked_drawable(context)?;
    let size = [width, height, 1];
    let layout = Layout::new(&context.state.unpack, Pixel::BIT, size, Extent::Flat)?;
    let source = crate::calls::pixels::memory::source(context, bitmap, layout.needed)?;
    if !context.state.raster_position.valid {
        return Ok(());
    }
    let source = source.filter(|_| layout.needed > 0);
    if let Some(source) = &source {
        layout.check_length(source.bytes().len(), "GL_UNPACK_ALIGNMENT")?;
    }
    // An empty one is a bitmap, too (section 5.3).
    if crate::context::feedback::pixels(context, PrimitiveToken::Bitmap) != RenderMode::Render {
        crate::calls::pixels::position::advance(context, [xmove, ymove]);
        return Ok(());
    }
    if let (Some(source), Some(bits)) = (source, layout.bits) {
        // The bitmap begins at a whole pixel, and is not zoomed.
        let position = &context.state.raster_position.window;
        let origin = [xorig, yorig].map(f64::from);
        // Far beyond any window, so that sums are numbers.
        let far = 1e12;
        let first = |axis: usize| snapped(position[axis] - origin[axis]).floor().clamp(-far, far);
        let first = [first(0) as i64, first(1) as i64];
        draw(context, &Bitmap { layout: &layout, bits, bytes: source.bytes(), first })?;
    }
    crate::calls::pixels::position::advance(context, [xmove, ymove]);
    Ok(())
}
