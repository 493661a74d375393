//! Minification, texel by texel: 8 × 8 texels on 5 × 5 pixels, and on 2 × 2.
//!
//! *TA 6*, "Minification". From left to right: the texture, nearest, bilinear, mipmapped. In the second row every
//! bilinear sample falls between white texels, so the grid is gone and the picture goes white; in the third, of
//! single texels, nearest is even worse: all dark, where four texels have the mean. Only the pyramid is
//! right in each.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "minification",
    lecture: "TA 6: \"Minification\"",
    source: include_str!("minification.rs"),
    halves: [4, 3],
    panels: &[
        "8×8 texels",
        "5×5: nearest",
        "bilinear",
        "pyramid",
        "8×8 texels",
        "2×2: nearest",
        "bilinear",
        "pyramid",
        "8×8 texels",
        "2×2: nearest",
        "bilinear",
        "pyramid",
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
const ROWS: [Row; 3] = [
    (8, 5, |x, y| (x / 2 + y / 2) % 2 == 0),
    (8, 2, |x, y| x % 4 % 3 == 0 || y % 4 % 3 == 0),
    (8, 2, |x, y| (x + y) % 2 == 0),
];

const COLUMNS: usize = 4;

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
        draw_square(0.8);
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
