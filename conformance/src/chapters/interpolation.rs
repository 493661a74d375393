//! Interpolation over triangles in perspective: data, and depth.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::interpolation::{self, Vertex, barycentric};
use crate::probe::{self, Precision, ProbeError, SIZE, shader};
use crate::rng::Rng;

/// A varying.
pub const PERSPECTIVE: Check = Check {
    name: "perspective",
    citation: "GL 2.1, 3.5.1: f = Σ a·fa/wa / Σ a/wa",
    what: "a varying at each pixel centre of random triangles, w from 1 to 64",
    unit: Unit::FullScale,
    tolerance: 8.0 / (1 << 24) as f64,
    why: "f32: f/w and 1/w to 2^-24 of their largest value, three corners each, then one division",
    run: |harness, tally| run(harness, tally, Quantity::Datum),
};

/// Window depth.
pub const DEPTH: Check = Check {
    name: "depth",
    citation: "GL 2.1, 3.5.1 and 2.11.1",
    what: "gl_FragCoord.z at each pixel centre, under three depth ranges",
    unit: Unit::FullScale,
    tolerance: 2.5 / (1 << 24) as f64,
    why: "f32: the value at a block's first pixel, up to 2 outside of the triangle, by 2^-24; two sums by 2^-25; two products and two slopes of at most half of it by 2^-26: twice the root of the sum of their squares is 2.6 · 2^-24",
    run: |harness, tally| run(harness, tally, Quantity::Depth),
};

/// The interpolated quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Quantity {
    Datum,
    Depth,
}

const DEPTH_RANGES: [[f64; 2]; 3] = [[0.0, 1.0], [0.25, 0.5], [1.0, 0.0]];

fn run(harness: &Harness, tally: &mut Tally, quantity: Quantity) -> Result<(), ProbeError> {
    let mut rng = Rng::named("interpolation");
    for round in 0..harness.cases(32) {
        let triangle = triangle(&mut rng);
        let range = match quantity {
            Quantity::Datum => DEPTH_RANGES[0],
            Quantity::Depth => DEPTH_RANGES[round % DEPTH_RANGES.len()],
        };
        let pixels = inside(&triangle);
        let expect = |&pixel: &[usize; 2], variant: Variant| {
            let value = match quantity {
                Quantity::Datum => interpolation::datum(&triangle, pixel, variant),
                Quantity::Depth => interpolation::depth(&triangle, pixel, range, variant),
            };
            [value, 0.0, 0.0, 0.0]
        };
        harness.compare(tally, &(triangle, range), &pixels, expect, |session| {
            session.depth_range(range);
            let body = match quantity {
                Quantity::Datum => shader::INPUT,
                Quantity::Depth => shader::FRAGMENT_DEPTH,
            };
            let program = session.program(body, Precision::Exact { components: 1 })?;
            let picture = session.triangles(&program, &triangle.map(clip))?;
            Ok(pixels.iter().map(|&[x, y]| picture[y * SIZE + x]).collect())
        })?;
    }
    Ok(())
}

/// A triangle of at least an eighth of the picture. Window positions are multiples of 1/16 pixel
/// and w of 1/4, so that clip coordinates are exact in `f32`.
fn triangle(rng: &mut Rng) -> [Vertex; 3] {
    loop {
        let triangle = [0; 3].map(|_: i32| Vertex {
            xy: [0; 2].map(|_: i32| f64::from(rng.dyadic(0.0, SIZE as f64, 1.0 / 16.0))),
            z: f64::from(rng.dyadic(-1.0, 1.0, 1.0 / 256.0)),
            w: f64::from(rng.dyadic(1.0, 64.0, 0.25)),
            datum: f64::from(rng.dyadic(0.0, 1.0, 1.0 / 256.0)),
        });
        let [a, b, c] = triangle.map(|v| v.xy);
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        if area.abs() > (SIZE * SIZE) as f64 / 4.0 {
            return triangle;
        }
    }
}

/// The pixels whose centres are inside, and not on an edge.
fn inside(triangle: &[Vertex; 3]) -> Vec<[usize; 2]> {
    let all = (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| [x, y]));
    let within = |&[x, y]: &[usize; 2]| {
        barycentric(triangle, [x as f64 + 0.5, y as f64 + 0.5]).iter().all(|&b| b > 1e-6)
    };
    all.filter(within).collect()
}

fn clip(v: Vertex) -> probe::Vertex {
    let ndc = v.xy.map(|c| 2.0 * c / SIZE as f64 - 1.0);
    let position = [ndc[0] * v.w, ndc[1] * v.w, v.z * v.w, v.w].map(|c| c as f32);
    probe::Vertex { position, inputs: [[v.datum as f32, 0.0, 0.0, 0.0], [0.0; 4], [0.0; 4]] }
}
