//! Magnification and minification, texel by texel.
//!
//! *TA 6*, slides "Magnification" and "Minification": 3 × 3 texels on 4 × 4 pixels, 8 × 8 on 5 × 5, and 8 × 8
//! on 2 × 2. From left to right: the texture, nearest, bilinear, mipmapped. In the last row every bilinear
//! sample falls between white texels, so the grid is gone; only the pyramid keeps its mean.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "resampling",
    lecture: "TA 6: \"Magnification\", \"Minification\"",
    source: include_str!("resampling.rs"),
    halves: [4, 3],
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
    (3, 4, |x, y| (x + y) % 2 == 0),
    (8, 5, |x, y| (x / 2 + y / 2) % 2 == 0),
    (8, 2, |x, y| x % 4 % 3 == 0 || y % 4 % 3 == 0),
];

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
        load(&paint(texels, dark));
        for (column, (minify, magnify)) in FILTERS.into_iter().enumerate() {
            set_filter(GL_TEXTURE_2D, minify, magnify);
            // The first column shows all texels.
            let side = if column == 0 { texels as i32 } else { pixels };
            glViewport(0, 0, side, side);
            draw_square(1.);
            pictures.push(copy(side));
        }
    }
    glClearColor(0.20, 0.24, 0.32, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (panel, picture) in (0..).zip(pictures) {
        window.panel(4, 3, panel);
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

/// Not by `gluBuild2DMipmaps`, which would make 4 × 4 texels of 3 × 3.
fn load(picture: &Picture) {
    let mut texture: GLuint = 0;
    glGenTextures(1, &mut texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let (side, data) = (picture.width, &picture.pixels);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, side, side, 0, GL_RGB, GL_UNSIGNED_BYTE, data);
    glGenerateMipmap(GL_TEXTURE_2D);
}

/// The window's lower left corner as a texture that shows its texels.
fn copy(side: i32) -> GLuint {
    let (mut old, mut picture): (GLint, GLuint) = (0, 0);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, std::slice::from_mut(&mut old));
    glGenTextures(1, &mut picture);
    glBindTexture(GL_TEXTURE_2D, picture);
    set_filter(GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 0, 0, side, side, 0);
    glBindTexture(GL_TEXTURE_2D, old as GLuint);
    picture
}

fn draw_square(half: f64) {
    glBegin(GL_QUADS);
    for (s, t) in [(0., 0.), (1., 0.), (1., 1.), (0., 1.)] {
        glTexCoord2f(s, t);
        glVertex2f(half * (2. * s - 1.), half * (2. * t - 1.));
    }
    glEnd();
}
