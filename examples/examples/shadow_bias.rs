//! The bias of a shadow map: none, enough, too much.
//!
//! *CS380*, slides 36 to 41. z as the light saw it is rounded, and belongs to another place of the same texel:
//! without a bias the surface shadows itself (left); with too much the shadow leaves its object (right).
//! `glPolygonOffset` adds the bias while the light's picture is drawn.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "shadow_bias",
    lecture: "CS380: slides 36 to 41, \"Shadow mapping\": bias",
    source: include_str!("shadow_bias.rs"),
    halves: [6, 2],
    panels: &["no bias", "enough", "too much"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const LIGHT_FRAGMENT_SHADER: &str = "\
#version 130

void main() {
}
";

const VERTEX_SHADER: &str = "\
#version 130
uniform mat4 uProjMatrix;
uniform mat4 uModelViewMatrix;
uniform mat4 uLightMatrix;
in vec4 aVertex;
in vec3 aNormal;
in vec3 aColor;
out vec4 vTexCoord;
out vec3 vColor;

void main() {
    vTexCoord = uLightMatrix * aVertex;
    vColor = aColor * (0.35 + 0.65 * max(0.0, dot(aNormal, normalize(vec3(3.0, 4.0, 2.0)))));
    gl_Position = uProjMatrix * uModelViewMatrix * aVertex;
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2DShadow uTexUnit0;
in vec4 vTexCoord;
in vec3 vColor;
out vec4 fragColor;

void main() {
    fragColor = vec4(vColor * (0.3 + 0.7 * shadow2DProj(uTexUnit0, vTexCoord).r), 1.0);
}
";

/// Side of the light's picture: small, so that the error can be seen.
const SIDE: GLsizei = 256;

/// Factor and units of `glPolygonOffset`.
const PANELS: [(i32, i32); 3] = [(0, 0), (2, 2), (0, 800_000)];

fn draw(window: &mut Window) {
    glEnable(GL_DEPTH_TEST);
    let fbo = depth_framebuffer(SIDE, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    let light_program = initShaders(window, EYE_VERTEX_SHADER, LIGHT_FRAGMENT_SHADER);
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    let light_projection = perspective(52., 1., 2., 12.);
    let light_view = look_at(dvec3(3., 4., 2.), DVec3::ZERO);
    let scene = ball_and_block().upload();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glClearColor(0.55, 0.68, 0.85, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (panel, (factor, units)) in (0..).zip(PANELS) {
        // Pass 1: from the light.
        glBindFramebuffer(GL_FRAMEBUFFER, fbo);
        glViewport(0, 0, SIDE, SIDE);
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(factor, units);
        use_program(light_program, &light_projection, &light_view);
        scene.draw(light_program);
        glDisable(GL_POLYGON_OFFSET_FILL);

        // Pass 2: from the eye.
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        let aspect = window.panel(3, 1, panel);
        let eye = look_at(dvec3(-1.2, 2.7, 4.2), dvec3(-0.1, 0.2, 0.));
        use_program(program, &perspective(46., aspect, 0.5, 40.), &eye);
        let light = unit_square() * light_projection * light_view;
        safe_glUniformMatrix4fv(safe_glGetUniformLocation(program, "uLightMatrix"), &light);
        scene.draw(program);
    }
}
