//! Evaluators: curves, surfaces, generated normals and grids.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::bernstein::{curve, grid, normal, parameter, surface};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;
use gl_api::types::GLenum;

/// Curves.
pub const CURVE: Check = Check {
    name: "evaluator-curve",
    citation: "GL 2.1, 5.1, equation 5.1: glMap1, glEvalCoord1",
    what: "1 to 4 texture coordinates of random maps of orders 1 to 8 and random domains, inside and outside",
    unit: Unit::FullScale,
    tolerance: 1.5 / (1 << 23) as f64,
    why: "f32: values up to 2 outside of the domain, rounded by 2^-24, and the parameter by as much",
    run: curves,
};

/// Surfaces.
pub const SURFACE: Check = Check {
    name: "evaluator-surface",
    citation: "GL 2.1, 5.1, equation 5.2: glMap2, glEvalCoord2",
    what: "1 to 4 texture coordinates of random maps of orders 1 to 6 in u and v",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 24) as f64,
    why: "values up to 1 that are rounded to f32: 2^-25, and as much on the way",
    run: surfaces,
};

/// Generated normals.
pub const NORMAL: Check = Check {
    name: "evaluator-normal",
    citation: "GL 2.1, 5.1: GL_AUTO_NORMAL, ∂p/∂u × ∂p/∂v, normalized",
    what: "normals of random surfaces that bulge",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 24) as f64,
    why: "values up to 1 that are rounded to f32: 2^-25, and as much on the way",
    run: normals,
};

/// Grids.
pub const GRID: Check = Check {
    name: "evaluator-grid",
    citation: "GL 2.1, 5.1: glMapGrid, glEvalPoint: i · (u2 − u1)/n + u1",
    what: "texture coordinates at the points of random grids",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 24) as f64,
    why: "values up to 1 that are rounded to f32: 2^-25, and as much on the way",
    run: grids,
};

fn points(rng: &mut Rng, count: usize) -> Vec<[f32; 4]> {
    (0..count).map(|_| [0; 4].map(|_: i32| rng.real(-1.0, 1.0))).collect()
}

fn exact(points: &[[f32; 4]]) -> Vec<[f64; 4]> {
    points.iter().map(|point| point.map(f64::from)).collect()
}

/// The targets of 1 to 4 texture coordinates.
const CURVES: [GLenum; 4] = [
    GL_MAP1_TEXTURE_COORD_1,
    GL_MAP1_TEXTURE_COORD_2,
    GL_MAP1_TEXTURE_COORD_3,
    GL_MAP1_TEXTURE_COORD_4,
];
const SURFACES: [GLenum; 4] = [
    GL_MAP2_TEXTURE_COORD_1,
    GL_MAP2_TEXTURE_COORD_2,
    GL_MAP2_TEXTURE_COORD_3,
    GL_MAP2_TEXTURE_COORD_4,
];

/// The texture coordinates that a map of `1 + index` components gives: what is missing is 0, 0, 1 (section 2.7).
fn completed(value: [f64; 4], index: usize) -> [f64; 4] {
    std::array::from_fn(|i| if i <= index { value[i] } else { [0.0, 0.0, 0.0, 1.0][i] })
}

fn domain(rng: &mut Rng) -> [f32; 2] {
    let low = rng.real(-1.0, 1.0);
    [low, low + rng.real(0.5, 2.0)]
}

fn curves(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("evaluator-curve");
    for order in 1..=8usize {
        let (control, [low, high]) = (points(&mut rng, order), domain(&mut rng));
        let index = (order + 3) % 4;
        let cases: Vec<f32> =
            (0..harness.cases(512)).map(|_| low + (high - low) * rng.real(-0.1, 1.1)).collect();
        let expect = |&u: &f32, variant: Variant| {
            let at = parameter([low, high].map(f64::from), f64::from(u), variant);
            completed(curve(&exact(&control), at, variant), index)
        };
        harness.compare(tally, &(order, low, high), &cases, expect, |session| {
            session.float_target()?;
            session.show_coordinates()?;
            // What the map does not set has another value from before.
            glTexCoord4f(0.5, 0.5, 0.5, 0.5);
            let flat = control.as_flattened();
            glMap1f(CURVES[index], low, high, 4, order, flat);
            glMap1f(GL_MAP1_VERTEX_3, low, high, 3, 1, &[0.0f32; 3]);
            glEnable(CURVES[index]);
            glEnable(GL_MAP1_VERTEX_3);
            session.points(cases.len(), |k| glEvalCoord1f(cases[k]))
        })?;
    }
    Ok(())
}

/// Rows of control points, and the numbers that glMap2f takes.
fn net(rng: &mut Rng, orders: [usize; 2]) -> Vec<Vec<[f32; 4]>> {
    (0..orders[0]).map(|_| points(rng, orders[1])).collect()
}

fn flat(net: &[Vec<[f32; 4]>]) -> Vec<f32> {
    net.iter().flat_map(|row| row.as_flattened().to_vec()).collect()
}

fn exact_net(net: &[Vec<[f32; 4]>]) -> Vec<Vec<[f64; 4]>> {
    net.iter().map(|row| exact(row)).collect()
}

/// Maps texture coordinates by a net, and all vertices to one position.
fn map_net(target: GLenum, net: &[Vec<[f32; 4]>], u: [f32; 2], v: [f32; 2]) {
    let (rows, columns) = (net.len(), net[0].len());
    let numbers = flat(net);
    glMap2f(target, u[0], u[1], 4 * columns as i32, rows, v[0], v[1], 4, columns, &numbers);
    glMap2f(GL_MAP2_VERTEX_3, u[0], u[1], 3, 1, v[0], v[1], 3, 1, &[0.0f32; 3]);
    glEnable(target);
    glEnable(GL_MAP2_VERTEX_3);
}

fn surfaces(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("evaluator-surface");
    for round in 0..12usize {
        let orders = [1 + round % 6, 1 + (round * 5 + 2) % 6];
        let index = (round + 3) % 4;
        let (control, u, v) = (net(&mut rng, orders), domain(&mut rng), domain(&mut rng));
        let cases: Vec<[f32; 2]> = (0..harness.cases(512))
            .map(|_| [u, v].map(|[low, high]| low + (high - low) * rng.real(0.0, 1.0)))
            .collect();
        let expect = |case: &[f32; 2], variant: Variant| {
            let at = |i: usize, domain: [f32; 2]| {
                parameter(domain.map(f64::from), f64::from(case[i]), variant)
            };
            completed(surface(&exact_net(&control), [at(0, u), at(1, v)], variant), index)
        };
        harness.compare(tally, &(orders, u, v), &cases, expect, |session| {
            session.float_target()?;
            session.show_coordinates()?;
            glTexCoord4f(0.5, 0.5, 0.5, 0.5);
            map_net(SURFACES[index], &control, u, v);
            session.points(cases.len(), |k| glEvalCoord2f(cases[k][0], cases[k][1]))
        })?;
    }
    Ok(())
}

fn normals(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("evaluator-normal");
    for _ in 0..8 {
        // About the plane x = u, y = v, so that tangents are no shorter than 1.
        let control: Vec<Vec<[f32; 4]>> = (0..4)
            .map(|i| (0..4).map(|j| [i as f32, j as f32, rng.real(-1.0, 1.0), 1.0]).collect())
            .collect();
        let cases: Vec<[f32; 2]> =
            (0..harness.cases(512)).map(|_| [rng.real(0.0, 1.0), rng.real(0.0, 1.0)]).collect();
        let expect = |case: &[f32; 2], variant: Variant| {
            let [x, y, z] = normal(&exact_net(&control), case.map(f64::from), variant);
            [x, y, z, 1.0]
        };
        harness.compare(tally, &control[0][0], &cases, expect, |session| {
            session.float_target()?;
            let vertex = "void main() {
                gl_Position = gl_ProjectionMatrix * vec4(0.0, 0.0, 0.0, 1.0);
                gl_TexCoord[0] = vec4(gl_Normal, 1.0); }";
            let fragment = "void main() { gl_FragColor = gl_TexCoord[0]; }";
            session.stages(&crate::probe::Stages { vertex, geometry: "", fragment })?;
            let numbers: Vec<f32> =
                control.iter().flatten().flat_map(|[x, y, z, _]| [*x, *y, *z]).collect();
            glMap2f(GL_MAP2_VERTEX_3, 0, 1, 12, 4, 0, 1, 3, 4, &numbers);
            glEnable(GL_MAP2_VERTEX_3);
            glEnable(GL_AUTO_NORMAL);
            session.points(cases.len(), |k| glEvalCoord2f(cases[k][0], cases[k][1]))
        })?;
    }
    Ok(())
}

fn grids(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("evaluator-grid");
    for round in 0..harness.cases(16).max(4) {
        let (control, u, v) = (net(&mut rng, [4, 3]), domain(&mut rng), domain(&mut rng));
        // The grid's own ends, within the domain.
        let ends = [u, v]
            .map(|[low, high]| [low + 0.1 * (high - low), low + rng.real(0.6, 0.9) * (high - low)]);
        // The least grid has one step.
        let counts = match round {
            0 => [1; 2],
            _ => [rng.integer(1, 19) as usize, rng.integer(1, 19) as usize],
        };
        let cases: Vec<[usize; 2]> =
            (0..=counts[0]).flat_map(|i| (0..=counts[1]).map(move |j| [i, j])).collect();
        let expect = |case: &[usize; 2], variant: Variant| {
            let at = |k: usize, domain: [f32; 2]| {
                let value = grid(ends[k].map(f64::from), counts[k], case[k], variant);
                parameter(domain.map(f64::from), value, variant)
            };
            surface(&exact_net(&control), [at(0, u), at(1, v)], variant)
        };
        harness.compare(tally, &(counts, ends), &cases, expect, |session| {
            session.float_target()?;
            session.show_coordinates()?;
            map_net(GL_MAP2_TEXTURE_COORD_4, &control, u, v);
            let [[u1, u2], [v1, v2]] = ends;
            glMapGrid2f(counts[0], u1, u2, counts[1], v1, v2);
            session.points(cases.len(), |k| glEvalPoint2(cases[k][0] as i32, cases[k][1] as i32))
        })?;
    }
    Ok(())
}
