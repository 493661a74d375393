//! Shadow mapping with `shadow2DProj`: the texture unit divides, compares, and mixes.
//!
//! *CS380, Texture Mapping*, slides 36 to 41. As `shadow_map`, but the depth texture compares by itself
//! (GL_COMPARE_R_TO_TEXTURE, ARB_shadow): r / q against four texels, and a linear filter blends the four answers,
//! which softens the edge of the shadow over one texel.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "shadow2d_proj",
    lecture: "CS380: slides 36 to 41, shadow2DProj",
    source: include_str!("shadow2d_proj.rs"),
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
uniform sampler2DShadow uTexUnit0;
in vec4 vTexCoord;
in vec3 vNormal;
in vec3 vColor;
in vec3 vToLight;
out vec4 fragColor;

void main() {
    float diffuse = max(0.0, dot(normalize(vNormal), normalize(vToLight)));
    vec4 biased = vTexCoord - vec4(0.0, 0.0, 0.0025 * vTexCoord.w, 0.0);
    float lit = shadow2DProj(uTexUnit0, biased).r;
    fragColor = vec4(vColor * (0.22 + 0.85 * diffuse * lit), 1.0);
}
";

/// Side of the depth texture.
const SIZE: GLsizei = 1024;

fn draw(window: &mut Window) {
    glEnable(GL_DEPTH_TEST);
    let fbo = depth_framebuffer(SIZE, GL_LINEAR);
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
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    let aspect = window.panel(1, 1, 0);
    let eye = look_at(dvec3(-0.9, 5.2, 5.6), dvec3(-0.1, 0.4, 0.));
    use_program(program, &perspective(50., aspect, 0.5, 40.), &eye);
    let uniform = |name| safe_glGetUniformLocation(program, name);
    safe_glUniformMatrix4fv(uniform("uSModelViewMatrix"), &light_view);
    safe_glUniformMatrix4fv(uniform("uSProjMatrix"), &(unit_square() * light_projection));
    model.draw(program);
}
