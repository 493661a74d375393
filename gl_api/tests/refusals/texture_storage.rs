//! What `glTexStorage` and the calls of textures with several samples a texel refuse.

use gl_api::*;

/// The preparation, the call, the error flag that it must set, and words that its message must have.
type Case = (fn(&mut Context), fn(&mut Context), GLenum, &'static str);

/// Most rows need nothing.
fn nothing(_: &mut Context) {}

const VALUE: GLenum = GL_INVALID_VALUE;
const OPERATION: GLenum = GL_INVALID_OPERATION;
const ENUM: GLenum = GL_INVALID_ENUM;

/// A 2D texture with storage for good.
fn stored(c: &mut Context) {
    c.bind_texture(GL_TEXTURE_2D, 1);
    c.tex_storage_2d(GL_TEXTURE_2D, 1, GL_RGBA8, 4, 4);
}

const MS: GLenum = GL_TEXTURE_2D_MULTISAMPLE;
const MS_ARRAY: GLenum = GL_TEXTURE_2D_MULTISAMPLE_ARRAY;

/// A texture with several samples a texel that is there for good.
fn stored_samples(c: &mut Context) {
    c.bind_texture(MS, 1);
    c.tex_storage_2d_multisample(MS, 4, GL_RGBA8, 4, 4, true);
}

const CASES: &[Case] = &[
    // Storage for good.
    (
        stored,
        |c| c.tex_storage_2d(GL_TEXTURE_2D, 1, GL_RGBA8, 4, 4),
        OPERATION,
        "has storage for good already",
    ),
    (nothing, |c| c.tex_storage_1d(GL_TEXTURE_2D, 1, GL_RGBA8, 4), ENUM, "GL_TEXTURE_1D"),
    (nothing, |c| c.tex_storage_3d(GL_TEXTURE_2D, 1, GL_RGBA8, 4, 4, 4), ENUM, "GL_TEXTURE_3D"),
    // Several samples a texel.
    (nothing, |c| c.tex_image_2d_multisample(MS_ARRAY, 4, GL_RGBA8, 4, 4, true), ENUM, "target"),
    (nothing, |c| c.tex_image_3d_multisample(MS, 4, GL_RGBA8, 4, 4, 4, true), ENUM, "target"),
    (nothing, |c| c.tex_image_2d_multisample(MS, 0, GL_RGBA8, 4, 4, true), VALUE, "samples = 0"),
    (nothing, |c| c.tex_image_2d_multisample(MS, 5, GL_RGBA8, 4, 4, true), OPERATION, "above 4"),
    (nothing, |c| c.tex_image_2d_multisample(MS, 4, GL_LINEAR, 4, 4, true), ENUM, "GL_LINEAR"),
    (nothing, |c| c.tex_image_2d_multisample(MS, 4, GL_RGB9_E5, 4, 4, true), ENUM, "drawn to"),
    (nothing, |c| c.tex_image_2d_multisample(MS, 4, GL_COMPRESSED_RGB, 4, 4, true), ENUM, "drawn"),
    (nothing, |c| c.tex_image_2d_multisample(MS, 4, GL_RGBA8, -1, 4, true), VALUE, "width = -1"),
    (nothing, |c| c.tex_image_2d_multisample(MS, 4, GL_RGBA8, 4, 8193, true), VALUE, "8193"),
    (
        nothing,
        |c| c.tex_image_3d_multisample(MS_ARRAY, 4, GL_RGBA8, 4, 4, 2049, true),
        VALUE,
        "depth = 2049",
    ),
    (
        nothing,
        |c| c.tex_image_2d_multisample(MS, 4, GL_RGBA32F, 8192, 8192, true),
        GL_OUT_OF_MEMORY,
        "a level of 8192×8192×4 texels is too large",
    ),
    (
        stored_samples,
        |c| c.tex_image_2d_multisample(MS, 4, GL_RGBA8, 4, 4, true),
        OPERATION,
        "given for good by glTexStorage",
    ),
    (
        stored_samples,
        |c| c.tex_storage_2d_multisample(MS, 4, GL_RGBA8, 4, 4, true),
        OPERATION,
        "for good",
    ),
    (nothing, |c| c.tex_storage_2d_multisample(MS, 4, GL_RGBA8, 4, 4, true), OPERATION, "default"),
    (stored_samples, |c| c.tex_storage_2d_multisample(MS, 4, GL_RGBA, 4, 4, true), ENUM, "sized"),
    (
        stored_samples,
        |c| c.tex_storage_2d_multisample(MS, 4, GL_RGBA8, 0, 4, true),
        VALUE,
        "at least 1",
    ),
    (
        stored_samples,
        |c| {
            c.tex_storage_3d_multisample(
                MS_ARRAY,
                4,
                GL_COMPRESSED_RGB_S3TC_DXT1_EXT,
                4,
                4,
                4,
                true,
            )
        },
        ENUM,
        "drawn to",
    ),
    (nothing, |c| c.tex_parameteri(MS, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32), ENUM, "samplers"),
    (
        nothing,
        |c| c.tex_parameterfv(MS_ARRAY, GL_TEXTURE_BORDER_COLOR, &[0.0; 4]),
        ENUM,
        "samplers",
    ),
    (nothing, |c| c.tex_parameteri(MS, GL_TEXTURE_BASE_LEVEL, 1), OPERATION, "must be 0"),
    (stored_samples, |c| c.generate_mipmap(MS), ENUM, "has no mipmaps"),
    (
        stored_samples,
        |c| c.tex_image_2d(MS, 0, GL_RGBA8 as i32, 4, 4, 0, GL_RGBA, GL_BYTE, Data::Null),
        ENUM,
        "target",
    ),
    (
        stored_samples,
        |c| c.tex_sub_image_2d(MS, 0, 0, 0, 1, 1, GL_RGBA, GL_BYTE, Data::Null),
        ENUM,
        "target",
    ),
    (stored_samples, |c| c.copy_tex_sub_image_2d(MS, 0, 0, 0, 0, 0, 1, 1), ENUM, "target"),
    (stored_samples, |c| c.get_tex_image(MS, 0, GL_RGBA, GL_BYTE, DataOut::Null), ENUM, "target"),
    (
        stored_samples,
        |c| c.get_tex_level_parameteriv(MS, 1, GL_TEXTURE_SAMPLES, &mut [0]),
        VALUE,
        "level = 1 of GL_TEXTURE_2D_MULTISAMPLE must be 0",
    ),
    (
        |c| {
            stored_samples(c);
            c.bind_framebuffer(GL_FRAMEBUFFER, 1);
        },
        |c| c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, MS, 1, 1),
        VALUE,
        "level = 1",
    ),
    (
        |c| {
            stored_samples(c);
            c.bind_framebuffer(GL_FRAMEBUFFER, 1);
        },
        |c| c.framebuffer_texture_layer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, 1, 0, 0),
        OPERATION,
        "has no layers",
    ),
    (nothing, |c| c.sample_maski(1, 0), VALUE, "maskNumber = 1"),
    (nothing, |c| c.get_integeri_v(GL_SAMPLE_MASK_VALUE, 1, &mut [0]), VALUE, "index = 1"),
    (nothing, |c| c.get_multisamplefv(GL_SAMPLES, 0, &mut [0.0; 2]), ENUM, "GL_SAMPLE_POSITION"),
    (nothing, |c| c.get_multisamplefv(GL_SAMPLE_POSITION, 0, &mut [0.0; 2]), VALUE, "index = 0"),
];

/// Runs the rows.
pub fn run() {
    for (number, (prepare, call, flag, words)) in CASES.iter().enumerate() {
        let mut c = super::context();
        prepare(&mut c);
        super::row(&mut c, format!("texture storage {number}"), call, *flag, words);
    }
}
