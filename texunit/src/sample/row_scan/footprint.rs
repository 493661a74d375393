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
        let (ux, uy) = (d.dx[0][lane] * scale[0], d.dy[0][lane] * scale[0]);
        let (vx, vy) = (d.dx[1][lane] * scale[1], d.dy[1][lane] * scale[1]);
        let (uu, uv, vv) = (ux * ux + uy * uy, ux * vx + uy * vy, vx * vx + vy * vy);
        let half = 0.5 * (uu + vv);
        let difference = 0.5 * (vv - uu);
        let root = (difference * difference + uv * uv).sqrt();
        let (major, minor) = (half + root, max(half - root, 0.0));
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
        lambda[lane] = log2_of_root(if is_long { squared } else { major });
        scan.along_t[lane] = if difference > 0.0 { !0 } else { 0 };
        scan.excess[lane] = if is_long { along } else { 0.0 };
        scan.slope[lane] = slope;
        scan.min_weight[lane] = to_fixed(min_weight, WEIGHT_ONE);
        majors[lane] = major;
        minors[lane] = minor;
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
