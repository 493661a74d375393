//! Planar mapping of a landscape, seen from above: (u, v) = (x/w, z/h).
//!
//! *TA 6*, "Planar mapping". A picture of width w and depth h lies over the hills as a sheet dropped from above:
//! even where the land is flat, drawn out where it is steep.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::smooth;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "planar_mapping",
    lecture: "TA 6: \"Planar mapping\"",
    source: include_str!("planar_mapping.rs"),
    halves: [4, 2],
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

uniform vec2 uSize; // w, h

void main() {
    vec3 color = texture2D(uTexUnit0, vObject.xz / uSize).rgb;
    float light = max(0.0, dot(normalize(vNormal), normalize(vec3(-0.4, 0.7, 0.6))));
    fragColor = vec4(color * (0.4 + 0.7 * light), 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.62, 0.74, 0.88, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    load_texture(0, window.picture("flagstones.ppm"), GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let land = Mesh::surface(160, 160, |s, t| {
        let (x, z) = (6. * s - 3., 3. - 6. * t);
        let slope = |d: DVec3| (height(x + d.x, z + d.z) - height(x - d.x, z - d.z)) / 2e-3;
        let normal = dvec3(-slope(DVec3::X * 1e-3), 1., -slope(DVec3::Z * 1e-3));
        (dvec3(x, height(x, z), z), normal.normalize())
    });
    let aspect = window.panel(1, 1, 0);
    let place = translate(0., -0.35, -8.4) * rotate(24., DVec3::X) * rotate(-24., DVec3::Y);
    use_program(program, &perspective(40., aspect, 0.1, 50.), &place);
    glUniform2f(safe_glGetUniformLocation(program, "uSize"), 1.5, 1.5);
    land.upload().draw(program);
}

/// A mesa with steep sides and a dune.
fn height(x: f64, z: f64) -> f64 {
    let mesa = 1. - smooth(0.55, 0.95, ((x + 1.0) * (x + 1.0) + (z - 0.2) * (z - 0.2)).sqrt());
    let dune = 1. / (1. + 2.5 * ((x - 1.3) * (x - 1.3) + 0.5 * (z + 0.5) * (z + 0.5)));
    1.3 * mesa + 0.8 * dune
}
