//! ETC2 and EAC (OpenGL ES 3.0, appendix C), and ETC1, which is a part of ETC2 (`OES_compressed_ETC1_RGB8_texture`): blocks
//! of 4 × 4 texels are decoded where an image is specified.
//!
//! A block of colours is a big-endian word of 64 bits; texels are numbered down the columns.

use crate::base::constants::*;
use crate::base::types::*;
use texunit::format::Format;

/// Texels of a side of a block.
pub(crate) const SIDE: u32 = 4;

/// What a block consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Coding {
    /// Colours without alpha.
    Rgb,
    /// Colours with one bit of alpha.
    Punchthrough,
    /// A block of alphas, then one of colours.
    Rgba,
    /// Blocks of 11-bit numbers, one for each channel.
    Eac(EacNumbers),
}

/// The 11-bit numbers of EAC.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum EacNumbers {
    /// From 0 to 2047, which is 1.
    Unsigned,
    /// From -1023 to 1023, which are -1 and 1.
    Signed,
}

/// A format of ETC2 or EAC.
#[derive(Debug)]
pub(crate) struct EtcFormat {
    pub name: GLenum,
    coding: Coding,
    /// What is stored. Numbers of 11 bits are floats: no format with fewer bits has their fractions.
    pub stored: Format,
    /// Bytes of a block.
    pub block: usize,
}

const fn row(name: GLenum, coding: Coding, stored: Format, block: usize) -> EtcFormat {
    EtcFormat { name, coding, stored, block }
}

/// Every format.
static FORMATS: [EtcFormat; 11] = {
    use Coding::{Eac, Punchthrough, Rgb, Rgba};
    use EacNumbers::{Signed, Unsigned};
    [
        row(GL_ETC1_RGB8_OES, Rgb, Format::Rgb8, 8),
        row(GL_COMPRESSED_RGB8_ETC2, Rgb, Format::Rgb8, 8),
        row(GL_COMPRESSED_SRGB8_ETC2, Rgb, Format::Srgb8, 8),
        row(GL_COMPRESSED_RGB8_PUNCHTHROUGH_ALPHA1_ETC2, Punchthrough, Format::Rgba8, 8),
        row(GL_COMPRESSED_SRGB8_PUNCHTHROUGH_ALPHA1_ETC2, Punchthrough, Format::Srgb8A8, 8),
        row(GL_COMPRESSED_RGBA8_ETC2_EAC, Rgba, Format::Rgba8, 16),
        row(GL_COMPRESSED_SRGB8_ALPHA8_ETC2_EAC, Rgba, Format::Srgb8A8, 16),
        row(GL_COMPRESSED_R11_EAC, Eac(Unsigned), Format::R32F, 8),
        row(GL_COMPRESSED_SIGNED_R11_EAC, Eac(Signed), Format::R32F, 8),
        row(GL_COMPRESSED_RG11_EAC, Eac(Unsigned), Format::Rg32F, 16),
        row(GL_COMPRESSED_SIGNED_RG11_EAC, Eac(Signed), Format::Rg32F, 16),
    ]
};

/// The format of a name.
pub(crate) fn find(name: GLenum) -> Option<&'static EtcFormat> {
    FORMATS.iter().find(|format| format.name == name)
}

/// The names of all formats.
pub(crate) fn names() -> impl Iterator<Item = GLenum> {
    FORMATS.iter().map(|format| format.name)
}

impl EtcFormat {
    /// The bytes of the blocks of so many texels.
    pub fn bytes(&self, [width, height, depth]: [u32; 3]) -> usize {
        let blocks = |side: u32| side.div_ceil(SIDE) as usize;
        blocks(width)
            .saturating_mul(blocks(height))
            .saturating_mul(depth as usize)
            .saturating_mul(self.block)
    }

    /// Decodes the blocks of a box of this size into texels of [`Self::stored`], tightly packed.
    pub fn decode(&self, [width, height, depth]: [u32; 3], blocks: &[u8], texels: &mut [u8]) {
        let bytes = self.stored.bytes();
        let across = width.div_ceil(SIDE) as usize;
        let slice_blocks = across * height.div_ceil(SIDE) as usize;
        let [width, height] = [width, height].map(|side| side as usize);
        for (number, block) in blocks.chunks_exact(self.block).enumerate() {
            let slice = number / slice_blocks;
            let (row, column) = (number % slice_blocks / across, number % across);
            if slice >= depth as usize {
                return;
            }
            let decoded = self.block_texels(block);
            for (at, texel) in decoded.iter().enumerate() {
                let (x, y) = (column * 4 + at / 4, row * 4 + at % 4);
                if x < width && y < height {
                    let start = ((slice * height + y) * width + x) * bytes;
                    texels[start..start + bytes].copy_from_slice(&texel[..bytes]);
                }
            }
        }
    }

    /// The bytes of the texels of a block, as they are stored.
    fn block_texels(&self, block: &[u8]) -> [[u8; 8]; 16] {
        let word = |at: usize| {
            let bytes = block[at..at + 8].iter();
            bytes.fold(0u64, |word, byte| word << 8 | u64::from(*byte))
        };
        let mut texels = [[0; 8]; 16];
        match self.coding {
            Coding::Rgb | Coding::Punchthrough => {
                let colors = colors(word(0), self.coding == Coding::Punchthrough);
                for (texel, color) in texels.iter_mut().zip(colors) {
                    texel[..4].copy_from_slice(&color);
                }
            }
            Coding::Rgba => {
                let alphas = eac(word(0), alpha);
                for (at, (texel, color)) in
                    texels.iter_mut().zip(colors(word(8), false)).enumerate()
                {
                    texel[..3].copy_from_slice(&color[..3]);
                    texel[3] = alphas[at] as u8;
                }
            }
            Coding::Eac(numbers) => {
                for channel in 0..self.block / 8 {
                    let values = match numbers {
                        EacNumbers::Unsigned => eac(word(channel * 8), unsigned_11),
                        EacNumbers::Signed => eac(word(channel * 8), signed_11),
                    };
                    let largest = match numbers {
                        EacNumbers::Unsigned => 2047.0,
                        EacNumbers::Signed => 1023.0,
                    };
                    for (texel, value) in texels.iter_mut().zip(values) {
                        let value = value as f32 / largest;
                        texel[channel * 4..channel * 4 + 4].copy_from_slice(&value.to_le_bytes());
                    }
                }
            }
        }
        texels
    }
}

/// Bits of a word, from bit `low` on.
fn bits(word: u64, low: u32, count: u32) -> i32 {
    (word >> low & ((1 << count) - 1)) as i32
}

/// More bits by repetition of the highest ones.
fn widen(value: i32, count: u32) -> i32 {
    value << (8 - count) | value >> (2 * count - 8)
}

fn byte(value: i32) -> u8 {
    value.clamp(0, 255) as u8
}

/// Table C.8: what is added to a base colour, for the two smaller indices; the others subtract it.
const MODIFIERS: [[i32; 2]; 8] =
    [[2, 8], [5, 17], [9, 29], [13, 42], [18, 60], [24, 80], [33, 106], [47, 183]];
/// Table C.11: the distances of the modes T and H.
const DISTANCES: [i32; 8] = [3, 6, 11, 16, 23, 32, 41, 64];

/// The colours of a block, with alpha.
fn colors(word: u64, punchthrough: bool) -> [[u8; 4]; 16] {
    let bit_33 = bits(word, 33, 1) == 1;
    // With one bit of alpha, blocks are never individual, and the bit says whether all texels are opaque.
    let (is_differential, is_opaque) = (bit_33 || punchthrough, bit_33 || !punchthrough);
    if is_differential {
        let sum = |low: u32| {
            let delta = bits(word, low, 3);
            bits(word, low + 3, 5) + if delta >= 4 { delta - 8 } else { delta }
        };
        let is_over = |low: u32| !(0..=31).contains(&sum(low));
        if is_over(56) {
            return painted(word, t_paints(word), is_opaque);
        }
        if is_over(48) {
            return painted(word, h_paints(word), is_opaque);
        }
        if is_over(40) {
            return planar(word);
        }
    }
    let bases: [[i32; 3]; 2] = if is_differential {
        let channels = [56, 48, 40];
        let first = channels.map(|low| bits(word, low + 3, 5));
        let second = channels.map(|low| {
            let delta = bits(word, low, 3);
            bits(word, low + 3, 5) + if delta >= 4 { delta - 8 } else { delta }
        });
        [first, second].map(|base| base.map(|channel| widen(channel, 5)))
    } else {
        let of = |low: u32| [16, 8, 0].map(|channel| widen(bits(word, low + channel, 4), 4));
        [of(44), of(40)]
    };
    let tables = [bits(word, 37, 3), bits(word, 34, 3)].map(|row| MODIFIERS[row as usize]);
    let is_flipped = bits(word, 32, 1) == 1;
    std::array::from_fn(|at| {
        let half = usize::from(if is_flipped { at % 4 >= 2 } else { at / 4 >= 2 });
        let [small, large] = tables[half];
        let modifier = match (index(word, at), is_opaque) {
            (0, true) => small,
            (0, false) => 0,
            (1, _) => large,
            (2, true) => -small,
            (2, false) => return [0; 4],
            (_, _) => -large,
        };
        let [r, g, b] = bases[half].map(|channel| byte(channel + modifier));
        [r, g, b, 255]
    })
}

/// The index of a texel.
fn index(word: u64, at: usize) -> u32 {
    ((word >> (16 + at) & 1) << 1 | word >> at & 1) as u32
}

/// Texels of four colours.
fn painted(word: u64, paints: [[i32; 3]; 4], is_opaque: bool) -> [[u8; 4]; 16] {
    std::array::from_fn(|at| {
        let index = index(word, at);
        if index == 2 && !is_opaque {
            return [0; 4];
        }
        let [r, g, b] = paints[index as usize].map(byte);
        [r, g, b, 255]
    })
}

/// The colours of the mode T: one, and three in a line.
fn t_paints(word: u64) -> [[i32; 3]; 4] {
    let red = bits(word, 59, 2) << 2 | bits(word, 56, 2);
    let first = [red, bits(word, 52, 4), bits(word, 48, 4)].map(|channel| widen(channel, 4));
    let second = [44, 40, 36].map(|low| widen(bits(word, low, 4), 4));
    let distance = DISTANCES[(bits(word, 34, 2) << 1 | bits(word, 32, 1)) as usize];
    let add = |distance: i32| second.map(|channel| channel + distance);
    [first, add(distance), second, add(-distance)]
}

/// The colours of the mode H: two on each side of two.
fn h_paints(word: u64) -> [[i32; 3]; 4] {
    let green = bits(word, 56, 3) << 1 | bits(word, 52, 1);
    let blue = bits(word, 51, 1) << 3 | bits(word, 47, 3);
    let first = [bits(word, 59, 4), green, blue];
    let second = [43, 39, 35].map(|low| bits(word, low, 4));
    // The order of the colours is a bit of the distance.
    let order = i32::from(first >= second);
    let distance = DISTANCES[(bits(word, 34, 1) << 2 | bits(word, 32, 1) << 1 | order) as usize];
    let add = |color: [i32; 3], distance: i32| color.map(|channel| widen(channel, 4) + distance);
    [add(first, distance), add(first, -distance), add(second, distance), add(second, -distance)]
}

/// A plane through the colours of three corners.
fn planar(word: u64) -> [[u8; 4]; 16] {
    let green = bits(word, 56, 1) << 6 | bits(word, 49, 6);
    let blue = bits(word, 48, 1) << 5 | bits(word, 43, 2) << 3 | bits(word, 39, 3);
    let rgb = |[r, g, b]: [i32; 3]| [widen(r, 6), widen(g, 7), widen(b, 6)];
    let origin = rgb([bits(word, 57, 6), green, blue]);
    let red = bits(word, 34, 5) << 1 | bits(word, 32, 1);
    let right = rgb([red, bits(word, 25, 7), bits(word, 19, 6)]);
    let below = rgb([bits(word, 13, 6), bits(word, 6, 7), bits(word, 0, 6)]);
    std::array::from_fn(|at| {
        let (x, y) = ((at / 4) as i32, (at % 4) as i32);
        let channel = |c: usize| {
            let (o, h, v) = (origin[c], right[c], below[c]);
            byte((x * (h - o) + y * (v - o) + 4 * o + 2) >> 2)
        };
        [channel(0), channel(1), channel(2), 255]
    })
}

/// Table C.13.
#[rustfmt::skip]
const EAC_MODIFIERS: [[i32; 8]; 16] = [
    [-3, -6,  -9, -15, 2, 5, 8, 14], [-3, -7, -10, -13, 2, 6, 9, 12],
    [-2, -5,  -8, -13, 1, 4, 7, 12], [-2, -4,  -6, -13, 1, 3, 5, 12],
    [-3, -6,  -8, -12, 2, 5, 7, 11], [-3, -7,  -9, -11, 2, 6, 8, 10],
    [-4, -7,  -8, -11, 3, 6, 7, 10], [-3, -5,  -8, -11, 2, 4, 7, 10],
    [-2, -6,  -8, -10, 1, 5, 7,  9], [-2, -5,  -8, -10, 1, 4, 7,  9],
    [-2, -4,  -8, -10, 1, 3, 7,  9], [-2, -5,  -7, -10, 1, 4, 6,  9],
    [-3, -4,  -7, -10, 2, 3, 6,  9], [-1, -2,  -3, -10, 0, 1, 2,  9],
    [-4, -6,  -8,  -9, 3, 5, 7,  8], [-3, -5,  -7,  -9, 2, 4, 6,  8],
];

/// The numbers of a block: `value` of its base, a modifier and the multiplier.
fn eac(word: u64, value: fn(i32, i32, i32) -> i32) -> [i32; 16] {
    let (base, multiplier) = (bits(word, 56, 8), bits(word, 52, 4));
    let modifiers = EAC_MODIFIERS[bits(word, 48, 4) as usize];
    std::array::from_fn(|at| {
        let index = bits(word, 45 - 3 * at as u32, 3) as usize;
        value(base, modifiers[index], multiplier)
    })
}

fn alpha(base: i32, modifier: i32, multiplier: i32) -> i32 {
    (base + modifier * multiplier).clamp(0, 255)
}

/// Eight times the product; of a multiplier of 0, the modifier.
fn product_11(modifier: i32, multiplier: i32) -> i32 {
    if multiplier == 0 { modifier } else { modifier * multiplier * 8 }
}

fn unsigned_11(base: i32, modifier: i32, multiplier: i32) -> i32 {
    (base * 8 + 4 + product_11(modifier, multiplier)).clamp(0, 2047)
}

/// The base is a signed byte, of which -128 counts as -127.
fn signed_11(base: i32, modifier: i32, multiplier: i32) -> i32 {
    let base = if base >= 128 { base - 256 } else { base }.max(-127);
    (base * 8 + product_11(modifier, multiplier)).clamp(-1023, 1023)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded(name: GLenum, block: &[u8]) -> [[u8; 8]; 16] {
        find(name).expect("a row").block_texels(block)
    }

    /// Individual mode: 4 bits a channel, both halves by their own row of table C.8.
    #[test]
    fn individual_blocks_have_two_colours() {
        // R1 = 8, R2 = 1; G1 = 4, G2 = 2; B1 = 0, B2 = 15; rows 0 and 7; columns; indices all 0.
        let block = [0x81, 0x42, 0x0f, 0b0001_1100, 0, 0, 0, 0];
        let texels = decoded(GL_COMPRESSED_RGB8_ETC2, &block);
        assert_eq!(texels[0][..4], [0x88 + 2, 0x44 + 2, 2, 255]);
        assert_eq!(texels[15][..4], [0x11 + 47, 0x22 + 47, 255, 255]);
    }

    /// Differential mode: the second colour by deltas of 3 bits; flipped halves; index 3 subtracts the larger modifier.
    #[test]
    fn differential_blocks_have_a_colour_and_a_difference() {
        // R = 16, dR = -1; G = 8, dG = 3; B = 31, dB = 0; rows 1 and 2; all indices 3.
        let block = [16 << 3 | 7, 8 << 3 | 3, 31 << 3, 0b0010_1011, 255, 255, 255, 255];
        let texels = decoded(GL_ETC1_RGB8_OES, &block);
        let wide = |v: i32| v << 3 | v >> 2;
        let expected = |r: i32, g: i32, b: i32, m: i32| {
            [wide(r) - m, wide(g) - m, wide(b) - m].map(|c| c.clamp(0, 255) as u8)
        };
        assert_eq!(texels[0][..3], expected(16, 8, 31, 17));
        assert_eq!(texels[3][..3], expected(15, 11, 31, 29));
    }

    /// A red sum below 0 is the mode T, one of green the mode H, one of blue the plane.
    #[test]
    fn sums_beyond_five_bits_choose_the_modes() {
        // T: R1 = 0b0001 from bits 60..59 = 0, 57..56 = 1; R = 0 with delta 0b101 = -3.
        let t = [0b0000_0101, 0x23, 0x45, 0b0110_1011, 0, 0, 0, 0];
        let texels = decoded(GL_COMPRESSED_RGB8_ETC2, &t);
        assert_eq!(texels[0][..3], [0x11, 0x22, 0x33]);
        let t = [0b0000_0101, 0x23, 0x45, 0b0110_1011, 0, 0, 255, 255];
        // Distance 0b10 << 1 | 1 = 5, which is 32, added to 0x44, 0x55, 0x66.
        let texels = decoded(GL_COMPRESSED_RGB8_ETC2, &t);
        assert_eq!(texels[0][..3], [0x44 + 32, 0x55 + 32, 0x66 + 32]);
        // H: red fits (R = 0, delta 0), green is 0 with delta -4.
        let h = [0b0000_0000, 0b0000_0100, 0b0000_0000, 0b0000_0010, 0, 0, 0, 0];
        // Both colours are 0 or nearly: R1 = 0, G1 = 0, B1 = 0; equal colours set the lowest bit: distance 6.
        let texels = decoded(GL_COMPRESSED_RGB8_ETC2, &h);
        assert_eq!(texels[0][..3], [6, 6, 6]);
        // Planar: blue is 0 with delta -4; O = 0, H has red 63, V nothing.
        let planar = [0, 0, 0b0000_0100, 0b0111_1111, 0, 0, 0, 0];
        let texels = decoded(GL_COMPRESSED_RGB8_ETC2, &planar);
        let red = |x: usize| texels[x * 4][0];
        assert_eq!([red(0), red(1), red(2), red(3)], [0, 64, 128, 191]);
    }

    #[test]
    fn punchthrough_blocks_have_holes_where_they_are_not_opaque() {
        // Differential without the bit: index 2 is a hole, index 0 the base colour.
        let block = [16 << 3, 16 << 3, 16 << 3, 0, 255, 255, 0, 0];
        let texels = decoded(GL_COMPRESSED_RGB8_PUNCHTHROUGH_ALPHA1_ETC2, &block);
        assert_eq!(texels[0][..4], [0; 4]);
        let block = [16 << 3, 16 << 3, 16 << 3, 0, 0, 0, 0, 0];
        let texels = decoded(GL_COMPRESSED_RGB8_PUNCHTHROUGH_ALPHA1_ETC2, &block);
        assert_eq!(texels[0][..4], [132, 132, 132, 255]);
    }

    #[test]
    fn alphas_and_11_bit_numbers_are_a_base_and_a_product() {
        // Base 100, multiplier 2, row 0, all indices 0: 100 - 3 · 2.
        let mut block = [0; 16];
        block[..2].copy_from_slice(&[100, 0x20]);
        assert_eq!(decoded(GL_COMPRESSED_RGBA8_ETC2_EAC, &block)[5][3], 94);
        let red = |name, block: [u8; 8]| {
            let texel = decoded(name, &block)[0];
            f32::from_le_bytes([texel[0], texel[1], texel[2], texel[3]])
        };
        let block = [100, 0x20, 0, 0, 0, 0, 0, 0];
        assert_eq!(red(GL_COMPRESSED_R11_EAC, block), (804.0 - 48.0) / 2047.0);
        assert_eq!(red(GL_COMPRESSED_SIGNED_R11_EAC, block), (800.0 - 48.0) / 1023.0);
        // A multiplier of 0 adds the modifier itself.
        assert_eq!(red(GL_COMPRESSED_R11_EAC, [100, 0, 0, 0, 0, 0, 0, 0]), 801.0 / 2047.0);
        assert_eq!(red(GL_COMPRESSED_SIGNED_R11_EAC, [128, 0xf0, 0, 0, 0, 0, 0, 0]), -1.0);
    }

    #[test]
    fn blocks_at_the_edge_are_cut() {
        let format = find(GL_COMPRESSED_RGB8_ETC2).expect("a row");
        assert_eq!(format.bytes([5, 3, 2]), 2 * 2 * 8);
        let mut texels = vec![0; 5 * 3 * 2 * format.stored.bytes()];
        format.decode([5, 3, 2], &[0; 32], &mut texels);
        assert!(texels.iter().all(|byte| [2, 255].contains(byte)), "every texel was written");
    }
}
