//! The demon triangle: a decal with mipmaps, bound under the name 666, in immediate mode.
//!
//! *Texture Mapping*, slides "Texture Mapping in OpenGL" and "Loose Ends of Texture Setup".
//! For its third vertex slide "Vertex Texture Coordinates" has (0.5, 0.5): see `demon_coordinates`. The chain of
//! levels that gluBuild2DMipmaps makes ends in 4 × 4, 2 × 2, 1 × 1; the slide prints "2x1".
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "demon_triangle",
    lecture: "Texture Mapping: \"Loose Ends of Texture Setup\"",
    source: include_str!("demon_triangle.rs"),
    halves: [2, 2],
    panels: &[],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

fn draw(window: &mut Window) {
    // RGB8 image data for a mipmapped 128x128 demon texture.
    let demon = window.picture("demon_image.h");
    let (width, height) = (demon.width, demon.height);
    let myDemonTextureImage = demon.pixels;

    glViewport(0, 0, window.width, window.height);
    glClearColor(0.12, 0.13, 0.16, 1);
    glClear(GL_COLOR_BUFFER_BIT);

    // Tightly packed texture data.
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);

    glBindTexture(GL_TEXTURE_2D, 666);
    // Load demon decal texture with mipmaps.
    gluBuild2DMipmaps(
        GL_TEXTURE_2D,
        GL_RGB8,
        width,
        height,
        GL_RGB,
        GL_UNSIGNED_BYTE,
        &myDemonTextureImage,
    );
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);

    glActiveTexture(GL_TEXTURE0);
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, 666);

    glBegin(GL_TRIANGLES);
    glTexCoord2f(0, 0);
    glVertex2f(-0.8, 0.8);
    glTexCoord2f(1, 0);
    glVertex2f(0.8, 0.8);
    glTexCoord2f(0.5, 1);
    glVertex2f(0.0, -0.8);
    glEnd();
}
