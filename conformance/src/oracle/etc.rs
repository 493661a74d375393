//! Blocks of ETC2 colours (OpenGL ES 3.0, appendix C), decoded texel by texel in integers with the formulas of its text.
//!
//! A block is a word of 64 bits, the first byte the most significant; the texels a to p run down the columns.

use crate::mutation::{Mutation, Variant};

/// How a block codes its texels (appendix C.1.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the specification's names")]
pub enum Mode {
    Individual,
    Differential,
    T,
    H,
    Planar,
}

impl Mode {
    /// All.
    pub const ALL: [Self; 5] =
        [Self::Individual, Self::Differential, Self::T, Self::H, Self::Planar];
}

/// Whether a block can have transparent texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Alpha {
    /// RGB8: bit 33 tells the individual mode from the others.
    None,
    /// RGB8A1: bit 33 says that all texels are opaque; there is no individual mode.
    Punchthrough,
}

/// What bit 33 of a block of RGB8A1 says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Opacity {
    /// All texels are opaque.
    Opaque,
    /// Those with index 2 are not, and index 0 has no modifier.
    Mixed,
}

/// A block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block(u64);

impl Block {
    /// The block of eight bytes.
    pub fn new(bytes: &[u8]) -> Self {
        Self(bytes.iter().take(8).fold(0, |word, &byte| word << 8 | u64::from(byte)))
    }

    /// Bits `high` to `low`.
    fn bits(self, high: u32, low: u32) -> i32 {
        (self.0 >> low & ((1 << (high - low + 1)) - 1)) as i32
    }

    /// Bits `high` to `low` in two's complement.
    fn signed(self, high: u32, low: u32) -> i32 {
        let width = high - low + 1;
        let value = self.bits(high, low);
        if value >> (width - 1) == 1 { value - (1 << width) } else { value }
    }

    /// The mode: the sums of the differential colours decide, red first, then green, then blue.
    pub fn mode(self, alpha: Alpha, variant: Variant) -> Mode {
        if alpha == Alpha::None && self.bits(33, 33) == 0 {
            return Mode::Individual;
        }
        let is_out = |high: u32| {
            let sum = self.bits(high, high - 4) + self.signed(high - 5, high - 7);
            !(0..=31).contains(&sum)
        };
        let [red, green, blue] = [is_out(63), is_out(55), is_out(47)];
        let modes = if variant.has(Mutation::EtcModesSwapped) {
            [Mode::H, Mode::T]
        } else {
            [Mode::T, Mode::H]
        };
        match (red, green, blue) {
            (true, ..) => modes[0],
            (false, true, _) => modes[1],
            (false, false, true) => Mode::Planar,
            (false, false, false) => Mode::Differential,
        }
    }

    /// R, G, B, A of the texel in column `x` of row `y`, as bytes.
    pub fn decode(self, alpha: Alpha, [x, y]: [usize; 2], variant: Variant) -> [u8; 4] {
        let [x, y] = if variant.has(Mutation::EtcRowsFirst) { [y, x] } else { [x, y] };
        let number = (4 * x + y) as u32;
        // The most significant bits of the 16 indices come first.
        let code = 2 * self.bits(16 + number, 16 + number) + self.bits(number, number);
        let opaque = alpha == Alpha::None
            || self.bits(33, 33) == 1
            || variant.has(Mutation::EtcOpaqueBitIgnored);
        let opacity = if opaque { Opacity::Opaque } else { Opacity::Mixed };
        let mode = self.mode(alpha, variant);
        if opacity == Opacity::Mixed && code == 2 && mode != Mode::Planar {
            return [0; 4];
        }
        let color = match mode {
            Mode::Individual | Mode::Differential => {
                self.subblock(mode, code, [x, y], opacity, variant)
            }
            Mode::T => self.t(code, variant),
            Mode::H => self.h(code, variant),
            Mode::Planar => self.planar([x as i32, y as i32], variant),
        };
        let [r, g, b] = color.map(|c| c.clamp(0, 255) as u8);
        [r, g, b, 255]
    }

    /// Two halves, each with one colour and a table of modifiers for all three channels.
    fn subblock(
        self,
        mode: Mode,
        code: i32,
        [x, y]: [usize; 2],
        opacity: Opacity,
        variant: Variant,
    ) -> [i32; 3] {
        let flipped = (self.bits(32, 32) == 1) != variant.has(Mutation::EtcFlipIgnored);
        let second = if flipped { y >= 2 } else { x >= 2 };
        let color = [63, 55, 47].map(|high: u32| match (mode, second) {
            (Mode::Individual, false) => extend(self.bits(high, high - 3), 4),
            (Mode::Individual, true) => extend(self.bits(high - 4, high - 7), 4),
            (_, false) => extend(self.bits(high, high - 4), 5),
            (_, true) => extend(self.bits(high, high - 4) + self.signed(high - 5, high - 7), 5),
        });
        let table = if second { self.bits(36, 34) } else { self.bits(39, 37) } as usize;
        let [small, large] = MODIFIERS[table];
        let modifier = match (code, opacity) {
            (0, Opacity::Opaque) => small,
            (0, Opacity::Mixed) => 0,
            (1, _) => large,
            (2, _) => -small,
            (_, _) => -large,
        };
        color.map(|c| c + modifier)
    }

    /// One colour, and three on a line through another.
    fn t(self, code: i32, variant: Variant) -> [i32; 3] {
        let first =
            [self.bits(60, 59) << 2 | self.bits(57, 56), self.bits(55, 52), self.bits(51, 48)];
        let second = [self.bits(47, 44), self.bits(43, 40), self.bits(39, 36)];
        let d = distance(self.bits(35, 34) << 1 | self.bits(32, 32), variant);
        let [first, second] = [first, second].map(|color| color.map(|c| extend(c, 4)));
        match code {
            0 => first,
            1 => second.map(|c| c + d),
            2 => second,
            _ => second.map(|c| c - d),
        }
    }

    /// Two on a line through each of two colours, whose order is a bit of the distance.
    fn h(self, code: i32, variant: Variant) -> [i32; 3] {
        let first = [
            self.bits(62, 59),
            self.bits(58, 56) << 1 | self.bits(52, 52),
            self.bits(51, 51) << 3 | self.bits(49, 47),
        ];
        let second = [self.bits(46, 43), self.bits(42, 39), self.bits(38, 35)];
        let [first, second] = [first, second].map(|color| color.map(|c| extend(c, 4)));
        let value = |[r, g, b]: [i32; 3]| r << 16 | g << 8 | b;
        let order = if variant.has(Mutation::EtcOrderIgnored) {
            0
        } else {
            i32::from(value(first) >= value(second))
        };
        let d = distance(self.bits(34, 34) << 2 | self.bits(32, 32) << 1 | order, variant);
        match code {
            0 => first.map(|c| c + d),
            1 => first.map(|c| c - d),
            2 => second.map(|c| c + d),
            _ => second.map(|c| c - d),
        }
    }

    /// A plane through the colours at the origin, at x = 4 and at y = 4.
    fn planar(self, [x, y]: [i32; 2], variant: Variant) -> [i32; 3] {
        let origin = [
            extend(self.bits(62, 57), 6),
            extend(self.bits(56, 56) << 6 | self.bits(54, 49), 7),
            extend(self.bits(48, 48) << 5 | self.bits(44, 43) << 3 | self.bits(41, 39), 6),
        ];
        let across = [
            extend(self.bits(38, 34) << 1 | self.bits(32, 32), 6),
            extend(self.bits(31, 25), 7),
            extend(self.bits(24, 19), 6),
        ];
        let down =
            [extend(self.bits(18, 13), 6), extend(self.bits(12, 6), 7), extend(self.bits(5, 0), 6)];
        let rounding = if variant.has(Mutation::EtcPlanarTruncates) { 0 } else { 2 };
        std::array::from_fn(|i| {
            let (o, h, v) = (origin[i], across[i], down[i]);
            (x * (h - o) + y * (v - o) + 4 * o + rounding) >> 2
        })
    }
}

/// Codewords of `width` bits as bytes: the first bits are repeated below the last.
fn extend(code: i32, width: u32) -> i32 {
    code << (8 - width) | code >> (2 * width - 8)
}

/// The distances of the T and H modes.
fn distance(index: i32, variant: Variant) -> i32 {
    let index = if variant.has(Mutation::EtcDistanceOff) { (index + 1) % 8 } else { index };
    [3, 6, 11, 16, 23, 32, 41, 64][index as usize]
}

/// The smaller and the larger modifier of each codeword.
const MODIFIERS: [[i32; 2]; 8] =
    [[2, 8], [5, 17], [9, 29], [13, 42], [18, 60], [24, 80], [33, 106], [47, 183]];

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;

    fn block(word: u64) -> Block {
        Block::new(&word.to_be_bytes())
    }

    #[test]
    fn halves_by_hand() {
        // Individual: red 1 and 15 of 15, table 0 and 7, side by side; all indices 0.
        let individual = block(0x1f00_0000 << 32 | 7 << 34);
        assert_eq!(individual.mode(Alpha::None, TRUE), Mode::Individual);
        assert_eq!(individual.decode(Alpha::None, [1, 3], TRUE), [17 + 2, 2, 2, 255]);
        assert_eq!(individual.decode(Alpha::None, [2, 0], TRUE), [255, 47, 47, 255]);
        // Differential: red 16 - 4, one above the other; index 3 for texel b, down the first column.
        let differential = block(0x8400_0000 << 32 | 3 << 32 | 1 << 17 | 1 << 1);
        assert_eq!(differential.mode(Alpha::None, TRUE), Mode::Differential);
        assert_eq!(differential.decode(Alpha::None, [0, 1], TRUE), [132 - 8, 0, 0, 255]);
        assert_eq!(differential.decode(Alpha::None, [0, 2], TRUE), [99 + 2, 2, 2, 255]);
    }

    #[test]
    fn the_sums_choose_the_mode() {
        // Red 31 + 1, green 31 + 1, blue 31 + 1 with the others in range.
        for (high, mode) in [(63, Mode::T), (55, Mode::H), (47, Mode::Planar)] {
            let word = (31_u64 << 3 | 1) << (high - 7) | 1 << 33;
            assert_eq!(block(word).mode(Alpha::None, TRUE), mode);
        }
    }

    #[test]
    fn planes_by_hand() {
        // Blue is 31 + 1, so that BO2 is 3 and BO3 is 2; all other fields are 0.
        let word = (31_u64 << 3 | 1) << 40 | 1 << 33;
        let plane = block(word);
        assert_eq!(plane.mode(Alpha::None, TRUE), Mode::Planar);
        let origin = 26 << 2 | 1;
        let expected = [4, 3, 2, 1].map(|left: i32| ((left * origin + 2) >> 2) as u8);
        let got = [0, 1, 2, 3].map(|x| plane.decode(Alpha::None, [x, 0], TRUE)[2]);
        assert_eq!(got, expected);
    }

    #[test]
    fn index_2_is_transparent_where_a_block_is_not_opaque() {
        let word = 0x8000_0000_u64 << 32 | 1 << 16;
        assert_eq!(block(word).decode(Alpha::Punchthrough, [0, 0], TRUE), [0; 4]);
        assert_eq!(block(word).decode(Alpha::Punchthrough, [0, 1], TRUE), [132, 0, 0, 255]);
        let opaque = block(word | 1 << 33);
        assert_eq!(opaque.decode(Alpha::Punchthrough, [0, 0], TRUE), [130, 0, 0, 255]);
    }
}
