//! Two measures of a footprint: the lecture's ρ and OpenGL's.
//!
//! *Texture Mapping*, slide "Mipmap LOD Selection", prints the larger of |(du/dx, du/dy)| and |(dv/dx, dv/dy)|;
//! OpenGL 2.1, equation 3.20, has the larger of |(du/dx, dv/dx)| and |(du/dy, dv/dy)|: the rows or the columns of
//! one matrix. They differ by a factor of √2 at most, half a level. λ is that of a floor with a texel a unit, a
//! band a half level.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "rho_measures",
    lecture: "Texture Mapping: \"Mipmap LOD Selection\"",
    source: include_str!("rho_measures.rs"),
    halves: [6, 2],
    panels: &[
        "λ of the lecture's ρ: max over u and v",
        "λ of OpenGL's ρ: max over x and y",
        "difference: red +1/2, blue -1/2",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const VERTEX_SHADER: &str = "\
#version 130
out vec2 vTexel;

void main() {
    vTexel = gl_MultiTexCoord0.st;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform int uShow; // 0: the lecture's, 1: OpenGL's, 2: their difference
in vec2 vTexel;
out vec4 fragColor;

void main() {
    vec2 x = dFdx(vTexel), y = dFdy(vTexel);
    float lecture = log2(max(length(vec2(x.s, y.s)), length(vec2(x.t, y.t))));
    float opengl = log2(max(length(x), length(y)));
    float level = uShow == 0 ? lecture : opengl;
    vec3 color = mix(vec3(0.10, 0.16, 0.35), vec3(1.0, 0.85, 0.45), clamp((level + 1.0) / 6.0, 0.0, 1.0));
    color *= 0.8 + 0.2 * step(0.5, fract(level));
    float d = lecture - opengl;
    if (uShow == 2) color = d > 0.0 ? vec3(1.0, 1.0 - 2.0 * d, 1.0 - 2.0 * d) : vec3(1.0 + 2.0 * d, 1.0 + 2.0 * d, 1.0);
    fragColor = vec4(color, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.10, 0.11, 0.15, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    glUseProgram(program);
    // As many texels a pixel in every size of the picture.
    let texels = f64::from(window.height) / 16.;
    for show in 0..3 {
        let aspect = window.panel(3, 1, show);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uShow"), show);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        gluPerspective(46, aspect, 0.1, 200);
        glRotatef(32, 1, 0, 0);
        glRotatef(34, 0, 1, 0);
        glBegin(GL_QUADS);
        for (x, z) in [(-99., 99.), (99., 99.), (99., -99.), (-99., -99.)] {
            glTexCoord2f(texels * x, texels * z);
            glVertex3f(x, -5, z);
        }
        glEnd();
    }
}
