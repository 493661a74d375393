//! The vertex stage that the last raster position went through, kept for the next.

use crate::context::recorder::vertex_stage::Ready;

/// The vertex stage that a raster position went through.
#[derive(Debug)]
pub(crate) struct Passed {
    /// How many calls there had been when it was chosen.
    pub at: u64,
    pub ready: Ready,
}

impl Passed {}
