//! Omnidirectional light through a cube map: a lamp with six windows of stained glass.
//!
//! *Texture Mapping*, slides "More Cube Mapping" and "Omni-directional Lighting". What falls on a point is
//! what the cube map has in the direction from the lamp; on the ring, the reflection vector looks it up too.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "cube_map_light",
    lecture: "Texture Mapping: \"Omni-directional Lighting\"",
    source: include_str!("cube_map_light.rs"),
    halves: [2, 2],
    panels: &[],
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
in vec3 vObject; // the lamp is at the origin
in vec3 vObjectNormal;
in vec3 vColor;
out vec4 fragColor;

void main() {
    float distance = length(vObject);
    vec3 normal = normalize(vObjectNormal);
    if (dot(normal, uEye - vObject) < 0.0) normal = -normal;
    float facing = max(0.0, dot(normal, -vObject / distance));
    vec3 light = textureCube(uTexUnit0, vObject).rgb * (4.0 * facing / (1.0 + 0.35 * distance * distance));
    vec3 bounced = reflect(normalize(vObject - uEye), normal);
    vec3 mirrored = textureCube(uTexUnit0, bounced).rgb * (1.0 - vColor.b);
    fragColor = vec4(vColor * (0.10 + light) + 0.8 * mirrored, 1.0);
}
";

fn draw(window: &mut Window) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    let glass = window.picture("slide.ppm").squared();
    let (side, data) = (glass.width, &glass.pixels);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for face in (GL_TEXTURE_CUBE_MAP_POSITIVE_X..).take(6) {
        glTexImage2D(face, 0, GL_RGB8, side, side, 0, GL_RGB, GL_UNSIGNED_BYTE, data);
    }
    glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
    set_filter(GL_TEXTURE_CUBE_MAP, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);

    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let eye = dvec3(0.7, 0.6, 4.4);
    let view = look_at(eye, dvec3(-0.15, -0.2, 0.));
    use_program(program, &perspective(62., window.panel(1, 1, 0), 0.1, 50.), &view);
    safe_glUniform3f(safe_glGetUniformLocation(program, "uEye"), eye.x, eye.y, eye.z);
    // A room around the lamp, without its front wall; white reflects nothing, copper does.
    let mut scene = Mesh::default();
    for turned in [
        DMat4::IDENTITY,
        rotate(90., DVec3::Y),
        rotate(-90., DVec3::Y),
        rotate(90., DVec3::X),
        rotate(-90., DVec3::X),
    ] {
        let wall = turned * translate(0., 0., -2.) * DMat4::from_scale(dvec3(2., 2., 1.));
        scene.append(
            Mesh::surface(1, 1, |s, t| (dvec3(2. * s - 1., 2. * t - 1., 0.), DVec3::Z)).moved(wall),
        );
    }
    let ring = rotate(38., DVec3::X) * rotate(16., DVec3::Z) * DMat4::from_scale(DVec3::splat(0.8));
    scene.append(Mesh::torus(0.24).moved(ring).colored([0.75, 0.45, 0.2]));
    scene.upload().draw(program);
}
