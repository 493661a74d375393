//! What adds visual realism? Geometry, then light, then textures.
//!
//! *Texture Mapping*, slides "What adds visual realism?" and "Textures Supply Surface Detail". The same
//! triangles three times: their edges alone; with Phong's shading, whose normals are interpolated; and with three
//! textures, which add what no triangle has.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use gl_api::glu::angle::sin_cos_degrees;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "visual_realism",
    lecture: "Texture Mapping: \"What adds visual realism?\"",
    source: include_str!("visual_realism.rs"),
    halves: [6, 2],
    panels: &["geometry only", "Phong shading", "Phong shading + texture maps"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform int uStep; // -1: what hides edges, 0: edges, 1: light, 2: light and texture
in vec3 vPosition;
in vec3 vNormal;
in vec2 vTexCoord;
in vec3 vColor;
out vec4 fragColor;

void main() {
    vec3 normal = normalize(vNormal);
    vec3 toLight = normalize(vec3(-2.0, 3.5, 1.0) - vPosition);
    vec3 halfway = normalize(toLight - normalize(vPosition));
    vec3 color = uStep == 2 ? texture2D(uTexUnit0, vTexCoord).rgb : vColor;
    vec3 lit = color * (0.16 + 0.84 * max(0.0, dot(normal, toLight)))
        + 0.45 * pow(max(0.0, dot(normal, halfway)), 40.0);
    if (uStep < 1) lit = uStep == 0 ? vec3(0.85, 0.90, 1.0) : vec3(0.07, 0.08, 0.11);
    fragColor = vec4(lit, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.07, 0.08, 0.11, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let objects = [
        (floor().upload(), load_texture(0, window.picture("planks.ppm"), GL_REPEAT)),
        (ball().upload(), load_texture(0, window.picture("slide.ppm"), GL_REPEAT)),
        (block().upload(), load_texture(0, window.picture("bricks.ppm"), GL_REPEAT)),
    ];
    for step in 0..3 {
        let aspect = window.panel(3, 1, step);
        let view = look_at(dvec3(0., 1.9, 4.6), dvec3(0., 0.65, 0.));
        use_program(program, &perspective(38., aspect, 0.1, 50.), &view);
        let uStep = safe_glGetUniformLocation(program, "uStep");
        for (model, texture) in &objects {
            glBindTexture(GL_TEXTURE_2D, *texture);
            if step == 0 {
                // The surface in the ground's colour, a little farther away: it hides the edges behind.
                safe_glUniform1i(uStep, -1);
                glEnable(GL_POLYGON_OFFSET_FILL);
                glPolygonOffset(1, 1);
                model.draw(program);
                glDisable(GL_POLYGON_OFFSET_FILL);
                glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
            }
            safe_glUniform1i(uStep, step);
            model.draw(program);
            glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        }
    }
}

fn floor() -> Mesh {
    let point = |s: f64, t: f64| (dvec3(5. * s - 2.5, 0., 2.2 - 4.4 * t), DVec3::Y);
    Mesh::surface(10, 8, point).tiled(1.4, 1.2).colored([0.62, 0.60, 0.56])
}

fn ball() -> Mesh {
    let point = |s: f64, t: f64| {
        let (sin_s, cos_s) = sin_cos_degrees(360. * s);
        let (sin_t, cos_t) = sin_cos_degrees(180. * t);
        let out = dvec3(sin_t * sin_s, -cos_t, sin_t * cos_s);
        (dvec3(-0.62, 0.72, 0.1) + 0.72 * out, out)
    };
    Mesh::surface(24, 14, point).tiled(2., 1.).colored([0.80, 0.35, 0.28])
}

fn block() -> Mesh {
    let place = translate(0.8, 0.5, -0.2) * rotate(32., DVec3::Y);
    let size = DMat4::from_scale(DVec3::splat(0.5));
    Mesh::cube().moved(place * size).colored([0.36, 0.55, 0.80])
}
