//! (Diffuse × decal) + (specular × gloss) = final result.
//!
//! *Texture Mapping*, slides "Combining texture maps" and "Multitexturing". The gloss map says where the
//! surface is polished: here the bricks are, and the joints between them are not.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "gloss_map",
    lecture: "Texture Mapping: \"Multitexturing\"",
    source: include_str!("gloss_map.rs"),
    halves: [4, 2],
    panels: &["diffuse", "decal", "specular", "gloss", "(diffuse × decal) + (specular × gloss)"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0; // decal
uniform sampler2D uTexUnit1; // gloss
uniform int uShow;           // 0 to 3: a term; 4: all
in vec3 vPosition;
in vec3 vNormal;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(vec3(1.6, 2.2, 1.5) - vPosition);
    vec3 halfway = normalize(toLight + normalize(-vPosition));
    vec3 diffuse = vec3(0.15 + 0.85 * max(0.0, dot(normal, toLight)));
    vec3 specular = vec3(1.0, 0.95, 0.85) * pow(max(0.0, dot(normal, halfway)), 24.0);
    vec3 decal = texture2D(uTexUnit0, vTexCoord).rgb;
    vec3 gloss = texture2D(uTexUnit1, vTexCoord).rgb;
    vec3 color = diffuse * decal + specular * gloss;
    if (uShow == 0) color = diffuse;
    if (uShow == 1) color = decal;
    if (uShow == 2) color = specular;
    if (uShow == 3) color = gloss;
    fragColor = vec4(color, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.08, 0.09, 0.11, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    load_texture(0, window.picture("bricks.ppm"), GL_REPEAT);
    load_texture(1, window.picture("bricks_height.ppm"), GL_REPEAT);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let ball = Mesh::sphere().tiled(4., 2.).upload();
    // Four terms on the left, their sum on the right.
    for show in 0..5 {
        let aspect = if show < 4 {
            window.panel(4, 2, show % 2 + 4 * (show / 2))
        } else {
            window.panel(2, 1, 1)
        };
        let place = translate(0., 0., -3.1) * rotate(20., DVec3::X) * rotate(30., DVec3::Y);
        use_program(program, &perspective(42., aspect, 0.1, 50.), &place);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uShow"), show);
        ball.draw(program);
    }
}
