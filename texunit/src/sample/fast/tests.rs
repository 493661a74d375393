//! The fast path against the general one.

mod affine;

use super::*;
use crate::format::Format;
use crate::image::{Image, Level, Shape};
use crate::lanes::{F32s, LANES, Simd, U32s};
use crate::lanes::{Isa, Kernel, math};
use crate::plan::SamplePlan;
use crate::plan::TexelClass;
use crate::sample::{
    FilteredTexels, LevelHint, Lod, LookupScratch, Points, SelectedLevels, TexelConsumer,
};
use crate::sampler::{Compare, Filter, Mipmap, Sampler, Seamless, Wrap};

fn noise(seed: u32) -> u32 {
    let mixed = seed.wrapping_mul(0x9E37_79B9) ^ seed >> 13;
    mixed.wrapping_mul(0x85EB_CA6B) ^ mixed >> 15
}

fn image(shape: Shape, format: Format, size: [u32; 3], seed: u32) -> Image {
    let mut image = Image::new(shape);
    let mut size = size;
    for number in 0..=size[0].max(size[1]).ilog2() {
        let border = shape.border(seed & 1);
        for face in 0..shape.faces() {
            let mut level = Level::with_size(format, size, border).unwrap();
            for (i, byte) in level.texels.iter_mut().enumerate() {
                *byte = noise(i as u32 ^ seed << 8 ^ number << 20) as u8;
            }
            image.set_level(face, number as usize, level).unwrap();
        }
        size = shape.halved(size);
    }
    image
}

const COMPARES: [Compare; 8] = [
    Compare::Never,
    Compare::Less,
    Compare::Equal,
    Compare::LessEqual,
    Compare::Greater,
    Compare::NotEqual,
    Compare::GreaterEqual,
    Compare::Always,
];

#[test]
fn depths_are_compared_the_short_way_as_they_are_in_general() {
    for (at, format) in Format::ALL.into_iter().filter(|format| format.is_depth()).enumerate() {
        for (number, op) in COMPARES.into_iter().enumerate() {
            for wrap in Wrap::ALL {
                let image = image(Shape::D2, format, [16, 9, 1], 2 * (at + number) as u32);
                let mipmap = [Mipmap::None, Mipmap::Nearest, Mipmap::Linear][number % 3];
                let sampler = Sampler {
                    wrap: [wrap; 3],
                    min: Filter::Nearest,
                    mag: Filter::Nearest,
                    mipmap,
                    compare: Some(op),
                    ..Sampler::default()
                };
                let plan = SamplePlan::new(&image, &sampler);
                let coords = [0.09, 0.07, 0.05].map(|step| {
                    F32s::from_fn(|lane| match lane {
                        17 => f32::NAN,
                        _ => step * lane as f32 - 0.7,
                    })
                });
                for isa in Isa::available() {
                    let sample = |plan: &SamplePlan| {
                        let mut out = [F32s::ZERO; 4];
                        let lod = Lod::Implicit { bias: None };
                        plan.sample(isa, coords.each_ref(), None, lod, &mut out);
                        out.map(|c| c.0.map(f32::to_bits))
                    };
                    assert_eq!(sample(&plan), sample(&plan.general()), "{}", plan.describe());
                }
            }
        }
    }
}

/// The bits of numbers, all that are none alike.
fn bits(lanes: F32s) -> [u32; LANES] {
    lanes.0.map(|x| if x.is_nan() { f32::NAN.to_bits() } else { x.to_bits() })
}

/// A lookup as part of a kernel: its colours, and its bytes, if that is what they are.
struct FusedLookup<'a> {
    isa: Isa,
    plan: &'a SamplePlan,
    coords: [&'a F32s; 3],
}

/// Keeps what a lookup gives.
struct KeepTexels;

impl TexelConsumer for KeepTexels {
    type Output = ([F32s; 4], Option<U32s>);

    #[inline(always)]
    fn consume<S: Simd>(self, texels: &impl FilteredTexels) -> Self::Output {
        let channel = |channel| {
            F32s::from_fn(|lane| {
                let value = texels.channel(lane, channel);
                // Bytes have fast paths of their own.
                assert_eq!(texels.byte(lane, channel), math::byte(value), "{value}");
                value
            })
        };
        ([0, 1, 2, 3].map(channel), texels.bytes().copied())
    }
}

impl Kernel for FusedLookup<'_> {
    type Output = ([F32s; 4], Option<U32s>);

    #[inline(always)]
    fn run<S: Simd>(self) -> Self::Output {
        let (lod, scratch) = (Lod::Implicit { bias: None }, &mut LookupScratch::default());
        let [s, t, _] = self.coords;
        let mut weight = F32s::ZERO;
        self.plan.prefetch::<S>([s, t], LevelHint::FirstLane(self.coords, lod));
        let read = self.plan.uniform_levels::<S>(self.coords, &lod, &mut weight);
        if let Some(read) = read {
            self.plan.prefetch::<S>([s, t], LevelHint::Uniform(read));
        }
        let known = SelectedLevels { levels: read, weight: &weight, addresses: Addresses::Compute };
        self.plan.sample_fused::<S, _>(self.isa, self.coords, lod, known, scratch, KeepTexels)
    }
}

#[test]
fn the_short_way_gives_the_bits_of_the_general_one() {
    let is_short = |format: &Format| TexelClass::of(*format).is_some() || format.block().is_some();
    let formats: Vec<Format> = Format::ALL.into_iter().filter(is_short).collect();
    assert!(formats.len() > 30);
    let (mut bytes_given, mut left_out) = (0, 0);
    for round in 0..1000_u32 {
        let pick = |salt: u32, n: usize| noise(round * 32 + salt) as usize % n;
        let (shape, border) = [(Shape::D2, round), (Shape::Cube, round & !1)][pick(0, 2)];
        let width = 1 + pick(1, 40) as u32;
        let height = if shape == Shape::Cube { width } else { 1 + pick(2, 40) as u32 };
        let format = formats[pick(3, formats.len())];
        let border = if format.block().is_some() { border & !1 } else { border };
        let image = image(shape, format, [width, height, 1], border);
        let filters = [Filter::Nearest, Filter::Linear];
        let sampler = Sampler {
            wrap: [4, 5, 6].map(|salt| Wrap::ALL[pick(salt, Wrap::ALL.len())]),
            min: filters[pick(7, 2)],
            mag: filters[pick(8, 2)],
            mipmap: [Mipmap::None, Mipmap::Nearest, Mipmap::Linear][pick(9, 3)],
            border: [-1.0, 0.25, 2.0, 0.5].into(),
            max_anisotropy: [1.0, 1.0, 4.0, 16.0][pick(10, 4)],
            seamless: [Seamless::Off, Seamless::On][pick(15, 2)],
            compare: (format.is_depth() && pick(16, 3) > 0)
                .then(|| COMPARES[pick(17, COMPARES.len())]),
            ..Sampler::default()
        };
        let plan = SamplePlan::new(&image, &sampler);
        assert!(plan.incomplete().is_none());
        // Noise has some alpha that is not 1; of a few texels it may have none.
        let opaque = SamplePlan::new(&with_opaque_texels(&image), &sampler);
        let plan = match opaque.without_alpha() {
            Some(without) if pick(18, 2) > 0 => {
                assert_eq!(format.channels(), 4);
                assert!(without.without_alpha().is_none());
                left_out += 1;
                without
            }
            Some(_) | None => plan,
        };
        let scale = [0.01, 0.1, 4.0][pick(11, 3)];
        let coords = [12, 13, 14].map(|salt| {
            F32s::from_fn(|lane| {
                let part = noise(lane as u32 ^ round << 8 ^ salt << 24) >> 8;
                match part % 61 {
                    0 => f32::NAN,
                    1 => -1e7,
                    2 => f32::INFINITY,
                    _ => scale * (part as f32 / 8_388_608.0 - 1.0) + 0.01 * lane as f32,
                }
            })
        });
        for isa in Isa::available() {
            let sample = |plan: &SamplePlan| {
                let mut out = [F32s::ZERO; 4];
                let lod = Lod::Implicit { bias: None };
                plan.sample(isa, coords.each_ref(), None, lod, &mut out);
                out.map(bits)
            };
            let want = sample(&plan);
            assert_eq!(want, sample(&plan.general()), "{}", plan.describe());
            if plan.samples_color() {
                let coords = coords.each_ref();
                let (colors, bytes) = isa.run(FusedLookup { isa, plan: &plan, coords });
                let got = colors.map(bits);
                assert_eq!(got, want, "as part of a kernel: {}", plan.describe());
                for lane in 0..LANES {
                    let Some(bytes) = bytes else { continue };
                    let byte = |channel: usize| f32::from(bytes[lane].to_le_bytes()[channel]);
                    let given = [0, 1, 2, 3].map(|channel| (byte(channel) / 255.0).to_bits());
                    assert_eq!(given, got.map(|channel| channel[lane]), "{}", plan.describe());
                    bytes_given += 1;
                }
            }
        }
    }
    assert!(bytes_given > 0 || Isa::available().len() == 1);
    assert!(left_out > 0);
}

#[test]
fn reused_addresses_are_those_that_would_be_computed() {
    let (mut shared, mut separate) = (0, 0);
    for round in 0..600_u32 {
        let pick = |salt: u32, n: usize| noise(round * 32 + salt) as usize % n;
        let filters = [Filter::Nearest, Filter::Linear, Filter::Linear];
        let filter = filters[pick(0, 3)];
        let sampler = Sampler {
            wrap: [Wrap::ALL[pick(1, Wrap::ALL.len())]; 3],
            min: filter,
            mag: filter,
            mipmap: [Mipmap::None, Mipmap::Nearest, Mipmap::Linear][pick(2, 3)],
            ..Sampler::default()
        };
        let [width, height] = [3, 4].map(|salt| 1 + pick(salt, 40) as u32);
        let size = [width, height, 1];
        let format = [Format::Rgba8, Format::Rgb8][pick(5, 2)];
        let first = SamplePlan::new(&image(Shape::D2, format, size, 2 * round), &sampler);
        // Of the same size, format and sampler, or with one of them different.
        let other = Sampler { lod_bias: 0.5, ..sampler.clone() };
        let (is_like, size, format, sampler) = match pick(6, 8) {
            0 => (false, [width + 1, height, 1], format, &sampler),
            1 => (
                false,
                size,
                if format == Format::Rgb8 { Format::Rgba8 } else { Format::Rgb8 },
                &sampler,
            ),
            2 => (sampler.mipmap == Mipmap::None, size, format, &other),
            _ => (true, size, format, &sampler),
        };
        let second = SamplePlan::new(&image(Shape::D2, format, size, 2 * round + 64), sampler);
        // Plans of another size or format, or with mipmaps and another LOD bias, do not share addresses.
        if !is_like {
            assert!(
                !second.shares_addresses_with(&first),
                "{} {}",
                first.describe(),
                second.describe()
            );
        }
        if !second.shares_addresses_with(&first) {
            separate += 1;
            continue;
        }
        shared += 1;
        let scale: f32 = [0.02, 0.3, 4.0][pick(7, 3)];
        let coords = [8, 9, 10].map(|salt| {
            let is_inside = pick(11, 2) == 0;
            F32s::from_fn(|lane| match noise(lane as u32 ^ round << 8 ^ salt << 24) >> 8 {
                part if part % 61 == 0 && !is_inside => f32::NAN,
                part if is_inside => 0.4 + 0.1 * scale.min(1.0) * (part as f32 / 16_777_216.0),
                part => scale * (part as f32 / 8_388_608.0 - 1.0) + 0.01 * lane as f32,
            })
        });
        let points = Points { coords: coords.each_ref(), layer: None, reference: None };
        let lod = Lod::Implicit { bias: None };
        for isa in Isa::available() {
            let unshared = |plan: &SamplePlan| {
                let mut out = [F32s::ZERO; 4];
                plan.sample(isa, points.coords, None, lod, &mut out);
                out.map(bits)
            };
            let mut scratch = LookupScratch::default();
            let lookups = [
                (&first, Addresses::Compute),
                (&second, Addresses::Reuse),
                (&first, Addresses::Reuse),
                (&second, Addresses::Compute),
                (&first, Addresses::Reuse),
            ];
            for (number, (plan, addresses)) in lookups.into_iter().enumerate() {
                plan.sample_offset(isa, points, [0; 3], lod, addresses, &mut scratch);
                let what = format!("{} lookup {number}: {}", isa.name(), plan.describe());
                assert_eq!(scratch.lanes.map(bits), unshared(plan), "{what}");
            }
        }
    }
    assert!(shared > 200 && separate > 100, "{shared} {separate}");
}

/// The image with the last of each four bytes 255: alpha, where that is a byte.
fn with_opaque_texels(image: &Image) -> Image {
    let mut opaque = image.clone();
    for face in 0..image.shape().faces() {
        for number in 0.. {
            let Some(level) = opaque.level_mut(face, number) else { break };
            for texel in level.texels.as_chunks_mut::<4>().0 {
                texel[3] = 255;
            }
        }
    }
    opaque
}

#[test]
fn alpha_is_left_out_where_it_is_one_byte_that_is_1_in_every_texel_of_every_level_that_is_read() {
    let sampler = |mipmap| Sampler { mipmap, ..Sampler::default() };
    for format in Format::ALL {
        let opaque = with_opaque_texels(&image(Shape::D2, format, [64, 40, 1], 4));
        let plan = SamplePlan::new(&opaque, &sampler(Mipmap::Linear));
        let expected = matches!(format, Format::Rgba8 | Format::Srgb8A8);
        assert_eq!(plan.without_alpha().is_some(), expected, "{format:?}");
        if !expected {
            continue;
        }
        // One texel that is not, in each place that matters, and in one that does not.
        for (number, [x, y]) in [(0, [0, 0]), (0, [63, 39]), (3, [7, 4]), (6, [0, 0])] {
            let mut other = opaque.clone();
            let level = other.level_mut(0, number).unwrap();
            let at = y * level.row_bytes() + 4 * x + 3;
            level.texels[at] = 254;
            let without = |mipmap| SamplePlan::new(&other, &sampler(mipmap)).without_alpha();
            assert!(without(Mipmap::Linear).is_none(), "{format:?} level {number} at {x}, {y}");
            let is_read = number == 0;
            assert_eq!(without(Mipmap::None).is_none(), is_read, "{format:?} level {number}");
        }
    }
}
