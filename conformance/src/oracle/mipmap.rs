//! Derived mipmap levels: each texel is the mean of the area that it covers in the level before
//! (section 3.8.8: the box filter is recommended; GLU 1.3, section 3 for the scaling).

use super::srgb;
use crate::mutation::{Mutation, Variant};

/// An image of numbers, four a texel, rows from the bottom, then slices.
#[derive(Clone, Debug, PartialEq)]
pub struct Volume {
    /// Width, height, depth.
    pub size: [usize; 3],
    /// R, G, B, A.
    pub texels: Vec<[f64; 4]>,
}

/// How means are computed and stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// Bytes, rounded half up.
    Bytes,
    /// Numbers of 16 bits, rounded half up.
    Shorts,
    /// Bytes that stand for sRGB-encoded colours, whose light is averaged; alpha is linear.
    SrgbBytes,
    /// `f32`.
    Floats,
}

/// The texels of a row of `old` that texel `index` of a row of `new` covers, and the weight of each.
fn covered(index: usize, old: usize, new: usize, variant: Variant) -> Vec<(usize, f64)> {
    if variant.has(Mutation::OddTexelDropped) && old > new {
        // Two texels a side, whatever is left over.
        return vec![(2 * index, 1.0), (2 * index + 1, 1.0)];
    }
    if variant.has(Mutation::MipmapOfOneTexel) {
        return vec![(index * old / new, 1.0)];
    }
    let (low, high) =
        (index as f64 * old as f64 / new as f64, (index + 1) as f64 * old as f64 / new as f64);
    (low.floor() as usize..(high.ceil() as usize).min(old))
        .map(|i| (i, (high.min(i as f64 + 1.0) - low.max(i as f64)).max(0.0)))
        .collect()
}

impl Volume {
    /// Scales to another size.
    pub fn scaled(&self, size: [usize; 3], storage: Storage, variant: Variant) -> Self {
        let axis = |n: usize| -> Vec<Vec<(usize, f64)>> {
            (0..size[n]).map(|i| covered(i, self.size[n], size[n], variant)).collect()
        };
        let (columns, rows, slices) = (axis(0), axis(1), axis(2));
        let mut texels = Vec::with_capacity(size.iter().product());
        for slice in &slices {
            for row in &rows {
                for column in &columns {
                    texels.push(self.mean([column, row, slice], storage, variant));
                }
            }
        }
        Self { size, texels }
    }

    fn mean(&self, taps: [&[(usize, f64)]; 3], storage: Storage, variant: Variant) -> [f64; 4] {
        let is_light = storage == Storage::SrgbBytes && !variant.has(Mutation::MipmapOfEncoded);
        let (mut sum, mut area) = ([0.0; 4], 0.0);
        for &(z, wz) in taps[2] {
            for &(y, wy) in taps[1] {
                for &(x, wx) in taps[0] {
                    let weight = wx * wy * wz;
                    let at = (z * self.size[1] + y) * self.size[0] + x;
                    let texel = self.texels[at];
                    let texel =
                        if is_light { srgb::decode_texel(texel, Variant::CORRECT) } else { texel };
                    area += weight;
                    for c in 0..4 {
                        sum[c] += weight * texel[c];
                    }
                }
            }
        }
        let mean = sum.map(|c| c / area);
        match storage {
            Storage::Floats => mean.map(|c| f64::from(c as f32)),
            Storage::Bytes => mean.map(|c| half_up(c, 255.0, variant)),
            Storage::Shorts => mean.map(|c| half_up(c, 65535.0, variant)),
            Storage::SrgbBytes => {
                let encode = |c: f64| if is_light { srgb::encode(c) } else { c };
                [encode(mean[0]), encode(mean[1]), encode(mean[2]), mean[3]]
                    .map(|c| half_up(c, 255.0, variant))
            }
        }
    }

    /// All levels that are derived from this one, halved (rounded down) to a single texel.
    pub fn chain(&self, storage: Storage, variant: Variant) -> Vec<Self> {
        let mut levels = Vec::new();
        let mut level = self.clone();
        while level.size.iter().any(|&n| n > 1) {
            level = level.scaled(level.size.map(|n| (n / 2).max(1)), storage, variant);
            levels.push(level.clone());
        }
        levels
    }
}

/// A fraction as a code of 0 to `last` has it, halves up. What is a half but for the roundings of `f64` is one.
fn half_up(c: f64, last: f64, variant: Variant) -> f64 {
    let half = if variant.has(Mutation::MipmapTruncates) { 0.0 } else { 0.5 };
    (c * last + half + 1e-9).floor() / last
}

/// The power of two that GLU scales a side to: the nearest, in the sense that 3·2^k goes up.
pub fn closest_power(n: usize, variant: Variant) -> usize {
    let floor = 1usize << n.ilog2();
    let up = if variant.has(Mutation::PowerRoundedDown) { false } else { 2 * n >= 3 * floor };
    if up { 2 * floor } else { floor }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn three_texels_become_one_and_five_two() {
        let row = |values: &[f64]| Volume {
            size: [values.len(), 1, 1],
            texels: values.iter().map(|&v| [v; 4]).collect(),
        };
        let one = row(&[0.0, 3.0, 6.0]).scaled([1, 1, 1], Storage::Floats, TRUE);
        assert_eq!(one.texels, [[3.0; 4]]);
        // 5 → 2: weights 1, 1, 1/2 over 5/2.
        let two = row(&[0.0, 5.0, 10.0, 0.0, 0.0]).scaled([2, 1, 1], Storage::Floats, TRUE);
        assert_eq!(two.texels, [[4.0; 4], [2.0; 4]]);
    }

    #[test]
    fn powers_of_two() {
        let powers = [1, 2, 3, 4, 5, 6, 7, 11, 12].map(|n| closest_power(n, TRUE));
        assert_eq!(powers, [1, 2, 4, 4, 4, 8, 8, 8, 16]);
    }
}
