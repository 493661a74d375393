//! Gouraud shading is wrong: its error against colours in perspective, and against Phong shading.
//!
//! *eScience*, slide 23, "Remarques". Above, four colours on a floor: linear in the window, as Gouraud shading
//! interpolates, where the square falls apart into its two triangles; linear in space.
//! Below, a highlight on a coarse floor: light at the corners, linear in space; light at each pixel, with the
//! normal interpolated (Phong). The last picture of each row is the difference of its first two, three times.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "gouraud",
    lecture: "eScience: slide 23, Gouraud shading is wrong",
    source: include_str!("gouraud.rs"),
    halves: [6, 4],
    panels: &[
        "Gouraud: linear in the window",
        "linear in space",
        "difference × 3",
        "Gouraud: light at the corners",
        "Phong: light at each pixel",
        "difference × 3",
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
in vec4 aVertex;
in vec3 aColor;
noperspective out vec3 vWindow; // linear in the window
smooth out vec3 vSpace;         // linear in space
smooth out vec3 vLight;         // of the corner
smooth out vec3 vObject;

vec3 light(vec3 p) {
    vec3 to_light = normalize(vec3(0.3, 0.7, 0.2) - p), to_eye = normalize(vec3(0.0, 1.6, 2.4) - p);
    float specular = pow(max(0.0, normalize(to_light + to_eye).y), 40.0);
    return vec3(0.30, 0.42, 0.60) * (0.15 + 0.85 * to_light.y) + specular;
}

void main() {
    gl_Position = uProjMatrix * uModelViewMatrix * aVertex;
    vWindow = aColor;
    vSpace = aColor;
    vLight = light(aVertex.xyz);
    vObject = aVertex.xyz;
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform int uShow;
noperspective in vec3 vWindow;
smooth in vec3 vSpace;
smooth in vec3 vLight;
smooth in vec3 vObject;
out vec4 fragColor;

vec3 light(vec3 p) {
    vec3 to_light = normalize(vec3(0.3, 0.7, 0.2) - p), to_eye = normalize(vec3(0.0, 1.6, 2.4) - p);
    float specular = pow(max(0.0, normalize(to_light + to_eye).y), 40.0);
    return vec3(0.30, 0.42, 0.60) * (0.15 + 0.85 * to_light.y) + specular;
}

void main() {
    vec3 color = vWindow;
    if (uShow == 1) color = vSpace;
    if (uShow == 2) color = abs(vWindow - vSpace) * 3.0;
    if (uShow == 3) color = vLight;
    if (uShow == 4) color = light(vObject);
    if (uShow == 5) color = abs(vLight - light(vObject)) * 3.0;
    fragColor = vec4(color, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.14, 0.15, 0.18, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    let flat = rotate(-90., DVec3::X) * DMat4::from_scale(dvec3(1.2, 1.6, 1.));
    let mut floor = Mesh::plane().moved(flat);
    for (vertex, color) in floor.vertices.iter_mut().zip(COLORS) {
        vertex.color = color;
    }
    let corners = |s: f64, t: f64| (dvec3(2. * s - 1., 2. * t - 1., 0.), DVec3::Z);
    let coarse = Mesh::surface(4, 4, corners).moved(flat);
    let meshes = [floor.upload(), coarse.upload()];
    for panel in 0..6 {
        let aspect = window.panel(3, 2, panel);
        let eye = look_at(dvec3(0., 1.6, 2.4), dvec3(0., -0.15, 0.));
        use_program(program, &perspective(48., aspect, 0.1, 50.), &eye);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uShow"), panel);
        meshes[panel as usize / 3].draw(program);
    }
}

/// Of the floor's corners.
const COLORS: [[f32; 3]; 4] = [[1.0, 0.2, 0.2], [1.0, 0.9, 0.2], [0.2, 0.4, 1.0], [0.3, 1.0, 0.5]];
