//! Visibility of draws: whether any primitive covers a sample, and if not, why. It explains black pictures.

use crate::primitive::InvisibleReasons;

/// The most primitives whose reason is recorded.
const MAX_REASONS: usize = 64;

/// Whether any primitive of some draws covers a sample, before tests and blending.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Visibility {
    /// The draws have no primitives.
    #[default]
    NothingDrawn,
    /// No primitive covers a sample; the reasons of the first 64.
    Invisible(InvisibleReasons),
    /// Some primitive covers a sample.
    Visible,
}

impl Visibility {
    /// How many more reasons are recorded.
    pub(super) fn reasons_left(&self) -> u32 {
        let left = match self {
            Self::NothingDrawn => MAX_REASONS,
            Self::Invisible(reasons) => MAX_REASONS.saturating_sub(reasons.len()),
            Self::Visible => 0,
        };
        left as u32
    }

    /// Adds later draws. The result does not depend on how draws are divided into submissions.
    pub fn add(&mut self, later: Self) {
        match (&mut *self, later) {
            (Self::Visible, _) | (_, Self::NothingDrawn) => {}
            (Self::NothingDrawn | Self::Invisible(_), Self::Visible) => *self = Self::Visible,
            (Self::NothingDrawn, Self::Invisible(reasons)) => *self = Self::Invisible(reasons),
            (Self::Invisible(reasons), Self::Invisible(others)) => {
                reasons.extend(others);
                reasons.truncate(MAX_REASONS);
            }
        }
    }
}
