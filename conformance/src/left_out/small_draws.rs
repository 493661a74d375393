//! Frames of many small draws, with calls between that change nothing.

use super::scene::SIDE;
use crate::gl::*;
use gl_api::constants::*;

/// So many small triangles in a frame.
const SMALL_DRAWS: usize = 400;

/// Small triangles, each in a draw of its own, with `between` called before each.
fn small_draws(between: impl Fn()) {
    glClear(GL_COLOR_BUFFER_BIT);
    for at in 0..SMALL_DRAWS {
        between();
        let [x, y] = [at % 20, at / 20].map(|c| c as f32 / 10.0 - 0.98);
        glBegin(GL_TRIANGLES);
        glColor3f(1.0, 0.5 + 0.025 * (at % 20) as f32, 0.25);
        glVertex2f(x, y);
        glVertex2f(x + 0.02, y);
        glVertex2f(x, y + 0.02);
        glEnd();
    }
}

/// Small draws with nothing between.
pub(super) fn draw_small() {
    small_draws(|| {});
}

/// Small draws with flags set between that are set already, and off and on again.
pub(super) fn draw_small_with_enables() {
    small_draws(|| {
        glEnable(GL_BLEND);
        glDisable(GL_BLEND);
        glDisable(GL_LIGHTING);
        glDisable(GL_TEXTURE_2D);
    });
}

/// Small draws with state set between to what it is.
pub(super) fn draw_small_with_same_state() {
    small_draws(|| {
        glDepthFunc(GL_LESS);
        glBlendFunc(GL_ONE, GL_ZERO);
        glShadeModel(GL_SMOOTH);
        glCullFace(GL_BACK);
    });
}

/// Small draws with bindings between that are there already.
pub(super) fn draw_small_with_bindings() {
    small_draws(|| {
        glBindTexture(GL_TEXTURE_2D, 0);
        glUseProgram(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glActiveTexture(GL_TEXTURE0);
    });
}

/// Small draws with the identity loaded between.
pub(super) fn draw_small_with_matrices() {
    small_draws(|| {
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
    });
}

/// Small draws with attributes and matrices pushed and popped between.
pub(super) fn draw_small_with_stacks() {
    small_draws(|| {
        glPushAttrib(GL_ENABLE_BIT);
        glPushMatrix();
        glPopMatrix();
        glPopAttrib();
    });
}

/// Small draws with questions between.
pub(super) fn draw_small_with_queries() {
    small_draws(|| {
        glGetError();
        let mut viewport = [0i32; 4];
        glGetIntegerv(GL_VIEWPORT, &mut viewport);
        glIsEnabled(GL_BLEND);
    });
}

/// Small draws with the viewport and the scissor set between to what they are.
pub(super) fn draw_small_with_viewports() {
    small_draws(|| {
        glViewport(0, 0, SIDE, SIDE);
        glScissor(0, 0, SIDE, SIDE);
        glDepthRange(0, 1);
    });
}

/// Small draws with texture matrices loaded between that are there already.
pub(super) fn draw_small_with_texture_matrices() {
    small_draws(|| {
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        glMatrixMode(GL_MODELVIEW);
    });
}

/// Small draws with moves between that take one another back.
pub(super) fn draw_small_with_moves() {
    small_draws(|| {
        glPushMatrix();
        glTranslatef(0.5, 0.25, 0.0);
        glPopMatrix();
    });
}

/// Small draws with all attributes pushed and popped between.
pub(super) fn draw_small_with_all_attributes() {
    small_draws(|| {
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glPopAttrib();
    });
}

/// Small draws with hints between.
pub(super) fn draw_small_with_hints() {
    small_draws(|| {
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST);
        glHint(GL_FOG_HINT, GL_DONT_CARE);
    });
}

/// Small draws with environments and parameters of textures set between to what they are.
pub(super) fn draw_small_with_environments() {
    small_draws(|| {
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE as i32);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR as i32);
        glFogf(GL_FOG_DENSITY, 1.0);
        glAlphaFunc(GL_ALWAYS, 0.0);
    });
}

/// Small draws with the light and the materials of [`lit`] set between.
pub(super) fn draw_small_with_lights() {
    small_draws(|| {
        glLightfv(GL_LIGHT0, GL_POSITION, &[0.3f32, 0.4, 1.0, 0.0]);
        glMaterialfv(GL_FRONT, GL_DIFFUSE, &[0.8f32, 0.5, 0.3, 1.0]);
        glMaterialf(GL_FRONT, GL_SHININESS, 20);
    });
}

/// Uploads the triangles of [`draw_arrays`].
pub(super) fn small_arrays() {
    let corners = |at: usize| {
        let [x, y] = [at % 20, at / 20].map(|c| c as f32 / 10.0 - 0.98);
        [x, y, x + 0.02, y, x, y + 0.02]
    };
    let vertices: Vec<f32> = (0..SMALL_DRAWS).flat_map(corners).collect();
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferData(GL_ARRAY_BUFFER, size_of_val(&vertices[..]), &vertices, GL_STATIC_DRAW);
    small_pointers();
}

/// The arrays of [`small_arrays`].
fn small_pointers() {
    glVertexPointer(2, GL_FLOAT, 0, BUFFER_OFFSET(0));
    glEnableClientState(GL_VERTEX_ARRAY);
}

/// Small draws of arrays, with `between` called before each.
fn array_draws(between: impl Fn()) {
    glClear(GL_COLOR_BUFFER_BIT);
    for at in 0..SMALL_DRAWS as i32 {
        between();
        glDrawArrays(GL_TRIANGLES, 3 * at, 3);
    }
}

/// Small draws of arrays with nothing between.
pub(super) fn draw_arrays() {
    array_draws(|| {});
}

/// Small draws of arrays with the identity loaded between.
pub(super) fn draw_arrays_with_matrices() {
    array_draws(|| {
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
    });
}

/// Small draws of arrays with the arrays set between to what they are.
pub(super) fn draw_arrays_with_pointers() {
    array_draws(small_pointers);
}

/// Small draws of arrays with bindings between that are there already.
pub(super) fn draw_arrays_with_bindings() {
    array_draws(|| {
        glBindBuffer(GL_ARRAY_BUFFER, 1);
        glBindTexture(GL_TEXTURE_2D, 0);
        glUseProgram(0);
    });
}

/// Small draws of arrays with flags set between that are set already, and off and on again.
pub(super) fn draw_arrays_with_enables() {
    array_draws(|| {
        glEnable(GL_BLEND);
        glDisable(GL_BLEND);
        glDisable(GL_LIGHTING);
        glDepthFunc(GL_LESS);
    });
}
