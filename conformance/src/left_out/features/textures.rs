//! State of textures and units.

use crate::gl::*;
use crate::left_out::feature::{Feature, Reason};
use crate::left_out::scene::*;
use gl_api::constants::*;

fn parameter(name: u32, value: impl Into<i32>) {
    glTexParameteri(GL_TEXTURE_2D, name, value.into());
}

pub(super) const LIST: &[Feature] = &[
    Feature::state(
        "anisotropy-magnified",
        "anisotropy 16 where the texture is magnified",
        mipmapped,
        || {
            mipmapped();
            glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 16.0);
        },
        draw_quad,
    )
    .because(Reason::DecidedPerBlock),
    Feature::state(
        "anisotropy-face-on",
        "anisotropy 16 where the texture is minified face on",
        mipmapped,
        || {
            mipmapped();
            glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 16.0);
        },
        draw_minified,
    )
    .because(Reason::DecidedPerBlock),
    Feature::state(
        "trilinear-magnified",
        "a mipmap filter where the texture is magnified",
        textured,
        mipmapped,
        draw_quad,
    )
    .because(Reason::DecidedPerBlock),
    Feature::state(
        "nearest-minification",
        "another filter of minification where the texture is magnified",
        textured,
        || {
            textured();
            parameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32);
        },
        draw_quad,
    )
    .because(Reason::DecidedPerBlock),
    Feature::state(
        "magnification-unused",
        "another filter of magnification where the texture is minified",
        mipmapped,
        || {
            mipmapped();
            parameter(GL_TEXTURE_MAG_FILTER, GL_NEAREST as i32);
        },
        draw_minified,
    )
    .because(Reason::DecidedPerBlock),
    Feature::state(
        "border-color",
        "a border colour with coordinates clamped to the edge",
        || {
            textured();
            parameter(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE as i32);
        },
        || {
            textured();
            parameter(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE as i32);
            glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[1.0f32, 0.0, 0.0, 1.0]);
        },
        draw_quad,
    ),
    Feature::state(
        "wrap-r",
        "wrapping along r of a texture of two dimensions",
        textured,
        || {
            textured();
            parameter(GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE as i32);
        },
        draw_quad,
    ),
    Feature::state(
        "levels-unused",
        "all levels of a texture whose filter takes one",
        textured,
        || {
            textured();
            glGenerateMipmap(GL_TEXTURE_2D);
        },
        draw_minified,
    ),
    Feature::state(
        "lod-bias-zero",
        "a level-of-detail bias of 0 of texture and unit",
        mipmapped,
        || {
            mipmapped();
            glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, 0.0);
            glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 0.0);
        },
        draw_minified,
    ),
    Feature::state(
        "texture-matrix-identity",
        "a texture matrix that is the identity",
        textured,
        || {
            textured();
            glMatrixMode(GL_TEXTURE);
            glScalef(2.0, 2.0, 2.0);
            glScalef(0.5, 0.5, 0.5);
            glMatrixMode(GL_MODELVIEW);
        },
        draw_quad,
    ),
    Feature::state(
        "other-unit-bound",
        "textures bound to units that are not enabled",
        textured,
        || {
            for unit in 1..4 {
                glActiveTexture(GL_TEXTURE0 + unit);
                textured();
                glDisable(GL_TEXTURE_2D);
            }
            glActiveTexture(GL_TEXTURE0);
            textured();
        },
        draw_quad,
    ),
    Feature::state(
        "lower-target",
        "GL_TEXTURE_1D enabled below GL_TEXTURE_2D",
        textured,
        || {
            textured();
            glEnable(GL_TEXTURE_1D);
        },
        draw_quad,
    ),
    Feature::state(
        "compare-mode",
        "depth comparison of a texture of colours",
        textured,
        || {
            textured();
            parameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE as i32);
        },
        draw_quad,
    ),
    Feature::state(
        "swizzle-identity",
        "a swizzle that moves nothing",
        textured,
        || {
            textured();
            let swizzle = [GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA].map(|c| c as i32);
            glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, &swizzle);
        },
        draw_quad,
    ),
    Feature::state(
        "sampler-object",
        "a sampler object with the texture's own parameters",
        textured,
        || {
            textured();
            let mut sampler = [0u32];
            glGenSamplers(1, &mut sampler);
            glBindSampler(0, sampler[0]);
            glSamplerParameteri(sampler[0], GL_TEXTURE_MIN_FILTER, GL_LINEAR as i32);
            glSamplerParameteri(sampler[0], GL_TEXTURE_MAG_FILTER, GL_LINEAR as i32);
        },
        draw_quad,
    ),
    Feature::state(
        "texgen-unread",
        "generated r coordinates of a texture of two dimensions",
        textured,
        || {
            textured();
            glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR as i32);
            glEnable(GL_TEXTURE_GEN_R);
        },
        draw_quad,
    ),
    Feature::state(
        "env-color",
        "an environment colour and scales of a unit that modulates",
        textured,
        || {
            textured();
            glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &[1.0f32, 0.5, 0.0, 1.0]);
            glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_ADD as i32);
        },
        draw_quad,
    ),
    Feature::state(
        "seamless",
        "seamless cube maps where there is none",
        textured,
        || {
            textured();
            glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        },
        draw_quad,
    ),
];
