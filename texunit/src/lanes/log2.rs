//! The logarithm to base 2.

/// The Chebyshev fit of `log2(1 + f) / f` from √½ - 1 to √2 - 1.
const P: [f64; 11] = [
    1.4426950417560511,
    -0.7213475119905358,
    0.48089790445500086,
    -0.36067466009513405,
    0.2885755897331174,
    -0.24044757077719425,
    0.20504002106652403,
    -0.17919457239512765,
    0.17234259277671127,
    -0.16765051818984325,
    0.09481863798699576,
];

/// The minimax fit of the same in `f32` (relative error below 2^-25).
const P_SHORT: [f32; 9] = [
    std::f32::consts::LOG2_E,
    -0.721_347_33,
    0.480_910_63,
    -0.360_703_68,
    0.287_916_24,
    -0.238_944_95,
    0.215_715_84,
    -0.207_268_94,
    0.125_835_37,
];

/// The bits of √½, where the mantissa's range is cut.
const CUT: u32 = std::f32::consts::FRAC_1_SQRT_2.to_bits();

/// `log2(x)` to within 1 ULP of the exact value (0.511 measured over every exponent), total:
/// ±0 gives -inf, inf gives inf, NaN and what is below 0 give NaN, denormals are exact too.
///
/// `x = m · 2^e` with `m` in [√½, √2); the result is `e + f · p(f)` with `f = m - 1`, in `f64`, where
/// `p` is the Chebyshev fit of `log2(1 + f) / f` of degree 10 (relative error below 2^-29).
#[inline(always)]
pub fn log2(x: f32) -> f32 {
    let denormal = x < f32::MIN_POSITIVE;
    let normal = if denormal { x * 8_388_608.0 } else { x };
    let shift = if denormal { -23 } else { 0 };
    let above_cut = normal.to_bits().wrapping_sub(CUT);
    let exponent = (above_cut as i32 >> 23) + shift;
    let m = f32::from_bits((above_cut & 0x007F_FFFF).wrapping_add(CUT));

    let f = f64::from(m - 1.0);
    let mut p = P[10];
    let mut term = 10;
    while term > 0 {
        term -= 1;
        p = p * f + P[term];
    }
    let finite = (f64::from(exponent) + f * p) as f32;

    let positive = if x < f32::INFINITY { finite } else { x };
    let defined = if x == 0.0 { f32::NEG_INFINITY } else { positive };
    if x < 0.0 { f32::NAN } else { defined }
}

/// `log2(√x)`, in `f32` alone: to within 2.5 ULP from 2^-126 on (2.36 measured over every exponent).
/// Zero and denormals give something from -64 to -62.5; what is below 0 means nothing; inf and NaN
/// stay.
#[inline(always)]
pub fn log2_of_root(x: f32) -> f32 {
    let above_cut = x.to_bits().wrapping_sub(CUT);
    let exponent = above_cut as i32 >> 23;
    let f = f32::from_bits((above_cut & 0x007F_FFFF).wrapping_add(CUT)) - 1.0;
    // All but the first term by pairs (Estrin's scheme): in sequence each would depend on the previous one.
    let (f2, p) = (f * f, &P_SHORT);
    let low = (p[1] + p[2] * f) + (p[3] + p[4] * f) * f2;
    let high = (p[5] + p[6] * f) + (p[7] + p[8] * f) * f2;
    let p = p[0] + f * (low + high * (f2 * f2));
    let finite = 0.5 * (exponent as f32 + f * p);
    if x < f32::INFINITY { finite } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The error in units of the last place of the exact value.
    fn ulps(x: f32) -> f64 {
        let exact = f64::from(x).log2();
        let nearest = exact as f32;
        let spacing = f64::from(nearest.abs().next_up()) - f64::from(nearest.abs());
        ((f64::from(log2(x)) - exact) / spacing).abs()
    }

    #[test]
    fn the_error_stays_below_the_stated_bound() {
        let mut worst = 0.0_f64;
        // Every exponent, denormals too; then every float in reach of 1, where it is hardest.
        for bits in (1..f32::INFINITY.to_bits()).step_by(4099) {
            worst = worst.max(ulps(f32::from_bits(bits)));
        }
        for bits in 0x3F7F_0000..0x3F81_0000 {
            worst = worst.max(ulps(f32::from_bits(bits)));
        }
        assert!(worst < 0.52, "{worst}");
    }

    #[test]
    fn the_logarithm_of_a_root_stays_within_two_and_a_half_ulp() {
        let mut worst = 0.0_f64;
        let every_exponent = (0x0080_0000..f32::INFINITY.to_bits()).step_by(4099);
        let near_one = 0x3F7F_0000..0x3F81_0000;
        let whole_exponent = (0x3F00_0000..0x3F80_0000).step_by(61);
        for bits in every_exponent.chain(near_one).chain(whole_exponent) {
            let x = f32::from_bits(bits);
            let exact = 0.5 * f64::from(x).log2();
            let nearest = (exact as f32).abs();
            let spacing = f64::from(nearest.next_up()) - f64::from(nearest);
            worst = worst.max(((f64::from(log2_of_root(x)) - exact) / spacing).abs());
        }
        assert!(worst < 2.5, "{worst}");
        assert!((-64.0..=-62.5).contains(&log2_of_root(0.0)));
        assert!((-64.0..=-62.5).contains(&log2_of_root(1e-40)));
        assert_eq!(log2_of_root(f32::INFINITY), f32::INFINITY);
        assert!(log2_of_root(f32::NAN).is_nan());
    }

    #[test]
    fn powers_of_two_are_exact_and_the_rest_is_total() {
        for e in -149..=127 {
            assert_eq!(log2(2.0_f64.powi(e) as f32), e as f32);
        }
        assert_eq!(log2(0.0), f32::NEG_INFINITY);
        assert_eq!(log2(-0.0), f32::NEG_INFINITY);
        assert_eq!(log2(f32::INFINITY), f32::INFINITY);
        for x in [f32::NAN, -1.0, -1e-45, f32::NEG_INFINITY] {
            assert!(log2(x).is_nan(), "{x}");
        }
    }
}
