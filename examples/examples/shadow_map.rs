//! Shadow mapping: a z-buffered image from the light, compared with what the eye sees.
//!
//! *CS380, Texture Mapping*, slides 36 to 41. Pass 1 stores z as the light sees it in a depth texture; in
//! pass 2 the fragment shader divides by w, looks up what the light saw there, and compares.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "shadow_map",
    lecture: "CS380: slides 36 to 41, \"Shadow mapping\"",
    source: include_str!("shadow_map.rs"),
    halves: [2, 2],
    panels: &[],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// Pass 1: only depth is stored.
const LIGHT_FRAGMENT_SHADER: &str = "\
#version 130

void main() {
}
";

/// Pass 2: the computation of the projector.
const VERTEX_SHADER: &str = "\
#version 130
uniform mat4 uProjMatrix;
uniform mat4 uModelViewMatrix;
uniform mat4 uSProjMatrix;
uniform mat4 uSModelViewMatrix;
in vec4 aVertex;
in vec3 aNormal;
in vec3 aColor;
out vec4 vTexCoord;
out vec3 vNormal;
out vec3 vColor;
out vec3 vToLight;

void main() {
    vTexCoord = uSProjMatrix * uSModelViewMatrix * aVertex;
    vNormal = aNormal;
    vColor = aColor;
    vToLight = vec3(3.2, 6.0, 2.6) - aVertex.xyz;
    gl_Position = uProjMatrix * uModelViewMatrix * aVertex;
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
in vec4 vTexCoord;
in vec3 vNormal;
in vec3 vColor;
in vec3 vToLight;
out vec4 fragColor;

void main() {
    float diffuse = max(0.0, dot(normalize(vNormal), normalize(vToLight)));
    vec3 t = vTexCoord.xyz / vTexCoord.w;
    float seen = texture2D(uTexUnit0, t.xy).r;
    // Without a bias a surface would shadow itself, texel by texel.
    float lit = t.z - 0.0025 <= seen ? 1.0 : 0.0;
    fragColor = vec4(vColor * (0.22 + 0.85 * diffuse * lit), 1.0);
}
";

/// Side of the depth texture.
const SIZE: GLsizei = 1024;

fn draw(window: &mut Window) {
    glEnable(GL_DEPTH_TEST);
    let fbo = depth_framebuffer(SIZE, GL_NEAREST);
    let model = ring_and_blocks().upload();
    let light_projection = perspective(60., 1., 3., 14.);
    let light_view = look_at(dvec3(3.2, 6.0, 2.6), DVec3::ZERO);

    // Pass 1: from the light, into the framebuffer object.
    let light = initShaders(window, EYE_VERTEX_SHADER, LIGHT_FRAGMENT_SHADER);
    glBindFramebuffer(GL_FRAMEBUFFER, fbo);
    glViewport(0, 0, SIZE, SIZE);
    glClear(GL_DEPTH_BUFFER_BIT);
    use_program(light, &light_projection, &light_view);
    model.draw(light);

    // Pass 2: from the eye, with the depth texture.
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glClearColor(0.55, 0.68, 0.85, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    let aspect = window.panel(1, 1, 0);
    let eye = look_at(dvec3(-0.9, 5.2, 5.6), dvec3(-0.1, 0.4, 0.));
    use_program(program, &perspective(50., aspect, 0.5, 40.), &eye);
    let uniform = |name| safe_glGetUniformLocation(program, name);
    safe_glUniformMatrix4fv(uniform("uSModelViewMatrix"), &light_view);
    safe_glUniformMatrix4fv(uniform("uSProjMatrix"), &(unit_square() * light_projection));
    model.draw(program);
}
