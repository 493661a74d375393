//! Coverage: which pixels a triangle draws, and that a mesh draws each pixel once.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::coverage::{Point, UNITS, covers};
use crate::probe::{ProbeError, SIZE};
use crate::rng::Rng;

/// Coverage of single triangles.
pub const COVERAGE: Check = Check {
    name: "coverage",
    citation: "GL 2.1, 3.5.1; top-left rule (window, y up)",
    what: "pixels of random triangles, slivers and triangles with corners on pixel centres",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not; positions are exact at 4 bits of subpixel precision",
    run: coverage,
};

/// Triangles that share edges.
pub const SHARED_EDGES: Check = Check {
    name: "shared-edges",
    citation: "GL 2.1, 3.5.1: one of two polygons that share an edge",
    what: "times that each pixel of a triangulated square is drawn, under additive blending",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "each pixel is drawn once",
    run: shared_edges,
};

const LAST: i64 = SIZE as i64 * UNITS;

fn coverage(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("coverage");
    for round in 0..harness.cases(128) {
        let grid = [1, UNITS / 2, UNITS][round % 3];
        let mut corner = || {
            [0; 2].map(|_: i32| {
                let on_centre = if grid == UNITS { UNITS / 2 } else { 0 };
                (rng.integer(0, LAST / grid - 1) * grid + on_centre).min(LAST)
            })
        };
        let mut triangle = [corner(), corner(), corner()];
        if round % 7 == 0 {
            // A sliver: the third corner beside the first.
            triangle[2] = [triangle[0][0], (triangle[0][1] + UNITS + 1).min(LAST)];
        }
        count(harness, tally, &[triangle])?;
    }
    Ok(())
}

fn shared_edges(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("shared-edges");
    for round in 0..harness.cases(48) {
        let mesh = if round % 2 == 0 { grid(&mut rng) } else { fan(&mut rng) };
        count(harness, tally, &mesh)?;
    }
    Ok(())
}

/// How often each pixel is drawn.
fn count(harness: &Harness, tally: &mut Tally, mesh: &[[Point; 3]]) -> Result<(), ProbeError> {
    let pixels: Vec<[usize; 2]> = (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| [x, y])).collect();
    let expect = |&pixel: &[usize; 2], variant: Variant| {
        let times = mesh.iter().filter(|&&triangle| covers(triangle, pixel, variant)).count();
        [times as f64, 0.0, 0.0, 0.0]
    };
    let scene: &[[Point; 3]] = if mesh.len() == 1 { mesh } else { &mesh[..2] };
    harness.compare(tally, &scene, &pixels, expect, |session| {
        let to_ndc = |c: i64| (2.0 * c as f64 / LAST as f64 - 1.0) as f32;
        let corners: Vec<[f32; 2]> =
            mesh.iter().flatten().map(|corner| corner.map(to_ndc)).collect();
        session.overdraw(&corners)
    })
}

/// A square of cells with moved corners, each cut along a diagonal. Every other row of corners
/// lies on pixel centres.
fn grid(rng: &mut Rng) -> Vec<[Point; 3]> {
    const CELLS: i64 = 8;
    let step = LAST / CELLS;
    // With less than a quarter of a cell every cell stays convex.
    let reach = step / 5;
    let corners: Vec<Point> = (0..=CELLS)
        .flat_map(|j| (0..=CELLS).map(move |i| (i, j)))
        .map(|(i, j)| {
            let mut place = |n: i64| match n {
                0 | CELLS => n * step,
                _ if j % 2 == 0 => n * step + rng.integer(-2, 2) * UNITS + UNITS / 2,
                _ => n * step + rng.integer(-reach, reach),
            };
            [place(i), place(j)]
        })
        .collect();
    let at = |i: i64, j: i64| corners[(j * (CELLS + 1) + i) as usize];
    let cells = (0..CELLS).flat_map(|j| (0..CELLS).map(move |i| (i, j)));
    cells
        .flat_map(|(i, j)| {
            let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            if (i + j) % 2 == 0 { [[a, b, c], [c, d, a]] } else { [[a, b, d], [d, b, c]] }
        })
        .collect()
}

/// The picture's outline, cut in many short edges, seen from a point within: edges at every angle
/// that meet in one point.
fn fan(rng: &mut Rng) -> Vec<[Point; 3]> {
    let centre = [0; 2].map(|_: i32| rng.integer(LAST / 4, 3 * LAST / 4));
    let step = LAST / 16;
    let along = |k: i64| k * step;
    let mut outline: Vec<Point> = Vec::new();
    outline.extend((0..16).map(|k| [along(k), 0]));
    outline.extend((0..16).map(|k| [LAST, along(k)]));
    outline.extend((0..16).map(|k| [LAST - along(k), LAST]));
    outline.extend((0..16).map(|k| [0, LAST - along(k)]));
    (0..outline.len()).map(|k| [centre, outline[k], outline[(k + 1) % outline.len()]]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_meshes_cover_every_pixel_once() {
        let mut rng = Rng::named("test");
        for mesh in [grid(&mut rng), fan(&mut rng)] {
            for y in 0..SIZE {
                for x in 0..SIZE {
                    let times =
                        mesh.iter().filter(|t| covers(**t, [x, y], Variant::CORRECT)).count();
                    assert_eq!(times, 1, "({x}, {y})");
                }
            }
        }
    }
}
