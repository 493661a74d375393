//! The anisotropic filter: `N` probes along the major axis of the footprint.
//!
//! EXT_texture_filter_anisotropic leaves the scheme to the implementation. DetGL's: with the
//! singular values `σ₁ ≥ σ₂` of `J = (∂(u,v)/∂x, ∂(u,v)/∂y)`, `N = min(⌈σ₁/σ₂ - 1/64⌉, limit)`
//! probes, each with `λ = log2 m` of `m = max(σ₂, σ₁/N)`, `g = √((σ₁² - m²)/(N² - 1))` texels apart
//! and weighted alike: the second moment of the row is that of the pixel's footprint, `σ₁²/12`.

use super::lod::Derivatives;
use super::sample::{self, Sampler};
use super::texture::Level;
use crate::mutation::{Mutation, Variant};

/// The probes of a footprint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probes {
    /// How many.
    pub count: usize,
    /// λ of each.
    pub lambda: f64,
    /// From one to the next, in (s, t).
    pub step: [f64; 2],
    /// `σ₁/σ₂`.
    pub ratio: f64,
}

/// The probes of a footprint on a base level of this size.
pub fn probes(d: &Derivatives, size: [usize; 2], limit: f64, variant: Variant) -> Probes {
    let texels = |v: [f64; 2]| [v[0] * size[0] as f64, v[1] * size[1] as f64];
    let (x, y) = (texels(d.dx), texels(d.dy));
    // The metric JᵀJ and its eigenvalues.
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let (xx, xy, yy) = (dot(x, x), dot(x, y), dot(y, y));
    let root = (((xx - yy) / 2.0).powi(2) + xy * xy).sqrt();
    let major = ((xx + yy) / 2.0 + root).sqrt();
    let minor = ((xx + yy) / 2.0 - root).max(0.0).sqrt();
    let ratio = major / minor;
    if ratio <= 1.0 + 1.0 / 64.0 || variant.has(Mutation::AnisotropyIgnored) {
        return Probes { count: 1, lambda: major.log2(), step: [0.0; 2], ratio };
    }
    let limit = if variant.has(Mutation::AnisotropyUnlimited) { 16.0 } else { limit };
    let n = (ratio - 1.0 / 64.0).ceil().clamp(2.0, limit);
    let m = minor.max(major / n);
    // The unit vector of the pixel that is stretched the most.
    let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
    let along = if variant.has(Mutation::AnisotropyAcross) {
        [-angle.sin(), angle.cos()]
    } else {
        [angle.cos(), angle.sin()]
    };
    let gap = if variant.has(Mutation::ProbesTouch) {
        major / n / major
    } else {
        ((1.0 - (m / major).powi(2)) / (n * n - 1.0)).sqrt()
    };
    let step = [0, 1].map(|c| gap * (d.dx[c] * along[0] + d.dy[c] * along[1]));
    let lambda = if variant.has(Mutation::LambdaOfMajor) { major.log2() } else { m.log2() };
    Probes { count: n as usize, lambda, step, ratio }
}

/// The mean of the probes.
pub fn sample(
    image: &[Level],
    sampler: &Sampler,
    st: [f64; 2],
    probes: &Probes,
    variant: Variant,
) -> [f64; 4] {
    let mut sum = [0.0; 4];
    for k in 0..probes.count {
        let at = k as f64 - (probes.count - 1) as f64 / 2.0;
        let st = [0, 1].map(|c| st[c] + at * probes.step[c]);
        let probe = sample::at_lambda(image, sampler, st, probes.lambda, variant);
        for (sum, c) in sum.iter_mut().zip(probe) {
            *sum += c / probes.count as f64;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_of_touching_boxes() {
        let d = Derivatives { dx: [4.0 / 64.0, 0.0], dy: [0.0, 1.0 / 64.0] };
        let probes = probes(&d, [64, 64], 16.0, Variant::TRUE);
        assert_eq!((probes.count, probes.lambda), (4, 0.0));
        assert!((probes.step[0] * 64.0 - 1.0).abs() < 1e-12 && probes.step[1].abs() < 1e-12);
    }
}
