//! Prefiltering: the mean over a pixel's footprint from tables made before.
//!
//! *eScience*, slides 10 to 15, "Antialiasing"; *Texture Mapping*, "How do we anti-alias textures?". Above: one
//! point a pixel; the mip pyramid (Williams 1983), whose squares are too large for a slanted footprint. Below:
//! a summed-area table (Crow 1984), whose rectangles follow the texture's axes; and a row of looks into the
//! pyramid along the footprint's longer side (anisotropic).
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use examples::tables::{load_table, sums, texels};
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "prefiltering",
    lecture: "eScience: slides 10 to 15, \"Antialiasing\": prefiltering",
    source: include_str!("prefiltering.rs"),
    halves: [3, 3],
    panels: &["one point", "mip pyramid", "summed areas", "anisotropic"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0; // with its pyramid
uniform sampler2D uTexUnit1; // the sums of all texels to the left and below
uniform int uShow;           // 0: point, 2: summed area, else as GL filters
in vec2 vTexCoord;
out vec4 fragColor;

// The sum over (0, 0) to (x, y) in texels; the table repeats with its total.
vec3 sum(vec2 xy) {
    vec2 whole = floor(xy / 64.0), part = xy - 64.0 * whole;
    vec3 total = texture2DLod(uTexUnit1, vec2(64.5) / 65.0, 0.0).rgb;
    vec3 right = texture2DLod(uTexUnit1, vec2(64.5, part.y + 0.5) / 65.0, 0.0).rgb;
    vec3 top = texture2DLod(uTexUnit1, vec2(part.x + 0.5, 64.5) / 65.0, 0.0).rgb;
    vec3 rest = texture2DLod(uTexUnit1, (part + 0.5) / 65.0, 0.0).rgb;
    return whole.x * whole.y * total + whole.x * right + whole.y * top + rest;
}

void main() {
    vec3 filtered = texture2D(uTexUnit0, vTexCoord).rgb;
    vec2 size = 64.0 * (abs(dFdx(vTexCoord)) + abs(dFdy(vTexCoord)));
    vec2 low = 64.0 * fract(vTexCoord) - 0.5 * size + 64.0, high = low + size;
    vec3 area = sum(high) - sum(vec2(low.x, high.y)) - sum(vec2(high.x, low.y)) + sum(low);
    if (uShow == 0) filtered = texture2DLod(uTexUnit0, vTexCoord, 0.0).rgb;
    if (uShow == 2) filtered = area / (size.x * size.y);
    fragColor = vec4(filtered, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.55, 0.68, 0.85, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    let checkers = Picture::paint(64, 64, |x, y| {
        let dark = ((x * 2.).floor() + (y * 2.).floor()) % 2.;
        if dark == 0. { [0.97; 3] } else { [0.08, 0.10, 0.35] }
    });
    load_table(1, 65, &sums(&texels(&checkers)));
    load_texture(0, checkers, GL_REPEAT);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let floor = rotate(-90., DVec3::X) * DMat4::from_scale(DVec3::splat(40.));
    let floor = Mesh::plane().moved(floor).tiled(40., 40.).upload();
    for (show, probes) in [(0, 1), (1, 1), (2, 1), (3, 16)] {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, probes);
        let aspect = window.panel(2, 2, show);
        let place = translate(0., -1., 0.) * rotate(25., DVec3::Y);
        use_program(program, &perspective(60., aspect, 0.1, 200.), &place);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uShow"), show);
        floor.draw(program);
    }
}
