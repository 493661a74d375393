//! What the calls on parameters of textures, samplers, mipmaps and the storage of pixels refuse, on the
//! textures of [`super::textures`].

use super::textures::{ENUM, FACE, OPERATION, VALUE, refused, refused_after};
use gl_api::*;

/// Runs the rows.
pub fn run() {
    let rows: &[(GLenum, GLenum, f32, GLenum, &str)] = &[
        (GL_TEXTURE_RECTANGLE, GL_TEXTURE_WRAP_S, GL_REPEAT as f32, ENUM, "GL_CLAMP"),
        (GL_TEXTURE_RECTANGLE, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT as f32, ENUM, "GL_CLAMP"),
        (
            GL_TEXTURE_RECTANGLE,
            GL_TEXTURE_MIN_FILTER,
            GL_LINEAR_MIPMAP_LINEAR as f32,
            ENUM,
            "GL_NEAREST or GL_LINEAR",
        ),
        (
            GL_TEXTURE_RECTANGLE,
            GL_TEXTURE_BASE_LEVEL,
            1.0,
            OPERATION,
            "of GL_TEXTURE_RECTANGLE must be 0",
        ),
        (GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_LINEAR as f32, ENUM, "GL_MIRRORED_REPEAT"),
        (GL_TEXTURE_1D, GL_TEXTURE_MAX_LEVEL, -1.0, VALUE, "must not be negative"),
        (GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, f32::NAN, VALUE, "must not be negative"),
        (GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, 1.0, ENUM, "GL_DECODE_EXT or"),
        (GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 0.5, VALUE, "must be at least 1"),
        (GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, f32::NAN, VALUE, "must be at least 1"),
        (
            GL_TEXTURE_2D,
            GL_TEXTURE_SWIZZLE_R,
            GL_LUMINANCE as f32,
            ENUM,
            "GL_ALPHA, GL_ZERO or GL_ONE",
        ),
        (GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, GL_RED as f32, ENUM, "four components"),
        (GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_RGBA as f32, ENUM, "GL_INTENSITY"),
        (GL_TEXTURE_2D, GL_TEXTURE_RESIDENT, 1.0, ENUM, "can only be read"),
        (GL_PROXY_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP as f32, ENUM, "target"),
        (FACE, GL_TEXTURE_WRAP_S, GL_CLAMP as f32, ENUM, "target"),
    ];
    for row in rows {
        let &(target, pname, value, flag, words) = row;
        refused(row, flag, words, |c| c.tex_parameterf(target, pname, value));
    }
    let rows: &[(GLuint, GLenum, f32, GLenum, &str)] = &[
        (7, GL_TEXTURE_WRAP_S, GL_CLAMP as f32, OPERATION, "glGenSamplers"),
        (1, GL_TEXTURE_BASE_LEVEL, 0.0, ENUM, "GL_TEXTURE_BASE_LEVEL must be"),
        (1, GL_DEPTH_TEXTURE_MODE, 0.0, ENUM, "pname"),
        (1, GL_TEXTURE_WRAP_R, GL_LINEAR as f32, ENUM, "GL_REPEAT"),
        (1, GL_TEXTURE_MIN_FILTER, GL_REPEAT as f32, ENUM, "GL_NEAREST"),
        (1, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR as f32, ENUM, "GL_LINEAR"),
        (1, GL_TEXTURE_COMPARE_FUNC, GL_LINEAR as f32, ENUM, "GL_NEVER"),
        (1, GL_TEXTURE_COMPARE_MODE, 1.0, ENUM, "GL_COMPARE_R_TO_TEXTURE"),
        (1, GL_TEXTURE_MAX_ANISOTROPY_EXT, 0.0, VALUE, "at least 1"),
        (1, GL_TEXTURE_BORDER_COLOR, 0.0, ENUM, "glSamplerParameterfv"),
    ];
    let sampler = |c: &mut Context| c.gen_samplers(1, &mut [0]);
    for row in rows {
        let &(name, pname, value, flag, words) = row;
        refused_after(row, flag, words, sampler, |c| c.sampler_parameterf(name, pname, value));
    }
    refused_after(&"border", OPERATION, "3 of 4 values", sampler, |c| {
        c.sampler_parameterfv(1, GL_TEXTURE_BORDER_COLOR, &[0.0; 3]);
    });
    refused(&"unit", VALUE, "not GL_TEXTURE0", |c| c.bind_sampler(GL_TEXTURE0, 0));
    refused(&"unknown", OPERATION, "glGenSamplers", |c| c.bind_sampler(0, 7));
    refused(&"n", VALUE, "n = -1", |c| c.gen_samplers(-1, &mut []));
    refused(&"n", VALUE, "n = -1", |c| c.delete_samplers(-1, &[]));
    refused(&"read", OPERATION, "glGenSamplers", |c| {
        c.get_sampler_parameterfv(9, GL_TEXTURE_WRAP_S, &mut [0.0]);
    });
    refused(&"mipmaps", ENUM, "no mipmaps", |c| c.generate_mipmap(GL_TEXTURE_RECTANGLE));
    refused(&"NaN", VALUE, "must be a number", |c| c.pixel_transferf(GL_RED_SCALE, f32::NAN));
    refused(&"table", ENUM, "GL_RED_SCALE", |c| c.pixel_transferi(GL_PIXEL_MAP_R_TO_R, 1));
    refused(&"images", VALUE, "must not be negative", |c| {
        c.pixel_storei(GL_UNPACK_SKIP_IMAGES, -1);
    });
    refused(&"images", VALUE, "must not be negative", |c| {
        c.pixel_storei(GL_PACK_IMAGE_HEIGHT, -1);
    });
    refused(&"level", VALUE, "level = 10", |c| {
        c.get_tex_level_parameteriv(GL_TEXTURE_3D, 10, GL_TEXTURE_WIDTH, &mut [0]);
    });
    // Without compression, without an image, of a proxy.
    for (target, level) in [(GL_TEXTURE_2D, 0), (FACE, 1), (GL_PROXY_TEXTURE_CUBE_MAP, 0)] {
        refused(&(target, level), OPERATION, "no image that is compressed", |c| {
            let (internal, ty) = (GL_COMPRESSED_RGB_S3TC_DXT1_EXT as i32, GL_UNSIGNED_BYTE);
            let proxy = GL_PROXY_TEXTURE_CUBE_MAP;
            c.tex_image_2d(proxy, 0, internal, 8, 8, 0, GL_RGB, ty, Data::Null);
            let pname = GL_TEXTURE_COMPRESSED_IMAGE_SIZE;
            c.get_tex_level_parameteriv(target, level, pname, &mut [0]);
        });
    }
    refused(&"proxy", ENUM, "proxy", |c| {
        let out = DataOut::Bytes(&mut [0; 64]);
        c.get_tex_image(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, out);
    });
    refused(&"integers", OPERATION, "integer", |c| {
        let out = DataOut::Bytes(&mut [0; 64]);
        c.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, out);
    });
}
