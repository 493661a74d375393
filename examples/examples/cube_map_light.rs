//! Omnidirectional light through a cube map.
//!
//! *Texture Mapping*, slides "More Cube Mapping" and "Omni-directional Lighting". The cube map has a colour and a
//! number of lamps for each face, so that it is seen which one lights what. In the middle "access texture by surface
//! reflection vector": things of polished plaster, lit from everywhere. On the right the map is a lantern in the middle
//! of a room: each point of a wall looks up the direction from there.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::picture::{Picture, disc};
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "cube_map_light",
    lecture: "Texture Mapping: \"Omni-directional Lighting\"",
    source: include_str!("cube_map_light.rs"),
    halves: [6, 2],
    panels: &[
        "the light: six faces, one to six lamps",
        "access by the reflection vector",
        "access by the direction from a lamp in a room",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform samplerCube uTexUnit0;
uniform vec3 uEye;
uniform int uRoom; // 1: the lantern is at the origin
in vec3 vObject;
in vec3 vObjectNormal;
in vec3 vColor;
out vec4 fragColor;

void main() {
    vec3 normal = normalize(vObjectNormal);
    vec3 bounced = reflect(normalize(vObject - uEye), normal);
    vec3 all = textureCube(uTexUnit0, normal, 8.0).rgb;
    vec3 lit = vColor * (0.10 + 1.6 * all) + textureCube(uTexUnit0, bounced, 1.0).rgb;
    float distance = length(vObject);
    float facing = max(0.0, dot(normal, -vObject / distance));
    vec3 thrown = vColor * (0.07 + 3.0 * facing * textureCube(uTexUnit0, vObject).rgb / distance);
    fragColor = vec4(uRoom == 1 ? thrown : lit, 1.0);
}
";

/// Of +X, -X, +Y, -Y, +Z, -Z.
const COLORS: [[f64; 3]; 6] = [
    [1.0, 0.30, 0.22],
    [0.25, 0.90, 0.45],
    [1.0, 0.97, 0.90],
    [0.35, 0.45, 1.0],
    [1.0, 0.45, 0.95],
    [1.0, 0.85, 0.25],
];

/// Where the lamps of a face are; face n has the first n + 1.
const LAMPS: [[f64; 2]; 6] =
    [[0.5, 0.5], [0.22, 0.5], [0.78, 0.5], [0.5, 0.22], [0.5, 0.78], [0.22, 0.22]];

fn draw(window: &mut Window) {
    glClearColor(0.05, 0.06, 0.08, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glBindTexture(GL_TEXTURE_CUBE_MAP, 1);
    for (face, target) in (GL_TEXTURE_CUBE_MAP_POSITIVE_X..).take(6).enumerate() {
        let lamps = Picture::paint(128, 128, |x, y| {
            let lit = LAMPS[..=face].iter().any(|&[u, v]| disc(x, y, u, v, 0.11));
            if lit { COLORS[face] } else { COLORS[face].map(|c| 0.05 * c) }
        });
        glTexImage2D(target, 0, GL_RGB8, 128, 128, 0, GL_RGB, GL_UNSIGNED_BYTE, &lamps.pixels);
    }
    glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
    set_filter(GL_TEXTURE_CUBE_MAP, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    window.panel(3, 1, 0);
    show_unfolded(window, 1);

    glEnable(GL_DEPTH_TEST);
    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let eyes = [(1, dvec3(0.5, 1.2, 5.6), things()), (2, dvec3(0.5, 0.4, 4.6), room())];
    for (panel, eye, scene) in eyes {
        let projection =
            perspective(if panel == 1 { 36. } else { 56. }, window.panel(3, 1, panel), 0.1, 50.);
        use_program(program, &projection, &look_at(eye, DVec3::ZERO));
        safe_glUniform3f(safe_glGetUniformLocation(program, "uEye"), eye.x, eye.y, eye.z);
        safe_glUniform1i(safe_glGetUniformLocation(program, "uRoom"), panel - 1);
        scene.upload().draw(program);
    }
}

/// A vase, a ball and a ring.
fn things() -> Mesh {
    let plaster = [0.62, 0.60, 0.58];
    let mut things = Mesh::vase().moved(translate(-0.85, 0.2, 0.)).colored(plaster);
    let ball = translate(0.75, 0.55, -0.2) * DMat4::from_scale(DVec3::splat(0.6));
    things.append(Mesh::sphere().moved(ball).colored(plaster));
    let ring =
        translate(0.7, -0.65, 0.3) * rotate(20., DVec3::X) * DMat4::from_scale(DVec3::splat(0.6));
    things.append(Mesh::torus(0.36).moved(ring).colored(plaster));
    things
}

/// Five walls around the lantern; there is no front one.
fn room() -> Mesh {
    let mut room = Mesh::default();
    for turned in [
        DMat4::IDENTITY,
        rotate(90., DVec3::Y),
        rotate(-90., DVec3::Y),
        rotate(90., DVec3::X),
        rotate(-90., DVec3::X),
    ] {
        let wall = turned * translate(0., 0., -2.) * DMat4::from_scale(dvec3(2., 2., 1.));
        room.append(Mesh::plane().moved(wall));
    }
    room
}
