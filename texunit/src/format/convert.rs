//! Texel bits to `f32` and back: one definition for single texels and for lanes.
//!
//! A channel is a [`Field`] of one of the texel's words, so it is decoded from that word alone.
//! Blocks of 4×4 texels are in [`super::block`].

use super::small_float::{
    HALF_MANTISSA, decode_half, decode_unsigned, encode_half, encode_unsigned,
};
use super::words::bytes_of;
pub use super::words::expand;
pub(crate) use super::words::words_of;
use super::{Encoding, Field, Format, block, shared_exponent, srgb};
use crate::lanes::math::{NAN, clamp, low_bits, max, round_even, to_i32, to_u32};
use crate::lanes::{F32s, LANES, Simd, U32s};
use std::marker::PhantomData;

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

/// The nearest of `0 ..= largest` to `x * largest`, halves to even. Clamps; NaN gives 0.
#[inline(always)]
fn to_unorm(x: f32, largest: f32) -> u32 {
    to_i32(round_even(clamp(x, 0.0, 1.0) * largest)) as u32
}

/// The nearest of `-largest ..= largest` to `x * largest`, halves to even. Clamps; NaN gives 0.
#[inline(always)]
fn to_snorm(x: f32, largest: f32) -> u32 {
    let number = if x.is_nan() { 0.0 } else { x };
    low_bits(clamp(number, -1.0, 1.0) * largest) as u32
}

/// The bits of an `f32`. Every NaN is stored as one.
#[inline(always)]
pub(crate) fn to_float(x: f32) -> u32 {
    if x.is_nan() { NAN } else { x.to_bits() }
}

/// The nearest of `0 ..= largest`, halves to even. NaN gives 0.
#[inline(always)]
fn to_uint(x: f32, largest: u32) -> u32 {
    let whole = to_u32(round_even(x));
    if whole < largest { whole } else { largest }
}

/// The nearest of `-largest - 1 ..= largest`, halves to even. NaN gives 0.
#[inline(always)]
fn to_sint(x: f32, largest: i32) -> u32 {
    let number = to_i32(round_even(if x.is_nan() { 0.0 } else { x }));
    let above = if number > -largest - 1 { number } else { -largest - 1 };
    (if above < largest { above } else { largest }) as u32
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

/// The texels of 64 colours as words, of which there are [`Format::words`], the first byte lowest; bytes
/// beyond the texel's are 0. [`encode`] is the same for one. Not for compressed formats, which give 0.
#[inline(always)]
pub fn encode_lanes<S: Simd>(format: Format, rgba: [&F32s; 4], out: &mut [U32s; 4]) {
    if format.info().encoding == Encoding::SharedExponent {
        let [r, g, b, _] = rgba;
        for lane in 0..LANES {
            out[0][lane] = shared_exponent::encode(r[lane], g[lane], b[lane]);
        }
        return;
    }
    for words in &mut out[..format.words()] {
        *words = U32s::ZERO;
    }
    for (channel, &source) in format.base().sources().iter().enumerate() {
        let (values, words) = (rgba[source], &mut out[word_of(format, channel)]);
        encode_values(format, channel, Lanes::<S> { values, words, simd: PhantomData });
    }
}

/// The bits of a stored channel in their place. 0 where channels are not encoded one by one.
#[inline(always)]
fn encode_channel(format: Format, channel: usize, x: f32) -> u32 {
    encode_values(format, channel, x)
}

/// What is encoded, by a function that is chosen once for all of it.
trait Values {
    type Bits;
    /// By this function.
    fn by(self, field: Field, bits_of: impl Fn(f32) -> u32) -> Self::Bits;
    /// By this function, to a word of its own.
    fn to_word_by(self, bits_of: impl Fn(f32) -> u32) -> Self::Bits;
    /// By [`srgb::encode`].
    fn by_srgb(self, field: Field) -> Self::Bits;
}

impl Values for f32 {
    type Bits = u32;
    #[inline(always)]
    fn by(self, field: Field, bits_of: impl Fn(Self) -> u32) -> u32 {
        field.put(bits_of(self))
    }
    #[inline(always)]
    fn to_word_by(self, bits_of: impl Fn(Self) -> u32) -> u32 {
        bits_of(self)
    }
    #[inline(always)]
    fn by_srgb(self, field: Field) -> u32 {
        field.put(srgb::encode(self).into())
    }
}

/// Values of lanes, and the words that their bits go into.
struct Lanes<'a, S> {
    values: &'a F32s,
    words: &'a mut U32s,
    simd: PhantomData<S>,
}

impl<S: Simd> Values for Lanes<'_, S> {
    type Bits = ();
    #[inline(always)]
    fn by(self, field: Field, bits_of: impl Fn(f32) -> u32) {
        for lane in 0..LANES {
            self.words[lane] |= field.put(bits_of(self.values[lane]));
        }
    }
    #[inline(always)]
    fn to_word_by(self, bits_of: impl Fn(f32) -> u32) {
        for lane in 0..LANES {
            self.words[lane] = bits_of(self.values[lane]);
        }
    }
    #[inline(always)]
    fn by_srgb(self, field: Field) {
        let bytes = srgb::encode_lanes::<S>(self.values);
        for lane in 0..LANES {
            self.words[lane] |= field.put(bytes[lane]);
        }
    }
}

/// [`encode_channel`] of one value or of lanes.
#[inline(always)]
fn encode_values<V: Values>(format: Format, channel: usize, values: V) -> V::Bits {
    let field = format.field(channel);
    match format.info().encoding {
        Encoding::Srgb if format.is_srgb_channel(channel) => values.by_srgb(field),
        Encoding::Unorm | Encoding::Srgb if field.bits == 32 => {
            // Saturates at the top.
            values.by(field, |x| (f64::from(clamp(x, 0.0, 1.0)) * UNORM32 + 0.5) as u32)
        }
        Encoding::Unorm | Encoding::Srgb => {
            let largest = field.mask() as i32 as f32;
            values.by(field, |x| to_unorm(x, largest))
        }
        Encoding::Snorm => {
            let largest = (field.mask() >> 1) as i32 as f32;
            values.by(field, |x| to_snorm(x, largest))
        }
        Encoding::Float if field.bits == 32 => {
            if format.is_depth() {
                values.to_word_by(|x| to_float(clamp(x, 0.0, 1.0)))
            } else {
                values.to_word_by(to_float)
            }
        }
        Encoding::Float if field.bits == HALF_MANTISSA + 6 => values.by(field, encode_half),
        Encoding::Float => {
            let mantissa = mantissa(field.bits);
            values.by(field, |x| encode_unsigned(x, mantissa))
        }
        Encoding::Uint => values.by(field, |x| to_uint(x, field.mask())),
        Encoding::Sint => values.by(field, |x| to_sint(x, (field.mask() >> 1) as i32)),
        Encoding::SharedExponent | Encoding::Block(_) | Encoding::SrgbBlock(_) => {
            values.by(field, |_| 0)
        }
    }
}

/// The texel of a colour: the first [`Format::bytes`] bytes of the result, the others 0.
///
/// Normalized formats clamp and round to nearest, on the encoded scale for sRGB, NaN to 0; floats
/// are stored unclamped but for depth, integers rounded and clamped, a stencil is 0. A compressed
/// format gives a block whose texels are all this colour.
pub fn encode(format: Format, rgba: [f32; 4]) -> [u8; 16] {
    if format.block().is_some() {
        return block::encode(format, &[rgba; 16]);
    }
    let mut words = [0; 4];
    if format.info().encoding == Encoding::SharedExponent {
        words[0] = shared_exponent::encode(rgba[0], rgba[1], rgba[2]);
    }
    for (channel, &source) in format.base().sources().iter().enumerate() {
        words[word_of(format, channel)] |= encode_channel(format, channel, rgba[source]);
    }
    bytes_of(words)
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
