//! The footprint of a row scan: λ, direction and slope.

use super::fixed_point::to_fixed;
use crate::lanes::math::max;
use crate::lanes::{F32s, I32s, LANES, U32s, WEIGHT_ONE, log2_of_root};
use crate::sample::derivatives::Derivatives;
use crate::sample::recorder::Recorder;
use crate::trace::SampleStep;

/// The scan direction of each lane, for all levels.
pub struct RowScan {
    /// `!0` where rows are crossed, 0 where columns.
    pub along_t: U32s,
    /// `a²`, in texels of the base level.
    pub excess: F32s,
    /// Texels across per texel along.
    pub slope: F32s,
    /// `b`, in units of 2^-14.
    pub min_weight: I32s,
}

/// A larger squared axis counts as no footprint.
const MAX_MAJOR: f32 = 1e18;
/// A smaller squared axis counts as a point.
const MIN_MAJOR: f32 = 1e-18;

/// λ of each lane and how it crosses the texels. `scale` is texels per unit of each coordinate, `most`
/// the largest ratio of the axes that is followed.
#[inline(always)]
pub fn footprint(
    d: &Derivatives<'_>,
    scale: [f32; 3],
    most: f32,
    recorder: &mut impl Recorder,
) -> (F32s, RowScan) {
    let mut lambda = F32s::ZERO;
    let mut scan = RowScan {
        along_t: U32s::ZERO,
        excess: F32s::ZERO,
        slope: F32s::ZERO,
        min_weight: I32s::ZERO,
    };
    let (mut majors, mut minors) = (F32s::ZERO, F32s::ZERO);
    let share = 1.0 / (most * most);
    for lane in 0..LANES {
        let u = [d.dx[0][lane] * scale[0], d.dy[0][lane] * scale[0]];
        let v = [d.dx[1][lane] * scale[1], d.dy[1][lane] * scale[1]];
        let of = LaneFootprint::new(u, v, share);
        lambda[lane] = of.lambda;
        scan.along_t[lane] = if of.along_t { !0 } else { 0 };
        scan.excess[lane] = of.excess;
        scan.slope[lane] = of.slope;
        scan.min_weight[lane] = of.min_weight;
        majors[lane] = of.major;
        minors[lane] = of.minor;
    }
    recorder.record(|lane| SampleStep::Scan {
        major_squared: majors[lane],
        minor_squared: minors[lane],
        along: if scan.along_t[lane] != 0 { 1 } else { 0 },
        slope: scan.slope[lane],
        lambda: lambda[lane],
    });
    (lambda, scan)
}

/// The footprint of one lane.
pub struct LaneFootprint {
    pub lambda: f32,
    /// Whether rows are crossed.
    pub along_t: bool,
    /// See [`RowScan`].
    pub excess: f32,
    pub slope: f32,
    pub min_weight: i32,
    /// `σ₁²` and `σ₂²`.
    major: f32,
    minor: f32,
}

impl LaneFootprint {
    /// From the derivatives along x and y in texels; `share` is `1 / A²`.
    #[inline(always)]
    pub fn new([ux, uy]: [f32; 2], [vx, vy]: [f32; 2], share: f32) -> Self {
        let (uu, uv, vv) = (ux * ux + uy * uy, ux * vx + uy * vy, vx * vx + vy * vy);
        let half = 0.5 * (uu + vv);
        let difference = 0.5 * (vv - uu);
        let root = (difference * difference + uv * uv).sqrt();
        // Of larger ones the root leaves the range, and would be infinite or NaN.
        let major = if half < MAX_MAJOR { half + root } else { half };
        let minor = max(half - root, 0.0);
        let width = max(minor, major * share);
        let longer = major - width;
        // False for NaN, of empty and infinite footprints.
        let is_long = (longer > 0.0) & (major > MIN_MAJOR) & (major < MAX_MAJOR);
        let reciprocal = 1.0 / ((root + root) * major);
        let part = longer * (major * reciprocal);
        let along = part * (root + difference.abs());
        let slope = part * uv / (max(width, 1.0) + along);
        let elongation = longer * ((root + root) * reciprocal);
        let squared = width + elongation * (1.0 - 0.5625 * width);
        let slope = if is_long { slope } else { 0.0 };
        let min_weight = 0.4375 * slope * slope * (if width < 1.0 { width } else { 1.0 });
        Self {
            lambda: log2_of_root(if is_long { squared } else { major }),
            along_t: difference > 0.0,
            excess: if is_long { along } else { 0.0 },
            slope,
            min_weight: to_fixed(min_weight, WEIGHT_ONE),
            major,
            minor,
        }
    }
}
