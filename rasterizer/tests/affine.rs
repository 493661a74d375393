//! What fragments make of varyings by affine maps is computed at the vertices, where that leaves no more to
//! interpolate: what is, what is not, and that pictures are as the formulas have it in either case.

mod common;

use common::{bindings, bytes, device, fragment, image, pass, pipeline, vertex, viewport};
use rasterizer::driver::{Command, CommandBuffer, Pipeline, PipelineDesc, RasterState, Topology};
use rasterizer::ir::{Builder, Input, Interpolation, Op, Ty, Value};
use std::sync::Arc;
use texunit::format::Format;
use texunit::lanes::Isa;

const SIZE: u32 = 32;
/// What is far is so much farther than what is near.
const FAR: f64 = 5.0;
/// The uniform words.
const WORDS: [f32; 4] = [0.75, -1.5, 0.3, 2.0];

/// What a vertex has for varyings, and what a pixel has of them.
fn attributes(s: f64, t: f64) -> [f64; 4] {
    [s, t, 0.5 + s - 2.0 * t, 3.0 - t]
}

/// A floor that fills the picture, in perspective: position, then [`attributes`].
fn floor() -> Vec<f32> {
    let corner = |x: f64, y: f64| {
        let w = if y > 0.0 { FAR } else { 1.0 };
        let place = [x * w, y * w, 0.0, w];
        [place, attributes((x + 1.0) * 0.5 * w, (y + 1.0) * 0.5 * w)].concat()
    };
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    corners.into_iter().flat_map(|[x, y]| corner(x, y)).map(|v| v as f32).collect()
}

/// The varyings of a pixel. On the screen 1/w, s/w and t/w are linear.
fn exact(pixel: u32) -> [f64; 4] {
    let [u, v] = [pixel % SIZE, pixel / SIZE].map(|at| (f64::from(at) + 0.5) / f64::from(SIZE));
    let inverse = 1.0 - v * (1.0 - 1.0 / FAR);
    attributes(u / inverse, v / inverse)
}

/// The picture of a draw over all of it, and what is said of the draw's varyings.
fn drawn(
    isa: Isa,
    desc: &PipelineDesc,
    raster: RasterState,
    vertices: &[f32],
) -> (Vec<f32>, String) {
    let device = device(isa, 2);
    let color = image(Format::Rgba32F, SIZE, SIZE);
    let mut commands = CommandBuffer::new();
    commands.push(pass(&color, None, SIZE, SIZE));
    commands.push(Command::BindPipeline(Pipeline::new(desc.clone()).expect("valid")));
    commands.push(Command::BindVertices(bindings(vertices, 2)));
    commands.push(Command::SetUniforms(WORDS.map(f32::to_bits).into()));
    commands.push(Command::SetRaster(Arc::new(raster)));
    commands.push(viewport(SIZE, SIZE));
    let count = vertices.len() as u32 / 8;
    commands.push(Command::Draw { first: 0, count, instances: 0..1 });
    commands.push(Command::EndPass);
    device.submit(&commands).expect("legal");
    let floats =
        bytes(&color).chunks(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
    let said = device.take_explanations().concat();
    let line = said.lines().find(|line| line.trim_start().starts_with("varyings"));
    (floats, line.unwrap_or_default().to_owned())
}

/// A fragment module, what it computes of the varyings, and what is to be said of them.
struct Case {
    what: &'static str,
    color: fn(&mut Builder) -> [Value; 4],
    formula: fn([f64; 4]) -> [f64; 4],
    said: &'static str,
}

fn varying(b: &mut Builder, slot: u16) -> Value {
    b.input(Input::Varying(slot))
}

fn word(b: &mut Builder, at: u32) -> Value {
    b.uniform(at, Ty::F32)
}

/// `(w0·v0 + w1·v1 + w2·v2) / w3 - v0`.
fn row(b: &mut Builder) -> Value {
    let [v0, v1, v2] = [0, 1, 2].map(|slot| varying(b, slot));
    let [w0, w1, w2, w3] = [0, 1, 2, 3].map(|at| word(b, at));
    let products = [(w0, v0), (v1, w1), (w2, v2)].map(|(a, c)| b.op(Op::Mul, &[a, c]));
    let sum = b.op(Op::Add, &[products[0], products[1]]);
    let sum = b.op(Op::Add, &[sum, products[2]]);
    let scaled = b.op(Op::Div, &[sum, w3]);
    b.op(Op::Sub, &[scaled, v0])
}

fn row_of([v0, v1, v2, _]: [f64; 4]) -> f64 {
    let [w0, w1, w2, w3] = WORDS.map(f64::from);
    (w0 * v0 + w1 * v1 + w2 * v2) / w3 - v0
}

const CASES: &[Case] = &[
    Case {
        what: "one map of three varyings, and its square",
        color: |b| {
            let map = row(b);
            let square = b.op(Op::Mul, &[map, map]);
            [map, square, map, map]
        },
        formula: |v| [row_of(v), row_of(v).powi(2), row_of(v), row_of(v)],
        said: "1 scalars interpolated, of them 1 made of others at the vertices",
    },
    Case {
        what: "two varyings apart, each with a map; a third as it is",
        color: |b| {
            let [v0, v1, v3, half] = [varying(b, 0), varying(b, 1), varying(b, 3), b.float(0.5)];
            let (halved, moved) = (b.op(Op::Mul, &[v0, half]), b.op(Op::Sub, &[half, v1]));
            let turned = b.op(Op::Neg, &[moved]);
            [halved, turned, v3, v3]
        },
        formula: |[v0, v1, _, v3]| [v0 * 0.5, v1 - 0.5, v3, v3],
        said: "3 scalars interpolated, of them 2 made of others at the vertices",
    },
    Case {
        what: "more maps than varyings",
        color: |b| {
            let (v0, w) = (varying(b, 0), word(b, 0));
            let (sum, product) = (b.op(Op::Add, &[v0, w]), b.op(Op::Mul, &[v0, w]));
            [sum, product, sum, sum]
        },
        formula: |[v0, ..]| [v0 + 0.75, v0 * 0.75, v0 + 0.75, v0 + 0.75],
        said: "1 scalars interpolated; left out",
    },
    Case {
        what: "a varying that is read besides",
        color: |b| {
            let (v0, w) = (varying(b, 0), word(b, 0));
            let sum = b.op(Op::Add, &[v0, w]);
            [sum, v0, sum, sum]
        },
        formula: |[v0, ..]| [v0 + 0.75, v0, v0 + 0.75, v0 + 0.75],
        said: "1 scalars interpolated; left out",
    },
    Case {
        what: "products and quotients of varyings",
        color: |b| {
            let ([v0, v3], w) = ([varying(b, 0), varying(b, 3)], word(b, 0));
            let (product, quotient) = (b.op(Op::Mul, &[v0, v3]), b.op(Op::Div, &[w, v3]));
            [product, quotient, product, quotient]
        },
        formula: |[v0, _, _, v3]| [v0 * v3, 0.75 / v3, v0 * v3, 0.75 / v3],
        said: "2 scalars interpolated; left out",
    },
    Case {
        what: "a flat varying, one at the centroid, one linear on the screen",
        color: |b| {
            b.module_mut().varyings[0] = Interpolation::Flat;
            b.module_mut().varyings[2] = Interpolation::NoPerspective;
            b.module_mut().centroids = vec![1];
            let w = word(b, 3);
            let [x, y, _] = [0, 1, 2].map(|slot| {
                let v = varying(b, slot);
                b.op(Op::Mul, &[v, w])
            });
            // Linear on the screen is not what the formulas here have.
            let rest = b.input(Input::Varying(2));
            let rest = b.op(Op::Sub, &[rest, rest]);
            let flat = b.op(Op::Sub, &[x, x]);
            [flat, y, rest, y]
        },
        formula: |[_, v1, ..]| [0.0, 2.0 * v1, 0.0, 2.0 * v1],
        said: "3 scalars interpolated; left out",
    },
    Case {
        what: "a chain that is longer than what is followed",
        color: |b| {
            let (mut v, w) = (varying(b, 0), word(b, 0));
            (0..200).for_each(|_| v = b.op(Op::Add, &[v, w]));
            [v; 4]
        },
        formula: |[v0, ..]| [v0 + 150.0; 4],
        said: "1 scalars interpolated, of them 1 made of others at the vertices",
    },
];

#[test]
fn maps_that_need_no_more_varyings_are_made_at_the_vertices() {
    for case in CASES {
        let desc = pipeline(vertex(4), fragment(4, case.color));
        let mut first = None;
        for isa in Isa::available() {
            let (picture, said) = drawn(isa, &desc, RasterState::default(), &floor());
            assert!(said.contains(case.said), "{}: {said}", case.what);
            for (at, pixel) in (0..).zip(picture.chunks(4)) {
                for (got, want) in pixel.iter().zip((case.formula)(exact(at))) {
                    let error = (f64::from(*got) - want).abs();
                    assert!(error < 4e-6 * want.abs().max(2.0), "{}: {got}, {want}", case.what);
                }
            }
            let bits: Vec<u32> = picture.iter().map(|v| v.to_bits()).collect();
            assert!(*first.get_or_insert_with(|| bits.clone()) == bits, "{}: {isa:?}", case.what);
        }
    }
}

#[test]
fn what_sprites_replace_is_mapped_by_the_fragments() {
    let color = fragment(4, |b| {
        let [two, one] = [2.0, 1.0].map(|v| b.float(v));
        let [x, y] = [0, 1].map(|slot| {
            let coordinate = varying(b, slot);
            let doubled = b.op(Op::Mul, &[coordinate, two]);
            b.op(Op::Add, &[doubled, one])
        });
        [x, y, x, y]
    });
    let desc = PipelineDesc { topology: Topology::Points, ..pipeline(vertex(4), color) };
    let point = [0.0, 0.0, 0.0, 1.0, 7.0, 7.0, 7.0, 7.0];
    for (sprite, said) in
        [(Some(vec![0]), "2 scalars interpolated; left out"), (None, ", of them 2")]
    {
        let mut raster = RasterState::default();
        raster.point.size = SIZE as f32;
        raster.point.sprite.clone_from(&sprite);
        let (picture, line) = drawn(Isa::best(), &desc, raster, &point);
        assert!(line.contains(said), "{line}");
        for (at, pixel) in (0..SIZE * SIZE).zip(picture.chunks(4)) {
            let [s, t] =
                [at % SIZE, SIZE - 1 - at / SIZE].map(|at| (at as f32 + 0.5) / SIZE as f32);
            let want = match sprite {
                Some(_) => [2.0 * s + 1.0, 2.0 * t + 1.0],
                None => [15.0; 2],
            };
            assert!((0..2).all(|i| (pixel[i] - want[i]).abs() < 1e-5), "{at}: {pixel:?} {want:?}");
        }
    }
}
