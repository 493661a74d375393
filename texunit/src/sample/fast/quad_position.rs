//! Positions of the 2×2 texels of a linear filter, edges included.

use super::offsets::add_offsets;
use crate::lanes::{F32s, I32s, LANES, Simd, U32s};
use crate::sample::fetch::side_by_side;
use crate::sample::level_view::LevelView;
use crate::sample::wrap::{Axis, lower_and_weight};
use crate::sampler::{Filter, Seamless, Wrap};

/// The positions of the texel quads of a batch.
pub struct QuadPosition {
    /// The axes of s and t.
    pub axes: [Axis; 2],
    /// Column and row of the lower left texel; -1 is beyond the edge.
    pub first: [I32s; 2],
    /// The weights of the right and of the upper texels.
    pub weights: [F32s; 2],
    /// Whether both columns, and both rows, lie inside the level.
    pub pairs: [PairPosition; 2],
}

/// The indices of the two texels along an axis.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum PairPosition {
    /// Inside the level in every lane.
    Inside,
    /// Across an edge in some lane.
    AcrossEdge,
}

impl PairPosition {
    /// Of texels `i` and `i + 1`.
    #[inline(always)]
    fn of<S: Simd>(i: &I32s, size: u32) -> Self {
        if side_by_side::<S>(i, size) { Self::Inside } else { Self::AcrossEdge }
    }
}

impl QuadPosition {
    /// Byte offsets of the four texels.
    #[inline(always)]
    pub fn corners(&self, view: &LevelView<'_>) -> [U32s; 4] {
        let Self { axes: [s, t], first: [i, j], pairs, .. } = self;
        let level = view.level;
        let xs = pair_offsets(s, i, pairs[0], level.format.bytes() as u32, level.origin() as u32);
        let ys = pair_offsets(t, j, pairs[1], level.row_bytes() as u32, 0);
        [
            add_offsets(&xs[0], &ys[0]),
            add_offsets(&xs[1], &ys[0]),
            add_offsets(&xs[0], &ys[1]),
            add_offsets(&xs[1], &ys[1]),
        ]
    }
}

/// Computes the positions; `None` where the border or another face is read.
#[inline(always)]
pub fn quad_position<S: Simd>(view: &LevelView<'_>, at: [&F32s; 3]) -> Option<QuadPosition> {
    let axes = [view.axis(0), view.axis(1)];
    let (i, alpha) = lower_and_weight::<S>(&axes[0].texel_coordinate::<S>(at[0]));
    let (j, beta) = lower_and_weight::<S>(&axes[1].texel_coordinate::<S>(at[1]));
    let pairs = [PairPosition::of::<S>(&i, axes[0].size), PairPosition::of::<S>(&j, axes[1].size)];
    let seamless = view.texture.seamless == Seamless::On;
    for (axis, pairs) in axes.iter().zip(pairs) {
        let is_over = pairs == PairPosition::AcrossEdge;
        if is_over && (seamless || axis.wrap.reaches_border(Filter::Linear)) {
            return None;
        }
    }
    Some(QuadPosition { axes, first: [i, j], weights: [alpha, beta], pairs })
}

/// The byte offsets of the lower and the upper texel along one axis, `stride` bytes apart.
#[inline(always)]
pub fn pair_offsets(
    axis: &Axis,
    i: &I32s,
    pairs: PairPosition,
    stride: u32,
    origin: u32,
) -> [U32s; 2] {
    let mut low = U32s::ZERO;
    let mut high = U32s::ZERO;
    if pairs == PairPosition::Inside {
        for lane in 0..LANES {
            let at = (i[lane] as u32).wrapping_mul(stride).wrapping_add(origin);
            low[lane] = at;
            high[lane] = at.wrapping_add(stride);
        }
        return [low, high];
    }
    let last = axis.size as i32 - 1;
    let (below, above) = if axis.wrap == Wrap::Repeat { (last, 0) } else { (0, last) };
    for lane in 0..LANES {
        let lower = if i[lane] < 0 { below } else { i[lane] } as u32;
        let upper = if i[lane] < last { i[lane] + 1 } else { above } as u32;
        low[lane] = lower.wrapping_mul(stride).wrapping_add(origin);
        high[lane] = upper.wrapping_mul(stride).wrapping_add(origin);
    }
    [low, high]
}
