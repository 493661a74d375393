//! Bicubic patches, and the teapot that Martin Newell made of them in 1975.

use crate::matrix::{DVec3, dvec3};
use gl_api::constants::*;
use gl_api::types::GLenum;
use gl_api::*;

/// The 16 control points of a patch, and the rectangle of texture coordinates that it has: s from, t from, s to,
/// t to. Points of a row follow u.
#[derive(Clone, Copy, Debug)]
pub struct Patch {
    /// Control points.
    pub points: [[DVec3; 4]; 4],
    /// Texture coordinates.
    pub texture: [f64; 4],
}

impl Patch {
    /// Over the square from -1.5 to 1.5 of x and z, with these heights and a whole texture.
    pub fn sheet(heights: [[f64; 4]; 4]) -> Self {
        let mut points = [[DVec3::ZERO; 4]; 4];
        for (row, of_row) in heights.into_iter().enumerate() {
            for (column, height) in of_row.into_iter().enumerate() {
                points[row][column] = dvec3(column as f64 - 1.5, height - 0.3, 1.5 - row as f64);
            }
        }
        Self { points, texture: [0.0, 0.0, 1.0, 1.0] }
    }

    /// Draws it with OpenGL's evaluators in `pieces` × `pieces` quadrilaterals, `GL_LINE` or `GL_FILL`.
    pub fn evaluate(&self, pieces: i32, mode: GLenum) {
        let points = self.points.map(|row| row.map(|point| point.as_vec3().to_array()));
        let [s0, t0, s1, t1] = self.texture.map(|c| c as f32);
        let corners: [[f32; 2]; 4] = [[s0, t0], [s1, t0], [s0, t1], [s1, t1]];
        glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 4, 0, 1, 12, 4, points.as_flattened().as_flattened());
        glMap2f(GL_MAP2_TEXTURE_COORD_2, 0, 1, 2, 2, 0, 1, 4, 2, corners.as_flattened());
        glMapGrid2f(pieces, 0, 1, pieces, 0, 1);
        glEvalMesh2(mode, 0, pieces, 0, pieces);
    }
}

/// Newell's quarter of a circle: where its inner control points are.
const QUARTER: f64 = 0.56;

/// Curves that are turned: radius and height, z upward.
const TURNED: [[[f64; 2]; 4]; 5] = [
    [[0.0, 3.15], [0.8, 3.15], [0.0, 2.7], [0.2, 2.55]],
    [[0.2, 2.55], [0.4, 2.4], [1.3, 2.4], [1.3, 2.4]],
    [[1.4, 2.4], [1.3375, 2.53125], [1.4375, 2.53125], [1.5, 2.4]],
    [[1.5, 2.4], [1.75, 1.875], [2.0, 1.35], [2.0, 0.9]],
    [[2.0, 0.9], [2.0, 0.45], [1.5, 0.225], [1.5, 0.15]],
];

/// A tube's cross-section: x and z of its upper side, of its lower side, half its width.
type Ring = [f64; 5];

const HANDLE: [[Ring; 4]; 2] = [
    [
        [-1.6, 2.025, -1.5, 2.25, 0.3],
        [-2.3, 2.025, -2.5, 2.25, 0.3],
        [-2.7, 2.025, -3.0, 2.25, 0.3],
        [-2.7, 1.8, -3.0, 1.8, 0.3],
    ],
    [
        [-2.7, 1.8, -3.0, 1.8, 0.3],
        [-2.7, 1.575, -3.0, 1.35, 0.3],
        [-2.5, 1.125, -2.65, 0.9375, 0.3],
        [-2.0, 0.9, -1.9, 0.6, 0.3],
    ],
];

const SPOUT: [[Ring; 4]; 2] = [
    [
        [1.7, 1.425, 1.7, 0.6, 0.66],
        [2.6, 1.425, 3.1, 0.825, 0.66],
        [2.3, 2.1, 2.4, 2.025, 0.25],
        [2.7, 2.4, 3.3, 2.4, 0.25],
    ],
    [
        [2.7, 2.4, 3.3, 2.4, 0.25],
        [2.8, 2.475, 3.525, 2.49375, 0.25],
        [2.9, 2.475, 3.45, 2.5125, 0.15],
        [2.8, 2.4, 3.2, 2.4, 0.15],
    ],
];

/// The patches of the teapot, y upward. The body's picture is twice around it.
pub fn teapot() -> Vec<Patch> {
    let mut patches = Vec::new();
    for (at, curve) in TURNED.iter().enumerate() {
        // From the lid's knob to the foot.
        let t = [1.0, 0.88, 0.76, 0.72, 0.3, 0.0];
        for quarter in 0..4 {
            let s = 0.5 * f64::from(quarter);
            patches.push(Patch {
                points: curve.map(|[radius, z]| quarter_of_circle(quarter, radius, z)),
                texture: [s, t[at], s + 0.5, t[at + 1]],
            });
        }
    }
    for ring in HANDLE.iter().chain(&SPOUT) {
        for side in [-1.0, 1.0] {
            let points = ring.map(|[x0, z0, x1, z1, half]| {
                let y = side * half;
                [[x0, 0.0, z0], [x0, y, z0], [x1, y, z1], [x1, 0.0, z1]].map(upright)
            });
            patches.push(Patch { points, texture: [0.0, 0.0, 0.5, 0.5] });
        }
    }
    patches
}

/// From z upward to y upward, the middle of the pot at the origin.
fn upright([x, y, z]: [f64; 3]) -> DVec3 {
    dvec3(x, z - 1.575, -y)
}

/// The control points of a quarter of a circle.
fn quarter_of_circle(quarter: i32, radius: f64, z: f64) -> [DVec3; 4] {
    let (near, k) = (radius, radius * QUARTER);
    [[near, 0.0], [near, k], [k, near], [0.0, near]].map(|[x, y]| {
        let (x, y) = match quarter {
            0 => (x, y),
            1 => (-y, x),
            2 => (-x, -y),
            _ => (y, -x),
        };
        upright([x, y, z])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarters_of_a_curve_meet() {
        for curve in teapot().chunks(4).take(TURNED.len()) {
            for at in 0..4 {
                let (end, begin) = (curve[at].points, curve[(at + 1) % 4].points);
                for row in 0..4 {
                    assert_eq!(end[row][3], begin[row][0]);
                }
            }
        }
    }

    #[test]
    fn it_has_thirty_two_patches_but_those_of_the_bottom() {
        assert_eq!(teapot().len(), 28);
    }
}
