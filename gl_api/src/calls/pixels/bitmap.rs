//! `glBitmap`: GL 2.1, section 3.7.

use crate::base::args::Data;
use crate::base::error::{Result, not_negative};
use crate::base::types::*;
use crate::calls::framebuffer::clear::drawn_area;
use crate::context::Context;
use crate::context::bitmaps::{Bitmaps, Twice};
use crate::context::ended::Ended;
use crate::draw::complete::{checked_drawable, draw_pass};
use crate::draw::ended::{draw_ended, draws_together};
use crate::pixel::client::Pixel;
use crate::pixel::layout::{Bits, Extent, Layout};
use crate::state::enable::Flag;
use crate::state::feedback::Mode;
use crate::state::feedback::record::Kind;
use rasterizer::driver::{MaskBlock, PixelMask, Rect};
use std::ops::Range;
use std::sync::Arc;

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
    context.changes.nothing();
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
    if crate::record::feedback::pixels(context, Kind::Bitmap) != Mode::Render {
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

/// A bitmap and where it lies.
pub(crate) struct Bitmap<'a> {
    layout: &'a Layout,
    bits: Bits,
    bytes: &'a [u8],
    /// Its first pixel in the window.
    first: [i64; 2],
}

impl Bitmap<'_> {
    /// Its pixels within an area of the window.
    fn blocks(&self, area: Rect) -> Vec<MaskBlock> {
        let [width, height, _] = self.layout.size;
        let seen = |axis: usize, size: usize, start: i32, length: u32| {
            let [first, start] = [self.first[axis], start.into()];
            first.max(start)..(first + size as i64).min(start + i64::from(length))
        };
        let columns = seen(0, width, area.x, area.width);
        let rows = seen(1, height, area.y, area.height);
        let mut blocks = Vec::new();
        if columns.is_empty() {
            return blocks;
        }
        for rows in by_blocks(rows) {
            for columns in by_blocks(columns.clone()) {
                let at = [&columns, &rows].map(|range| (range.start / 8) as u32);
                let pixels = self.pixels(columns, rows.clone());
                if pixels != 0 {
                    blocks.push(MaskBlock { at, pixels });
                }
            }
        }
        blocks
    }

    /// Those of some columns and rows of a block.
    fn pixels(&self, columns: Range<i64>, rows: Range<i64>) -> u64 {
        let mut pixels = 0;
        for y in rows {
            let row = (y - self.first[1]) as usize * self.layout.stride;
            let row = &self.bytes[self.layout.start + row..];
            let first = (columns.start - self.first[0]) as usize;
            let bits = self.bits.up_to_eight(row, first, (columns.end - columns.start) as usize);
            pixels |= MaskBlock::row(y as u32 % 8, bits << (columns.start % 8));
        }
        pixels
    }
}

/// The parts of a range of columns or rows, which is not empty, that lie in one block each.
pub(crate) fn by_blocks(range: Range<i64>) -> impl Iterator<Item = Range<i64>> {
    let blocks = range.start / 8..(range.end + 7) / 8;
    blocks.map(move |block| range.start.max(block * 8)..range.end.min(block * 8 + 8))
}

impl Twice {
    fn of(context: &Context) -> Self {
        let state = &context.state;
        let adds = state.enables.has(Flag::ColorLogicOp)
            || state.enables.has(Flag::StencilTest)
            || state.fragment.buffers.iter().any(|buffer| buffer.blend)
            || context.recorder.counter.is_some();
        if adds { Self::Other } else { Self::Same }
    }
}

/// Draws a bitmap, or has it wait with others.
pub(crate) fn draw(context: &mut Context, bitmap: &Bitmap<'_>) -> Result<()> {
    if let Some(Ended::Bitmaps(waiting)) = &mut context.ended
        && waiting.are_like(&context.state.raster_position)
        && waiting.take(&bitmap.blocks(waiting.area))
    {
        return Ok(());
    }
    draw_ended(context);
    let pass = draw_pass(context)?;
    let mut bitmaps = Bitmaps {
        position: context.state.raster_position.clone(),
        area: drawn_area(context, &pass),
        pixels: Arc::new(PixelMask::new(pass.width, pass.height)),
        twice: Twice::of(context),
    };
    bitmaps.take(&bitmap.blocks(bitmaps.area));
    if context.is_alone() && draws_together(context) {
        context.ended = Some(Ended::Bitmaps(Box::new(bitmaps)));
        return Ok(());
    }
    crate::draw::rectangle::draw_mask(context, &bitmaps.position, &bitmaps.pixels)
}

/// Draws the bitmaps that have waited.
pub(crate) fn draw_waiting(context: &mut Context, bitmaps: &Bitmaps) {
    // What the driver cannot do is said, as of every draw.
    if let Err(error) =
        crate::draw::rectangle::draw_mask(context, &bitmaps.position, &bitmaps.pixels)
    {
        context.refuse("glBitmap", error);
    }
}
