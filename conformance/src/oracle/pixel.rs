//! Pixels in the client's memory: components, packed types, byte order, and where a pixel is
//! (sections 3.6.1 to 3.6.4; tables 2.9 and 3.5 to 3.11).

use crate::mutation::{Mutation, Variant};

/// Which components a pixel has, first to last, as places in R, G, B, A.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Components {
    /// These of R, G, B, A.
    Colors(&'static [usize]),
    /// One number that is R, G and B.
    Luminance,
    /// That, and alpha.
    LuminanceAlpha,
}

impl Components {
    /// How many.
    pub fn count(self) -> usize {
        match self {
            Self::Colors(places) => places.len(),
            Self::Luminance => 1,
            Self::LuminanceAlpha => 2,
        }
    }

    /// R, G, B, A of the components: what is missing is 0, alpha 1 (section 3.6.4, final expansion).
    pub fn expand(self, c: [f64; 4], variant: Variant) -> [f64; 4] {
        match self {
            Self::Colors(places) => {
                let swapped = variant.has(Mutation::BgrAsRgb);
                let mut rgba = [0.0, 0.0, 0.0, 1.0];
                for (&place, value) in places.iter().zip(c) {
                    let is_bgr = places.first() == Some(&2) && places.len() > 1;
                    let place = if swapped && is_bgr && place < 3 { 2 - place } else { place };
                    rgba[place] = value;
                }
                rgba
            }
            Self::Luminance => [c[0], c[0], c[0], 1.0],
            Self::LuminanceAlpha => [c[0], c[0], c[0], c[1]],
        }
    }

    /// The components of the texel R, G, B, A: luminance is R (section 6.1.4).
    pub fn select(self, rgba: [f64; 4], variant: Variant) -> [f64; 4] {
        let luminance = || {
            let is_sum = variant.has(Mutation::LuminanceIsSum);
            if is_sum { rgba[0] + rgba[1] + rgba[2] } else { rgba[0] }
        };
        let mut c = [0.0; 4];
        match self {
            Self::Colors(places) => {
                for (component, &place) in c.iter_mut().zip(places) {
                    *component = rgba[place];
                }
            }
            Self::Luminance => c[0] = luminance(),
            Self::LuminanceAlpha => (c[0], c[1]) = (luminance(), rgba[3]),
        }
        c
    }
}

/// How components are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// Unsigned integers of so many bits: `c / (2^b - 1)`.
    Unsigned(u32),
    /// Signed ones: `(2c + 1) / (2^b - 1)`.
    Signed(u32),
    /// Floats of 16 bits.
    Half,
    /// Floats of 32 bits.
    Single,
    /// All in one word of so many bytes, with these bits, the first component at the top.
    Packed(usize, &'static [u32]),
    /// The same, the first component at the bottom.
    Reversed(usize, &'static [u32]),
}

impl Element {
    /// Bytes of an element.
    pub fn size(self) -> usize {
        match self {
            Self::Unsigned(bits) | Self::Signed(bits) => bits as usize / 8,
            Self::Half => 2,
            Self::Single => 4,
            Self::Packed(bytes, _) | Self::Reversed(bytes, _) => bytes,
        }
    }

    /// Bytes of a pixel.
    pub fn pixel_bytes(self, components: Components) -> usize {
        match self {
            Self::Unsigned(_) | Self::Signed(_) | Self::Half | Self::Single => {
                self.size() * components.count()
            }
            Self::Packed(bytes, _) | Self::Reversed(bytes, _) => bytes,
        }
    }

    /// Whether the type goes with these components.
    pub fn fits(self, components: Components) -> bool {
        match self {
            Self::Unsigned(_) | Self::Signed(_) | Self::Half | Self::Single => true,
            Self::Packed(_, bits) | Self::Reversed(_, bits) => match components {
                // Three fields are R, G, B only; four are RGBA or BGRA (table 3.8).
                Components::Colors(places) if bits.len() == 3 => places == [0, 1, 2],
                Components::Colors(places) => places.len() == bits.len(),
                Components::Luminance | Components::LuminanceAlpha => false,
            },
        }
    }

    /// The integers of a pixel, `swapped` with their bytes in the other order than the machine's.
    fn words(self, pixel: &[u8], swapped: bool, variant: Variant) -> Vec<u32> {
        let swapped = swapped && !variant.has(Mutation::BytesNotSwapped);
        let word = |bytes: &[u8]| {
            let big = swapped != cfg!(target_endian = "big");
            bytes.iter().enumerate().fold(0u32, |word, (i, &byte)| {
                let place = if big { bytes.len() - 1 - i } else { i };
                word | u32::from(byte) << (8 * place)
            })
        };
        let words: Vec<u32> = pixel.chunks_exact(self.size()).map(word).collect();
        let split = |bits: &[u32], first_at_top: bool| {
            let total: u32 = bits.iter().sum();
            let mut below = 0;
            bits.iter()
                .map(|&b| {
                    let shift = if first_at_top { total - below - b } else { below };
                    below += b;
                    words[0] >> shift & ((1u64 << b) - 1) as u32
                })
                .collect()
        };
        let turned = variant.has(Mutation::PackedReversed);
        match self {
            Self::Packed(_, bits) => split(bits, !turned),
            Self::Reversed(_, bits) => split(bits, turned),
            Self::Unsigned(_) | Self::Signed(_) | Self::Half | Self::Single => words,
        }
    }

    /// The components of a pixel.
    pub fn unpack(self, pixel: &[u8], swapped: bool, variant: Variant) -> [f64; 4] {
        let mut c = [0.0; 4];
        for (i, word) in self.words(pixel, swapped, variant).into_iter().enumerate() {
            c[i] = match self {
                Self::Unsigned(bits) => f64::from(word) / (2f64.powi(bits as i32) - 1.0),
                Self::Signed(bits) => {
                    let number = f64::from((word << (32 - bits)) as i32 >> (32 - bits));
                    let whole = 2f64.powi(bits as i32) - 1.0;
                    if variant.has(Mutation::SignedWithoutHalf) {
                        2.0 * number / whole
                    } else {
                        (2.0 * number + 1.0) / whole
                    }
                }
                Self::Half => half(word),
                Self::Single => f64::from(f32::from_bits(word)),
                Self::Packed(_, bits) | Self::Reversed(_, bits) => {
                    f64::from(word) / ((1u64 << bits[i]) - 1) as f64
                }
            };
        }
        c
    }

    /// The integers of a pixel as they are, signs too.
    pub fn codes(self, pixel: &[u8], swapped: bool) -> [f64; 4] {
        let mut c = [0.0; 4];
        for (i, word) in self.words(pixel, swapped, Variant::CORRECT).into_iter().enumerate() {
            c[i] = match self {
                Self::Signed(bits) => f64::from((word << (32 - bits)) as i32 >> (32 - bits)),
                _ => f64::from(word),
            };
        }
        c
    }

    /// The real numbers that the integers of these components are rounded from (section 4.3.2,
    /// table 4.7), within the range of their codes.
    pub fn ideal_codes(self, c: [f64; 4], count: usize) -> [f64; 4] {
        let mut out = [0.0; 4];
        for (i, value) in c.into_iter().enumerate().take(count) {
            out[i] = match self {
                Self::Signed(bits) => {
                    let whole = 2f64.powi(bits as i32) - 1.0;
                    (whole * value.clamp(-1.0, 1.0) - 1.0) / 2.0
                }
                Self::Unsigned(bits) => value.clamp(0.0, 1.0) * (2f64.powi(bits as i32) - 1.0),
                Self::Packed(_, bits) | Self::Reversed(_, bits) => {
                    value.clamp(0.0, 1.0) * ((1u64 << bits[i]) - 1) as f64
                }
                Self::Half | Self::Single => value,
            };
        }
        out
    }
}

/// A float of 16 bits: sign, 5 bits of exponent, 10 of mantissa (section 2.1.2).
fn half(word: u32) -> f64 {
    let sign = if word & 0x8000 == 0 { 1.0 } else { -1.0 };
    let (exponent, mantissa) = ((word >> 10 & 31) as i32, f64::from(word & 0x3ff));
    sign * match exponent {
        0 => mantissa * 2f64.powi(-24),
        31 if mantissa == 0.0 => f64::INFINITY,
        31 => f64::NAN,
        e => (1.0 + mantissa / 1024.0) * 2f64.powi(e - 15),
    }
}

/// `GL_UNPACK_*` or `GL_PACK_*`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Store {
    /// 1, 2, 4 or 8.
    pub alignment: usize,
    /// Pixels in a row, or 0 for the width.
    pub row_length: usize,
    /// Rows in an image, or 0 for the height.
    pub image_height: usize,
    /// Pixels, rows, images that are skipped.
    pub skip: [usize; 3],
}

impl Store {
    /// Where pixel (x, y, z) of an image begins, in bytes: rows are
    /// `k = n·l` elements apart where the element is not smaller than the alignment `a`, else
    /// `k = (a/s)·ceil(s·n·l/a)` (section 3.6.4).
    pub fn place(
        &self,
        [x, y, z]: [usize; 3],
        [width, height]: [usize; 2],
        element: usize,
        pixel: usize,
        variant: Variant,
    ) -> usize {
        let length = |set: usize, of: usize| if set > 0 { set } else { of };
        let l = length(
            if variant.has(Mutation::RowLengthIgnored) { 0 } else { self.row_length },
            width,
        );
        let rows = length(
            if variant.has(Mutation::ImageHeightIgnored) { 0 } else { self.image_height },
            height,
        );
        let aligned = element < self.alignment && !variant.has(Mutation::AlignmentIgnored);
        let row = if aligned { (pixel * l).next_multiple_of(self.alignment) } else { pixel * l };
        let skip = if variant.has(Mutation::SkipsIgnored) { [0; 3] } else { self.skip };
        (z + skip[2]) * rows * row + (y + skip[1]) * row + (x + skip[0]) * pixel
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn packed_pixels_by_hand() {
        let top = Element::Packed(2, &[5, 6, 5]);
        let red = 0xf800u16.to_le_bytes();
        assert_eq!(top.unpack(&red, false, TRUE), [1.0, 0.0, 0.0, 0.0]);
        let bottom = Element::Reversed(2, &[5, 6, 5]);
        assert_eq!(bottom.unpack(&red, false, TRUE), [0.0, 0.0, 1.0, 0.0]);
        assert_eq!(top.unpack(&0xf8u16.to_le_bytes(), true, TRUE), [1.0, 0.0, 0.0, 0.0]);
    }

    #[test]
    fn rows_are_padded() {
        let store = Store { alignment: 4, row_length: 0, image_height: 0, skip: [1, 1, 0] };
        assert_eq!(store.place([0, 0, 0], [3, 2], 1, 3, TRUE), 12 + 3);
        assert_eq!(store.place([0, 0, 1], [3, 2], 1, 3, TRUE), 24 + 12 + 3);
        assert_eq!(half(0x3c00), 1.0);
    }
}
