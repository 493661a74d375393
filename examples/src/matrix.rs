//! Matrices in `f64`; shaders get them as 16 floats column by column.

use gl_api::glu::angle::{cotangent_degrees, sin_cos_degrees};
pub use glam::{DMat4, DVec3, dvec3};

/// `gluPerspective` as a matrix: `fovy` degrees high, `aspect` times as wide.
pub fn perspective(fovy: f64, aspect: f64, near: f64, far: f64) -> DMat4 {
    let f = cotangent_degrees(fovy / 2.0);
    let depth = near - far;
    #[rustfmt::skip]
    let matrix = DMat4::from_cols_array(&[
        f / aspect, 0.0, 0.0, 0.0,
        0.0, f, 0.0, 0.0,
        0.0, 0.0, (far + near) / depth, -1.0,
        0.0, 0.0, 2.0 * far * near / depth, 0.0,
    ]);
    matrix
}

/// `gluLookAt` as a matrix, with `y` upward.
pub fn look_at(eye: DVec3, center: DVec3) -> DMat4 {
    DMat4::look_at_rh(eye, center, DVec3::Y)
}

/// The view from the origin that draws a cube map's face, in GL's order (GL 2.1 table 3.19); with
/// `perspective(90, 1, ..)` the face is filled.
pub fn look_through_face(face: usize) -> DMat4 {
    let (toward, up) = match face {
        0 => (DVec3::X, DVec3::NEG_Y),
        1 => (DVec3::NEG_X, DVec3::NEG_Y),
        2 => (DVec3::Y, DVec3::Z),
        3 => (DVec3::NEG_Y, DVec3::NEG_Z),
        4 => (DVec3::Z, DVec3::NEG_Y),
        _ => (DVec3::NEG_Z, DVec3::NEG_Y),
    };
    DMat4::look_at_rh(DVec3::ZERO, toward, up)
}

/// A rotation about an axis of length 1, in degrees, counterclockwise as `glRotate`.
pub fn rotate(degrees: f64, axis: DVec3) -> DMat4 {
    let (sin, cos) = sin_cos_degrees(degrees);
    let column =
        |v: DVec3| (v * cos + axis.cross(v) * sin + axis * (axis.dot(v) * (1.0 - cos))).extend(0.0);
    DMat4::from_cols(column(DVec3::X), column(DVec3::Y), column(DVec3::Z), glam::DVec4::W)
}

/// A translation.
pub fn translate(x: f64, y: f64, z: f64) -> DMat4 {
    DMat4::from_translation(dvec3(x, y, z))
}

/// From clip coordinates' [-1, 1] to the texture domain [0, 1] in x, y and z: what the lecture's
/// "we have to deal with the fact that the canonical texture image domain is the unit square" asks.
pub fn unit_square() -> DMat4 {
    translate(0.5, 0.5, 0.5) * DMat4::from_scale(DVec3::splat(0.5))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_turn_about_z_sends_x_to_y_exactly() {
        assert_eq!(rotate(90.0, DVec3::Z).transform_vector3(DVec3::X), DVec3::Y);
    }

    #[test]
    fn the_corners_of_the_frustum_go_to_the_corners_of_the_picture() {
        let m = unit_square() * perspective(90.0, 1.0, 1.0, 3.0);
        assert!((m.project_point3(dvec3(-1.0, -1.0, -1.0)) - DVec3::ZERO).length() < 1e-15);
        assert!((m.project_point3(dvec3(3.0, 3.0, -3.0)) - DVec3::ONE).length() < 1e-15);
    }
}
