//! Bicubic patches: (u, v) gives (x, y, z), and (s, t) with it.
//!
//! *Texture Mapping*, slides "Texture mapping" (Catmull 1974, refined by Blinn and Newell 1976), "Source of
//! texture coordinates?" and "Implementing texture mapping": "if the surface moves/deforms, the texture goes with
//! it". All by OpenGL's evaluators: one map of 4 × 4 points for the position, one of 2 × 2 for the coordinates.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::teapot::{Patch, teapot};
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "bicubic_patch",
    lecture: "Texture Mapping: \"Source of texture coordinates?\"",
    source: include_str!("bicubic_patch.rs"),
    halves: [6, 4],
    panels: &[
        "a patch: 16 control points",
        "Catmull 1974: 1, 4, 16, 64 pieces, until they are small",
        "(u, v) -> (x, y, z) and (s, t)",
        "moved and deformed: the texture goes with it",
        "Newell's teapot: 28 patches",
        "Blinn and Newell 1976: textured",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

fn draw(window: &mut Window) {
    glClearColor(0.09, 0.10, 0.14, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for capability in [GL_DEPTH_TEST, GL_LIGHT0, GL_AUTO_NORMAL, GL_NORMALIZE] {
        glEnable(capability);
    }
    for map in [GL_MAP2_VERTEX_3, GL_MAP2_TEXTURE_COORD_2] {
        glEnable(map);
    }
    // glEvalMesh2 goes clockwise around what du × dv points away from (GL 2.1, section 5.1).
    glFrontFace(GL_CW);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, &[0.66, 0.64, 0.60, 1.]);
    let picture = load_texture(0, window.picture("slide.ppm"), GL_REPEAT);
    let bent = Patch::sheet([
        [0.1, 0.9, 0.3, -0.2],
        [0.5, 1.4, 0.6, 0.2],
        [0.2, 0.7, -0.3, 0.3],
        [0.0, 0.2, 0.5, 0.9],
    ]);
    let wave = Patch::sheet([
        [1.3, 0.1, -0.6, 0.5],
        [-1.2, 0.9, 0.9, -0.8],
        [1.1, -0.9, 1.5, 0.3],
        [-0.3, 0.5, -1.0, 1.4],
    ]);

    glBindTexture(GL_TEXTURE_2D, 0);
    look(window, 0, 5.8);
    let dot = (window.height as f32 / 512.).max(1.);
    glLineWidth(dot);
    glPointSize(5. * dot);
    net(&bent);
    bent.evaluate(12, GL_LINE);

    let [width, height] = [window.width / 3, window.height / 2];
    look(window, 1, 5.8);
    glEnable(GL_LIGHTING);
    glShadeModel(GL_FLAT);
    for (at, pieces) in [(0, 1), (1, 2), (2, 4), (3, 8)] {
        let (x, y) = (width + at % 2 * width / 2, 2 * height - (at / 2 + 1) * height / 2);
        glViewport(x, y, width / 2, height / 2);
        bent.evaluate(pieces, GL_FILL);
    }
    glShadeModel(GL_SMOOTH);

    glBindTexture(GL_TEXTURE_2D, picture);
    glEnable(GL_TEXTURE_2D);
    look(window, 2, 5.8);
    bent.evaluate(24, GL_FILL);
    look(window, 3, 5.8);
    glRotatef(35, 0, 1, 0);
    wave.evaluate(24, GL_FILL);
    for (panel, textured) in [(4, GL_FALSE), (5, GL_TRUE)] {
        look(window, panel, 9.6);
        if textured == GL_TRUE {
            glEnable(GL_TEXTURE_2D);
            glBindTexture(GL_TEXTURE_2D, picture);
        } else {
            glDisable(GL_TEXTURE_2D);
            glBindTexture(GL_TEXTURE_2D, 0);
        }
        teapot().iter().for_each(|patch| patch.evaluate(24, GL_FILL));
    }
}

/// Chooses a panel, and looks at the origin from above.
fn look(window: &mut Window, panel: i32, distance: f64) {
    let aspect = window.panel(3, 2, panel);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(36, aspect, 0.1, 50);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glLightfv(GL_LIGHT0, GL_POSITION, &[-1., 2., 2., 0.]);
    gluLookAt(0.12 * distance, 0.5 * distance, distance, 0, 0, 0, 0, 1, 0);
}

/// Draws the control points of a patch and the lines between them.
fn net(patch: &Patch) {
    glColor3f(0.95, 0.6, 0.2);
    for row in 0..4 {
        glBegin(GL_LINE_STRIP);
        patch.points[row].iter().for_each(|p| glVertex3f(p.x, p.y, p.z));
        glEnd();
        glBegin(GL_LINE_STRIP);
        patch
            .points
            .iter()
            .for_each(|of_row| glVertex3f(of_row[row].x, of_row[row].y, of_row[row].z));
        glEnd();
    }
    glBegin(GL_POINTS);
    patch.points.as_flattened().iter().for_each(|p| glVertex3f(p.x, p.y, p.z));
    glEnd();
    glColor3f(0.6, 0.75, 1.0);
}
