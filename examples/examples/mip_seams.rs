//! Bilinear mipmapped filtering and its seams, beside trilinear filtering, which has none.
//!
//! *eScience*, slide 14. On the left `GL_LINEAR_MIPMAP_NEAREST`: the nearest level, four texels and three linear
//! interpolations; where λ passes a half, one level ends and the next begins. On the right
//! `GL_LINEAR_MIPMAP_LINEAR`: two levels, eight texels and seven interpolations. Above stripes, below a colour
//! for each level, which shows where the seams are.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::{Picture, packed_pixel_t};
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "mip_seams",
    lecture: "eScience: slide 14, bilinear and trilinear mipmapped filtering",
    source: include_str!("mip_seams.rs"),
    halves: [4, 4],
    panels: &[
        "one level: 4 texels, 3 interpolations",
        "two levels: 8 texels, 7 interpolations",
        "one level, a colour each",
        "two levels",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// Of the levels from the largest.
const COLORS: [[u8; 3]; 7] = [
    [230, 60, 50],
    [240, 150, 40],
    [245, 225, 60],
    [90, 190, 80],
    [50, 170, 200],
    [70, 80, 200],
    [150, 70, 180],
];

fn draw(window: &mut Window) {
    glClearColor(0.55, 0.68, 0.85, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    let stripes = Picture::paint(64, 64, |x, y| {
        let at = (4. * x + 2. * y).fract();
        if at < 0.5 { [0.95, 0.92, 0.85] } else { [0.10, 0.12, 0.40] }
    });
    let textures = [load_texture(0, stripes, GL_REPEAT), load_colors()];
    for panel in 0..4 {
        let aspect = window.panel(2, 2, panel);
        glBindTexture(GL_TEXTURE_2D, textures[panel as usize / 2]);
        let filter =
            if panel % 2 == 0 { GL_LINEAR_MIPMAP_NEAREST } else { GL_LINEAR_MIPMAP_LINEAR };
        set_filter(GL_TEXTURE_2D, filter, GL_LINEAR);
        draw_floor(aspect);
    }
}

/// A texture whose levels have one colour each.
fn load_colors() -> GLuint {
    let mut texture: GLuint = 0;
    glGenTextures(1, &mut texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (level, [r, g, b]) in (0..).zip(COLORS) {
        let side = 64 >> level;
        let data = vec![packed_pixel_t { r, g, b }; side * side];
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGB8, side, side, 0, GL_RGB, GL_UNSIGNED_BYTE, &data);
    }
    texture
}

/// A floor to the horizon, a unit a pattern.
fn draw_floor(aspect: f64) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(60, aspect, 0.1, 200);
    glRotatef(24, 1, 0, 0);
    glBegin(GL_QUADS);
    for (x, z) in [(-90, 0), (90, 0), (90, -120), (-90, -120)] {
        glTexCoord2f(f64::from(x), f64::from(z));
        glVertex3f(x, -1, z);
    }
    glEnd();
}
