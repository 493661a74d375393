//! The bilinear formula, written out in a shader beside GL_LINEAR.
//!
//! *Texture Mapping*, "Bilinear interpolation"; *TA 6*, "Bilinear filtering". From left to right: GL's filter;
//! the mean of four texels by hand, (1-a)(1-b) t00 + a (1-b) t10 + (1-a) b t01 + a b t11; and four million times
//! their difference, which is the rounding of the last bit.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "bilinear_formula",
    lecture: "Texture Mapping: \"Bilinear interpolation\"",
    source: include_str!("bilinear_formula.rs"),
    halves: [6, 2],
    panels: &["GL_LINEAR", "the formula, by hand", "difference × 4 million"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform int uShow; // 0: GL, 1: by hand, 2: the difference
in vec2 vTexCoord;
out vec4 fragColor;

vec3 byHand(vec2 st) {
    vec2 size = vec2(textureSize(uTexUnit0, 0));
    vec2 uv = st * size - 0.5; // texel centres lie at whole numbers
    ivec2 i = ivec2(floor(uv));
    vec2 ab = fract(uv);
    ivec2 last = ivec2(size) - 1;
    ivec2 low = clamp(i, ivec2(0), last);
    ivec2 high = clamp(i + 1, ivec2(0), last);
    vec3 t00 = texelFetch(uTexUnit0, low, 0).rgb;
    vec3 t10 = texelFetch(uTexUnit0, ivec2(high.x, low.y), 0).rgb;
    vec3 t01 = texelFetch(uTexUnit0, ivec2(low.x, high.y), 0).rgb;
    vec3 t11 = texelFetch(uTexUnit0, high, 0).rgb;
    return (1.0 - ab.x) * (1.0 - ab.y) * t00 + ab.x * (1.0 - ab.y) * t10
        + (1.0 - ab.x) * ab.y * t01 + ab.x * ab.y * t11;
}

void main() {
    vec3 filtered = texture2D(uTexUnit0, vTexCoord).rgb;
    vec3 color = filtered;
    if (uShow == 1) color = byHand(vTexCoord);
    if (uShow == 2) color = 4.0e6 * abs(filtered - byHand(vTexCoord));
    fragColor = vec4(color, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.10, 0.12, 0.16, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    // Eight texels a side, so that each can be seen.
    let texels = Picture::paint_centers(8, 8, |x, y| {
        let ring = ((x - 0.5).abs().max((y - 0.5).abs()) * 8.).floor() % 2.;
        [0.25 + 0.75 * ring * x, 0.2 + 0.6 * ring, 0.9 - 0.8 * y * ring]
    });
    load_texture(0, texels, GL_CLAMP_TO_EDGE);
    set_filter(GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let square = Mesh::plane().upload();
    for show in 0..3 {
        window.panel(3, 1, show);
        use_program(program, &DMat4::IDENTITY, &DMat4::from_scale(DVec3::splat(0.94)));
        safe_glUniform1i(safe_glGetUniformLocation(program, "uShow"), show);
        square.draw(program);
    }
}
