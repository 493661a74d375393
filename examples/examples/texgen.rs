//! Texture coordinate generation: GL makes the coordinates, not the artist.
//!
//! *Texture Mapping*, slide "Source of texture coordinates?". From left to right, above: `GL_OBJECT_LINEAR`,
//! where the pattern sticks to the vase however it is turned, and `GL_EYE_LINEAR`, where the vase moves
//! through the pattern; below: `GL_SPHERE_MAP`, and `GL_REFLECTION_MAP` into a cube map.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "texgen",
    lecture: "Texture Mapping: \"Source of texture coordinates?\"",
    source: include_str!("texgen.rs"),
    halves: [3, 3],
    panels: &["GL_OBJECT_LINEAR", "GL_EYE_LINEAR", "GL_SPHERE_MAP", "GL_REFLECTION_MAP"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

fn draw(window: &mut Window) {
    glClearColor(0.10, 0.12, 0.16, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(42, 1, 0.1, 50);
    let vase = Mesh::vase().upload();

    load_texture(0, window.picture("bricks.ppm"), GL_REPEAT);
    glEnable(GL_TEXTURE_2D);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    for (panel, mode, plane) in
        [(0, GL_OBJECT_LINEAR, GL_OBJECT_PLANE), (1, GL_EYE_LINEAR, GL_EYE_PLANE)]
    {
        window.panel(2, 2, panel);
        generate(&[GL_S, GL_T], mode);
        glTexGenfv(GL_S, plane, &[0.8, 0., 0., 0.]);
        glTexGenfv(GL_T, plane, &[0., 0.8, 0., 0.]);
        draw_two(&vase);
    }

    window.panel(2, 2, 2);
    load_texture(0, window.picture("sphere_map.ppm"), GL_CLAMP_TO_EDGE);
    generate(&[GL_S, GL_T], GL_SPHERE_MAP);
    draw_two(&vase);

    window.panel(2, 2, 3);
    glDisable(GL_TEXTURE_2D);
    load_cube_map(window);
    glEnable(GL_TEXTURE_CUBE_MAP);
    generate(&[GL_S, GL_T, GL_R], GL_REFLECTION_MAP);
    draw_two(&vase);
}

fn generate(coordinates: &[GLenum], mode: GLenum) {
    for (&coordinate, capability) in coordinates.iter().zip(GL_TEXTURE_GEN_S..) {
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, mode);
        glEnable(capability);
    }
}

/// The same vase twice, upright and tilted.
fn draw_two(vase: &Model) {
    for (x, degrees) in [(-0.62, 0), (0.62, -38)] {
        glPushMatrix();
        glTranslatef(x, 0, -3.6);
        glRotatef(degrees, 0, 0, 1);
        glRotatef(14, 1, 0, 0);
        vase.draw_fixed();
        glPopMatrix();
    }
}
