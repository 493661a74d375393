//! The gift wrapping problem: flat paper does not go around everything.
//!
//! *Texture Mapping*, slide "Source of texture coordinates?". The paper has circles of one size. Around a sphere
//! they shrink toward the poles; around a cube they are pleated on the lids, worst at the corners; a cube unfolded keeps them, but
//! the paper is cut along seven edges. A cone is developable: one cut, and every circle stays a circle. The
//! captions are measured on the triangles: the area of a circle by the mean, and the longest ellipse.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::{Picture, disc, mix};
use examples::stretch::extremes;
use gl_api::glu::angle::sin_cos_degrees;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "gift_wrapping",
    lecture: "Texture Mapping: \"Source of texture coordinates?\"",
    source: include_str!("gift_wrapping.rs"),
    halves: [4, 4],
    panels: &[],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
in vec3 vPosition;
in vec3 vNormal;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec3 facet = cross(dFdx(vPosition), dFdy(vPosition));
    vec3 normal = normalize(dot(vNormal, vNormal) > 0.5 ? vNormal : facet);
    float light = 0.35 + 0.65 * max(0.0, dot(normal, normalize(vec3(-0.4, 0.6, 0.7))));
    fragColor = vec4(light * texture2D(uTexUnit0, vTexCoord).rgb, 1.0);
}
";

fn draw(window: &mut Window) {
    glClearColor(0.10, 0.11, 0.15, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    load_texture(0, paper(), GL_REPEAT);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    for (panel, (name, mesh, tilt)) in (0..).zip(wrapped()) {
        let aspect = window.panel(2, 2, panel);
        let place = translate(0., 0.12, -5.4) * rotate(tilt, DVec3::X) * rotate(-32., DVec3::Y);
        use_program(program, &perspective(38., aspect, 0.1, 50.), &place);
        mesh.upload().draw(program);
        let [least, most, axes] = extremes(&mesh);
        let measured = format!("area {least:.2} to {most:.2}, ellipses up to {axes:.1} : 1");
        let (x, y) = (0.5 * f64::from(panel % 2), 0.5 - 0.5 * f64::from(panel / 2));
        window.caption(x, y, format!("{name}\n{measured}"));
    }
}

/// Circles on a grid, in the colours of their place.
fn paper() -> Picture {
    Picture::paint(512, 512, |x, y| {
        let (u, v) = ((16. * x).fract(), (16. * y).fract());
        let ground = mix([0.96, 0.94, 0.88], [0.80, 0.88, 0.96], y);
        let ink = mix([0.80, 0.16, 0.20], [0.12, 0.30, 0.65], x);
        let line = u.min(v).min(1. - u).min(1. - v) < 0.03;
        if disc(u, v, 0.5, 0.5, 0.36) {
            ink
        } else if line {
            [0.55; 3]
        } else {
            ground
        }
    })
}

/// The surfaces, and how far each is tilted toward the eye.
pub fn wrapped() -> [(&'static str, Mesh, f64); 4] {
    let direction = |s: f64, t: f64| {
        let (sin_s, cos_s) = sin_cos_degrees(360. * s);
        let (sin_t, cos_t) = sin_cos_degrees(180. * t);
        dvec3(sin_t * sin_s, -cos_t, sin_t * cos_s)
    };
    // The paper is twice as long as it is high, as its squares are to be squares at the equator.
    let sphere = Mesh::surface(96, 48, |s, t| (1.25 * direction(s, t), direction(s, t)));
    // Around the sides, and from the middle of a lid over its edge; the shader finds its normals.
    let cube = Mesh::surface(96, 48, |s, t| {
        let side = direction(s, 0.5);
        let edge = side / side.abs().max_element();
        let up = (8. * (t - 0.5)).clamp(-2., 2.) / 2.;
        (edge * (2. * (1. - (2. * t - 1.).abs())).min(1.) + DVec3::Y * up, DVec3::ZERO)
    });
    [
        ("a sphere", sphere.tiled(2., 1.), 40.),
        ("a cube: sides fit, lids are pleated", cube.tiled(2., 1.), 35.),
        ("a cube, unfolded: 7 edges are cut", unfolded_cube(), 35.),
        ("a cone, which is developable", cone(), 20.),
    ]
}

/// The six faces in a cross of the paper.
fn unfolded_cube() -> Mesh {
    let mut cube = Mesh::cube();
    for (face, corners) in cube.vertices.chunks_exact_mut(4).enumerate() {
        let (column, row) = [(2, 1), (0, 1), (1, 2), (1, 0), (1, 1), (3, 1)][face];
        for corner in corners {
            let [s, t] = corner.tex_coord;
            corner.tex_coord = [0.25 * (column as f32 + s), 0.25 * (row as f32 + t)];
        }
    }
    cube
}

/// A cone from a half circle of paper: slant 2, radius 1.
fn cone() -> Mesh {
    let mut cone = Mesh::surface(96, 32, |s, t| {
        let (sin, cos) = sin_cos_degrees(360. * s);
        let down = 2. * (1. - t);
        let normal = dvec3(0.866 * sin, 0.5, 0.866 * cos);
        (1.2 * dvec3(0.5 * down * sin, 0.866 * (1. - down), 0.5 * down * cos), normal)
    });
    for vertex in &mut cone.vertices {
        let [s, t] = vertex.tex_coord.map(f64::from);
        let (sin, cos) = sin_cos_degrees(180. * s);
        let from_apex = 0.5 * (1. - t);
        vertex.tex_coord = [0.5 - from_apex * cos, 1. - from_apex * sin].map(|c| c as f32);
    }
    cone
}
