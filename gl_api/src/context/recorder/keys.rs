//! The keys of the fixed-function stages: which state changes their code, and how.

use crate::generate::fixed::vertex::Generated;
use crate::interface::*;

/// What draws have found out about the texture units, while these stay as they are.
#[derive(Debug, Default)]
pub(crate) struct UnitsSeen {
    /// Of the units; 0 before the first.
    pub version: u64,
    /// Those that texture, if their texture is complete, bit by unit.
    pub enabled: u8,
    pub generated: [[Option<Generated>; 4]; MAX_TEXTURE_UNITS as usize],
}
