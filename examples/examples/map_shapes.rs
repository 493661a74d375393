//! Map shapes: planar, triplanar, cylindrical with caps, spherical.
//!
//! *eScience*, slides 24 to 27; *TA 6*, "Projection Mapping". Each shape is projected onto a cylinder, a ball
//! and a box, from a procedure of (x, y, z): (x, y); one of three planes by the normal; 0.5 + θ/2π and z'/h with
//! (x, z) on the caps; 0.5 + θ/2π and 1 − φ/π.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "map_shapes",
    lecture: "eScience: slides 24 to 27; TA 6: \"Projection Mapping\"",
    source: include_str!("map_shapes.rs"),
    halves: [4, 2],
    panels: &["plane", "three planes", "cylinder", "sphere"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform int uShape;
in vec3 vNormal;
in vec3 vObject;
in vec3 vObjectNormal;
out vec4 fragColor;

vec2 plane(vec3 p) { return 0.5 * p.xy + 0.5; }

vec2 cylinder(vec3 p, vec3 n) {
    if (abs(n.y) > 0.7) return 0.5 * p.xz + 0.5; // the caps
    return vec2(0.5 + atan(p.z, p.x) / 6.2831853, (p.y + 1.0) / 2.0); // from y = -1, h = 2
}

vec2 sphere(vec3 p) {
    float phi = acos(p.y / length(p));
    return vec2(0.5 + atan(p.z, p.x) / 6.2831853, 1.0 - phi / 3.1415927);
}

vec3 look(vec2 at) { return texture2DLod(uTexUnit0, 2.0 * at, 0.0).rgb; }

vec3 triplanar(vec3 p, vec3 n) {
    vec3 weight = n * n * n * n;
    weight /= weight.x + weight.y + weight.z;
    return weight.x * look(0.5 * p.zy + 0.5) + weight.y * look(0.5 * p.xz + 0.5)
        + weight.z * look(plane(p));
}

void main() {
    vec3 n = normalize(vObjectNormal);
    vec3 color = triplanar(vObject, n);
    if (uShape == 0) color = look(plane(vObject));
    if (uShape == 2) color = look(cylinder(vObject, n));
    if (uShape == 3) color = look(sphere(vObject));
    float light = max(0.0, dot(normalize(vNormal), normalize(vec3(-0.4, 0.7, 0.6))));
    fragColor = vec4(color * (0.4 + 0.7 * light), 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.90, 0.89, 0.86, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    load_texture(0, tiles(), GL_REPEAT);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let meshes = [Mesh::cylinder(), Mesh::sphere(), Mesh::cube()].map(|mesh| mesh.upload());
    for shape in 0..4 {
        let aspect = window.panel(2, 2, shape);
        for (x, mesh) in [-1.35, 0., 1.35].into_iter().zip(&meshes) {
            let place = translate(x, 0., -4.1) * rotate(30., DVec3::X) * rotate(28., DVec3::Y);
            let place = place * DMat4::from_scale(DVec3::splat(0.52));
            use_program(program, &perspective(36., aspect, 0.1, 50.), &place);
            safe_glUniform1i(safe_glGetUniformLocation(program, "uShape"), shape);
            mesh.draw(program);
        }
    }
}

/// Squares that get redder with s and bluer with t.
fn tiles() -> Picture {
    Picture::paint(128, 128, |x, y| {
        let dark = ((x * 4.).floor() + (y * 4.).floor()) % 2.;
        let color = [0.35 + 0.6 * x, 0.75 - 0.3 * x, 0.3 + 0.6 * y];
        color.map(|component| component * (0.35 + 0.65 * dark))
    })
}
