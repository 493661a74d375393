//! A diffuse surface is equally bright from everywhere; a Blinn-Phong highlight goes with the eye.
//!
//! *CS380*, "Diffuse reflectance model" ("we do not need to use the v vector at all") and "Blinn-Phong reflectance
//! model". Above diffuse, below Blinn-Phong: a ball under one light, from the left and from the right; and the
//! difference of the two colours of each of its points, unrolled by longitude and latitude. Above it is black.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "view_independence",
    lecture: "CS380: \"Diffuse reflectance model\", no v",
    source: include_str!("view_independence.rs"),
    halves: [6, 4],
    panels: &[
        "diffuse, from the left",
        "diffuse, from the right",
        "difference of each point: 0",
        "Blinn-Phong, from the left",
        "from the right",
        "difference of each point",
    ],
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
uniform int uUnrolled;
in vec4 aVertex;
in vec3 aNormal;
in vec2 aTexCoord;
out vec3 vObject;
out vec3 vNormal;

void main() {
    vObject = aVertex.xyz;
    vNormal = aNormal;
    gl_Position = uProjMatrix * uModelViewMatrix * aVertex;
    if (uUnrolled == 1) gl_Position = vec4(2.0 * aTexCoord - 1.0, 0.0, 1.0);
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform vec3 uEye;
uniform vec3 uOtherEye;
uniform int uSpecular;
uniform int uUnrolled;
in vec3 vObject;
in vec3 vNormal;
out vec4 fragColor;

vec3 shade(vec3 eye) {
    vec3 n = normalize(vNormal), l = normalize(vec3(0.3, 0.9, 0.8)), v = normalize(eye - vObject);
    float diffuse = max(0.0, dot(n, l));
    float specular = diffuse > 0.0 ? pow(max(0.0, dot(n, normalize(l + v))), 40.0) : 0.0;
    return vec3(0.75, 0.50, 0.30) * (0.1 + 0.8 * diffuse) + float(uSpecular) * 0.8 * specular;
}

void main() {
    vec3 color = shade(uEye);
    if (uUnrolled == 1) color = abs(color - shade(uOtherEye));
    fragColor = vec4(color, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.16, 0.18, 0.22, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    let uniform = |name| safe_glGetUniformLocation(program, name);
    let ball = Mesh::sphere().upload();
    let eyes = [dvec3(-2.4, 0.6, 2.4), dvec3(2.4, 0.6, 2.4)];
    for panel in 0..6 {
        let aspect = window.panel(3, 2, panel);
        let eye = eyes[panel as usize % 3 % 2];
        use_program(program, &perspective(42., aspect, 0.1, 50.), &look_at(eye, DVec3::ZERO));
        for (name, DVec3 { x, y, z }) in [("uEye", eye), ("uOtherEye", eyes[1])] {
            safe_glUniform3f(uniform(name), x, y, z);
        }
        safe_glUniform1i(uniform("uSpecular"), panel / 3);
        safe_glUniform1i(uniform("uUnrolled"), i32::from(panel % 3 == 2));
        ball.draw(program);
    }
}
