//! Addresses and weights of rows as integers.

use crate::lanes::Simd;
use crate::lanes::math::to_i32;

/// The most rows of a level; only levels finer than that of λ would have more.
pub const MAX_ROWS: f32 = 48.0;

/// 1.5 · 2^23: its sum with a small number holds the nearest integer in its low bits.
const MAGIC: f32 = 12_582_912.0;

/// `x · one`, to the nearest integer, of two the even one. For results below 2^22.
#[inline(always)]
pub fn to_fixed(x: f32, one: i32) -> i32 {
    (x * one as f32 + MAGIC).to_bits().wrapping_sub(MAGIC.to_bits()) as i32
}

/// The same for results below 2^31.
#[inline(always)]
pub fn to_large_fixed<S: Simd>(x: f32, one: i32) -> i32 {
    to_i32(S::round_even(x * one as f32))
}
