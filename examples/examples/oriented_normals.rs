//! Normals are oriented to the surface: a map's x, y, z are the surface's S, T, N.
//!
//! *Texture Mapping*, slide "Normal Mapping": "otherwise have to orient the normal coordinates to the surface". A
//! map that is made from a height field has its normals around +z. On a ring that is right nowhere but where
//! the ring faces the eye: its light is flat. With the frame of each point, S around the ring, T around the tube and
//! N = S × T, the bricks are lit as they lie.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::normals::normal_map;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "oriented_normals",
    lecture: "Texture Mapping: \"Normal Mapping\"",
    source: include_str!("oriented_normals.rs"),
    halves: [4, 4],
    panels: &[
        "the normal map: x, y, z as r, g, b",
        "not oriented: the map's axes are the eye's",
        "oriented: the map's axes are S, T, N",
        "the oriented normals, as colours",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0; // normals
uniform sampler2D uTexUnit1; // colours
uniform mat4 uModelViewMatrix;
uniform int uShow; // 1: not oriented, 2: oriented, 3: the oriented normals
in vec3 vPosition;
in vec3 vObject;
in vec3 vObjectNormal;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec3 n = 2.0 * texture2D(uTexUnit0, vTexCoord).rgb - 1.0;
    vec3 N = normalize(vObjectNormal);
    vec3 S = normalize(cross(vec3(0.0, 1.0, 0.0), vObject)); // along the ring
    vec3 T = cross(N, S);                                    // around the tube
    vec3 oriented = normalize(n.x * S + n.y * T + n.z * N);
    vec3 normal = uShow == 1 ? normalize(n) : vec3(uModelViewMatrix * vec4(oriented, 0.0));
    vec3 toLight = normalize(vec3(-2.5, 3.0, 1.0) - vPosition);
    vec3 halfway = normalize(toLight - normalize(vPosition));
    vec3 color = texture2D(uTexUnit1, vTexCoord).rgb * (0.12 + max(0.0, dot(normal, toLight)))
        + 0.3 * pow(max(0.0, dot(normal, halfway)), 30.0);
    fragColor = vec4(uShow == 3 ? 0.5 * normal + 0.5 : color, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.09, 0.10, 0.13, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    load_texture(1, window.picture("bricks.ppm"), GL_REPEAT);
    let normals = normal_map(&window.picture("bricks_height.ppm"), 7.);
    let normals = load_texture(0, normals, GL_REPEAT);
    window.panel(2, 2, 0);
    show_flat(normals);
    glEnable(GL_DEPTH_TEST);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let ring = Mesh::torus(0.42).tiled(4., 2.).upload();
    for show in 1..4 {
        let aspect = window.panel(2, 2, show);
        let place = translate(0., 0.1, -4.2) * rotate(48., DVec3::X) * rotate(20., DVec3::Z);
        use_program(program, &perspective(42., aspect, 0.1, 50.), &place);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uShow"), show);
        ring.draw(program);
    }
}
