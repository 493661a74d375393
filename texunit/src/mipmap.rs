//! Mip generation: each level is the box-filtered half of the one before.
//!
//! A texel of the smaller level is the mean of exactly the area it covers: two texels along an
//! even side, three along an odd one, the outer two in part (a side of `2n + 1` becomes `n`; texel
//! `i` covers `i(2n+1)/n` to `(i+1)(2n+1)/n`, so the weights over `2n + 1` are `n - i`, `n`, `i + 1`).
//! Weights are integers. Integer channels are summed exactly and rounded half up; sRGB colours
//! are averaged in linear light, and `f32` depth likewise, in `f64`.

use crate::format::{Encoding, Format, srgb};
use crate::image::{Image, ImageError, Level};

/// The texels that one smaller texel covers along a side, and their weights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Cover {
    first: u32,
    weights: [u32; 3],
}

impl Cover {
    /// What texel `i` of the half of `size` covers. A side of 1 stays.
    fn new(size: u32, i: u32) -> Self {
        let half = size / 2;
        let weights = if size == 1 {
            [1, 0, 0]
        } else if size.is_multiple_of(2) {
            [1, 1, 0]
        } else {
            [half - i, half, i + 1]
        };
        Self { first: 2 * i, weights }
    }

    fn total(self) -> u64 {
        self.weights.iter().copied().map(u64::from).sum()
    }

    /// The covered texels and their weights; those without weight, which may lie outside, left out.
    fn taps(self) -> impl Iterator<Item = (u32, u64)> {
        let first = self.first;
        (first..).zip(self.weights.map(u64::from)).filter(|&(_, weight)| weight > 0)
    }
}

impl Level {
    /// The next smaller level: half the width and height, rounded down, at least 1.
    ///
    /// # Errors
    /// When there is no memory.
    pub fn halved(&self) -> Result<Self, ImageError> {
        if self.width == 0 || self.height == 0 {
            return Self::new(self.format, self.width, self.height);
        }
        let half = |size: u32| (size / 2).max(1);
        let mut smaller = Self::new(self.format, half(self.width), half(self.height))?;
        let columns: Vec<Cover> = (0..smaller.width).map(|x| Cover::new(self.width, x)).collect();
        let bytes = self.format.bytes();
        let mut at = 0;
        for y in 0..smaller.height {
            let row = Cover::new(self.height, y);
            for &column in &columns {
                let texel = self.mean(column, row);
                smaller.texels[at..at + bytes].copy_from_slice(&texel[..bytes]);
                at += bytes;
            }
        }
        Ok(smaller)
    }

    /// The mean of the covered texels, in this level's format.
    fn mean(&self, column: Cover, row: Cover) -> [u8; 4] {
        let total = column.total() * row.total();
        // Below 255 · 2^28 for bytes and 2^24 · 2^28 for depth: no overflow.
        let integers = |value: &dyn Fn(&[u8]) -> u64| {
            let mut sum = 0;
            for (y, down) in row.taps() {
                for (x, across) in column.taps() {
                    sum += down * across * value(self.texel(x, y));
                }
            }
            (2 * sum + total) / (2 * total)
        };
        let reals = |value: &dyn Fn(&[u8]) -> f32| {
            let mut sum = 0.0;
            for (y, down) in row.taps() {
                for (x, across) in column.taps() {
                    sum += (down * across) as f64 * f64::from(value(self.texel(x, y)));
                }
            }
            (sum / total as f64) as f32
        };
        let mut texel = [0; 4];
        match self.format.info().encoding {
            Encoding::Unorm8 | Encoding::Srgb8 => {
                for channel in 0..self.format.channels() {
                    texel[channel] = if self.format.is_srgb_channel(channel) {
                        srgb::encode(reals(&|t| srgb::DECODE[usize::from(t[channel])]))
                    } else {
                        integers(&|t| u64::from(t[channel])) as u8
                    };
                }
            }
            Encoding::Unorm16 | Encoding::Unorm24 => {
                texel = (integers(&|t| u64::from(depth_bits(self.format, t))) as u32).to_le_bytes();
            }
            Encoding::Float32 => {
                texel = reals(&|t| f32::from_bits(depth_bits(self.format, t))).to_le_bytes();
            }
        }
        texel
    }
}

/// The bits of a depth texel.
fn depth_bits(format: Format, texel: &[u8]) -> u32 {
    let mut bytes = [0; 4];
    bytes[..texel.len()].copy_from_slice(texel);
    let word = u32::from_le_bytes(bytes);
    match format.info().encoding {
        Encoding::Unorm24 => word & 0xFF_FFFF,
        Encoding::Unorm8 | Encoding::Srgb8 | Encoding::Unorm16 | Encoding::Float32 => word,
    }
}

impl Image {
    /// Makes the levels above `base` of every face from the base level, to 1×1 or `max`.
    ///
    /// # Errors
    /// When a face has no base level or there is no memory; levels made until then stay.
    pub fn generate_mipmaps(&mut self, base: u32, max: u32) -> Result<(), ImageError> {
        for face in 0..self.shape().faces() {
            let mut level = base as usize;
            while let Some(larger) = self.level(face, level) {
                let done = larger.width.max(larger.height) <= 1 || level as u64 >= u64::from(max);
                if done {
                    break;
                }
                let smaller = larger.halved()?;
                level += 1;
                self.set_level(face, level, smaller)?;
            }
            if self.level(face, base as usize).is_none() {
                return Err(ImageError::Missing { face, level: base as usize });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::Shape;

    fn level(format: Format, width: u32, height: u32, texels: &[u8]) -> Level {
        Level::from_texels(format, width, height, texels).unwrap()
    }

    #[test]
    fn sides_are_covered_exactly() {
        for size in [2, 3, 5, 7, 8, 101] {
            let half = size / 2;
            let mut weights = vec![0; size as usize];
            for i in 0..half {
                let cover = Cover::new(size, i);
                // Every smaller texel covers size/half texels, every texel is covered in full.
                for (x, weight) in cover.taps() {
                    weights[x as usize] += weight;
                }
            }
            assert!(weights.iter().all(|&w| w == weights[0]), "{size}: {weights:?}");
        }
    }

    #[test]
    fn bytes_round_half_up_and_odd_sides_weigh_their_area() {
        let cases: [(Level, &[u8]); 5] = [
            (level(Format::L8, 2, 1, &[0, 1]), &[1]),
            (level(Format::L8, 2, 2, &[0, 0, 0, 1]), &[0]),
            (level(Format::L8, 3, 1, &[10, 20, 60]), &[30]),
            // 5 → 2: weights 2 2 1 0 0 and 0 0 1 2 2 over 5.
            (level(Format::L8, 5, 1, &[10, 20, 30, 40, 50]), &[18, 42]),
            (level(Format::Rgb8, 1, 2, &[0, 10, 255, 255, 20, 255]), &[128, 15, 255]),
        ];
        for (larger, want) in cases {
            let got = larger.halved().unwrap();
            assert_eq!(&got.texels[..want.len()], want, "{larger:?}");
            assert_eq!(got.texels.len(), want.len() + 3);
        }
    }

    #[test]
    fn srgb_is_averaged_in_linear_light_and_its_alpha_is_not() {
        let got = level(Format::Srgb8A8, 2, 1, &[0, 0, 0, 0, 255, 255, 255, 255]).halved().unwrap();
        assert_eq!(got.texel(0, 0), [188, 188, 188, 128]);
    }

    #[test]
    fn a_constant_image_stays_constant_in_every_format() {
        for format in Format::ALL {
            let texel = crate::format::convert::encode(format, [0.3, 0.7, 0.1, 0.9]);
            let texels = texel[..format.bytes()].repeat(13 * 6);
            let mut image = Image::new(Shape::D2);
            image.set_level(0, 0, level(format, 13, 6, &texels)).unwrap();
            image.generate_mipmaps(0, 1000).unwrap();
            for (number, size) in [(1, [6, 3]), (2, [3, 1]), (3, [1, 1])] {
                let made = image.level(0, number).unwrap();
                assert_eq!([made.width, made.height], size);
                assert_eq!(made.texel(0, 0), &texel[..format.bytes()], "{format:?}");
            }
            assert!(image.level(0, 4).is_none());
        }
    }

    #[test]
    fn the_largest_level_ends_the_pyramid_and_a_missing_base_is_an_error() {
        let mut image = Image::new(Shape::D2);
        assert!(image.generate_mipmaps(0, 9).is_err());
        image.set_level(0, 3, Level::new(Format::L8, 16, 16).unwrap()).unwrap();
        image.generate_mipmaps(3, 4).unwrap();
        assert!(image.level(0, 4).is_some() && image.level(0, 5).is_none());
        image.generate_mipmaps(3, 2).unwrap();
    }
}
