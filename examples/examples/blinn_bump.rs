//! Bump mapping after Blinn: the normal is turned by the slope of a height map, the surface stays.
//!
//! *Texture Mapping*, "Bump mapping" (Blinn 1978, "Simulation of wrinkled surfaces"); *eScience*, slide 30.
//! From left to right: the height map F; the smooth torus; and the torus with
//! N' = N + F_u (N × P_v) / |N| + F_v (P_u × N) / |N|, with F_u, F_v as central differences.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::{Picture, smooth};
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "blinn_bump",
    lecture: "Texture Mapping: \"Bump mapping\"; eScience: slide 30",
    source: include_str!("blinn_bump.rs"),
    halves: [6, 2],
    panels: &["height map F", "smooth", "bumped"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0; // the heights
uniform mat4 uModelViewMatrix;
uniform float uHeight;
in vec3 vPosition;
in vec3 vObject;
in vec3 vObjectNormal;
in vec2 vTexCoord;
out vec4 fragColor;

const vec2 TILES = vec2(10.0, 4.0);

float F(vec2 at) { return uHeight * texture2D(uTexUnit0, at * TILES).r; }

void main() {
    vec3 N = normalize(vObjectNormal);
    // The torus runs around y: P_u along its ring, P_v around its tube, for u and v from 0 to 1.
    vec3 along = normalize(vec3(vObject.z, 0.0, -vObject.x));
    vec3 P_u = 6.2832 * length(vObject.xz) * along;
    vec3 P_v = 6.2832 * 0.42 * cross(N, along);
    const float d = 1.0 / 2048.0;
    float F_u = (F(vTexCoord + vec2(d, 0.0)) - F(vTexCoord - vec2(d, 0.0))) / (2.0 * d);
    float F_v = (F(vTexCoord + vec2(0.0, d)) - F(vTexCoord - vec2(0.0, d))) / (2.0 * d);
    vec3 surface = cross(P_u, P_v); // not of length 1
    vec3 bumped = surface + F_u * cross(N, P_v) + F_v * cross(P_u, N);
    vec3 n = normalize(vec3(uModelViewMatrix * vec4(bumped, 0.0)));
    vec3 light = normalize(vec3(-0.5, 0.8, 0.7));
    vec3 halfway = normalize(light - normalize(vPosition));
    float diffuse = max(0.0, dot(n, light));
    float specular = pow(max(0.0, dot(n, halfway)), 30.0);
    fragColor = vec4(vec3(0.95, 0.55, 0.20) * (0.15 + 0.8 * diffuse) + 0.35 * specular, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.10, 0.12, 0.16, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    let wrinkles = Picture::paint(128, 128, |x, y| {
        let (dx, dy) = (2. * x - 1., 2. * y - 1.);
        [1. - smooth(0.2, 0.95, (dx * dx + dy * dy).sqrt()); 3]
    });
    load_texture(0, wrinkles, GL_REPEAT);

    window.panel(3, 1, 0);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glBegin(GL_QUADS);
    for (s, t) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
        glTexCoord2f(4 * s, 4 * t);
        glVertex2f(1.5 * f64::from(s) - 0.75, 1.5 * f64::from(t) - 0.75);
    }
    glEnd();

    glEnable(GL_DEPTH_TEST);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let torus = Mesh::torus(0.42).upload();
    for (panel, height) in [(1, 0.), (2, 0.09)] {
        let aspect = window.panel(3, 1, panel);
        let place = translate(0., 0., -4.4) * rotate(48., DVec3::X);
        use_program(program, &perspective(42., aspect, 0.1, 50.), &place);
        safe_glUniform1f(safe_glGetUniformLocation(program, "uHeight"), height);
        torus.draw(program);
    }
}
