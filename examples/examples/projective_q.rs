//! Projective texture coordinates: what the fourth one is for.
//!
//! *Texture Mapping*, slide "Interpolation in OpenGL": "projective texturing means we want (s/q, t/q)". Both
//! shapes are flat trapezoids of two triangles. On the left (s, t) as it is: the triangles do not agree; on
//! the right (s·q, t·q, 0, q), with q as wide as the edge is: a square seen in perspective.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "projective_q",
    lecture: "Texture Mapping: \"Interpolation in OpenGL\"",
    source: include_str!("projective_q.rs"),
    halves: [4, 2],
    panels: &["(s, t)", "(s/q, t/q)"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// Corners: s, t, and half the width of the edge they are on.
const CORNERS: [(f64, f64, f64); 4] =
    [(0., 0., 0.9), (1., 0., 0.9), (1., 1., 0.28), (0., 1., 0.28)];

fn draw(window: &mut Window) {
    glClearColor(0.08, 0.09, 0.11, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    load_texture(0, window.picture("slide.ppm"), GL_CLAMP_TO_EDGE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);

    window.panel(2, 1, 0);
    glBegin(GL_TRIANGLE_FAN);
    for (s, t, half) in CORNERS {
        glTexCoord2f(s, t);
        glVertex2f((2. * s - 1.) * half, 1.7 * t - 0.85);
    }
    glEnd();

    window.panel(2, 1, 1);
    glBegin(GL_TRIANGLE_FAN);
    for (s, t, half) in CORNERS {
        let q = half;
        glTexCoord4f(s * q, t * q, 0, q);
        glVertex2f((2. * s - 1.) * half, 1.7 * t - 0.85);
    }
    glEnd();
}
