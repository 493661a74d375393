//! Graphics resets: what `KHR_robustness` reports of a draw that was stopped.

use crate::base::constants::{GL_LOSE_CONTEXT_ON_RESET, GL_NO_RESET_NOTIFICATION};
use crate::base::types::GLenum;

/// What a context reports of draws whose shaders were stopped (`KHR_robustness`: the reset notification behaviour).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ResetNotification {
    /// `GL_NO_RESET_NOTIFICATION`: nothing; the first stopped draw of a process is reported on stderr.
    #[default]
    Never,
    /// `GL_LOSE_CONTEXT_ON_RESET`: `glGetGraphicsResetStatus` returns `GL_GUILTY_CONTEXT_RESET` once after a draw
    /// was stopped. The context keeps its state and objects, and can be used further.
    LoseContextOnReset,
}

impl ResetNotification {
    /// The value of `GL_RESET_NOTIFICATION_STRATEGY`.
    pub(crate) fn encode(self) -> GLenum {
        match self {
            Self::Never => GL_NO_RESET_NOTIFICATION,
            Self::LoseContextOnReset => GL_LOSE_CONTEXT_ON_RESET,
        }
    }
}

/// Whether a stopped draw was reported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ResetStatus {
    /// No draw was stopped since the last report.
    NoError,
    /// A draw of this context was stopped.
    Guilty,
}

/// The graphics resets of a context.
#[derive(Debug)]
pub(crate) struct Resets {
    pub notification: ResetNotification,
    pub status: ResetStatus,
}

impl Resets {
    /// Those of a new context.
    pub fn new(notification: ResetNotification) -> Self {
        Self { notification, status: ResetStatus::NoError }
    }

    /// Notes that a draw was stopped.
    pub fn draw_was_stopped(&mut self) {
        match self.notification {
            ResetNotification::Never => {}
            ResetNotification::LoseContextOnReset => self.status = ResetStatus::Guilty,
        }
    }
}
