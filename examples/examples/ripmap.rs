//! Anisotropic prefiltering, as a ripmap: the texture downsampled on each axis independently.
//!
//! *TA 6*, "Anisotropic Filtering". From left to right: the mip pyramid; a ripmap, all of whose 7 × 7 levels are
//! in its sky; a summed-area table (Crow 1984); and GL's anisotropic filter, which needs only the pyramid.
//! Above the floor lies along the texture's axes, where a ripmap is as sharp as the others; below it is turned
//! by 45 degrees, where a rectangle along the axes is too large, and only the last follows the footprint.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use examples::tables::{load_table, ripmap, sums, texels};
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "ripmap",
    lecture: "TA 6: \"Anisotropic Filtering\", each axis independently",
    source: include_str!("ripmap.rs"),
    halves: [8, 3],
    panels: &[
        "mipmap",
        "ripmap",
        "summed areas",
        "anisotropic 16",
        "mipmap, 45°",
        "ripmap, 45°",
        "summed areas, 45°",
        "anisotropic 16, 45°",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0; // with its pyramid
uniform sampler2D uTexUnit1; // the ripmap, 128 x 128
uniform sampler2D uTexUnit2; // the sums of all texels to the left and below
uniform int uShow;           // 1: ripmap, 2: summed area, else as GL filters
in vec2 vTexCoord;
out vec4 fragColor;

// Bilinear in the level that is halved so often along each axis.
vec3 level(ivec2 halved) {
    ivec2 size = ivec2(64 >> halved.x, 64 >> halved.y), first = 128 - 2 * size;
    vec2 at = fract(vTexCoord) * vec2(size) - 0.5, part = fract(at);
    ivec2 low = (ivec2(floor(at)) + size) % size, high = (low + 1) % size;
    vec3 a = texelFetch(uTexUnit1, first + low, 0).rgb;
    vec3 b = texelFetch(uTexUnit1, first + ivec2(high.x, low.y), 0).rgb;
    vec3 c = texelFetch(uTexUnit1, first + ivec2(low.x, high.y), 0).rgb;
    vec3 d = texelFetch(uTexUnit1, first + high, 0).rgb;
    return mix(mix(a, b, part.x), mix(c, d, part.x), part.y);
}

// Four levels: 16 texels and 15 interpolations.
vec3 ripmap(vec2 size) {
    vec2 lambda = clamp(log2(size), 0.0, 6.0), part = fract(lambda);
    ivec2 near = ivec2(lambda), far = min(near + 1, 6);
    vec3 low = mix(level(near), level(ivec2(far.x, near.y)), part.x);
    return mix(low, mix(level(ivec2(near.x, far.y)), level(far), part.x), part.y);
}

vec3 sum(vec2 xy) {
    vec2 whole = floor(xy / 64.0), part = xy - 64.0 * whole;
    vec3 total = texture2DLod(uTexUnit2, vec2(64.5) / 65.0, 0.0).rgb;
    vec3 right = texture2DLod(uTexUnit2, vec2(64.5, part.y + 0.5) / 65.0, 0.0).rgb;
    vec3 top = texture2DLod(uTexUnit2, vec2(part.x + 0.5, 64.5) / 65.0, 0.0).rgb;
    vec3 rest = texture2DLod(uTexUnit2, (part + 0.5) / 65.0, 0.0).rgb;
    return whole.x * whole.y * total + whole.x * right + whole.y * top + rest;
}

void main() {
    vec3 color = texture2D(uTexUnit0, vTexCoord).rgb;
    vec2 size = 64.0 * (abs(dFdx(vTexCoord)) + abs(dFdy(vTexCoord)));
    vec2 low = 64.0 * fract(vTexCoord) - 0.5 * size + 64.0, high = low + size;
    vec3 area = sum(high) - sum(vec2(low.x, high.y)) - sum(vec2(high.x, low.y)) + sum(low);
    if (uShow == 1) color = ripmap(size);
    if (uShow == 2) color = area / (size.x * size.y);
    fragColor = vec4(color, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.55, 0.68, 0.85, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    let tiles = Picture::paint(64, 64, |x, y| {
        let line = (x * 2.).fract().min((y * 2.).fract()) < 0.14;
        let odd = (x * 2.).floor() + (y * 2.).floor() == 1.;
        if line { [0.95; 3] } else { [0.10 + 0.5 * f64::from(odd), 0.15, 0.40] }
    });
    let texels = texels(&tiles);
    let ripmap = load_table(1, 128, &ripmap(&texels));
    load_table(2, 65, &sums(&texels));
    load_texture(0, tiles, GL_REPEAT);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let floor = rotate(-90., DVec3::X) * DMat4::from_scale(DVec3::splat(60.));
    let floor = Mesh::plane().moved(floor).tiled(60., 60.).upload();
    for panel in 0..8 {
        let aspect = window.panel(4, 2, panel);
        let probes = if panel % 4 == 3 { 16 } else { 1 };
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, probes);
        let turn = if panel < 4 { 0. } else { 45. };
        let place = translate(0., -1., 0.) * rotate(turn, DVec3::Y);
        use_program(program, &perspective(60., aspect, 0.1, 200.), &place);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uShow"), panel % 4);
        floor.draw(program);
    }
    let [x, y] = [window.width / 4, window.height * 3 / 4];
    glViewport(x, y, window.width / 4, window.height / 4);
    show_flat(ripmap);
}
