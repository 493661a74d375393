//! The anisotropic filter of images in a plane: the footprint is read row by row.
//!
//! EXT_texture_filter_anisotropic leaves the scheme open. Its usual one, several filtered samples
//! in a row, reads most texels twice and more. This one walks the rows that the footprint crosses
//! (columns, where it lies rather along s) and takes from each one pair of neighbours, so that
//! every texel is read once and the sum along the footprint is the exact one of whole texels.
//!
//! With the derivatives in texels of the base level, the footprint has the second moments
//! `C = J·Jᵀ` (over 12), of eigenvalues `σ₁² ≥ σ₂²`. A sample is filtered for a width of
//! `m² = max(σ₂², σ₁²/A²)`, where `A` is `TEXTURE_MAX_ANISOTROPY`; what the footprint is longer than
//! wide, `κ (C - σ₂² I)` with `κ = (σ₁² - m²) / (σ₁² - σ₂²)`, the rows make up for. With the moments
//! `a²` of that along the axis with the larger one, and `c` between both axes:
//!
//! - *Length.* On a level whose texels are `x` of the base's, `L = √(1 + a²/x²)` rows, at most
//!   [`LONGEST`], each weighted by how much of it lies within `L/2` of the sample. A round footprint
//!   has `L = 1`, and these weights are those of a bilinear filter.
//! - *Slope.* From row to row the place moves by `c / (max(m², 1) + a²)`.
//! - *Across.* The two texels about the place weigh `1 - w` and `w` with `w = b + (1 - 2b)·α` of the
//!   place's fraction `α`: `b = 7/16 slope² min(m², 1)` evens the weights out where the rows are
//!   crossed at an angle, as the pair is then narrower, measured across the footprint, than a pair
//!   of a level should be. (Where pixels are nearer to one another than texels, no step may show.)
//! - *Level.* `λ = ½ log2(m² + ε (1 - 9/16 m²))` with the elongation `ε = 1 - m²/σ₁²`: a pair of
//!   texels is as wide as 3/2 of them, so a long footprint takes levels a little finer than a round
//!   one, for which `λ = log2 σ₁`.
//!
//! `conformance/src/oracle/anisotropy.rs` has the same in `f64`. Places and weights are integers
//! ([`rows`]), and of formats of bytes so are the sums: exact, whatever the order.

mod read;
mod rows;

pub use read::level;

use super::footprint::Derivatives;
use super::record::Recorder;
use crate::lanes::math::max;
use crate::lanes::{F32s, I32s, LANES, ONE, U32s, log2_of_root};
use crate::trace::SampleStep;

/// The most rows of a level; only levels finer than λ asks for would have more.
pub const LONGEST: f32 = 48.0;

/// How the lanes of a batch cross the texels, whatever the level.
pub struct Scan {
    /// `!0` where rows are crossed, 0 where columns.
    pub along_t: U32s,
    /// `a²`, in texels of the base level.
    pub excess: F32s,
    /// Texels across per texel along.
    pub slope: F32s,
    /// `b`, in units of 2^-14.
    pub even: I32s,
}

/// Axes whose square is larger are no footprint.
const LARGEST: f32 = 1e18;
/// Axes whose square is smaller are a point.
const SMALLEST: f32 = 1e-18;

/// λ of each lane and how it crosses the texels. `scale` is texels per unit of each coordinate, `most`
/// the largest ratio of the axes that is followed.
#[inline(always)]
pub fn footprint(
    d: &Derivatives<'_>,
    scale: [f32; 3],
    most: f32,
    recorder: &mut impl Recorder,
) -> (F32s, Scan) {
    let mut lambda = F32s::ZERO;
    let mut scan =
        Scan { along_t: U32s::ZERO, excess: F32s::ZERO, slope: F32s::ZERO, even: I32s::ZERO };
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
        // Not where NaN comes from no footprint or an infinite one.
        let is_long = (longer > 0.0) & (major > SMALLEST) & (major < LARGEST);
        let reciprocal = 1.0 / ((root + root) * major);
        let part = longer * (major * reciprocal);
        let along = part * (root + difference.abs());
        let slope = part * uv / (max(width, 1.0) + along);
        let elongation = longer * ((root + root) * reciprocal);
        let squared = width + elongation * (1.0 - 0.5625 * width);
        let slope = if is_long { slope } else { 0.0 };
        let even = 0.4375 * slope * slope * (if width < 1.0 { width } else { 1.0 });
        lambda[lane] = log2_of_root(if is_long { squared } else { major });
        scan.along_t[lane] = if difference > 0.0 { !0 } else { 0 };
        scan.excess[lane] = if is_long { along } else { 0.0 };
        scan.slope[lane] = slope;
        scan.even[lane] = rows::to_fixed(even, ONE);
        majors[lane] = major;
        minors[lane] = minor;
    }
    recorder.note(|lane| SampleStep::Scan {
        major_squared: majors[lane],
        minor_squared: minors[lane],
        along: if scan.along_t[lane] != 0 { 1 } else { 0 },
        slope: scan.slope[lane],
        lambda: lambda[lane],
    });
    (lambda, scan)
}
