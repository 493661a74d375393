//! Texture maps in combination: each parameter of the shading equation has a map.
//!
//! *Texture Mapping*, slide "Combining texture maps" (diffuse colour, environment map, specular coefficient,
//! material properties), and "Parametric texture mapping": a texture can modulate "diffuse color, specular color,
//! specular exponent, ...". On the left the inputs, and the vase with the exponent map alone: from 2 to 256, the
//! highlight is wide where the map is dark and a point where it is white.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::{Color, Picture};
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "material_maps",
    lecture: "Texture Mapping: \"Combining texture maps\"",
    source: include_str!("material_maps.rs"),
    halves: [6, 3],
    panels: &[
        "diffuse colour",
        "environment map",
        "specular coefficient",
        "specular exponent",
        "material: how much it mirrors",
        "the exponent map alone",
        "all in combination",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform samplerCube uTexUnit0; // environment
uniform sampler2D uTexUnit1;   // diffuse colour
uniform sampler2D uTexUnit2;   // specular coefficient, specular exponent, mirror
uniform mat4 uModelViewMatrix;
uniform int uAlone;            // 1: the exponent map alone
in vec3 vPosition;
in vec3 vNormal;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toEye = normalize(-vPosition);
    vec3 toLight = normalize(vec3(1.5, 2.0, 1.8) - vPosition);
    vec3 halfway = normalize(toLight + toEye);
    vec3 material = texture2D(uTexUnit2, vTexCoord).rgb;
    vec3 kd = texture2D(uTexUnit1, vTexCoord).rgb;
    float ks = material.r, n = exp2(1.0 + 7.0 * material.g), mirror = material.b;
    vec3 environment = textureCube(uTexUnit0, reflect(-toEye, normal)).rgb;
    if (uAlone == 1) { kd = vec3(0.35, 0.38, 0.45); ks = 0.8; mirror = 0.0; }
    vec3 color = kd * (0.15 + 0.85 * max(0.0, dot(normal, toLight)))
        + ks * pow(max(0.0, dot(normal, halfway)), n)
        + mirror * environment * mix(vec3(1.0), kd, 0.6);
    fragColor = vec4(color, 1.0);
}
";

/// What a square of the vase is made of.
struct Material {
    diffuse: Color,
    specular: f64,
    exponent: f64,
    mirror: f64,
}

const CLAY: Material =
    Material { diffuse: [0.72, 0.36, 0.22], specular: 0.10, exponent: 0.15, mirror: 0.0 };
const ENAMEL: Material =
    Material { diffuse: [0.10, 0.25, 0.55], specular: 0.90, exponent: 1.0, mirror: 0.10 };
const GOLD: Material =
    Material { diffuse: [0.55, 0.40, 0.12], specular: 0.35, exponent: 0.6, mirror: 0.85 };
const SATIN: Material =
    Material { diffuse: [0.80, 0.76, 0.66], specular: 0.45, exponent: 0.35, mirror: 0.0 };

/// The material of a point: squares, with gold between them.
fn material(x: f64, y: f64) -> &'static Material {
    let (u, v) = (8. * x, 6. * y);
    if u.fract().min(v.fract()) < 0.14 {
        return &GOLD;
    }
    [&CLAY, &ENAMEL, &SATIN, &GOLD][(u as usize + 2 * (v as usize)) % 4]
}

fn paint(of: fn(&Material) -> Color) -> Picture {
    Picture::paint(256, 256, move |x, y| of(material(x, y)))
}

fn draw(window: &mut Window) {
    glClearColor(0.09, 0.10, 0.13, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    let diffuse = load_texture(1, paint(|m| m.diffuse), GL_REPEAT);
    let all = load_texture(2, paint(|m| [m.specular, m.exponent, m.mirror]), GL_REPEAT);
    let grey: [fn(&Material) -> Color; 3] =
        [|m| [m.specular; 3], |m| [m.exponent; 3], |m| [m.mirror; 3]];
    let [specular, exponent, mirror] = grey.map(|of| load_texture(2, paint(of), GL_REPEAT));
    glBindTexture(GL_TEXTURE_2D, all);
    let environment = load_cube_map(window);

    window.panel(4, 3, 0);
    show_flat(diffuse);
    window.panel(4, 3, 1);
    show_unfolded(window, environment);
    for (panel, texture) in [(4, specular), (5, exponent), (8, mirror)] {
        window.panel(4, 3, panel);
        show_flat(texture);
    }

    glEnable(GL_DEPTH_TEST);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let vase = Mesh::vase().upload();
    for alone in [1, 0] {
        let aspect = if alone == 1 { window.panel(4, 3, 9) } else { window.panel(2, 1, 1) };
        let far = if alone == 1 { -4. } else { -3.3 };
        let place = translate(0., 0.04, far) * rotate(14., DVec3::X) * rotate(30., DVec3::Y);
        use_program(program, &perspective(40., aspect, 0.1, 50.), &place);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uAlone"), alone);
        vase.draw(program);
    }
}
