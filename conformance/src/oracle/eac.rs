//! Blocks of EAC (OpenGL ES 3.0, appendix C.1.3, C.1.5 to C.1.8): one number for each of 4×4 texels, as alpha or as a
//! channel of 11 bits.

use crate::mutation::{Mutation, Variant};

/// What the numbers are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numbers {
    /// The alpha of RGBA8: 0 to 255.
    Alpha8,
    /// 0 to 2047, which is 1.
    Unsigned11,
    /// -1023 to 1023, which are -1 and 1.
    Signed11,
}

/// Modifiers, by the codeword of the table and the index of the texel.
const MODIFIERS: [[i32; 8]; 16] = [
    [-3, -6, -9, -15, 2, 5, 8, 14],
    [-3, -7, -10, -13, 2, 6, 9, 12],
    [-2, -5, -8, -13, 1, 4, 7, 12],
    [-2, -4, -6, -13, 1, 3, 5, 12],
    [-3, -6, -8, -12, 2, 5, 7, 11],
    [-3, -7, -9, -11, 2, 6, 8, 10],
    [-4, -7, -8, -11, 3, 6, 7, 10],
    [-3, -5, -8, -11, 2, 4, 7, 10],
    [-2, -6, -8, -10, 1, 5, 7, 9],
    [-2, -5, -8, -10, 1, 4, 7, 9],
    [-2, -4, -8, -10, 1, 3, 7, 9],
    [-2, -5, -7, -10, 1, 4, 6, 9],
    [-3, -4, -7, -10, 2, 3, 6, 9],
    [-1, -2, -3, -10, 0, 1, 2, 9],
    [-4, -6, -8, -9, 3, 5, 7, 8],
    [-3, -5, -7, -9, 2, 4, 6, 8],
];

/// The number of the texel in column `x` of row `y` of a block of eight bytes, as it is sampled.
pub fn decode(numbers: Numbers, block: &[u8], [x, y]: [usize; 2], variant: Variant) -> f64 {
    let indices = block[2..8].iter().fold(0u64, |word, &byte| word << 8 | u64::from(byte));
    let number = 4 * x + y;
    let index = (indices >> (45 - 3 * number) & 7) as usize;
    let multiplier = i32::from(block[1] >> 4);
    let table = if variant.has(Mutation::EacTableOff) {
        block[1].wrapping_add(1) & 15
    } else {
        block[1] & 15
    };
    let modifier = MODIFIERS[usize::from(table)][index];
    // A multiplier of 0 stands for an eighth in the formulas of 11 bits.
    let eighths = if multiplier == 0 && !variant.has(Mutation::EacMultiplierOfZero) {
        modifier
    } else {
        modifier * multiplier * 8
    };
    match numbers {
        Numbers::Alpha8 => {
            f64::from((i32::from(block[0]) + modifier * multiplier).clamp(0, 255)) / 255.0
        }
        Numbers::Unsigned11 => {
            let half = if variant.has(Mutation::EacWithoutFour) { 0 } else { 4 };
            f64::from((i32::from(block[0]) * 8 + half + eighths).clamp(0, 2047)) / 2047.0
        }
        Numbers::Signed11 => {
            let unclamped = i32::from(block[0] as i8);
            let base =
                if variant.has(Mutation::EacMinus128) { unclamped } else { unclamped.max(-127) };
            f64::from((base * 8 + eighths).clamp(-1023, 1023)) / 1023.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn numbers_by_hand() {
        // Base 100, multiplier 3, table 13; texel a has index 7 (9), b index 0 (-1).
        let block = [100, 0x3d, 0b1110_0000, 0, 0, 0, 0, 0];
        assert_eq!(decode(Numbers::Alpha8, &block, [0, 0], TRUE), 127.0 / 255.0);
        assert_eq!(decode(Numbers::Alpha8, &block, [0, 1], TRUE), 97.0 / 255.0);
        assert_eq!(decode(Numbers::Unsigned11, &block, [0, 0], TRUE), (804 + 216) as f64 / 2047.0);
        assert_eq!(decode(Numbers::Signed11, &block, [0, 1], TRUE), (800 - 24) as f64 / 1023.0);
    }

    #[test]
    fn no_multiplier_is_an_eighth_and_the_least_base_is_minus_127() {
        let block = [0x80, 0x0d, 0b1110_0000, 0, 0, 0, 0, 0];
        assert_eq!(decode(Numbers::Signed11, &block, [0, 0], TRUE), (-1016 + 9) as f64 / 1023.0);
        assert_eq!(decode(Numbers::Unsigned11, &block, [0, 0], TRUE), (1028 + 9) as f64 / 2047.0);
        assert_eq!(decode(Numbers::Alpha8, &block, [0, 0], TRUE), 128.0 / 255.0);
    }
}
