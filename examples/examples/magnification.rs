//! Magnification, texel by texel: 3 × 3 texels on 4 × 4 pixels.
//!
//! *TA 6*, "Magnification". From left to right: the texture; nearest, which shows one row and one column twice;
//! bilinear, which mixes them by the place of each pixel's centre. Above a checkerboard, below a cross.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "magnification",
    lecture: "TA 6: \"Magnification\"",
    source: include_str!("magnification.rs"),
    halves: [3, 2],
    panels: &[
        "3×3 texels",
        "4×4: nearest",
        "4×4: bilinear",
        "3×3 texels",
        "4×4: nearest",
        "4×4: bilinear",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// The texture's side, the picture's, and where the texture is dark.
type Row = (usize, i32, fn(usize, usize) -> bool);

/// The textures.
const ROWS: [Row; 2] = [(3, 4, |x, y| (x + y) % 2 == 0), (3, 4, |x, y| x == 1 || y == 1)];

/// A pyramid has no part in it.
const COLUMNS: usize = 3;

/// What the columns show: the texture's own texels, nearest, bilinear, and with the pyramid.
const FILTERS: [(GLenum, GLenum); 4] = [
    (GL_NEAREST, GL_NEAREST),
    (GL_NEAREST, GL_NEAREST),
    (GL_LINEAR, GL_LINEAR),
    (GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR),
];

fn draw(window: &mut Window) {
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    let mut pictures = Vec::new();
    for (texels, pixels, dark) in ROWS {
        let texture = load_texels(&paint(texels, dark));
        for (column, (minify, magnify)) in FILTERS.into_iter().enumerate().take(COLUMNS) {
            set_filter(GL_TEXTURE_2D, minify, magnify);
            let side = if column == 0 { texels as i32 } else { pixels };
            glViewport(0, 0, side, side);
            draw_square(1.);
            pictures.push(copy_window(side));
            glBindTexture(GL_TEXTURE_2D, texture);
        }
    }
    glClearColor(0.20, 0.24, 0.32, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (panel, picture) in (0..).zip(pictures) {
        window.panel(COLUMNS as i32, ROWS.len() as i32, panel);
        glBindTexture(GL_TEXTURE_2D, picture);
        draw_square(0.9);
    }
}

fn paint(side: usize, dark: fn(usize, usize) -> bool) -> Picture {
    let texel = |at: f64| (at * side as f64) as usize;
    Picture::paint_centers(side, side, |x, y| {
        if dark(texel(x), texel(y)) { [0.10, 0.12, 0.45] } else { [1.0; 3] }
    })
}

fn draw_square(half: f64) {
    glBegin(GL_QUADS);
    for (s, t) in [(0., 0.), (1., 0.), (1., 1.), (0., 1.)] {
        glTexCoord2f(s, t);
        glVertex2f(half * (2. * s - 1.), half * (2. * t - 1.));
    }
    glEnd();
}
