//! Environment mapping by a sphere map: one picture of the whole surroundings in a ball.
//!
//! *Texture Mapping*, "Environment mapping" (Blinn and Newell 1976; Haeberli and Segal 1993). On the left the
//! map, a photograph of a mirror ball; on the right a mirror that looks it up at
//! s = r_x / m + 1/2, t = r_y / m + 1/2, m = 2 √(r_x² + r_y² + (r_z + 1)²), which GL_SPHERE_MAP generates.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "sphere_map",
    lecture: "Texture Mapping: \"Environment mapping\", sphere map",
    source: include_str!("sphere_map.rs"),
    halves: [4, 2],
    panels: &["the sphere map", "a mirror that looks it up"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

fn draw(window: &mut Window) {
    glClearColor(0.10, 0.12, 0.16, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    load_texture(0, window.picture("sphere_map.ppm"), GL_CLAMP_TO_EDGE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);

    // The map itself.
    window.panel(2, 1, 0);
    glBegin(GL_QUADS);
    for (s, t) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
        glTexCoord2f(s, t);
        glVertex2f(1.8 * f64::from(s) - 0.9, 1.8 * f64::from(t) - 0.9);
    }
    glEnd();

    // The mirror: s and t come from the eye and the normal.
    glEnable(GL_DEPTH_TEST);
    for (coordinate, capability) in [(GL_S, GL_TEXTURE_GEN_S), (GL_T, GL_TEXTURE_GEN_T)] {
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
        glEnable(capability);
    }
    let aspect = window.panel(2, 1, 1);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(42, aspect, 0.1, 50);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0, -4);
    glPushMatrix();
    glRotatef(58, 1, 0, 0);
    glRotatef(20, 0, 0, 1);
    Mesh::torus(0.34).upload().draw_fixed();
    glPopMatrix();
    glScalef(0.5, 0.5, 0.5);
    Mesh::sphere().upload().draw_fixed();
}
