//! The mip pyramid: every level of a texture, each the mean of four texels of the one before.
//!
//! *Texture Mapping*, slide "Pre-filtered Image Versions"; *eScience*, slides 14 and 15. Each level is drawn by
//! itself, with `GL_TEXTURE_BASE_LEVEL` and `GL_TEXTURE_MAX_LEVEL` on it, at its own size above and stretched
//! to the same size below.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "mip_pyramid",
    lecture: "Texture Mapping: \"Pre-filtered Image Versions\"",
    source: include_str!("mip_pyramid.rs"),
    halves: [4, 3],
    panels: &[],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// The most levels that are drawn.
const LEVELS: i32 = 8;

fn draw(window: &mut Window) {
    glClearColor(0.16, 0.18, 0.22, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    let picture = window.picture("demon_image.h");
    // A smaller picture has fewer levels.
    let levels = LEVELS.min(picture.width.max(picture.height).ilog2() as i32 + 1);
    load_texture(0, picture, GL_CLAMP_TO_EDGE);
    set_filter(GL_TEXTURE_2D, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glViewport(0, 0, window.width, window.height);
    glMatrixMode(GL_PROJECTION);
    // 4 × 3 units of length; one is the side of the largest level.
    gluOrtho2D(0, 4, 0, 3);
    let mut x = 0.1;
    for level in 0..levels {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, level);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level);
        let side = 1.8 / f64::from(1 << level);
        draw_square(x, 1.1, side);
        x += side + 0.03;
        draw_square(0.04 + 0.495 * f64::from(level), 0.3, 0.455);
    }
}

fn draw_square(x: f64, y: f64, side: f64) {
    glBegin(GL_QUADS);
    for (s, t) in [(0., 0.), (1., 0.), (1., 1.), (0., 1.)] {
        glTexCoord2f(s, t);
        glVertex2f(x + side * s, y + side * t);
    }
    glEnd();
}
