//! Transparency: the alpha of a texture decides what is seen of what lies behind.
//!
//! *eScience*, slide 28, "What Else About Mapping?". From left to right: alpha ignored; the alpha test, which
//! takes or leaves a fragment (GL_ALPHA_TEST, A > 1/2); and blending, C = A_s C_s + (1 - A_s) C_d, drawn from
//! back to front.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::smooth;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "transparency",
    lecture: "eScience: slide 28, \"What Else About Mapping?\": transparency",
    source: include_str!("transparency.rs"),
    halves: [6, 2],
    panels: &["alpha ignored", "alpha test", "blending"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

fn draw(window: &mut Window) {
    glClear(GL_COLOR_BUFFER_BIT);
    load_leaf();
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glAlphaFunc(GL_GREATER, 0.5);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (panel, capability) in [(0, None), (1, Some(GL_ALPHA_TEST)), (2, Some(GL_BLEND))] {
        window.panel(3, 1, panel);
        draw_sky();
        if let Some(capability) = capability {
            glEnable(capability);
        }
        glEnable(GL_TEXTURE_2D);
        for (x, y, degrees, color) in LEAVES {
            glPushMatrix();
            glTranslatef(x, y, 0);
            glRotatef(degrees, 0, 0, 1);
            glColor3fv(&color);
            glBegin(GL_QUADS);
            for (s, t) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
                glTexCoord2f(s, t);
                glVertex2f(f64::from(s) - 0.5, 1.2 * f64::from(t) - 0.6);
            }
            glEnd();
            glPopMatrix();
        }
        glDisable(GL_TEXTURE_2D);
        if let Some(capability) = capability {
            glDisable(capability);
        }
    }
}

/// Place, turn, and colour, from back to front.
const LEAVES: [(f64, f64, f64, [f32; 3]); 4] = [
    (-0.40, 0.32, 35., [0.95, 0.75, 0.20]),
    (0.35, 0.38, -50., [0.90, 0.45, 0.20]),
    (-0.15, -0.15, 80., [0.45, 0.75, 0.30]),
    (0.40, -0.35, -15., [0.85, 0.30, 0.30]),
];

fn draw_sky() {
    glBegin(GL_QUADS);
    for (x, y, color) in [
        (-1, -1, [0.95, 0.90, 0.80]),
        (1, -1, [0.95, 0.90, 0.80]),
        (1, 1, [0.35, 0.60, 0.90]),
        (-1, 1, [0.35, 0.60, 0.90]),
    ] {
        glColor3fv(&color);
        glVertex2f(x, y);
    }
    glEnd();
}

/// A leaf with veins; its alpha is 0 around it, and less than 1 between the veins.
fn load_leaf() {
    const SIDE: usize = 128;
    let mut texels: Vec<u8> = Vec::with_capacity(SIDE * SIDE * 4);
    for at in 0..SIDE * SIDE {
        let middle = |at: usize| 2. * (at as f64 + 0.5) / SIDE as f64 - 1.;
        let (x, y) = (middle(at % SIDE), middle(at / SIDE));
        let width = 0.75 * (1. - y * y);
        let inside = 1. - smooth(width - 0.06, width, x.abs());
        let vein = ((y - 0.6 * x.abs()) * 6.).rem_euclid(1.);
        let vein = if x.abs() < 0.04 || vein < 0.14 { 1. } else { 0. };
        let shade = (150. + 105. * vein) as u8;
        texels.extend([shade, shade, shade, (255. * inside * (0.65 + 0.35 * vein)) as u8]);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let data = &texels;
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGBA8, SIDE, SIDE, GL_RGBA, GL_UNSIGNED_BYTE, data);
    set_filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
}
