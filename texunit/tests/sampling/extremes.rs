//! Coordinates and levels of detail that no picture has, and what they are defined to give.

use crate::scene;
use texunit::format::Format;
use texunit::image::Shape;
use texunit::lanes::{F32s, Isa, LANES};
use texunit::plan::SamplePlan;
use texunit::sample::Lod;
use texunit::sampler::{Filter, Mipmap, Sampler, Wrap};

fn sample(plan: &SamplePlan, s: f32, t: f32, lambda: f32) -> [f32; 4] {
    let mut out = [F32s::ZERO; 4];
    let (s, t, lambda) = (F32s::splat(s), F32s::splat(t), F32s::splat(lambda));
    plan.sample(Isa::best(), [&s, &t, &F32s::ZERO], None, Lod::Explicit(&lambda), &mut out);
    for component in &out {
        assert_eq!(component.0, [component[0]; LANES]);
    }
    out.map(|component| component[0])
}

#[test]
fn nan_counts_as_zero_and_infinity_as_the_end_of_the_range() {
    let image = scene::image(Shape::D2, Format::Rgba8, 8, 8, 1);
    for filter in [Filter::Nearest, Filter::Linear] {
        for wrap in Wrap::ALL {
            let sampler = Sampler {
                wrap: [wrap; 3],
                min: filter,
                mag: filter,
                mipmap: Mipmap::None,
                border: [0.25, 0.5, 0.75, 1.0].into(),
                ..Sampler::default()
            };
            let plan = SamplePlan::new(&image, &sampler);
            let at = |s| sample(&plan, s, 0.4, 0.0);
            assert_eq!(at(f32::NAN), at(0.0), "{wrap:?} {filter:?}");
            let (low, high) = match wrap {
                Wrap::Repeat | Wrap::MirroredRepeat => (0.0, 0.0),
                Wrap::Clamp | Wrap::ClampToEdge | Wrap::ClampToBorder => (-9.0, 9.0),
                Wrap::MirrorClamp | Wrap::MirrorClampToEdge | Wrap::MirrorClampToBorder => {
                    (9.0, 9.0)
                }
            };
            assert_eq!(at(f32::NEG_INFINITY), at(low), "{wrap:?} {filter:?}");
            assert_eq!(at(f32::INFINITY), at(high), "{wrap:?} {filter:?}");
            // 10^7 is an even integer: every repeat starts there.
            let (low, high) = if (low, high) == (0.0, 0.0) { (0.0, 0.0) } else { (low, high) };
            assert_eq!(at(-1e7), at(low), "{wrap:?} {filter:?}");
            assert_eq!(at(1e7), at(high), "{wrap:?} {filter:?}");
            assert_eq!(at(1e-45), at(0.0), "{wrap:?} {filter:?}");
            assert_eq!(at(f32::MAX), at(high), "{wrap:?} {filter:?}");
        }
    }
}

#[test]
fn any_lod_reaches_a_level_that_is_there() {
    let image = scene::image(Shape::D2, Format::L8, 16, 4, 2);
    for mipmap in [Mipmap::Nearest, Mipmap::Linear] {
        let sampler =
            Sampler { min: Filter::Nearest, mag: Filter::Nearest, mipmap, ..Sampler::default() };
        let plan = SamplePlan::new(&image, &sampler);
        let texel = |level: usize| {
            let level = image.level(0, level).unwrap();
            f32::from(level.texel(0, 0)[0]) / 255.0
        };
        for (lambda, level) in [
            (f32::NEG_INFINITY, 0),
            (-1e30, 0),
            (f32::NAN, 0),
            (2.0, 2),
            (4.0, 4),
            (1e30, 4),
            (f32::INFINITY, 4),
        ] {
            assert_eq!(sample(&plan, 0.01, 0.01, lambda)[0], texel(level), "{mipmap:?} {lambda}");
        }
    }
}

#[test]
fn directions_without_a_face_are_defined() {
    let image = scene::image(Shape::Cube, Format::Rgba8, 8, 8, 3);
    let plan = SamplePlan::new(&image, &Sampler::default());
    for direction in [
        [0.0, 0.0, 0.0],
        [f32::NAN; 3],
        [f32::INFINITY, f32::NEG_INFINITY, 1.0],
        [f32::NAN, 1.0, f32::MAX],
        [1e-45, 0.0, 1e-45],
    ] {
        let coords = direction.map(F32s::splat);
        let mut out = [F32s::splat(f32::NAN); 4];
        plan.sample(Isa::best(), coords.each_ref(), None, Lod::Implicit { bias: None }, &mut out);
        for component in &out {
            assert!(component.0.iter().all(|x| (0.0..=1.0).contains(x)), "{direction:?}");
        }
    }
}

#[test]
fn a_constant_image_is_constant_wherever_it_is_sampled() {
    let mut image = scene::image(Shape::D2, Format::Rgb8, 13, 7, 4);
    let level = image.level_mut(0, 0).unwrap();
    for y in 0..7 {
        for x in 0..13 {
            level.put(x, y, [0.3, 0.6, 0.9, 0.0]);
        }
    }
    image.generate_mipmaps(Isa::best(), 0, 1000).unwrap();
    let sampler = Sampler { min: Filter::Linear, ..Sampler::default() };
    let plan = SamplePlan::new(&image, &sampler);
    let want = sample(&plan, 0.5, 0.5, 0.0);
    for i in 0..200 {
        let x = i as f32;
        assert_eq!(sample(&plan, x * 0.137, -x * 0.71, x * 0.02), want);
    }
}

#[test]
fn thin_and_long_images_repeat_without_a_seam() {
    for (width, height) in [(1, 1), (1, 64), (8192, 1)] {
        let image = scene::image(Shape::D2, Format::Rgba8, width, height, 6);
        let linear = Sampler { min: Filter::Linear, mipmap: Mipmap::None, ..Sampler::default() };
        let plan = SamplePlan::new(&image, &linear);
        for whole in [-3.0, -1.0, 0.0, 1.0, 2.0] {
            // At the seam, the mean of the last texel and the first.
            let seam = sample(&plan, whole, 0.5 / height as f32, 0.0)[0];
            let ends =
                [0, width as i32 - 1].map(|x| image.level(0, 0).unwrap().color_at([x, 0, 0]));
            let mean = ends.map(|c| c.unwrap()[0]).iter().sum::<f32>() / 2.0;
            assert!((seam - mean).abs() < 1e-6, "{width}×{height} at {whole}: {seam} for {mean}");
        }
    }
}

#[test]
fn the_lower_bound_of_lod_wins_nothing_over_the_upper() {
    let image = scene::image(Shape::D2, Format::L8, 16, 16, 2);
    let sampler = Sampler {
        min: Filter::Nearest,
        mag: Filter::Nearest,
        mipmap: Mipmap::Nearest,
        min_lod: 3.0,
        max_lod: 1.0,
        ..Sampler::default()
    };
    let plan = SamplePlan::new(&image, &sampler);
    let want = f32::from(image.level(0, 1).unwrap().texel(0, 0)[0]) / 255.0;
    for lambda in [f32::NEG_INFINITY, 0.0, 2.0, f32::INFINITY] {
        assert_eq!(sample(&plan, 0.01, 0.01, lambda)[0], want);
    }
}

#[test]
fn border_colours_and_float_texels_keep_what_is_outside_zero_to_one() {
    let mut image = scene::image(Shape::D2, Format::Rgba32F, 4, 4, 2);
    let level = image.level_mut(0, 0).unwrap();
    for (x, bits) in [f32::INFINITY, f32::NEG_INFINITY, f32::NAN].into_iter().enumerate() {
        level.texels[16 * x..16 * x + 4].copy_from_slice(&bits.to_le_bytes());
    }
    let sampler = Sampler {
        wrap: [Wrap::ClampToBorder; 3],
        min: Filter::Nearest,
        mag: Filter::Nearest,
        mipmap: Mipmap::None,
        border: [-2.0, 7.5, 0.0, 1e9].into(),
        ..Sampler::default()
    };
    let plan = SamplePlan::new(&image, &sampler);
    assert_eq!(sample(&plan, -3.0, 0.5, 0.0), [-2.0, 7.5, 0.0, 1e9]);
    assert_eq!(sample(&plan, 0.1, 0.1, 0.0)[0], f32::INFINITY);
    assert_eq!(sample(&plan, 0.3, 0.1, 0.0)[0], f32::NEG_INFINITY);
    assert!(sample_bits(&plan, 0.6, 0.1).is_nan());
}

#[test]
fn a_border_colour_is_held_in_the_range_of_normalized_texels() {
    for (format, least) in [(Format::Rgba8, 0.0), (Format::Rgba16, 0.0), (Format::Rgba8Snorm, -1.0)]
    {
        let sampler = Sampler {
            wrap: [Wrap::ClampToBorder; 3],
            min: Filter::Linear,
            mag: Filter::Linear,
            mipmap: Mipmap::None,
            border: [f32::MAX, f32::MIN, f32::NAN, 0.5].into(),
            ..Sampler::default()
        };
        let plan = SamplePlan::new(&scene::image(Shape::D2, format, 4, 4, 2), &sampler);
        let [r, g, _, a] = sample(&plan, -3.0, 0.5, 0.0);
        assert_eq!([r, g, a], [1.0, least, 0.5], "{format:?}");
        // Half of it at the edge.
        assert!(sample(&plan, 0.0, 0.4, 0.0).iter().all(|c| c.abs() <= 1.0), "{format:?}");
    }
}

/// One component, which may be NaN.
fn sample_bits(plan: &SamplePlan, s: f32, t: f32) -> f32 {
    let mut out = [F32s::ZERO; 4];
    let (s, t) = (F32s::splat(s), F32s::splat(t));
    plan.sample(Isa::best(), [&s, &t, &F32s::ZERO], None, Lod::Implicit { bias: None }, &mut out);
    out[0][0]
}

#[test]
fn seamless_edges_and_corners_look_the_same_from_every_face() {
    use texunit::sampler::Seamless;
    let image = scene::image(Shape::Cube, Format::R8, 8, 8, 4);
    let sampler = Sampler {
        min: Filter::Linear,
        mipmap: Mipmap::None,
        seamless: Seamless::On,
        ..Sampler::default()
    };
    let plan = SamplePlan::new(&image, &sampler);
    let at = |direction: [f32; 3]| {
        let coords = direction.map(F32s::splat);
        let mut out = [F32s::ZERO; 4];
        plan.sample(Isa::best(), coords.each_ref(), None, Lod::Implicit { bias: None }, &mut out);
        out[0][0]
    };
    let near = 1.0 - 1e-6;
    for a in [-1.0_f32, 1.0] {
        for b in [-1.0_f32, 1.0] {
            for along in [-0.8, -0.3, 0.05, 0.6, 1.0] {
                for axis in 0..3 {
                    // Just on either side of the edge (a corner where `along` is 1).
                    let turned = |v: [f32; 3]| [v[axis], v[(axis + 1) % 3], v[(axis + 2) % 3]];
                    let here = at(turned([a, b * near, along * near]));
                    let there = at(turned([a * near, b, along * near]));
                    assert!((here - there).abs() < 1e-4, "{a} {b} {along}: {here} {there}");
                }
            }
        }
    }
}

#[test]
fn a_footprint_long_one_way_and_nothing_the_other_is_a_mean_along_it() {
    let mut image = scene::image(Shape::D2, Format::R8, 4096, 64, 8);
    for row in 0..64 {
        for column in 0..4096 {
            let level = image.level_mut(0, 0).unwrap();
            level.put(column, row, [if row < 32 { 0.0 } else { 1.0 }; 4]);
        }
    }
    image.generate_mipmaps(Isa::best(), 0, 1000).unwrap();
    let zero = F32s::ZERO;
    for anisotropy in [1.0, 4.0, 16.0] {
        let sampler =
            Sampler { min: Filter::Linear, max_anisotropy: anisotropy, ..Sampler::default() };
        let plan = SamplePlan::new(&image, &sampler);
        // From one texel to more than the texture has.
        for texels in [1.0, 16.0, 1000.0, 4096.0, 1e6] {
            let along = F32s::splat(texels / 4096.0);
            let (dx, dy) = ([&along, &zero, &zero], [&zero; 3]);
            for (a, b) in [(dx, dy), (dy, dx)] {
                let lod = Lod::Gradient { dx: a, dy: b, bias: None };
                let mut out = [F32s::ZERO; 4];
                let (s, t) = (F32s::splat(0.3), F32s::splat(0.25));
                plan.sample(Isa::best(), [&s, &t, &zero], None, lod, &mut out);
                let got = out[0][0];
                // The texels of the levels for a 16th of the length still tell the rows apart.
                let sharp = anisotropy == 16.0 && texels <= 16.0;
                assert!((0.0..=1.0).contains(&got), "{anisotropy} {texels}: {got}");
                assert!(!sharp || got == 0.0, "{anisotropy} {texels}: {got}");
            }
        }
    }
}

#[test]
fn denormal_derivatives_and_coordinates_magnify() {
    let image = scene::image(Shape::D2, Format::Rgba8, 16, 16, 9);
    let sampler = Sampler { min: Filter::Linear, max_anisotropy: 16.0, ..Sampler::default() };
    let plan = SamplePlan::new(&image, &sampler);
    let want = sample(&plan, 1e-41, 1e-45, f32::NEG_INFINITY);
    let tiny = F32s::splat(1e-40);
    let lod = Lod::Gradient { dx: [&tiny; 3], dy: [&tiny; 3], bias: None };
    let mut out = [F32s::ZERO; 4];
    let (s, t) = (F32s::splat(1e-41), F32s::splat(1e-45));
    plan.sample(Isa::best(), [&s, &t, &F32s::ZERO], None, lod, &mut out);
    // Weights of an anisotropic filter are multiples of 2^-14.
    let near = |(c, want): (&F32s, f32)| (c[0] - want).abs() < 1.0 / 8192.0;
    assert!(out.iter().zip(want).all(near), "{out:?} {want:?}");
}
