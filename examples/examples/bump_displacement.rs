//! Bump mapping beside displacement: the silhouette tells them apart.
//!
//! *Texture Mapping*, slides "Displacement and Bump Mapping" (after Blinn 1976) and "Displacement vs. bump
//! mapping"; *eScience*, slide 30. From left to right: the sphere; Blinn's perturbed normal
//! N' = N + h_u (T × N) + h_v (S × N); and P' = P + h N in the vertex shader, with the same normals.
//! With S × T = N, the product P'_u × P'_v gives N × T where the slide prints T × N.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use gl_api::glu::angle::sin_cos_degrees;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "bump_displacement",
    lecture: "Texture Mapping: \"Displacement and Bump Mapping\"",
    source: include_str!("bump_displacement.rs"),
    halves: [6, 2],
    panels: &["smooth", "bump map", "displacement"],
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
uniform sampler2D uTexUnit0;
uniform float uDisplace;
in vec4 aVertex;
in vec3 aNormal;
in vec2 aTexCoord;
out vec3 vNormal;
out vec2 vTexCoord;

void main() {
    float h = uDisplace * texture2DLod(uTexUnit0, aTexCoord * vec2(4.0, 2.0), 1.0).r;
    vNormal = aNormal;
    vTexCoord = aTexCoord;
    gl_Position = uProjMatrix * uModelViewMatrix * (aVertex + vec4(h * aNormal, 0.0));
}
";

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0; // heights
uniform mat4 uModelViewMatrix;
uniform float uBump;
in vec3 vNormal;
in vec2 vTexCoord;
out vec4 fragColor;

float h(vec2 at) { return uBump * texture2D(uTexUnit0, at * vec2(4.0, 2.0)).r; }

void main() {
    vec3 N = normalize(vNormal);
    vec3 S = normalize(cross(vec3(0.0, 1.0, 0.0), N)); // eastward
    vec3 T = cross(N, S);                              // northward
    // Differences of the height over the way on the sphere, 2 pi around and pi from pole to pole.
    const float d = 0.002;
    float around = max(0.2, sqrt(1.0 - N.y * N.y));
    float h_u = (h(vTexCoord + vec2(d, 0)) - h(vTexCoord - vec2(d, 0))) / (2.0 * d * 6.2832 * around);
    float h_v = (h(vTexCoord + vec2(0, d)) - h(vTexCoord - vec2(0, d))) / (2.0 * d * 3.1416);
    vec3 perturbed = normalize(N + h_u * cross(N, T) + h_v * cross(S, N));
    vec3 normal = vec3(uModelViewMatrix * vec4(perturbed, 0.0));
    float diffuse = max(0.0, dot(normal, normalize(vec3(-0.6, 0.7, 0.6))));
    fragColor = vec4(vec3(0.92, 0.72, 0.52) * (0.12 + 0.95 * diffuse), 1.0);
}
";

/// How far the bricks stand out of the sphere: of the normals, of the vertices.
const PANELS: [(f64, f64); 3] = [(0., 0.), (0.13, 0.), (0.13, 0.13)];

fn draw(window: &mut Window) {
    glClearColor(0.10, 0.12, 0.18, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    load_texture(0, window.picture("bricks_height.ppm"), GL_REPEAT);
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    // Fine enough for the displaced vertices to follow the joints.
    let ball = Mesh::surface(288, 144, |s, t| {
        let (sin_s, cos_s) = sin_cos_degrees(360. * s);
        let (sin_t, cos_t) = sin_cos_degrees(180. * t);
        let out = dvec3(sin_t * sin_s, -cos_t, sin_t * cos_s);
        (out, out)
    })
    .upload();
    for (panel, (bump, displace)) in (0..).zip(PANELS) {
        let aspect = window.panel(3, 1, panel);
        let place = translate(0., 0., -3.5) * rotate(24., DVec3::X);
        use_program(program, &perspective(42., aspect, 0.1, 50.), &place);
        safe_glUniform1f(safe_glGetUniformLocation(program, "uBump"), bump);
        safe_glUniform1f(safe_glGetUniformLocation(program, "uDisplace"), displace);
        ball.draw(program);
    }
}
