//! The work of a compilation or a link, counted in steps that take about as long on any source: tokens, expressions,
//! statements, scalars. What a short source expands to can be without bounds; the work is not.

use crate::limits::MAX_WORK;

/// The work of all phases of a compilation or a link.
#[derive(Clone, Copy, Debug, Default)]
pub struct Work {
    steps: u64,
}

impl Work {
    /// Adds steps.
    pub fn add(&mut self, steps: usize) {
        self.steps = self.steps.saturating_add(steps as u64);
    }

    /// Whether there were more than [`MAX_WORK`] steps.
    pub fn is_over(&self) -> bool {
        self.steps > MAX_WORK
    }
}
