//! A vase cut from solid marble, beside one with a marble veneer.
//!
//! *Texture Mapping*, slides "Solid textures" (Perlin's vase). The veneer on the left is one slice of the
//! marble, wrapped around: it is squeezed where the vase is narrow, and has a seam. On the right the
//! coordinates in model space index a 3D texture.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::solid::marble_volume;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "solid_marble",
    lecture: "Texture Mapping: \"Solid textures\"",
    source: include_str!("solid_marble.rs"),
    halves: [4, 2],
    panels: &["marble veneer: squeezed, with a seam", "solid marble: a 3D texture"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler3D uTexUnit0;
uniform float uSolid;
in vec3 vPosition;
in vec3 vNormal;
in vec3 vObject;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec3 veneer = vec3(1.25 * vTexCoord, 0.5);
    vec3 marble = texture3D(uTexUnit0, mix(veneer, 0.5 * vObject + 0.5, uSolid)).rgb;
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(vec3(-2.0, 2.5, 2.0) - vPosition);
    vec3 halfway = normalize(toLight + normalize(-vPosition));
    float diffuse = 0.25 + 0.8 * max(0.0, dot(normal, toLight));
    fragColor = vec4(marble * diffuse + 0.35 * pow(max(0.0, dot(normal, halfway)), 40.0), 1.0);
}
";

/// Side of the block of marble.
const SIDE: usize = 64;

fn draw(window: &mut Window) {
    glClearColor(0.22, 0.16, 0.14, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    load_volume(SIDE, GL_RGB, &marble_volume(SIDE));
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let vase = Mesh::vase().upload();
    for (panel, solid) in [(0, 0.), (1, 1.)] {
        let aspect = window.panel(2, 1, panel);
        // Turned so that the veneer's seam can be seen.
        let place = translate(0., 0., -3.2) * rotate(16., DVec3::X) * rotate(-35., DVec3::Y);
        use_program(program, &perspective(42., aspect, 0.1, 50.), &place);
        safe_glUniform1f(safe_glGetUniformLocation(program, "uSolid"), solid);
        vase.draw(program);
    }
}
