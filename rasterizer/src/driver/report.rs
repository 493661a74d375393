//! What a device answers: errors, and what a submission reports.

use super::visibility::Visibility;
use texunit::lanes::IsaError;
use thiserror::Error;

/// A device that cannot be made.
#[derive(Debug, Error)]
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
pub struct SubmitError {
    /// Which command.
    pub index: usize,
    /// What it broke.
    pub rule: String,
}

/// What a submission has to say.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SubmitReport {
    /// Draws whose shaders ran over their budget, by index of their command. What they would have drawn from there on is
    /// left out.
    pub over_budget: Vec<usize>,
    /// Whether anything of its draws may be seen.
    pub visibility: Visibility,
}
