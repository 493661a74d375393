//! The texture matrix: coordinates are scaled, turned and moved before they are used.
//!
//! *eScience*, slides 7 and 28: u = a_u s + b_u t + c_u, v = a_v s + b_v t + c_v. Above: the texture as it is;
//! scaled, which tiles it 3 × 3. Below: turned by 30 degrees about its middle; moved by a quarter. The
//! numbers below each are GL's own, from `GL_TEXTURE_MATRIX`.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "texture_matrix",
    lecture: "eScience: slides 7 and 28: u = a s + b t + c, the texture matrix",
    source: include_str!("texture_matrix.rs"),
    halves: [3, 3],
    panels: &["as it is", "scaled", "turned", "moved"],
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
            glVertex2f(1.5 * f64::from(s) - 0.75, 1.5 * f64::from(t) - 0.57);
        }
        glEnd();
        window.label(0., -0.74, [1., 1., 0.9], &formula());
    }
}

/// The affine part of the texture matrix, which is stored column by column.
fn formula() -> String {
    let mut m: [f32; 16] = [0.; 16];
    glGetFloatv(GL_TEXTURE_MATRIX, &mut m);
    let row = |name: &str, at: usize| {
        format!("{name} = {:.2} s {:+.2} t {:+.2}", m[at], m[at + 4], m[at + 12])
    };
    format!("{}\n{}", row("u", 0), row("v", 1))
}
