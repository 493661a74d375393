//! Triplanar mapping: three planes, each as far as the normal points along it.
//!
//! *TA 6*, "Triplanar mapping". On the left one plane alone, (x, y), which smears along z; on the right the
//! mean of (z, y), (x, z) and (x, y), weighted by the fourth power of the normal's x, y and z.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "triplanar",
    lecture: "TA 6: \"Triplanar mapping\"",
    source: include_str!("triplanar.rs"),
    halves: [4, 2],
    panels: &["one plane", "three planes"],
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

uniform int uPlanes;

vec3 look(vec2 at) { return texture2D(uTexUnit0, at).rgb; }

void main() {
    vec3 n = normalize(vObjectNormal), p = vObject;
    vec3 weight = n * n * n * n;
    weight /= weight.x + weight.y + weight.z;
    if (uPlanes == 1) weight = vec3(0.0, 0.0, 1.0);
    vec3 color = weight.x * look(p.zy) + weight.y * look(p.xz) + weight.z * look(p.xy);
    float light = max(0.0, dot(normalize(vNormal), normalize(vec3(-0.4, 0.7, 0.6))));
    fragColor = vec4(color * (0.4 + 0.7 * light), 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.90, 0.89, 0.86, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    load_texture(0, window.picture("bricks.ppm"), GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let mut model = Mesh::cube().moved(translate(0., -0.2, 0.));
    model.append(Mesh::sphere().moved(translate(0., 1.25, 0.)));
    let model = model.upload();
    for (panel, planes) in [(0, 1), (1, 3)] {
        let aspect = window.panel(2, 1, panel);
        let place = translate(0., -0.5, -6.4) * rotate(22., DVec3::X) * rotate(-36., DVec3::Y);
        use_program(program, &perspective(42., aspect, 0.1, 50.), &place);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uPlanes"), planes);
        model.draw(program);
    }
}
