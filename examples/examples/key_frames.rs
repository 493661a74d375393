//! A key-frame model and its decal skin.
//!
//! *Texture Mapping*, slide "Textured Polygonal Models": key-frame geometry, a decal skin, the result. A key frame
//! has a position for each vertex; between two, positions are interpolated. Texture coordinates belong to the
//! vertices, so the skin goes with every frame, and another skin makes another fish.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::{Picture, disc, mix, smooth};
use gl_api::glu::angle::sin_cos_degrees;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "key_frames",
    lecture: "Texture Mapping: \"Textured Polygonal Models\"",
    source: include_str!("key_frames.rs"),
    halves: [6, 4],
    panels: &[
        "key frame 1: tail to the left",
        "key frame 2: tail to the right",
        "geometry: a third of the way between them",
        "decal skin",
        "result: geometry and skin",
        "the same geometry, another skin",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform int uShow; // 0: edges, 1: geometry, 2: with its skin
in vec3 vNormal;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    float light = 0.25 + 0.75 * max(0.0, dot(normalize(vNormal), normalize(vec3(-0.3, 0.8, 0.6))));
    vec3 skin = texture2D(uTexUnit0, vTexCoord).rgb;
    vec3 lit = light * (uShow == 2 ? skin : vec3(0.75, 0.76, 0.78));
    fragColor = vec4(uShow == 0 ? vec3(0.55, 0.75, 1.0) : lit, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.06, 0.10, 0.15, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    let skins = [[0.95, 0.48, 0.12], [0.20, 0.50, 0.80]]
        .map(|color| load_texture(0, skin(color), GL_REPEAT));
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let (first, second) = (fish(-0.55), fish(0.55));
    let between = blend(&first, &second, 1. / 3.).upload();
    let (first, second) = (first.upload(), second.upload());
    for (panel, model, show, skin) in [
        (0, &first, 0, skins[0]),
        (1, &second, 0, skins[0]),
        (2, &between, 1, skins[0]),
        (4, &between, 2, skins[0]),
        (5, &between, 2, skins[1]),
    ] {
        if panel == 4 {
            window.panel(3, 2, 3);
            show_flat(skins[0]);
            glEnable(GL_DEPTH_TEST);
        }
        let aspect = window.panel(3, 2, panel);
        let view = look_at(dvec3(-1.1, 1.7, 4.0), DVec3::ZERO);
        use_program(program, &perspective(36., aspect, 0.1, 50.), &view);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uShow"), show);
        glBindTexture(GL_TEXTURE_2D, skin);
        glPolygonMode(GL_FRONT_AND_BACK, if show == 0 { GL_LINE } else { GL_FILL });
        model.draw(program);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }
}

/// A fish from nose (s = 0) to tail (s = 1), its tail `bend` to the side; t goes once around it.
fn fish(bend: f64) -> Mesh {
    let point = |s: f64, t: f64| {
        let (sin, cos) = sin_cos_degrees(360. * t);
        let body = 0.95 * s.max(0.).sqrt() * (1. - smooth(0.12, 0.92, s)) + 0.09;
        let tail = 0.52 * smooth(0.74, 1.0, s);
        let high = body + tail;
        let wide = 0.5 * body * (1. - smooth(0.7, 0.95, s)) + 0.015;
        let side = bend * (s * s - 0.2 * s);
        dvec3(2.4 * s - 1.2, -high * cos, wide * sin + side)
    };
    Mesh::surface(36, 20, |s, t| {
        let step = 1e-4;
        let by_s = point((s + step).min(1.), t) - point((s - step).max(0.), t);
        let by_t = point(s, t + step) - point(s, t - step);
        (point(s, t), by_s.cross(by_t).normalize_or_zero())
    })
}

/// The frame between two: positions and normals part of the way.
fn blend(from: &Mesh, to: &Mesh, part: f32) -> Mesh {
    let mut frame = from.clone();
    let mix = |a: [f32; 3], b: [f32; 3]| std::array::from_fn(|c| a[c] + part * (b[c] - a[c]));
    for (vertex, other) in frame.vertices.iter_mut().zip(&to.vertices) {
        vertex.position = mix(vertex.position, other.position);
        vertex.normal = mix(vertex.normal, other.normal);
    }
    frame
}

/// A skin: nose left, belly at both edges, back in the middle; stripes, scales and two eyes.
fn skin(color: [f64; 3]) -> Picture {
    Picture::paint(512, 256, |x, y| {
        let from_back = (y - 0.5).abs() * 2.;
        let stripe = smooth(0.13, 0.17, ((3. * x + 0.3 * from_back).fract() - 0.5).abs());
        let scales =
            0.9 + 0.1 * smooth(0.3, 0.5, ((32. * x).fract() - 0.5).hypot((24. * y).fract() - 0.5));
        let back = mix(color, [0.97, 0.95, 0.90], smooth(0.55, 0.95, from_back));
        let skin = mix([0.98, 0.97, 0.94], back, stripe).map(|c| c * scales);
        let skin =
            if x > 0.84 { mix(skin, [0.15, 0.12, 0.14], smooth(0.84, 0.96, x)) } else { skin };
        let eye = |radius| [0.30, 0.70].iter().any(|&at| disc(x, 0.6 * y, 0.10, 0.6 * at, radius));
        if eye(0.014) {
            [0.02; 3]
        } else if eye(0.028) {
            [0.98, 0.95, 0.75]
        } else {
            skin
        }
    })
}
