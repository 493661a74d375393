//! Non-parametric against parametric mapping.
//!
//! *Texture Mapping*, slides "Non-parametric texture mapping" and "Parametric texture mapping". On the left
//! the texture belongs to the window, whatever the surface does: the cookie-cutter effect. On the right it
//! has coordinates of its own, which are tied to the surface.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "parametric",
    lecture: "Texture Mapping: \"Parametric texture mapping\"",
    source: include_str!("parametric.rs"),
    halves: [4, 2],
    panels: &["non-parametric: a cookie cutter", "parametric: tied to the surface"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform vec3 uWindow; // pixels a texture; whether the surface has coordinates of its own
in vec3 vNormal;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec2 cookie = gl_FragCoord.xy / uWindow.xy;
    vec3 color = texture2D(uTexUnit0, mix(cookie, vTexCoord, uWindow.z)).rgb;
    float light = mix(1.0, 0.45 + 0.6 * abs(normalize(vNormal).z), uWindow.z);
    fragColor = vec4(color * light, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.90, 0.89, 0.86, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    load_texture(0, window.picture("bricks.ppm"), GL_REPEAT);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let cube = Mesh::cube().upload();
    let vase = Mesh::vase().tiled(2., 1.).upload();
    let side = f64::from(window.height) / 2.;
    for (panel, own) in [(0, 0.), (1, 1.)] {
        let projection = perspective(42., window.panel(2, 1, panel), 0.1, 50.);
        let turned = rotate(28., DVec3::X) * rotate(34., DVec3::Y);
        let place = translate(-0.95, 0., -5.6) * turned * DMat4::from_scale(DVec3::splat(0.72));
        use_program(program, &projection, &place);
        safe_glUniform3f(safe_glGetUniformLocation(program, "uWindow"), side, side, own);
        cube.draw(program);
        let place = translate(1.05, 0., -5.6) * rotate(20., DVec3::X);
        use_program(program, &projection, &(place * DMat4::from_scale(DVec3::splat(1.2))));
        vase.draw(program);
    }
}
