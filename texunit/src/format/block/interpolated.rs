//! Eight or six values on the line between two bytes: the alpha of DXT5, and RGTC.

/// What the two bytes are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ends {
    /// 0 to 255.
    Unsigned,
    /// -127 to 127; -128 counts as -127.
    Signed,
}

impl Ends {
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

/// A texel's value. The two bytes are the lowest of `low`; 16 codes of 3 bits follow.
#[inline(always)]
pub(super) fn decode(low: u32, high: u32, at: u32, ends: Ends) -> f32 {
    let [smallest, largest] = ends.range();
    // Which palette it is, the bytes as they are decide; values are clamped after that.
    let [first, second] = match ends {
        Ends::Unsigned => [(low & 0xFF) as i32, (low >> 8 & 0xFF) as i32],
        Ends::Signed => [i32::from(low as u8 as i8), i32::from((low >> 8) as u8 as i8)],
    };
    let eight = first > second;
    let first = if first < smallest { smallest } else { first };
    let second = if second < smallest { smallest } else { second };
    let both = u64::from(low) | u64::from(high) << 32;
    let code = (both >> (16 + 3 * at)) as u32 & 7;
    let a = (if eight { EIGHT[0] } else { SIX[0] }) >> (4 * code) & 15;
    let b = (if eight { EIGHT[1] } else { SIX[1] }) >> (4 * code) & 15;
    let mean = a as i32 * first + b as i32 * second;
    let end = if code == 6 { 5 * smallest } else { 5 * largest };
    let is_end = !eight & (code >= 6);
    let parts = if eight { 7 } else { 5 };
    (if is_end { end } else { mean }) as f32 / (parts * largest) as f32
}
