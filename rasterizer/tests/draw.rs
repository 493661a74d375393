//! Whole draws: the same bits for every instruction set and thread count, and the right ones.

mod common;
mod primitives;

use common::{bindings, bytes, device, fragment, image, pass, pipeline, vertex, viewport};
use rasterizer::driver::{
    Blend, BlendEquation, BlendFactor, ClearValue, Command, CommandBuffer, Cull, DepthState,
    DepthWrite, Device, Pipeline, PipelineDesc, RasterState, Rect, Topology,
};
use rasterizer::ir::{Builder, Input, Op, Value};
use std::sync::Arc;
use texunit::format::Format;
use texunit::lanes::Isa;
use texunit::sampler::Compare;

/// Every instruction set with 1, 2 and 8 threads.
fn devices() -> Vec<Device> {
    let mut all = Vec::new();
    for isa in Isa::executions() {
        for threads in [1, 2, 8] {
            all.push(device(isa, threads));
        }
    }
    all
}

/// Draws `count` vertices of `desc` into a fresh picture; gives its bytes.
fn picture(
    device: &Device,
    desc: &PipelineDesc,
    vertices: &[f32],
    attributes: u8,
    size: (u32, u32),
) -> Vec<u8> {
    picture_with(device, desc, &RasterState::default(), vertices, attributes, size)
}

/// The same with a raster state.
fn picture_with(
    device: &Device,
    desc: &PipelineDesc,
    raster: &RasterState,
    vertices: &[f32],
    attributes: u8,
    size: (u32, u32),
) -> Vec<u8> {
    picture_cut(device, desc, raster, vertices, attributes, size, Cut::No)
}

/// The same in one draw or many.
fn picture_cut(
    device: &Device,
    desc: &PipelineDesc,
    raster: &RasterState,
    vertices: &[f32],
    attributes: u8,
    size: (u32, u32),
    cut: Cut,
) -> Vec<u8> {
    let color = image(Format::Rgba8, size.0, size.1);
    let depth = image(Format::D24, size.0, size.1);
    let mut commands = CommandBuffer::new();
    commands.push(pass(&color, Some(&depth), size.0, size.1));
    commands.push(Command::Clear {
        value: ClearValue::Depth(1.0),
        area: Rect { x: 0, y: 0, width: size.0, height: size.1 },
    });
    commands.push(Command::BindPipeline(Pipeline::new(desc.clone()).expect("valid")));
    commands.push(Command::BindVertices(bindings(vertices, attributes)));
    commands.push(viewport(size.0, size.1));
    commands.push(Command::SetRaster(Arc::new(raster.clone())));
    let all = vertices.len() as u32 / (u32::from(attributes) * 4);
    let count = match cut {
        Cut::No => all,
        Cut::ByTriangle => 3,
    };
    for first in (0..all).step_by(count.max(1) as usize) {
        commands.push(Command::Draw { first, count, instances: 0..1 });
    }
    commands.push(Command::EndPass);
    device.submit(&commands).expect("legal");
    bytes(&color)
}

/// Whether a picture is one draw.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Cut {
    No,
    ByTriangle,
}

/// The colour is varyings 0 to 3.
fn varyings(b: &mut Builder) -> [Value; 4] {
    [0, 1, 2, 3].map(|slot| b.input(Input::Varying(slot)))
}

/// A fragment module that interpolates a colour.
fn colored() -> PipelineDesc {
    pipeline(vertex(4), fragment(4, varyings))
}

/// splitmix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ z >> 31
    }

    /// In [low, high).
    fn float(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * ((self.next() >> 40) as f32 / 16_777_216.0)
    }
}

/// Triangles of all sizes in perspective, some behind the eye, with depth and blending.
fn soup(count: usize) -> Vec<f32> {
    let mut random = Random(7);
    let mut out = Vec::new();
    for i in 0..count {
        let size = [0.05, 0.3, 3.0][i % 3];
        let center = [random.float(-1.2, 1.2), random.float(-1.2, 1.2)];
        for _ in 0..3 {
            let w = random.float(if i % 7 == 0 { -0.5 } else { 0.2 }, 2.0);
            let x = center[0] + random.float(-size, size);
            let y = center[1] + random.float(-size, size);
            out.extend([x * w, y * w, random.float(-1.1, 1.1) * w, w]);
            out.extend([
                random.float(0.0, 1.0),
                random.float(0.0, 1.0),
                random.float(0.0, 1.0),
                0.5,
            ]);
        }
    }
    out
}

#[test]
fn every_instruction_set_and_thread_count_gives_the_same_bits() {
    let mut desc = colored();
    desc.depth = Some(DepthState { test: Compare::LessEqual, write: DepthWrite::On });
    desc.colors[0].blend = Some(Blend {
        equation: [BlendEquation::Add; 2],
        src: [BlendFactor::SrcAlpha, BlendFactor::One],
        dst: [BlendFactor::OneMinusSrcAlpha, BlendFactor::One],
        constant: [0.0; 4],
    });
    let vertices = soup(600);
    let mut first: Option<Vec<u8>> = None;
    for device in devices() {
        let got = picture(&device, &desc, &vertices, 2, (203, 150));
        let want = first.get_or_insert_with(|| got.clone());
        assert!(*want == got, "{:?}", device.desc());
    }
    let drawn = first.expect("there is a device").chunks(4).filter(|p| p[3] != 0).count();
    assert!(drawn > 15_000, "{drawn} of {} pixels drawn", 203 * 150);
}

/// What the planes and the coverage of a group give is what they give for each triangle alone.
#[test]
fn small_triangles_of_one_draw_look_as_if_each_were_a_draw() {
    let mut desc = colored();
    desc.depth = Some(DepthState { test: Compare::Less, write: DepthWrite::On });
    desc.colors[0].blend = Some(Blend {
        equation: [BlendEquation::Add; 2],
        src: [BlendFactor::SrcAlpha, BlendFactor::One],
        dst: [BlendFactor::OneMinusSrcAlpha, BlendFactor::One],
        constant: [0.0; 4],
    });
    let mut random = Random(11);
    let mut vertices = Vec::new();
    for i in 0..3000 {
        let size = [0.01, 0.03, 0.1][i % 3];
        let (x, y) = (random.float(-1.1, 1.1), random.float(-1.1, 1.1));
        for _ in 0..3 {
            let w = random.float(0.5, 2.0);
            let (x, y) = (x + random.float(-size, size), y + random.float(-size, size));
            vertices.extend([x * w, y * w, random.float(-1.0, 1.0) * w, w]);
            vertices.extend([(); 3].map(|()| random.float(0.0, 1.0)));
            vertices.push(0.5);
        }
    }
    let raster = RasterState::default();
    for device in devices() {
        let draw = |cut| picture_cut(&device, &desc, &raster, &vertices, 2, (203, 150), cut);
        assert!(draw(Cut::No) == draw(Cut::ByTriangle), "{:?}", device.desc());
    }
}

#[test]
fn a_square_covers_every_pixel_once() {
    // Additive blending of 1/255 shows how often a pixel was drawn.
    let mut desc = colored();
    desc.colors[0].blend = Some(Blend {
        equation: [BlendEquation::Add; 2],
        src: [BlendFactor::One; 2],
        dst: [BlendFactor::One; 2],
        constant: [0.0; 4],
    });
    // A fan whose spokes run at every angle.
    let mut vertices = Vec::new();
    let step = 1.0 / 255.0;
    let n = 97;
    let rim = |i: usize| {
        let t = (i % n) as f32 / n as f32 * 4.0;
        match t as u32 {
            0 => [t * 2.0 - 1.0, -1.0],
            1 => [1.0, (t - 1.0) * 2.0 - 1.0],
            2 => [1.0 - (t - 2.0) * 2.0, 1.0],
            _ => [-1.0, 1.0 - (t - 3.0) * 2.0],
        }
    };
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let mut points: Vec<[f32; 2]> = (0..n).map(rim).collect();
    points.extend(corners);
    points.sort_by(|a, b| {
        let angle = |p: &[f32; 2]| f64::from(p[1] - 0.013).atan2(f64::from(p[0] - 0.1));
        angle(a).total_cmp(&angle(b))
    });
    for i in 0..points.len() {
        for p in [[0.1, 0.013], points[i], points[(i + 1) % points.len()]] {
            vertices.extend([p[0], p[1], 0.0, 1.0, step, step, step, step]);
        }
    }
    for device in devices() {
        for size in [(64, 64), (131, 77), (1, 1)] {
            let got = picture(&device, &desc, &vertices, 2, size);
            for (i, pixel) in got.chunks(4).enumerate() {
                let at = (i as u32 % size.0, i as u32 / size.0);
                assert_eq!(pixel, [1; 4], "pixel {at:?} of {size:?}");
            }
        }
    }
}

#[test]
fn varyings_are_perspective_correct() {
    // A floor from w = 1 to w = 100: the varying is linear in clip space.
    let desc = colored();
    let quad = [(-1.0, -1.0, 1.0, 0.0), (1.0, -1.0, 1.0, 0.0), (1.0, 1.0, 100.0, 1.0)];
    let other = [(-1.0, -1.0, 1.0, 0.0), (1.0, 1.0, 100.0, 1.0), (-1.0, 1.0, 100.0, 1.0)];
    let vertices: Vec<f32> = quad
        .iter()
        .chain(&other)
        .flat_map(|&(x, y, w, v)| [x * w, y * w, 0.0, w, v, v, v, 1.0])
        .collect();
    for device in devices() {
        let got = picture(&device, &desc, &vertices, 2, (64, 256));
        for y in 0..256 {
            let t = (f64::from(y) + 0.5) / 256.0;
            let want = (t / 100.0) / ((1.0 - t) + t / 100.0);
            let pixel = got[(y as usize * 64 + 31) * 4];
            assert!(
                (f64::from(pixel) - want * 255.0).abs() <= 0.5 + 1e-4,
                "row {y}: {pixel}, {want}"
            );
        }
    }
}

#[test]
fn a_triangle_through_the_eye_is_cut_at_the_near_plane() {
    // One vertex behind the eye: its part in front of the near plane is drawn, with the varyings
    // that the whole triangle has there.
    let desc = colored();
    let vertices = [
        [-2.0, -1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0],
        [2.0, -1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0],
        [0.0, 8.0, -3.0, -2.0, 0.0, 0.0, 1.0, 1.0],
    ]
    .concat();
    for device in devices() {
        let got = picture(&device, &desc, &vertices, 2, (64, 64));
        assert_eq!(got[4 * 32 + 3], 255, "the lowest row is drawn");
        for (i, pixel) in got.chunks(4).enumerate().filter(|(_, p)| p[3] != 0) {
            let (x, y) = ((i % 64) as f64 + 0.5, (i / 64) as f64 + 0.5);
            // The weights of the vertices: solve window = Σ b_i p_i in homogeneous coordinates.
            let ndc = [x / 32.0 - 1.0, y / 32.0 - 1.0, 1.0];
            let column = |k: usize| {
                let v = &vertices[k * 8..];
                [f64::from(v[0]), f64::from(v[1]), f64::from(v[3])]
            };
            let det = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
                a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                    + a[2] * (b[0] * c[1] - b[1] * c[0])
            };
            let (a, b, c) = (column(0), column(1), column(2));
            let weights = [det(ndc, b, c), det(a, ndc, c), det(a, b, ndc)];
            let sum: f64 = weights.iter().sum();
            for k in 0..3 {
                let want = weights[k] / sum * 255.0;
                assert!((f64::from(pixel[k]) - want).abs() < 0.51, "{x},{y}: {pixel:?} {want}");
            }
        }
    }
}

#[test]
fn depth_compares_as_asked_and_culling_takes_the_back() {
    let quad = |z: f32, color: [f32; 4]| {
        let c = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        c.into_iter()
            .flat_map(move |[x, y]| [x, y, z, 1.0].into_iter().chain(color))
            .collect::<Vec<f32>>()
    };
    let mut vertices = quad(0.0, [1.0, 0.0, 0.0, 1.0]);
    vertices.extend(quad(0.5, [0.0, 1.0, 0.0, 1.0]));
    vertices.extend(quad(-0.5, [0.0, 0.0, 1.0, 1.0]));
    let device = &devices()[0];
    for (test, want) in [
        (Compare::Less, [0, 0, 255, 255]),
        (Compare::Always, [0, 0, 255, 255]),
        (Compare::Greater, [0, 0, 0, 0]),
        (Compare::Never, [0, 0, 0, 0]),
    ] {
        let mut desc = colored();
        desc.depth = Some(DepthState { test, write: DepthWrite::On });
        let got = picture(device, &desc, &vertices, 2, (16, 16));
        assert!(got.chunks(4).all(|p| p == want), "{test:?}: {:?}", &got[..4]);
    }
    for (cull, drawn) in
        [(Cull::None, true), (Cull::Front, false), (Cull::Back, true), (Cull::Both, false)]
    {
        let desc = PipelineDesc { cull, ..colored() };
        let got = picture(device, &desc, &vertices, 2, (16, 16));
        assert_eq!(got[3] == 255, drawn, "{cull:?}");
    }
}

#[test]
fn what_is_not_a_number_or_beyond_all_bounds_draws_nothing_or_is_cut() {
    let desc = colored();
    let numbers =
        [0.0, 1.0, -1.0, 1e30, -1e30, 3e38, f32::INFINITY, f32::NAN, 1e-40, f32::MIN_POSITIVE];
    let mut random = Random(3);
    let mut pick = || numbers[(random.next() % numbers.len() as u64) as usize];
    let mut vertices = Vec::new();
    for _ in 0..3000 {
        vertices.extend([pick(), pick(), pick(), pick(), pick(), pick(), pick(), 1.0]);
    }
    for topology in [Topology::Triangles, Topology::Lines, Topology::Points, Topology::Quads] {
        let desc = PipelineDesc { topology, ..desc.clone() };
        let pictures: Vec<_> =
            devices().iter().map(|d| picture(d, &desc, &vertices, 2, (70, 70))).collect();
        assert!(pictures.windows(2).all(|p| p[0] == p[1]), "{topology:?}");
    }
}

#[test]
fn lines_and_points_cover_their_pixels() {
    let device = &devices()[0];
    let line = |x0: f32, y0: f32, x1: f32, y1: f32| {
        [[x0, y0], [x1, y1]]
            .into_iter()
            .flat_map(|[x, y]| [x / 8.0 - 1.0, y / 8.0 - 1.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0])
            .collect::<Vec<f32>>()
    };
    let lines = PipelineDesc { topology: Topology::Lines, ..colored() };
    let drawn = |desc: &PipelineDesc, vertices: &[f32]| {
        let got = picture(device, desc, vertices, 2, (16, 16));
        let mut at = Vec::new();
        for (i, pixel) in got.chunks(4).enumerate() {
            if pixel[0] != 0 {
                at.push((i % 16, i / 16));
            }
        }
        at
    };
    assert_eq!(drawn(&lines, &line(2.1, 3.5, 5.1, 3.5)), [(2, 3), (3, 3), (4, 3)]);
    assert_eq!(drawn(&lines, &line(3.5, 5.1, 3.5, 2.1)), [(3, 3), (3, 4), (3, 5)]);
    // Ends between two diamonds count as a little to the left (GL 2.1, section 3.4.1).
    assert_eq!(drawn(&lines, &line(2.0, 3.5, 5.0, 3.5)), [(1, 3), (2, 3), (3, 3)]);
    assert_eq!(drawn(&lines, &line(1.5, 1.5, 4.5, 4.5)), [(1, 1), (2, 2), (3, 3)]);
    let points = PipelineDesc { topology: Topology::Points, ..colored() };
    assert_eq!(drawn(&points, &line(2.7, 3.2, 9.0, 9.0)), [(2, 3), (9, 9)]);
}

#[test]
fn a_draw_that_needs_little_says_what_it_left_out() {
    let device = device(Isa::BASELINE, 1);
    let desc = pipeline(
        vertex(4),
        fragment(4, |b| {
            let red = b.input(Input::Varying(0));
            let half = b.float(0.5);
            let red = b.op(Op::Mul, &[red, half]);
            [red; 4]
        }),
    );
    picture(&device, &desc, &soup(1), 2, (8, 8));
    let plans = device.take_explanations();
    assert_eq!(plans.len(), 1);
    for part in [
        "1 scalars interpolated, of them 1 made of others at the vertices",
        "left out: 3 that the fragment stage does not read",
        "left out: no depth test",
        "left out: blending",
    ] {
        assert!(plans[0].contains(part), "{part} is not in\n{}", plans[0]);
    }
}
