//! What number the bits of a field are, and which bits a number has.
//!
//! Fractions of integers go through `f64`: the quotient is the nearest to the exact one, the product is rounded
//! to nearest, halves to even. What is out of range is clamped, NaN is 0 in all but floats.

use crate::format::convert::{signed, to_float};
use crate::format::small_float::{
    HALF_MANTISSA, decode_half, decode_unsigned, encode_half, encode_unsigned,
};
use crate::format::{Field, shared_exponent, srgb};
use crate::lanes::math::clamp;
use crate::lanes::{F64s, LANES, U32s};

/// What number the bits of a field are. `n` is the field's width in bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberEncoding {
    /// `c / (2^n - 1)` (GL 2.1, table 2.9).
    Unorm,
    /// `(2c + 1) / (2^n - 1)` of `c` in two's complement (GL 2.1, table 2.9).
    Fixed,
    /// `max(c / (2^(n-1) - 1), -1)` of `c` in two's complement (`EXT_texture_snorm`).
    Snorm,
    /// A byte of linear light, sRGB-encoded (`EXT_texture_sRGB`).
    Srgb,
    /// An integer (`EXT_texture_integer`).
    Uint,
    /// An integer in two's complement.
    Sint,
    /// The integer of a signed fraction, of which the two lowest are the same.
    SnormSteps,
    /// IEEE `f32` (32 bits), half float (16), and unsigned floats (11 and 10, `EXT_packed_float`).
    Float,
    /// An `f32` that is clamped to [0, 1] when it is written.
    Depth,
    /// A mantissa of 9 bits, with the exponent in the top 5 bits of the word
    /// (`EXT_texture_shared_exponent`).
    SharedExponent,
}

/// A number whose sum with one below 2^51 has that number, rounded to nearest, halves to even, as its low bits.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// The nearest integer, halves to even, in two's complement, of what lies within -2^31 to 2^32.
#[inline(always)]
fn nearest(x: f64) -> u32 {
    (x + ROUND).to_bits() as u32
}

/// `x` held within two numbers; NaN gives the lower one.
#[inline(always)]
fn held(x: f64, low: f64, high: f64) -> f64 {
    let x = if x > low { x } else { low };
    if x < high { x } else { high }
}

/// `x` held within two numbers; NaN gives 0.
#[inline(always)]
fn held_or_zero(x: f64, low: f64, high: f64) -> f64 {
    held(if x.is_nan() { 0.0 } else { x }, low, high)
}

/// The least and the largest integer of a field in two's complement.
#[inline(always)]
fn signed_range(field: Field) -> [f64; 2] {
    let high = f64::from(field.mask() >> 1);
    [-high - 1.0, high]
}

/// `1 / largest` in two parts, of which the first has so few bits that its product with one of up to 16 is
/// exact: the sum of both products is the nearest `f64` to the quotient (a test holds all).
#[inline(always)]
fn inverse(largest: f64) -> [f64; 2] {
    let high = f64::from_bits((1.0 / largest).to_bits() & !0xFF_FFFF);
    [high, (1.0 - high * largest) / largest]
}

impl NumberEncoding {
    /// Whether its numbers are whole.
    #[inline(always)]
    pub fn is_integer(self) -> bool {
        match self {
            Self::Uint | Self::Sint | Self::SnormSteps => true,
            Self::Unorm | Self::Fixed | Self::Snorm | Self::Srgb => false,
            Self::Float | Self::Depth | Self::SharedExponent => false,
        }
    }

    /// The numbers of a field.
    #[inline(always)]
    pub(super) fn read(self, field: Field, words: &U32s, out: &mut F64s) {
        let signed = |word: u32| f64::from(signed(field, word));
        match self {
            Self::Unorm if field.bits <= 16 => {
                let [high, low] = inverse(field.mask().into());
                for lane in 0..LANES {
                    let c = f64::from(field.of(words[lane]) as i32);
                    out[lane] = c * high + c * low;
                }
            }
            Self::Unorm => {
                let largest = f64::from(field.mask());
                for lane in 0..LANES {
                    out[lane] = f64::from(field.of(words[lane])) / largest;
                }
            }
            Self::Fixed => {
                let all = f64::from(field.mask());
                for lane in 0..LANES {
                    out[lane] = (2.0 * signed(words[lane]) + 1.0) / all;
                }
            }
            Self::Snorm => {
                let largest = f64::from(field.mask() >> 1);
                for lane in 0..LANES {
                    let c = signed(words[lane]) / largest;
                    out[lane] = if c > -1.0 { c } else { -1.0 };
                }
            }
            Self::Srgb => {
                for lane in 0..LANES {
                    out[lane] = srgb::DECODE[(words[lane] >> field.shift & 0xFF) as usize].into();
                }
            }
            Self::Uint => {
                for lane in 0..LANES {
                    out[lane] = field.of(words[lane]).into();
                }
            }
            Self::Sint => {
                for lane in 0..LANES {
                    out[lane] = signed(words[lane]);
                }
            }
            Self::SnormSteps => {
                let lowest = -f64::from(field.mask() >> 1);
                for lane in 0..LANES {
                    let c = signed(words[lane]);
                    out[lane] = if c > lowest { c } else { lowest };
                }
            }
            Self::Float | Self::Depth if field.bits == 32 => {
                for lane in 0..LANES {
                    out[lane] = f32::from_bits(words[lane]).into();
                }
            }
            Self::Float | Self::Depth if field.bits == HALF_MANTISSA + 6 => {
                for lane in 0..LANES {
                    out[lane] = decode_half(field.of(words[lane])).into();
                }
            }
            Self::Float | Self::Depth => {
                for lane in 0..LANES {
                    out[lane] = decode_unsigned(field.of(words[lane]), field.bits - 5).into();
                }
            }
            Self::SharedExponent => {
                for lane in 0..LANES {
                    let word = words[lane];
                    out[lane] = shared_exponent::decode(word, field.of(word)).into();
                }
            }
        }
    }

    /// Adds numbers to the words of a field, whose bits were 0.
    #[inline(always)]
    pub(super) fn write(self, field: Field, numbers: &F64s, words: &mut U32s) {
        match self {
            Self::Unorm => {
                let largest = f64::from(field.mask());
                for lane in 0..LANES {
                    let c = held(numbers[lane], 0.0, 1.0) * largest;
                    words[lane] |= field.put(nearest(c));
                }
            }
            // GL 2.1, table 4.9.
            Self::Fixed => {
                let all = f64::from(field.mask());
                for lane in 0..LANES {
                    let c = held_or_zero(numbers[lane], -1.0, 1.0);
                    words[lane] |= field.put(nearest((c * all - 1.0) / 2.0));
                }
            }
            Self::Snorm => {
                let largest = f64::from(field.mask() >> 1);
                for lane in 0..LANES {
                    let c = held_or_zero(numbers[lane], -1.0, 1.0) * largest;
                    words[lane] |= field.put(nearest(c));
                }
            }
            Self::Srgb => {
                for lane in 0..LANES {
                    let byte = srgb::encode(numbers[lane] as f32);
                    words[lane] |= field.put(byte.into());
                }
            }
            Self::Uint => {
                let largest = f64::from(field.mask());
                for lane in 0..LANES {
                    words[lane] |= field.put(nearest(held(numbers[lane], 0.0, largest)));
                }
            }
            Self::Sint | Self::SnormSteps => {
                let [low, high] = signed_range(field);
                for lane in 0..LANES {
                    let c = held_or_zero(numbers[lane], low, high);
                    words[lane] |= field.put(nearest(c));
                }
            }
            Self::Depth => {
                for lane in 0..LANES {
                    words[lane] |= clamp(numbers[lane] as f32, 0.0, 1.0).to_bits();
                }
            }
            Self::Float if field.bits == 32 => {
                for lane in 0..LANES {
                    words[lane] |= to_float(numbers[lane] as f32);
                }
            }
            Self::Float if field.bits == HALF_MANTISSA + 6 => {
                for lane in 0..LANES {
                    words[lane] |= field.put(encode_half(numbers[lane] as f32));
                }
            }
            Self::Float => {
                for lane in 0..LANES {
                    let bits = encode_unsigned(numbers[lane] as f32, field.bits - 5);
                    words[lane] |= field.put(bits);
                }
            }
            // All at once, see below.
            Self::SharedExponent => {}
        }
    }
}

/// The words of colours with a common exponent.
#[inline(always)]
pub(super) fn write_shared_exponent(numbers: [&F64s; 4], words: &mut U32s) {
    let [r, g, b, _] = numbers;
    for lane in 0..LANES {
        words[lane] = shared_exponent::encode(r[lane] as f32, g[lane] as f32, b[lane] as f32);
    }
}
