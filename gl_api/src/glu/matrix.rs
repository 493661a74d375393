//! GLU's viewing and projection matrices, in `f64`, multiplied onto the current matrix.

use crate::base::angle::cotangent_degrees;
use crate::entry::{Arg, glMultMatrixd, glOrtho, glTranslated};
use texunit::lanes::FloatEnv;

/// A 4×4 matrix as GL takes it: column by column.
type Columns = [f64; 16];

/// Multiplies a perspective projection onto the current matrix: `fovy` degrees high, `aspect`
/// times as wide, from `z_near` to `z_far` in front of the eye. As in GLU, a field of view,
/// aspect or depth range of nothing leaves the matrix as it is.
pub fn gluPerspective(
    fovy: impl Arg<f64>,
    aspect: impl Arg<f64>,
    z_near: impl Arg<f64>,
    z_far: impl Arg<f64>,
) {
    let _float_env = FloatEnv::enter();
    if let Some(matrix) = perspective(fovy.arg(), aspect.arg(), z_near.arg(), z_far.arg()) {
        glMultMatrixd(&matrix);
    }
}

/// Multiplies a view onto the current matrix: from `eye` toward `center`, with `up` upward.
#[expect(clippy::too_many_arguments, reason = "GLU's signature")]
pub fn gluLookAt(
    eye_x: impl Arg<f64>,
    eye_y: impl Arg<f64>,
    eye_z: impl Arg<f64>,
    center_x: impl Arg<f64>,
    center_y: impl Arg<f64>,
    center_z: impl Arg<f64>,
    up_x: impl Arg<f64>,
    up_y: impl Arg<f64>,
    up_z: impl Arg<f64>,
) {
    let _float_env = FloatEnv::enter();
    let eye = [eye_x.arg(), eye_y.arg(), eye_z.arg()];
    let center = [center_x.arg(), center_y.arg(), center_z.arg()];
    let up = [up_x.arg(), up_y.arg(), up_z.arg()];
    glMultMatrixd(&look_toward(subtract(center, eye), up));
    glTranslated(-eye[0], -eye[1], -eye[2]);
}

/// Multiplies a parallel projection with depths from -1 to 1 onto the current matrix.
pub fn gluOrtho2D(
    left: impl Arg<f64>,
    right: impl Arg<f64>,
    bottom: impl Arg<f64>,
    top: impl Arg<f64>,
) {
    let _float_env = FloatEnv::enter();
    glOrtho(left.arg(), right.arg(), bottom.arg(), top.arg(), -1.0, 1.0);
}

/// GLU 1.3's `gluPerspective`: `None` where its formula divides by zero.
fn perspective(fovy: f64, aspect: f64, near: f64, far: f64) -> Option<Columns> {
    let f = cotangent_degrees(fovy / 2.0);
    let depth = near - far;
    if !f.is_finite() || aspect == 0.0 || depth == 0.0 {
        return None;
    }
    let mut m = [0.0; 16];
    m[0] = f / aspect;
    m[5] = f;
    m[10] = (far + near) / depth;
    m[11] = -1.0;
    m[14] = 2.0 * far * near / depth;
    Some(m)
}

/// The rotation of GLU 1.3's `gluLookAt`: rows are the side, the up and the backward direction.
fn look_toward(forward: [f64; 3], up: [f64; 3]) -> Columns {
    let forward = normalize(forward);
    let side = normalize(cross(forward, up));
    let up = cross(side, forward);
    let mut m = [0.0; 16];
    for axis in 0..3 {
        m[axis * 4] = side[axis];
        m[axis * 4 + 1] = up[axis];
        m[axis * 4 + 2] = -forward[axis];
    }
    m[15] = 1.0;
    m
}

fn subtract(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// A direction of length 1; nothing stays nothing, as in libGLU.
fn normalize(v: [f64; 3]) -> [f64; 3] {
    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    if length == 0.0 { v } else { v.map(|x| x / length) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn transform(m: &Columns, p: [f64; 4]) -> [f64; 4] {
        std::array::from_fn(|row| (0..4).map(|column| m[column * 4 + row] * p[column]).sum())
    }

    #[test]
    fn perspective_sends_the_frustum_to_the_cube() {
        let m = perspective(90.0, 2.0, 1.0, 9.0).unwrap();
        for (eye, cube) in [
            ([2.0, 1.0, -1.0, 1.0], [1.0, 1.0, -1.0]),
            ([-18.0, 9.0, -9.0, 1.0], [-1.0, 1.0, 1.0]),
            ([0.0, 0.0, -1.8, 1.0], [0.0, 0.0, 0.0]),
        ] {
            let clip = transform(&m, eye);
            for axis in 0..3 {
                assert!((clip[axis] / clip[3] - cube[axis]).abs() < 1e-15, "{eye:?} {clip:?}");
            }
        }
    }

    #[test]
    fn degenerate_perspectives_do_nothing() {
        for (fovy, aspect, near, far) in [
            (0.0, 1.0, 1.0, 2.0),
            (360.0, 1.0, 1.0, 2.0),
            (60.0, 0.0, 1.0, 2.0),
            (60.0, 1.0, 2.0, 2.0),
            (f64::NAN, 1.0, 1.0, 2.0),
        ] {
            assert_eq!(perspective(fovy, aspect, near, far), None);
        }
    }

    #[test]
    fn looking_sends_the_center_straight_ahead_and_keeps_lengths() {
        let m = look_toward([3.0, -4.0, 12.0], [0.0, 1.0, 0.0]);
        let ahead = transform(&m, [3.0, -4.0, 12.0, 0.0]);
        let expected = [0.0, 0.0, -13.0, 0.0];
        assert!(ahead.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{ahead:?}");
        let up = transform(&m, [0.0, 1.0, 0.0, 0.0]);
        assert!(up[0].abs() < 1e-15 && up[1] > 0.0, "{up:?}");
    }
}
