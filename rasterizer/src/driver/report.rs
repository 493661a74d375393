//! What a device answers: errors, and what a submission reports.

use super::visibility::Visibility;
use texunit::lanes::IsaError;
use thiserror::Error;

/// A device that cannot be made.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum DeviceError {
    /// `DETGL_ISA` is wrong.
    #[error(transparent)]
    Isa(#[from] IsaError),
    /// `DETGL_THREADS` is wrong.
    #[error("DETGL_THREADS={0}: must be a whole number from 1 to 1024")]
    Threads(String),
    /// `DETGL_DRAW_BUDGET` is wrong.
    #[error("DETGL_DRAW_BUDGET={0}: must be a whole number below 2^64")]
    Budget(String),
    /// The threads could not be started.
    #[error("cannot start threads: {0}")]
    Pool(String),
}

impl DeviceError {
    pub(super) fn pool(error: impl std::error::Error) -> Self {
        Self::Pool(error.to_string())
    }
}

/// A command buffer that breaks a rule. Nothing of it was run.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("command {index}: {rule}")]
#[non_exhaustive]
pub struct SubmitError {
    /// Which command.
    pub index: usize,
    /// What it broke.
    pub rule: String,
}

/// The operations that endless draws have run since a frame began; the whole budget, once a draw was stopped. Later draws
/// of the frame have the difference to the budget.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrameSpending {
    pub(super) operations: u64,
}

impl FrameSpending {
    /// Takes all that is left of a budget.
    pub(super) fn exhaust(&mut self, budget: u64) {
        self.operations = self.operations.max(budget.max(1));
    }

    /// Adds operations.
    pub(super) fn add(&mut self, operations: u64) {
        self.operations = self.operations.saturating_add(operations);
    }
}

/// What a submission has to say.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct SubmitReport {
    /// Draws whose shaders ran over their budget, by index of their command. What they would have drawn from there on is
    /// left out.
    pub over_budget: Vec<usize>,
    /// What the frame has spent of its budget, with what it had before.
    pub spent: FrameSpending,
    /// Whether anything of its draws may be seen.
    pub visibility: Visibility,
    /// About how many batches of 64 fragments the bounds of its shapes hold.
    pub batches: u64,
}
