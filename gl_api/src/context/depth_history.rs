//! Where the depths and stencils of a window are from: never set, cleared, drawn, or left by an earlier picture.
//!
//! A window keeps a [`DepthHistory`] and a [`KnownStencil`]; `draw/warnings/depth.rs` and `draw/warnings/rejected.rs` warn
//! by them.

use crate::context::Context;
use rasterizer::driver::{ClearValue, DepthState, DepthWrite, StencilFace, StencilOp};
use texunit::sampler::Compare;

/// Which picture the depths of a window are from, and whether the present picture began with a clear of its colours.
#[derive(Debug, Default)]
pub(crate) struct DepthHistory {
    pub depths: DepthSource,
    pub color_clear: ColorClear,
    /// The depth of the last clear.
    pub clear_depth: f32,
}

/// What is wrong with the depths that a draw is compared with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum DepthProblem {
    /// Nothing has set them.
    Undefined,
    /// They were cleared to a value against which no fragment in front of it passes.
    ClearedAgainst(f32),
    /// They are those of an earlier picture.
    Stale,
}

/// Where the depths of a window are from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum DepthSource {
    /// Nothing has set them.
    #[default]
    Undefined,
    /// A clear; nothing was drawn since.
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
                ClearValue::Depth(depth) => {
                    (self.depths, self.clear_depth) = (DepthSource::Cleared, *depth);
                }
                ClearValue::Stencil { .. } => {}
            }
        }
    }

    /// Notes that depths were written by other means than clears and draws: all may be set.
    pub fn copied(&mut self) {
        self.depths = DepthSource::ThisPicture;
    }

    /// Notes a draw, and finds what is wrong with the depths that it is compared with.
    pub(crate) fn draw(&mut self, depth: &DepthState) -> Option<DepthProblem> {
        let compares = depth.test != Compare::Always;
        let problem = match self.depths {
            DepthSource::Undefined => Some(DepthProblem::Undefined),
            DepthSource::Cleared => rejects(depth.test, self.clear_depth)
                .then_some(DepthProblem::ClearedAgainst(self.clear_depth)),
            DepthSource::EarlierPicture if self.color_clear == ColorClear::Yes => {
                Some(DepthProblem::Stale)
            }
            DepthSource::EarlierPicture | DepthSource::ThisPicture => None,
        };
        if depth.write == DepthWrite::On && (self.depths == DepthSource::Cleared || !compares) {
            self.depths = DepthSource::ThisPicture;
        }
        problem.filter(|_| compares)
    }
}

/// Whether no depth from 0 to 1 passes against a stored depth, but for one that is equal to it.
fn rejects(test: Compare, stored: f32) -> bool {
    match test {
        Compare::Less | Compare::LessEqual => stored <= 0.0,
        Compare::Greater | Compare::GreaterEqual => stored >= 1.0,
        Compare::Never | Compare::Equal | Compare::NotEqual | Compare::Always => false,
    }
}

/// The stencil that all pixels of a window have, as far as it is known.
#[derive(Debug)]
pub(crate) struct KnownStencil(Option<u8>);

impl Default for KnownStencil {
    /// A new window has zeros.
    fn default() -> Self {
        Self(Some(0))
    }
}

impl KnownStencil {
    /// Notes that stencils may be written.
    pub fn written(&mut self) {
        self.0 = None;
    }

    /// Notes a clear of all pixels.
    pub fn clear(&mut self, value: u8, mask: u8) {
        self.0 = match self.0 {
            Some(before) => Some(before & !mask | value & mask),
            None => (mask == 0xff).then_some(value),
        };
    }

    /// Notes a draw with the stencil test. The stencil with which no fragment passes, if there is one.
    pub fn draw(&mut self, faces: [&StencilFace; 2]) -> Option<u8> {
        let stencil = self.0?;
        let fails = |face: &StencilFace| !face.passes(stencil);
        let all_fail = faces.into_iter().all(fails);
        let writes = |face: &StencilFace| {
            let passes = [face.depth_fail, face.pass].iter().any(|op| *op != StencilOp::Keep);
            face.write_mask != 0 && (face.fail != StencilOp::Keep || passes && !all_fail)
        };
        if faces.into_iter().any(writes) {
            self.0 = None;
            return None;
        }
        all_fail.then_some(stencil)
    }
}

impl Context {
    /// Notes that depths or stencils of the draw framebuffer were copied, by neither clears nor draws.
    pub(crate) fn depth_stencil_copied(&mut self) {
        if self.state.bindings.draw_framebuffer == 0 {
            self.window.depths.copied();
            self.window.stencils.written();
        }
    }
}
