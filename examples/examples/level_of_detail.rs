//! LOD bias and clamp: a pyramid whose levels have a colour each.
//!
//! *Texture Mapping*, slides "LOD Bias and Clamping" and "Determine Levels and Interpolant":
//! λ = log2(ρ) + lodBias, λ' = max(minLOD, min(maxLOD, λ)). Above, the bias is -1.5, 0 and +1.5; below, λ is
//! clamped to at least 2, to at most 1, and the pyramid begins at level 3.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "level_of_detail",
    lecture: "Texture Mapping: \"LOD Bias and Clamping\"",
    source: include_str!("level_of_detail.rs"),
    halves: [3, 2],
    panels: &["bias -1.5", "bias 0", "bias +1.5", "λ at least 2", "λ at most 1", "base level 3"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// A colour a level.
const LEVELS: [[f64; 3]; 8] = [
    [0.90, 0.20, 0.20],
    [0.95, 0.60, 0.15],
    [0.95, 0.90, 0.25],
    [0.35, 0.80, 0.30],
    [0.20, 0.75, 0.80],
    [0.25, 0.40, 0.90],
    [0.60, 0.30, 0.85],
    [0.95, 0.95, 0.95],
];

/// Bias, least λ, greatest λ, base level.
const PANELS: [(f64, i32, i32, i32); 6] = [
    (-1.5, -1000, 1000, 0),
    (0., -1000, 1000, 0),
    (1.5, -1000, 1000, 0),
    (0., 2, 1000, 0),
    (0., -1000, 1, 0),
    (0., -1000, 1000, 3),
];

fn draw(window: &mut Window) {
    glClearColor(0.08, 0.09, 0.11, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    let mut texture: GLuint = 0;
    glGenTextures(1, &mut texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (level, color) in LEVELS.into_iter().enumerate() {
        let side = 128 >> level;
        // A checkerboard of 16 × 16, as far as the level can show it.
        let image = Picture::paint(side, side, |x, y| {
            let light = ((x * 16.0).floor() + (y * 16.0).floor()) % 2.0;
            color.map(|component| component * (0.55 + 0.45 * light))
        });
        let data = &image.pixels;
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGB8, side, side, 0, GL_RGB, GL_UNSIGNED_BYTE, data);
    }
    set_filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    for (panel, (bias, least, greatest, base)) in (0..).zip(PANELS) {
        glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, bias);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, least);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, greatest);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, base);
        let aspect = window.panel(3, 2, panel);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        gluPerspective(60, aspect, 0.1, 200);
        glRotatef(22, 1, 0, 0);
        glBegin(GL_QUADS);
        for (x, z) in [(-40, 0), (40, 0), (40, -60), (-40, -60)] {
            glTexCoord2f(0.5 * f64::from(x), 0.5 * f64::from(z));
            glVertex3f(x, -1, z);
        }
        glEnd();
    }
}
