//! Refraction: the environment cube map, looked up where the bent ray goes.
//!
//! *CS380*, slide 24: "This can be used for refraction." On the left every ray is bent once at the surface
//! (Snell, 1/1.5); on the right three rays, one a colour, are bent a little differently, and the mirror's ray
//! is mixed in toward the rim (Schlick's approximation of Fresnel's reflectance).
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "refraction",
    lecture: "CS380: slide 24, \"Environment map shader\"",
    source: include_str!("refraction.rs"),
    halves: [4, 2],
    panels: &["refraction", "three colours, and Fresnel's mirror"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform samplerCube uTexUnit0;
uniform float uSky;
uniform float uGlass;
in vec3 vPosition;
in vec3 vNormal;
out vec4 fragColor;

vec3 look(vec3 direction) { return textureCube(uTexUnit0, direction).rgb; }

void main() {
    vec3 v = normalize(vPosition);
    vec3 n = normalize(vNormal);
    vec3 bent = look(refract(v, n, 1.0 / 1.5));
    vec3 split = vec3(
        look(refract(v, n, 1.0 / 1.47)).r,
        bent.g,
        look(refract(v, n, 1.0 / 1.53)).b);
    float mirror = 0.04 + 0.96 * pow(1.0 - max(0.0, dot(-v, n)), 5.0);
    vec3 glass = mix(split, look(reflect(v, n)), mirror);
    fragColor = vec4(mix(mix(bent, glass, uGlass), look(v), uSky), 1.0);
}
";

fn draw(window: &mut Window) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    load_cube_map(window);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let sky = Mesh::cube().upload();
    let mut glass = Mesh::sphere().moved(DMat4::from_scale(DVec3::splat(0.56)));
    glass.append(Mesh::torus(0.2).moved(rotate(62., DVec3::X) * rotate(20., DVec3::Z)));
    let glass = glass.upload();
    for (panel, kind) in [(0, 0.), (1, 1.)] {
        let projection = perspective(52., window.panel(2, 1, panel), 0.1, 50.);
        use_program(program, &projection, &DMat4::from_scale(DVec3::splat(20.)));
        let h_uSky = safe_glGetUniformLocation(program, "uSky");
        safe_glUniform1f(h_uSky, 1);
        sky.draw(program);
        use_program(program, &projection, &translate(0., 0., -3.2));
        safe_glUniform1f(h_uSky, 0);
        safe_glUniform1f(safe_glGetUniformLocation(program, "uGlass"), kind);
        glass.draw(program);
    }
}
