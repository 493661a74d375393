//! Scratch of a lookup, and what one lookup may hand to the next.

use super::fast::{Places, TexelQuad};
use super::uniform_levels::Read;
use crate::lanes::F32s;

/// What a lookup needs room for, and what the next one may keep of it ([`Places::Kept`]).
#[derive(Clone, Debug, Default)]
pub struct Room {
    /// What a lookup gave: red, green, blue and alpha. Of one that is taken, only where the short way does not lead.
    pub lanes: [F32s; 4],
    pub(crate) squares: QuadScratch,
    pub(crate) detail: LevelScratch,
}

/// The texels of one level, or of two.
#[derive(Clone, Debug, Default)]
pub(crate) struct QuadScratch {
    pub levels: [TexelQuad; 2],
    /// Whether all of those of the last lookup were [`QuadLoad::Inside`].
    pub inside: bool,
}

/// What is known of a lookup that is taken.
#[derive(Clone, Copy, Debug)]
pub struct Known<'a> {
    /// What all lanes read, if that is the same.
    pub read: Option<Read>,
    /// Of the second level.
    pub weight: &'a F32s,
    /// Who looks for its texels.
    pub places: Places,
}

/// What the level of detail of a lookup comes to.
#[derive(Clone, Debug, Default)]
pub(crate) struct LevelScratch {
    pub read: Option<Read>,
    /// Of the second level.
    pub weight: F32s,
}
