//! Affine against perspective-correct interpolation: the same wall twice.
//!
//! *eScience*, slides 16 to 22; *Texture Mapping*, "Interpolation in OpenGL". On the left the texture
//! coordinates vary linearly over the window (`noperspective`), and each triangle bends the bricks its own
//! way; on the right u/w, v/w and 1/w do, and each fragment divides.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "perspective_correct",
    lecture: "eScience: slides 16 to 22, \"Perspective Correction\"",
    source: include_str!("perspective_correct.rs"),
    halves: [4, 2],
    panels: &["linear in the window", "perspective-correct"],
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
noperspective out vec2 vAffine;
smooth out vec2 vCorrect;

void main() {
    vAffine = aTexCoord;
    vCorrect = aTexCoord;
    gl_Position = uProjMatrix * uModelViewMatrix * aVertex;
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform float uCorrect;
noperspective in vec2 vAffine;
smooth in vec2 vCorrect;
out vec4 fragColor;

void main() {
    fragColor = texture2D(uTexUnit0, mix(vAffine, vCorrect, uCorrect));
}
";

fn draw(window: &mut Window) {
    glClearColor(0.08, 0.09, 0.11, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    load_texture(0, window.picture("bricks.ppm"), GL_REPEAT);
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    let wall = Mesh::plane().upload();
    for (panel, correct) in [(0, 0.), (1, 1.)] {
        let aspect = window.panel(2, 1, panel);
        let turned = translate(0.25, 0., -2.15) * rotate(58., DVec3::Y);
        use_program(program, &perspective(58., aspect, 0.1, 50.), &turned);
        safe_glUniform1f(safe_glGetUniformLocation(program, "uCorrect"), correct);
        wall.draw(program);
    }
}
