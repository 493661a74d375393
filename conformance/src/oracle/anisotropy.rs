//! The anisotropic filter: the rows (or columns) that the footprint crosses, a pair of texels of each.
//!
//! EXT_texture_filter_anisotropic leaves the scheme to the implementation. DetGL's, for images in a
//! plane: with the footprint's second moments `C = J·Jᵀ` of eigenvalues `σ₁² ≥ σ₂²`, its limit `A`,
//! the width `m² = max(σ₂², σ₁²/A²)` and the elongation `ε = 1 - m²/σ₁²`, levels are those of
//! `λ = ½ log2(m² + ε (1 - 9/16 m²))`. The excess is `κ (C - σ₂² I)`, `κ = (σ₁² - m²)/(σ₁² - σ₂²)`; with
//! its moments `a²` along the axis of the larger one and `c` between both, a level of texels of size
//! `x` gives `L = √(1 + a²/x²)` rows, weighted by what lies within `L/2` of the sample, each
//! `c / (max(m², 1) + a²)` texels beside the one before. The two texels of a row weigh `1 - w` and
//! `w = b + (1 - 2b) α`, with `b = 7/16 slope² min(m², 1)`.

use super::lod::{self, Derivatives, Levels};
use super::sample::Sampler;
use super::texture::Level;
use super::wrap::Wrap;
use crate::mutation::{Mutation, Variant};

/// How a footprint crosses the texels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footprint {
    /// The axis along which texels follow one another: 0 for s (columns), 1 for t (rows).
    pub along: usize,
    /// `a²`.
    pub excess: f64,
    /// Texels across per texel along.
    pub slope: f64,
    /// `b`.
    pub even: f64,
    /// λ.
    pub lambda: f64,
    /// `σ₁/σ₂`.
    pub ratio: f64,
    /// How much larger one moment is than the other, over their sum: at 0 columns become rows.
    pub lead: f64,
}

/// The footprint on a base level of this size.
pub fn footprint(d: &Derivatives, size: [usize; 2], limit: f64, variant: Variant) -> Footprint {
    let texels = |axis: usize| [d.dx[axis], d.dy[axis]].map(|c| c * size[axis] as f64);
    let (u, v) = (texels(0), texels(1));
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let (uu, uv, vv) = (dot(u, u), dot(u, v), dot(v, v));
    let root = ((0.5 * (uu - vv)).powi(2) + uv * uv).sqrt();
    let major = 0.5 * (uu + vv) + root;
    let minor = (0.5 * (uu + vv) - root).max(0.0);
    let ratio = (major / minor).sqrt();
    let lead = (uu - vv).abs() / (uu + vv);
    let round = 0.5 * major.log2();
    let limit = if variant.has(Mutation::AnisotropyUnlimited) { 16.0 } else { limit };
    let width = minor.max(major / (limit * limit));
    if major <= width || variant.has(Mutation::AnisotropyIgnored) {
        let along = usize::from(vv > uu);
        return Footprint { along, excess: 0.0, slope: 0.0, even: 0.0, lambda: round, ratio, lead };
    }
    // C turned by a right angle has the axes exchanged.
    let across = variant.has(Mutation::AnisotropyAcross);
    let (uu, uv, vv) = if across { (vv, -uv, uu) } else { (uu, uv, vv) };
    let part = (major - width) / (major - minor);
    let excess = part * (uu.max(vv) - minor);
    let slope = part * uv / (width.max(1.0) + excess);
    let elongation = 1.0 - width / major;
    let squared = width + elongation * (1.0 - 9.0 / 16.0 * width);
    Footprint {
        along: usize::from(vv > uu),
        excess,
        slope: if variant.has(Mutation::RowsUpright) { 0.0 } else { slope },
        even: if variant.has(Mutation::RowsUneven) {
            0.0
        } else {
            7.0 / 16.0 * slope * slope * width.min(1.0)
        },
        lambda: if variant.has(Mutation::LambdaOfMajor) { round } else { 0.5 * squared.log2() },
        ratio,
        lead,
    }
}

/// The filtered colour of an image that repeats, is mirrored, or goes on as its edge.
pub fn sample(
    image: &[Level],
    sampler: &Sampler,
    st: [f64; 2],
    footprint: &Footprint,
    variant: Variant,
) -> [f64; 4] {
    let base = &image[sampler.range.base];
    let wrap = sampler.at.wrap;
    let read = |level: usize| rows((base, &image[level]), wrap, st, footprint, variant).0;
    match lod::levels(footprint.lambda, sampler.filters, sampler.range, variant) {
        Levels::One(level, _) => read(level),
        Levels::Two(levels, weight, _) => {
            let [a, b] = levels.map(read);
            std::array::from_fn(|c| (1.0 - weight) * a[c] + weight * b[c])
        }
    }
}

/// How near a sample comes to a step of its formula, in texels: where a row crosses a texel's centre,
/// the weights of its pair jump; and where columns become rows.
pub fn nearest_step(
    image: &[Level],
    sampler: &Sampler,
    st: [f64; 2],
    footprint: &Footprint,
) -> f64 {
    let base = &image[sampler.range.base];
    let levels = |level: usize| (base, &image[level]);
    let wrap = sampler.at.wrap;
    let near = |level: usize| rows(levels(level), wrap, st, footprint, Variant::CORRECT).1;
    let near = match lod::levels(footprint.lambda, sampler.filters, sampler.range, Variant::CORRECT)
    {
        Levels::One(level, _) => near(level),
        Levels::Two([a, b], ..) => near(a).min(near(b)),
    };
    near.min(footprint.lead)
}

/// The texel that stands for one beyond the edges: footprints go on there as if the image did (section 3.8.7).
fn wrapped(wrap: Wrap, i: i64, size: usize) -> usize {
    let n = size as i64;
    let inside = match wrap {
        Wrap::Repeat => i.rem_euclid(n),
        Wrap::MirroredRepeat => {
            let twice = i.rem_euclid(2 * n);
            twice.min(2 * n - 1 - twice)
        }
        // With a border, other than these, DetGL's filter is one of probes, which no oracle has.
        Wrap::ClampToEdge
        | Wrap::Clamp
        | Wrap::ClampToBorder
        | Wrap::MirrorClamp
        | Wrap::MirrorClampToEdge
        | Wrap::MirrorClampToBorder => i.clamp(0, n - 1),
    };
    inside as usize
}

/// The mean of a level's rows, and how near a row comes to a texel's centre.
fn rows(
    (base, level): (&Level, &Level),
    wrap: [Wrap; 2],
    st: [f64; 2],
    footprint: &Footprint,
    variant: Variant,
) -> ([f64; 4], f64) {
    let size = [level.width, level.height];
    let part = [0, 1].map(|c| size[c] as f64 / [base.width, base.height][c] as f64);
    let (along, across) = (footprint.along, 1 - footprint.along);
    let place = [0, 1].map(|c| st[c] * size[c] as f64);
    let slope = (footprint.slope * part[across] / part[along]).clamp(-2.0, 2.0);
    let length = (1.0 + footprint.excess * part[along] * part[along]).sqrt().min(48.0);
    let (low, high) = (place[along] - length / 2.0, place[along] + length / 2.0);
    let (mut sum, mut weights, mut near) = ([0.0; 4], 0.0, f64::INFINITY);
    let mut row = low.floor();
    while row < high {
        let weight = match variant.has(Mutation::RowsWhole) {
            true => 1.0,
            false => high.min(row + 1.0) - low.max(row),
        };
        let x = place[across] + slope * (row + 0.5 - place[along]) - 0.5;
        if footprint.even > 0.0 {
            near = near.min((x - x.round()).abs());
        }
        let right = footprint.even + (1.0 - 2.0 * footprint.even) * (x - x.floor());
        for (i, part) in [(x.floor(), 1.0 - right), (x.floor() + 1.0, right)] {
            let mut at = [0; 2];
            at[along] = wrapped(wrap[along], row as i64, size[along]);
            at[across] = wrapped(wrap[across], i as i64, size[across]);
            let texel = level.texel(at[0], at[1]);
            (0..4).for_each(|c| sum[c] += weight * part * texel[c]);
        }
        weights += weight;
        row += 1.0;
    }
    (sum.map(|c| c / weights), near)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_texels_along_s_are_columns_without_slope() {
        let d = Derivatives { dx: [4.0 / 64.0, 0.0], dy: [0.0, 1.0 / 64.0] };
        let got = footprint(&d, [64, 64], 16.0, Variant::CORRECT);
        assert_eq!((got.along, got.excess, got.slope, got.even), (0, 15.0, 0.0, 0.0));
        let image = [Level::from_fn(64, 64, |i, _| [if i < 3 { 255 } else { 0 }; 4])];
        // Four columns about the middle of texel 1: half of texel -1, three, and half of texel 3.
        let (mean, _) = rows(
            (&image[0], &image[0]),
            [Wrap::Repeat; 2],
            [1.5 / 64.0; 2],
            &got,
            Variant::CORRECT,
        );
        assert!((mean[0] - 0.75).abs() < 1e-12, "{mean:?}");
    }

    #[test]
    fn a_round_footprint_has_the_weights_of_a_bilinear_filter() {
        let d = Derivatives { dx: [2.0 / 64.0, 0.0], dy: [0.0, 2.0 / 64.0] };
        let got = footprint(&d, [64, 64], 16.0, Variant::CORRECT);
        assert_eq!((got.excess, got.slope, got.even, got.lambda), (0.0, 0.0, 0.0, 1.0));
        let image = [Level::from_fn(64, 64, |i, j| [(i * 3 + j) as u8; 4])];
        let (mean, _) = rows(
            (&image[0], &image[0]),
            [Wrap::Repeat; 2],
            [10.7 / 64.0, 9.1 / 64.0],
            &got,
            Variant::CORRECT,
        );
        assert!((mean[0] * 255.0 - (10.2 * 3.0 + 8.6)).abs() < 1e-9, "{mean:?}");
    }
}
