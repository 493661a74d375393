//! Multisample targets: what each sample holds, against exact arithmetic and counts.

mod common;

use common::{bindings, bytes, device, fragment, image, pass, pipeline, vertex, viewport};
use rasterizer::driver::{
    AlphaToCoverage, AlphaToOne, Attachment, Blend, BlendEquation, BlendFactor, ClearValue,
    Command, CommandBuffer, Counter, DepthState, DepthWrite, Device, Image, MultisampleState,
    MultisampleStorage, Pipeline, PipelineDesc, RasterState, Rect, SampleCoverage, SampleRule,
    ShaderModule, Topology, sample_positions,
};
use rasterizer::ir::{Builder, Input, Interpolation, Output, Stage};
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Image as Texels, Level, Shape};
use texunit::lanes::Isa;
use texunit::sampler::Compare;

const SIZE: u32 = 32;

/// The standard positions of four samples, from the pixel's lower left corner, in 256ths.
const FOUR: [[i64; 2]; 4] = [[96, 32], [224, 96], [32, 160], [160, 224]];

fn multisampled(format: Format, samples: u8) -> Image {
    let mut texels = Texels::new(Shape::D2);
    texels.set_level(0, 0, Level::new(format, SIZE, SIZE).expect("small")).expect("face 0");
    Image::with_samples(texels, samples)
}

#[test]
fn an_image_has_as_many_samples_as_there_are_places() {
    for (asked, got) in [(0, 1), (1, 1), (2, 2), (3, 4), (4, 4), (5, 4), (255, 4)] {
        let image = multisampled(Format::Rgba8, asked);
        assert_eq!((image.samples(), sample_positions(asked).len()), (got, usize::from(got)));
    }
}

fn each() -> MultisampleState {
    MultisampleState { rule: SampleRule::Each, ..MultisampleState::default() }
}

/// Draws triangles, given in 256ths of pixels with a depth, over black.
fn draw(
    device: &Device,
    targets: (&Image, Option<&Image>),
    desc: &PipelineDesc,
    multisample: MultisampleState,
    corners: &[[i64; 2]],
    depth: impl Fn(&[i64; 2]) -> f32,
) -> u64 {
    let raster = RasterState { multisample, ..RasterState::default() };
    draw_with(device, targets, desc, raster, corners, depth)
}

fn draw_with(
    device: &Device,
    targets: (&Image, Option<&Image>),
    desc: &PipelineDesc,
    raster: RasterState,
    corners: &[[i64; 2]],
    depth: impl Fn(&[i64; 2]) -> f32,
) -> u64 {
    let counter = Counter::new();
    let clip = |v: i64| v as f32 / (128.0 * SIZE as f32) - 1.0;
    let vertices: Vec<f32> =
        corners.iter().flat_map(|c| [clip(c[0]), clip(c[1]), depth(c), 1.0]).collect();
    let area = Rect { x: 0, y: 0, width: SIZE, height: SIZE };
    let value = ClearValue::Color { target: 0, value: [0.0; 4], mask: [true; 4] };
    let commands = vec![
        pass(targets.0, targets.1, SIZE, SIZE),
        Command::Clear { value, area },
        Command::Clear { value: ClearValue::Depth(0.5), area },
        viewport(SIZE, SIZE),
        Command::SetRaster(Arc::new(raster)),
        Command::SetCounter(Some(counter.clone())),
        Command::BindPipeline(Pipeline::new(desc.clone()).expect("valid")),
        Command::BindVertices(bindings(&vertices, 1)),
        Command::Draw { first: 0, count: corners.len() as u32, instances: 0..1 },
        Command::EndPass,
    ];
    device.submit(&CommandBuffer { commands }).expect("legal");
    counter.samples()
}

fn constant(color: [f32; 4]) -> PipelineDesc {
    pipeline(vertex(0), fragment(0, |b| color.map(|v| b.float(v))))
}

/// Adds what is drawn to what is there.
fn adding(color: [f32; 4]) -> PipelineDesc {
    let mut desc = constant(color);
    desc.colors[0].blend = Some(Blend {
        equation: [BlendEquation::Add; 2],
        src: [BlendFactor::One; 2],
        dst: [BlendFactor::One; 2],
        constant: [0.0; 4],
    });
    desc
}

/// The first channel of every pixel of an Rgba32F image.
fn reds(target: &Image) -> Vec<f32> {
    let words = bytes(target);
    words.chunks(16).map(|t| f32::from_le_bytes([t[0], t[1], t[2], t[3]])).collect()
}

/// A number below `end` from a counter.
fn random(state: &mut u64, end: i64) -> i64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 33) as i64 % end
}

/// How many of the four samples of a pixel lie in a triangle.
fn samples_inside(corners: &[[i64; 2]], x: i64, y: i64) -> u32 {
    inside(corners, x, y).len() as u32
}

/// The samples of a pixel that lie in a triangle, by exact arithmetic.
fn inside(corners: &[[i64; 2]], x: i64, y: i64) -> Vec<[i64; 2]> {
    let side = |a: [i64; 2], b: [i64; 2], p: [i64; 2]| {
        (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    };
    let mut c = [corners[0], corners[1], corners[2]];
    let area = side(c[0], c[1], c[2]);
    if area < 0 {
        c.swap(1, 2);
    }
    let inside = |place: &&[i64; 2]| {
        let p = [x * 256 + place[0], y * 256 + place[1]];
        area != 0
            && (0..3).all(|i| {
                let (a, b) = (c[i], c[(i + 1) % 3]);
                let top_left = b[1] < a[1] || (b[1] == a[1] && b[0] < a[0]);
                let e = side(a, b, p);
                e > 0 || (e == 0 && top_left)
            })
    };
    FOUR.iter().filter(inside).copied().collect()
}

/// A position, in clip coordinates, that the fragment takes at the centroid of its samples: its
/// coordinate along `axis` becomes red.
fn place_of_centroid(axis: u16, interpolation: Interpolation) -> PipelineDesc {
    let mut b = Builder::new(Stage::Vertex);
    for component in 0..4 {
        let value = b.input(Input::Attribute { location: 0, component });
        for output in [Output::Position(component), Output::Varying(component.into())] {
            let out = b.output(output);
            b.store(out, value);
        }
    }
    let vertex = ShaderModule::new(b.finish()).expect("valid");
    let fragment = fragment(2, |b| {
        b.module_mut().centroids = vec![0, 1];
        b.module_mut().varyings = vec![interpolation; 2];
        let place = b.input(Input::Varying(axis));
        [place; 4]
    });
    pipeline(vertex, fragment)
}

#[test]
fn a_centroid_is_that_of_the_covered_samples() {
    let device = device(Isa::best(), 1);
    let mut state = 3;
    let end = 256 * i64::from(SIZE);
    for round in 0..12 {
        let corners: [[i64; 2]; 3] = [0; 3].map(|_| [0; 2].map(|_| random(&mut state, end)));
        let axis = round % 2;
        let interpolation = [Interpolation::Smooth, Interpolation::NoPerspective][round / 2 % 2];
        let target = multisampled(Format::Rgba32F, 4);
        let desc = place_of_centroid(axis as u16, interpolation);
        draw(&device, (&target, None), &desc, each(), &corners, |_| 0.0);
        for (i, red) in reds(&target).into_iter().enumerate() {
            let pixel = [i as i64 % i64::from(SIZE), i as i64 / i64::from(SIZE)];
            let covered = inside(&corners, pixel[0], pixel[1]);
            // Of `n` covered samples, each holds the mean of their places; the others are 0.
            let places = covered.iter().map(|place| (256 * pixel[axis] + place[axis]) as f64);
            let clip = places.map(|place| place / (128.0 * f64::from(SIZE)) - 1.0);
            let want = clip.sum::<f64>() / 4.0;
            assert!((f64::from(red) - want).abs() < 1e-5, "{corners:?} {pixel:?}: {red}, {want}");
        }
    }
}

#[test]
fn triangles_cover_the_samples_that_exact_arithmetic_says() {
    let device = device(Isa::best(), 2);
    let mut state = 7;
    let end = 256 * i64::from(SIZE);
    for round in 0..60 {
        // Coordinates on samples, on the grid of eighths, or anywhere; small ones too.
        let step = [1, 32, 64][round % 3];
        let reach = [end, end / 8, 300][round / 3 % 3];
        let at = [0, 1].map(|_| random(&mut state, end - reach + 1));
        let corners: [[i64; 2]; 3] =
            [0; 3].map(|_| [0, 1].map(|axis| (at[axis] + random(&mut state, reach)) / step * step));
        let target = multisampled(Format::Rgba32F, 4);
        let desc = constant([1.0; 4]);
        let counted = draw(&device, (&target, None), &desc, each(), &corners, |_| 0.0);
        let mut sum = 0;
        for (at, red) in reds(&target).into_iter().enumerate() {
            let (x, y) = (at as i64 % i64::from(SIZE), at as i64 / i64::from(SIZE));
            let inside = samples_inside(&corners, x, y);
            assert_eq!(red * 4.0, inside as f32, "{corners:?} at {x}, {y}");
            sum += u64::from(inside);
        }
        assert_eq!(counted, sum);
    }
}

#[test]
fn triangles_that_share_edges_cover_each_sample_once() {
    let device = device(Isa::best(), 2);
    let end = 256 * i64::from(SIZE);
    let mut state = 3;
    for _ in 0..10 {
        // A fan around a point inside, over all of the target.
        let middle = [0, 1].map(|_| 256 + random(&mut state, end - 512) / 32 * 32);
        let rim = [[0, 0], [end, 0], [end, end], [0, end]];
        let corners: Vec<_> = (0..4).flat_map(|i| [middle, rim[i], rim[(i + 1) % 4]]).collect();
        let target = multisampled(Format::Rgba32F, 4);
        let desc = adding([1.0; 4]);
        let counted = draw(&device, (&target, None), &desc, each(), &corners, |_| 0.0);
        assert_eq!(counted, u64::from(4 * SIZE * SIZE));
        assert!(reds(&target).into_iter().all(|red| red == 1.0), "{middle:?}");
    }
}

#[test]
fn samples_that_follow_the_centre_resolve_to_what_one_sample_holds() {
    let device = device(Isa::best(), 2);
    let corners = [[100, 300], [7000, 1200], [2500, 8000]];
    let single = image(Format::Rgba8, SIZE, SIZE);
    let desc = constant([0.25, 0.5, 0.75, 1.0]);
    let rule = MultisampleState::default();
    let one = draw(&device, (&single, None), &desc, rule, &corners, |_| 0.0);
    for samples in [2, 4] {
        let target = multisampled(Format::Rgba8, samples);
        let counted = draw(&device, (&target, None), &desc, rule, &corners, |_| 0.0);
        assert_eq!(bytes(&target), bytes(&single));
        assert_eq!(counted, one * u64::from(samples));
    }
}

#[test]
fn depth_is_that_of_the_plane_at_each_sample() {
    let device = device(Isa::best(), 2);
    let end = 256 * i64::from(SIZE);
    let corners = [[0, 0], [end, 0], [end, end], [0, 0], [end, end], [0, end]];
    // 0.5 where x = 1/2 of a pixel is 16.5: of that column the samples left of the centre are nearer.
    let slope = |c: &[i64; 2]| (c[0] - (16 * 256 + 128)) as f32 / end as f32;
    let color = multisampled(Format::Rgba32F, 4);
    let depth = multisampled(Format::D32F, 4);
    let mut desc = constant([1.0; 4]);
    desc.depth = Some(DepthState { test: Compare::Less, write: DepthWrite::On });
    draw(&device, (&color, Some(&depth)), &desc, each(), &corners, slope);
    for (at, red) in reds(&color).into_iter().enumerate() {
        let want = match at as u32 % SIZE {
            0..16 => 1.0,
            16 => 0.5,
            _ => 0.0,
        };
        assert_eq!(red, want, "{at}");
    }
}

#[test]
fn rows_of_every_sample_hold_what_it_holds() {
    let device = device(Isa::best(), 2);
    let mut state = 3;
    let end = 256 * i64::from(SIZE);
    for _ in 0..20 {
        let corners: Vec<[i64; 2]> =
            (0..3).map(|_| [0; 2].map(|_| random(&mut state, end))).collect();
        let mut texels = Texels::new(Shape::D2Array);
        let level = Level::with_size(Format::R32F, [SIZE, SIZE, 4], [0; 3]).expect("small");
        texels.set_level(0, 0, level).expect("face 0");
        let target = Image::new(Texels::new(Shape::D2Array));
        target.replace(texels, 4, MultisampleStorage::EachSample);
        let targets = (&target, None);
        draw(&device, targets, &constant([1.0; 4]), each(), &corners, |_| 0.0);
        let texels = target.texels();
        let rows = texels.level(0, 0).expect("there");
        for (pixel, sample) in (0..SIZE * SIZE).flat_map(|at| (0..4).map(move |s| (at, s))) {
            let (x, y) = (pixel % SIZE, pixel / SIZE);
            let covered = inside(&corners, x.into(), y.into()).contains(&FOUR[sample]);
            let got = rows.texel_at([x as i32, y as i32, sample as i32]);
            assert_eq!(got, f32::from(u8::from(covered)).to_le_bytes(), "{x} {y} {sample}");
        }
        // Given back with other texels, the samples are those.
        let attachment = Attachment::new(target.clone(), 0, 0);
        let mut samples = attachment.each_sample().expect("there");
        assert_eq!(samples.texels, rows.texels);
        samples.write_box([3, 4, 2], [1; 3], &7.0_f32.to_le_bytes()).expect("within");
        device.set_each_sample(&attachment, &samples);
        let texels = target.texels();
        assert_eq!(texels.level(0, 0).expect("there").texels, samples.texels);
    }
}

#[test]
fn alpha_and_the_coverage_of_the_state_choose_samples() {
    let device = device(Isa::best(), 2);
    let end = 256 * i64::from(SIZE);
    let corners = [[0, 0], [2 * end, 0], [0, 2 * end]];
    let alpha = |to_one| MultisampleState {
        alpha_to_coverage: AlphaToCoverage::On,
        alpha_to_one: to_one,
        ..each()
    };
    let covered = |coverage| MultisampleState { coverage: Some(coverage), ..each() };
    let masked = |mask, state| MultisampleState { mask, ..state };
    let (off, on) = (AlphaToOne::Off, AlphaToOne::On);
    // The state, the fragment's alpha, how many samples it keeps, and their alpha.
    for (state, a, kept, written) in [
        (each(), 0.5, 4, 0.5),
        (alpha(off), 0.0, 0, 0.0),
        (alpha(off), 0.1, 0, 0.1),
        (alpha(off), 0.25, 1, 0.25),
        (alpha(off), 0.5, 2, 0.5),
        (alpha(on), 0.5, 2, 1.0),
        (alpha(off), 0.9, 4, 0.9),
        (alpha(off), 1.0, 4, 1.0),
        (covered(SampleCoverage::Part(0.5)), 1.0, 2, 1.0),
        (covered(SampleCoverage::AllBut(0.25)), 1.0, 3, 1.0),
        (covered(SampleCoverage::Part(0.0)), 1.0, 0, 1.0),
        (masked(0b1010, each()), 1.0, 2, 1.0),
        (masked(0xFFFF_FFF0, each()), 1.0, 0, 1.0),
        (masked(0b0011, covered(SampleCoverage::AllBut(0.25))), 1.0, 1, 1.0),
        // Alpha leaves the first two.
        (masked(0b0110, alpha(off)), 0.5, 1, 0.5),
    ] {
        // With and without a depth test, which then has to come after the shader.
        for test in [None, Some(DepthState { test: Compare::Less, write: DepthWrite::On })] {
            let mut desc = constant([1.0, 0.0, 0.0, a]);
            desc.depth = test;
            let target = multisampled(Format::Rgba32F, 4);
            let depth = multisampled(Format::D32F, 4);
            let targets = (&target, Some(&depth));
            let counted = draw(&device, targets, &desc, state, &corners, |_| -1.0);
            assert_eq!(counted, kept * u64::from(SIZE * SIZE), "{state:?} {a}");
            let texels = bytes(&target);
            let words = [0, 12].map(|i| [texels[i], texels[i + 1], texels[i + 2], texels[i + 3]]);
            let [red, got] = words.map(f32::from_le_bytes);
            let part = kept as f32 / 4.0;
            assert_eq!((red, got), (part, part * written), "{state:?} {a}");
        }
    }
}

#[test]
fn tests_after_the_shader_see_the_depths_that_tests_before_it_see() {
    let device = device(Isa::best(), 2);
    let mut state = 5;
    let end = 256 * i64::from(SIZE);
    // Many that cross each other, so that a difference of one bit shows.
    let corners: Vec<[i64; 2]> = (0..90).map(|_| [0; 2].map(|_| random(&mut state, end))).collect();
    let depth = |c: &[i64; 2]| (c[0] * 7 % end) as f32 / end as f32 - 0.75;
    let mut desc = adding([0.1, 0.2, 0.3, 1.0]);
    desc.depth = Some(DepthState { test: Compare::LessEqual, write: DepthWrite::On });
    let late = MultisampleState { alpha_to_coverage: AlphaToCoverage::On, ..each() };
    let [early, late] = [each(), late].map(|multisample| {
        let color = multisampled(Format::Rgba32F, 4);
        let depths = multisampled(Format::D32F, 4);
        let targets = (&color, Some(&depths));
        let counted = draw(&device, targets, &desc, multisample, &corners, depth);
        (bytes(&color), bytes(&depths), counted)
    });
    assert!(early == late);
}

#[test]
fn lines_are_rectangles_and_points_are_discs() {
    type Inside<'a> = &'a dyn Fn([f64; 2]) -> bool;
    let device = device(Isa::best(), 2);
    let mut raster = RasterState { multisample: each(), ..RasterState::default() };
    (raster.line.width, raster.point.size) = (2.5, 9.0);
    let at = |v: f64| (v * 256.0) as i64;
    let (a, b) = ([5.25, 4.5], [26.0, 17.75]);
    // What of a sample's place says that it is covered.
    let in_line = |p: [f64; 2]| {
        let way = [b[0] - a[0], b[1] - a[1]];
        let length = f64::hypot(way[0], way[1]);
        let p = [p[0] - a[0], p[1] - a[1]];
        let along = (p[0] * way[0] + p[1] * way[1]) / length;
        let across = (way[0] * p[1] - way[1] * p[0]) / length;
        (0.0..length).contains(&along) && across.abs() < 1.25
    };
    let in_point = |p: [f64; 2]| f64::hypot(p[0] - a[0] - 3.0, p[1] - a[1] - 3.0) <= 4.5;
    let inside: [(Topology, Vec<[i64; 2]>, Inside<'_>); 2] = [
        (Topology::Lines, vec![a.map(at), b.map(at)], &in_line),
        (Topology::Points, vec![a.map(|v| at(v + 3.0))], &in_point),
    ];
    for (topology, corners, inside) in inside {
        let mut desc = constant([1.0; 4]);
        desc.topology = topology;
        let target = multisampled(Format::Rgba32F, 4);
        draw_with(&device, (&target, None), &desc, raster.clone(), &corners, |_| 0.0);
        for (at, red) in reds(&target).into_iter().enumerate() {
            let pixel = [at as i64 % i64::from(SIZE), at as i64 / i64::from(SIZE)];
            let of = |place: &&[i64; 2]| {
                inside([0, 1].map(|axis| pixel[axis] as f64 + place[axis] as f64 / 256.0))
            };
            let want = FOUR.iter().filter(of).count() as f32;
            assert_eq!(red * 4.0, want, "{topology:?} {pixel:?}");
        }
    }
}

#[test]
fn every_instruction_set_and_number_of_threads_gives_the_same_bits() {
    let mut state = 11;
    let end = 256 * i64::from(SIZE);
    let corners: Vec<[i64; 2]> = (0..90).map(|_| [0; 2].map(|_| random(&mut state, end))).collect();
    let depth = |c: &[i64; 2]| (c[0] * 3 + c[1]) as f32 / (4 * end) as f32 - 0.5;
    let mut desc = adding([0.3, 0.2, 0.1, 0.7]);
    desc.depth = Some(DepthState { test: Compare::LessEqual, write: DepthWrite::On });
    let mut first = None;
    for isa in Isa::available() {
        for threads in [1, 3] {
            let target = multisampled(Format::Rgba16F, 4);
            let depths = multisampled(Format::D24S8, 4);
            let device = device(isa, threads);
            let multisample = MultisampleState { alpha_to_coverage: AlphaToCoverage::On, ..each() };
            let targets = (&target, Some(&depths));
            let counted = draw(&device, targets, &desc, multisample, &corners, depth);
            let got = (bytes(&target), bytes(&depths), counted);
            assert_eq!(&got, first.get_or_insert(got.clone()), "{} {threads}", isa.name());
        }
    }
}

/// A triangle of one depth and one colour, in bytes.
#[derive(Clone, Debug)]
struct Flat {
    corners: [[i64; 2]; 3],
    depth: f32,
    color: [u8; 4],
    blend: Option<Blend>,
}

/// Draws triangles with a depth test; their corners are moved by `by`, in 256ths of pixels.
fn draw_flat(device: &Device, target: &Image, depth: &Image, triangles: &[Flat], by: [i64; 2]) {
    let area = Rect { x: 0, y: 0, width: SIZE, height: SIZE };
    let value = ClearValue::Color { target: 0, value: [0.0; 4], mask: [true; 4] };
    let raster = RasterState { multisample: each(), ..RasterState::default() };
    let mut commands = vec![
        pass(target, Some(depth), SIZE, SIZE),
        Command::Clear { value, area },
        Command::Clear { value: ClearValue::Depth(1.0), area },
        viewport(SIZE, SIZE),
        Command::SetRaster(Arc::new(raster)),
    ];
    for Flat { corners, depth, color, blend } in triangles {
        let clip = |v: i64| v as f32 / (128.0 * SIZE as f32) - 1.0;
        let vertices: Vec<f32> = corners
            .iter()
            .flat_map(|c| [clip(c[0] + by[0]), clip(c[1] + by[1]), *depth, 1.0])
            .collect();
        let mut desc = constant(color.map(|byte| f32::from(byte) / 255.0));
        desc.depth = Some(DepthState { test: Compare::LessEqual, write: DepthWrite::On });
        desc.colors[0].blend = *blend;
        commands.extend([
            Command::BindPipeline(Pipeline::new(desc).expect("valid")),
            Command::BindVertices(bindings(&vertices, 1)),
            Command::Draw { first: 0, count: 3, instances: 0..1 },
        ]);
    }
    commands.push(Command::EndPass);
    device.submit(&CommandBuffer { commands }).expect("legal");
}

/// A sample is what the only sample of a picture is whose triangles are moved: whatever way the blocks of a triangle take,
/// alone, in groups, or quad by quad with others.
#[test]
fn a_sample_is_a_picture_of_one_sample_that_was_moved() {
    let over = Blend {
        equation: [BlendEquation::Add; 2],
        src: [BlendFactor::SrcAlpha; 2],
        dst: [BlendFactor::OneMinusSrcAlpha; 2],
        constant: [0.0; 4],
    };
    let (mut state, mut edges) = (7, 0);
    for round in 0..24 {
        let triangles: Vec<Flat> = (0..1 + random(&mut state, 8))
            .map(|_| {
                let reach = if random(&mut state, 3) == 0 { 2_000 } else { 12_000 };
                let at = [0; 2].map(|_| random(&mut state, 8_192));
                let corner = |state: &mut u64| at.map(|at| at + random(state, reach) - reach / 2);
                Flat {
                    corners: [0; 3].map(|_| corner(&mut state)),
                    depth: random(&mut state, 100) as f32 / 50.0 - 1.0,
                    // The mean of four is a byte.
                    color: [0; 4].map(|_| 4 * random(&mut state, 64) as u8),
                    blend: (round % 2 == 1 && random(&mut state, 2) == 0).then_some(over),
                }
            })
            .collect();
        let moved: Vec<Vec<u8>> = FOUR
            .iter()
            .map(|position| {
                let (target, depth) =
                    (image(Format::Rgba8, SIZE, SIZE), image(Format::D24, SIZE, SIZE));
                let by = position.map(|at| 128 - at);
                draw_flat(&device(Isa::best(), 1), &target, &depth, &triangles, by);
                bytes(&target)
            })
            .collect();
        for isa in Isa::executions() {
            let (target, depth) = (multisampled(Format::Rgba8, 4), multisampled(Format::D24, 4));
            draw_flat(&device(isa, 2), &target, &depth, &triangles, [0; 2]);
            for (at, &got) in bytes(&target).iter().enumerate() {
                let samples = [0, 1, 2, 3].map(|sample: usize| moved[sample][at]);
                let sum: i32 = samples.iter().map(|byte| i32::from(*byte)).sum();
                // A mean of blended bytes may lie half way.
                let most = if round % 2 == 1 { 2 } else { 0 };
                let difference = (4 * i32::from(got) - sum).abs();
                assert!(
                    difference <= most,
                    "{} round {round} byte {at}: {got} of {samples:?}",
                    isa.name()
                );
                edges += usize::from(samples.iter().any(|sample| *sample != samples[0]));
            }
        }
    }
    assert!(edges > 10_000, "{edges} bytes whose samples differ");
}
