//! The kernel of scattered lanes against the general one.

use super::edges;
use super::lane_level::LaneLevel;
use crate::format::Format;
use crate::image::{FACES, Image, Level, Shape};
use crate::lanes::{F32s, I32s, Isa, LANES, U32s};
use crate::plan::{SampleKernel, SamplePlan, TexelClass};
use crate::sample::cube;
use crate::sample::{Addresses, Lod, LookupScratch, Points};
use crate::sampler::{Compare, Filter, Mipmap, Sampler, Seamless, Wrap};

/// Numbers that look random.
struct Noise(u64);

impl Noise {
    fn bits(&mut self) -> u32 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as u32
    }

    fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.bits() as usize % from.len()]
    }

    /// -1 to 1.
    fn signed(&mut self) -> f32 {
        self.bits() as f32 / (1 << 30) as f32 - 1.0
    }
}

fn image(noise: &mut Noise, shape: Shape, format: Format, [width, height]: [u32; 2]) -> Image {
    let depth = match shape {
        Shape::CubeArray => 12,
        Shape::D2Array => 3,
        Shape::D1 | Shape::D2 | Shape::D3 | Shape::Rect | Shape::Cube | Shape::D1Array => 1,
    };
    let mut image = Image::new(shape);
    let mut size = [width, height, depth];
    for number in 0..=width.max(height).ilog2() {
        for face in 0..shape.faces() {
            let mut level = Level::with_size(format, size, [0; 3]).unwrap();
            for byte in level.texels.iter_mut() {
                *byte = (noise.bits() >> 8) as u8;
            }
            image.set_level(face, number as usize, level).unwrap();
        }
        size = shape.halved(size);
    }
    image
}

/// A sampler, mostly of those that the kernel has.
fn sampler(noise: &mut Noise, format: Format) -> Sampler {
    let filter = noise.pick(&[Filter::Nearest, Filter::Linear, Filter::Linear]);
    let wraps = [Wrap::Repeat, Wrap::ClampToEdge, Wrap::MirroredRepeat, Wrap::Clamp];
    let compares = [
        Compare::Never,
        Compare::Less,
        Compare::Equal,
        Compare::LessEqual,
        Compare::Greater,
        Compare::NotEqual,
        Compare::GreaterEqual,
        Compare::Always,
    ];
    Sampler {
        wrap: [noise.pick(&wraps), noise.pick(&wraps), Wrap::Repeat],
        min: filter,
        mag: if noise.bits().is_multiple_of(16) { Filter::Linear } else { filter },
        mipmap: noise.pick(&[Mipmap::None, Mipmap::Nearest, Mipmap::Linear, Mipmap::Linear]),
        seamless: noise.pick(&[Seamless::Off, Seamless::On]),
        lod_bias: noise.pick(&[0.0, 0.0, -0.4, 3.0]),
        max_lod: noise.pick(&[1000.0, 1000.0, 1.5]),
        max_anisotropy: noise.pick(&[1.0, 1.0, 1.0, 4.0]),
        compare: (format.is_depth() && noise.bits().is_multiple_of(2))
            .then(|| noise.pick(&compares)),
        ..Sampler::default()
    }
}

/// A coordinate that no range leaves out.
fn any_number(noise: &mut Noise) -> f32 {
    match noise.bits() % 12 {
        0 => f32::NAN,
        1 => f32::INFINITY,
        2 => f32::NEG_INFINITY,
        3 => 0.0,
        4 => -0.0,
        5 => f32::from_bits(noise.bits() % 0x80_0000),
        6 => -f32::from_bits(noise.bits() % 0x80_0000),
        7 => f32::from_bits(noise.bits() << 1 ^ noise.bits()),
        8 => 1.0,
        9 => -1.0,
        _ => noise.signed(),
    }
}

/// A batch of points: of which kind, `kind` says.
fn points(noise: &mut Noise, kind: u32, texels: u32) -> [F32s; 3] {
    let mut out = [F32s::ZERO; 3];
    let center = [noise.signed(), noise.signed(), noise.signed()];
    let step = noise.pick(&[0.1, 1.0, 4.0]) / texels as f32;
    let [across, up] = [0, 1].map(|_| [noise.signed(), noise.signed(), noise.signed()]);
    let axis = noise.bits() as usize % 3;
    for lane in 0..LANES {
        let (x, y) = ((lane % 8) as f32 * step, (lane / 8) as f32 * step);
        let smooth = |c: usize| center[c] + across[c] * x + up[c] * y;
        let point = match kind {
            // A piece of a surface.
            0 => [smooth(0), smooth(1), smooth(2)],
            // Anywhere.
            1 => [noise.signed(), noise.signed(), noise.signed()],
            // Any bits.
            2 => [any_number(noise), any_number(noise), any_number(noise)],
            // On edges and corners, and close to them.
            3 => {
                let near = 1.0 - noise.pick(&[0.0, 0.0, 0.5, 1.0, 2.0]) / texels as f32;
                let mut point = [noise.signed(), noise.signed(), noise.signed()];
                for (c, part) in point.iter_mut().enumerate() {
                    if c != axis || noise.bits().is_multiple_of(4) {
                        *part = noise.pick(&[near, -near, 1.0, -1.0]);
                    }
                }
                point
            }
            // At centres and sides of texels, where weights are 0 and nearest texels change.
            _ => {
                let half =
                    |noise: &mut Noise| (noise.bits() % (2 * texels + 1)) as f32 / texels as f32;
                let mut point = [half(noise) - 1.0, half(noise) - 1.0, half(noise) - 1.0];
                point[axis] = noise.pick(&[1.0, -1.0]);
                point
            }
        };
        for (out, part) in out.iter_mut().zip(point) {
            out[lane] = part;
        }
    }
    out
}

/// The bits of numbers, all that are none alike.
fn bits(lanes: &F32s) -> [u32; LANES] {
    lanes.0.map(|x| if x.is_nan() { f32::NAN.to_bits() } else { x.to_bits() })
}

/// Samples in several ways, fast and in general.
fn check(noise: &mut Noise, plan: &SamplePlan, coords: &[F32s; 3]) {
    let [bias, layer, reference] = [0, 1, 2].map(|_| F32s::from_fn(|_| 2.0 * noise.signed()));
    let steps: [F32s; 6] = std::array::from_fn(|_| F32s::from_fn(|_| 0.01 * noise.signed()));
    let [dx, dy] = [0, 3].map(|at| [&steps[at], &steps[at + 1], &steps[at + 2]]);
    let lambda = F32s::from_fn(|lane| match lane {
        0 => f32::NAN,
        1 => f32::INFINITY,
        _ => 4.0 * noise.signed() + 1.0,
    });
    let lods = [
        Lod::Implicit { bias: None },
        Lod::Implicit { bias: Some(&bias) },
        Lod::Explicit(&lambda),
        Lod::Gradient { dx, dy, bias: None },
    ];
    let points =
        Points { coords: coords.each_ref(), layer: Some(&layer), reference: Some(&reference) };
    for lod in lods {
        let sample = |plan: &SamplePlan, isa: Isa| {
            let mut scratch = LookupScratch::default();
            plan.sample_offset(isa, points, [0; 3], lod, Addresses::Compute, &mut scratch);
            scratch.lanes.each_ref().map(bits)
        };
        let want = sample(&plan.general(), Isa::BASELINE);
        for isa in Isa::available() {
            let got = sample(plan, isa);
            for lane in 0..LANES {
                let of = |bits: &[[u32; LANES]; 4]| [0, 1, 2, 3].map(|c| bits[c][lane]);
                let at = [0, 1, 2].map(|c| coords[c][lane]);
                let what = (isa.name(), plan.describe(), lod, lane, at);
                assert_eq!(of(&got), of(&want), "{what:?}");
            }
        }
    }
}

#[test]
fn scattered_lanes_get_the_bits_of_the_general_kernel() {
    let noise = &mut Noise(44);
    let has_class = |format: &Format| TexelClass::of(*format).is_some();
    let formats: Vec<Format> = Format::ALL.into_iter().filter(has_class).collect();
    assert!(formats.len() > 20);
    let (mut scattered, mut crossing, rounds) = (0, 0, 900);
    for round in 0..rounds {
        let shape = noise.pick(&[Shape::Cube, Shape::Cube, Shape::CubeArray, Shape::D2Array]);
        let width = noise.pick(&[1, 2, 3, 4, 7, 8, 16, 21, 33]);
        let height = if shape.is_cube() { width } else { noise.pick(&[1, 5, 16]) };
        let format = formats[round % formats.len()];
        let image = image(noise, shape, format, [width, height]);
        let sampler = sampler(noise, format);
        let plan = SamplePlan::new(&image, &sampler);
        assert!(plan.incomplete().is_none());
        let plan = plan.without_alpha().unwrap_or(plan);
        let kernel = plan.texture().unwrap().kernel;
        let is_scattered = matches!(kernel, SampleKernel::Scattered(_));
        scattered += usize::from(is_scattered);
        let is_seamless = is_scattered && sampler.seamless == Seamless::On && shape.is_cube();
        crossing += usize::from(is_seamless && sampler.min == Filter::Linear);
        for kind in 0..5 {
            let coords = points(noise, kind, width);
            check(noise, &plan, &coords);
        }
    }
    assert!(scattered > rounds / 3 && crossing > rounds / 10, "{scattered} {crossing}");
}

#[test]
fn large_faces_get_the_bits_of_the_general_kernel() {
    let noise = &mut Noise(45);
    for (width, format) in [(1024, Format::R8), (512, Format::Rgb8), (100, Format::Rgba32F)] {
        let image = image(noise, Shape::Cube, format, [width; 2]);
        for seamless in [Seamless::Off, Seamless::On] {
            for mipmap in [Mipmap::None, Mipmap::Linear] {
                let wrap = [Wrap::ClampToEdge; 3];
                let sampler = Sampler {
                    min: Filter::Linear,
                    mag: Filter::Linear,
                    mipmap,
                    seamless,
                    wrap,
                    ..Sampler::default()
                };
                let plan = SamplePlan::new(&image, &sampler);
                let kernel = plan.texture().unwrap().kernel;
                assert!(matches!(kernel, SampleKernel::Scattered(_)), "{}", plan.describe());
                for kind in [0, 0, 0, 1, 2, 3, 3, 4] {
                    let coords = points(noise, kind, width);
                    check(noise, &plan, &coords);
                }
            }
        }
    }
}

#[test]
fn the_table_of_neighbours_has_the_texels_of_the_formula() {
    let image_of = |size: u32| {
        let mut image = Image::new(Shape::Cube);
        for face in 0..FACES {
            let level = Level::new(Format::R8, size, size).unwrap();
            image.set_level(face, 0, level).unwrap();
        }
        SamplePlan::new(&image, &Sampler { mipmap: Mipmap::None, ..Sampler::default() })
    };
    for size in [1, 2, 3, 8, 1000] {
        let plan = image_of(size);
        let texture = plan.texture().unwrap();
        for face in 0..FACES as u32 {
            let zero = U32s::ZERO;
            let faces = U32s::splat(face);
            let level = LaneLevel::new(texture, &zero, &faces, &zero);
            let indices = [-1, 0, size as i32 / 2, size as i32 - 1];
            let i = I32s::from_fn(|lane| indices[lane % 4]);
            let j = I32s::from_fn(|lane| indices[lane / 4 % 4]);
            for step in [[0, 0], [1, 0], [0, 1], [1, 1]] {
                let got = edges::across_edge(&level, &i, &j, step);
                let want = cube::across_edge(face, &i, &j, step, size as i32);
                assert_eq!(got.missing, want.missing, "face {face} of {size}");
                for lane in (0..LANES).filter(|&lane| want.missing[lane] == 0) {
                    let of = |texels: &cube::EdgeTexels| {
                        [texels.face[lane], texels.x[lane], texels.y[lane]]
                    };
                    let at = [i[lane] + step[0], j[lane] + step[1]];
                    assert_eq!(of(&got), of(&want), "{at:?} of face {face} of {size}");
                }
            }
        }
    }
}
