//! Powers and logarithms, in `f64` inside and rounded once at the end.

use super::polynomial::polynomial;

/// 1.5 · 2^52: adding it leaves an integer in the low bits of the sum.
pub(super) const ROUND: f64 = 6_755_399_441_055_744.0;

/// `2^t`, relative error below 2^-28.9. Beyond (-150, 130] 0 or inf as `f32`: 2^-150 itself is a
/// tie that goes to 0.
#[inline(always)]
pub(super) fn exp2_wide(t: f64) -> f64 {
    // NaN fails both comparisons and goes through.
    let t = if t > 130.0 { 130.0 } else { t };
    let t = if t <= -150.0 { -151.0 } else { t };
    let shifted = t + ROUND;
    let z = t - (shifted - ROUND);
    const P: [f64; 7] = [
        1.000_000_000_554_288,
        0.693_147_205_740_167_2,
        0.240_226_468_900_001_77,
        0.055_503_287_703_895_295,
        0.009_618_488_996_654_67,
        0.001_339_993_391_533_856_4,
        0.000_153_458_081_331_983_55,
    ];
    let p = polynomial(z, &P);
    // Into the exponent, where the low bits of the sum are the integer.
    f64::from_bits(p.to_bits().wrapping_add(shifted.to_bits() << 52))
}

/// `atanh(s) / s` as a series in `s²`; relative error below 1e-13 for |s| <= 0.1716.
#[inline(always)]
fn atanh_series(s: f64) -> f64 {
    const P: [f64; 9] = [
        1.0,
        1.0 / 3.0,
        1.0 / 5.0,
        1.0 / 7.0,
        1.0 / 9.0,
        1.0 / 11.0,
        1.0 / 13.0,
        1.0 / 15.0,
        1.0 / 17.0,
    ];
    polynomial(s * s, &P)
}

/// Exponent and mantissa in [√½, √2) of a positive, finite, normal `x`.
#[inline(always)]
fn split(x: f64) -> (f64, f64) {
    const ONE: u64 = 0x3ff0_0000_0000_0000;
    const SQRT_HALF: u64 = 0x3fe6_a09e_667f_3bcd;
    const MANTISSA: u64 = 0x000f_ffff_ffff_ffff;
    /// 2^52, whose low bits hold an integer.
    const INTEGER: u64 = 0x4330_0000_0000_0000;
    let bits = x.to_bits().wrapping_add(ONE - SQRT_HALF);
    let exponent = f64::from_bits(bits >> 52 | INTEGER) - (4_503_599_627_370_496.0 + 1023.0);
    (exponent, f64::from_bits((bits & MANTISSA) + SQRT_HALF))
}

/// The values of a logarithm where it is not `finite`: inf, NaN, 0 and below.
#[inline(always)]
fn log_edges<T: Edges>(x: f32, finite: T) -> T {
    let result = if x < f32::INFINITY { finite } else { T::from(x) };
    let result = if x == 0.0 { T::from(f32::NEG_INFINITY) } else { result };
    if x < 0.0 { T::from(f32::NAN) } else { result }
}

/// The two widths.
trait Edges: From<f32> {}
impl Edges for f32 {}
impl Edges for f64 {}

/// The logarithm to base 2 of a positive, finite `x`; relative error below 2^-33.
#[inline(always)]
fn log2_finite(x: f32) -> f64 {
    const P: [f64; 12] = [
        1.442_695_040_939_355_7,
        -0.721_347_525_212_828_2,
        0.480_898_320_724_760_7,
        -0.360_672_800_594_817_5,
        0.288_540_643_973_442_26,
        -0.240_504_172_731_514_3,
        0.206_096_244_089_312_32,
        -0.179_046_961_857_816_54,
        0.159_001_640_639_129_97,
        -0.156_982_335_513_368_38,
        0.154_856_941_148_146_74,
        -0.086_345_245_930_455_85,
    ];
    let (exponent, m) = split(f64::from(x));
    let f = m - 1.0;
    exponent + f * polynomial(f, &P)
}

#[inline(always)]
fn ln_wide(x: f64) -> f64 {
    let (exponent, m) = split(x);
    let s = (m - 1.0) / (m + 1.0);
    exponent * std::f64::consts::LN_2 + 2.0 * s * atanh_series(s)
}

/// `2^x`. Within 0.54 ULP.
#[inline(always)]
pub fn exp2(x: f32) -> f32 {
    exp2_wide(f64::from(x)) as f32
}

/// `e^x`. Within 0.54 ULP.
#[inline(always)]
pub fn exp(x: f32) -> f32 {
    exp2_wide(f64::from(x) * std::f64::consts::LOG2_E) as f32
}

/// The logarithm to base 2; of 0 -inf, below 0 NaN. Within 0.51 ULP.
#[inline(always)]
pub fn log2(x: f32) -> f32 {
    log_edges(x, log2_finite(x) as f32)
}

/// The natural logarithm; of 0 -inf, below 0 NaN. Within 0.51 ULP.
#[inline(always)]
pub fn log(x: f32) -> f32 {
    log_edges(x, (log2_finite(x) * std::f64::consts::LN_2) as f32)
}

/// `x^y`. Within 0.7 ULP.
///
/// GLSL leaves `x < 0`, and `x = 0` with `y <= 0`, undefined. Here all is as IEEE's and C's `pow`:
/// `x^0 = 1` and `1^y = 1` even for NaN, `0^y = inf` for negative `y`; a negative `x` has powers
/// of whole `y`, as shaders square what may be negative by `pow(x, 2.0)`, and NaN of others.
#[inline(always)]
pub fn pow(x: f32, y: f32) -> f32 {
    if x.is_sign_negative() { pow_negative(x, y) } else { pow_positive(x, y) }
}

/// [`pow`] where `x` has no sign.
#[inline(always)]
pub fn pow_positive(x: f32, y: f32) -> f32 {
    let log = if x < f32::INFINITY { log2_finite(x) } else { f64::from(x) };
    let log = if x == 0.0 { f64::NEG_INFINITY } else { log };
    let power = exp2_wide(f64::from(y) * log) as f32;
    if y == 0.0 || x == 1.0 { 1.0 } else { power }
}

/// [`pow`] where `x` has one.
#[inline(always)]
pub fn pow_negative(x: f32, y: f32) -> f32 {
    /// From here on every `f32` is even; NaN stays.
    const EVEN_FROM: f64 = 16_777_216.0;
    let size = f64::from(y).abs();
    let size = if size > EVEN_FROM { EVEN_FROM } else { size };
    let shifted = size + ROUND;
    let power = pow_positive(-x, y);
    // The lowest bit of the sum is that of the integer.
    let signed = f32::from_bits(power.to_bits() ^ (shifted.to_bits() as u32) << 31);
    let broken = if x == 0.0 || x == f32::NEG_INFINITY { power } else { f32::NAN };
    if shifted - ROUND == size { signed } else { broken }
}

/// `sinh` and `cosh` without their overflow: both too large by the same power when |x| > 90.
#[inline(always)]
fn hyperbolic(x: f32) -> (f64, f64) {
    let x = f64::from(x);
    let up = exp2_wide(x * std::f64::consts::LOG2_E);
    let down = 1.0 / up;
    let x2 = x * x;
    // Near zero the difference cancels.
    let series = 1.0 / 120.0 + x2 * (1.0 / 5_040.0 + x2 * (1.0 / 362_880.0));
    let near = x + x * x2 * (1.0 / 6.0 + x2 * series);
    let far = 0.5 * (up - down);
    (if x.abs() < 0.5 { near } else { far }, 0.5 * (up + down))
}

/// The hyperbolic sine. Within 0.6 ULP.
#[inline(always)]
pub fn sinh(x: f32) -> f32 {
    hyperbolic(x).0 as f32
}

/// The hyperbolic cosine. Within 0.6 ULP.
#[inline(always)]
pub fn cosh(x: f32) -> f32 {
    hyperbolic(x).1 as f32
}

/// The hyperbolic tangent. Within 0.6 ULP.
#[inline(always)]
pub fn tanh(x: f32) -> f32 {
    let (sinh, cosh) = hyperbolic(x);
    (sinh / cosh) as f32
}

/// The inverse of [`sinh`]. Within 0.51 ULP.
#[inline(always)]
pub fn asinh(x: f32) -> f32 {
    let a = f64::from(x).abs();
    let a2 = a * a;
    let near = a * (1.0 - a2 * (1.0 / 6.0 - a2 * (3.0 / 40.0 - a2 * (15.0 / 336.0))));
    let far = ln_wide(a + (a2 + 1.0).sqrt());
    let finite = if a < 0.03125 { near } else { far };
    // Keeps inf and NaN.
    let magnitude = if a < f64::INFINITY { finite } else { a };
    (magnitude as f32).copysign(x)
}

/// The inverse of [`cosh`]; below 1 NaN. Within 0.51 ULP.
#[inline(always)]
pub fn acosh(x: f32) -> f32 {
    let a = f64::from(x);
    let finite = ln_wide(a + (a * a - 1.0).sqrt());
    let result = if x < f32::INFINITY { finite } else { a };
    if x >= 1.0 { result as f32 } else { f32::NAN }
}

/// The inverse of [`tanh`]; of ±1 ±inf, beyond NaN. Within 0.51 ULP.
#[inline(always)]
pub fn atanh(x: f32) -> f32 {
    let a = f64::from(x).abs();
    let near = a * atanh_series(a);
    let far = 0.5 * ln_wide((1.0 + a) / (1.0 - a));
    let inside = if a < 0.125 { near } else { far };
    let result = if a < 1.0 { inside } else { f64::INFINITY };
    let result = (result as f32).copysign(x);
    if a <= 1.0 { result } else { f32::NAN }
}
