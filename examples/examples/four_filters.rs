//! The four-way filter comparison on a floor of tiles.
//!
//! *Texture Mapping*, slide "Mipmap Texture Filtering". Above, without mipmaps: point sampling and linear
//! filtering; the far tiles are noise. Below, with them: mipmapped point sampling, whose levels show as
//! bands, and mipmapped linear filtering.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "four_filters",
    lecture: "Texture Mapping: \"Mipmap Texture Filtering\"",
    source: include_str!("four_filters.rs"),
    halves: [3, 3],
    panels: &[],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// Minification and magnification filters, as the slide has them.
const FILTERS: [(GLenum, GLenum); 4] = [
    (GL_NEAREST, GL_NEAREST),
    (GL_LINEAR, GL_LINEAR),
    (GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST),
    (GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR),
];

fn draw(window: &mut Window) {
    glClearColor(0.55, 0.68, 0.85, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    load_texture(0, tiles(), GL_REPEAT);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    for (panel, (minify, magnify)) in (0..).zip(FILTERS) {
        set_filter(GL_TEXTURE_2D, minify, magnify);
        draw_floor(window.panel(2, 2, panel));
    }
}

/// Red and cream tiles with dark joints.
fn tiles() -> Picture {
    Picture::paint(64, 64, |x, y| {
        let (u, v) = (x * 4.0, y * 4.0);
        if u.fract().min(v.fract()) < 0.12 {
            return [0.12, 0.10, 0.10];
        }
        if (u.floor() + v.floor()) % 2.0 == 0.0 { [0.95, 0.90, 0.78] } else { [0.72, 0.16, 0.12] }
    })
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
