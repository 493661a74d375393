//! Spherical mapping: u = 0.5 + θ/2π, v = 1 − φ/π, with θ = atan2(z, x) and φ = acos(y/r).
//!
//! *TA 6*, "Spherical mapping"; *eScience*, slide 27. Above: a ball, on which the text is seen from behind, as θ
//! runs from x to z and so clockwise around y; the same with 0.5 − θ/2π; and eScience's "latitude into x, longitude
//! into y", which lays the picture on its side (the two words have changed places). Below: "the texturing stays
//! the same independent of scale while the object is centred": a ball of half the radius; the same ball, moved
//! to x = 0.7, where it does not; and a box.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "spherical_mapping",
    lecture: "TA 6: \"Spherical mapping\"; eScience: slide 27",
    source: include_str!("spherical_mapping.rs"),
    halves: [6, 4],
    panels: &[
        "u = 0.5 + θ/2π: mirrored",
        "u = 0.5 − θ/2π",
        "latitude → x: on its side",
        "half the radius: the same",
        "off the centre: not the same",
        "a box",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform int uShow; // 0: as printed, 1: u from left to right, 2: latitude into x
in vec3 vNormal;
in vec3 vObject;
in vec3 vObjectNormal;
out vec4 fragColor;

const float pi = 3.1415927;

void main() {
    float r = length(vObject);
    float theta = atan(vObject.z, vObject.x);
    float phi = acos(vObject.y / r);
    vec2 at = vec2(0.5 + theta / (2.0 * pi), 1.0 - phi / pi);
    if (uShow == 1) at.x = 1.0 - at.x;
    if (uShow == 2) at = at.yx;
    // Where u jumps from 1 to 0 its derivative is taken of the other side.
    vec2 dx = dFdx(at), dy = dFdy(at), other = fract(at + 0.5);
    if (abs(dFdx(other.x)) < abs(dx.x)) dx.x = dFdx(other.x);
    if (abs(dFdy(other.x)) < abs(dy.x)) dy.x = dFdy(other.x);
    if (abs(dFdx(other.y)) < abs(dx.y)) dx.y = dFdx(other.y);
    if (abs(dFdy(other.y)) < abs(dy.y)) dy.y = dFdy(other.y);
    vec3 color = textureGrad(uTexUnit0, at, dx, dy).rgb;
    float light = max(0.0, dot(normalize(vNormal), normalize(vec3(-0.4, 0.7, 0.6))));
    fragColor = vec4(color * (0.5 + 0.6 * light), 1.0);
}
";

fn draw(window: &mut Window) {
    let picture = numbered_map(window);
    glClearColor(0.90, 0.89, 0.86, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glBindTexture(GL_TEXTURE_2D, picture);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let half = Mesh::sphere().moved(DMat4::from_scale(DVec3::splat(0.5)));
    let moved = half.clone().moved(translate(0.7, 0., 0.));
    for (panel, (mesh, show)) in (0..).zip([
        (Mesh::sphere(), 0),
        (Mesh::sphere(), 1),
        (Mesh::sphere(), 2),
        (half, 1),
        (moved, 1),
        (Mesh::cube(), 1),
    ]) {
        let aspect = window.panel(3, 2, panel);
        let size = if panel == 5 { 0.72 } else { 1. };
        let place = translate(0., 0.1, -4.) * rotate(24., DVec3::X) * rotate(70., DVec3::Y);
        let place = place * DMat4::from_scale(DVec3::splat(size));
        use_program(program, &perspective(38., aspect, 0.1, 50.), &place);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uShow"), show);
        mesh.upload().draw(program);
    }
}
