//! Wrap modes (section 3.8.7), and which texels a coordinate reads (section 3.8.8).

use crate::mutation::{Mutation, Variant};

/// What happens to a coordinate outside [0, 1].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrap {
    /// `GL_REPEAT`.
    Repeat,
    /// `GL_CLAMP`.
    Clamp,
    /// `GL_CLAMP_TO_EDGE`: to [1/(2·width), 1 - 1/(2·width)], where the first lecture prints `1/2*width`.
    ClampToEdge,
    /// `GL_CLAMP_TO_BORDER`.
    ClampToBorder,
    /// `GL_MIRRORED_REPEAT`.
    MirroredRepeat,
    /// `GL_MIRROR_CLAMP_EXT`.
    MirrorClamp,
    /// `GL_MIRROR_CLAMP_TO_EDGE_EXT`.
    MirrorClampToEdge,
    /// `GL_MIRROR_CLAMP_TO_BORDER_EXT`.
    MirrorClampToBorder,
}

impl Wrap {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Repeat,
        Self::Clamp,
        Self::ClampToEdge,
        Self::ClampToBorder,
        Self::MirroredRepeat,
        Self::MirrorClamp,
        Self::MirrorClampToEdge,
        Self::MirrorClampToBorder,
    ];
}

/// A texel of a row, or the border beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Index {
    /// A texel, counted from 0.
    Texel(usize),
    /// The border colour.
    Border,
}

/// The wrapped coordinate in texels: `u` for a row of `size` texels and coordinate `s`.
///
/// `s - floor(s)` repeats; `mirror(f)` is `f - floor(f)` for an even `floor(f)` and
/// `1 - (f - floor(f))` for an odd one; the clamps are to [0, 1], to [1/2N, 1 - 1/2N] and to
/// [-1/2N, 1 + 1/2N]. The mirror clamps (EXT_texture_mirror_clamp) are of `|s|`, to [1/2N, 1],
/// to [1/2N, 1 - 1/2N] and to [1/2N, 1 + 1/2N].
pub fn coordinate(wrap: Wrap, s: f64, size: usize, variant: Variant) -> f64 {
    let n = size as f64;
    let half = 0.5 / n;
    let s = match wrap {
        Wrap::Repeat if variant.has(Mutation::RepeatTruncates) => (s - s.trunc()).abs(),
        Wrap::Repeat => s - s.floor(),
        Wrap::Clamp if variant.has(Mutation::ClampAsClampToEdge) => s.clamp(half, 1.0 - half),
        Wrap::Clamp => s.clamp(0.0, 1.0),
        Wrap::ClampToEdge if variant.has(Mutation::EdgeClampedToWholeTexel) => s.clamp(0.0, 1.0),
        Wrap::ClampToEdge => s.clamp(half, 1.0 - half),
        Wrap::ClampToBorder => s.clamp(-half, 1.0 + half),
        Wrap::MirroredRepeat => {
            let fraction = s - s.floor();
            let odd = s.floor().rem_euclid(2.0) == 1.0 && !variant.has(Mutation::MirrorAsRepeat);
            (if odd { 1.0 - fraction } else { fraction }).clamp(half, 1.0 - half)
        }
        Wrap::MirrorClamp | Wrap::MirrorClampToEdge | Wrap::MirrorClampToBorder
            if variant.has(Mutation::MirrorNegativeIgnored) =>
        {
            s.clamp(half, 1.0 - half)
        }
        Wrap::MirrorClamp => s.abs().clamp(half, 1.0),
        Wrap::MirrorClampToEdge => s.abs().clamp(half, 1.0 - half),
        Wrap::MirrorClampToBorder => s.abs().clamp(half, 1.0 + half),
    };
    s * n
}

/// The texel at integer position `i`: repeating images go round, others end at the border.
fn index(wrap: Wrap, i: f64, size: usize, variant: Variant) -> Index {
    let n = size as f64;
    let inside = match wrap {
        Wrap::Repeat => i.rem_euclid(n),
        Wrap::Clamp
        | Wrap::ClampToEdge
        | Wrap::ClampToBorder
        | Wrap::MirroredRepeat
        | Wrap::MirrorClamp
        | Wrap::MirrorClampToEdge
        | Wrap::MirrorClampToBorder => i,
    };
    if (0.0..n).contains(&inside) {
        Index::Texel(inside as usize)
    } else if variant.has(Mutation::BorderAsEdge) {
        Index::Texel(inside.clamp(0.0, n - 1.0) as usize)
    } else {
        Index::Border
    }
}

/// The texel that `s` lies in: `floor(u)`, and the last one for `GL_CLAMP` at `s = 1`.
pub fn nearest(wrap: Wrap, s: f64, size: usize, variant: Variant) -> Index {
    let u = coordinate(wrap, s, size, variant);
    let mut i = if variant.has(Mutation::RoundForFloor) { u.round() } else { u.floor() };
    match wrap {
        Wrap::Clamp
        | Wrap::ClampToEdge
        | Wrap::MirroredRepeat
        | Wrap::MirrorClamp
        | Wrap::MirrorClampToEdge => i = i.min(size as f64 - 1.0),
        Wrap::Repeat | Wrap::ClampToBorder | Wrap::MirrorClampToBorder => {}
    }
    if variant.has(Mutation::TexelOffByOne) {
        i += 1.0;
    }
    index(wrap, i, size, variant)
}

/// The two texels about `s`, and the weight α of the second: `i0 = floor(u - 1/2)`,
/// `i1 = i0 + 1`, `α = frac(u - 1/2)`.
pub fn linear(wrap: Wrap, s: f64, size: usize, variant: Variant) -> ([Index; 2], f64) {
    let half = if variant.has(Mutation::HalfTexelOff) { 0.0 } else { 0.5 };
    let u = coordinate(wrap, s, size, variant) - half;
    let i = u.floor();
    let pair = [index(wrap, i, size, variant), index(wrap, i + 1.0, size, variant)];
    (pair, u - i)
}

#[cfg(test)]
mod tests {
    use super::*;
    use Index::{Border, Texel};

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn nearest_by_hand() {
        let table = [
            (Wrap::Repeat, -0.25, Texel(3)),
            (Wrap::Repeat, 1.0, Texel(0)),
            (Wrap::Repeat, 7.5, Texel(2)),
            (Wrap::Clamp, -3.0, Texel(0)),
            (Wrap::Clamp, 1.0, Texel(3)),
            (Wrap::ClampToEdge, 9.0, Texel(3)),
            (Wrap::ClampToBorder, -0.001, Border),
            (Wrap::ClampToBorder, 1.0, Border),
            (Wrap::ClampToBorder, 0.999, Texel(3)),
            (Wrap::MirroredRepeat, -0.1, Texel(0)),
            (Wrap::MirroredRepeat, 1.1, Texel(3)),
            (Wrap::MirroredRepeat, 2.1, Texel(0)),
            (Wrap::MirroredRepeat, 1.9, Texel(0)),
            (Wrap::MirrorClamp, -1.0, Texel(3)),
            (Wrap::MirrorClampToBorder, -0.3, Texel(1)),
            (Wrap::MirrorClampToBorder, -1.0, Border),
            (Wrap::MirrorClampToBorder, 1.01, Border),
        ];
        for (wrap, s, expected) in table {
            assert_eq!(nearest(wrap, s, 4, TRUE), expected, "{wrap:?} {s}");
        }
    }

    #[test]
    fn linear_by_hand() {
        let table = [
            (Wrap::Repeat, 0.0, [Texel(3), Texel(0)], 0.5),
            (Wrap::Repeat, 0.25, [Texel(0), Texel(1)], 0.5),
            (Wrap::Clamp, -5.0, [Border, Texel(0)], 0.5),
            (Wrap::Clamp, 5.0, [Texel(3), Border], 0.5),
            (Wrap::ClampToEdge, -5.0, [Texel(0), Texel(1)], 0.0),
            (Wrap::ClampToBorder, -5.0, [Border, Texel(0)], 0.0),
            (Wrap::ClampToBorder, 0.0625, [Border, Texel(0)], 0.75),
            (Wrap::MirroredRepeat, 1.25, [Texel(2), Texel(3)], 0.5),
            (Wrap::MirrorClampToBorder, 0.0, [Texel(0), Texel(1)], 0.0),
            (Wrap::MirrorClampToBorder, -0.9375, [Texel(3), Border], 0.25),
        ];
        for (wrap, s, texels, alpha) in table {
            assert_eq!(linear(wrap, s, 4, TRUE), (texels, alpha), "{wrap:?} {s}");
        }
    }
}
