//! Anisotropic filtering against the area integral, and its bounds.

use crate::scene;
use texunit::format::Format;
use texunit::image::{Image, Level, Shape};
use texunit::lanes::{F32s, Isa};
use texunit::plan::SamplePlan;
use texunit::sample::Lod;
use texunit::sampler::{Filter, Sampler};

const SIZE: u32 = 64;

fn sampler(max_anisotropy: f32) -> Sampler {
    Sampler { min: Filter::Linear, max_anisotropy, ..Sampler::default() }
}

fn sample(image: &Image, most: f32, at: [f32; 2], dx: [f32; 2], dy: [f32; 2]) -> f64 {
    let plan = SamplePlan::new(image, &sampler(most));
    let [s, t] = at.map(F32s::splat);
    let [dx, dy] = [dx, dy].map(|[s, t]| [F32s::splat(s), F32s::splat(t), F32s::ZERO]);
    let lod = Lod::Gradient { dx: dx.each_ref(), dy: dy.each_ref(), bias: None };
    let mut out = [F32s::ZERO; 4];
    plan.sample(Isa::best(), [&s, &t, &F32s::ZERO], None, lod, &mut out);
    f64::from(out[0][17])
}

/// The mean over the parallelogram of the footprint, by 64×64 points.
fn area(level: &Level, at: [f32; 2], dx: [f32; 2], dy: [f32; 2]) -> f64 {
    let mut sum = 0.0;
    for i in 0..64 {
        for j in 0..64 {
            let (a, b) = ((f64::from(i) + 0.5) / 64.0 - 0.5, (f64::from(j) + 0.5) / 64.0 - 0.5);
            let [x, y] = [0, 1].map(|axis| {
                let s = f64::from(at[axis]) + a * f64::from(dx[axis]) + b * f64::from(dy[axis]);
                (s * f64::from(SIZE)).floor().rem_euclid(f64::from(SIZE)) as i32
            });
            sum += f64::from(level.color_at([x, y, 0]).unwrap()[0]);
        }
    }
    sum / 4096.0
}

#[test]
fn a_stretched_footprint_is_nearer_to_the_area_integral_than_an_isotropic_one() {
    let mut image = scene::image(Shape::D2, Format::R8, SIZE, SIZE, 10);
    image.generate_mipmaps(Isa::best(), 0, 1000).unwrap();
    let level = image.level(0, 0).unwrap().clone();
    for ratio in [2.0, 4.0, 8.0, 15.0] {
        let (mut isotropic, mut anisotropic) = (0.0, 0.0);
        for case in 0..300_u16 {
            let turn = f32::from(case) * 0.37;
            let at = [0.123 * f32::from(case), 0.731 * f32::from(case)];
            let unit = 1.5 / SIZE as f32;
            let dx = [turn.cos() * unit * ratio, turn.sin() * unit * ratio];
            let dy = [-turn.sin() * unit, turn.cos() * unit];
            let want = area(&level, at, dx, dy);
            isotropic += (sample(&image, 1.0, at, dx, dy) - want).powi(2);
            anisotropic += (sample(&image, 16.0, at, dx, dy) - want).powi(2);
        }
        assert!(anisotropic < 0.6 * isotropic, "{ratio}: {anisotropic} against {isotropic}");
    }
}

#[test]
fn a_round_footprint_gives_what_an_isotropic_filter_gives() {
    let image = scene::image(Shape::D2, Format::Rgba8, SIZE, SIZE, 10);
    for (size, turn) in [(3.0, 0.0_f32), (1.7, 0.3), (0.2, 1.0), (9.0, 2.0)] {
        let unit = size / SIZE as f32;
        let (sin, cos) = turn.sin_cos();
        let (dx, dy) = ([unit * cos, unit * sin], [-unit * sin, unit * cos]);
        let [round, any] = [1.0, 16.0].map(|most| sample(&image, most, [0.3, 0.6], dx, dy));
        assert!((round - any).abs() < 1.0 / 8192.0, "{size} {turn}: {round} {any}");
    }
}

#[test]
fn white_stays_white_and_black_black() {
    for (color, want) in [([1.0; 4], 1.0), ([0.0; 4], 0.0)] {
        for format in [Format::Rgba8, Format::Srgb8A8, Format::Rgba16F, Format::Dxt5] {
            let mut image = Image::new(Shape::D2);
            for number in 0..=6 {
                let mut level = Level::new(format, SIZE >> number, SIZE >> number).unwrap();
                level.fill(|_| color);
                image.set_level(0, number, level).unwrap();
            }
            let mut random = scene::Random(6);
            for _ in 0..200 {
                let mut pair = || [0; 2].map(|_: i32| random.within(-0.3, 0.3));
                let (at, dx, dy) = (pair(), pair(), pair());
                assert_eq!(sample(&image, 16.0, at, dx, dy), want, "{format:?} {at:?} {dx:?}");
            }
        }
    }
}

#[test]
fn what_a_lane_gets_does_not_depend_on_its_neighbours() {
    let image = scene::image(Shape::D2, Format::Rgba8, SIZE, SIZE, 10);
    let plan = SamplePlan::new(&image, &sampler(16.0));
    let mut random = scene::Random(4);
    let mut lanes = |scale: f32| F32s::from_fn(|_| random.within(-scale, scale));
    let coords = [lanes(2.0), lanes(2.0), F32s::ZERO];
    let dx = [lanes(0.2), lanes(0.2), F32s::ZERO];
    let dy = [lanes(0.05), lanes(0.05), F32s::ZERO];
    let run = |coords: &[F32s; 3], dx: &[F32s; 3], dy: &[F32s; 3]| {
        let mut out = [F32s::ZERO; 4];
        let lod = Lod::Gradient { dx: dx.each_ref(), dy: dy.each_ref(), bias: None };
        plan.sample(Isa::best(), coords.each_ref(), None, lod, &mut out);
        out
    };
    let together = run(&coords, &dx, &dy);
    for lane in 0..64 {
        let alone = |v: &[F32s; 3]| v.map(|v| F32s::splat(v[lane]));
        let got = run(&alone(&coords), &alone(&dx), &alone(&dy));
        assert_eq!(got.map(|c| c[0]), together.map(|c| c[lane]), "{lane}");
    }
}

#[test]
fn extreme_footprints_are_bounded() {
    let image = scene::image(Shape::D2, Format::Rgba8, SIZE, SIZE, 10);
    let odd = [0.0, 1e-45, 1e-7, 70.0, 1e7, 1e19, 1e38, f32::INFINITY, f32::NAN];
    for a in odd {
        for b in odd {
            for (dx, dy) in [([a, 0.0], [0.0, b]), ([a, b], [b, a]), ([a, b], [0.0, 0.0])] {
                let got = sample(&image, 16.0, [0.4, 0.7], dx, dy);
                assert!((0.0..=1.0).contains(&got), "{dx:?} {dy:?}: {got}");
            }
        }
    }
}

#[test]
fn probes_that_leave_a_face_are_taken_from_the_neighbour() {
    // Each face its own colour: red counts the faces.
    let mut image = Image::new(Shape::Cube);
    for face in 0..6 {
        for number in 0..=5 {
            let mut level = Level::new(Format::R32F, 32 >> number, 32 >> number).unwrap();
            level.fill(|_| [face as f32; 4]);
            image.set_level(face, number, level).unwrap();
        }
    }
    let plan = SamplePlan::new(&image, &sampler(16.0));
    let sample = |direction: [f32; 3], dx: [f32; 3], dy: [f32; 3]| {
        let [at, dx, dy] = [direction, dx, dy].map(|v| v.map(F32s::splat));
        let lod = Lod::Gradient { dx: dx.each_ref(), dy: dy.each_ref(), bias: None };
        let mut out = [F32s::ZERO; 4];
        plan.sample(Isa::best(), at.each_ref(), None, lod, &mut out);
        out[0][40]
    };
    // Just on +X, beside +Z (4): half of a footprint across the edge lies on either.
    let (at, thin) = ([1.0, 0.1, 0.999], [0.0, 0.02, 0.0]);
    let across = sample(at, [0.0, 0.0, 0.3], thin);
    assert!((across - 2.0).abs() < 0.3, "{across}");
    // Beside +Y (2) too: along the edge, nothing of another face is mixed in.
    assert_eq!(sample([1.0, 0.1, 0.5], [0.0, 0.3, 0.0], [0.0, 0.0, 0.02]), 0.0);
    // From either side of the edge it looks the same.
    let back = sample([0.999, 0.1, 1.0], [0.3, 0.0, 0.0], thin);
    assert!((across + back - 4.0).abs() < 0.6, "{across} and {back}");
    // Far beyond every edge there is still a face.
    let wild = sample(at, [0.0, 0.0, 1e6], thin);
    assert!((0.0..=5.0).contains(&wild), "{wild}");
}
