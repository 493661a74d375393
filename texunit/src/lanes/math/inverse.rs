//! The angles of sines, cosines and tangents, in `f64` inside and rounded once at the end.

use super::polynomial::polynomial;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// tan(π/8): beyond it, atan(t) = π/4 - atan((1 - t) / (1 + t)).
const FAR: f64 = 0.414_213_562_373_095_03;

/// The angle of the point (x, y), -π to π, with every edge as IEEE's `atan2`.
#[inline(always)]
fn angle(y: f64, x: f64) -> f64 {
    let (ay, ax) = (y.abs(), x.abs());
    let steep = ay > ax;
    let (small, large) = if steep { (ax, ay) } else { (ay, ax) };
    let far = small > FAR * large;
    let (top, bottom) = if far { (small - large, small + large) } else { (small, large) };
    // inf/inf counts as 1, 0/0 as 0.
    let z = if small == large { 0.0 } else { top / bottom };
    let from = if far || (small == large && large > 0.0) { FRAC_PI_4 } else { 0.0 };
    // atan(z) / z as a polynomial in z²; relative error below 2^-35 for |z| <= tan(π/8).
    let z2 = z * z;
    const P: [f64; 7] = [
        0.999_999_999_979_295_7,
        -0.333_333_321_348_176_06,
        0.199_998_863_671_087_24,
        -0.142_816_508_399_232_68,
        0.110_411_836_567_476_04,
        -0.084_597_768_921_775_4,
        0.047_142_888_302_545_39,
    ];
    let p = polynomial(z2, &P);
    let first = from + z * p;
    let upper = if steep { FRAC_PI_2 - first } else { first };
    let left = x.to_bits() >> 63 != 0;
    let result = (if left { PI - upper } else { upper }).copysign(y);
    if ax >= 0.0 && ay >= 0.0 { result } else { f64::NAN }
}

/// The angle of the point (x, y), -π to π; GLSL's undefined (0, 0) as IEEE: ±0 or ±π. Within 0.51
/// ULP.
#[inline(always)]
pub fn atan2(y: f32, x: f32) -> f32 {
    angle(f64::from(y), f64::from(x)) as f32
}

/// The angle in [-π/2, π/2] of this tangent. Within 0.51 ULP.
#[inline(always)]
pub fn atan(x: f32) -> f32 {
    angle(f64::from(x), 1.0) as f32
}

/// `asin(s) / s` as a polynomial in `s²`, for |s| <= 1/2; relative error below 2^-35.
#[inline(always)]
fn asin_over(s2: f64) -> f64 {
    const P: [f64; 8] = [
        0.999_999_999_984_903_3,
        0.166_666_674_216_678_77,
        0.074_999_381_989_645_69,
        0.044_662_035_569_441_76,
        0.030_092_208_957_170_734,
        0.024_711_544_611_968_97,
        0.007_223_822_727_088_222,
        0.034_951_560_034_103_44,
    ];
    polynomial(s2, &P)
}

/// The angle of a sine between 0 and 1/2; beyond it, half of what the angle lacks to π/2:
/// asin(x) = π/2 - 2 asin(sqrt((1 - x) / 2)). NaN beyond 1.
#[inline(always)]
fn asin_part(magnitude: f32) -> f64 {
    let far = magnitude > 0.5;
    let half = f64::from(0.5 - 0.5 * magnitude);
    let near = f64::from(magnitude);
    let s2 = if far { half } else { near * near };
    let s = if far { half.sqrt() } else { near };
    s * asin_over(s2)
}

/// The angle in [-π/2, π/2] of this sine; NaN beyond ±1. Within 0.51 ULP.
#[inline(always)]
pub fn asin(x: f32) -> f32 {
    let magnitude = x.abs();
    let part = asin_part(magnitude);
    let angle = if magnitude > 0.5 { FRAC_PI_2 - 2.0 * part } else { part };
    (angle as f32).copysign(x)
}

/// The angle in [0, π] of this cosine; NaN beyond ±1. Within 0.51 ULP.
#[inline(always)]
pub fn acos(x: f32) -> f32 {
    let magnitude = x.abs();
    let part = asin_part(magnitude);
    // Of the magnitude; acos(-x) = π - acos(x).
    let angle = if magnitude > 0.5 { 2.0 * part } else { FRAC_PI_2 - part };
    (if x < 0.0 { PI - angle } else { angle }) as f32
}
