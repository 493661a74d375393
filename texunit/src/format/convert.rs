//! Texel bits to `f32` and back: one definition for single texels and for lanes.

use super::srgb;
use super::{BaseFormat, Encoding, Format};
use crate::lanes::math::{clamp, round_even, to_i32};
use crate::lanes::{F32s, LANES, Simd, U32s};

/// 1/255 in two parts. The first has 16 significant bits, so that its product with a byte is
/// exact; the sum with the second then rounds as the quotient does (a test holds all 256).
const BYTE_HIGH: f32 = f32::from_bits((1.0_f32 / 255.0).to_bits() & 0xFFFF_FF00);
const BYTE_LOW: f32 = (1.0 / 255.0 - BYTE_HIGH as f64) as f32;

/// `byte / 255` for 0 to 255, the nearest `f32`, without a division.
#[inline(always)]
fn unorm8(byte: u32) -> f32 {
    let c = byte as i32 as f32;
    c * BYTE_HIGH + c * BYTE_LOW
}

/// A linear byte channel of a texel's word.
#[inline(always)]
pub(crate) fn byte_channel(word: u32, channel: usize) -> f32 {
    unorm8(word >> (8 * channel) & 0xFF)
}

/// The nearest of `0 ..= largest` to `x * largest`, halves to even. Clamps; NaN gives 0.
#[inline(always)]
fn to_unorm(x: f32, largest: f32) -> u32 {
    to_i32(round_even(clamp(x, 0.0, 1.0) * largest)) as u32
}

/// One stored channel of 64 texels, whose bytes are in `words`, the first lowest.
#[inline(always)]
pub fn decode_channel<S: Simd>(format: Format, channel: usize, words: &U32s) -> F32s {
    let mut out = F32s::ZERO;
    match format.info().encoding {
        Encoding::Srgb8 if format.is_srgb_channel(channel) => {
            let mut bytes = U32s::ZERO;
            for lane in 0..LANES {
                bytes[lane] = words[lane] >> (8 * channel) & 0xFF;
            }
            out = S::gather_f32(&srgb::DECODE, &bytes);
        }
        Encoding::Unorm8 | Encoding::Srgb8 => {
            for lane in 0..LANES {
                out[lane] = byte_channel(words[lane], channel);
            }
        }
        Encoding::Unorm16 => {
            for lane in 0..LANES {
                out[lane] = (words[lane] & 0xFFFF) as i32 as f32 / 65_535.0;
            }
        }
        Encoding::Unorm24 => {
            for lane in 0..LANES {
                out[lane] = (words[lane] & 0xFF_FFFF) as i32 as f32 / 16_777_215.0;
            }
        }
        Encoding::Float32 => {
            for lane in 0..LANES {
                out[lane] = f32::from_bits(words[lane]);
            }
        }
    }
    out
}

/// The texels of 64 colours, the first byte lowest; the bytes above the texel's are 0. Colours
/// are clamped to 0 to 1 and rounded to nearest, on the encoded scale for sRGB; NaN gives 0.
/// [`encode`] is the same for one.
#[inline(always)]
pub fn encode_lanes(format: Format, rgba: &[F32s; 4]) -> U32s {
    let mut out = U32s::ZERO;
    for (channel, &source) in format.base().sources().iter().enumerate() {
        let values = &rgba[source];
        for lane in 0..LANES {
            out[lane] |= encode_channel(format, channel, values[lane]);
        }
    }
    out
}

#[inline(always)]
fn encode_channel(format: Format, channel: usize, x: f32) -> u32 {
    match format.info().encoding {
        Encoding::Srgb8 if format.is_srgb_channel(channel) => {
            u32::from(srgb::encode(x)) << (8 * channel)
        }
        Encoding::Unorm8 | Encoding::Srgb8 => to_unorm(x, 255.0) << (8 * channel),
        Encoding::Unorm16 => to_unorm(x, 65_535.0),
        Encoding::Unorm24 => to_unorm(x, 16_777_215.0),
        Encoding::Float32 => clamp(x, 0.0, 1.0).to_bits(),
    }
}

/// The texel of a colour: the first [`Format::bytes`] bytes of the result, the others 0. Colours
/// are clamped to 0 to 1 and rounded to nearest, on the encoded scale for sRGB; NaN gives 0.
pub fn encode(format: Format, rgba: [f32; 4]) -> [u8; 4] {
    let mut word = 0;
    for (channel, &source) in format.base().sources().iter().enumerate() {
        word |= encode_channel(format, channel, rgba[source]);
    }
    word.to_le_bytes()
}

/// The stored channels of a texel, unused ones 0. Bytes that are missing count as 0.
pub fn decode_channels(format: Format, texel: &[u8]) -> [f32; 4] {
    let mut bytes = [0; 4];
    for (to, from) in bytes.iter_mut().zip(texel.iter().take(format.bytes())) {
        *to = *from;
    }
    let word = u32::from_le_bytes(bytes);
    let mut out = [0.0; 4];
    for (channel, value) in out.iter_mut().take(format.channels()).enumerate() {
        *value = match format.info().encoding {
            Encoding::Srgb8 if format.is_srgb_channel(channel) => {
                srgb::DECODE[usize::from(bytes[channel])]
            }
            Encoding::Unorm8 | Encoding::Srgb8 => unorm8(u32::from(bytes[channel])),
            Encoding::Unorm16 => (word & 0xFFFF) as f32 / 65_535.0,
            Encoding::Unorm24 => (word & 0xFF_FFFF) as f32 / 16_777_215.0,
            Encoding::Float32 => f32::from_bits(word),
        };
    }
    out
}

/// The colour of a texel as a sample returns it: channels expanded by the base format
/// (GL 2.1, table 3.15 and section 3.8.8), depth as luminance.
pub fn decode(format: Format, texel: &[u8]) -> [f32; 4] {
    let [a, b, c, d] = decode_channels(format, texel);
    match format.base() {
        BaseFormat::Alpha => [0.0, 0.0, 0.0, a],
        BaseFormat::Luminance | BaseFormat::Depth => [a, a, a, 1.0],
        BaseFormat::LuminanceAlpha => [a, a, a, b],
        BaseFormat::Intensity => [a, a, a, a],
        BaseFormat::Red => [a, 0.0, 0.0, 1.0],
        BaseFormat::Rg => [a, b, 0.0, 1.0],
        BaseFormat::Rgb => [a, b, c, 1.0],
        BaseFormat::Rgba => [a, b, c, d],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{Isa, Kernel};

    struct Decode(Format, usize, U32s);
    impl Kernel for Decode {
        type Output = F32s;
        #[inline(always)]
        fn run<S: Simd>(self) -> F32s {
            decode_channel::<S>(self.0, self.1, &self.2)
        }
    }

    struct Encode(Format, [F32s; 4]);
    impl Kernel for Encode {
        type Output = U32s;
        #[inline(always)]
        fn run<S: Simd>(self) -> U32s {
            encode_lanes(self.0, &self.1)
        }
    }

    #[test]
    fn a_byte_is_the_rounded_quotient() {
        for byte in 0..=255 {
            assert_eq!(unorm8(byte).to_bits(), (byte as f32 / 255.0).to_bits(), "{byte}");
        }
    }

    #[test]
    fn every_texel_value_survives_a_round_trip() {
        for format in Format::ALL {
            let info = format.info();
            let values: Vec<u32> = match info.encoding {
                Encoding::Unorm8 | Encoding::Srgb8 => (0..256).map(|v| v * 0x0101_0101).collect(),
                Encoding::Unorm16 => (0..65_536).collect(),
                Encoding::Unorm24 => (0..1 << 24).step_by(251).chain([0xFF_FFFF]).collect(),
                Encoding::Float32 => [0.0_f32, 1e-40, 0.1, 1.0].map(f32::to_bits).to_vec(),
            };
            for value in values {
                let mut texel = value.to_le_bytes();
                texel[info.bytes..].fill(0);
                let mut color = decode(format, &texel);
                if info.base == BaseFormat::Intensity {
                    color[3] = 0.0;
                }
                assert_eq!(encode(format, color), texel, "{format:?}");
            }
        }
    }

    #[test]
    fn lanes_convert_as_single_texels_on_every_instruction_set() {
        let words = U32s::from_fn(|lane| (lane as u32).wrapping_mul(0x9E37_79B9));
        let odd = [f32::NAN, f32::INFINITY, -f32::INFINITY, -0.0, 1e-40, 1.0, 0.5 / 255.0, 2.0];
        let colors: [F32s; 4] = [0, 1, 2, 3].map(|c| {
            F32s::from_fn(|lane| match odd.get(lane) {
                Some(&x) => x,
                None => ((lane * 37 + c * 101) % 256) as f32 / 240.0 - 0.02,
            })
        });
        for isa in Isa::available() {
            for format in Format::ALL {
                let encoded = isa.run(Encode(format, colors));
                for lane in 0..LANES {
                    let want = encode(format, [0, 1, 2, 3].map(|c| colors[c][lane]));
                    assert_eq!(encoded[lane].to_le_bytes(), want, "{format:?} {}", isa.name());
                }
                for channel in 0..format.channels() {
                    let got = isa.run(Decode(format, channel, words));
                    for lane in 0..LANES {
                        let want = decode_channels(format, &words[lane].to_le_bytes())[channel];
                        assert_eq!(got[lane].to_bits(), want.to_bits(), "{format:?}");
                    }
                }
            }
        }
    }
}
