//! The anisotropic filter of probes in a row, for images that are not plane.
//!
//! EXT_texture_filter_anisotropic leaves the scheme to the implementation, and gives one of N probes along the line of
//! anisotropy. DetGL's: the pixel's footprint is the parallelogram of the columns of the Jacobian J, in texels, which has the
//! second moments J·Jᵀ/12 along axes `σ₁ ≥ σ₂` (the singular values). Up to `σ₁/σ₂ = 1 + 1/64` there is one probe, for `σ₁`;
//! else `N = ⌈σ₁/σ₂ - 1/64⌉`, at most the limit, each filtered for a width of `m = max(σ₂, σ₁/N)`. They lie evenly about the
//! sample's place along the longer axis, as far apart as makes the second moment of N boxes of width m along it that of
//! the footprint: a row of N points g apart has the moment `g² (N² - 1)/12`, and so `g² (N² - 1) + m² = σ₁²`.

use crate::mutation::{Mutation, Variant};

/// A row of probes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// How many.
    pub count: usize,
    /// From one to the next, in texels of the base level.
    pub step: [f64; 3],
    /// λ of each.
    pub lambda: f64,
    /// How near the footprint is to one with another number of probes, as a difference of ratios.
    pub nearest: f64,
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The largest ratio that has one probe.
const ROUND: f64 = 1.0 + 1.0 / 64.0;

/// The row for a footprint with these derivatives of texels along x and y.
pub fn row(dx: [f64; 3], dy: [f64; 3], limit: usize, variant: Variant) -> Row {
    // The two perpendicular directions of the window whose images are perpendicular: the axes of the ellipse.
    let turn = 0.5 * (2.0 * dot(dx, dy)).atan2(dot(dx, dx) - dot(dy, dy));
    let (sin, cos) = turn.sin_cos();
    let long: [f64; 3] = std::array::from_fn(|i| cos * dx[i] + sin * dy[i]);
    let short: [f64; 3] = std::array::from_fn(|i| cos * dy[i] - sin * dx[i]);
    let (major, minor) = (dot(long, long).sqrt(), dot(short, short).sqrt());
    let ratio = major / minor;
    let limit = if variant.has(Mutation::AnisotropyUnlimited) { 16 } else { limit };
    if ratio <= ROUND || variant.has(Mutation::AnisotropyIgnored) {
        let nearest = (ratio - ROUND).abs();
        return Row { count: 1, step: [0.0; 3], lambda: major.log2(), nearest };
    }
    let exact = ratio - (ROUND - 1.0);
    let count = exact.ceil().clamp(2.0, limit as f64);
    let width = minor.max(major / count);
    let apart = ((major * major - width * width) / (count * count - 1.0)).sqrt();
    let of_major = variant.has(Mutation::LambdaOfMajor);
    Row {
        count: count as usize,
        step: long.map(|c| c / major * apart),
        lambda: if of_major { major } else { width }.log2(),
        nearest: if exact > limit as f64 {
            exact - limit as f64
        } else {
            (exact - exact.round()).abs()
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_texels_along_t_are_four_boxes_that_touch() {
        let row = row([0.0, 4.0, 0.0], [1.0, 0.0, 0.0], 16, Variant::CORRECT);
        assert_eq!((row.count, row.lambda), (4, 0.0));
        assert!((row.step[1].abs() - 1.0).abs() < 1e-12 && row.step[0].abs() < 1e-12, "{row:?}");
    }

    #[test]
    fn a_limit_makes_probes_wider() {
        let row = row([8.0, 0.0, 0.0], [0.0, 1.0, 0.0], 2, Variant::CORRECT);
        assert_eq!((row.count, row.lambda), (2, 2.0));
        // (64 - 16) / 3.
        assert!((row.step[0].abs() - 4.0).abs() < 1e-12, "{row:?}");
    }

    #[test]
    fn what_is_round_has_one_probe() {
        let row = row([3.0, 4.0, 0.0], [-4.0, 3.0, 0.0], 16, Variant::CORRECT);
        assert_eq!((row.count, row.step, row.lambda), (1, [0.0; 3], 5f64.log2()));
    }
}
