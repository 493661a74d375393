//! The level of detail (GL 2.1, section 3.8.8): from λ to the levels that a lane reads.

use crate::lanes::math::{clamp, to_i32};
use crate::lanes::{F32s, LANES, U32s};
use crate::sampler::{MAX_LOD_BIAS, Mipmap};

/// The sampler's part in the choice of levels: from λ of the base level to levels and weights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LodRange {
    /// The sampler's bias.
    pub bias: f32,
    /// Lower bound of λ.
    pub min: f32,
    /// Upper bound of λ.
    pub max: f32,
    /// The magnification filter is used up to this λ (`c` in the specification).
    pub magnified_to: f32,
    /// The filter between levels.
    pub mipmap: Mipmap,
    /// The last level, counted from the base level.
    pub last: u32,
}

impl LodRange {
    /// λ with the bias added and clamped to the sampler's range (GL 2.1, equations 3.18 and 3.19). The sum of the biases
    /// is clamped to ±16. NaN gives the lower bound.
    #[inline(always)]
    pub fn lambda(&self, base: &F32s, bias: Option<&F32s>) -> F32s {
        let mut out = F32s::ZERO;
        match bias {
            Some(shader) => {
                for lane in 0..LANES {
                    let bias = clamp(self.bias + shader[lane], -MAX_LOD_BIAS, MAX_LOD_BIAS);
                    out[lane] = clamp(base[lane] + bias, self.min, self.max);
                }
            }
            None => {
                let bias = clamp(self.bias, -MAX_LOD_BIAS, MAX_LOD_BIAS);
                for lane in 0..LANES {
                    out[lane] = clamp(base[lane] + bias, self.min, self.max);
                }
            }
        }
        out
    }

    /// The two levels of each minified lane, counted from the base level, and the weight of the second.
    #[inline(always)]
    pub fn levels(&self, lambda: &F32s) -> ([U32s; 2], F32s) {
        let mut levels = [U32s::ZERO; 2];
        let mut weight = F32s::ZERO;
        let last = self.last as i32;
        match self.mipmap {
            Mipmap::None => {}
            Mipmap::Nearest => {
                for lane in 0..LANES {
                    levels[0][lane] = nearest_level(lambda[lane], last);
                }
                levels[1] = levels[0];
            }
            Mipmap::Linear => {
                for lane in 0..LANES {
                    let ([first, second], part) = mixed_levels(lambda[lane], last);
                    levels[0][lane] = first;
                    levels[1][lane] = second;
                    weight[lane] = part;
                }
            }
        }
        (levels, weight)
    }

    /// [`Self::lambda`] without a bias of the lookup, of one lane.
    #[inline(always)]
    pub fn lambda_of(&self, base: f32) -> f32 {
        clamp(base + clamp(self.bias, -MAX_LOD_BIAS, MAX_LOD_BIAS), self.min, self.max)
    }

    /// Whether the minification filter is used at this λ.
    #[inline(always)]
    pub fn is_minified(&self, lambda: f32) -> bool {
        lambda > self.magnified_to
    }

    /// [`Self::levels`] of one lane.
    #[inline(always)]
    pub fn levels_of(&self, lambda: f32) -> ([u32; 2], f32) {
        let last = self.last as i32;
        match self.mipmap {
            Mipmap::None => ([0; 2], 0.0),
            Mipmap::Nearest => ([nearest_level(lambda, last); 2], 0.0),
            Mipmap::Linear => mixed_levels(lambda, last),
        }
    }
}

/// `⌈λ + 1/2⌉ - 1`, the nearest level; a tie gives the finer.
#[inline(always)]
fn nearest_level(lambda: f32, last: i32) -> u32 {
    let inside = clamp(lambda, 0.0, last as f32);
    let whole = to_i32(inside);
    let up = if inside - whole as f32 > 0.5 { 1 } else { 0 };
    (whole + up) as u32
}

/// The two levels around λ, and the weight of the second.
#[inline(always)]
fn mixed_levels(lambda: f32, last: i32) -> ([u32; 2], f32) {
    let inside = clamp(lambda, 0.0, last as f32);
    let whole = to_i32(inside);
    let next = if whole < last { whole + 1 } else { last };
    ([whole as u32, next as u32], inside - whole as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn range(mipmap: Mipmap) -> LodRange {
        LodRange { bias: 0.0, min: -1000.0, max: 1000.0, magnified_to: 0.0, mipmap, last: 4 }
    }

    fn levels(mipmap: Mipmap, lambda: f32) -> (u32, u32, f32) {
        let ([first, second], weight) = range(mipmap).levels(&F32s::splat(lambda));
        (first[9], second[9], weight[9])
    }

    #[test]
    fn levels_follow_the_equations() {
        for (lambda, d) in
            [(0.1, 0), (0.5, 0), (0.50001, 1), (1.5, 1), (3.6, 4), (4.4, 4), (99.0, 4)]
        {
            assert_eq!(levels(Mipmap::Nearest, lambda), (d, d, 0.0), "{lambda}");
        }
        for (lambda, want) in [
            (0.25, (0, 1, 0.25)),
            (1.0, (1, 2, 0.0)),
            (3.75, (3, 4, 0.75)),
            (4.0, (4, 4, 0.0)),
            (f32::INFINITY, (4, 4, 0.0)),
            (f32::NEG_INFINITY, (0, 1, 0.0)),
            (f32::NAN, (0, 1, 0.0)),
        ] {
            assert_eq!(levels(Mipmap::Linear, lambda), want, "{lambda}");
        }
    }

    #[test]
    fn bias_is_bounded_and_lambda_stays_in_range() {
        let lod = LodRange { bias: 15.0, min: -1.0, max: 9.0, ..range(Mipmap::Linear) };
        let base = F32s::from_fn(|lane| match lane {
            0 => -20.0,
            1 => f32::INFINITY,
            2 => f32::NAN,
            _ => -13.5,
        });
        let got = lod.lambda(&base, Some(&F32s::splat(7.0)));
        assert_eq!(got.0[..4], [-1.0, 9.0, -1.0, 2.5]);
        assert_eq!(lod.lambda(&base, None).0[..4], [-1.0, 9.0, -1.0, 1.5]);
    }
}
