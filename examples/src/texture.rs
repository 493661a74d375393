//! Texture and framebuffer objects for programs whose subject is something else.

use crate::picture::Picture;
use crate::picture::sky::FACES;
use crate::window::Window;
use gl_api::constants::*;
use gl_api::glu::gluBuild2DMipmaps;
use gl_api::types::{GLenum, GLint, GLsizei, GLuint};
use gl_api::*;

/// Binds a new texture of a picture to a unit, with mipmaps and a trilinear filter, its bottom row at
/// t = 0; `wrap` is the wrap mode of both axes.
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

/// Binds a new cube map of the environment to unit 0, with a linear filter.
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

/// Binds a new repeating 3D texture to unit 0, `side`³ texels of RGB or luminance.
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

/// A new texture of a picture, unscaled, clamped to its edge, with mipmaps. (Not by
/// `gluBuild2DMipmaps`, which would make 4 × 4 texels of 3 × 3.)
pub fn load_texels(picture: &Picture) -> GLuint {
    let mut texture: GLuint = 0;
    glGenTextures(1, &mut texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    clamp_to_edge(GL_TEXTURE_2D);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let (side, data) = (picture.width, &picture.pixels);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, side, side, 0, GL_RGB, GL_UNSIGNED_BYTE, data);
    glGenerateMipmap(GL_TEXTURE_2D);
    texture
}

/// Copies the window's lower left corner to a new texture with nearest filters.
pub fn copy_window(side: GLsizei) -> GLuint {
    let mut picture: GLuint = 0;
    glGenTextures(1, &mut picture);
    glBindTexture(GL_TEXTURE_2D, picture);
    set_filter(GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 0, 0, side, side, 0);
    picture
}

fn clamp_to_edge(target: GLenum) {
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

/// A framebuffer object that has only a depth texture of `side` × `side` texels with these filters;
/// both stay bound.
pub fn depth_framebuffer(side: GLsizei, filter: GLenum) -> GLuint {
    let (mut fbo, mut texture): (GLuint, GLuint) = (0, 0);
    glGenTextures(1, &mut texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    set_filter(GL_TEXTURE_2D, filter, filter);
    clamp_to_edge(GL_TEXTURE_2D);
    let format = GL_DEPTH_COMPONENT;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, side, side, 0, format, GL_FLOAT, NULL);
    glGenFramebuffers(1, &mut fbo);
    glBindFramebuffer(GL_FRAMEBUFFER, fbo);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    assert_complete();
    fbo
}

/// A framebuffer object with a depth buffer and a colour texture of `side` × `side` texels, which
/// is filtered linearly; both stay bound.
pub fn color_framebuffer(side: GLsizei) -> (GLuint, GLuint) {
    let (mut fbo, mut texture, mut depth): (GLuint, GLuint, GLuint) = (0, 0, 0);
    glGenTextures(1, &mut texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    set_filter(GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
    clamp_to_edge(GL_TEXTURE_2D);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glGenRenderbuffers(1, &mut depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, side, side);
    glGenFramebuffers(1, &mut fbo);
    glBindFramebuffer(GL_FRAMEBUFFER, fbo);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    assert_complete();
    (fbo, texture)
}

/// Stops a program whose framebuffer object is not complete.
fn assert_complete() {
    let status: GLint = glCheckFramebufferStatus(GL_FRAMEBUFFER) as GLint;
    assert_eq!(status, GL_FRAMEBUFFER_COMPLETE as GLint);
}
