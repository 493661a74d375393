//! A brick wall, a lawn and the sky of eight polygons: six of a box, and one each.
//!
//! *eScience*, slide 4, "The Quest for Visual Realism (2)"; slides 3 and 5: one colour a polygon does not convince,
//! and a picture on it does. On the left the eight polygons in one colour each, on the right the same eight with
//! textures, whose coordinates outside of [0, 1] repeat the bricks and the grass.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "wall_lawn_sky",
    lecture: "eScience: slide 4, eight polygons",
    source: include_str!("wall_lawn_sky.rs"),
    halves: [4, 2],
    panels: &["eight polygons", "eight polygons, textured"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// A polygon: a corner, the sides along s and t, and how often the texture repeats along them.
type Polygon = ([f64; 3], [f64; 3], [f64; 3], [f64; 2]);

/// The file of a texture, the colour in its place, and the polygons.
type Part = (&'static str, [f64; 3], &'static [Polygon]);

/// Two units of the wall are a picture of bricks.
const SCENE: [Part; 3] = [
    (
        "clouds.ppm",
        [0.55, 0.72, 0.93],
        &[([-50., -3., -20.], [90., 0., 0.], [0., 20., 0.], [2., 1.])],
    ),
    (
        "grass.ppm",
        [0.30, 0.50, 0.16],
        &[([-50., 0., 4.], [90., 0., 0.], [0., 0., -24.], [45., 12.])],
    ),
    (
        "bricks.ppm",
        [0.70, 0.36, 0.26],
        &[
            ([-6., 0., -5.], [9., 0., 0.], [0., 2., 0.], [4.5, 1.]),
            ([3., 0., -6.], [-9., 0., 0.], [0., 2., 0.], [4.5, 1.]),
            ([3., 0., -5.], [0., 0., -1.], [0., 2., 0.], [0.5, 1.]),
            ([-6., 0., -6.], [0., 0., 1.], [0., 2., 0.], [0.5, 1.]),
            ([-6., 2., -5.], [9., 0., 0.], [0., 0., -1.], [4.5, 0.5]),
            ([-6., 0., -6.], [9., 0., 0.], [0., 0., 1.], [4.5, 0.5]),
        ],
    ),
];

fn draw(window: &mut Window) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    let textures = SCENE.map(|(file, ..)| load_texture(0, window.picture(file), GL_REPEAT));
    for panel in 0..2 {
        let aspect = window.panel(2, 1, panel);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        gluPerspective(50, aspect, 0.1, 60);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        gluLookAt(4.2, 1.7, 3.2, -0.6, 1.3, -5, 0, 1, 0);
        if panel == 1 {
            glEnable(GL_TEXTURE_2D);
        }
        let mut polygons = 0;
        for ((_, color, part), texture) in SCENE.iter().zip(textures) {
            glBindTexture(GL_TEXTURE_2D, if panel == 1 { texture } else { 0 });
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
            glColor3d(color[0], color[1], color[2]);
            part.iter().for_each(draw_polygon);
            polygons += part.len();
        }
        window.label(-0.55, 0.92, [0.05, 0.1, 0.3], &format!("polygons: {polygons}"));
    }
}

fn draw_polygon(&(corner, s_side, t_side, repeat): &Polygon) {
    glBegin(GL_POLYGON);
    for (s, t) in [(0., 0.), (1., 0.), (1., 1.), (0., 1.)] {
        glTexCoord2d(s * repeat[0], t * repeat[1]);
        let [x, y, z] = std::array::from_fn(|at| corner[at] + s * s_side[at] + t * t_side[at]);
        glVertex3d(x, y, z);
    }
    glEnd();
}
