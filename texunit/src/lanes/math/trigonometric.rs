//! Angles, in `f64` inside and rounded once at the end.

use super::exponential::ROUND;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Angles are reduced up to here, 2^28 radians. Further out neighbouring `f32` are several turns
/// apart, and the angle counts as zero.
const LARGEST_ANGLE: f32 = 268_435_456.0;

/// `x` less the nearest multiple of π/2, and the low bits of that multiple.
///
/// Cody and Waite: π/2 in three parts, the first two so short that their products with the
/// multiple, and the differences, are exact.
#[inline(always)]
fn reduce(x: f32) -> (f64, u64) {
    const PARTS: [f64; 3] = [
        f64::from_bits(0x3ff9_21fb_5000_0000),
        f64::from_bits(0x3e51_10b4_6000_0000),
        f64::from_bits(0x3c91_a626_3314_5c07),
    ];
    let angle = f64::from(if x.abs() <= LARGEST_ANGLE { x } else { x * 0.0 });
    let shifted = angle * std::f64::consts::FRAC_2_PI + ROUND;
    let multiple = shifted - ROUND;
    let r = angle - multiple * PARTS[0] - multiple * PARTS[1] - multiple * PARTS[2];
    (r, shifted.to_bits())
}

/// Sine and cosine of |r| <= π/4 by their series; relative error below 1e-12.
#[inline(always)]
fn series(r: f64) -> (f64, f64) {
    let r2 = r * r;
    let s = 1.0 / 6_227_020_800.0;
    let s = s * r2 - 1.0 / 39_916_800.0;
    let s = s * r2 + 1.0 / 362_880.0;
    let s = s * r2 - 1.0 / 5_040.0;
    let s = s * r2 + 1.0 / 120.0;
    let s = s * r2 - 1.0 / 6.0;
    let c = -1.0 / 87_178_291_200.0;
    let c = c * r2 + 1.0 / 479_001_600.0;
    let c = c * r2 - 1.0 / 3_628_800.0;
    let c = c * r2 + 1.0 / 40_320.0;
    let c = c * r2 - 1.0 / 720.0;
    let c = c * r2 + 1.0 / 24.0;
    let c = c * r2 - 0.5;
    (r * (s * r2 + 1.0), c * r2 + 1.0)
}

/// The sine a number of quarter turns on.
#[inline(always)]
fn sine_of(r: f64, quarters: u64) -> f64 {
    let (sin, cos) = series(r);
    let magnitude = if quarters & 1 == 0 { sin } else { cos };
    if quarters & 2 == 0 { magnitude } else { -magnitude }
}

/// The sine of an angle in radians. Within 0.51 ULP up to 2^28; 0 beyond, NaN at infinity.
#[inline(always)]
pub fn sin(x: f32) -> f32 {
    let (r, quarters) = reduce(x);
    sine_of(r, quarters) as f32
}

/// The cosine of an angle in radians. Within 0.51 ULP up to 2^28; 1 beyond, NaN at infinity.
#[inline(always)]
pub fn cos(x: f32) -> f32 {
    let (r, quarters) = reduce(x);
    sine_of(r, quarters.wrapping_add(1)) as f32
}

/// The tangent of an angle in radians. Within 0.51 ULP up to 2^28; 0 beyond, NaN at infinity.
#[inline(always)]
pub fn tan(x: f32) -> f32 {
    let (r, quarters) = reduce(x);
    let (sin, cos) = series(r);
    let even = quarters & 1 == 0;
    let (top, bottom) = if even { (sin, cos) } else { (-cos, sin) };
    (top / bottom) as f32
}

/// `atan(t)` for 0 <= t <= 1; relative error below 1e-12.
#[inline(always)]
fn atan_unit(t: f64) -> f64 {
    // tan(π/8): beyond it, atan(t) = π/4 + atan((t - 1) / (t + 1)).
    let far = t > 0.414_213_562_373_095_03;
    let z = if far { (t - 1.0) / (t + 1.0) } else { t };
    let z2 = z * z;
    let p = 1.0 / 29.0;
    let p = 1.0 / 27.0 - p * z2;
    let p = 1.0 / 25.0 - p * z2;
    let p = 1.0 / 23.0 - p * z2;
    let p = 1.0 / 21.0 - p * z2;
    let p = 1.0 / 19.0 - p * z2;
    let p = 1.0 / 17.0 - p * z2;
    let p = 1.0 / 15.0 - p * z2;
    let p = 1.0 / 13.0 - p * z2;
    let p = 1.0 / 11.0 - p * z2;
    let p = 1.0 / 9.0 - p * z2;
    let p = 1.0 / 7.0 - p * z2;
    let p = 1.0 / 5.0 - p * z2;
    let p = 1.0 / 3.0 - p * z2;
    let near = z - z * (z2 * p);
    if far { FRAC_PI_4 + near } else { near }
}

/// The angle of the point (x, y), -π to π, with every edge as IEEE's `atan2`.
#[inline(always)]
fn angle(y: f64, x: f64) -> f64 {
    let (ay, ax) = (y.abs(), x.abs());
    let steep = ay > ax;
    let (small, large) = if steep { (ax, ay) } else { (ay, ax) };
    // 0/0 is 0 and inf/inf is 1.
    let ratio = if small == large { 1.0 } else { small / large };
    let ratio = if large == 0.0 { 0.0 } else { ratio };
    let first = atan_unit(ratio);
    let upper = if steep { FRAC_PI_2 - first } else { first };
    let left = x.to_bits() >> 63 != 0;
    let result = (if left { PI - upper } else { upper }).copysign(y);
    if ax >= 0.0 && ay >= 0.0 { result } else { f64::NAN }
}

/// The angle of the point (x, y), -π to π; GLSL's undefined (0, 0) as IEEE: ±0 or ±π. Within 0.51 ULP.
#[inline(always)]
pub fn atan2(y: f32, x: f32) -> f32 {
    angle(f64::from(y), f64::from(x)) as f32
}

/// The angle in [-π/2, π/2] of this tangent. Within 0.51 ULP.
#[inline(always)]
pub fn atan(x: f32) -> f32 {
    angle(f64::from(x), 1.0) as f32
}

/// The angle in [-π/2, π/2] of this sine; NaN beyond ±1. Within 0.51 ULP.
#[inline(always)]
pub fn asin(x: f32) -> f32 {
    let x = f64::from(x);
    angle(x, ((1.0 - x) * (1.0 + x)).sqrt()) as f32
}

/// The angle in [0, π] of this cosine; NaN beyond ±1. Within 0.51 ULP.
#[inline(always)]
pub fn acos(x: f32) -> f32 {
    let x = f64::from(x);
    angle(((1.0 - x) * (1.0 + x)).sqrt(), x) as f32
}
