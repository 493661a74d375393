//! Meshes of evaluators: which vertices `glEvalMesh` joins to which primitives, in feedback.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::bernstein::{curve, grid, parameter, surface};
use crate::probe::{ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;
use gl_api::types::GLenum;

/// Points, lines and quads.
pub const MESH: Check = Check {
    name: "evaluator-mesh",
    citation: "GL 2.1, 5.1: glEvalMesh1 and glEvalMesh2, in the words of their pseudo-code; 5.3: GL_FEEDBACK",
    what: "window coordinates of every vertex of every primitive of meshes of points, lines and quads, over parts of random grids",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 18) as f64,
    why: "f32 coordinates up to 1 off by 2^-24 on the way, times 32 pixels: 2^-19; the grid's and the map's parameter as much",
    run,
};

/// Side of the viewport.
const SIDE: usize = 64;

/// Steps of a parameter, by number of the grid's points.
type Steps = [usize; 2];

/// What is drawn: a curve over u, or a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mesh {
    Curve(Steps),
    Surface([Steps; 2]),
}

fn between([first, last]: Steps) -> std::ops::RangeInclusive<usize> {
    first..=last
}

/// The primitives, in their order: the numbers of the grid's points, of u and v, of their vertices.
fn primitives(mesh: Mesh, mode: GLenum) -> Vec<Vec<[usize; 2]>> {
    let strip = |points: Vec<[usize; 2]>| -> Vec<Vec<[usize; 2]>> {
        points.windows(2).map(<[_]>::to_vec).collect()
    };
    match (mesh, mode) {
        (Mesh::Curve(u), GL_POINT) => between(u).map(|i| vec![[i, 0]]).collect(),
        (Mesh::Curve(u), _) => strip(between(u).map(|i| [i, 0]).collect()),
        (Mesh::Surface([u, v]), GL_POINT) => {
            between(v).flat_map(|j| between(u).map(move |i| vec![[i, j]])).collect()
        }
        (Mesh::Surface([u, v]), GL_LINE) => {
            let along = between(v).flat_map(|j| strip(between(u).map(|i| [i, j]).collect()));
            let up = between(u).flat_map(|i| strip(between(v).map(|j| [i, j]).collect()));
            along.chain(up).collect()
        }
        // A strip of quads for each row: vertices (i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j) of each.
        (Mesh::Surface([u, v]), _) => (v[0]..v[1])
            .flat_map(|j| {
                (u[0]..u[1]).map(move |i| vec![[i, j], [i, j + 1], [i + 1, j + 1], [i + 1, j]])
            })
            .collect(),
    }
}

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("evaluator-mesh");
    for round in 0..harness.cases(40).max(10) {
        // The least grid has one step.
        let counts = match round {
            0..5 => [1; 2],
            _ => [rng.integer(1, 7) as usize, rng.integer(1, 7) as usize],
        };
        let mut steps = |count: usize| {
            let first = rng.integer(0, count as i64 - 1) as usize;
            [first, rng.integer(first as i64 + 1, count as i64) as usize]
        };
        let parts = [steps(counts[0]), steps(counts[1])];
        let (mesh, mode) = [
            (Mesh::Curve(parts[0]), GL_POINT),
            (Mesh::Curve(parts[0]), GL_LINE),
            (Mesh::Surface(parts), GL_POINT),
            (Mesh::Surface(parts), GL_LINE),
            (Mesh::Surface(parts), GL_FILL),
        ][round % 5];
        // Within the view volume, about a flat net, so that quads have an area.
        let control: Vec<Vec<[f32; 4]>> = (0..3)
            .map(|i| {
                let row = (0..4).map(|j| {
                    let [x, y] = [i as f32 * 0.5 - 0.5, j as f32 * 0.4 - 0.6];
                    [x + rng.real(-0.1, 0.1), y + rng.real(-0.1, 0.1), rng.real(-0.5, 0.5), 1.0]
                });
                row.collect()
            })
            .collect();
        let exact: Vec<Vec<[f64; 4]>> =
            control.iter().map(|row| row.iter().map(|p| p.map(f64::from)).collect()).collect();
        let ends =
            [[rng.real(0.0, 0.3), rng.real(0.6, 1.0)], [rng.real(0.0, 0.3), rng.real(0.6, 1.0)]];
        let all = primitives(mesh, mode);
        let cases: Vec<[usize; 2]> = all.iter().flatten().copied().collect();
        let expect = |case: &[usize; 2], variant: Variant| {
            let at = |k: usize| {
                let value = grid(ends[k].map(f64::from), counts[k], case[k], variant);
                parameter([0.0, 1.0], value, Variant::CORRECT)
            };
            let [x, y, ..] = match mesh {
                Mesh::Curve(_) => {
                    let line: Vec<[f64; 4]> = exact.iter().map(|row| row[0]).collect();
                    curve(&line, at(0), variant)
                }
                Mesh::Surface(_) => surface(&exact, [at(0), at(1)], variant),
            };
            let [x, y] = [x, y].map(|c| (c + 1.0) * 0.5 * SIDE as f64);
            [x, y, 0.0, 0.0]
        };
        let vertices = all.first().map_or(0, Vec::len);
        harness.compare(tally, &(mesh, enum_name(mode), counts), &cases, expect, |session| {
            glViewport(0, 0, SIDE, SIDE);
            let numbers: Vec<f32> =
                control.iter().flatten().flat_map(|[x, y, z, _]| [*x, *y, *z]).collect();
            let [[u1, u2], [v1, v2]] = ends;
            glFeedbackBuffer(1 << 12, GL_2D, NULL);
            glRenderMode(GL_FEEDBACK);
            match mesh {
                Mesh::Curve([first, last]) => {
                    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 12, 3, &numbers);
                    glEnable(GL_MAP1_VERTEX_3);
                    glMapGrid1f(counts[0], u1, u2);
                    glEvalMesh1(mode, first as i32, last as i32);
                }
                Mesh::Surface([u, v]) => {
                    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 12, 3, 0, 1, 3, 4, &numbers);
                    glEnable(GL_MAP2_VERTEX_3);
                    glMapGrid2f(counts[0], u1, u2, counts[1], v1, v2);
                    let [[u1, u2], [v1, v2]] = [u, v].map(|part| part.map(|n| n as i32));
                    glEvalMesh2(mode, u1, u2, v1, v2);
                }
            }
            found(session, mode, vertices)
        })?;
    }
    Ok(())
}

/// The vertices of the primitives in the feedback buffer, each of so many.
fn found(session: &Session, mode: GLenum, vertices: usize) -> Result<Vec<[f64; 4]>, ProbeError> {
    let count = glRenderMode(GL_RENDER);
    session.check("reading feedback")?;
    let buffer = feedback();
    let words = buffer.get(..count.max(0) as usize).unwrap_or_default();
    // A token, of a polygon the number of its vertices, and two coordinates of each vertex.
    let head = if mode == GL_FILL { 2 } else { 1 };
    let records = words.chunks_exact(head + 2 * vertices);
    let points = records.flat_map(|record| record[head..].chunks_exact(2));
    Ok(points.map(|point| [point[0].into(), point[1].into(), 0.0, 0.0]).collect())
}
