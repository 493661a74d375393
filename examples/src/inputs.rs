//! The inputs of a picture, shown beside its result: textures lie flat, cube maps unfolded.

use crate::window::Window;
use gl_api::constants::*;
use gl_api::types::{GLint, GLuint};
use gl_api::*;

/// Turns to the fixed function with a texture target of unit 0, and one unit a pixel's width of the
/// viewport, whose width and height it returns.
fn begin(target: u32, texture: GLuint) -> [f64; 2] {
    let mut viewport: [GLint; 4] = [0; 4];
    glGetIntegerv(GL_VIEWPORT, &mut viewport);
    let [_, _, width, height] = viewport.map(f64::from);
    glPushAttrib(GL_ENABLE_BIT | GL_TEXTURE_BIT);
    glUseProgram(0);
    for capability in [GL_LIGHTING, GL_DEPTH_TEST] {
        glDisable(capability);
    }
    glActiveTexture(GL_TEXTURE0);
    glEnable(target);
    glBindTexture(target, texture);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-width / 2., width / 2., -height / 2., height / 2., -1, 1);
    [width, height]
}

/// Draws a texture flat in the middle of the viewport, as a square with a margin.
pub fn show_flat(texture: GLuint) {
    show_flat_tiled(texture, 1.);
}

/// [`show_flat`] with the unit square of coordinates `times` over.
pub fn show_flat_tiled(texture: GLuint, times: f64) {
    let [width, height] = begin(GL_TEXTURE_2D, texture);
    let half = 0.42 * width.min(height);
    let up = 0.05 * height;
    glBegin(GL_QUADS);
    for (s, t) in [(0., 0.), (1., 0.), (1., 1.), (0., 1.)] {
        glTexCoord2f(s * times, t * times);
        glVertex2f((2. * s - 1.) * half, up + (2. * t - 1.) * half);
    }
    glEnd();
    glPopAttrib();
}

/// A face of a cube seen from inside: its name, its place in the unfolded cube (columns from the left, rows
/// from the bottom), and the directions toward it, to its right and up.
type Face = (&'static str, [f64; 2], [[f64; 3]; 3]);

const FACES: [Face; 6] = [
    ("-X", [0., 1.], [[-1., 0., 0.], [0., 0., -1.], [0., 1., 0.]]),
    ("-Z", [1., 1.], [[0., 0., -1.], [1., 0., 0.], [0., 1., 0.]]),
    ("+X", [2., 1.], [[1., 0., 0.], [0., 0., 1.], [0., 1., 0.]]),
    ("+Z", [3., 1.], [[0., 0., 1.], [-1., 0., 0.], [0., 1., 0.]]),
    ("+Y", [1., 2.], [[0., 1., 0.], [1., 0., 0.], [0., 0., 1.]]),
    ("-Y", [1., 0.], [[0., -1., 0.], [1., 0., 0.], [0., 0., -1.]]),
];

/// Draws a cube map unfolded in the viewport, as it is seen from inside, with the names of its faces.
pub fn show_unfolded(window: &mut Window, cube: GLuint) {
    let [width, height] = begin(GL_TEXTURE_CUBE_MAP, cube);
    let side = (0.95 * width / 4.).min(0.84 * height / 3.);
    let mut viewport: [GLint; 4] = [0; 4];
    glGetIntegerv(GL_VIEWPORT, &mut viewport);
    let [left, bottom, ..] = viewport.map(f64::from);
    for (name, [column, row], [toward, right, up]) in FACES {
        let (x, y) = ((column - 2.) * side, (row - 1.5) * side + 0.06 * height);
        glBegin(GL_QUADS);
        for (s, t) in [(0., 0.), (1., 0.), (1., 1.), (0., 1.)] {
            let at = |c: usize| toward[c] + (2. * s - 1.) * right[c] + (2. * t - 1.) * up[c];
            glTexCoord3f(at(0), at(1), at(2));
            glVertex2f(x + s * 0.98 * side, y + t * 0.98 * side);
        }
        glEnd();
        let (x, y) = (left + width / 2. + x, bottom + height / 2. + y);
        window.caption(x / f64::from(window.width), y / f64::from(window.height), name);
    }
    glPopAttrib();
}
