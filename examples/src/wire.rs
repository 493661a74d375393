//! Lines for diagrams: a ground, axes, a camera's frustum.

use crate::matrix::{DMat4, DVec3, dvec3};
use gl_api::constants::*;
use gl_api::*;

/// Turns to the fixed function, a matrix and a colour.
pub fn through(matrix: &DMat4, color: [f32; 3]) {
    glUseProgram(0);
    glDisable(GL_TEXTURE_2D);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(&matrix.to_cols_array());
    glColor3fv(&color);
}

/// Lines between pairs of points.
pub fn segments(points: &[(DVec3, DVec3)]) {
    glBegin(GL_LINES);
    for point in points.iter().flat_map(|(from, to)| [from, to]) {
        glVertex3d(point.x, point.y, point.z);
    }
    glEnd();
}

/// A grid on y = 0, from -2 to 4.
pub fn draw_ground(matrix: &DMat4) {
    through(matrix, [0.45, 0.55, 0.45]);
    let line = |at: i32| {
        [(f64::from(at), -2., f64::from(at), 4.), (-2., f64::from(at), 4., f64::from(at))]
    };
    let lines: Vec<_> = (-2..=4)
        .flat_map(line)
        .map(|(x, z, to_x, to_z)| (dvec3(x, 0., z), dvec3(to_x, 0., to_z)))
        .collect();
    segments(&lines);
}

/// One unit long, in red, green and blue.
pub fn draw_axes(view: &DMat4) {
    for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
        through(view, axis.as_vec3().to_array().map(|c| 0.8 * c));
        glLineWidth(2);
        segments(&[(DVec3::ZERO, axis)]);
        glLineWidth(1);
    }
}

/// The edges of the cube of clip space.
pub fn draw_frustum(matrix: &DMat4) {
    through(matrix, [0.35, 0.25, 0.60]);
    let corner = |at: i32| {
        dvec3(1., 1., 1.)
            - 2. * dvec3(f64::from(at & 1), f64::from(at >> 1 & 1), f64::from(at >> 2))
    };
    let edges: Vec<_> = (0..8)
        .flat_map(|from| [1, 2, 4].map(|bit| (from, from | bit)))
        .filter(|(from, to)| from != to)
        .map(|(from, to)| (corner(from), corner(to)))
        .collect();
    segments(&edges);
}
