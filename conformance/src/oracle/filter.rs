//! The two filters within a level (section 3.8.8, nearest and linear).

use super::texture::Level;
use super::wrap::{self, Index, Wrap};
use crate::mutation::{Mutation, Variant};

/// Wrap modes and border colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Addressing {
    /// Wrap of s and of t.
    pub wrap: [Wrap; 2],
    /// Border colour.
    pub border: [f64; 4],
}

impl Addressing {
    fn wraps(&self, variant: Variant) -> [Wrap; 2] {
        let [s, t] = self.wrap;
        if variant.has(Mutation::WrapAxesSwapped) { [t, s] } else { [s, t] }
    }

    fn fetch(&self, level: &Level, i: Index, j: Index, variant: Variant) -> [f64; 4] {
        match (i, j) {
            (Index::Texel(i), Index::Texel(j)) if variant.has(Mutation::RowsUpsideDown) => {
                level.texel(i, level.height - 1 - j)
            }
            (Index::Texel(i), Index::Texel(j)) => level.texel(i, j),
            (Index::Border, _) | (_, Index::Border) => {
                if variant.has(Mutation::BorderColorBlack) {
                    [0.0; 4]
                } else {
                    self.border
                }
            }
        }
    }
}

/// `GL_NEAREST`: the texel that (s, t) lies in.
pub fn nearest(level: &Level, at: &Addressing, st: [f64; 2], variant: Variant) -> [f64; 4] {
    let wraps = at.wraps(variant);
    let i = wrap::nearest(wraps[0], st[0], level.width, variant);
    let j = wrap::nearest(wraps[1], st[1], level.height, variant);
    at.fetch(level, i, j, variant)
}

/// `GL_LINEAR`:
/// `τ = (1-α)(1-β) τ00 + α(1-β) τ10 + (1-α)β τ01 + αβ τ11`, α and β the fractions of u - 1/2 and v - 1/2. (The first
/// lecture's frac(i - 1/2), of an i that was floored before, would always be 1/2.)
pub fn linear(level: &Level, at: &Addressing, st: [f64; 2], variant: Variant) -> [f64; 4] {
    if variant.has(Mutation::NearestForLinear) {
        return nearest(level, at, st, variant);
    }
    let wraps = at.wraps(variant);
    let (i, alpha) = wrap::linear(wraps[0], st[0], level.width, variant);
    let (j, beta) = wrap::linear(wraps[1], st[1], level.height, variant);
    let (alpha, beta) = weights(alpha, beta, variant);
    let texel = |a: usize, b: usize| at.fetch(level, i[a], j[b], variant);
    let corners = [texel(0, 0), texel(1, 0), texel(0, 1), texel(1, 1)];
    std::array::from_fn(|c| {
        (1.0 - alpha) * (1.0 - beta) * corners[0][c]
            + alpha * (1.0 - beta) * corners[1][c]
            + (1.0 - alpha) * beta * corners[2][c]
            + alpha * beta * corners[3][c]
    })
}

fn weights(alpha: f64, beta: f64, variant: Variant) -> (f64, f64) {
    if variant.has(Mutation::WeightsReversed) {
        (1.0 - alpha, 1.0 - beta)
    } else if variant.has(Mutation::WeightsSwapped) {
        (beta, alpha)
    } else if variant.has(Mutation::WeightsOf4Bits) {
        ((alpha * 16.0).floor() / 16.0, (beta * 16.0).floor() / 16.0)
    } else {
        (alpha, beta)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 2×2: red grows with i, green with j.
    fn level() -> Level {
        Level::from_fn(2, 2, |i, j| [i as u8 * 255, j as u8 * 255, 0, 255])
    }

    fn at(wrap: Wrap) -> Addressing {
        Addressing { wrap: [wrap; 2], border: [0.25, 0.5, 1.0, 0.0] }
    }

    #[test]
    fn linear_by_hand() {
        let edge = at(Wrap::ClampToEdge);
        let table = [
            ([0.25, 0.25], [0.0, 0.0, 0.0, 1.0]),
            ([0.5, 0.5], [0.5, 0.5, 0.0, 1.0]),
            ([0.375, 0.75], [0.25, 1.0, 0.0, 1.0]),
        ];
        for (st, expected) in table {
            assert_eq!(linear(&level(), &edge, st, Variant::CORRECT), expected, "{st:?}");
        }
    }

    #[test]
    fn clamp_mixes_half_of_the_border_at_the_edge() {
        let value = linear(&level(), &at(Wrap::Clamp), [-9.0, 0.25], Variant::CORRECT);
        assert_eq!(value, [0.125, 0.25, 0.5, 0.5]);
    }

    #[test]
    fn nearest_by_hand() {
        let repeat = at(Wrap::Repeat);
        assert_eq!(nearest(&level(), &repeat, [-0.3, 0.2], Variant::CORRECT), [1.0, 0.0, 0.0, 1.0]);
        let border = at(Wrap::ClampToBorder);
        assert_eq!(nearest(&level(), &border, [0.1, 1.5], Variant::CORRECT), border.border);
    }
}
