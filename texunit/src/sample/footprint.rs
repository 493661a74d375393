//! The footprint of a pixel on the texture: λ, and the probes of an anisotropic filter.
//!
//! With the Jacobian `J = (∂(u, v, w)/∂x, ∂(u, v, w)/∂y)` in texels of the base level, a pixel's
//! square has the parallelogram `J` as its footprint, whose second moments are `J·Jᵀ / 12`. Its
//! axes `σ₁ ≥ σ₂` are the singular values of `J`, from the metric `JᵀJ` (Heckbert's ellipse).
//!
//! *Isotropic* (GL 2.1, equation 3.20): `ρ² = max(|∂/∂x|², |∂/∂y|²)`.
//!
//! *Anisotropic* (EXT_texture_filter_anisotropic leaves the scheme open): two-dimensional images use a
//! row scan ([`super::row_scan`]); other shapes and wrap modes take `N` probes in a row along
//! the major axis, `N = min(⌈σ₁/σ₂ - 1/64⌉, max)`, each filtered for a width of
//! `m = max(σ₂, σ₁/N)`, so that `λ = log2 m`. They lie `g = √((σ₁² - m²) / (N² - 1))` apart, the one
//! distance at which `N` boxes of width `m` have the second moment `σ₁²/12` of the parallelogram
//! itself: where `σ₁ = N·m` the boxes touch, and as `σ₁` falls to `m` they close up, so that
//! the result is continuous where `N` changes. All probes have the same weight, as in the area integral. Each
//! probe is an ordinary sample with the levels of λ; on a cube, of the face that it lies on.

use super::derivatives::{Derivatives, rho_squared};
use super::recorder::Recorder;
use super::row_scan::RowScan;
use crate::lanes::math::{clamp, max};
use crate::lanes::{F32s, LANES, Simd, U32s, log2_of_root};
use crate::trace::SampleStep;

/// How the footprints of a batch are filtered.
pub enum Footprint {
    /// Isotropic: one sample.
    Isotropic,
    /// With probes along the major axis.
    Probes(Probes),
    /// With a row scan.
    Scan(RowScan),
}

/// The footprints that a kernel is compiled for.
pub trait FootprintSet: Copy {
    /// [`Footprint::Isotropic`], and each probe.
    const ISOTROPIC: bool;
    /// [`Footprint::Probes`].
    const PROBES: bool;
    /// [`Footprint::Scan`].
    const SCANS: bool;
}

/// Isotropic footprints.
#[derive(Clone, Copy)]
pub struct IsotropicOnly;
impl FootprintSet for IsotropicOnly {
    const ISOTROPIC: bool = true;
    const PROBES: bool = false;
    const SCANS: bool = false;
}

/// Isotropic footprints, and probes.
#[derive(Clone, Copy)]
pub struct IsotropicAndProbes;
impl FootprintSet for IsotropicAndProbes {
    const ISOTROPIC: bool = true;
    const PROBES: bool = true;
    const SCANS: bool = false;
}

/// Row scans.
#[derive(Clone, Copy)]
pub struct RowScans;
impl FootprintSet for RowScans {
    const ISOTROPIC: bool = false;
    const PROBES: bool = false;
    const SCANS: bool = true;
}

/// All footprints: for traces and the baseline.
#[derive(Clone, Copy)]
pub struct AllFootprints;
impl FootprintSet for AllFootprints {
    const ISOTROPIC: bool = true;
    const PROBES: bool = true;
    const SCANS: bool = true;
}

/// The probes of a batch.
pub struct Probes {
    /// The largest number of probes of a lane.
    pub max_count: u32,
    /// The number of probes of each lane, at least 1.
    pub count: F32s,
    /// From one probe to the next, per axis, in units of the coordinate.
    pub step: [F32s; 3],
}

/// `JᵀJ`: the squares of both derivatives and their product.
struct Metric {
    xx: F32s,
    xy: F32s,
    yy: F32s,
}

#[inline(always)]
fn metric(d: &Derivatives<'_>, axes: usize, scale: [f32; 3]) -> Metric {
    let mut out = Metric { xx: F32s::ZERO, xy: F32s::ZERO, yy: F32s::ZERO };
    for (axis, scale) in scale.into_iter().enumerate().take(axes) {
        for lane in 0..LANES {
            let x = d.dx[axis][lane] * scale;
            let y = d.dy[axis][lane] * scale;
            out.xx[lane] += x * x;
            out.xy[lane] += x * y;
            out.yy[lane] += y * y;
        }
    }
    out
}

/// λ of one probe for the whole footprint. `scale` is texels per unit of each coordinate.
#[inline(always)]
pub fn isotropic(
    d: &Derivatives<'_>,
    axes: usize,
    scale: [f32; 3],
    recorder: &mut impl Recorder,
) -> F32s {
    let mut lambda = F32s::ZERO;
    if axes == 2 {
        for lane in 0..LANES {
            lambda[lane] = log2_of_root(rho_squared(d, scale, lane));
        }
        recorder.record(|lane| SampleStep::Isotropic {
            rho_squared: rho_squared(d, scale, lane),
            lambda: lambda[lane],
        });
        return lambda;
    }
    let metric = metric(d, axes, scale);
    for lane in 0..LANES {
        lambda[lane] = log2_of_root(max(metric.xx[lane], metric.yy[lane]));
    }
    recorder.record(|lane| SampleStep::Isotropic {
        rho_squared: max(metric.xx[lane], metric.yy[lane]),
        lambda: lambda[lane],
    });
    lambda
}

/// λ of each probe, and the probes, if any lane has more than one.
#[inline(always)]
pub fn anisotropic<S: Simd>(
    d: &Derivatives<'_>,
    axes: usize,
    scale: [f32; 3],
    max_probes: f32,
    recorder: &mut impl Recorder,
) -> (F32s, Option<Probes>) {
    let Metric { xx, xy, yy } = metric(d, axes, scale);
    // The squares of σ₁ and σ₂, and of the width that each probe is filtered for.
    let mut major = F32s::ZERO;
    let mut minor = F32s::ZERO;
    let mut root = F32s::ZERO;
    let mut elongated = U32s::ZERO;
    for lane in 0..LANES {
        let half = 0.5 * (xx[lane] + yy[lane]);
        let difference = 0.5 * (xx[lane] - yy[lane]);
        root[lane] = (difference * difference + xy[lane] * xy[lane]).sqrt();
        // Of larger ones the root leaves the range: they are round, and as good as infinite.
        let fits = half < MAX_MAJOR;
        major[lane] = if fits { half + root[lane] } else { half };
        minor[lane] = if fits { max(half - root[lane], 0.0) } else { half };
        let stretched = major[lane] > minor[lane] * (ISOTROPIC_RATIO * ISOTROPIC_RATIO);
        elongated[lane] = if stretched { !0 } else { 0 };
    }
    let mut width = major;
    let mut probes = None;
    if S::any(&elongated) {
        let mut count = F32s::ZERO;
        let (mut x, mut y) = (F32s::ZERO, F32s::ZERO);
        for lane in 0..LANES {
            let (major, minor) = (major[lane], minor[lane]);
            // False for NaN, of empty and infinite footprints.
            let stretched = elongated[lane] != 0;
            let ratio = (major / minor).sqrt();
            let n = clamp(S::ceil(ratio - (ISOTROPIC_RATIO - 1.0)), 2.0, max_probes);
            let wide = max(minor, major / (n * n));
            width[lane] = if stretched { wide } else { major };
            count[lane] = if stretched { n } else { 1.0 };

            // The major axis is (1, slope) or (slope, 1) in the pixel's x and y.
            let difference = 0.5 * (xx[lane] - yy[lane]);
            let slope = xy[lane] / (difference.abs() + root[lane]);
            let along = (1.0 - wide / major) / ((n * n - 1.0) * (1.0 + slope * slope));
            let along = if stretched { max(along, 0.0).sqrt() } else { 0.0 };
            let across = if stretched { along * slope } else { 0.0 };
            let steep = difference < 0.0;
            x[lane] = if steep { across } else { along };
            y[lane] = if steep { along } else { across };
        }
        let mut step = [F32s::ZERO; 3];
        for (axis, step) in step.iter_mut().enumerate().take(axes) {
            for lane in 0..LANES {
                let moved = d.dx[axis][lane] * x[lane] + d.dy[axis][lane] * y[lane];
                step[lane] = if count[lane] > 1.0 { moved } else { 0.0 };
            }
        }
        // The bits of positive floats are ordered as the numbers.
        let max_count = f32::from_bits(S::largest(count.as_u32())) as u32;
        probes = Some(Probes { max_count, count, step });
    }
    let mut lambda = F32s::ZERO;
    for lane in 0..LANES {
        lambda[lane] = log2_of_root(width[lane]);
    }
    recorder.record(|lane| {
        let of = |probes: &Probes| (probes.count[lane] as u32, probes.step.map(|step| step[lane]));
        let (probes, step) = probes.as_ref().map_or((1, [0.0; 3]), of);
        SampleStep::Anisotropic {
            major_squared: major[lane],
            minor_squared: minor[lane],
            probes,
            step,
            lambda: lambda[lane],
        }
    });
    (lambda, probes)
}

/// A larger squared axis is beyond any level.
const MAX_MAJOR: f32 = 1e18;

/// Up to this ratio of the axes a footprint is isotropic: rounding alone must not cost a probe.
const ISOTROPIC_RATIO: f32 = 1.0 + 1.0 / 64.0;
