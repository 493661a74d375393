//! Scratch of a lookup, part of which the next lookup may reuse.

use super::fast::{Addresses, TexelQuad};
use super::uniform_levels::UniformLevels;
use crate::lanes::{F32s, U32s};

/// The most axes of lookups whose texels are kept for other lookups.
pub const KEPT_AXES: usize = 16;

/// Whether the texels of a lookup along an axis are computed, kept for other lookups, or reused from one. Only nearest
/// lookups of which all but the coordinates is known before keep and reuse them ([`crate::plan::SamplePlan::sample_registers`]).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AxisTexels {
    /// Computed.
    #[default]
    Compute,
    /// Computed, and kept under this number, below [`KEPT_AXES`].
    Keep(u8),
    /// Those that were kept under this number: by a lookup with the same plan and the same coordinate along the axis.
    Reuse(u8),
}

/// Result and scratch of a lookup. The next lookup may reuse texel addresses and levels ([`Addresses::Reuse`]).
#[derive(Clone, Debug, Default)]
pub struct LookupScratch {
    /// The result: red, green, blue and alpha. A fused lookup writes it only where the fast path does not apply.
    pub lanes: [F32s; 4],
    pub(crate) quads: QuadScratch,
    pub(crate) levels: LevelScratch,
    pub(crate) axes: KeptAxes,
}

/// The texels along axes, by the numbers of [`AxisTexels`].
#[derive(Clone, Debug)]
pub(crate) struct KeptAxes(pub [TexelSpan; KEPT_AXES]);

/// Texels along an axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TexelSpan {
    /// How far each lane's is from the first.
    pub texels: U32s,
    /// The first one, of the lanes at the corners of a batch.
    pub first: u32,
    /// The largest of `texels`: beyond the size if a lane's comes before the first.
    pub last: u32,
}

impl Default for KeptAxes {
    fn default() -> Self {
        Self([TexelSpan { texels: U32s::ZERO, first: 0, last: 0 }; KEPT_AXES])
    }
}

/// The texel quads of one level, or of two.
#[derive(Clone, Debug, Default)]
pub(crate) struct QuadScratch {
    pub levels: [TexelQuad; 2],
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
