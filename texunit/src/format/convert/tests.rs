//! Conversions against `f64`, there and back, and lanes against single texels.

use super::encode::to_snorm;
use super::*;
use crate::format::BaseFormat;
use crate::format::words::bytes_of;
use crate::lanes::{Isa, Kernel, math};

struct Decode<'a>(Format, &'a [U32s; 4]);
impl Kernel for Decode<'_> {
    type Output = [F32s; 4];
    #[inline(always)]
    fn run<S: Simd>(self) -> [F32s; 4] {
        let mut out = [F32s::ZERO; 4];
        decode_lanes::<S>(self.0, &self.1[..self.0.words()], &mut out);
        out
    }
}

struct Encode<'a>(Format, &'a [F32s; 4]);
impl Kernel for Encode<'_> {
    type Output = [U32s; 4];
    #[inline(always)]
    fn run<S: Simd>(self) -> [U32s; 4] {
        let mut out = [U32s::ZERO; 4];
        encode_lanes::<S>(self.0, self.1.each_ref(), &mut out);
        out
    }
}

/// The formats whose texels stand by themselves.
fn plain() -> impl Iterator<Item = Format> {
    Format::ALL.into_iter().filter(|format| format.block().is_none())
}

/// Every value of a channel of up to 16 bits; of wider ones some, the ends among them.
fn channel_values(bits: u32) -> Vec<u32> {
    if bits <= 16 {
        return (0..1 << bits).collect();
    }
    let largest = u32::MAX >> (32 - bits);
    (0..largest).step_by(largest as usize / 4001).chain([1, largest - 1, largest]).collect()
}

/// The texels of a format with each value in every channel at once, and a running one.
fn texels(format: Format) -> Vec<[u32; 4]> {
    let info = format.info();
    let widest = info.fields.iter().map(|f| f.bits).max().unwrap_or(0);
    let mut texels = Vec::new();
    for (number, value) in channel_values(widest).into_iter().enumerate() {
        let mut words = [0; 4];
        for (channel, field) in info.fields.into_iter().enumerate().filter(|(_, f)| f.bits > 0) {
            let moved = value.wrapping_add((channel * number) as u32);
            words[field.word] |= (moved & field.mask()) << field.shift;
        }
        if info.encoding == Encoding::SharedExponent {
            words[0] |= (number as u32 % 32) << 27;
        }
        texels.push(words);
    }
    texels
}

/// What a channel is, in `f64` from the specification's text.
fn oracle(format: Format, channel: usize, words: [u32; 4]) -> f64 {
    let info = format.info();
    let field = info.fields[channel];
    let bits = u64::from(words[field.word]) >> field.shift & ((1 << field.bits) - 1);
    let c = bits as f64;
    let full = (field.bits as f64).exp2();
    let in_twos_complement = if 2.0 * c >= full { c - full } else { c };
    let float = |mantissa: u32| {
        let (e, m) = (bits >> mantissa & 31, (bits & ((1 << mantissa) - 1)) as f64);
        let m = m / f64::from(mantissa).exp2();
        match e {
            0 => m * (-14_f64).exp2(),
            31 if m == 0.0 => f64::INFINITY,
            31 => f64::NAN,
            _ => (1.0 + m) * (e as f64 - 15.0).exp2(),
        }
    };
    match info.encoding {
        Encoding::Srgb if format.base().sources()[channel] != 3 => {
            let c = c / 255.0;
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        }
        Encoding::Unorm | Encoding::Srgb => c / (full - 1.0),
        Encoding::Snorm => (in_twos_complement / (full / 2.0 - 1.0)).max(-1.0),
        Encoding::Float => match field.bits {
            32 => f64::from(f32::from_bits(bits as u32)),
            16 => float(10) * if bits >> 15 == 1 { -1.0 } else { 1.0 },
            11 => float(6),
            _ => float(5),
        },
        Encoding::SharedExponent => c * (f64::from(words[0] >> 27) - 24.0).exp2(),
        Encoding::Uint => c,
        Encoding::Sint => in_twos_complement,
        Encoding::Block(_) | Encoding::SrgbBlock(_) => unreachable!("left out"),
    }
}

#[test]
fn a_byte_is_the_rounded_quotient() {
    for byte in 0..=255 {
        assert_eq!(unorm8(byte).to_bits(), (byte as f32 / 255.0).to_bits(), "{byte}");
        // So that a filter may take either.
        assert_eq!(unorm8(byte) * 255.0, byte as f32, "{byte}");
    }
}

#[test]
fn what_lies_between_bytes_is_divided_within_an_ulp() {
    for step in 0..255 * 4096 {
        let c = step as f32 / 4096.0;
        let (got, want) = (over_255(c), f64::from(c) / 255.0);
        let ulp = f64::from((want as f32).next_up()) - f64::from(want as f32);
        assert!((f64::from(got) - want).abs() <= ulp, "{c}: {got} for {want}");
    }
}

#[test]
fn every_channel_is_the_nearest_float_to_its_definition() {
    for format in plain() {
        for words in texels(format) {
            let got = decode_channels(format, &bytes_of(words)[..format.bytes()]);
            for (channel, got) in got.into_iter().enumerate().take(format.channels()) {
                let want = oracle(format, channel, words);
                let same = got == want as f32 || want.is_nan() && got.is_nan();
                assert!(same, "{format:?} {words:x?}: {got} is not {want}");
            }
        }
    }
}

#[test]
fn every_texel_value_survives_a_round_trip() {
    for format in plain() {
        for words in texels(format) {
            let texel = bytes_of(words);
            let mut color = decode(format, &texel);
            if format.base() == BaseFormat::Intensity {
                color[3] = 0.0;
            }
            let back = encode(format, color);
            let channels = decode_channels(format, &back);
            // -1 has two signed normalized forms, NaN many, a shared exponent too; an `f32` does
            // not hold 32 bits; depth is clamped.
            let exact = match format.info().encoding {
                Encoding::Unorm | Encoding::Srgb => format != Format::D32,
                Encoding::Snorm | Encoding::SharedExponent | Encoding::Float => false,
                Encoding::Uint | Encoding::Sint => format.channel_bits(0) < 32,
                Encoding::Block(_) | Encoding::SrgbBlock(_) => false,
            };
            if exact {
                assert_eq!(back, texel, "{format:?}");
            } else if !format.is_depth() {
                let first = decode_channels(format, &texel);
                for channel in 0..format.channels() {
                    let (a, b) = (first[channel], channels[channel]);
                    // The largest 32-bit integers have no `f32` of their own.
                    let near = format.is_integer() && (a - b).abs() <= a.abs() * f32::EPSILON;
                    assert!(a == b || near || a.is_nan() && b.is_nan(), "{format:?} {a} {b}");
                }
            }
        }
    }
}

#[test]
fn lanes_decode_as_single_texels_on_every_instruction_set() {
    for format in plain() {
        let texels = texels(format);
        for batch in texels.chunks(LANES) {
            // What is above the texel's bytes is the next texel's.
            let used = 8 * format.bytes().min(4) as u32;
            let above = if used < 32 { u32::MAX << used } else { 0 };
            let words = [0, 1, 2, 3].map(|word| {
                U32s::from_fn(|lane| {
                    let noise = if word == 0 { above & 0xA5A5_A5A5 } else { 0 };
                    batch.get(lane).map_or(0, |texel| texel[word]) | noise
                })
            });
            for isa in Isa::available() {
                let got = isa.run(Decode(format, &words));
                for (lane, texel) in batch.iter().enumerate() {
                    let want = decode_channels(format, &bytes_of(*texel));
                    for channel in 0..format.channels() {
                        let (got, want) = (got[channel][lane].to_bits(), want[channel].to_bits());
                        assert_eq!(got, want, "{format:?} {} {texel:x?}", isa.name());
                    }
                }
            }
        }
    }
}

#[test]
fn a_mean_of_bytes_gives_the_same_byte_divided_or_not() {
    let around =
        |half: f32| (half.to_bits().saturating_sub(9)..half.to_bits() + 9).map(f32::from_bits);
    let halves = (0..255).flat_map(|byte| around(byte as f32 + 0.5));
    let all = (0..=255.0_f32.to_bits()).step_by(997).map(f32::from_bits);
    for mean in halves.chain(all) {
        let want = math::byte(over_255(mean));
        assert_eq!(
            [math::unit_byte(over_255(mean)), math::nearest_byte(mean)],
            [want; 2],
            "{mean}"
        );
    }
}

#[test]
fn lanes_encode_as_single_texels_on_every_instruction_set() {
    let odd = [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        -0.0,
        1e-40,
        1.0,
        0.5 / 255.0,
        2.0,
        -1.0,
        65_408.0,
        65_520.0,
        7e4,
        -3e9,
        5e9,
    ];
    for round in 0..200 {
        let colors: [F32s; 4] = [0, 1, 2, 3].map(|c| {
            F32s::from_fn(|lane| match odd.get((lane + 3 * c + round) % 64) {
                Some(&x) => x,
                None => {
                    let noise = ((round * 64 + lane) as u32 * 4 + c as u32)
                        .wrapping_mul(0x9E37_79B9)
                        ^ 0x1234_5678;
                    let exponent = 110 + noise % 35;
                    f32::from_bits(exponent << 23 | (noise >> 7 & 0x807F_FFFF))
                }
            })
        });
        for isa in Isa::available() {
            for format in plain() {
                let encoded = isa.run(Encode(format, &colors));
                for lane in 0..LANES {
                    let want = encode(format, [0, 1, 2, 3].map(|c| colors[c][lane]));
                    let got = bytes_of([0, 1, 2, 3].map(|word| encoded[word][lane]));
                    assert_eq!(got, want, "{format:?} {}", isa.name());
                }
            }
        }
    }
}

#[test]
fn signed_normalized_numbers_are_the_nearest_halves_to_even() {
    for largest in [127.0, 32_767.0_f32] {
        let last = largest as i32;
        for twice in -2 * last - 3..=2 * last + 3 {
            let middle = twice as f32 / 2.0 / largest;
            for x in [middle.next_down(), middle, middle.next_up()] {
                let want = (x.clamp(-1.0, 1.0) * largest).round_ties_even() as i32;
                assert_eq!(to_snorm(x, largest) as i32, want, "{x}");
            }
        }
        assert_eq!(to_snorm(f32::NAN, largest), 0);
    }
}

#[test]
fn colours_go_to_the_nearest_code_and_clamp() {
    use Format::{D32F, L16F, R3G3B2, R5G6B5, R8Snorm, R32F, Rgb5A1, Rgb10A2, Rgba4};
    let cases: [(Format, [f32; 4], &[u8]); 9] = [
        (R3G3B2, [1.0, 0.0, 0.5, 0.0], &[0b1110_0010]),
        (R5G6B5, [1.0, 0.0, 1.0, 0.0], &[0x1F, 0xF8]),
        (Rgba4, [1.0, 0.0, 0.2, 2.0], &[0x3F, 0xF0]),
        (Rgb5A1, [0.0, 1.0, 0.0, 0.6], &[0xC1, 0x07]),
        (Rgb10A2, [1.0, 0.0, 0.0, 1.0], &[0xFF, 0x03, 0x00, 0xC0]),
        (R8Snorm, [-1.0, 0.0, 0.0, 0.0], &[0x81]),
        (L16F, [-2.0, 0.0, 0.0, 0.0], &[0x00, 0xC0]),
        (R32F, [7.5, 0.0, 0.0, 0.0], &[0, 0, 0xF0, 0x40]),
        (D32F, [7.5, 0.0, 0.0, 0.0], &[0, 0, 0x80, 0x3F]),
    ];
    for (format, color, want) in cases {
        assert_eq!(&encode(format, color)[..want.len()], want, "{format:?}");
    }
}
