//! Conditional rendering: `NV_conditional_render`; GL 3.0, section 2.14.
//!
//! The result is waited for in every mode, so that a picture never depends on how fast it comes.

use crate::objects::queries::ActiveQueries;

/// What becomes of draws between `glBeginConditionalRender` and `glEndConditionalRender`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    Draw,
    Discard,
}

impl ActiveQueries {
    /// Whether draws, and clears, have no effect now.
    pub fn discards(&self) -> bool {
        self.conditional == Some(Verdict::Discard)
    }
}
