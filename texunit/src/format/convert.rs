//! Texel bits to `f32` and back: one definition for single texels and for lanes.
//!
//! A channel is a [`Field`] of one of the texel's words, so it is decoded from that word alone.
//! Blocks of 4×4 texels are in [`super::block`].

use super::small_float::{decode_half, decode_unsigned};
mod encode;

pub use super::words::expand;
pub(crate) use super::words::words_of;
use super::{Encoding, Field, Format, block, shared_exponent, srgb};
use crate::lanes::math::{NAN, max};
use crate::lanes::{F32s, LANES, Simd, U32s};
pub use encode::{encode, encode_lanes};

/// 1/255 in two parts. The first has 16 significant bits, so that its product with a byte is
/// exact; the sum with the second then rounds as the quotient does (a test holds all 256).
const BYTE_HIGH: f32 = f32::from_bits((1.0_f32 / 255.0).to_bits() & 0xFFFF_FF00);
const BYTE_LOW: f32 = (1.0 / 255.0 - BYTE_HIGH as f64) as f32;

/// `1 / (2^n - 1)` in two parts, as those of 1/255, for `n` up to 16. The first has 8 significant bits.
const INVERSES: [[f32; 2]; 17] = {
    let mut table = [[0.0; 2]; 17];
    let mut bits = 1;
    while bits < 17 {
        let inverse = 1.0 / ((1_u32 << bits) - 1) as f64;
        let high = f32::from_bits((inverse as f32).to_bits() & 0xFFFF_0000);
        table[bits] = [high, (inverse - high as f64) as f32];
        bits += 1;
    }
    table
};

/// The largest 32-bit unsigned normalized number.
const UNORM32: f64 = u32::MAX as f64;

/// `c / 255` for 0 to 255, without a division: of a byte the nearest `f32`, of what lies between bytes
/// within 1 ULP of it.
#[inline(always)]
pub fn over_255(c: f32) -> f32 {
    c * BYTE_HIGH + c * BYTE_LOW
}

/// `byte / 255` for 0 to 255, the nearest `f32`.
#[inline(always)]
fn unorm8(byte: u32) -> f32 {
    over_255(byte as i32 as f32)
}

/// A byte of a texel's word, 0 to 255.
#[inline(always)]
pub fn byte_of(word: u32, byte: usize) -> f32 {
    (word >> (8 * byte) & 0xFF) as i32 as f32
}

/// A linear byte channel of a texel's word: `byte / 255` (GL 2.1, table 2.9).
#[inline(always)]
pub fn byte_channel(word: u32, channel: usize) -> f32 {
    over_255(byte_of(word, channel))
}

#[inline(always)]
fn unorm32(bits: u32) -> f32 {
    (f64::from(bits) / UNORM32) as f32
}

/// The nearest `f32` to a whole number over that of which these are the [`INVERSES`].
#[inline(always)]
fn over(c: i32, [high, low]: [f32; 2]) -> f32 {
    c as f32 * high + c as f32 * low
}

/// A signed normalized number.
#[inline(always)]
fn snorm(c: i32, inverse: [f32; 2]) -> f32 {
    max(over(c, inverse), -1.0)
}

/// The field of a word in two's complement.
#[inline(always)]
pub(crate) fn signed(field: Field, word: u32) -> i32 {
    let unused = 32 - field.bits;
    ((field.of(word) << unused) as i32) >> unused
}

/// The bits of a mantissa in a float of this many bits without sign.
#[inline(always)]
const fn mantissa(bits: u32) -> u32 {
    bits - 5
}

/// The bits of an `f32`. Every NaN is stored as one.
#[inline(always)]
pub(crate) fn to_float(x: f32) -> u32 {
    if x.is_nan() { NAN } else { x.to_bits() }
}

/// Which word of a texel holds this stored channel.
#[inline(always)]
pub const fn word_of(format: Format, channel: usize) -> usize {
    format.field(channel).word
}

/// One stored channel of 64 texels from the word that holds it ([`word_of`]). Bits above the
/// texel's bytes do not matter. Integers become the nearest `f32`. Not for compressed formats,
/// which give 0.
#[inline(always)]
pub fn decode_channel<S: Simd>(format: Format, channel: usize, words: &U32s) -> F32s {
    let field = format.field(channel);
    let mut out = F32s::ZERO;
    match format.info().encoding {
        Encoding::Srgb if format.is_srgb_channel(channel) => {
            let mut bytes = U32s::ZERO;
            for lane in 0..LANES {
                bytes[lane] = words[lane] >> field.shift & 0xFF;
            }
            out = S::gather_f32(&srgb::DECODE, &bytes);
        }
        Encoding::Unorm | Encoding::Srgb if field.bits == 8 => {
            for lane in 0..LANES {
                out[lane] = unorm8(words[lane] >> field.shift & 0xFF);
            }
        }
        Encoding::Unorm | Encoding::Srgb if field.bits == 32 => {
            for lane in 0..LANES {
                out[lane] = unorm32(words[lane]);
            }
        }
        Encoding::Unorm | Encoding::Srgb if field.bits > 16 => {
            let largest = field.mask() as i32 as f32;
            for lane in 0..LANES {
                out[lane] = field.of(words[lane]) as i32 as f32 / largest;
            }
        }
        Encoding::Unorm | Encoding::Srgb => {
            let inverse = INVERSES[field.bits as usize];
            for lane in 0..LANES {
                out[lane] = over(field.of(words[lane]) as i32, inverse);
            }
        }
        Encoding::Snorm => {
            let inverse = INVERSES[field.bits as usize - 1];
            for lane in 0..LANES {
                out[lane] = snorm(signed(field, words[lane]), inverse);
            }
        }
        Encoding::Float if field.bits == 32 => {
            for lane in 0..LANES {
                out[lane] = f32::from_bits(words[lane]);
            }
        }
        Encoding::Float if field.bits == 16 => {
            for lane in 0..LANES {
                out[lane] = decode_half(field.of(words[lane]));
            }
        }
        Encoding::Float => {
            for lane in 0..LANES {
                out[lane] = decode_unsigned(field.of(words[lane]), mantissa(field.bits));
            }
        }
        Encoding::SharedExponent => {
            for lane in 0..LANES {
                out[lane] = shared_exponent::decode(words[lane], field.of(words[lane]));
            }
        }
        Encoding::Uint => {
            for lane in 0..LANES {
                out[lane] = field.of(words[lane]) as f32;
            }
        }
        Encoding::Sint => {
            for lane in 0..LANES {
                out[lane] = signed(field, words[lane]) as f32;
            }
        }
        Encoding::Block(_) | Encoding::SrgbBlock(_) => {}
    }
    out
}

/// The stored channels of 64 texels from their words, of which there are [`Format::words`]. Only
/// the stored channels of `out` are written. Not for compressed formats: see
/// [`block::decode_lanes`].
#[inline(always)]
pub fn decode_lanes<S: Simd>(format: Format, words: &[U32s], out: &mut [F32s; 4]) {
    for (channel, out) in out.iter_mut().enumerate().take(format.channels()) {
        *out = decode_channel::<S>(format, channel, &words[word_of(format, channel)]);
    }
}

/// One stored channel of a texel's words: [`decode_channel`] for one.
#[inline(always)]
fn decode_field(format: Format, channel: usize, words: [u32; 4]) -> f32 {
    let info = format.info();
    let field = info.fields[channel];
    let word = words[field.word];
    let bits = field.of(word);
    match info.encoding {
        Encoding::Srgb if format.is_srgb_channel(channel) => srgb::DECODE[(bits & 0xFF) as usize],
        Encoding::Unorm | Encoding::Srgb => match field.bits {
            8 => unorm8(bits),
            32 => unorm32(bits),
            17.. => bits as f32 / field.mask() as f32,
            _ => over(bits as i32, INVERSES[field.bits as usize]),
        },
        Encoding::Snorm => snorm(signed(field, word), INVERSES[field.bits as usize - 1]),
        Encoding::Float => match field.bits {
            32 => f32::from_bits(word),
            16 => decode_half(bits),
            _ => decode_unsigned(bits, mantissa(field.bits)),
        },
        Encoding::SharedExponent => shared_exponent::decode(word, bits),
        Encoding::Uint => bits as f32,
        Encoding::Sint => signed(field, word) as f32,
        Encoding::Block(_) | Encoding::SrgbBlock(_) => 0.0,
    }
}

/// The stored channels of a texel, unused ones 0. Bytes that are missing count as 0. Of a
/// compressed format, those of its block's first texel.
pub fn decode_channels(format: Format, texel: &[u8]) -> [f32; 4] {
    let words = words_of(format, texel);
    if format.block().is_some() {
        return block::decode_channels(format, words, 0);
    }
    let mut out = [0.0; 4];
    for (channel, value) in out.iter_mut().take(format.channels()).enumerate() {
        *value = decode_field(format, channel, words);
    }
    out
}

/// The colour of a texel as a sample returns it: channels expanded by the base format
/// (GL 2.1, table 3.15 and section 3.8.8), depth as luminance.
pub fn decode(format: Format, texel: &[u8]) -> [f32; 4] {
    expand(format.base(), decode_channels(format, texel))
}

#[cfg(test)]
mod tests;
