//! Texture coordinates in fixed point: how many bits of a fraction are enough.
//!
//! *Texture Mapping*, slides "Interpolation Operations" ("all floating-point operations") and "Texture Space
//! Mapping" ("could convert (s,t) to fixed-point first"). 14 of a texture's 256 columns fill the picture. With 8 bits
//! (s, t) has a step a texel, and the linear filter shows nothing between two; 12 bits leave 16 places in a texel, which
//! are seen as steps; with 16 bits there are 256, as many as a colour has.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::{Picture, dim};
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "fixed_point",
    lecture: "Texture Mapping: \"Texture Space Mapping\"",
    source: include_str!("fixed_point.rs"),
    halves: [4, 4],
    panels: &[
        "floating point",
        "8 bits: 1/2 texel off",
        "12 bits: 1/32 texel off",
        "16 bits: 1/512 texel off",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const VERTEX_SHADER: &str = "\
#version 130
in vec4 aVertex;
in vec2 aTexCoord;
out vec2 vTexCoord;

void main() {
    vTexCoord = aTexCoord;
    gl_Position = aVertex;
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform float uSteps; // 2 to the power of the bits; 0: floating point
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec2 st = 0.47 + vTexCoord * (14.0 / 256.0);
    if (uSteps > 0.0) st = floor(st * uSteps + 0.5) / uSteps;
    fragColor = textureLod(uTexUnit0, st, 0.0);
}
";

/// Bits of a fraction; 0: floating point.
pub const BITS: [i32; 4] = [0, 8, 12, 16];

fn draw(window: &mut Window) {
    load_texture(0, blobs(), GL_REPEAT);
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    glUseProgram(program);
    safe_glUniform1i(safe_glGetUniformLocation(program, "uTexUnit0"), 0);
    let square = Mesh::plane().upload();
    for (panel, bits) in (0..).zip(BITS) {
        window.panel(2, 2, panel);
        let steps = if bits == 0 { 0. } else { f64::from(1 << bits) };
        safe_glUniform1f(safe_glGetUniformLocation(program, "uSteps"), steps);
        square.draw(program);
    }
}

/// 256 × 256 texels: a checker of colours that the linear filter blends.
fn blobs() -> Picture {
    Picture::paint_centers(256, 256, |x, y| {
        let (i, j) = ((x * 256.) as i64, (y * 256.) as i64);
        let color =
            [[0.95, 0.75, 0.20], [0.12, 0.30, 0.60], [0.80, 0.25, 0.20], [0.90, 0.92, 0.90]];
        dim(color[((i / 2 + 3 * (j / 2)) % 4) as usize], if (i + j) % 2 == 0 { 1. } else { 0.45 })
    })
}
