//! Explicit UV: each corner of a model names its place in the picture.
//!
//! *TA 6*, "Explicit UV". A die: on the left its texture, six faces laid out as a cross, with the seams of the
//! model drawn over it; on the right the cube whose corners carry these coordinates.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::{Picture, disc};
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "explicit_uv",
    lecture: "TA 6: \"Explicit UV\"",
    source: include_str!("explicit_uv.rs"),
    halves: [4, 2],
    panels: &["the unfolded die", "folded"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// Of each face: outward, to the right of its picture, and its cell of 4 × 3.
const FACES: [([i32; 3], [i32; 3], [i32; 2]); 6] = [
    ([0, 0, 1], [1, 0, 0], [1, 1]),
    ([1, 0, 0], [0, 0, -1], [2, 1]),
    ([0, 0, -1], [-1, 0, 0], [3, 1]),
    ([-1, 0, 0], [0, 0, 1], [0, 1]),
    ([0, 1, 0], [1, 0, 0], [1, 2]),
    ([0, -1, 0], [1, 0, 0], [1, 0]),
];

/// Where the pips of each face are, in thirds.
const PIPS: [&[(i32, i32)]; 6] = [
    &[(1, 1)],
    &[(0, 0), (2, 2)],
    &[(0, 0), (0, 1), (0, 2), (2, 0), (2, 1), (2, 2)],
    &[(0, 0), (0, 2), (2, 0), (2, 2), (1, 1)],
    &[(0, 0), (1, 1), (2, 2)],
    &[(0, 0), (0, 2), (2, 0), (2, 2)],
];

fn draw(window: &mut Window) {
    glClearColor(0.90, 0.89, 0.86, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    let die = load_texture(0, atlas(), GL_CLAMP_TO_EDGE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    window.panel(2, 1, 0);
    glEnable(GL_TEXTURE_2D);
    for (_, _, cell) in FACES {
        draw_corners(GL_QUADS, |(s, t)| {
            glTexCoord2fv(&uv(cell, s, t).map(|at| at as f32));
            place(uv(cell, s, t));
        });
    }
    glBindTexture(GL_TEXTURE_2D, 0);
    glDisable(GL_TEXTURE_2D);
    glColor3f(0.8, 0.2, 0.2);
    for (_, _, cell) in FACES {
        draw_corners(GL_LINE_LOOP, |(s, t)| place(uv(cell, s, t)));
    }

    glBindTexture(GL_TEXTURE_2D, die);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_DEPTH_TEST);
    let aspect = window.panel(2, 1, 1);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(36, aspect, 0.1, 50);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0, -5.6);
    glRotatef(28, 1, 0, 0);
    glRotatef(-34, 0, 1, 0);
    for (out, right, cell) in FACES {
        let [out, right] = [out, right].map(|v| dvec3(v[0].into(), v[1].into(), v[2].into()));
        let up = out.cross(right);
        draw_corners(GL_QUADS, |(s, t)| {
            let [u, v] = uv(cell, s, t);
            glTexCoord2f(u, v);
            let at = out + right * (2. * s - 1.) + up * (2. * t - 1.);
            glVertex3f(at.x, at.y, at.z);
        });
    }
}

/// A place of the picture in the window.
fn place([u, v]: [f64; 2]) {
    glVertex2f(1.8 * u - 0.9, 1.35 * v - 0.675);
}

/// A place of a face in the picture.
fn uv(cell: [i32; 2], s: f64, t: f64) -> [f64; 2] {
    [(f64::from(cell[0]) + s) / 4., (f64::from(cell[1]) + t) / 3.]
}

fn draw_corners(mode: GLenum, corner: impl FnMut((f64, f64))) {
    glBegin(mode);
    [(0., 0.), (1., 0.), (1., 1.), (0., 1.)].into_iter().for_each(corner);
    glEnd();
}

/// The six faces; rows count from the top.
fn atlas() -> Picture {
    Picture::paint(512, 384, |x, y| {
        let (x, y) = (4. * x, 3. * (1. - y));
        let face = FACES.iter().position(|(_, _, c)| c.map(f64::from) == [x.floor(), y.floor()]);
        let Some(face) = face else { return [0.75, 0.75, 0.72] };
        let (s, t) = (x.fract(), y.fract());
        let pip = |(i, j): &(i32, i32)| {
            disc(s, t, 0.26 + 0.24 * f64::from(*i), 0.26 + 0.24 * f64::from(*j), 0.085)
        };
        if PIPS[face].iter().any(pip) {
            [0.12, 0.12, 0.20]
        } else {
            [0.97 - 0.02 * face as f64, 0.93, 0.82 + 0.03 * face as f64]
        }
    })
}
