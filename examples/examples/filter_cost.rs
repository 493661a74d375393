//! One to eight texels a fetch: the six minification filters, and what each reads.
//!
//! *Texture Mapping*, slide "Pre-filtered Image Versions": "hardware wants to sample just a small (1 to 8) number
//! of samples for every fetch -- and want constant time access". However far away the floor is, each filter reads
//! as many texels as its caption says; a lerp is one interpolation between two values.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "filter_cost",
    lecture: "Texture Mapping: \"Pre-filtered Image Versions\"",
    source: include_str!("filter_cost.rs"),
    halves: [6, 4],
    panels: &[
        "NEAREST: 1 texel",
        "NEAREST_MIPMAP_NEAREST: 1 texel of a level",
        "NEAREST_MIPMAP_LINEAR: 2 texels, 1 lerp",
        "LINEAR: 4 texels, 3 lerps",
        "LINEAR_MIPMAP_NEAREST: 4 texels, 3 lerps",
        "LINEAR_MIPMAP_LINEAR: 8 texels, 7 lerps",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// The filters, those of one texel in a level above, those of four below.
const FILTERS: [GLenum; 6] = [
    GL_NEAREST,
    GL_NEAREST_MIPMAP_NEAREST,
    GL_NEAREST_MIPMAP_LINEAR,
    GL_LINEAR,
    GL_LINEAR_MIPMAP_NEAREST,
    GL_LINEAR_MIPMAP_LINEAR,
];

fn draw(window: &mut Window) {
    glClearColor(0.55, 0.68, 0.85, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    let squares = Picture::paint(64, 64, |x, y| {
        let odd = ((x * 4.).floor() + (y * 4.).floor()) % 2. == 1.;
        if odd { [0.10, 0.22, 0.42] } else { [0.96, 0.90, 0.70] }
    });
    load_texture(0, squares, GL_REPEAT);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    for (panel, minify) in (0..).zip(FILTERS) {
        let magnify = if panel < 3 { GL_NEAREST } else { GL_LINEAR };
        set_filter(GL_TEXTURE_2D, minify, magnify);
        let aspect = window.panel(3, 2, panel);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        gluPerspective(60, aspect, 0.1, 200);
        glRotatef(22, 1, 0, 0);
        glRotatef(20, 0, 1, 0);
        glBegin(GL_QUADS);
        for (x, z) in [(-120, 20), (120, 20), (120, -140), (-120, -140)] {
            glTexCoord2f(0.25 * f64::from(x), 0.25 * f64::from(z));
            glVertex3f(x, -1, z);
        }
        glEnd();
    }
}
