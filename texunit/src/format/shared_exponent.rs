//! RGB9_E5: three mantissas of 9 bits and one exponent (`EXT_texture_shared_exponent`).

use super::small_float::power_of_two;
use crate::lanes::math::{max, min, to_i32};

/// N, bits of a mantissa.
const MANTISSA: i32 = 9;
/// B, the exponent's bias.
const BIAS: i32 = 15;
/// `sharedexp_max`: `(2^N - 1) / 2^N · 2^(31 - B)`.
pub const LARGEST: f32 = 65_408.0;

/// One channel of a word. Exact.
#[inline(always)]
pub(crate) const fn decode(word: u32, mantissa: u32) -> f32 {
    let exponent = (word >> 27) as i32;
    mantissa as i32 as f32 * power_of_two(exponent - BIAS - MANTISSA)
}

/// `⌊x + 1/2⌋` of 0 to 512, exact: the sum in `f32` would round.
#[inline(always)]
fn round_half_up(x: f32) -> i32 {
    let whole = to_i32(x);
    let part = x - whole as f32;
    if part >= 0.5 { whole + 1 } else { whole }
}

/// The word of a colour, by the steps of section 3.8.x of the extension. Negative and NaN give 0.
#[inline(always)]
pub fn encode(r: f32, g: f32, b: f32) -> u32 {
    // `max` gives its second argument where the first is NaN.
    let (r, g, b) =
        (min(max(r, 0.0), LARGEST), min(max(g, 0.0), LARGEST), min(max(b, 0.0), LARGEST));
    let largest = max(max(r, g), b);
    // floor(log2) is the exponent of the number itself; what is denormal is far below 2^-16.
    let log2 = (largest.to_bits() >> 23) as i32 - 127;
    let preliminary = (if log2 > -BIAS - 1 { log2 } else { -BIAS - 1 }) + 1 + BIAS;
    let overflows =
        round_half_up(largest * power_of_two(BIAS + MANTISSA - preliminary)) == 1 << MANTISSA;
    let exponent = if overflows { preliminary + 1 } else { preliminary };
    let scale = power_of_two(BIAS + MANTISSA - exponent);
    let [r, g, b] = [round_half_up(r * scale), round_half_up(g * scale), round_half_up(b * scale)];
    r as u32 | (g as u32) << 9 | (b as u32) << 18 | (exponent as u32) << 27
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The extension's formulas in `f64`, word for word.
    fn oracle(color: [f64; 3]) -> u32 {
        let [r, g, b] = color.map(|c| c.clamp(0.0, (511.0 / 512.0) * 65_536.0));
        let largest = r.max(g).max(b);
        let preliminary = (-16.0_f64).max(largest.log2().floor()) + 1.0 + 15.0;
        let max_s = (largest / (preliminary - 15.0 - 9.0).exp2() + 0.5).floor();
        let exponent = if max_s < 512.0 { preliminary } else { preliminary + 1.0 };
        let s = |c: f64| (c / (exponent - 15.0 - 9.0).exp2() + 0.5).floor() as u32;
        s(r) | s(g) << 9 | s(b) << 18 | (exponent as u32) << 27
    }

    #[test]
    fn colours_are_encoded_as_the_extension_says() {
        let mut seed = 1_u32;
        let mut random = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            seed >> 8
        };
        for _ in 0..200_000 {
            let exponent = random() % 60;
            let c = [(); 3].map(|()| f32::from_bits(((90 + exponent) << 23) | random() >> 1));
            assert_eq!(encode(c[0], c[1], c[2]), oracle(c.map(f64::from)), "{c:?}");
        }
        for c in [[511.5, 0.0, 0.0], [65_408.0, 1e9, 3.0], [0.99902, 1.0, 0.5], [0.0; 3]] {
            assert_eq!(encode(c[0], c[1], c[2]), oracle(c.map(f64::from)), "{c:?}");
        }
        assert_eq!(encode(f32::NAN, -1.0, f32::NEG_INFINITY), 0);
        assert_eq!(encode(f32::INFINITY, 0.0, 0.0), 31 << 27 | 511);
    }

    #[test]
    fn channels_are_decoded_as_the_extension_says() {
        for exponent in 0..32_u32 {
            for mantissa in 0..512 {
                let got = f64::from(decode(exponent << 27 | mantissa, mantissa));
                assert_eq!(got, f64::from(mantissa) * (f64::from(exponent) - 24.0).exp2());
            }
        }
    }
}
