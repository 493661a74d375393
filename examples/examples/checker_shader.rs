//! The RenderMan checkerboard, as a fragment shader: the material is a program.
//!
//! *Texture Mapping*, slide "Can define material by program". `surface checker(float Kd=.5, Ka=.1)` line by
//! line; GL has no `ambient()` and `diffuse()`, so they are functions here.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "checker_shader",
    lecture: "Texture Mapping: \"Can define material by program\"",
    source: include_str!("checker_shader.rs"),
    halves: [2, 2],
    panels: &[],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
const float Kd = 0.5, Ka = 0.1;
in vec3 vPosition;
in vec3 vNormal;
in vec2 vTexCoord;
in vec3 vColor;
out vec4 fragColor;

vec3 ambient() { return vec3(1.0); }

vec3 diffuse(vec3 N) {
    return 1.7 * vec3(max(0.0, dot(N, normalize(vec3(0.5, 0.8, 0.7)))));
}

/* Checkerboard */
void main() {
    float s = vTexCoord.s, t = vTexCoord.t;
    vec3 Cs = vColor, Ci, N = vNormal, I = vPosition;
    float smod = mod(10.0 * s, 1.0);
    float tmod = mod(10.0 * t, 1.0);
    if (smod < 0.5) {
        if (tmod < 0.5) Ci = Cs; else Ci = vec3(0, 0, 0);
    } else {
        if (tmod < 0.5) Ci = vec3(0, 0, 0); else Ci = Cs;
    }
    float Oi = 1.0;
    Ci = Oi * Ci * (
        Ka * ambient() +
        Kd * diffuse(faceforward(normalize(N), I, normalize(N))));
    fragColor = vec4(Ci, Oi);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.30, 0.34, 0.40, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let floor = translate(0., -1., 0.) * rotate(-90., DVec3::X);
    let mut scene = Mesh::plane().moved(floor * DMat4::from_scale(DVec3::splat(3.)));
    scene.append(Mesh::sphere().moved(translate(-1.15, 0., -0.4)).colored([1.0, 0.75, 0.3]));
    let vase = Mesh::vase().moved(translate(1.1, 0., 0.4));
    scene.append(vase.colored([0.45, 0.85, 1.0]));
    let aspect = window.panel(1, 1, 0);
    let eye = look_at(dvec3(0.4, 2.0, 5.2), dvec3(0., -0.2, 0.));
    use_program(program, &perspective(46., aspect, 0.1, 50.), &eye);
    scene.upload().draw(program);
}
