//! Texture objects, where how they are made is not the program's point.

use crate::picture::Picture;
use crate::picture::sky::FACES;
use crate::window::Window;
use gl_api::constants::*;
use gl_api::entry::*;
use gl_api::glu::gluBuild2DMipmaps;
use gl_api::types::{GLenum, GLsizei, GLuint};

/// A new texture of a picture on a unit, with mipmaps and trilinear filter, its bottom row at
/// t = 0; `wrap` goes for both directions.
pub fn load_texture(unit: u32, picture: Picture, wrap: GLenum) -> GLuint {
    let picture = picture.flipped();
    let mut texture: GLuint = 0;
    glGenTextures(1, &mut texture);
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let (width, height) = (picture.width, picture.height);
    let data = &picture.pixels;
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB8, width, height, GL_RGB, GL_UNSIGNED_BYTE, data);
    texture
}

/// A new cube map of the environment on unit 0, with a linear filter.
pub fn load_cube_map(window: &Window) -> GLuint {
    let mut texture: GLuint = 0;
    glGenTextures(1, &mut texture);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_CUBE_MAP, texture);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (target, face) in (GL_TEXTURE_CUBE_MAP_POSITIVE_X..).zip(FACES) {
        let image = window.picture(face).squared();
        let (width, height, data) = (image.width, image.height, &image.pixels);
        glTexImage2D(target, 0, GL_RGB8, width, height, 0, GL_RGB, GL_UNSIGNED_BYTE, data);
    }
    texture
}

/// Sets both filters of the texture that is bound to a target.
pub fn set_filter(target: GLenum, minify: GLenum, magnify: GLenum) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, minify);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, magnify);
}

/// A new 3D texture on unit 0 that repeats, `side`³ texels of RGB or luminance.
pub fn load_volume(side: usize, format: GLenum, texels: &[u8]) -> GLuint {
    let mut texture: GLuint = 0;
    glGenTextures(1, &mut texture);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_3D, texture);
    set_filter(GL_TEXTURE_3D, GL_LINEAR, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let data = texels;
    glTexImage3D(GL_TEXTURE_3D, 0, format, side, side, side, 0, format, GL_UNSIGNED_BYTE, data);
    texture
}

/// An empty cube map on unit 1, with a linear filter; and a framebuffer object with a depth buffer,
/// which stays bound, to draw its faces with.
pub fn cube_framebuffer(side: GLsizei) -> (GLuint, GLuint) {
    let (mut map, mut depth, mut fbo): (GLuint, GLuint, GLuint) = (0, 0, 0);
    glActiveTexture(GL_TEXTURE1);
    glGenTextures(1, &mut map);
    glBindTexture(GL_TEXTURE_CUBE_MAP, map);
    set_filter(GL_TEXTURE_CUBE_MAP, GL_LINEAR, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    for face in (GL_TEXTURE_CUBE_MAP_POSITIVE_X..).take(6) {
        glTexImage2D(face, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    }
    glGenRenderbuffers(1, &mut depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, side, side);
    glGenFramebuffers(1, &mut fbo);
    glBindFramebuffer(GL_FRAMEBUFFER, fbo);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    (fbo, map)
}
