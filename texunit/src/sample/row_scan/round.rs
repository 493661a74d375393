//! Round footprints, which are filtered as isotropic ones: EXT_texture_filter_anisotropic takes the sample of the isotropic
//! filter where the axes have the ratio 1.

use super::footprint::{LaneFootprint, RowScan};
use crate::lanes::{LANES, U32s};
use crate::sample::level_view::LevelView;

/// The largest slope that moves no position: a quarter of its unit.
const NO_SLOPE: f32 = 1.0 / (1 << 18) as f32;
/// The largest `a²` that makes no row longer: the root of 1 more than it is an eighth of a weight's unit above 1.
const NO_EXCESS: f32 = 1.0 / (1 << 16) as f32;

/// Slopes on a level that move no position, by the axis that is scanned, compared without a division.
#[derive(Clone, Copy)]
struct LevelSlopes([[f32; 2]; 2]);

impl LevelSlopes {
    #[inline(always)]
    fn new(view: &LevelView<'_>) -> Self {
        let base = view.texture.scale;
        let [s, t] = [0, 1].map(|axis| view.axis(axis).scale);
        let [along_t, along_s] = [[s * base[1], t * base[0]], [t * base[0], s * base[1]]];
        Self([along_s, along_t])
    }

    /// Whether the rows of a footprint are one texel long, without slope and without least weight: the numbers that
    /// [`super::rows::Rows`] would compute round to these. No level has more texels than the base level, which bounds the
    /// length; the first row is less than one from the middle, so that its shift is at most the slope.
    #[inline(always)]
    fn is_round(self, excess: f32, min_weight: i32, slope: f32, along_t: u32) -> bool {
        let Self([[more_s, less_s], [more_t, less_t]]) = self;
        let (more, less) = if along_t != 0 { (more_t, less_t) } else { (more_s, less_s) };
        (excess <= NO_EXCESS) & (min_weight == 0) & (slope.abs() * more <= NO_SLOPE * less)
    }
}

/// Whether a footprint is round on a level.
#[inline(always)]
pub fn is_round(view: &LevelView<'_>, of: &LaneFootprint) -> bool {
    let along_t = if of.along_t { !0 } else { 0 };
    LevelSlopes::new(view).is_round(of.excess, of.min_weight, of.slope, along_t)
}

/// The lanes whose footprints are round on a level.
#[inline(always)]
pub fn round_lanes(view: &LevelView<'_>, scan: &RowScan) -> U32s {
    let slopes = LevelSlopes::new(view);
    let mut round = U32s::ZERO;
    for lane in 0..LANES {
        let (excess, min_weight) = (scan.excess[lane], scan.min_weight[lane]);
        let is_round = slopes.is_round(excess, min_weight, scan.slope[lane], scan.along_t[lane]);
        round[lane] = if is_round { !0 } else { 0 };
    }
    round
}
