//! The demon's third vertex: what the lecture's code says, and what its figure says.
//!
//! *Texture Mapping*, slide "Texture Mapping in OpenGL" calls glTexCoord2f (0.5, 1) for the lower vertex; slide
//! "Vertex Texture Coordinates" writes ST = (0.5, 0.5) beside it. Both cannot be: on the left the code, where the
//! triangle has the picture from its top row to the middle of its bottom row, on the right the figure, where it
//! ends in the middle of the picture and the demon is twice as tall.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "demon_coordinates",
    lecture: "Texture Mapping: \"Vertex Texture Coordinates\"",
    source: include_str!("demon_coordinates.rs"),
    halves: [4, 2],
    panels: &["the code: ST = (0.5, 1)", "the figure: ST = (0.5, 0.5)"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

fn draw(window: &mut Window) {
    glClearColor(0.12, 0.13, 0.16, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    // As the lecture loads it: its top row first, which GL has at t = 0.
    let demon = window.picture("demon_image.h").flipped();
    load_texture(0, demon, GL_CLAMP_TO_EDGE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    for (panel, t) in [(0, 1.), (1, 0.5)] {
        window.panel(2, 1, panel);
        glBegin(GL_TRIANGLES);
        glTexCoord2f(0, 0);
        glVertex2f(-0.8, 0.8);
        glTexCoord2f(1, 0);
        glVertex2f(0.8, 0.8);
        glTexCoord2f(0.5, t);
        glVertex2f(0.0, -0.8);
        glEnd();
    }
}
