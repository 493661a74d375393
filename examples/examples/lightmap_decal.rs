//! Multiple textures: lightmaps only × decal only = combined scene, on two units.
//!
//! *Texture Mapping*, slide "Multiple Textures" (Id Software's Quake 2, circa 1997). The light is
//! baked into small textures that are stretched over the walls; `GL_MODULATE` multiplies them with
//! the decals, which repeat.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::corridor::{DECALS, Surface, surfaces};
use examples::lecture::*;
use std::collections::BTreeMap;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "lightmap_decal",
    lecture: "Texture Mapping: \"Multiple Textures\" (Quake 2)",
    source: include_str!("lightmap_decal.rs"),
    halves: [3, 1],
    panels: &["lightmaps only", "decal only", "combined scene"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// Which of the two units a panel uses: decals on unit 0, lightmaps on unit 1.
const PANELS: [[bool; 2]; 3] = [[false, true], [true, false], [true, true]];

fn draw(window: &mut Window) {
    let decals = DECALS.map(|name| (name, load_texture(0, window.picture(name), GL_REPEAT)));
    let decals = BTreeMap::from(decals);
    let room: Vec<_> = surfaces()
        .into_iter()
        .map(|surface| (surface, decals[surface.decal], lightmap(&surface)))
        .collect();

    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glActiveTexture(GL_TEXTURE0);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glColor3f(1, 1, 1);

    let width = window.width / 3;
    glMatrixMode(GL_PROJECTION);
    gluPerspective(68, f64::from(width) / f64::from(window.height), 0.1, 40);
    glMatrixMode(GL_MODELVIEW);
    gluLookAt(-0.35, 1.75, -0.3, 0.1, 1.2, -8, 0, 1, 0);

    for (panel, units) in (0..).zip(PANELS) {
        window.panel(3, 1, panel);
        for (unit, used) in (GL_TEXTURE0..).zip(units) {
            glActiveTexture(unit);
            if used { glEnable(GL_TEXTURE_2D) } else { glDisable(GL_TEXTURE_2D) }
        }
        for (surface, decal, lightmap) in &room {
            draw_surface(surface, *decal, *lightmap);
        }
    }
}

fn draw_surface(surface: &Surface, decal: GLuint, lightmap: GLuint) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, decal);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, lightmap);

    let repeat_s = surface.s_edge.length() * surface.density;
    let repeat_t = surface.t_edge.length() * surface.density;
    glBegin(GL_QUADS);
    for (s, t) in [(0., 0.), (1., 0.), (1., 1.), (0., 1.)] {
        let corner = surface.origin + surface.s_edge * s + surface.t_edge * t;
        glMultiTexCoord2f(GL_TEXTURE0, s * repeat_s, t * repeat_t);
        glMultiTexCoord2f(GL_TEXTURE1, s, t);
        glVertex3f(corner.x, corner.y, corner.z);
    }
    glEnd();
}

fn lightmap(surface: &Surface) -> GLuint {
    let light = surface.lightmap();
    let mut texture: GLuint = 0;
    glGenTextures(1, &mut texture);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(
        GL_TEXTURE_2D,
        0,
        GL_RGB8,
        light.width,
        light.height,
        0,
        GL_RGB,
        GL_UNSIGNED_BYTE,
        &light.pixels,
    );
    texture
}
