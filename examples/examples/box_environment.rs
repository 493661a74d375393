//! A box-shaped environment: six pictures on the sides of a cube around the scene.
//!
//! *eScience*, slides 31 and 32, "Environment mapping". On the left the six faces, unfolded as a cross; on the
//! right a mirror inside the box: each bounced view vector leaves through one face, at
//! (s_c / |m_a| + 1) / 2, (t_c / |m_a| + 1) / 2.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "box_environment",
    lecture: "eScience: slides 31 and 32, \"Environment mapping\"",
    source: include_str!("box_environment.rs"),
    halves: [4, 2],
    panels: &["six faces, unfolded", "a mirror in the box"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform samplerCube uTexUnit0;
uniform int uMirror;
in vec3 vPosition;
in vec3 vNormal;
out vec4 fragColor;

void main() {
    vec3 v = normalize(vPosition);
    fragColor = textureCube(uTexUnit0, uMirror == 1 ? reflect(v, normalize(vNormal)) : v);
}
";

/// Column and row of each face in the cross, in the order +X, -X, +Y, -Y, +Z, -Z.
const CROSS: [[i32; 2]; 6] = [[2, 1], [0, 1], [1, 2], [1, 0], [3, 1], [1, 1]];

fn draw(window: &mut Window) {
    glClearColor(0.10, 0.12, 0.16, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    load_cube_map(window);

    // Each face through the direction of its corners: straight ahead is -Z.
    window.panel(2, 1, 0);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_CUBE_MAP);
    for (face, [column, row]) in CROSS.into_iter().enumerate() {
        glBegin(GL_QUADS);
        for (s, t) in [(-1., -1.), (1., -1.), (1., 1.), (-1., 1.)] {
            let [x, y, z] = match face {
                0 => [1., t, s],
                1 => [-1., t, -s],
                2 => [s, 1., t],
                3 => [s, -1., -t],
                4 => [-s, t, 1.],
                _ => [s, t, -1.],
            };
            glTexCoord3f(x, y, z);
            let place = |at: i32, size: i32, t: f64| {
                1.9 * ((f64::from(at) + 0.5 * t + 0.5) / 4. - f64::from(size) / 8.)
            };
            glVertex2f(place(column, 4, s), place(row, 3, t));
        }
        glEnd();
    }
    glDisable(GL_TEXTURE_CUBE_MAP);

    let aspect = window.panel(2, 1, 1);
    let projection = perspective(58., aspect, 0.1, 50.);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let mirror = |program, on| safe_glUniform1i(safe_glGetUniformLocation(program, "uMirror"), on);
    use_program(program, &projection, &DMat4::from_scale(DVec3::splat(20.)));
    mirror(program, 0);
    Mesh::cube().upload().draw(program);
    glEnable(GL_DEPTH_TEST);
    use_program(program, &projection, &translate(0., 0., -2.6));
    mirror(program, 1);
    Mesh::sphere().upload().draw(program);
}
