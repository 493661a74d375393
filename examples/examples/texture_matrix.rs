//! Tiling, transparency, and the texture matrix.
//!
//! *eScience*, slide 28, "What Else About Mapping?". Above: the texture as it is, and tiled 3 × 3 by a scale;
//! below: turned by 30 degrees about its middle, and moved by a quarter. The holes have an alpha of 0, and
//! blending lets the stripes behind show through.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::disc;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "texture_matrix",
    lecture: "eScience: slide 28, \"What Else About Mapping?\"",
    source: include_str!("texture_matrix.rs"),
    halves: [2, 2],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

fn draw(window: &mut Window) {
    glClearColor(0.15, 0.22, 0.30, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    load_with_holes(window);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for panel in 0..4 {
        window.panel(2, 2, panel);
        draw_stripes();

        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        match panel {
            0 => {}
            1 => glScalef(3, 3, 1),
            2 => {
                glTranslatef(0.5, 0.5, 0);
                glRotatef(30, 0, 0, 1);
                glTranslatef(-0.5, -0.5, 0);
            }
            _ => glTranslatef(0.25, 0.25, 0),
        }
        glEnable(GL_TEXTURE_2D);
        glEnable(GL_BLEND);
        glBegin(GL_QUADS);
        for (s, t) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
            glTexCoord2f(s, t);
            glVertex2f(1.7 * f64::from(s) - 0.85, 1.7 * f64::from(t) - 0.85);
        }
        glEnd();
        glDisable(GL_BLEND);
        glDisable(GL_TEXTURE_2D);
    }
}

fn draw_stripes() {
    glColor3f(0.95, 0.80, 0.35);
    glBegin(GL_QUADS);
    for stripe in 0..6 {
        let x = -1. + f64::from(stripe) / 3.;
        for (dx, y) in [(0., -1), (1. / 6., -1), (1. / 6., 1), (0., 1)] {
            glVertex2f(x + dx, y);
        }
    }
    glEnd();
}

/// The demon, with an alpha that is 0 in four round holes.
fn load_with_holes(window: &Window) {
    let picture = window.picture("demon_image.h").flipped();
    let (width, height) = (picture.width, picture.height);
    let mut texels: Vec<u8> = Vec::with_capacity(width * height * 4);
    for (at, texel) in picture.pixels.iter().enumerate() {
        let middle = |at: usize, size: usize| (at as f64 + 0.5) / size as f64;
        let (s, t) = (middle(at % width, width), middle(at / width, height));
        let hole = disc(s.min(1. - s), t.min(1. - t), 0.17, 0.17, 0.12);
        texels.extend([texel.r, texel.g, texel.b, if hole { 0 } else { 255 }]);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGBA8, width, height, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
    set_filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
}
