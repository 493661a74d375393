//! Interpolation over meshes: many triangles in one draw, small and large, whose planes are computed together.

use super::pictures::{Pictures, Pixel};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Values over meshes.
pub const MESH: Check = Check {
    name: "mesh-interpolation",
    citation: "GL 2.1, 3.5.1: f = Σ a·fa/wa / Σ a/wa, of each triangle of a mesh",
    what: "every pixel of meshes of cells of 1/16 to 24 pixels whose values are those of one plane, in parallel and in perspective",
    unit: Unit::FullScale,
    tolerance: 6.0 / (1 << 24) as f64,
    why: "f32: coordinates, w and value of a corner are off by 2^-25 each, f/w and 1/w by as much, then one division",
    run: |harness, tally| run(harness, tally, Shown::Values),
};

/// Depths over meshes.
pub const DEPTH: Check = Check {
    name: "mesh-depth",
    citation: "GL 2.1, 3.5.1: depth is linear in the window; 2.11.1",
    what: "every pixel's depth of such meshes, in parallel and in perspective, as floats",
    unit: Unit::FullScale,
    tolerance: 3.0 / (1 << 24) as f64,
    why: "f32: z and w of a corner are off by 2^-25 each, which z/w doubles, and the depth is rounded",
    run: |harness, tally| run(harness, tally, Shown::Depths),
};

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shown {
    Values,
    Depths,
}

/// Columns and rows of a cell, in pixels. The flat ones are thinner than an eighth of a pixel: their triangles have
/// interpolation of their own. All corners are exact in 1/256 pixels.
const CELLS: [[f64; 2]; 8] = [
    [1.0, 1.0],
    [2.0, 2.0],
    [3.0, 3.0],
    [8.0, 0.0625],
    [8.0, 8.0],
    [12.0, 12.0],
    [0.0625, 9.0],
    [24.0, 24.0],
];

const PICTURE: Pixel = [96, 72];

/// A linear function of the window.
#[derive(Clone, Copy, Debug)]
struct Linear([f64; 3]);

impl Linear {
    /// Of these values at three corners of the picture: lower left, lower right, upper left.
    fn of([a, b, c]: [f64; 3]) -> Self {
        Self([a, (b - a) / PICTURE[0] as f64, (c - a) / PICTURE[1] as f64])
    }

    fn at(&self, [x, y]: [f64; 2]) -> f64 {
        self.0[0] + self.0[1] * x + self.0[2] * y
    }
}

/// How vertices are given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Given {
    Quads,
    Strips,
    Arrays,
}

fn run(harness: &Harness, tally: &mut Tally, shown: Shown) -> Result<(), ProbeError> {
    let mut rng = Rng::named("mesh-interpolation");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(48).max(24) {
        let cell = CELLS[round % CELLS.len()];
        let given = [Given::Quads, Given::Strips, Given::Arrays][round / 2 % 3];
        let perspective = round % 4 < 2;
        // 1/w, and a value over w, are linear in the window.
        let mut corners = |low: f64, high: f64| [0; 3].map(|_: i32| f64::from(rng.real(low, high)));
        let inverse = Linear::of(if perspective { corners(0.4, 0.7) } else { [1.0; 3] });
        let over = [Linear::of(corners(0.1, 0.3)), Linear::of(corners(0.1, 0.3))];
        let depth = Linear::of(corners(0.4, 0.6));
        let value = |at: [f64; 2]| over.map(|over| over.at(at) / inverse.at(at));
        let expect = |[x, y]: Pixel, variant: Variant| {
            let at = [x as f64 + 0.5, y as f64 + 0.5];
            // The mistake: as if all w of a square were those of its lower left corner.
            let flat = [0, 1].map(|i| (at[i] / cell[i]).floor() * cell[i]);
            Some(match (shown, variant.has(Mutation::AffineWithinTriangles)) {
                (Shown::Values, false) => {
                    let [s, t] = value(at);
                    [s, t, 0.0, 1.0]
                }
                (Shown::Values, true) => {
                    let [s, t] = over.map(|over| over.at(at) / inverse.at(flat));
                    [s, t, 0.0, 1.0]
                }
                (Shown::Depths, _) => {
                    let z = depth.at(at);
                    let range = variant.has(Mutation::DepthRangeIgnored);
                    [if range { 2.0 * z - 1.0 } else { z }, 0.0, 0.0, 0.0]
                }
            })
        };
        pictures.compare(&(cell, given, inverse, over, depth), expect, |session| {
            session.deep_frame(GL_RGBA32F, GL_DEPTH_COMPONENT32F, PICTURE, 0)?;
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_ALWAYS);
            session.show_coordinates()?;
            let vertex = |corner: [usize; 2]| {
                let at = [0, 1].map(|i| corner[i] as f64 * cell[i]);
                let w = 1.0 / inverse.at(at);
                let [x, y] = [0, 1].map(|i| (2.0 * at[i] / PICTURE[i] as f64 - 1.0) * w);
                (value(at), [x, y, (2.0 * depth.at(at) - 1.0) * w, w])
            };
            draw(given, [0, 1].map(|i| (PICTURE[i] as f64 / cell[i]).ceil() as usize), vertex);
            match shown {
                Shown::Values => session.read_floats(PICTURE),
                Shown::Depths => session.read_depths(PICTURE),
            }
        })?;
    }
    pictures.finish(100, 100);
    Ok(())
}

/// Draws so many cells; a vertex is given by its column and row.
fn draw(given: Given, cells: [usize; 2], vertex: impl Fn([usize; 2]) -> ([f64; 2], [f64; 4])) {
    let emit = |corner: [usize; 2]| {
        let ([s, t], [x, y, z, w]) = vertex(corner);
        glTexCoord2d(s, t);
        glVertex4d(x, y, z, w);
    };
    let (columns, rows) = (|| 0..cells[0], || 0..cells[1]);
    match given {
        Given::Quads => {
            glBegin(GL_QUADS);
            for (y, x) in rows().flat_map(|y| columns().map(move |x| (y, x))) {
                for corner in [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]] {
                    emit(corner);
                }
            }
            glEnd();
        }
        Given::Strips => {
            for y in rows() {
                glBegin(GL_TRIANGLE_STRIP);
                for x in 0..=cells[0] {
                    emit([x, y + 1]);
                    emit([x, y]);
                }
                glEnd();
            }
        }
        Given::Arrays => {
            let (mut coordinates, mut positions) = (Vec::new(), Vec::new());
            for (y, x) in rows().flat_map(|y| columns().map(move |x| (y, x))) {
                let [a, b] = [[x, y], [x + 1, y]];
                let [c, d] = [[x + 1, y + 1], [x, y + 1]];
                for corner in [a, b, c, a, c, d] {
                    let (coordinate, position) = vertex(corner);
                    coordinates.push(coordinate.map(|v| v as f32));
                    positions.push(position.map(|v| v as f32));
                }
            }
            glEnableClientState(GL_VERTEX_ARRAY);
            glEnableClientState(GL_TEXTURE_COORD_ARRAY);
            glVertexPointer(4, GL_FLOAT, 0, positions.as_flattened());
            glTexCoordPointer(2, GL_FLOAT, 0, coordinates.as_flattened());
            glDrawArrays(GL_TRIANGLES, 0, positions.len());
        }
    }
}
