//! A dynamic cube map: the surroundings of a mirror ball, rendered on the fly.
//!
//! *Texture Mapping*, slide "Dynamic Cube Map Textures". Six passes draw what the ball sees, one into each
//! face of a cube map in a framebuffer object; the last pass draws the scene, and the ball with that map.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "dynamic_cube_map",
    lecture: "Texture Mapping: \"Dynamic Cube Map Textures\"",
    source: include_str!("dynamic_cube_map.rs"),
    halves: [4, 2],
    panels: &["the dynamically created cube map", "the rendered scene"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const SCENE_FRAGMENT_SHADER: &str = "\
#version 130
uniform samplerCube uTexUnit0;
uniform float uSky; // 1: the surroundings, far away; 0: a thing
in vec3 vObject;
in vec3 vObjectNormal;
in vec3 vColor;
out vec4 fragColor;

void main() {
    vec3 light = 0.35 * textureCube(uTexUnit0, vObjectNormal).rgb
        + 0.55 + 0.45 * dot(normalize(vObjectNormal), vec3(0.5, 0.7, 0.5));
    vec3 sky = textureCube(uTexUnit0, vObject).rgb;
    fragColor = vec4(mix(vColor * light, sky, uSky), 1.0);
}
";

/// The ball is in the middle, and nothing is turned but the eye: the object's frame is the world's.
const MIRROR_FRAGMENT_SHADER: &str = "\
#version 130
uniform samplerCube uTexUnit1;
uniform vec3 uEye;
in vec3 vObject;
in vec3 vObjectNormal;
out vec4 fragColor;

void main() {
    vec3 reflected = reflect(vObject - uEye, normalize(vObjectNormal));
    fragColor = vec4(0.95 * textureCube(uTexUnit1, reflected).rgb, 1.0);
}
";

/// Side of a face.
const SIDE: GLsizei = 256;

fn draw(window: &mut Window) {
    glEnable(GL_DEPTH_TEST);
    load_cube_map(window);
    let scene = initShaders(window, EYE_VERTEX_SHADER, SCENE_FRAGMENT_SHADER);
    let mirror = initShaders(window, EYE_VERTEX_SHADER, MIRROR_FRAGMENT_SHADER);
    let sky = Mesh::cube().moved(DMat4::from_scale(DVec3::splat(20.))).upload();
    let things = things().upload();
    let draw_scene = |projection: &DMat4, view: &DMat4| {
        use_program(scene, projection, view);
        let h_uSky = safe_glGetUniformLocation(scene, "uSky");
        safe_glUniform1f(h_uSky, 1);
        sky.draw(scene);
        safe_glUniform1f(h_uSky, 0);
        things.draw(scene);
    };

    let (_, map) = cube_framebuffer(SIDE);
    glViewport(0, 0, SIDE, SIDE);
    for (face, target) in (GL_TEXTURE_CUBE_MAP_POSITIVE_X..).take(6).enumerate() {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, map, 0);
        assert_eq!(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_scene(&perspective(90., 1., 0.1, 50.), &look_through_face(face));
    }

    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glClearColor(0.10, 0.11, 0.14, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    window.panel(2, 1, 0);
    show_unfolded(window, map);
    let projection = perspective(50., window.panel(2, 1, 1), 0.1, 50.);
    let eye = dvec3(0.6, 1.1, 4.6);
    let view = look_at(eye, DVec3::ZERO);
    draw_scene(&projection, &view);
    use_program(mirror, &projection, &view);
    safe_glUniform3f(safe_glGetUniformLocation(mirror, "uEye"), eye.x, eye.y, eye.z);
    Mesh::sphere().upload().draw(mirror);
}

/// What stands around the ball.
fn things() -> Mesh {
    let mut things = Mesh::default();
    for (x, y, z, size, color) in [
        (-1.7, -0.3, 0.5, 0.42, [1.0, 0.35, 0.25]),
        (1.6, -0.5, 0.9, 0.36, [0.35, 0.85, 0.4]),
        (0.5, 1.75, -0.3, 0.3, [1.0, 0.85, 0.3]),
        (-0.9, -1.1, 1.8, 0.26, [0.4, 0.6, 1.0]),
    ] {
        let place = translate(x, y, z) * DMat4::from_scale(DVec3::splat(size));
        things.append(Mesh::sphere().moved(place).colored(color));
    }
    let place = translate(1.9, 0.4, -1.6) * rotate(30., DVec3::Y);
    things.append(Mesh::cube().moved(place * DMat4::from_scale(DVec3::splat(0.5))));
    things
}
