//! The footprint of a pixel in texture space.
//!
//! *Texture Mapping*, slides "How do we anti-alias textures?" ("approximate footprint as parallelogram; determine
//! this approximate footprint using discrete differences") and "Mipmap LOD Selection" (quads of 2 × 2 pixels, 4
//! subtractions). White: where the pixels' edges are in the texture. Orange: the parallelogram of u10 - u00,
//! v10 - v00, u01 - u00, v01 - v00; blue: that of the derivatives at the first pixel's centre.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use examples::plane_view::PlaneView;
use glam::{DVec2, dvec2};
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "footprint",
    lecture: "Texture Mapping: \"How do we anti-alias textures?\"",
    source: include_str!("footprint.rs"),
    halves: [6, 2],
    panels: &[
        "16 × 16 pixels of a floor, and a quad of four",
        "texture space: the four pixels",
        "the quad: 4 subtractions (orange), derivatives (blue)",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// Pixels of the screen along each side, and the lower left one of the quad.
const PIXELS: f64 = 16.;
const QUAD: DVec2 = dvec2(4., 6.);

/// The view of the floor: its plane y = 0 has texel (x, z).
fn view() -> DMat4 {
    let turned = rotate(32., DVec3::X) * rotate(34., DVec3::Y);
    perspective(46., 1., 0.1, 100.) * turned * translate(-3., -5., -10.)
}

fn draw(window: &mut Window) {
    glClearColor(0.10, 0.11, 0.15, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    let picture = Picture::paint(64, 64, |x, y| {
        let odd = ((x * 8.).floor() + (y * 8.).floor()) % 2. == 1.;
        if odd { [0.30, 0.36, 0.44] } else { [0.52, 0.50, 0.46] }
    });
    load_texture(0, picture, GL_REPEAT);
    let dot = (window.height as f32 / 256.).max(1.);
    glLineWidth(dot);
    glPointSize(4. * dot);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    let of = PlaneView::new(&view(), [PIXELS, PIXELS]);
    let square = |at: DVec2| [at, at + DVec2::X, at + DVec2::ONE, at + DVec2::Y];
    let quad = square(QUAD);

    window.panel(3, 1, 0);
    load(&view());
    floor();
    load(&(translate(-1., -1., 0.) * DMat4::from_scale(DVec3::splat(2. / PIXELS))));
    for line in 0..=16 {
        let at = f64::from(line);
        outline(
            GL_LINES,
            [0.75; 3],
            &[dvec2(at, 0.), dvec2(at, PIXELS), dvec2(0., at), dvec2(PIXELS, at)],
        );
    }
    quad.iter().for_each(|&at| outline(GL_LINE_LOOP, [1., 0.9, 0.3], &square(at)));

    let center = of.point(QUAD + DVec2::ONE);
    for (panel, across) in [(1, 7.), (2, 2.6)] {
        window.panel(3, 1, panel);
        let flat =
            DMat4::from_scale(DVec3::splat(2. / across)) * translate(-center.x, -center.y, 0.);
        load(&(flat * rotate(90., DVec3::X)));
        floor();
        load(&flat);
        for at in quad {
            outline(GL_LINE_LOOP, [1.; 3], &square(at).map(|corner| of.point(corner)));
        }
        let [p00, p10, _, p01] = quad.map(|at| of.point(at + 0.5));
        parallelogram([1., 0.6, 0.2], p00, [p10 - p00, p01 - p00]);
        parallelogram([0.4, 0.7, 1.], p00, of.derivatives(QUAD + 0.5));
        outline(GL_LINES, [1., 0.6, 0.2], &[p00, p10, p00, p01]);
        if panel == 2 {
            let [x, y] = [p10 - p00, p01 - p00];
            let [dx, dy] = of.derivatives(QUAD + 0.5);
            let row = |d: DVec2| format!("u {:+.2} v {:+.2}", d.x, d.y);
            let texts = [row(x), row(dx), row(y), row(dy)];
            let [x, dx, y, dy] = texts;
            window.caption(
                0.67,
                0.83,
                format!("10 - 00: {x}\nd/dx: {dx}\n01 - 00: {y}\nd/dy: {dy}"),
            );
        }
        outline(GL_POINTS, [1., 1., 0.6], &quad.map(|at| of.point(at + 0.5)));
    }
}

fn load(matrix: &DMat4) {
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(&matrix.to_cols_array());
}

/// The floor, whose picture has eight checks, each of which stands for a texel.
fn floor() {
    glEnable(GL_TEXTURE_2D);
    glBegin(GL_QUADS);
    for (x, z) in [(-64., 64.), (64., 64.), (64., -64.), (-64., -64.)] {
        glTexCoord2f(0.125 * x, 0.125 * z);
        glVertex3f(x, 0, z);
    }
    glEnd();
    glDisable(GL_TEXTURE_2D);
}

fn parallelogram(color: [f64; 3], center: DVec2, [x, y]: [DVec2; 2]) {
    let corners = [-x - y, x - y, x + y, y - x].map(|corner| center + corner / 2.);
    outline(GL_LINE_LOOP, color, &corners);
}

fn outline(mode: GLenum, [r, g, b]: [f64; 3], points: &[DVec2]) {
    glColor3f(r, g, b);
    glBegin(mode);
    points.iter().for_each(|at| glVertex2f(at.x, at.y));
    glEnd();
}
