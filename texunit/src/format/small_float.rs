//! Half floats, and the unsigned floats of 11 and 10 bits (`ARB_half_float_pixel`,
//! `EXT_packed_float`): an exponent of 5 bits with a bias of 15 over a mantissa of 10, 6 or 5.
//!
//! Conversions are exact where they can be, and else round to the nearest, halves to even.
//! Denormals and inf are kept; every NaN becomes the same one.

/// Bits of a half float's mantissa.
pub const HALF_MANTISSA: u32 = 10;
/// The sign of a half float.
const HALF_SIGN: u32 = 0x8000;
/// The sum that takes an exponent biased by 15 to one biased by 127.
const REBIAS: u32 = (127 - 15) << 23;
const F32_INFINITY: u32 = 0x7F80_0000;

/// `2^exponent` for -126 to 127.
#[inline(always)]
pub(super) const fn power_of_two(exponent: i32) -> f32 {
    f32::from_bits(((exponent + 127) as u32) << 23)
}

/// The value of an unsigned float with this many bits of mantissa. Exact.
#[inline(always)]
pub const fn decode_unsigned(bits: u32, mantissa: u32) -> f32 {
    let shifted = bits << (23 - mantissa);
    let denormal = bits as i32 as f32 * power_of_two(-14 - mantissa as i32);
    let special = f32::from_bits(shifted | F32_INFINITY);
    let normal = f32::from_bits(shifted + REBIAS);
    let exponent = bits >> mantissa;
    if exponent == 0 {
        denormal
    } else if exponent == 31 {
        special
    } else {
        normal
    }
}

/// The nearest unsigned float, halves to even, to a magnitude that is a number or inf, with an
/// exponent that may run past that of inf.
#[inline(always)]
fn round_magnitude(magnitude: f32, mantissa: u32) -> u32 {
    let bits = magnitude.to_bits();
    let shift = 23 - mantissa;
    // A carry out of the mantissa raises the exponent, as it should.
    let even = bits >> shift & 1;
    let rounded = (bits.wrapping_add((1 << (shift - 1)) - 1 + even)) >> shift;
    let normal = rounded.wrapping_sub(REBIAS >> shift);
    let least = power_of_two(-14);
    // A number whose last bit is worth a denormal's: the sum rounds to those, halves to even.
    let unit = power_of_two(9 - mantissa as i32);
    let denormal = (magnitude + unit).to_bits().wrapping_sub(unit.to_bits());
    if magnitude < least { denormal } else { normal }
}

/// The nearest unsigned float: negative gives 0, a finite value above the largest gives the
/// largest, inf and NaN stay (`EXT_packed_float`, section 2.1.A).
#[inline(always)]
pub fn encode_unsigned(x: f32, mantissa: u32) -> u32 {
    let infinity = 31 << mantissa;
    let magnitude = if x > 0.0 { x } else { 0.0 };
    let rounded = round_magnitude(magnitude, mantissa);
    let finite = if rounded < infinity { rounded } else { infinity - 1 };
    let number = if magnitude == f32::INFINITY { infinity } else { finite };
    if x.is_nan() { infinity | 1 << (mantissa - 1) } else { number }
}

/// The value of a half float. Exact; a NaN keeps its bits.
#[inline(always)]
pub const fn decode_half(bits: u32) -> f32 {
    let magnitude = decode_unsigned(bits & 0x7FFF, HALF_MANTISSA);
    f32::from_bits(magnitude.to_bits() | (bits & HALF_SIGN) << 16)
}

/// The nearest half float, halves to even; too large gives ±inf, NaN gives `0x7E00`.
#[inline(always)]
pub fn encode_half(x: f32) -> u32 {
    let infinity = 31 << HALF_MANTISSA;
    let rounded = round_magnitude(x.abs(), HALF_MANTISSA);
    let magnitude = if rounded < infinity { rounded } else { infinity };
    let signed = magnitude | (x.to_bits() >> 16 & HALF_SIGN);
    if x.is_nan() { infinity | 1 << (HALF_MANTISSA - 1) } else { signed }
}

/// A number clamped to those that a float of 32, 16, 11 or 10 bits can hold; the last two have no sign. Infinities and
/// NaN are numbers that each of them has.
pub fn clamp_to_range(x: f32, bits: u32) -> f32 {
    let (mantissa, least) = match bits {
        32 => return x,
        16 => (HALF_MANTISSA, -1.0),
        unsigned => (unsigned - 5, 0.0),
    };
    let largest = decode_unsigned((31 << mantissa) - 1, mantissa);
    if x.is_finite() {
        x.clamp(least * largest, largest)
    } else if x == f32::NEG_INFINITY && least == 0.0 {
        0.0
    } else {
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The definition, in `f64`.
    fn value(bits: u32, mantissa: i32) -> f64 {
        let (exponent, fraction) = (bits >> mantissa, f64::from(bits & ((1 << mantissa) - 1)));
        let scale = 2.0_f64.powi(mantissa);
        match exponent {
            0 => fraction / scale * 2.0_f64.powi(-14),
            31 if fraction == 0.0 => f64::INFINITY,
            31 => f64::NAN,
            _ => (1.0 + fraction / scale) * 2.0_f64.powi(exponent as i32 - 15),
        }
    }

    #[test]
    fn every_small_float_is_its_definition_and_comes_back() {
        for mantissa in [10, 6, 5] {
            for bits in 0..32 << mantissa {
                let (got, want) = (decode_unsigned(bits, mantissa), value(bits, mantissa as i32));
                if want.is_nan() {
                    assert!(got.is_nan());
                } else {
                    assert_eq!(f64::from(got), want);
                    assert_eq!(encode_unsigned(got, mantissa), bits);
                }
            }
        }
        for bits in 0..65_536 {
            let got = decode_half(bits);
            let sign = if bits & HALF_SIGN == 0 { 1.0 } else { -1.0 };
            let want = sign * value(bits & 0x7FFF, 10);
            assert!(got.is_nan() && want.is_nan() || f64::from(got) == want);
            let back = encode_half(got);
            assert_eq!(back, if got.is_nan() { 0x7E00 } else { bits });
        }
    }

    #[test]
    fn halfway_goes_to_the_even_one_and_a_bit_more_or_less_to_the_nearest() {
        for mantissa in [10_u32, 6, 5] {
            // The last is the largest finite one; above it there is a clamp or inf.
            for below in 0..(31 << mantissa) - 1 {
                let middle =
                    (value(below, mantissa as i32) + value(below + 1, mantissa as i32)) / 2.0;
                let x = middle as f32;
                assert_eq!(f64::from(x), middle);
                let even = below + (below & 1);
                let encode = |x| encode_unsigned(x, mantissa);
                assert_eq!(encode(x), even);
                assert_eq!(encode(x.next_down()), below);
                assert_eq!(encode(x.next_up()), below + 1);
                if mantissa == 10 {
                    assert_eq!(encode_half(-x), even | HALF_SIGN);
                    assert_eq!(encode_half(x.next_up()), below + 1);
                }
            }
        }
    }

    #[test]
    fn the_ends_of_the_range() {
        for (x, half, eleven) in [
            (0.0, 0, 0),
            (-0.0, 0x8000, 0),
            (-1.0, 0xBC00, 0),
            (65_504.0, 0x7BFF, 0x7BF),
            (65_519.996, 0x7BFF, 0x7BF),
            (65_520.0, 0x7C00, 0x7BF),
            (f32::MAX, 0x7C00, 0x7BF),
            (f32::INFINITY, 0x7C00, 0x7C0),
            (f32::NEG_INFINITY, 0xFC00, 0),
            (f32::NAN, 0x7E00, 0x7E0),
            (f32::MIN_POSITIVE, 0, 0),
            (1e-45, 0, 0),
        ] {
            assert_eq!(encode_half(x), half, "{x}");
            assert_eq!(encode_unsigned(x, 6), eleven, "{x}");
        }
    }
}
