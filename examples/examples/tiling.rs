//! Tiling: what lies beyond 1 is up to the wrap mode.
//!
//! *eScience*, slide 28, "What Else About Mapping?"; *Texture Mapping*, "Texture wrap modes". Coordinates run
//! from -1 to 2 in each square. From left to right, above: GL_REPEAT, GL_MIRRORED_REPEAT; below:
//! GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER with a yellow border.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "tiling",
    lecture: "eScience: slide 28, \"What Else About Mapping?\": tiling",
    source: include_str!("tiling.rs"),
    halves: [2, 2],
    panels: &["GL_REPEAT", "GL_MIRRORED_REPEAT", "GL_CLAMP_TO_EDGE", "GL_CLAMP_TO_BORDER"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const WRAPS: [GLenum; 4] = [GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER];

fn draw(window: &mut Window) {
    glClearColor(0.12, 0.14, 0.18, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    load_texture(0, window.picture("demon_image.h"), GL_REPEAT);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[0.95, 0.80, 0.35, 1.]);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    for (panel, wrap) in (0..).zip(WRAPS) {
        window.panel(2, 2, panel);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
        glBegin(GL_QUADS);
        for (x, y) in [(-1, -1), (1, -1), (1, 1), (-1, 1)] {
            glTexCoord2f(0.5 + 1.5 * f64::from(x), 0.5 + 1.5 * f64::from(y));
            glVertex2f(0.92 * f64::from(x), 0.92 * f64::from(y));
        }
        glEnd();
    }
}
