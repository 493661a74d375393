//! Points, lines, polygon modes and user clip planes: which pixels are drawn, against formulas.

mod instances;
mod packing;
mod products;
mod sides;
mod stencil_blocks;
mod targets;

use super::common::{fragment, pipeline, vertex};
use super::{Random, colored, devices, picture_with, varyings};
use rasterizer::driver::{
    Antialiasing, Blend, BlendEquation, BlendFactor, Device, LineStipple, PipelineDesc, PointSize,
    PolygonMode, PolygonOffset, RasterState, ShaderModule, SpriteOrigin, Stipple, Topology,
};
use rasterizer::ir::{Builder, Input, Op, Output, Stage};
use std::collections::BTreeSet;

const SIZE: u32 = 32;

/// A vertex at window `(x, y)` of a picture of [`SIZE`], white.
fn at(x: f32, y: f32) -> [f32; 8] {
    let half = SIZE as f32 / 2.0;
    [x / half - 1.0, y / half - 1.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0]
}

fn vertices(points: &[[f32; 2]]) -> Vec<f32> {
    points.iter().flat_map(|&[x, y]| at(x, y)).collect()
}

fn draw(device: &Device, desc: &PipelineDesc, raster: &RasterState, vertices: &[f32]) -> Vec<u8> {
    picture_with(device, desc, raster, vertices, 2, (SIZE, SIZE))
}

/// The pixels with any red.
fn drawn(topology: Topology, raster: &RasterState, points: &[[f32; 2]]) -> BTreeSet<(u32, u32)> {
    let desc = PipelineDesc { topology, ..colored() };
    let picture = draw(&devices()[0], &desc, raster, &vertices(points));
    let pixels = (0..).zip(picture.chunks(4)).filter(|(_, pixel)| pixel[0] != 0);
    pixels.map(|(i, _)| (i % SIZE, i / SIZE)).collect()
}

fn set(pixels: impl IntoIterator<Item = (u32, u32)>) -> BTreeSet<(u32, u32)> {
    pixels.into_iter().collect()
}

/// Adds what is drawn to what is there.
fn added(desc: &mut PipelineDesc) {
    desc.colors[0].blend = Some(Blend {
        equation: [BlendEquation::Add; 2],
        src: [BlendFactor::One; 2],
        dst: [BlendFactor::One; 2],
        constant: [0.0; 4],
    });
}

#[test]
fn aliased_points_are_squares_of_whole_sizes() {
    for (size, center, low, side) in [
        (1.0, [4.9, 4.1], 4, 1),
        (0.2, [4.9, 4.1], 4, 1),
        (2.0, [4.4, 4.3], 3, 2),
        (2.4, [4.4, 4.3], 3, 2),
        (3.0, [4.9, 4.1], 3, 3),
        (6.0, [4.6, 5.4], 2, 6),
    ] {
        let mut raster = RasterState::default();
        raster.point.size = size;
        let want = set((0..side).flat_map(|y| (0..side).map(move |x| (low + x, low + y))));
        assert_eq!(drawn(Topology::Points, &raster, &[center]), want, "{size}");
    }
}

#[test]
fn a_sprite_covers_the_centres_in_its_square_and_counts_from_its_origin() {
    let color = fragment(4, |b| {
        let coords = [0, 1].map(|axis| b.input(Input::PointCoord(axis)));
        let replaced = [0, 1].map(|slot| b.input(Input::Varying(slot)));
        [coords[0], coords[1], replaced[0], replaced[1]]
    });
    let desc = PipelineDesc { topology: Topology::Points, ..pipeline(vertex(4), color) };
    let (center, size) = ([7.3_f64, 9.8_f64], 5.5_f64);
    for origin in [SpriteOrigin::UpperLeft, SpriteOrigin::LowerLeft] {
        let mut raster = RasterState::default();
        raster.point.size = size as f32;
        raster.point.sprite = Some(vec![0]);
        raster.point.origin = origin;
        for device in devices() {
            let got = draw(&device, &desc, &raster, &at(center[0] as f32, center[1] as f32));
            for (i, pixel) in (0..).zip(got.chunks(4)) {
                let p = [f64::from(i % SIZE) + 0.5, f64::from(i / SIZE) + 0.5];
                let coords = [0, 1].map(|axis| 0.5 + (p[axis] - center[axis]) / size);
                let inside = coords.iter().all(|c| (0.0..1.0).contains(c));
                let s = if inside { coords[0] } else { 0.0 };
                let t = match origin {
                    SpriteOrigin::UpperLeft => 1.0 - coords[1],
                    SpriteOrigin::LowerLeft => coords[1],
                };
                let t = if inside { t } else { 0.0 };
                for (channel, want) in [s, t, s, t].into_iter().enumerate() {
                    let got = f64::from(pixel[channel]);
                    assert!((got - want * 255.0).abs() < 0.51, "{p:?}: {pixel:?}, {want}");
                }
            }
        }
    }
}

#[test]
fn the_vertex_stage_gives_the_size_where_the_state_says_so() {
    let mut b = Builder::new(Stage::Vertex);
    for component in 0..4 {
        let value = b.input(Input::Attribute { location: 0, component });
        let out = b.output(Output::Position(component));
        b.store(out, value);
    }
    let three = b.float(3.0);
    let out = b.output(Output::PointSize);
    b.store(out, three);
    let sized = ShaderModule::new(b.finish()).expect("valid");
    let white = fragment(0, |b| [1.0; 4].map(|v| b.float(v)));
    let desc = PipelineDesc { topology: Topology::Points, ..pipeline(sized, white) };
    for (source, want) in [(PointSize::State, 1), (PointSize::Vertex, 9)] {
        let mut raster = RasterState::default();
        raster.point.source = source;
        let got = draw(&devices()[0], &desc, &raster, &at(8.5, 8.5));
        assert_eq!(got.chunks(4).filter(|pixel| pixel[0] != 0).count(), want);
    }
}

/// The coverage of what is drawn, as a picture of red.
fn coverage() -> PipelineDesc {
    pipeline(
        vertex(4),
        fragment(4, |b| {
            let part = b.input(Input::Coverage);
            [part; 4]
        }),
    )
}

#[test]
fn smooth_primitives_cover_their_area() {
    let mut raster = RasterState::default();
    raster.point.antialiasing = Antialiasing::Smooth;
    raster.line.antialiasing = Antialiasing::Smooth;
    raster.polygon.antialiasing = Antialiasing::Smooth;
    raster.point.size = 9.5;
    raster.line.width = 2.5;
    let triangle = [[3.2, 4.1], [27.9, 9.7], [11.3, 29.2]];
    let area = |p: [[f32; 2]; 3]| {
        let d = |i: usize, axis: usize| f64::from(p[i][axis]) - f64::from(p[0][axis]);
        (d(1, 0) * d(2, 1) - d(2, 0) * d(1, 1)) / 2.0
    };
    let (dx, dy) = (21.7_f64, 11.1_f64);
    for (topology, points, want) in [
        (Topology::Points, vec![[15.3, 14.8]], std::f64::consts::PI * 4.75 * 4.75),
        (Topology::Lines, vec![[4.3, 5.2], [26.0, 16.3]], (dx * dx + dy * dy).sqrt() * 2.5),
        (Topology::Triangles, triangle.to_vec(), area(triangle)),
    ] {
        let mut desc = PipelineDesc { topology, ..coverage() };
        added(&mut desc);
        let mut first = None;
        for device in devices() {
            let got = draw(&device, &desc, &raster, &vertices(&points));
            let sum: f64 = got.chunks(4).map(|pixel| f64::from(pixel[0]) / 255.0).sum();
            assert!((sum - want).abs() < 0.01 * want, "{topology:?}: {sum}, {want}");
            assert_eq!(*first.get_or_insert_with(|| got.clone()), got);
        }
    }
}

#[test]
fn stipple_takes_fragments_out_and_goes_on_along_a_strip() {
    let mut raster = RasterState::default();
    let points = [[2.5, 3.5], [9.5, 3.5], [9.5, 20.5], [28.5, 20.5]];
    let all = |i: u32| match i {
        0..7 => (2 + i, 3),
        7..24 => (9, 3 + (i - 7)),
        _ => (9 + (i - 24), 20),
    };
    for (factor, pattern) in [(1, 0x5555), (1, 0x00FF), (2, 0x1C47), (3, 0xAAAA), (256, 1)] {
        raster.line.stipple = Some(LineStipple { factor, pattern });
        let on = |i: u32| pattern >> (i / u32::from(factor) % 16) & 1 == 1;
        let want = set((0..43).filter(|&i| on(i)).map(all));
        assert_eq!(drawn(Topology::LineStrip, &raster, &points), want, "{factor} {pattern:x}");
        // Lines of their own begin anew.
        let want = set((0..7)
            .filter(|&i| on(i))
            .map(all)
            .chain((0..19).filter(|&i| on(i)).map(|i| (9 + i, 20))));
        assert_eq!(drawn(Topology::Lines, &raster, &points), want, "{factor} {pattern:x}");
    }
}

#[test]
fn polygons_are_drawn_as_their_mode_says() {
    let square = [[4.5, 4.5], [10.5, 4.5], [10.5, 10.5], [4.5, 10.5]];
    let rim = set((4..=10)
        .flat_map(|x| (4..=10).map(move |y| (x, y)))
        .filter(|&(x, y)| x == 4 || x == 10 || y == 4 || y == 10));
    let corners = set([(4, 4), (10, 4), (10, 10), (4, 10)]);
    for topology in [Topology::Quads, Topology::Polygon] {
        for (mode, want) in [(PolygonMode::Line, &rim), (PolygonMode::Point, &corners)] {
            let mut raster = RasterState::default();
            raster.polygon.mode = [mode; 2];
            assert_eq!(drawn(topology, &raster, &square), *want, "{topology:?} {mode:?}");
            raster.polygon.mode = [PolygonMode::Fill, mode];
            let back: Vec<_> = square.into_iter().rev().collect();
            assert_eq!(drawn(topology, &raster, &back), *want, "{topology:?} {mode:?}");
            assert_eq!(drawn(topology, &raster, &square).len(), 36);
        }
    }
    // The second component of attribute 1 is no flag; attribute 0 of a vertex at x = 0 is.
    let mut raster = RasterState::default();
    raster.polygon.mode = [PolygonMode::Point; 2];
    raster.polygon.edge_flag = Some(0);
    let quad = [[16.0, 4.5], [24.5, 4.5], [24.5, 12.5], [16.0, 12.5]];
    assert_eq!(drawn(Topology::Quads, &raster, &quad), set([(24, 4), (24, 12)]));
}

#[test]
fn a_polygon_stipple_takes_pixels_out() {
    let mut raster = RasterState::default();
    let rows: [u32; 32] = std::array::from_fn(|y| 0x8F31_0245_u32.rotate_left(y as u32 * 5));
    raster.polygon.stipple = Some(Stipple::Pattern(rows));
    let all = [[0.0, 0.0], [32.0, 0.0], [32.0, 32.0], [0.0, 32.0]];
    let on = |x: u32, y: u32| rows[y as usize] >> (31 - x) & 1 == 1;
    let want = set((0..32).flat_map(|y| (0..32).map(move |x| (x, y))).filter(|&(x, y)| on(x, y)));
    assert_eq!(drawn(Topology::Quads, &raster, &all), want);
}

#[test]
fn offsets_move_the_mode_they_are_for() {
    let depth = |b: &mut Builder| {
        let z = b.input(Input::FragCoord(2));
        [z; 4]
    };
    let desc = pipeline(vertex(4), fragment(4, depth));
    let points = [[4.5, 4.5], [28.5, 4.5], [4.5, 28.5]];
    for (index, mode) in
        [PolygonMode::Point, PolygonMode::Line, PolygonMode::Fill].into_iter().enumerate()
    {
        let mut raster = RasterState::default();
        raster.polygon.mode = [mode; 2];
        let units = 8_388_608.0 / 4.0;
        raster.polygon.offset[index] = Some(PolygonOffset { factor: 1.0, units, clamp: 0.0 });
        let got = draw(&devices()[0], &desc, &raster, &vertices(&points));
        let depths: BTreeSet<u8> = got.chunks(4).map(|pixel| pixel[0]).collect();
        assert_eq!(depths, BTreeSet::from([0, 191]), "{mode:?}");
    }
}

/// A vertex module with a distance to a plane through the window, the other way round if `sign` is
/// negative.
fn cut(planes: &[([f32; 4], f32)]) -> ShaderModule {
    let mut b = Builder::new(Stage::Vertex);
    let position =
        [0, 1, 2, 3].map(|component| b.input(Input::Attribute { location: 0, component }));
    for (component, value) in (0..).zip(position) {
        let out = b.output(Output::Position(component));
        b.store(out, value);
    }
    for slot in 0..4 {
        let value = b.input(Input::Attribute { location: 1, component: slot as u8 });
        let out = b.output(Output::Varying(slot));
        b.store(out, value);
    }
    for (n, (plane, sign)) in (0..).zip(planes) {
        let mut sum = b.float(0.0);
        for (coefficient, component) in plane.iter().zip(position) {
            let coefficient = b.float(coefficient * sign);
            let product = b.op(Op::Mul, &[coefficient, component]);
            sum = b.op(Op::Add, &[sum, product]);
        }
        let out = b.output(Output::ClipDistance(n));
        b.store(out, sum);
    }
    ShaderModule::new(b.finish()).expect("valid")
}

#[test]
fn complementary_half_spaces_draw_every_pixel_once() {
    let mut random = Random(11);
    let white = || fragment(4, varyings);
    for round in 0..40 {
        let plane = [0; 4].map(|_| random.float(-1.0, 1.0));
        let other = [0; 4].map(|_| random.float(-1.0, 1.0));
        let topology = [Topology::Triangles, Topology::Lines][round % 2];
        let mut points = Vec::new();
        for _ in 0..6 {
            let w = random.float(0.3, 3.0);
            let (x, y, z) =
                (random.float(-1.5, 1.5), random.float(-1.5, 1.5), random.float(-1.2, 1.2));
            points.extend([x * w, y * w, z * w, w]);
            points.extend([16.0 / 255.0; 4]);
        }
        let device = &devices()[round % devices().len()];
        let picture = |planes: &[([f32; 4], f32)]| {
            let mut desc = PipelineDesc { topology, ..pipeline(cut(planes), white()) };
            added(&mut desc);
            draw(device, &desc, &RasterState::default(), &points)
        };
        let quarters: Vec<_> = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)]
            .map(|(a, b)| picture(&[(plane, a), (other, b)]))
            .into();
        let halves: Vec<_> = [1.0, -1.0].map(|sign| picture(&[(plane, sign)])).into();
        for (parts, far) in [(halves, 1), (quarters, 2)] {
            let whole = picture(&[]);
            let mut wrong = 0;
            for i in (0..whole.len()).step_by(4) {
                let sum: u32 = parts.iter().map(|part| u32::from(part[i])).sum();
                wrong += usize::from(sum != u32::from(whole[i]));
            }
            // A cut corner is snapped, which may move the rest of an edge by half a subpixel: along
            // the rim, and only there, a pixel may change sides.
            assert!(wrong <= 3 * far, "round {round}: {wrong} pixels");
        }
    }
}

/// Over a square that fills the window no rim can change sides: every pixel is drawn exactly once.
#[test]
fn complementary_half_spaces_of_the_window_leave_no_seam() {
    let mut random = Random(5);
    let square = [[0.0, 0.0], [32.0, 0.0], [32.0, 32.0], [0.0, 32.0]];
    let mut all: Vec<f32> = vertices(&square);
    for vertex in all.chunks_mut(8) {
        vertex[4..].fill(16.0 / 255.0);
    }
    for round in 0..60 {
        let plane = [0; 4].map(|_| random.float(-1.0, 1.0));
        let mut sum = vec![0_u8; (SIZE * SIZE * 4) as usize];
        for sign in [1.0, -1.0] {
            let mut desc = PipelineDesc {
                topology: Topology::Quads,
                ..pipeline(cut(&[(plane, sign)]), fragment(4, varyings))
            };
            added(&mut desc);
            let got = draw(&devices()[round % 3], &desc, &RasterState::default(), &all);
            for (to, from) in sum.iter_mut().zip(got) {
                *to += from;
            }
        }
        assert!(sum.iter().all(|&v| v == 16), "round {round}");
    }
}

#[test]
fn what_is_not_a_number_is_the_same_everywhere_as_lines_and_points() {
    let numbers =
        [0.0, 1.0, -1.0, 0.3, 1e30, -1e30, 3e38, f32::INFINITY, f32::NAN, 1e-40, f32::MIN_POSITIVE];
    let mut random = Random(3);
    let mut pick = || numbers[(random.next() % numbers.len() as u64) as usize];
    let mut points = Vec::new();
    for _ in 0..600 {
        points.extend([pick(), pick(), pick(), pick(), pick(), pick(), pick(), 1.0]);
    }
    let plane = ([1.0, 0.5, 0.25, 0.1], 1.0);
    for (round, topology) in
        [Topology::Triangles, Topology::LineStrip, Topology::Points, Topology::Polygon]
            .into_iter()
            .cycle()
            .take(8)
            .enumerate()
    {
        let mut raster = RasterState::default();
        raster.line.width = 7.0;
        raster.point.size = 19.5;
        raster.line.stipple = Some(LineStipple { factor: 3, pattern: 0x5F31 });
        raster.polygon.mode = [PolygonMode::Line, PolygonMode::Point];
        raster.polygon.offset =
            [Some(PolygonOffset { factor: 1e30, units: f32::NAN, clamp: 0.0 }); 3];
        if round >= 4 {
            raster.point.antialiasing = Antialiasing::Smooth;
            raster.line.antialiasing = Antialiasing::Smooth;
        }
        let color = fragment(4, |b| {
            [0, 1, 2]
                .map(|slot| b.input(Input::Varying(slot)))
                .into_iter()
                .chain([b.input(Input::Coverage)])
                .collect::<Vec<_>>()
                .try_into()
                .expect("four")
        });
        let desc = PipelineDesc { topology, ..pipeline(cut(&[plane]), color) };
        let pictures: Vec<_> =
            devices().iter().map(|device| draw(device, &desc, &raster, &points)).collect();
        assert!(pictures.windows(2).all(|p| p[0] == p[1]), "{topology:?}");
    }
}
