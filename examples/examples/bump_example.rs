//! Two textures make a picture: diffuse colour and bump map.
//!
//! *Texture Mapping*, slide "Bump mapping example": texture #1 (diffuse colour), texture #2 (bump map), rendered image.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "bump_example",
    lecture: "Texture Mapping: \"Bump mapping example\"",
    source: include_str!("bump_example.rs"),
    halves: [6, 2],
    panels: &["texture #1: diffuse colour", "texture #2: bump map", "rendered image"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0; // diffuse colour
uniform sampler2D uTexUnit1; // heights
in vec3 vPosition;
in vec3 vNormal;
in vec2 vTexCoord;
out vec4 fragColor;

float h(vec2 at) { return 0.06 * texture2D(uTexUnit1, at).r; }

void main() {
    // S and T from how position and coordinates change on the screen.
    vec3 px = dFdx(vPosition), py = dFdy(vPosition);
    vec2 cx = dFdx(vTexCoord), cy = dFdy(vTexCoord);
    float det = cx.s * cy.t - cy.s * cx.t;
    vec3 S = (px * cy.t - py * cx.t) / det, T = (py * cx.s - px * cy.s) / det;
    float hu = (h(vTexCoord + vec2(0.004, 0.0)) - h(vTexCoord - vec2(0.004, 0.0))) / 0.008;
    float hv = (h(vTexCoord + vec2(0.0, 0.004)) - h(vTexCoord - vec2(0.0, 0.004))) / 0.008;
    vec3 n = normalize(vNormal);
    // P'u x P'v of P' = P + h n, the terms with the change of n left out.
    vec3 normal = normalize(cross(S, T) + hu * cross(n, T) + hv * cross(S, n));
    vec3 toLight = normalize(vec3(-2.0, 2.0, 1.5) - vPosition);
    vec3 halfway = normalize(toLight - normalize(vPosition));
    vec3 color = texture2D(uTexUnit0, vTexCoord).rgb * (0.14 + max(0.0, dot(normal, toLight)))
        + 0.25 * pow(max(0.0, dot(normal, halfway)), 24.0);
    fragColor = vec4(color, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.09, 0.10, 0.13, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    let heights = load_texture(1, window.picture("bricks_height.ppm"), GL_REPEAT);
    let colors = load_texture(0, window.picture("bricks.ppm"), GL_REPEAT);
    for (panel, texture) in [(0, colors), (1, heights)] {
        window.panel(3, 1, panel);
        show_flat(texture);
    }
    glEnable(GL_DEPTH_TEST);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let aspect = window.panel(3, 1, 2);
    let place = translate(0., 0.05, -3.4) * rotate(22., DVec3::X) * rotate(-40., DVec3::Y);
    use_program(program, &perspective(42., aspect, 0.1, 50.), &place);
    Mesh::sphere().tiled(4., 2.).upload().draw(program);
}
