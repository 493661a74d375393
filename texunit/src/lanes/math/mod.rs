//! Exact and bounded math, one definition for every instruction set.
//!
//! No function here calls the platform's `libm`. Each is plain arithmetic without branches, so
//! that a loop over lanes vectorizes, and states its error bound in ULP, measured against `f64`.
//! Where rare arguments need much more work, the function is defined in two pieces and the rare
//! one is a function of its own (see [`is_far`]).
//!
//! Polynomials are minimax fits of the relative error (Remez's algorithm). Inside, most is `f64`:
//! one multiplication there does what double-`f32` arithmetic without a fused multiply-add takes
//! ten operations for, so that it is the faster way to a bound below 1 ULP, not only the simpler.

mod circular;
mod exponential;
mod inverse;
mod polynomial;
mod power;
#[cfg(test)]
mod tests;

pub use circular::{
    cos, cos_far, cos_near, is_far, sin, sin_far, sin_near, tan, tan_far, tan_near,
};
pub use exponential::{
    acosh, asinh, atanh, cosh, exp, exp2, log, log2, pow, pow_negative, pow_positive, sinh, tanh,
};
pub use inverse::{acos, asin, atan, atan2};
pub use power::Power;

/// The bits of the plainest NaN: quiet, without a sign.
pub const NAN: u32 = 0x7FC0_0000;
/// The bit of a number's sign.
const SIGN: u32 = 1 << 31;
/// 2^23, from which on every `f32` is an integer.
const INTEGERS_FROM: f32 = 8_388_608.0;

/// `x`, with the quiet bit of a NaN set. What a comparison with a constant chooses becomes a `maxNum` on
/// other processors than x86 (AArch64's `fmaxnm`), and that gives a NaN for one that signals.
#[inline(always)]
pub(crate) fn quiet(x: f32) -> f32 {
    const INFINITY: u32 = f32::INFINITY.to_bits();
    const QUIET: u32 = 1 << 22;
    let bits = x.to_bits();
    if cfg!(target_arch = "x86_64") {
        return x;
    }
    f32::from_bits(if bits & !SIGN > INFINITY { bits | QUIET } else { bits })
}

/// The bits of `x`. Operations on numbers give the NaN of the processor, which has a sign on x86 and none on
/// AArch64: of both, [`NAN`]. Others, which somebody has put there, are kept.
#[inline(always)]
pub fn bits(x: f32) -> u32 {
    let bits = x.to_bits();
    if bits == NAN | SIGN { NAN } else { bits }
}

/// The integer part toward zero as an `i32`; out of range clamps, NaN gives the smallest.
#[inline(always)]
pub fn to_i32(x: f32) -> i32 {
    let x = quiet(x);
    // The order of each comparison sends NaN to the lower bound. 2147483520 is the largest `f32`
    // below 2^31.
    let low = if x >= -2_147_483_648.0 { x } else { -2_147_483_648.0 };
    let clamped = if low <= 2_147_483_520.0 { low } else { 2_147_483_520.0 };
    // SAFETY: not NaN, and within the range of `i32` after the clamps.
    unsafe { clamped.to_int_unchecked::<i32>() }
}

/// The integer that `x` lies in or right above, held from 0 to `last`, which is held from 0 to 2^24; NaN gives 0.
#[inline(always)]
pub fn index(x: f32, last: f32) -> u32 {
    let inside = clamp(x, 0.0, clamp(last, 0.0, 16_777_216.0));
    // SAFETY: the clamps leave no NaN, so this is in 0 ..= 2^24.
    unsafe { inside.to_int_unchecked::<i32>() as u32 }
}

/// The largest number below a half. What is added to it and cut off is the nearest integer, halves up: a half itself
/// would take what is right below a half to 1.
const BELOW_HALF: f32 = 0.499_999_97;

/// `[0, 1]` to the nearest byte, 0 to 255; what is outside clamps, NaN gives 0 (GL 2.1, section
/// 2.14.9).
#[inline(always)]
pub fn byte(c: f32) -> u32 {
    // Held in bounds at last: LLVM makes a choice between products of a clamp before.
    let near = clamp(c * 255.0 + BELOW_HALF, 0.0, 255.5);
    // SAFETY: the clamp leaves no NaN, so this is in 0 ..= 255.5.
    unsafe { near.to_int_unchecked::<i32>() as u32 }
}

/// [`byte`] of what is known to lie in `[0, 1]`, give or take its last bits. What does not gives some byte.
#[inline(always)]
pub fn unit_byte(c: f32) -> u32 {
    nearest_byte(c * 255.0)
}

/// The byte nearest to what is known to lie in `[0, 255]`, give or take its last bits. What does not gives some byte.
#[inline(always)]
pub fn nearest_byte(c: f32) -> u32 {
    const LAST: u32 = 255.5_f32.to_bits();
    let bits = (c + BELOW_HALF).to_bits();
    // Floats that are not negative are in the order of their bits; all others are beyond.
    let near = f32::from_bits(if bits < LAST { bits } else { LAST });
    // SAFETY: bits from 0 to those of 255.5 are of floats from 0 to 255.5.
    unsafe { near.to_int_unchecked::<i32>() as u32 }
}

/// The integer part toward zero as a `u32`; negative and NaN give 0, too large clamps.
#[inline(always)]
pub fn to_u32(x: f32) -> u32 {
    let x = quiet(x);
    let low = if x >= 0.0 { x } else { 0.0 };
    let clamped = if low <= 4_294_967_040.0 { low } else { 4_294_967_040.0 };
    // Through two halves of 31 bits: only signed conversions are vector instructions everywhere.
    let high = clamped >= 2_147_483_648.0;
    let part = if high { clamped - 2_147_483_648.0 } else { clamped };
    // SAFETY: `part` is in 0 ..= 2147483520.
    let bits = unsafe { part.to_int_unchecked::<i32>() } as u32;
    if high { bits | 0x8000_0000 } else { bits }
}

/// The integer part toward zero. Exact; keeps inf and NaN.
#[inline(always)]
pub fn trunc(x: f32) -> f32 {
    let whole = to_i32(x) as f32;
    let inside = x.abs() < INTEGERS_FROM;
    if inside { whole } else { x }
}

/// The largest integer not above `x`. Exact; keeps inf and NaN; `floor(-0.0)` is `0.0`.
#[inline(always)]
pub fn floor(x: f32) -> f32 {
    let whole = trunc(x);
    if whole > x { whole - 1.0 } else { whole }
}

/// 1.5 · 2^23: its sum with a small number holds the nearest integer in its low bits.
const MAGIC: f32 = 12_582_912.0;

/// `floor(x)` as an integer and as a number, for magnitudes below 2^22, in fewer steps than through
/// a conversion. Of larger magnitudes and NaN some integer, the same everywhere.
#[inline(always)]
pub fn floor_small(x: f32) -> (i32, f32) {
    let nearest = (x + MAGIC) - MAGIC;
    let whole = if nearest > x { nearest - 1.0 } else { nearest };
    (low_bits(whole), whole)
}

/// The nearest integer, halves to even, to a magnitude below 2^22.
#[inline(always)]
pub fn low_bits(x: f32) -> i32 {
    (x + MAGIC).to_bits().wrapping_sub(MAGIC.to_bits()) as i32
}

/// The smallest integer not below `x`. Exact; keeps inf and NaN.
#[inline(always)]
pub fn ceil(x: f32) -> f32 {
    let whole = trunc(x);
    if whole < x { whole + 1.0 } else { whole }
}

/// `x - floor(x)`, GLSL's `fract`. In [0, 1]; exact unless it rounds up to 1 for tiny negative `x`.
#[inline(always)]
pub fn fract(x: f32) -> f32 {
    x - floor(x)
}

/// The nearest integer, halves to even. Exact; keeps inf and NaN.
#[inline(always)]
pub fn round_even(x: f32) -> f32 {
    // Adding and taking away 2^23 rounds to an integer in the one rounding mode there is.
    let magnitude = x.abs();
    let rounded = (magnitude + INTEGERS_FROM) - INTEGERS_FROM;
    let result = if magnitude < INTEGERS_FROM { rounded } else { magnitude };
    result.copysign(x)
}

/// `a - b · floor(a / b)` (GLSL 1.20, section 8.3), given `inverse`, `1 / b`, and `nearest`, the
/// integer nearest to `a · inverse`. This is the whole quotient or one more: then the difference has
/// not `b`'s sign. Other than the formula in `f32` it never leaves the range from 0 to `b` because a
/// quotient was rounded up, as long as this is below 2^22. An infinite inverse (`b` below 2^-128) is none.
#[inline(always)]
pub fn modulo(a: f32, b: f32, inverse: f32, nearest: f32) -> f32 {
    let left = a - b * nearest;
    let along = f32::from_bits(left.to_bits() ^ inverse.to_bits() & SIGN);
    if along < 0.0 { left + b } else { left }
}

/// [`modulo`] of a `b` above 0.
#[inline(always)]
pub fn modulo_positive(a: f32, b: f32, nearest: f32) -> f32 {
    let left = a - b * nearest;
    // Of a number below 0 and a larger one, the larger has the smaller word; of two others, the smaller. (A difference
    // is no -0 here: `nearest` has the sign of `a`.)
    f32::from_bits(left.to_bits().min((left + b).to_bits()))
}

/// Of vectors that are longer, no square is so small that it loses bits.
pub const LEAST_NORM: f32 = 8.881_784e-16;
/// The sum of the squares of vectors that are shorter is finite.
pub const LARGEST_NORM: f32 = 9.223_372e18;

/// The length of a vector of any size: in `f64` no square of a float leaves the range.
pub fn norm_far(a: f32, b: f32, c: f32) -> f32 {
    norm_of_any(a, b, c) as f32
}

/// The inverse of the length of a vector of any size. It is infinite only of 0: of denormal vectors whose
/// inverse length would be, it is the largest float.
pub fn inverse_norm_far(a: f32, b: f32, c: f32) -> f32 {
    let norm = norm_of_any(a, b, c);
    let inverse = (1.0 / norm) as f32;
    if inverse.is_infinite() && norm > 0.0 { f32::MAX } else { inverse }
}

fn norm_of_any(a: f32, b: f32, c: f32) -> f64 {
    let [a, b, c] = [a, b, c].map(f64::from);
    (a * a + b * b + c * c).sqrt()
}

/// The smaller; `b` if `a` is NaN. (Rust's and each processor's own `min` differ on NaN and ±0.)
#[inline(always)]
pub fn min(a: f32, b: f32) -> f32 {
    let a = quiet(a);
    if a < b { a } else { b }
}

/// The larger; `b` if `a` is NaN.
#[inline(always)]
pub fn max(a: f32, b: f32) -> f32 {
    let a = quiet(a);
    if a > b { a } else { b }
}

/// The smaller of two numbers; the other if one is NaN, as IEEE 754-2008's `minNum`.
#[inline(always)]
pub fn min_number(a: f32, b: f32) -> f32 {
    if a < b || b.is_nan() { a } else { b }
}

/// The larger of two numbers; the other if one is NaN, as IEEE 754-2008's `maxNum`.
#[inline(always)]
pub fn max_number(a: f32, b: f32) -> f32 {
    if a > b || b.is_nan() { a } else { b }
}

/// `x` held between `low` and `high`; NaN gives `low`.
#[inline(always)]
pub fn clamp(x: f32, low: f32, high: f32) -> f32 {
    min(max(x, low), high)
}
