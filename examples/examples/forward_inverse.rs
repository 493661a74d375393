//! Forward against inverse mapping.
//!
//! *eScience*, slide 8. On the left each texel is sent to the pixel where it falls (a point each): stretched,
//! the texels leave holes. On the right each pixel asks which texel it shows, and none is left out.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "forward_inverse",
    lecture: "eScience: slide 8, \"Transformations: Direct or Inverse\"",
    source: include_str!("forward_inverse.rs"),
    halves: [4, 2],
    panels: &["forward: each texel", "inverse: each pixel"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

fn draw(window: &mut Window) {
    glClearColor(0.05, 0.05, 0.06, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    let picture = window.picture("demon_image.h").flipped();
    let (width, height) = (picture.width, picture.height);

    window.panel(2, 1, 0);
    place();
    glPointSize(1);
    glBegin(GL_POINTS);
    for (at, texel) in picture.pixels.iter().enumerate() {
        let (s, t) = (at % width, at / width);
        glColor3ub(texel.r, texel.g, texel.b);
        glVertex2f(middle(s, width), middle(t, height));
    }
    glEnd();

    window.panel(2, 1, 1);
    load_texture(0, picture.flipped(), GL_CLAMP_TO_EDGE);
    set_filter(GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glBegin(GL_QUADS);
    for (s, t) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
        glTexCoord2f(s, t);
        glVertex2f(2 * s - 1, 2 * t - 1);
    }
    glEnd();
}

/// The same transformation for both: a turn and a tilt.
fn place() {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45, 1, 0.1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -2.6);
    glRotatef(-40, 1, 0, 0);
    glRotatef(20, 0, 0, 1);
}

/// The middle of a texel, from -1 to 1.
fn middle(at: usize, size: usize) -> f64 {
    (2. * at as f64 + 1.) / size as f64 - 1.
}
