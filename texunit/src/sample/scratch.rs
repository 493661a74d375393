//! Scratch of a lookup, part of which the next lookup may reuse.

use super::fast::{Addresses, TexelQuad};
use super::row_scan::RoundQuad;
use super::uniform_levels::UniformLevels;
use crate::lanes::F32s;

/// Result and scratch of a lookup. The next lookup may reuse texel addresses and levels ([`Addresses::Reuse`]).
#[derive(Clone, Debug, Default)]
pub struct LookupScratch {
    /// The result: red, green, blue and alpha. A fused lookup writes it only where the fast path does not apply.
    pub lanes: [F32s; 4],
    pub(crate) quads: QuadScratch,
    pub(crate) levels: LevelScratch,
}

/// The texel quads of one level, or of two.
#[derive(Clone, Debug, Default)]
pub(crate) struct QuadScratch {
    pub levels: [TexelQuad; 2],
    /// Those of scanned footprints.
    pub round: [RoundQuad; 2],
    /// Whether all quads of the last lookup were [`QuadLoad::Inside`](super::fast::QuadLoad::Inside).
    pub is_inside: bool,
}

/// The level of detail of a fused lookup, selected before it.
#[derive(Clone, Copy, Debug)]
pub struct SelectedLevels<'a> {
    /// The levels, if all lanes read the same.
    pub levels: Option<UniformLevels>,
    /// The weight of the second level.
    pub weight: &'a F32s,
    /// Whether texel addresses are computed or reused.
    pub addresses: Addresses,
}

/// The levels of the last lookup.
#[derive(Clone, Debug, Default)]
pub(crate) struct LevelScratch {
    pub levels: Option<UniformLevels>,
    /// The weight of the second level.
    pub weight: F32s,
}
