//! Colours to texel bits: one definition for single texels and for lanes.

use super::{UNORM32, mantissa, to_float, word_of};
use crate::format::small_float::{HALF_MANTISSA, encode_half, encode_unsigned};
use crate::format::words::bytes_of;
use crate::format::{Encoding, Field, Format, block, shared_exponent, srgb};
use crate::lanes::math::{clamp, low_bits, round_even, to_i32, to_u32};
use crate::lanes::{F32s, LANES, Simd, U32s};
use std::marker::PhantomData;

/// The nearest of `0 ..= largest` to `x * largest`, halves to even. Clamps; NaN gives 0.
#[inline(always)]
fn to_unorm(x: f32, largest: f32) -> u32 {
    to_i32(round_even(clamp(x, 0.0, 1.0) * largest)) as u32
}

/// The nearest of `-largest ..= largest` to `x * largest`, halves to even. Clamps; NaN gives 0.
#[inline(always)]
pub(super) fn to_snorm(x: f32, largest: f32) -> u32 {
    let number = if x.is_nan() { 0.0 } else { x };
    low_bits(clamp(number, -1.0, 1.0) * largest) as u32
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

/// One value or lanes of values; the encoding function is chosen once for all of them.
trait Values {
    type Bits;
    /// Encodes with `bits_of`, into the field of a word.
    fn by(self, field: Field, bits_of: impl Fn(f32) -> u32) -> Self::Bits;
    /// Encodes with `bits_of`, into a whole word.
    fn to_word_by(self, bits_of: impl Fn(f32) -> u32) -> Self::Bits;
    /// Encodes with [`srgb::encode`].
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
