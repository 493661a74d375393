//! `glBitmap`: GL 2.1, section 3.7.

use crate::state::raster_position::RasterPosition;
use rasterizer::driver::{MaskBlock, PixelMask, Rect};
use std::sync::Arc;

/// Bitmaps that wait for more: text is drawn letter by letter.
#[derive(Debug)]
pub(crate) struct Bitmaps {
    /// The raster position of the first.
    pub position: RasterPosition,
    /// The pixels that fragments reach.
    pub area: Rect,
    pub pixels: Arc<PixelMask>,
    pub twice: Twice,
}

/// What a fragment does where one like it was drawn before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Twice {
    /// Nothing.
    Same,
    /// Maybe something.
    Other,
}

impl Twice {}

impl Bitmaps {
    /// Whether fragments of a raster position are those of the first, but for where they are.
    pub(crate) fn are_like(&self, position: &RasterPosition) -> bool {
        let bits = |position: &RasterPosition| {
            let [color, secondary] = [position.color, position.secondary_color];
            let coords = position.tex_coords.map(|coords| coords.map(f32::to_bits));
            let depth = position.window[2].to_bits();
            let colors = [color, secondary].map(|color| color.map(f32::to_bits));
            (depth, colors, coords, position.distance.to_bits())
        };
        bits(&self.position) == bits(position)
    }

    /// Adds pixels, unless one is there that is to be drawn again.
    pub(crate) fn take(&mut self, blocks: &[MaskBlock]) -> bool {
        let is_free = |block: &MaskBlock| self.pixels.block(block.at) & block.pixels == 0;
        let fit = self.twice == Twice::Same || blocks.iter().all(is_free);
        if fit {
            let pixels = Arc::make_mut(&mut self.pixels);
            blocks.iter().for_each(|block| pixels.add(*block));
        }
        fit
    }
}

/// Whether bitmaps that wait may do so while this call is made, of those that may not stand between
/// `glBegin` and `glEnd`: it changes nothing that their fragments depend on, or sees to that itself.
pub(crate) fn outlast(call: &str) -> bool {
    const CALLS: [&str; 12] = [
        "glBitmap",
        "glListBase",
        "glPixelStorei",
        "glPixelStoref",
        "glPushClientAttrib",
        "glPopClientAttrib",
        "glPushAttrib",
        "glPopAttrib",
        "glGetIntegerv",
        "glGetFloatv",
        "glGetDoublev",
        "glGetBooleanv",
    ];
    CALLS.contains(&call) || call.starts_with("glRasterPos") || call.starts_with("glWindowPos")
}
