//! Scalars of the IR as Rust types, and the helpers of the operations.

use super::types::{TRUE, Ty};
use texunit::lanes::{LANES, U32s};

/// A scalar of the IR as a Rust type.
pub(super) trait Scalar: Copy {
    const TY: Ty;
    fn from_word(word: u32) -> Self;
    fn to_word(self) -> u32;
    /// The type of a lane.
    #[inline(always)]
    fn of_lane(words: &U32s, lane: usize) -> Self {
        Self::from_word(words[lane])
    }
}

impl Scalar for f32 {
    const TY: Ty = Ty::F32;
    #[inline(always)]
    fn from_word(word: u32) -> Self {
        Self::from_bits(word)
    }
    #[inline(always)]
    fn to_word(self) -> u32 {
        self.to_bits()
    }
    /// Loaded as a float: LLVM chooses between words that were loaded as integers by their bits, and
    /// then sees no minimum or maximum.
    #[inline(always)]
    fn of_lane(words: &U32s, lane: usize) -> Self {
        words.as_f32()[lane]
    }
}

impl Scalar for i32 {
    const TY: Ty = Ty::I32;
    #[inline(always)]
    fn from_word(word: u32) -> Self {
        word as Self
    }
    #[inline(always)]
    fn to_word(self) -> u32 {
        self as u32
    }
}

impl Scalar for u32 {
    const TY: Ty = Ty::U32;
    #[inline(always)]
    fn from_word(word: u32) -> Self {
        word
    }
    #[inline(always)]
    fn to_word(self) -> u32 {
        self
    }
}

impl Scalar for bool {
    const TY: Ty = Ty::Bool;
    #[inline(always)]
    fn from_word(word: u32) -> Self {
        word != 0
    }
    #[inline(always)]
    fn to_word(self) -> u32 {
        if self { TRUE } else { 0 }
    }
}

/// Integer division that is total: all ones for a zero divisor; `MIN / -1` wraps.
#[inline(always)]
pub(super) fn div_i32(a: i32, b: i32) -> i32 {
    if b == 0 { -1 } else { a.wrapping_div(b) }
}

#[inline(always)]
pub(super) fn rem_i32(a: i32, b: i32) -> i32 {
    if b == 0 { -1 } else { a.wrapping_rem(b) }
}

#[inline(always)]
pub(super) fn div_u32(a: u32, b: u32) -> u32 {
    a.checked_div(b).unwrap_or(u32::MAX)
}

#[inline(always)]
pub(super) fn rem_u32(a: u32, b: u32) -> u32 {
    a.checked_rem(b).unwrap_or(u32::MAX)
}

/// `b` where `a` is true, else `c`, by bits: both are always loaded, so that no branch remains.
#[inline(always)]
pub(super) fn select<T: Scalar>(a: bool, b: T, c: T) -> T {
    let mask = a.to_word();
    T::from_word((b.to_word() & mask) | (c.to_word() & !mask))
}

/// From this cost on, lanes that all hold the same words are looked for and computed once.
pub(super) const LONG: u32 = 40;

/// Whether every lane holds the same word.
#[inline(always)]
pub(super) fn agree(words: &U32s) -> bool {
    if words[0] != words[LANES - 1] {
        return false;
    }
    let mut differing = 0;
    for lane in 0..LANES {
        differing |= words[lane] ^ words[0];
    }
    differing == 0
}
