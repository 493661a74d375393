//! Spherical mapping: (u, v) = (atan2(z, x), acos(y/r)), longitude and latitude.
//!
//! *TA 6*, "Spherical mapping"; *eScience*, slide 27. From left to right: a ball, where the meridians meet at
//! the poles; a vase and a box, on which the picture falls from a sphere around them.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "spherical_mapping",
    lecture: "TA 6: \"Spherical mapping\"; eScience: slide 27",
    source: include_str!("spherical_mapping.rs"),
    halves: [6, 2],
    panels: &[],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
in vec3 vNormal;
in vec3 vObject;
in vec3 vObjectNormal;
out vec4 fragColor;

void main() {
    float r = length(vObject);
    float u = atan(vObject.z, vObject.x) / 6.2831853;
    float v = acos(vObject.y / r) / 3.1415927;
    // Where u jumps from 1/2 to -1/2 its derivative is taken of the other side.
    float other = fract(u);
    vec2 dx = dFdx(vec2(u, v)), dy = dFdy(vec2(u, v));
    if (abs(dFdx(other)) < abs(dx.x)) dx.x = dFdx(other);
    if (abs(dFdy(other)) < abs(dy.x)) dy.x = dFdy(other);
    vec2 tiles = vec2(4.0, 2.0);
    vec3 color = textureGrad(uTexUnit0, vec2(u, v) * tiles, dx * tiles, dy * tiles).rgb;
    float light = max(0.0, dot(normalize(vNormal), normalize(vec3(-0.4, 0.7, 0.6))));
    fragColor = vec4(color * (0.4 + 0.7 * light), 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.90, 0.89, 0.86, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    load_texture(0, graph_paper(), GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    for (panel, mesh) in (0..).zip([Mesh::sphere(), Mesh::vase(), Mesh::cube()]) {
        let aspect = window.panel(3, 1, panel);
        let size = if panel == 2 { 0.72 } else { 1. };
        let place = translate(0., 0., -4.) * rotate(32., DVec3::X) * rotate(24., DVec3::Y);
        let place = place * DMat4::from_scale(DVec3::splat(size));
        use_program(program, &perspective(38., aspect, 0.1, 50.), &place);
        mesh.upload().draw(program);
    }
}

/// Squares with numbered shades: redder with s, bluer with t, and dark lines between them.
fn graph_paper() -> Picture {
    Picture::paint(256, 256, |x, y| {
        let line = (x * 4.).fract() < 0.06 || (y * 4.).fract() < 0.06;
        let dark = ((x * 4.).floor() + (y * 4.).floor()) % 2.;
        let color = [0.45 + 0.5 * x, 0.75 - 0.25 * dark, 0.40 + 0.5 * y];
        if line { [0.15, 0.15, 0.25] } else { color }
    })
}
