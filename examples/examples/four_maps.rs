//! Four maps of one wall: albedo, specular, height and normal; and what each adds.
//!
//! *TA 6*, "Some Types of Textures". Above and at the lower left the maps as they are stored: colours; how much of
//! the highlight a point mirrors; how high it is, white above black; and its normal, n/2 + 0.5, made from the
//! heights. Then the wall in the light of a lamp: with the albedo alone, on a flat face, and with all four: the
//! normal turns the light, the specular map shares out the highlight, and the height moves the coordinates
//! along the view, so that what is deep is hidden behind what is high (parallax).
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::normals::normal_map;
use examples::picture::{Picture, packed_pixel_t};
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "four_maps",
    lecture: "TA 6: \"Some Types of Textures\"",
    source: include_str!("four_maps.rs"),
    halves: [6, 4],
    panels: &["albedo", "specular", "height", "normal", "albedo alone", "all four"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0; // albedo
uniform sampler2D uTexUnit1; // specular
uniform sampler2D uTexUnit2; // height
uniform sampler2D uTexUnit3; // normal
uniform int uAll;
in vec3 vObject;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec3 to_eye = normalize(vec3(-0.9, 0.5, 2.2) - vObject);
    vec3 to_light = normalize(vec3(-0.2, 0.7, 0.7) - vObject);
    vec2 at = vTexCoord;
    vec3 n = vec3(0.0, 0.0, 1.0);
    float gloss = 0.0;
    if (uAll == 1) {
        at += 0.06 * (texture2D(uTexUnit2, at).r - 0.6) * to_eye.xy / to_eye.z;
        n = normalize(2.0 * texture2D(uTexUnit3, at).rgb - 1.0);
        gloss = texture2D(uTexUnit1, at).r;
    }
    float diffuse = max(0.0, dot(n, to_light));
    float specular = pow(max(0.0, dot(n, normalize(to_light + to_eye))), 30.0);
    vec3 color = texture2D(uTexUnit0, at).rgb * (0.15 + 0.95 * diffuse) + 0.9 * gloss * specular;
    fragColor = vec4(color, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.13, 0.14, 0.17, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    let albedo = window.picture("bricks.ppm");
    let height = window.picture("bricks_height.ppm");
    let maps = [albedo, glaze(&height), height.clone(), normal_map(&height, 5.)];
    let mut textures: [GLuint; 4] = [0; 4];
    for (unit, map) in (0..4).zip(maps).rev() {
        textures[unit as usize] = load_texture(unit, map, GL_REPEAT);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
    }
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    for (panel, texture) in (0..).zip(textures) {
        window.panel(3, 2, panel);
        show_flat(texture);
    }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, textures[0]);
    let wall = Mesh::plane().upload();
    for all in 0..2 {
        let aspect = window.panel(3, 2, 4 + all);
        let eye = look_at(dvec3(-0.9, 0.5, 2.2), DVec3::ZERO);
        use_program(program, &perspective(57., aspect, 0.1, 50.), &eye);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uTexUnit3"), 3);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uAll"), all);
        wall.draw(program);
    }
}

/// What stands out is glazed, the joints are not.
fn glaze(height: &Picture) -> Picture {
    let shine = |pixel: &packed_pixel_t| {
        let shine = pixel.r.saturating_sub(110).saturating_mul(3);
        packed_pixel_t { r: shine, g: shine, b: shine }
    };
    Picture { pixels: height.pixels.iter().map(shine).collect(), ..height.clone() }
}
