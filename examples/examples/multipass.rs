//! Multipass: a scene is rendered offline into a framebuffer object, then used as a texture.
//!
//! *CS380, Texture Mapping*, slides 33 to 35. Pass 1 draws the scene; pass 2 blurs it from left to
//! right into a second framebuffer object; pass 3 draws to the window: behind, the scene blurred
//! from top to bottom as well, and before it a screen that shows the scene sharp.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "multipass",
    lecture: "CS380: slides 33 to 35, \"Multipass\"",
    source: include_str!("multipass.rs"),
    halves: [2, 2],
    panels: &[],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const SCENE_FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
in vec3 vNormal;
in vec2 vTexCoord;
in vec3 vColor;
out vec4 fragColor;

void main() {
    vec3 normal = normalize(vNormal);
    float diffuse = max(0.0, dot(normal, normalize(vec3(0.4, 0.8, 0.6))));
    float rim = pow(1.0 - abs(normal.z), 3.0);
    vec3 color = vColor * texture2D(uTexUnit0, vTexCoord).rgb;
    fragColor = vec4(color * (0.25 + 0.95 * diffuse) + 0.5 * rim * vec3(0.3, 0.5, 1.0), 1.0);
}
";

/// The mean of 17 texels in a row, the middle ones weighing more, times a brightness.
const SCREEN_FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2D uTexUnit0;
uniform vec3 uStep; // x, y: from tap to tap; z: brightness
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec3 sum = vec3(0.0);
    for (int i = -8; i <= 8; i++) {
        float weight = 9.0 - abs(float(i));
        sum += weight * texture2D(uTexUnit0, vTexCoord + float(i) * uStep.xy).rgb;
    }
    fragColor = vec4(sum / 81.0 * uStep.z, 1.0);
}
";

/// Side of the framebuffer objects.
const SIZE: GLsizei = 512;

fn draw(window: &mut Window) {
    let scene_program = initShaders(window, EYE_VERTEX_SHADER, SCENE_FRAGMENT_SHADER);
    let screen_program = initShaders(window, EYE_VERTEX_SHADER, SCREEN_FRAGMENT_SHADER);
    let decal = load_texture(0, window.picture("flagstones.ppm"), GL_REPEAT);
    let (sharp_fbo, sharp) = color_framebuffer(SIZE);
    let (blurred_fbo, blurred) = color_framebuffer(SIZE);
    let square = Mesh::plane().upload();

    // Pass 1: the scene, offline.
    glBindFramebuffer(GL_FRAMEBUFFER, sharp_fbo);
    glViewport(0, 0, SIZE, SIZE);
    glClearColor(0.16, 0.10, 0.28, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glBindTexture(GL_TEXTURE_2D, decal);
    draw_scene(scene_program);
    glDisable(GL_DEPTH_TEST);

    // Pass 2: the first picture is a texture; blur it along x.
    use_program(screen_program, &DMat4::IDENTITY, &DMat4::IDENTITY);
    let h_uStep = safe_glGetUniformLocation(screen_program, "uStep");
    glBindFramebuffer(GL_FRAMEBUFFER, blurred_fbo);
    glBindTexture(GL_TEXTURE_2D, sharp);
    safe_glUniform3f(h_uStep, 1.5 / f64::from(SIZE), 0, 1);
    square.draw(screen_program);

    // Pass 3: the window.
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, window.width, window.height);
    glClear(GL_COLOR_BUFFER_BIT);
    glBindTexture(GL_TEXTURE_2D, blurred);
    safe_glUniform3f(h_uStep, 0, 1.5 / f64::from(SIZE), 0.75);
    square.draw(screen_program);

    let projection = perspective(45., window.panel(1, 1, 0), 0.1, 20.);
    let place = translate(0., 0., -3.4) * rotate(28., DVec3::Y) * rotate(-5., DVec3::X);
    glBindTexture(GL_TEXTURE_2D, sharp);
    for (scale, brightness) in [(1.06, 0.04), (1., 1.)] {
        let size = DMat4::from_scale(dvec3(scale, scale, 1.));
        use_program(screen_program, &projection, &(place * size));
        safe_glUniform3f(h_uStep, 0, 0, brightness);
        square.draw(screen_program);
    }
}

fn draw_scene(program: GLuint) {
    let projection = perspective(45., 1., 0.1, 20.);
    let place = translate(0., 0., -4.9) * rotate(38., DVec3::X);
    let ring = Mesh::torus(0.3).tiled(6., 2.);
    for (degrees, color) in [(0., [1.0, 0.75, 0.35]), (90., [0.45, 0.95, 1.0])] {
        let across = DMat4::from_translation(DVec3::X * (degrees / 90. - 0.5));
        let turned = rotate(degrees, DVec3::X);
        use_program(program, &projection, &(place * across * turned));
        ring.clone().colored(color).upload().draw(program);
    }
}
