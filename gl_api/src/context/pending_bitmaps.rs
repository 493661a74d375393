//! Bitmaps that wait to be drawn together: `glBitmap` (GL 2.1, section 3.7).

use crate::state::raster_position::RasterPosition;
use rasterizer::driver::{MaskBlock, PixelMask, Rect};
use std::sync::Arc;

/// Bitmaps that wait for more, as text is drawn letter by letter.
#[derive(Debug)]
pub(crate) struct PendingBitmaps {
    /// The raster position of the first bitmap.
    pub position: RasterPosition,
    /// The pixels that fragments reach.
    pub area: Rect,
    pub pixels: Arc<PixelMask>,
    pub overdraw: Overdraw,
}

/// Whether a pixel that two equal fragments reach differs from one that a single fragment reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Overdraw {
    /// It does not.
    Idempotent,
    /// It may, as with blending: such bitmaps wait together only where they do not overlap.
    Accumulates,
}

impl PendingBitmaps {
    /// Whether fragments at a raster position have the values of those at the first.
    pub(crate) fn match_position(&self, position: &RasterPosition) -> bool {
        let bits = |position: &RasterPosition| {
            let [color, secondary] = [position.color, position.secondary_color];
            let coords = position.tex_coords.map(|coords| coords.map(f32::to_bits));
            let depth = position.window[2].to_bits();
            let colors = [color, secondary].map(|color| color.map(f32::to_bits));
            (depth, colors, coords, position.distance.to_bits())
        };
        bits(&self.position) == bits(position)
    }

    /// Adds pixels; `false`, and nothing is added, where a pixel would have to be drawn again.
    pub(crate) fn try_add(&mut self, blocks: &[MaskBlock]) -> bool {
        let is_free = |block: &MaskBlock| self.pixels.block(block.at) & block.pixels == 0;
        let fit = self.overdraw == Overdraw::Idempotent || blocks.iter().all(is_free);
        if fit {
            let pixels = Arc::make_mut(&mut self.pixels);
            blocks.iter().for_each(|block| pixels.add(*block));
        }
        fit
    }
}

/// Whether bitmaps may stay pending during a call of those that may not stand between `glBegin` and `glEnd`: it changes
/// nothing that their fragments depend on, or draws them itself where it does.
pub(crate) fn bitmaps_survive(call: &str) -> bool {
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
