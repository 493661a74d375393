//! Depths that an earlier picture left, where only colours were cleared: the new picture fails against them.
//!
//! A window keeps a [`DepthHistory`]; `draw/warnings/stale_depth.rs` warns by it.

use rasterizer::driver::{ClearValue, DepthState, DepthWrite};
use texunit::sampler::Compare;

/// Which picture the depths of a window are from, and whether the present picture began with a clear of its colours.
#[derive(Debug, Default)]
pub(crate) struct DepthHistory {
    pub depths: DepthSource,
    pub color_clear: ColorClear,
}

/// Where the depths of a window are from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum DepthSource {
    /// A clear; nothing was drawn since.
    #[default]
    Cleared,
    /// The picture that is drawn now.
    ThisPicture,
    /// A picture before.
    EarlierPicture,
}

/// Whether colours were cleared since the last picture was taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum ColorClear {
    #[default]
    No,
    Yes,
}

impl DepthHistory {
    /// Notes a clear.
    pub fn clear(&mut self, clears: &[ClearValue]) {
        for value in clears {
            match value {
                ClearValue::Color { .. } | ClearValue::Texel { .. } => {
                    self.color_clear = ColorClear::Yes
                }
                ClearValue::Depth(_) => self.depths = DepthSource::Cleared,
                ClearValue::Stencil { .. } => {}
            }
        }
    }

    /// Notes a draw: whether it is compared with depths that an earlier picture left, after a clear of colours alone.
    pub(crate) fn draw(&mut self, depth: &DepthState) -> bool {
        let compares = depth.test != Compare::Always;
        let is_stale = compares
            && (self.depths, self.color_clear) == (DepthSource::EarlierPicture, ColorClear::Yes);
        if depth.write == DepthWrite::On && (self.depths == DepthSource::Cleared || !compares) {
            self.depths = DepthSource::ThisPicture;
        }
        is_stale
    }
}
