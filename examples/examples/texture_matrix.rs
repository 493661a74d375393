//! The texture matrix: coordinates are scaled, turned and moved before they are used.
//!
//! *eScience*, slide 28, "What Else About Mapping?". Above: the texture as it is; scaled, which tiles it 3 × 3.
//! Below: turned by 30 degrees about its middle; moved by a quarter.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "texture_matrix",
    lecture: "eScience: slide 28, \"What Else About Mapping?\": texture matrix",
    source: include_str!("texture_matrix.rs"),
    halves: [2, 2],
    panels: &[],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

fn draw(window: &mut Window) {
    glClearColor(0.15, 0.22, 0.30, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    load_texture(0, window.picture("demon_image.h"), GL_REPEAT);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    for panel in 0..4 {
        window.panel(2, 2, panel);
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        match panel {
            0 => {}
            1 => glScalef(3, 3, 1),
            2 => {
                glTranslatef(0.5, 0.5, 0);
                glRotatef(30, 0, 0, 1);
                glTranslatef(-0.5, -0.5, 0);
            }
            _ => glTranslatef(0.25, 0.25, 0),
        }
        glBegin(GL_QUADS);
        for (s, t) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
            glTexCoord2f(s, t);
            glVertex2f(1.7 * f64::from(s) - 0.85, 1.7 * f64::from(t) - 0.85);
        }
        glEnd();
    }
}
