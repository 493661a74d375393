//! Cylindrical mapping: u = 0.5 + θ/2π, v = z'/h, with θ = atan2(z, x) and z' = y; and caps mapped by a plane.
//!
//! *TA 6*, "Cylindrical mapping"; *eScience*, slide 26. From left to right, on a barrel from y = 0 to y = h: as
//! printed, where the text is seen from behind (θ runs clockwise around y), and the lid shows the highest row
//! of the picture drawn out into rays; with 0.5 − θ/2π, and caps from (x, z); and eScience's cylinder, whose axis
//! is z: what is toward z on a box and a ball is cut into pie slices.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "cylindrical_mapping",
    lecture: "TA 6: \"Cylindrical mapping\"; eScience: slide 26",
    source: include_str!("cylindrical_mapping.rs"),
    halves: [6, 2],
    panels: &["as printed: mirrored", "u = 0.5 − θ/2π, caps by (x, z)", "the axis is z"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform int uShow; // 0: as printed, 1: with caps, 2: the axis is z
in vec3 vNormal;
in vec3 vObject;
in vec3 vObjectNormal;
out vec4 fragColor;

const float pi = 3.1415927, h = 2.0;

vec2 around(vec3 p) {
    float theta = atan(p.z, p.x);
    return vec2(0.5 + theta / (2.0 * pi), p.y / h);
}

void main() {
    vec2 at = around(vObject);
    if (uShow == 1) at.x = 1.0 - at.x;
    if (uShow == 1 && abs(vObjectNormal.y) > 0.7) at = 0.5 + 0.5 * vObject.xz;
    if (uShow == 2) at = around(vec3(vObject.xy, vObject.z + 1.0).xzy) * vec2(-1.0, 1.0);
    vec3 color = texture2DLod(uTexUnit0, at, 0.0).rgb;
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
    let barrel = Mesh::cylinder().moved(translate(0., 1., 0.));
    let turned = rotate(34., DVec3::X) * rotate(70., DVec3::Y);
    let upright = translate(0., 0.05, -4.7) * turned * translate(0., -1., 0.);
    let toward = rotate(16., DVec3::X) * rotate(-24., DVec3::Y);
    let [small, left, right] = [
        DMat4::from_scale(DVec3::splat(0.62)),
        translate(-0.72, 0.1, -4.),
        translate(0.72, 0.1, -4.),
    ];
    let shapes: [(i32, i32, Mesh, DMat4); 4] = [
        (0, 0, barrel.clone(), upright),
        (1, 1, barrel, upright),
        (2, 2, Mesh::sphere(), left * toward * small),
        (2, 2, Mesh::cube(), right * toward * small * DMat4::from_scale(DVec3::splat(0.85))),
    ];
    for (panel, show, mesh, place) in shapes {
        let aspect = window.panel(3, 1, panel);
        use_program(program, &perspective(40., aspect, 0.1, 50.), &place);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uShow"), show);
        mesh.upload().draw(program);
    }
}
