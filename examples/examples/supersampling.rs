//! Supersampling: several points a pixel, and their mean.
//!
//! *eScience*, slides 10 to 15; *Texture Mapping*, "How do we anti-alias textures?". Above: one point a pixel
//! aliases; 2 × 2 points (Crow 1981) alias less. Below: 4 × 4, and 8 × 8 points a pixel. What the pyramid
//! does instead is in `prefiltering`.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::Picture;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "supersampling",
    lecture: "eScience: slides 10 to 15, \"Antialiasing\": supersampling",
    source: include_str!("supersampling.rs"),
    halves: [3, 3],
    panels: &["1 point a pixel", "2 × 2 points", "4 × 4 points", "8 × 8 points"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform int uPoints; // a pixel, along each side
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec2 across = dFdx(vTexCoord), up = dFdy(vTexCoord);
    vec4 sum = vec4(0.0);
    for (int y = 0; y < uPoints; y++) {
        for (int x = 0; x < uPoints; x++) {
            vec2 at = (vec2(x, y) + 0.5) / float(uPoints) - 0.5;
            sum += texture2DLod(uTexUnit0, vTexCoord + at.x * across + at.y * up, 0.0);
        }
    }
    fragColor = sum / float(uPoints * uPoints);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.55, 0.68, 0.85, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    load_texture(0, checkers(), GL_REPEAT);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let floor = rotate(-90., DVec3::X) * DMat4::from_scale(DVec3::splat(40.));
    let floor = Mesh::plane().moved(floor).tiled(40., 40.).upload();
    for (panel, points) in [(0, 1), (1, 2), (2, 4), (3, 8)] {
        let aspect = window.panel(2, 2, panel);
        let place = translate(0., -1., 0.) * rotate(25., DVec3::Y);
        use_program(program, &perspective(60., aspect, 0.1, 200.), &place);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uPoints"), points);
        floor.draw(program);
    }
}

fn checkers() -> Picture {
    Picture::paint(64, 64, |x, y| {
        if ((x * 2.).floor() + (y * 2.).floor()) % 2. == 0. {
            [0.97; 3]
        } else {
            [0.08, 0.10, 0.35]
        }
    })
}
