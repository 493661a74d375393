//! Cylindrical mapping with caps: (u, v) = (atan2(z, x), y), and (x, z) on top and bottom.
//!
//! *TA 6*, "Cylindrical mapping"; *eScience*, slide 26. On the left without caps, where the lid shows one row of
//! the picture drawn out into rays; on the right the caps are mapped by a plane, where the normal points up or
//! down.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "cylindrical_mapping",
    lecture: "TA 6: \"Cylindrical mapping\"; eScience: slide 26",
    source: include_str!("cylindrical_mapping.rs"),
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

uniform int uCaps;

void main() {
    vec2 around = vec2(atan(vObject.z, vObject.x) / 6.2831853 * 4.0, vObject.y + 0.3);
    bool cap = uCaps == 1 && abs(vObjectNormal.y) > 0.7;
    vec3 color = texture2DLod(uTexUnit0, cap ? vObject.xz : around, 1.0).rgb;
    float light = max(0.0, dot(normalize(vNormal), normalize(vec3(-0.4, 0.7, 0.6))));
    fragColor = vec4(color * (0.4 + 0.7 * light), 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.90, 0.89, 0.86, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    load_texture(0, window.picture("planks.ppm"), GL_REPEAT);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let barrel = Mesh::cylinder().upload();
    for caps in 0..2 {
        let aspect = window.panel(2, 1, caps);
        let place = translate(0., 0., -4.6) * rotate(38., DVec3::X) * rotate(20., DVec3::Y);
        use_program(program, &perspective(40., aspect, 0.1, 50.), &place);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uCaps"), caps);
        barrel.draw(program);
    }
}
