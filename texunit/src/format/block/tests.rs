//! Blocks against the extensions' tables in `f64`, lanes against single texels, and compression.

use super::*;
use crate::format::BaseFormat;
use crate::lanes::{Isa, Kernel};

/// A small generator (splitmix64).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
}

fn compressed() -> impl Iterator<Item = Format> {
    Format::ALL.into_iter().filter(|format| format.block().is_some())
}

/// Random blocks, and some whose ends are equal or one apart.
fn blocks(random: &mut Random) -> Vec<[u8; 16]> {
    (0..400_u32)
        .map(|number| {
            let mut block = [0; 16];
            block[..8].copy_from_slice(&random.bits().to_le_bytes());
            block[8..].copy_from_slice(&random.bits().to_le_bytes());
            if number % 4 == 0 {
                for half in [0, 8] {
                    block[half + 2] = block[half];
                    block[half + 3] = block[half + 1];
                    block[half + 1] = block[half].wrapping_add((number / 4 % 3) as u8);
                }
            }
            if number % 7 == 0 {
                (block[0], block[1]) = (0x81, 0x80);
            }
            block
        })
        .collect()
}

/// `EXT_texture_compression_s3tc`: the colour and alpha of a texel of the 8 bytes of a DXT1 block.
fn s3tc_color(b: &[u8], at: usize, always_four: bool) -> ([f64; 3], f64) {
    let number = |i: usize| u16::from(b[i]) + 256 * u16::from(b[i + 1]);
    let (c0, c1) = (number(0), number(2));
    let rgb = |c: u16| {
        let part = |v: u16, n: f64| f64::from(v) / n;
        [part(c >> 11, 31.0), part(c >> 5 & 63, 63.0), part(c & 31, 31.0)]
    };
    let mix = |m: f64, n: f64, whole: f64| {
        let (x, y) = (rgb(c0), rgb(c1));
        [0, 1, 2].map(|i| (m * x[i] + n * y[i]) / whole)
    };
    let code = b[4 + at / 4] >> (2 * (at % 4)) & 3;
    match (code, always_four || c0 > c1) {
        (0, _) => (rgb(c0), 1.0),
        (1, _) => (rgb(c1), 1.0),
        (2, true) => (mix(2.0, 1.0, 3.0), 1.0),
        (3, true) => (mix(1.0, 2.0, 3.0), 1.0),
        (2, false) => (mix(1.0, 1.0, 2.0), 1.0),
        _ => ([0.0; 3], 0.0),
    }
}

/// A value on a line, `ARB_texture_compression_rgtc` and the alpha of DXT5.
fn line(b: &[u8], at: usize, signed: bool) -> f64 {
    let mut bits = 0_u64;
    for (i, &byte) in b[2..8].iter().enumerate() {
        bits |= u64::from(byte) << (8 * i);
    }
    let code = bits >> (3 * at) & 7;
    let value = |byte: u8| {
        if signed { (f64::from(byte as i8) / 127.0).max(-1.0) } else { f64::from(byte) / 255.0 }
    };
    let (r0, r1) = (value(b[0]), value(b[1]));
    let larger = if signed { b[0] as i8 > b[1] as i8 } else { b[0] > b[1] };
    match (code, larger) {
        (0, _) => r0,
        (1, _) => r1,
        (k, true) => ((8 - k) as f64 * r0 + (k - 1) as f64 * r1) / 7.0,
        (6, false) => {
            if signed {
                -1.0
            } else {
                0.0
            }
        }
        (7, false) => 1.0,
        (k, false) => ((6 - k) as f64 * r0 + (k - 1) as f64 * r1) / 5.0,
    }
}

fn oracle(format: Format, b: &[u8], at: usize) -> [f64; 4] {
    let linear = |c: f64| {
        if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
    };
    let color = |b: &[u8], four: bool| {
        let ([r, g, b], a) = s3tc_color(b, at, four);
        if format.is_srgb() { ([r, g, b].map(linear), a) } else { ([r, g, b], a) }
    };
    let [r, g, b, a] = match format.block().unwrap() {
        Block::Dxt1 => {
            let ([r, g, b], a) = color(b, false);
            [r, g, b, if format.channels() == 4 { a } else { 1.0 }]
        }
        Block::Dxt3 => {
            let ([r, g, blue], _) = color(&b[8..], true);
            [r, g, blue, f64::from(b[at / 2] >> (4 * (at % 2)) & 15) / 15.0]
        }
        Block::Dxt5 => {
            let ([r, g, blue], _) = color(&b[8..], true);
            [r, g, blue, line(b, at, false)]
        }
        Block::Rgtc1 => [line(b, at, false), 0.0, 0.0, 1.0],
        Block::Rgtc1Snorm => [line(b, at, true), 0.0, 0.0, 1.0],
        Block::Rgtc2 => [line(b, at, false), line(&b[8..], at, false), 0.0, 1.0],
        Block::Rgtc2Snorm => [line(b, at, true), line(&b[8..], at, true), 0.0, 1.0],
        Block::Bptc | Block::BptcUnsignedFloat | Block::BptcSignedFloat => {
            unreachable!("tests of its own, and `conformance`")
        }
    };
    // EXT_texture_compression_latc has luminance and alpha where RGTC has red and green.
    match format.base() {
        BaseFormat::Luminance => [r, r, r, 1.0],
        BaseFormat::LuminanceAlpha => [r, r, r, g],
        _ => [r, g, b, a],
    }
}

#[test]
fn every_texel_is_the_nearest_float_to_the_extensions_formula() {
    let blocks = blocks(&mut Random(1));
    for format in compressed().filter(|format| !is_decoded_whole(*format)) {
        for block in &blocks {
            for at in 0..16 {
                let got = decode(format, &block[..format.bytes()], at);
                let want = oracle(format, block, at as usize);
                for c in 0..4 {
                    // The oracle's own roundings may fall on the other side of a tie.
                    let error = (f64::from(got[c]) - want[c]).abs();
                    let half_ulp = f64::from(f32::EPSILON) / 2.0 * want[c].abs();
                    assert!(
                        error <= half_ulp * 1.000_001 + 1e-15,
                        "{format:?} {block:x?} {at} {c}"
                    );
                }
            }
        }
    }
}

struct Decode<'a>(Format, &'a [U32s; 4], &'a U32s);
impl Kernel for Decode<'_> {
    type Output = [F32s; 4];
    #[inline(always)]
    fn run<S: Simd>(self) -> [F32s; 4] {
        let mut out = [F32s::ZERO; 4];
        decode_lanes::<S>(self.0, self.1, self.2, &mut out);
        out
    }
}

#[test]
fn lanes_decode_as_single_texels_on_every_instruction_set() {
    let mut random = Random(2);
    let blocks = blocks(&mut random);
    for format in compressed() {
        for batch in blocks.chunks_exact(LANES) {
            let words =
                [0, 1, 2, 3].map(|word| U32s::from_fn(|lane| words_of(format, &batch[lane])[word]));
            let within = U32s::from_fn(|_| (random.bits() & 15) as u32);
            for isa in Isa::available() {
                let got = isa.run(Decode(format, &words, &within));
                for lane in 0..LANES {
                    let single = [0, 1, 2, 3].map(|word| words[word][lane]);
                    let want = decode_channels(format, single, within[lane]);
                    for c in 0..format.channels() {
                        assert_eq!(got[c][lane].to_bits(), want[c].to_bits(), "{format:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_block_of_one_colour_that_the_format_holds_is_exact() {
    let mut random = Random(3);
    for format in compressed() {
        for _ in 0..200 {
            let bits = random.bits();
            let part = |shift: u32, largest: u64| (bits >> shift & largest) as f32 / largest as f32;
            let mut color = match format.block().unwrap() {
                Block::Dxt1 => [part(0, 31), part(8, 63), part(16, 31), part(24, 1)],
                Block::Dxt3 => [part(0, 31), part(8, 63), part(16, 31), part(24, 15)],
                Block::Dxt5 => [part(0, 31), part(8, 63), part(16, 31), part(24, 255)],
                Block::Bptc => [part(0, 255), part(8, 255), part(16, 255), part(24, 255)],
                Block::BptcUnsignedFloat | Block::BptcSignedFloat => continue,
                Block::Rgtc1 | Block::Rgtc2 => [part(0, 255), part(8, 255), 0.0, 1.0],
                Block::Rgtc1Snorm | Block::Rgtc2Snorm => {
                    let signed = |shift: u32| (bits >> shift) as u8 as i8;
                    [signed(0), signed(8), 0, 127].map(|c| (f32::from(c) / 127.0).max(-1.0))
                }
            };
            if format.is_srgb() {
                continue;
            }
            let block = encode(format, &[color; 16]);
            match (format.base(), format.base().sources().len()) {
                (BaseFormat::Luminance, _) => color = [color[0], color[0], color[0], 1.0],
                (BaseFormat::LuminanceAlpha, _) => color = [color[0], color[0], color[0], color[3]],
                (_, 1) => color = [color[0], 0.0, 0.0, 1.0],
                (_, 3) => color[3] = 1.0,
                _ => {}
            }
            if format == Format::Dxt1Rgba && color[3] == 0.0 {
                color = [0.0; 4];
            }
            for at in 0..16 {
                assert_eq!(decode(format, &block, at), color, "{format:?}");
            }
        }
    }
}

#[test]
fn a_ramp_is_kept_within_a_step_of_its_line() {
    for format in compressed().filter(|format| !format.is_srgb()) {
        let texels: [[f32; 4]; 16] = std::array::from_fn(|i| {
            let t = i as f32 / 15.0;
            [0.2 + 0.6 * t, 0.9 - 0.5 * t, 0.1 + 0.2 * t, 0.5 + 0.5 * t]
        });
        let block = encode(format, &texels);
        for (at, texel) in texels.iter().enumerate() {
            let got = decode(format, &block, at as u32);
            for &source in format.base().sources() {
                // Half of a third of the line, and the rounding of its ends.
                let bound = if format == Format::Dxt1Rgba && source == 3 { 0.5 } else { 0.14 };
                assert!((got[source] - texel[source]).abs() <= bound, "{format:?} {at} {source}");
            }
        }
    }
}

#[test]
fn any_numbers_compress() {
    let odd = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -0.0, 1e-40, 3.0, -7.0, 0.5];
    let texels: [[f32; 4]; 16] = std::array::from_fn(|i| [0, 1, 2, 3].map(|c| odd[(i + c) % 8]));
    for format in compressed() {
        let block = encode(format, &texels);
        for at in 0..16 {
            let got = decode(format, &block, at);
            let most = if decoded_format(format) == Some(Format::Rgb16F) { 65504.0 } else { 1.0 };
            assert!(got.iter().all(|c| (-most..=most).contains(c)), "{format:?}");
        }
    }
}

/// Blocks whose texels follow from the specification by hand: modes, partitions, rotation, bits below the ends.
#[test]
fn blocks_of_bptc_have_the_texels_that_follow_by_hand() {
    let texel = |bits: u128, at| {
        let rgba = decode(Format::Bptc, &bits.to_le_bytes(), at);
        rgba.map(|channel| (channel * 255.0) as u8)
    };
    // Mode 6: ends (0, 0, 0, 0) and (255, 255, 255, 255) of 7 bits and one below; the indices 0 to 15 of 4 bits.
    let mut block = 1_u128 << 6;
    for channel in 0..4 {
        block |= 127 << (14 + 14 * channel);
    }
    block |= 1 << 64;
    for index in 1..16_u128 {
        block |= index << (64 + 4 * index);
    }
    for (at, weight) in [(0, 0), (1, 4), (8, 34), (15, 64)] {
        let value = ((255 * weight + 32) >> 6) as u8;
        assert_eq!(texel(block, at), [value; 4], "texel {at}");
    }
    // Mode 5 with red and alpha exchanged: red has 8 bits of its own.
    let block = 1 << 5 | 1 << 6 | 200_u128 << 50 | 200 << 58 | 127 << 8 | 127 << 15;
    assert_eq!(texel(block, 3), [200, 0, 0, 255]);
    // Mode 3: two subsets, partition 13 has the lower half first; one of 7 bits and 1 each.
    let mut block = 1_u128 << 3 | 13 << 4;
    for channel in 0..3 {
        // Ends 2 and 3 are those of the second subset.
        block |= (127 << 14 | 127 << 21) << (10 + 28 * channel);
    }
    assert_eq!(texel(block, 0), [0, 0, 0, 255]);
    assert_eq!(texel(block, 7), [0, 0, 0, 255]);
    assert_eq!(texel(block, 8), [254, 254, 254, 255]);
    // No mode.
    assert_eq!(texel(0, 5), [0; 4]);
    let float = |format, bits: u128, at| decode(format, &bits.to_le_bytes(), at);
    // Mode 3 of floats: ends of 10 bits as they are.
    let ends = |end: u128| 3 | (0..6).fold(0, |all, at| all | end << (5 + 10 * at));
    let half = |end: u32| ((((end << 16) + 0x8000) >> 10) * 31) >> 6;
    for end in [1, 100, 480, 495, 1022] {
        let expected = small_float::decode_half(half(end));
        let found = float(Format::BptcUnsignedFloat, ends(end.into()), 9);
        assert_eq!(found, [expected, expected, expected, 1.0]);
    }
    assert_eq!(float(Format::BptcUnsignedFloat, ends(1023), 9)[0], 65504.0);
    // Signed: -511 is the least, and so is -512.
    for end in [512, 513] {
        assert_eq!(float(Format::BptcSignedFloat, ends(end), 9)[0], -65504.0);
    }
    assert_eq!(float(Format::BptcSignedFloat, ends(511), 9)[0], 65504.0);
    // Codes that stand for no mode.
    for code in [0b10011, 0b10111, 0b11011, 0b11111] {
        let found = float(Format::BptcSignedFloat, u128::MAX << 5 | code, 2);
        assert_eq!(found, [0.0, 0.0, 0.0, 1.0]);
    }
}

/// Floats of one colour come back within the step of 10 bits, 1/32 of their value and more; others are clamped.
#[test]
fn floats_are_compressed_to_near_values() {
    for (format, values) in [
        (Format::BptcUnsignedFloat, [0.0, 0.001, 0.5, 1.0, 3.3, 1000.0, 65504.0, 1e9]),
        (Format::BptcSignedFloat, [0.0, -0.001, 0.5, -1.0, 3.3, -1000.0, 65504.0, -1e9]),
    ] {
        for value in values {
            let block = encode(format, &[[value, 0.0, value, 1.0]; 16]);
            let found = decode(format, &block, 5);
            let wanted: f32 = value.clamp(-65504.0, 65504.0);
            let bound = wanted.abs() / 24.0;
            assert!((found[0] - wanted).abs() <= bound, "{format:?} {value}: {found:?}");
            assert_eq!(found[0], found[2]);
            assert!(found[1].abs() < 1e-6);
        }
    }
    let block = encode(Format::BptcUnsignedFloat, &[[-1.0, f32::NAN, f32::NEG_INFINITY, 1.0]; 16]);
    assert_eq!(decode(Format::BptcUnsignedFloat, &block, 0), [0.0, 0.0, 0.0, 1.0]);
}

/// A level that is decoded before it is sampled has the texels of its blocks.
#[test]
fn decoded_levels_have_the_texels_of_the_blocks() {
    let mut random = Random(5);
    for format in compressed().filter(|format| is_decoded_whole(*format)) {
        for size in [[1, 1, 1], [7, 5, 3], [16, 8, 1]] {
            let mut level = crate::image::Level::with_size(format, size, [0; 3]).unwrap();
            for bytes in level.texels.chunks_exact_mut(8) {
                bytes.copy_from_slice(&random.bits().to_le_bytes());
            }
            let decoded = level.decoded().expect("there is memory");
            for z in 0..size[2] as i32 {
                for y in 0..size[1] as i32 {
                    for x in 0..size[0] as i32 {
                        let [a, b] = [&level, &decoded].map(|of| of.color_at([x, y, z]).unwrap());
                        assert_eq!(a.map(f32::to_bits), b.map(f32::to_bits), "{format:?}");
                    }
                }
            }
        }
    }
}
