//! Matrices that GL and GLU make (section 2.11.2), and window coordinates (2.11.1).

use super::matrix::{Matrix, apply};
use crate::mutation::{Mutation, Variant};

/// The unit matrix.
pub const IDENTITY: Matrix =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// `a · b`.
pub fn product(a: &Matrix, b: &Matrix) -> Matrix {
    [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// `glRotate`: `uuᵀ + cos θ (I − uuᵀ) + sin θ S`, about an axis of any length, in degrees.
pub fn rotation(degrees: f64, axis: [f64; 3], variant: Variant) -> Matrix {
    let length = if variant.has(Mutation::AxisNotNormalized) {
        1.0
    } else {
        axis.iter().map(|c| c * c).sum::<f64>().sqrt()
    };
    let u = axis.map(|c| c / length);
    let turned = if variant.has(Mutation::RotationReversed) { -degrees } else { degrees };
    let (sin, cos) = turned.to_radians().sin_cos();
    let s = [[0.0, -u[2], u[1]], [u[2], 0.0, -u[0]], [-u[1], u[0], 0.0]];
    let mut m = IDENTITY;
    for i in 0..3 {
        for j in 0..3 {
            let outer = u[i] * u[j];
            m[i][j] = outer + cos * (IDENTITY[i][j] - outer) + sin * s[i][j];
        }
    }
    m
}

/// `glTranslate`.
pub fn translation(by: [f64; 3]) -> Matrix {
    let mut m = IDENTITY;
    for i in 0..3 {
        m[i][3] = by[i];
    }
    m
}

/// `glScale`.
pub fn scaling(by: [f64; 3]) -> Matrix {
    let mut m = IDENTITY;
    for i in 0..3 {
        m[i][i] = by[i];
    }
    m
}

/// `glFrustum` of left, right, bottom, top, near, far.
pub fn frustum([l, r, b, t, n, f]: [f64; 6], variant: Variant) -> Matrix {
    let centred = if variant.has(Mutation::AlwaysCentred) { 0.0 } else { 1.0 };
    [
        [2.0 * n / (r - l), 0.0, centred * (r + l) / (r - l), 0.0],
        [0.0, 2.0 * n / (t - b), centred * (t + b) / (t - b), 0.0],
        [0.0, 0.0, -(f + n) / (f - n), -2.0 * f * n / (f - n)],
        [0.0, 0.0, -1.0, 0.0],
    ]
}

/// `glOrtho` of left, right, bottom, top, near, far.
pub fn ortho([l, r, b, t, n, f]: [f64; 6], variant: Variant) -> Matrix {
    let centred = if variant.has(Mutation::AlwaysCentred) { 0.0 } else { 1.0 };
    [
        [2.0 / (r - l), 0.0, 0.0, -centred * (r + l) / (r - l)],
        [0.0, 2.0 / (t - b), 0.0, -centred * (t + b) / (t - b)],
        [0.0, 0.0, -2.0 / (f - n), -(f + n) / (f - n)],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

/// `gluPerspective`: the angle from bottom to top, in degrees.
pub fn perspective([fovy, aspect, near, far]: [f64; 4], variant: Variant) -> Matrix {
    let half = if variant.has(Mutation::FieldOfViewIsHalf) { fovy } else { fovy / 2.0 };
    let top = near * half.to_radians().tan();
    frustum([-top * aspect, top * aspect, -top, top, near, far], Variant::CORRECT)
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / length)
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// `gluLookAt` of eye, centre and up.
pub fn look_at([eye, centre, up]: [[f64; 3]; 3], variant: Variant) -> Matrix {
    let f = unit([0, 1, 2].map(|i| centre[i] - eye[i]));
    let s = unit(cross(f, up));
    let u = if variant.has(Mutation::UpNotOrthogonal) { unit(up) } else { cross(s, f) };
    let m =
        [[s[0], s[1], s[2], 0.0], [u[0], u[1], u[2], 0.0], [-f[0], -f[1], -f[2], 0.0], IDENTITY[3]];
    product(&m, &translation(eye.map(|c| -c)))
}

/// A viewport: lower left, size, and depths of the near and the far plane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "GL's names")]
pub struct Viewport {
    pub low: [f64; 2],
    pub size: [f64; 2],
    pub depth: [f64; 2],
}

impl Viewport {
    /// Window coordinates of clip coordinates, and clip w.
    pub fn window(&self, clip: [f64; 4], variant: Variant) -> [f64; 4] {
        let [x, y, z] = [0, 1, 2].map(|i| clip[i] / clip[3]);
        let origin = |i: usize| {
            if variant.has(Mutation::ViewportOriginIgnored) { 0.0 } else { self.low[i] }
        };
        let [near, far] = self.depth;
        [
            self.size[0] / 2.0 * x + self.size[0] / 2.0 + origin(0),
            self.size[1] / 2.0 * y + self.size[1] / 2.0 + origin(1),
            (far - near) / 2.0 * z + f64::midpoint(far, near),
            clip[3],
        ]
    }
}

/// Whether clip coordinates are in the view volume; `None` close to its sides.
pub fn in_volume(clip: [f64; 4]) -> Option<bool> {
    let least = (0..3).map(|i| clip[3] - clip[i].abs()).fold(f64::INFINITY, f64::min);
    (least.abs() > 1e-4).then_some(least > 0.0)
}

/// Clip coordinates through two matrices.
pub fn clip(projection: &Matrix, model_view: &Matrix, object: [f64; 4]) -> [f64; 4] {
    apply(projection, apply(model_view, object))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn a_quarter_turn_about_z() {
        let turned = apply(&rotation(90.0, [0.0, 0.0, 5.0], TRUE), [1.0, 0.0, 0.0, 1.0]);
        assert!((turned[0].abs() + (turned[1] - 1.0).abs()) < 1e-15);
    }

    #[test]
    fn corners_of_the_frustum_are_corners_of_the_cube() {
        let m = frustum([1.0, 2.0, -1.0, 3.0, 1.0, 10.0], TRUE);
        let corner = apply(&m, [20.0, 30.0, -10.0, 1.0]);
        assert!(corner.iter().all(|c| (c - 10.0).abs() < 1e-12), "{corner:?}");
        let m = ortho([1.0, 2.0, -1.0, 3.0, 1.0, 10.0], TRUE);
        assert_eq!(apply(&m, [1.0, -1.0, -1.0, 1.0]), [-1.0, -1.0, -1.0, 1.0]);
    }

    #[test]
    fn the_eye_is_the_origin_and_the_centre_is_ahead() {
        let m = look_at([[1.0, 2.0, 3.0], [1.0, 2.0, -4.0], [0.0, 1.0, 1.0]], TRUE);
        assert_eq!(apply(&m, [1.0, 2.0, 3.0, 1.0]), [0.0, 0.0, 0.0, 1.0]);
        assert_eq!(apply(&m, [1.0, 2.0, -4.0, 1.0]), [0.0, 0.0, -7.0, 1.0]);
    }

    #[test]
    fn the_middle_of_the_window() {
        let of = Viewport { low: [10.0, 20.0], size: [31.0, 40.0], depth: [1.0, 0.5] };
        assert_eq!(of.window([0.0, 2.0, -2.0, 2.0], TRUE), [25.5, 60.0, 1.0, 2.0]);
    }
}
