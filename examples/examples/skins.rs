//! Multiple skins packed in one texture array: one bind, one mesh, six skins.
//!
//! *Texture Mapping*, slides "Texture Arrays" and "Textured Polygonal Models". The layer is the third
//! texture coordinate.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "skins",
    lecture: "Texture Mapping: \"Texture Arrays\"",
    source: include_str!("skins.rs"),
    halves: [3, 2],
    panels: &["layer 0", "layer 1", "layer 2", "layer 3", "layer 4", "layer 5"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

const FRAGMENT_SHADER: &str = "\
#version 130
uniform sampler2DArray uTexUnit0;
uniform float uSkin;
in vec3 vNormal;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec3 skin = texture(uTexUnit0, vec3(vTexCoord, uSkin)).rgb;
    float light = max(0.0, dot(normalize(vNormal), normalize(vec3(0.4, 0.7, 0.6))));
    fragColor = vec4(skin * (0.3 + 0.8 * light), 1.0);
}
";

const SKINS: [&str; 6] =
    ["demon_image.h", "bricks.ppm", "flagstones.ppm", "planks.ppm", "slide.ppm", "reachup.ppm"];

/// Side of a layer.
const SIDE: GLsizei = 128;

fn draw(window: &mut Window) {
    glClearColor(0.10, 0.12, 0.16, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    let (target, layers) = (GL_TEXTURE_2D_ARRAY, SKINS.len());
    let mut skins: GLuint = 0;
    glGenTextures(1, &mut skins);
    glBindTexture(target, skins);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glTexImage3D(target, 0, GL_RGB8, SIDE, SIDE, layers, 0, GL_RGB, GL_UNSIGNED_BYTE, NULL);
    for (layer, name) in SKINS.into_iter().enumerate() {
        let data = layer_of(window, name);
        glTexSubImage3D(target, 0, 0, 0, layer, SIDE, SIDE, 1, GL_RGB, GL_UNSIGNED_BYTE, &data);
    }
    glGenerateMipmap(target);
    set_filter(target, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);

    let program = initShaders(window, EYE_VERTEX_SHADER, FRAGMENT_SHADER);
    let mut figure = Mesh::vase().tiled(2., 1.);
    figure.append(Mesh::torus(0.12).moved(translate(0., 0.1, 0.)).tiled(6., 1.));
    let figure = figure.upload();
    for panel in 0..layers as i32 {
        let aspect = window.panel(3, 2, panel);
        let place = translate(0., 0., -3.7) * rotate(24., DVec3::X);
        use_program(program, &perspective(40., aspect, 0.1, 50.), &place);
        safe_glUniform1f(safe_glGetUniformLocation(program, "uSkin"), panel);
        figure.draw(program);
    }
}

/// A picture at the size of a layer.
fn layer_of(window: &Window, name: &str) -> Vec<packed_pixel_t> {
    let picture = window.picture(name).flipped();
    let (width, height) = (picture.width as GLsizei, picture.height as GLsizei);
    let mut layer = vec![packed_pixel_t::default(); (SIDE * SIDE) as usize];
    gluScaleImage(
        GL_RGB,
        width,
        height,
        GL_UNSIGNED_BYTE,
        &picture.pixels,
        SIDE,
        SIDE,
        GL_UNSIGNED_BYTE,
        &mut layer,
    );
    layer
}
