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
    what: "every pixel of meshes of squares of 1 to 24 pixels whose values are those of one plane, in parallel and in perspective",
    unit: Unit::FullScale,
    tolerance: 6.0 / (1 << 24) as f64,
    why: "f32: coordinates, w and value of a corner are off by 2^-25 each, f/w and 1/w by as much, then one division",
    run,
};

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

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("mesh-interpolation");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(48).max(18) {
        let side: usize = [1, 2, 3, 8, 12, 24][round % 6];
        let given = [Given::Quads, Given::Strips, Given::Arrays][round / 2 % 3];
        let perspective = round % 4 < 2;
        // 1/w, and a value over w, are linear in the window.
        let mut corners = |low: f64, high: f64| [0; 3].map(|_: i32| f64::from(rng.real(low, high)));
        let inverse = Linear::of(if perspective { corners(0.4, 0.7) } else { [1.0; 3] });
        let over = [Linear::of(corners(0.1, 0.3)), Linear::of(corners(0.1, 0.3))];
        let value = |at: [f64; 2]| over.map(|over| over.at(at) / inverse.at(at));
        let expect = |[x, y]: Pixel, variant: Variant| {
            let at = [x as f64 + 0.5, y as f64 + 0.5];
            // The mistake: as if all w of a square were those of its lower left corner.
            let flat = at.map(|v| (v / side as f64).floor() * side as f64);
            let [s, t] = match variant.has(Mutation::AffineWithinTriangles) {
                true => over.map(|over| over.at(at) / inverse.at(flat)),
                false => value(at),
            };
            Some([s, t, 0.0, 1.0])
        };
        pictures.compare(&(side, given, inverse, over), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            session.show_coordinates()?;
            let vertex = |[x, y]: [usize; 2]| {
                let at = [x as f64, y as f64];
                let w = 1.0 / inverse.at(at);
                let [x, y] = [0, 1].map(|i| (2.0 * at[i] / PICTURE[i] as f64 - 1.0) * w);
                (value(at), [x, y, 0.0, w])
            };
            draw(given, side, vertex);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 100);
    Ok(())
}

fn draw(given: Given, side: usize, vertex: impl Fn([usize; 2]) -> ([f64; 2], [f64; 4])) {
    let emit = |corner: [usize; 2]| {
        let ([s, t], [x, y, z, w]) = vertex(corner);
        glTexCoord2d(s, t);
        glVertex4d(x, y, z, w);
    };
    let rows = || (0..PICTURE[1]).step_by(side);
    let columns = || (0..PICTURE[0]).step_by(side);
    match given {
        Given::Quads => {
            glBegin(GL_QUADS);
            for (y, x) in rows().flat_map(|y| columns().map(move |x| (y, x))) {
                for corner in [[x, y], [x + side, y], [x + side, y + side], [x, y + side]] {
                    emit(corner);
                }
            }
            glEnd();
        }
        Given::Strips => {
            for y in rows() {
                glBegin(GL_TRIANGLE_STRIP);
                for x in columns().chain([PICTURE[0]]) {
                    emit([x, y + side]);
                    emit([x, y]);
                }
                glEnd();
            }
        }
        Given::Arrays => {
            let (mut coordinates, mut positions) = (Vec::new(), Vec::new());
            for (y, x) in rows().flat_map(|y| columns().map(move |x| (y, x))) {
                let [a, b] = [[x, y], [x + side, y]];
                let [c, d] = [[x + side, y + side], [x, y + side]];
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
