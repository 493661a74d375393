//! Whether anything of what is drawn may be seen, and why not: what to ask of a black picture.

use crate::primitive::Reasons;

/// So many primitives are asked why they are not seen.
const ASKED: usize = 64;

/// Whether anything of some draws may be seen: whether it covers any sample, before tests and blending.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Sight {
    /// There were no primitives.
    #[default]
    Undrawn,
    /// Nothing is, and this is why, of the first 64 primitives.
    None(Reasons),
    /// Something is.
    Some,
}

impl Sight {
    /// How many more primitives are to be asked why they are not seen.
    pub(super) fn asks(&self) -> u32 {
        let left = match self {
            Self::Undrawn => ASKED,
            Self::None(reasons) => ASKED.saturating_sub(reasons.len()),
            Self::Some => 0,
        };
        left as u32
    }

    /// Adds what was drawn after this. Into how many submissions draws are divided makes no difference.
    pub fn add(&mut self, later: Self) {
        match (&mut *self, later) {
            (Self::Some, _) | (_, Self::Undrawn) => {}
            (Self::Undrawn | Self::None(_), Self::Some) => *self = Self::Some,
            (Self::Undrawn, Self::None(reasons)) => *self = Self::None(reasons),
            (Self::None(reasons), Self::None(others)) => {
                reasons.extend(others);
                reasons.truncate(ASKED);
            }
        }
    }
}
