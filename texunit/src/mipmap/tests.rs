//! The box filter against the integral over each texel's area, in `f64`.

use super::*;
use crate::format::{Encoding, Format};

fn level(format: Format, width: u32, height: u32, texels: &[u8]) -> Level {
    Level::from_texels(format, width, height, texels).unwrap()
}

fn averaged() -> impl Iterator<Item = Format> {
    Format::ALL.into_iter().filter(|f| f.has_mean() && f.block().is_none())
}

/// A level of noise: any bits where every bit pattern is a number, else colours.
fn noise(format: Format, size: [u32; 3], border: [u32; 3], seed: u32) -> Level {
    let mut level = Level::with_size(format, size, border).unwrap();
    let mut state = seed;
    level.fill(|_| {
        [(); 4].map(|()| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / 16_777_216.0
        })
    });
    level
}

/// How much of texel `x` of `size` lies in texel `i` of `half`, along one axis with a border.
fn overlap(size: u32, half: u32, i: i32, x: i32) -> f64 {
    let (low, high) = (i < 0 || x < 0, i >= half as i32 || x >= size as i32);
    if half == size || low || high {
        // A border belongs to the border on its own side.
        let same = if half == size {
            i == x
        } else {
            (i < 0 && x < 0) || (i >= half as i32 && x >= size as i32)
        };
        return if same { 1.0 } else { 0.0 };
    }
    let scale = f64::from(size) / f64::from(half);
    let (from, to) = (f64::from(i) * scale, f64::from(i + 1) * scale);
    (to.min(f64::from(x) + 1.0) - from.max(f64::from(x))).max(0.0)
}

fn oracle(larger: &Level, half: [u32; 3], at: [i32; 3]) -> [f64; 4] {
    let range = |axis: usize| {
        let border = larger.border[axis] as i32;
        let (size, near) = (larger.size()[axis] as i32, 2 * at[axis]);
        let identity = half[axis] == larger.size()[axis];
        let (low, high) = if identity { (at[axis], at[axis]) } else { (near - 2, near + 3) };
        low.max(-border)..=high.min(size - 1 + border)
    };
    let (mut sum, mut total) = ([0.0; 4], 0.0);
    for z in range(2) {
        for y in range(1) {
            for x in range(0) {
                let weight: f64 = (0..3)
                    .map(|axis| overlap(larger.size()[axis], half[axis], at[axis], [x, y, z][axis]))
                    .product();
                let channels = larger.channels_at([x, y, z]).unwrap();
                total += weight;
                for c in 0..4 {
                    sum[c] += if weight > 0.0 { weight * f64::from(channels[c]) } else { 0.0 };
                }
            }
        }
    }
    sum.map(|sum| sum / total)
}

/// Half the distance between the neighbours of a channel's value.
fn rounding(format: Format, channel: usize, value: f64) -> f64 {
    let bits = format.channel_bits(channel);
    let relative = |mantissa: i32| value.abs() * 2.0_f64.powi(-mantissa - 1);
    match format.info().encoding {
        Encoding::Srgb if format.is_srgb_channel(channel) => {
            // On the encoded scale, whose slope is below 2.3.
            2.3 * 0.5 / 255.0
        }
        Encoding::Unorm | Encoding::Srgb => 0.5 / ((1_u64 << bits) - 1) as f64,
        Encoding::Snorm => 0.5 / ((1_u64 << (bits - 1)) - 1) as f64,
        // The exponent is the largest channel's, at most 1 here.
        Encoding::SharedExponent => 0.5 / 256.0,
        _ => relative(match bits {
            32 => 23,
            16 => 10,
            11 => 6,
            _ => 5,
        }),
    }
}

#[test]
fn every_format_and_shape_is_the_integral_over_its_area() {
    let cases = [
        (Shape::D1, [13, 1, 1]),
        (Shape::D2, [7, 5, 1]),
        (Shape::D2, [6, 1, 1]),
        (Shape::D2, [8, 4, 1]),
        (Shape::D2, [1, 9, 1]),
        (Shape::D3, [5, 4, 3]),
        (Shape::D3, [2, 2, 7]),
        (Shape::Cube, [3, 3, 1]),
        (Shape::D1Array, [6, 1, 3]),
        (Shape::D2Array, [4, 3, 3]),
        (Shape::CubeArray, [5, 5, 6]),
    ];
    for format in averaged() {
        for (number, (shape, size)) in cases.into_iter().enumerate() {
            for border in [0, 1] {
                let border = shape.border(border);
                let larger = noise(format, size, border, number as u32);
                let smaller = larger.halved(shape, Isa::BASELINE).unwrap();
                let half = shape.halved(size);
                assert_eq!(smaller.size(), half);
                assert_eq!(smaller.border, border);
                let [w, h, d] = smaller.stored_size();
                for i in 0..w * h * d {
                    let place = [i % w, i / w % h, i / (w * h)];
                    let at = [0, 1, 2].map(|axis| place[axis] as i32 - border[axis] as i32);
                    let want = oracle(&larger, half, at);
                    let got = smaller.channels_at(at).unwrap();
                    for c in 0..format.channels() {
                        let error = (f64::from(got[c]) - want[c]).abs();
                        let bound = rounding(format, c, want[c]) * 1.001 + 1e-7;
                        assert!(error <= bound, "{format:?} {shape:?} {at:?}: {got:?} {want:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn every_instruction_set_gives_the_same_level() {
    for format in averaged() {
        for size in [[64, 6, 1], [37, 5, 1], [66, 1, 1]] {
            let larger = noise(format, size, [0; 3], 9);
            let want = larger.halved(Shape::D2, Isa::BASELINE).unwrap();
            for isa in Isa::available() {
                assert_eq!(larger.halved(Shape::D2, isa).unwrap(), want, "{format:?}");
            }
        }
    }
}

#[test]
fn sides_are_covered_exactly() {
    for size in [2, 3, 5, 7, 8, 101] {
        let mut weights = vec![0.0; size as usize];
        // Every smaller texel covers size/half texels, every texel is covered in full.
        for cover in AxisTaps::all(size, size / 2, 0) {
            for (x, weight) in cover.taps() {
                weights[x] += weight;
            }
        }
        assert!(weights.iter().all(|&w| w == weights[0]), "{size}: {weights:?}");
    }
}

#[test]
fn bytes_round_half_up_and_odd_sides_weigh_their_area() {
    let cases: [(Level, &[u8]); 6] = [
        (level(Format::L8, 2, 1, &[0, 1]), &[1]),
        (level(Format::L8, 2, 2, &[0, 0, 0, 1]), &[0]),
        (level(Format::L8, 2, 2, &[0, 1, 0, 1]), &[1]),
        (level(Format::L8, 3, 1, &[10, 20, 60]), &[30]),
        // 5 → 2: weights 2 2 1 0 0 and 0 0 1 2 2 over 5.
        (level(Format::L8, 5, 1, &[10, 20, 30, 40, 50]), &[18, 42]),
        (level(Format::Rgb8, 1, 2, &[0, 10, 255, 255, 20, 255]), &[128, 15, 255]),
    ];
    for (larger, want) in cases {
        let got = larger.halved(Shape::D2, Isa::best()).unwrap();
        assert_eq!(&got.texels[..want.len()], want, "{larger:?}");
        assert_eq!(got.texels.len(), want.len() + 3);
    }
}

#[test]
fn srgb_is_averaged_in_linear_light_and_its_alpha_is_not() {
    let got = level(Format::Srgb8A8, 2, 1, &[0, 0, 0, 0, 255, 255, 255, 255])
        .halved(Shape::D2, Isa::best())
        .unwrap();
    assert_eq!(got.texel(0, 0), [188, 188, 188, 128]);
}

#[test]
fn floats_keep_what_is_not_finite_to_the_texels_it_covers() {
    let texels = [f32::INFINITY, 1.0, 2.0, 4.0, f32::NAN, 0.0].map(f32::to_le_bytes).concat();
    let got = level(Format::R32F, 6, 1, &texels).halved(Shape::D2, Isa::best()).unwrap();
    let values = [0, 1, 2].map(|x| got.color_at([x, 0, 0]).unwrap()[0]);
    assert_eq!(values[..2], [f32::INFINITY, 3.0]);
    assert_eq!(values[2].to_bits(), 0x7FC0_0000);
}

#[test]
fn a_constant_image_stays_constant_in_every_format() {
    for format in averaged() {
        let texel = crate::format::convert::encode(format, [0.3, 0.7, 0.1, 0.9]);
        let texels = texel[..format.bytes()].repeat(13 * 6);
        let mut image = Image::new(Shape::D2);
        image.set_level(0, 0, level(format, 13, 6, &texels)).unwrap();
        image.generate_mipmaps(Isa::best(), 0, 1000).unwrap();
        for (number, size) in [(1, [6, 3]), (2, [3, 1]), (3, [1, 1])] {
            let made = image.level(0, number).unwrap();
            assert_eq!([made.width, made.height], size);
            assert_eq!(made.texel(0, 0), &texel[..format.bytes()], "{format:?}");
        }
        assert!(image.level(0, 4).is_none());
    }
}

#[test]
fn what_has_no_mean_is_refused() {
    for format in Format::ALL {
        let mut image = Image::new(Shape::D2);
        image.set_level(0, 0, Level::new(format, 8, 8).unwrap()).unwrap();
        let made = image.generate_mipmaps(Isa::best(), 0, 9);
        let want = if format.has_mean() { Ok(()) } else { Err(ImageError::NoMean { format }) };
        assert_eq!(made, want);
    }
}

#[test]
fn the_largest_level_ends_the_pyramid_and_a_missing_base_is_an_error() {
    let mut image = Image::new(Shape::D2);
    assert!(image.generate_mipmaps(Isa::best(), 0, 9).is_err());
    image.set_level(0, 3, Level::new(Format::L8, 16, 16).unwrap()).unwrap();
    image.generate_mipmaps(Isa::best(), 3, 4).unwrap();
    assert!(image.level(0, 4).is_some() && image.level(0, 5).is_none());
    image.generate_mipmaps(Isa::best(), 3, 2).unwrap();
}

#[test]
fn layers_stay_and_slices_are_halved() {
    for (shape, depths) in
        [(Shape::D3, [6, 3, 1]), (Shape::D2Array, [6, 6, 6]), (Shape::CubeArray, [6, 6, 6])]
    {
        let mut image = Image::new(shape);
        image.set_level(0, 0, noise(Format::Rgba8, [4, 4, 6], [0; 3], 1)).unwrap();
        image.generate_mipmaps(Isa::best(), 0, 99).unwrap();
        let made = [0, 1, 2].map(|level| image.level(0, level).unwrap().depth);
        assert_eq!(made, depths);
        assert!(image.level(0, 3).is_none());
    }
}
