//! Displacement over a rectangle, a bump map around a cylinder, and their input.
//!
//! *Texture Mapping*, slides "Displacement vs. bump mapping" and "(cont'd)". The slide before prints the perturbed
//! normal as N + h_u (T × N) + h_v (S × N). With N = S × T, P'_u × P'_v is N + h_u (N × T) + h_v (S × N): the first
//! product is printed the wrong way round. The last panel has it as printed: left flanks are lit as right ones.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::{Picture, smooth};
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "displacement_vs_bump",
    lecture: "Texture Mapping: \"Displacement vs. bump mapping\"",
    source: include_str!("displacement_vs_bump.rs"),
    halves: [6, 4],
    panels: &[
        "input texture",
        "displacement over a rectangle",
        "bump map over the same rectangle",
        "original rendering of a cylinder",
        "bump map wrapped around it",
        "as printed, T × N: left and right are swapped",
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
uniform sampler2D uTexUnit0;
uniform float uDisplace;
in vec4 aVertex;
in vec3 aNormal;
in vec2 aTexCoord;
out vec3 vNormal;
out vec2 vTexCoord;

void main() {
    float h = uDisplace * texture2DLod(uTexUnit0, aTexCoord, 0.0).r;
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
uniform float uSign; // 1: N x T; -1: T x N, as printed
uniform vec2 uSize;  // of the unit square of coordinates on the surface
in vec3 vNormal;
in vec2 vTexCoord;
out vec4 fragColor;

float h(vec2 at) { return uBump * texture2D(uTexUnit0, at).r; }

void main() {
    vec3 N = normalize(vNormal);
    vec3 S = normalize(cross(vec3(0.0, 1.0, 0.0), N));
    vec3 T = cross(N, S);
    const float d = 0.004;
    float h_u = (h(vTexCoord + vec2(d, 0)) - h(vTexCoord - vec2(d, 0))) / (2.0 * d * uSize.x);
    float h_v = (h(vTexCoord + vec2(0, d)) - h(vTexCoord - vec2(0, d))) / (2.0 * d * uSize.y);
    vec3 perturbed = normalize(N + uSign * h_u * cross(N, T) + h_v * cross(S, N));
    if (abs(N.y) > 0.99) perturbed = N; // the cylinder's caps have no S
    vec3 normal = vec3(uModelViewMatrix * vec4(perturbed, 0.0));
    float diffuse = max(0.0, dot(normal, normalize(vec3(-0.7, 0.5, 0.8))));
    fragColor = vec4(vec3(0.80, 0.78, 0.70) * (0.12 + 0.95 * diffuse), 1.0);
}
";

/// Heights of the normals and of the vertices, and the sign of the first product.
const LOOKS: [[f64; 3]; 5] =
    [[0.22, 0.22, 1.], [0.22, 0., 1.], [0., 0., 1.], [0.10, 0., 1.], [0.10, 0., -1.]];

fn draw(window: &mut Window) {
    glClearColor(0.09, 0.11, 0.16, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    let heights = load_texture(0, studs(), GL_REPEAT);
    window.panel(3, 2, 0);
    show_flat(heights);
    glEnable(GL_DEPTH_TEST);
    let program = initShaders(window, VERTEX_SHADER, FRAGMENT_SHADER);
    let rectangle = Mesh::surface(160, 160, |s, t| (dvec3(2. * s - 1., 2. * t - 1., 0.), DVec3::Z));
    let (rectangle, cylinder) = (rectangle.upload(), Mesh::cylinder().tiled(3., 1.).upload());
    for (panel, [bump, displace, sign]) in (1..).zip(LOOKS) {
        let aspect = window.panel(3, 2, panel);
        let is_flat = panel < 3;
        let turned = if is_flat {
            rotate(-62., DVec3::X) * rotate(28., DVec3::Z)
        } else {
            rotate(24., DVec3::X)
        };
        let place = translate(0., 0.1, if is_flat { -4.1 } else { -4.4 }) * turned;
        use_program(program, &perspective(42., aspect, 0.1, 50.), &place);
        for (name, value) in [("uBump", bump), ("uDisplace", displace), ("uSign", sign)] {
            safe_glUniform1f(safe_glGetUniformLocation(program, name), value);
        }
        let around = if is_flat { 2. } else { 2.0944 };
        glUniform2f(safe_glGetUniformLocation(program, "uSize"), around, 2);
        if is_flat { rectangle.draw(program) } else { cylinder.draw(program) }
    }
}

/// Nine studs, each with a ring around it.
fn studs() -> Picture {
    Picture::paint(256, 256, |x, y| {
        let (u, v) = ((3. * x).fract() - 0.5, (3. * y).fract() - 0.5);
        let from_middle = u.hypot(v);
        let stud = 1. - smooth(0.10, 0.22, from_middle);
        let ring = 1. - smooth(0.02, 0.06, (from_middle - 0.38).abs());
        [stud.max(0.6 * ring); 3]
    })
}
