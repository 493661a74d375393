//! A decal skin on a model: GL_DECAL lays the picture over what is lit.
//!
//! *Texture Mapping*, "Decal skins". From left to right: the lit vase without a texture; the decal replacing
//! it (GL_REPLACE), which knows no light and shows the picture's empty ground; and GL_DECAL,
//! C = (1 - A_s) C_f + A_s C_s, where the picture's alpha says how much of the vase is covered.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::smooth;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "decal_skin",
    lecture: "Texture Mapping: \"Decal skins\"",
    source: include_str!("decal_skin.rs"),
    halves: [6, 2],
    panels: &["no texture", "GL_REPLACE: knows no light", "GL_DECAL: as the picture's alpha says"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

fn draw(window: &mut Window) {
    glClearColor(0.12, 0.14, 0.18, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, &[-2., 3., 4., 0.]);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, &[0.45, 0.70, 0.62, 1.]);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, &[0.5, 0.5, 0.5, 1.]);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40);
    glBindTexture(GL_TEXTURE_2D, 1);
    load_decal(window);
    let vase = Mesh::vase().upload();
    for (panel, environment) in [(0, None), (1, Some(GL_REPLACE)), (2, Some(GL_DECAL))] {
        let aspect = window.panel(3, 1, panel);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        gluPerspective(38, aspect, 0.1, 50);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glTranslatef(0, 0, -3.4);
        glRotatef(16, 1, 0, 0);
        glBindTexture(GL_TEXTURE_2D, if environment.is_none() { 0 } else { 1 });
        if let Some(mode) = environment {
            glEnable(GL_TEXTURE_2D);
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode);
        }
        // Once around is two pictures; the texture matrix puts one in front.
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        glTranslatef(0.5, 0, 0);
        glScalef(2, 1, 1);
        glMatrixMode(GL_MODELVIEW);
        vase.draw_fixed();
    }
}

/// The demon's head as a decal: opaque inside an ellipse with a soft rim, nothing outside.
fn load_decal(window: &Window) {
    let picture = window.picture("demon_image.h").flipped();
    let (width, height) = (picture.width, picture.height);
    let middle = |at: usize, size: usize| 2. * (at as f64 + 0.5) / size as f64 - 1.;
    let mut texels: Vec<u8> = Vec::with_capacity(width * height * 4);
    for (at, texel) in picture.pixels.iter().enumerate() {
        let (x, y) = (middle(at % width, width), middle(at / width, height));
        let from_middle = (x * x / 0.85 + y * y).sqrt();
        let cover = 1. - smooth(0.62, 0.70, from_middle);
        texels.extend([texel.r, texel.g, texel.b, (cover * 255.) as u8]);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGBA8, width, height, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
    set_filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
}
