//! Eight or six values on the line between two bytes: the alpha of DXT5, and RGTC.

use super::quotient::{quotient, reciprocal};

/// What the two bytes are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Signedness {
    /// 0 to 255.
    Unsigned,
    /// -127 to 127; -128 counts as -127.
    Signed,
}

impl Signedness {
    /// The numbers that stand for the ends of the range.
    #[inline(always)]
    pub const fn range(self) -> [i32; 2] {
        match self {
            Self::Unsigned => [0, 255],
            Self::Signed => [-127, 127],
        }
    }
}

/// The weights of the first and second end, a hexadecimal digit per code: in sevenths where the
/// first is the larger, else in fifths.
const EIGHT: [u32; 2] = [0x1234_5607, 0x6543_2170];
const SIX: [u32; 2] = [0x0012_3405, 0x0043_2150];

/// What the weights of a line's ends add up to: fifths and sevenths of the largest number.
#[inline(always)]
const fn wholes(signedness: Signedness) -> [[f32; 2]; 2] {
    const WHOLES: [[[f32; 2]; 2]; 2] =
        [[reciprocal(5 * 255), reciprocal(7 * 255)], [reciprocal(5 * 127), reciprocal(7 * 127)]];
    match signedness {
        Signedness::Unsigned => WHOLES[0],
        Signedness::Signed => WHOLES[1],
    }
}

/// A texel's value. The two bytes are the lowest of `low`; 16 codes of 3 bits follow.
#[inline(always)]
pub(crate) fn decode(low: u32, high: u32, at: u32, signedness: Signedness) -> f32 {
    let [smallest, largest] = signedness.range();
    // Which palette it is, the bytes as they are decide; values are clamped after that.
    let [first, second] = match signedness {
        Signedness::Unsigned => [(low & 0xFF) as i32, (low >> 8 & 0xFF) as i32],
        Signedness::Signed => [(low << 24) as i32 >> 24, (low << 16) as i32 >> 24],
    };
    let eight = first > second;
    let first = if first < smallest { smallest } else { first };
    let second = if second < smallest { smallest } else { second };
    // Of either half of the texels, the codes fit one word.
    let codes = if at < 8 { low >> 16 | high << 16 } else { high >> 8 };
    let code = codes >> (3 * (at & 7)) & 7;
    let a = (if eight { EIGHT[0] } else { SIX[0] }) >> (4 * code) & 15;
    let b = (if eight { EIGHT[1] } else { SIX[1] }) >> (4 * code) & 15;
    let mean = a as i32 * first + b as i32 * second;
    let end = if code == 6 { 5 * smallest } else { 5 * largest };
    let is_end = !eight & (code >= 6);
    let [five, seven] = wholes(signedness);
    let whole = if eight { seven } else { five };
    quotient((if is_end { end } else { mean }) as f32, whole)
}
