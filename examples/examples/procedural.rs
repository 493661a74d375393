//! Procedural wood and marble: a procedure of the place, with no picture stored.
//!
//! *eScience*, slide 29. "Perturbing stripes can result in a texture with a marbled appearance", and wood
//! "begins with a three-dimensional texture of concentric rings", whose shape noise varies. The noise comes
//! from a small 3D texture.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::solid::noise_volume;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "procedural",
    lecture: "eScience: slide 29, \"Texture 3D and Procedural Textures\"",
    source: include_str!("procedural.rs"),
    halves: [4, 2],
    panels: &["wood: rings and noise", "marble: perturbed stripes"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler3D uTexUnit0; // noise
uniform int uWood;
in vec3 vPosition;
in vec3 vNormal;
in vec3 vObject;
out vec4 fragColor;

float noise(vec3 at) { return texture3D(uTexUnit0, at).r - 0.5; }

vec3 wood(vec3 at) {
    float radius = length(at.xy - vec2(0.25, 0.15)) + 0.16 * noise(0.25 * at);
    float ring = fract(9.0 * radius);
    float late = smoothstep(0.3, 0.85, ring) - smoothstep(0.9, 1.0, ring);
    float grain = noise(vec3(4.0 * at.xy, 0.3 * at.z));
    return mix(vec3(0.78, 0.55, 0.31), vec3(0.45, 0.24, 0.11), late) * (1.0 + 0.35 * grain);
}

vec3 marble(vec3 at) {
    float turbulence = abs(noise(0.3 * at)) + 0.5 * abs(noise(0.6 * at)) + 0.25 * abs(noise(1.2 * at));
    float stripe = 0.5 + 0.5 * sin(8.0 * at.x + 3.0 * at.y + 24.0 * turbulence);
    return mix(vec3(0.92, 0.93, 0.90), vec3(0.16, 0.30, 0.26), pow(stripe, 3.0));
}

void main() {
    vec3 color = uWood == 1 ? wood(vObject) : marble(vObject);
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(vec3(1.5, 3.0, 1.0) - vPosition);
    vec3 halfway = normalize(toLight + normalize(-vPosition));
    float diffuse = 0.28 + 0.8 * max(0.0, dot(normal, toLight));
    fragColor = vec4(color * diffuse + 0.2 * pow(max(0.0, dot(normal, halfway)), 30.0), 1.0);
}
";

/// Side of the noise.
const SIDE: usize = 32;

fn draw(window: &mut Window) {
    glClearColor(0.13, 0.15, 0.18, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    load_volume(SIDE, GL_LUMINANCE, &noise_volume(SIDE));
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    for (panel, wood, mesh, size) in [(0, 1, Mesh::cube(), 0.74), (1, 0, Mesh::torus(0.45), 0.85)] {
        let aspect = window.panel(2, 1, panel);
        let turned = rotate(34., DVec3::X) * rotate(-36., DVec3::Y);
        let place = translate(0., 0., -3.6) * turned * DMat4::from_scale(DVec3::splat(size));
        use_program(program, &perspective(42., aspect, 0.1, 50.), &place);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uWood"), wood);
        mesh.upload().draw(program);
    }
}
