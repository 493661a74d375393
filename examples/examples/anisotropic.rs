//! Isotropic beside anisotropic: the same floor with one probe a pixel, and with up to sixteen.
//!
//! *Texture Mapping*, slide "Anisotropic Texture Filtering". Isotropic level selection takes the longer side
//! of the footprint and "tends to spread blurring at shallow viewing angles"; anisotropic filtering takes
//! the shorter one, and several probes along the longer.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "anisotropic",
    lecture: "Texture Mapping: \"Anisotropic Texture Filtering\"",
    source: include_str!("anisotropic.rs"),
    halves: [4, 2],
    panels: &["isotropic", "anisotropic"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

fn draw(window: &mut Window) {
    glClearColor(0.55, 0.68, 0.85, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    load_texture(0, window.picture("flagstones.ppm"), GL_REPEAT);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    for (panel, anisotropy) in [(0, 1), (1, 16)] {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
        draw_floor(window.panel(2, 1, panel));
    }
}

/// A floor of tiles to the horizon, four units a tile's pattern.
fn draw_floor(aspect: f64) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(60, aspect, 0.1, 200);
    glRotatef(17, 1, 0, 0);
    glBegin(GL_QUADS);
    for (x, z) in [(-90, 0), (90, 0), (90, -120), (-90, -120)] {
        glTexCoord2f(0.25 * f64::from(x) + 0.5, 0.25 * f64::from(z));
        glVertex3f(x, -1, z);
    }
    glEnd();
}
