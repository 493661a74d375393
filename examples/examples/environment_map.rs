//! The environment cube map: a mirror shows where the bounced view vector points to.
//!
//! *CS380, Texture Mapping*, slides 18 to 23. The lecture hands a `sampler2D` to `textureCube` and
//! mixes up `nNormal` and `vNormal`; here both are repaired by hand. It prints no vertex shader;
//! this one gives the eye coordinates that its slide 23 assumes.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "environment_map",
    lecture: "CS380: slides 18 to 23, \"Environment cube maps\"",
    source: include_str!("environment_map.rs"),
    halves: [2, 2],
    panels: &[],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const VERTEX_SHADER: &str = "\
#version 130
uniform mat4 uProjMatrix;
uniform mat4 uModelViewMatrix;
in vec4 aVertex;
in vec3 aNormal;
out vec3 vNormal;
out vec4 vPosition;

void main() {
    vNormal = vec3(uModelViewMatrix * vec4(aNormal, 0.0));
    vPosition = uModelViewMatrix * aVertex;
    gl_Position = uProjMatrix * vPosition;
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform samplerCube uTexUnit0;
in vec3 vNormal;
in vec4 vPosition;
out vec4 fragColor;

vec3 reflect(vec3 w, vec3 n){
    return n*(dot(w,n)*2.0) - w; // bounce vector
}

void main() {
    vec3 normal = normalize(vNormal);
    vec3 reflected = reflect(normalize(vec3(-vPosition)), normal);
    vec4 texColor0 = textureCube(uTexUnit0, reflected);
    fragColor = vec4(texColor0.r, texColor0.g, texColor0.b, 1.0);
}
";

/// The environment itself, behind everything: a square that fills the window.
const SKY_VERTEX_SHADER: &str = "\
#version 130
uniform mat4 uProjMatrix;
in vec4 aVertex;
out vec3 vDirection;

void main() {
    vDirection = vec3(aVertex.x / uProjMatrix[0][0], aVertex.y / uProjMatrix[1][1], -1.0);
    gl_Position = vec4(aVertex.xy, 0.0, 1.0);
}
";

const SKY_FRAGMENT_SHADER: &str = "\
#version 130
uniform samplerCube uTexUnit0;
in vec3 vDirection;
out vec4 fragColor;

void main() {
    fragColor = textureCube(uTexUnit0, vDirection);
}
";

fn draw(window: &mut Window) {
    glViewport(0, 0, window.width, window.height);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    load_cube_map(window);

    let aspect = f64::from(window.width) / f64::from(window.height);
    let projection = perspective(60., aspect, 0.1, 50.);

    let sky = initShaders(window, SKY_VERTEX_SHADER, SKY_FRAGMENT_SHADER);
    glUseProgram(sky);
    safe_glUniform1i(safe_glGetUniformLocation(sky, "uTexUnit0"), 0);
    safe_glUniformMatrix4fv(safe_glGetUniformLocation(sky, "uProjMatrix"), &projection);
    Mesh::plane().upload().draw(sky);

    let h_program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    glUseProgram(h_program);
    safe_glUniform1i(safe_glGetUniformLocation(h_program, "uTexUnit0"), 0);
    safe_glUniformMatrix4fv(safe_glGetUniformLocation(h_program, "uProjMatrix"), &projection);
    let h_uModelViewMatrix = safe_glGetUniformLocation(h_program, "uModelViewMatrix");

    glEnable(GL_DEPTH_TEST);
    let place = translate(0., 0., -3.6);
    let tilted = place * rotate(72., DVec3::X) * rotate(24., DVec3::Z);
    safe_glUniformMatrix4fv(h_uModelViewMatrix, &tilted);
    Mesh::torus(0.36).upload().draw(h_program);
    safe_glUniformMatrix4fv(h_uModelViewMatrix, &(place * DMat4::from_scale(DVec3::splat(0.5))));
    Mesh::sphere().upload().draw(h_program);
}
