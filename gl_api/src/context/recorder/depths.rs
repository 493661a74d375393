//! Depths of the picture before, where only its colours were cleared: the new one fails against them.

use rasterizer::driver::{ClearValue, DepthState, DepthWrite};
use texunit::sampler::Compare;

/// Which picture has left depths in a window, and whether the picture that is drawn began with a clear of its colours.
#[derive(Debug, Default)]
pub(crate) struct Depths {
    pub drawn: Drawn,
    pub colors: Colors,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Drawn {
    /// Nothing was since they were cleared.
    #[default]
    Nothing,
    /// This picture.
    Now,
    /// One before.
    Before,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Colors {
    #[default]
    Kept,
    Cleared,
}

impl Depths {
    /// Takes note of what is cleared.
    pub fn clear(&mut self, clears: &[ClearValue]) {
        for value in clears {
            match value {
                ClearValue::Color { .. } | ClearValue::Texel { .. } => {
                    self.colors = Colors::Cleared
                }
                ClearValue::Depth(_) => self.drawn = Drawn::Nothing,
                ClearValue::Stencil { .. } => {}
            }
        }
    }

    /// Takes note of a draw; says whether it is compared with what a picture before has left.
    pub(crate) fn draw(&mut self, depth: &DepthState) -> bool {
        let compares = depth.test != Compare::Always;
        let is_hidden = compares && (self.drawn, self.colors) == (Drawn::Before, Colors::Cleared);
        if depth.write == DepthWrite::On && (self.drawn == Drawn::Nothing || !compares) {
            self.drawn = Drawn::Now;
        }
        is_hidden
    }
}
