//! What is interpolated: (x, y, z, w, u, v, 1, r, g, b, a), divided by w, and divided again.
//!
//! *eScience*, slides 16 to 22, "Perspective-correct interpolation". From left to right: u and v linear in the
//! window, which is wrong; everything over w and 1/w linear in the window, divided in the fragment shader by
//! hand; and GL's own varyings, which do the same.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "interpolation",
    lecture: "eScience: slides 16 to 22, \"Perspective-correct interpolation\"",
    source: include_str!("interpolation.rs"),
    halves: [6, 2],
    panels: &["u, v linear in the window", "u/w, v/w, 1/w by hand", "GL's varyings"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const VERTEX_SHADER: &str = "\
#version 130
uniform mat4 uProjMatrix;
uniform mat4 uModelViewMatrix;
in vec4 aVertex;
in vec2 aTexCoord;
in vec3 aColor;
noperspective out vec2 vLinear; // u, v
noperspective out vec4 vColorW; // r/w, g/w, b/w, a/w
noperspective out vec3 vOverW;  // u/w, v/w, 1/w
smooth out vec2 vTexCoord;
smooth out vec4 vColor;

void main() {
    gl_Position = uProjMatrix * uModelViewMatrix * aVertex;
    vLinear = aTexCoord;
    vColor = vec4(aColor, 1.0);
    vTexCoord = aTexCoord;
    vOverW = vec3(aTexCoord, 1.0) / gl_Position.w;
    vColorW = vColor / gl_Position.w;
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform int uShow;
noperspective in vec2 vLinear;
noperspective in vec4 vColorW;
noperspective in vec3 vOverW;
smooth in vec2 vTexCoord;
smooth in vec4 vColor;
out vec4 fragColor;

void main() {
    vec2 at = vLinear;
    vec4 color = vColorW / vOverW.z;
    if (uShow == 1) at = vOverW.xy / vOverW.z;
    if (uShow == 2) { at = vTexCoord; color = vColor; }
    fragColor = texture2DLod(uTexUnit0, at, 0.0) * color;
}
";

fn draw(window: &mut Window) {
    glClearColor(0.10, 0.12, 0.16, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    let squares = Picture::paint(256, 256, |x, y| {
        let light = ((x * 8.).floor() + (y * 8.).floor()) % 2.;
        [0.35 + 0.65 * light; 3]
    });
    load_texture(0, squares, GL_CLAMP_TO_EDGE);
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    let mut square = Mesh::plane();
    for (vertex, color) in square.vertices.iter_mut().zip(COLORS) {
        vertex.color = color;
    }
    let square = square.upload();
    for show in 0..3 {
        let aspect = window.panel(3, 1, show);
        let place = translate(0., 0.1, -2.9) * rotate(-58., DVec3::X);
        use_program(program, &perspective(44., aspect, 0.1, 50.), &place);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uShow"), show);
        square.draw(program);
    }
}

/// Of the square's corners.
const COLORS: [[f32; 3]; 4] = [[1.0, 0.3, 0.3], [1.0, 0.9, 0.3], [0.3, 0.5, 1.0], [0.4, 1.0, 0.5]];
