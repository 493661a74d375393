//! Sine, cosine and tangent: in `f64` inside and rounded once at the end.
//!
//! Each function is defined in two pieces. The near one, up to [`NEAR`], is short arithmetic
//! without branches, for loops over lanes. The far one reduces the angle in whole numbers (Payne
//! and Hanek), one lane at a time; a batch runs it only when [`is_far`] says that a lane needs it.

use super::exponential::ROUND;
use super::polynomial::polynomial;
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI, PI};

/// The near pieces hold up to here, 2^22 radians: half turns have few enough bits that their
/// product with the high part of π is exact.
const NEAR: f32 = 4_194_304.0;

/// Whether an angle needs the far piece.
#[inline(always)]
pub fn is_far(x: f32) -> bool {
    x.abs() > NEAR && x.abs() < f32::INFINITY
}

/// π to 31 bits, and what is left of it (Cody and Waite).
const PI_PARTS: [f64; 2] =
    [f64::from_bits(0x4009_21fb_5440_0000), f64::from_bits(0x3de0_b461_1a62_6331)];

/// `x` less a multiple of π.
#[inline(always)]
fn less_pi(x: f64, multiple: f64) -> f64 {
    x - multiple * PI_PARTS[0] - multiple * PI_PARTS[1]
}

/// The sine of |r| <= π/2; relative error below 2^-27.5, and the sign flipped if bit 0 of `turns` is 1.
#[inline(always)]
fn sine(r: f64, turns: u64) -> f64 {
    const P: [f64; 5] = [
        0.999_999_994_686_126_1,
        -0.166_666_566_839_897_33,
        0.008_333_025_137_654_188,
        -0.000_198_074_186_045_782_83,
        2.601_902_758_951_064_8e-6,
    ];
    let z = r * r;
    let p = polynomial(z, &P);
    r * f64::from_bits(p.to_bits() ^ turns << 63)
}

/// Sine and cosine of |r| <= π/4; relative errors below 2^-34.
#[inline(always)]
fn sine_cosine(r: f64) -> (f64, f64) {
    const S: [f64; 5] = [
        0.999_999_999_995_450_4,
        -0.166_666_666_304_461_03,
        0.008_333_328_690_132_49,
        -0.000_198_391_783_485_430_36,
        2.717_152_735_427_1e-6,
    ];
    const C: [f64; 5] = [
        0.999_999_999_943_937_2,
        -0.499_999_995_715_556_2,
        0.041_666_613_233_305_026,
        -0.001_388_652_914_098_782,
        2.437_267_854_135_06e-5,
    ];
    let z = r * r;
    let s = polynomial(z, &S);
    let c = polynomial(z, &C);
    (r * s, c)
}

/// The tangent a number of quarter turns on.
#[inline(always)]
fn tangent(r: f64, quarters: u64) -> f64 {
    let (sin, cos) = sine_cosine(r);
    let even = quarters & 1 == 0;
    let (top, bottom) = if even { (sin, cos) } else { (-cos, sin) };
    top / bottom
}

/// [`sin`] where not [`is_far`].
#[inline(always)]
pub fn sin_near(x: f32) -> f32 {
    let x = f64::from(x);
    let shifted = x * FRAC_1_PI + ROUND;
    sine(less_pi(x, shifted - ROUND), shifted.to_bits()) as f32
}

/// [`cos`] where not [`is_far`].
#[inline(always)]
pub fn cos_near(x: f32) -> f32 {
    let x = f64::from(x);
    // The nearest odd multiple of π/2: cos(r + (n + 1/2) π) = -(-1)^n sin(r).
    let shifted = (x * FRAC_1_PI - 0.5) + ROUND;
    let r = less_pi(x, (shifted - ROUND) + 0.5);
    sine(r, !shifted.to_bits()) as f32
}

/// [`tan`] where not [`is_far`].
#[inline(always)]
pub fn tan_near(x: f32) -> f32 {
    let x = f64::from(x);
    let shifted = x * FRAC_2_PI + ROUND;
    tangent(less_pi(x, 0.5 * (shifted - ROUND)), shifted.to_bits()) as f32
}

/// 1/π: a word of whole, then of fraction.
const INVERSE_PI: [u32; 9] = [
    0,
    0x517c_c1b7,
    0x2722_0a94,
    0xfe13_abe8,
    0xfa9a_6ee0,
    0x6db1_4acc,
    0x9e21_c820,
    0xff28_b1d5,
    0xef5d_e2b0,
];

/// Half turns in an angle that [`is_far`], modulo 2, in units of 2^-95.
fn half_turns(x: f32) -> u128 {
    let bits = x.abs().to_bits();
    let mantissa = u128::from(bits & 0x007f_ffff | 0x0080_0000);
    // The angle is mantissa · 2^exponent; what it makes of the bits of 1/π before these is even.
    let biased_exponent = (bits >> 23) as usize;
    let first = 31 + biased_exponent - 150;
    let words = &INVERSE_PI[first / 32..][..4];
    let window = words.iter().fold(0, |window, word| window << 32 | u128::from(*word));
    let window = (window << (first % 32)) >> 32;
    (mantissa * window) & ((1 << 96) - 1)
}

/// Parts of `half_turns` (2^-`step`): their number, nearest, and what is left, in radians.
fn nearest(half_turns: u128, step: u32) -> (f64, u64) {
    let whole = 95 - step;
    let count = (half_turns + (1 << (whole - 1))) >> whole;
    // Below 2^96, so that the difference fits.
    let left = half_turns as i128 - (count << whole) as i128;
    (left as f64 * (PI / (1_u128 << 95) as f64), count as u64)
}

/// [`sin`] where [`is_far`].
pub fn sin_far(x: f32) -> f32 {
    let (r, turns) = nearest(half_turns(x), 0);
    odd(sine(r, turns), x)
}

/// [`cos`] where [`is_far`].
pub fn cos_far(x: f32) -> f32 {
    // A quarter turn on.
    let (r, turns) = nearest(half_turns(x) + (1 << 94), 0);
    sine(r, turns) as f32
}

/// [`tan`] where [`is_far`].
pub fn tan_far(x: f32) -> f32 {
    let (r, quarters) = nearest(half_turns(x), 1);
    odd(tangent(r, quarters), x)
}

/// The value of an odd function at `x`, from its value at `|x|`.
fn odd(of_magnitude: f64, x: f32) -> f32 {
    let result = of_magnitude as f32;
    if x < 0.0 { -result } else { result }
}

/// The sine of an angle in radians; NaN at infinity. Within 0.6 ULP.
#[inline(always)]
pub fn sin(x: f32) -> f32 {
    if is_far(x) { sin_far(x) } else { sin_near(x) }
}

/// The cosine of an angle in radians; NaN at infinity. Within 0.6 ULP.
#[inline(always)]
pub fn cos(x: f32) -> f32 {
    if is_far(x) { cos_far(x) } else { cos_near(x) }
}

/// The tangent of an angle in radians; NaN at infinity. Within 0.51 ULP.
#[inline(always)]
pub fn tan(x: f32) -> f32 {
    if is_far(x) { tan_far(x) } else { tan_near(x) }
}
