//! Colours to the words of an attachment and back, for every format that can be drawn to.

use texunit::format::convert::{self, word_of};
use texunit::format::{BaseFormat, Encoding, Format};
use texunit::lanes::{Baseline, F32s, Kernel, LANES, Simd, U32s, math};

/// `[0, 1]` to 0 … `largest`, rounded to nearest; NaN gives 0 (GL 2.1, section 2.14.9).
#[inline(always)]
pub fn unorm(c: f32, largest: f32) -> u32 {
    math::index(c * largest + 0.5, largest)
}

/// The texels of 64 colours: one vector for each word of the format. Not inlined, as it is large.
#[inline(always)]
pub fn encode_color<S: Simd>(format: Format, rgba: [&F32s; 4], out: &mut [U32s; 4]) {
    S::outlined(Encode { format, rgba, out });
}

/// The colours of 64 texels, as blending sees them: components that are not stored are 0, alpha 1. Not inlined.
#[inline(always)]
pub fn decode_color<S: Simd>(format: Format, words: [&U32s; 4]) -> [F32s; 4] {
    S::outlined(Decode { format, words })
}

struct Encode<'a> {
    format: Format,
    rgba: [&'a F32s; 4],
    out: &'a mut [U32s; 4],
}

impl Kernel for Encode<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { format, rgba, out } = self;
        match format.info().encoding {
            Encoding::Unorm => {}
            Encoding::Srgb
            | Encoding::Snorm
            | Encoding::Float
            | Encoding::SharedExponent
            | Encoding::Uint
            | Encoding::Sint
            | Encoding::Block(_)
            | Encoding::SrgbBlock(_) => return convert::encode_lanes::<S>(format, rgba, out),
        }
        for words in &mut out[..format.words()] {
            *words = U32s::ZERO;
        }
        for (channel, &source) in format.base().sources().iter().enumerate() {
            let field = format.field(channel);
            let largest = field.mask() as i32 as f32;
            let (values, to) = (rgba[source], &mut out[field.word]);
            for lane in 0..LANES {
                to[lane] |= unorm(values[lane], largest) << field.shift;
            }
        }
    }
}

struct Decode<'a> {
    format: Format,
    words: [&'a U32s; 4],
}

impl Kernel for Decode<'_> {
    type Output = [F32s; 4];
    #[inline(always)]
    fn run<S: Simd>(self) -> [F32s; 4] {
        let Self { format, words } = self;
        let mut rgba = [F32s::ZERO, F32s::ZERO, F32s::ZERO, F32s::splat(1.0)];
        for (channel, &source) in format.base().sources().iter().enumerate() {
            let words = words[word_of(format, channel)];
            rgba[source] = convert::decode_channel::<S>(format, channel, words);
        }
        if format.base() == BaseFormat::Intensity {
            rgba[3] = rgba[0];
        }
        rgba
    }
}

/// The words of an RGBA colour in an attachment of this format, as a draw of that colour would
/// write them. It is one texel: no kernel, but what every machine has.
pub fn texel_words(format: Format, color: [f32; 4]) -> [u32; 4] {
    let [r, g, b, a] = color;
    let lanes = [F32s::splat(r), F32s::splat(g), F32s::splat(b), F32s::splat(a)];
    let mut words = [U32s::ZERO; 4];
    encode_color::<Baseline>(format, lanes.each_ref(), &mut words);
    words.map(|word| word[0])
}

/// The words of a texel as the colour that blending sees; integers as numbers.
pub fn texel_color(format: Format, words: [u32; 4]) -> [f32; 4] {
    if !format.is_integer() {
        let lanes = words.map(U32s::splat);
        return decode_color::<Baseline>(format, lanes.each_ref()).map(|c| c[0]);
    }
    let info = format.info();
    let mut rgba = [0.0, 0.0, 0.0, 1.0];
    for (field, &source) in info.fields.iter().zip(format.base().sources()) {
        let (up, down) = (32 - field.bits - field.shift, 32 - field.bits);
        let top = words[field.word] << up;
        let is_signed = info.encoding == Encoding::Sint;
        rgba[source] = if is_signed { (top as i32 >> down) as f32 } else { (top >> down) as f32 };
    }
    rgba
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_normalized_number_is_clamped_scaled_and_rounded() {
        for bits in 1..=16 {
            let largest = ((1_u32 << bits) - 1) as f32;
            for at in (0..=u32::MAX).step_by(65_521) {
                let c = f32::from_bits(at);
                let held = if c > 0.0 { c.min(1.0) } else { 0.0 };
                assert_eq!(unorm(c, largest), (held * largest + 0.5) as u32, "{c} of {largest}");
            }
        }
    }
}
