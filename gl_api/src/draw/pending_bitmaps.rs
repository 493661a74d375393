//! Bitmaps as draws: those that follow one another wait in [`PendingBitmaps`] and are drawn together.

use crate::base::error::Result;
use crate::context::Context;
use crate::context::pending_bitmaps::{Overdraw, PendingBitmaps};
use crate::context::pending_primitives::PendingPrimitives;
use crate::draw::completeness::draw_pass;
use crate::draw::pass::drawn_area;
use crate::draw::pending_primitives::{can_batch, draw_pending};
use crate::pixel::layout::{Bits, Layout};
use crate::state::enable::Flag;
use rasterizer::driver::{MaskBlock, PixelMask, Rect};
use std::ops::Range;
use std::sync::Arc;

/// A bitmap and where it lies.
pub(crate) struct Bitmap<'a> {
    pub layout: &'a Layout,
    pub bits: Bits,
    pub bytes: &'a [u8],
    /// Its first pixel in the window.
    pub first: [i64; 2],
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

impl Overdraw {
    fn of(context: &Context) -> Self {
        let state = &context.state;
        let adds = state.enables.has(Flag::ColorLogicOp)
            || state.enables.has(Flag::StencilTest)
            || state.fragment.buffers.iter().any(|buffer| buffer.blend)
            || context.recorder.counter.is_some();
        if adds { Self::Accumulates } else { Self::Idempotent }
    }
}

/// Draws a bitmap, or adds it to the pending ones.
pub(crate) fn draw(context: &mut Context, bitmap: &Bitmap<'_>) -> Result<()> {
    if let Some(PendingPrimitives::Bitmaps(waiting)) = &mut context.pending
        && waiting.match_position(&context.state.raster_position)
        && waiting.try_add(&bitmap.blocks(waiting.area))
    {
        return Ok(());
    }
    draw_pending(context);
    let pass = draw_pass(context)?;
    let mut bitmaps = PendingBitmaps {
        position: context.state.raster_position.clone(),
        area: drawn_area(context, &pass),
        pixels: Arc::new(PixelMask::new(pass.width, pass.height)),
        overdraw: Overdraw::of(context),
    };
    bitmaps.try_add(&bitmap.blocks(bitmaps.area));
    if context.objects.shared.is_exclusive() && can_batch(context) {
        context.pending = Some(PendingPrimitives::Bitmaps(Box::new(bitmaps)));
        return Ok(());
    }
    crate::draw::pixel_rectangle::draw_mask(context, &bitmaps.position, &bitmaps.pixels)
}

/// Draws pending bitmaps.
pub(crate) fn draw_pending_bitmaps(context: &mut Context, bitmaps: &PendingBitmaps) {
    // The driver may refuse it, as every draw.
    if let Err(error) =
        crate::draw::pixel_rectangle::draw_mask(context, &bitmaps.position, &bitmaps.pixels)
    {
        context.refuse("glBitmap", error);
    }
}
