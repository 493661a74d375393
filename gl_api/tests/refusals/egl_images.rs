//! What the commands of `OES_EGL_image` refuse.

use gl_api::host::{EglImage, EglImageSource, share};
use gl_api::*;

const D2: GLenum = GL_TEXTURE_2D;
const BUFFER: GLenum = GL_RENDERBUFFER;
/// Names of the textures that `prepared` makes.
const PLAIN: GLuint = 1;
const IMMUTABLE: GLuint = 2;
const BLOCKS: GLuint = 3;

/// A texture that may change, one that may not, and blocks, with images of the first and the last.
fn prepared() -> (Context, EglImage, EglImage) {
    let mut c = super::context();
    c.gen_textures(3, &mut [0; 3]);
    c.bind_texture(D2, BLOCKS);
    let dxt = GL_COMPRESSED_RGBA_S3TC_DXT5_EXT;
    c.compressed_tex_image_2d(D2, 0, dxt, 4, 4, 0, 16, Data::Bytes(&[0; 16]));
    c.bind_texture(D2, IMMUTABLE);
    c.tex_storage_2d(D2, 1, GL_RGBA8, 4, 4);
    c.bind_texture(D2, PLAIN);
    c.tex_image_2d(D2, 0, GL_RGBA as GLint, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, Data::Null);
    let of = |c: &Context, texture| {
        let source = EglImageSource::Texture2D { texture, level: 0 };
        EglImage::new(&share(c), source).expect("a source")
    };
    let (plain, blocks) = (of(&c, PLAIN), of(&c, BLOCKS));
    (c, plain, blocks)
}

type Images = (GLeglImageOES, GLeglImageOES);

/// A call, the object that must be bound before it, and its error.
type Case = (fn(&mut Context), fn(&mut Context, Images), GLenum, &'static str);

const CASES: &[Case] = &[
    (
        |_| {},
        |c, (plain, _)| c.egl_image_target_texture_2d(GL_TEXTURE_3D, plain),
        GL_INVALID_ENUM,
        "target = GL_TEXTURE_3D must be GL_TEXTURE_2D",
    ),
    (
        |_| {},
        |c, _| c.egl_image_target_texture_2d(D2, std::ptr::null_mut()),
        GL_INVALID_VALUE,
        "image = 0x0 is no handle that eglCreateImage gave",
    ),
    (
        |c| c.bind_texture(D2, IMMUTABLE),
        |c, (plain, _)| c.egl_image_target_texture_2d(D2, plain),
        GL_INVALID_OPERATION,
        "texture 2 has its storage for good",
    ),
    (
        |_| {},
        |c, (plain, _)| c.egl_image_target_renderbuffer_storage(D2, plain),
        GL_INVALID_ENUM,
        "target = GL_TEXTURE_2D must be GL_RENDERBUFFER",
    ),
    (
        |_| {},
        |c, (plain, _)| c.egl_image_target_renderbuffer_storage(BUFFER, plain),
        GL_INVALID_OPERATION,
        "no renderbuffer is bound",
    ),
    (
        |c| c.bind_renderbuffer(BUFFER, 1),
        |c, _| c.egl_image_target_renderbuffer_storage(BUFFER, std::ptr::null_mut()),
        GL_INVALID_VALUE,
        "image = 0x0 is no handle",
    ),
    (
        |c| c.bind_renderbuffer(BUFFER, 1),
        |c, (_, blocks)| c.egl_image_target_renderbuffer_storage(BUFFER, blocks),
        GL_INVALID_OPERATION,
        "GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, which no renderbuffers here have",
    ),
];

pub fn run() {
    for (number, (prepare, call, flag, words)) in CASES.iter().enumerate() {
        let (mut c, plain, blocks) = prepared();
        prepare(&mut c);
        let images = (plain.handle(), blocks.handle());
        let call = |c: &mut Context| call(c, images);
        super::row(&mut c, format!("EGL images {number}"), &call, *flag, words);
    }
}
