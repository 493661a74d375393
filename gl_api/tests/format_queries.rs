//! What formats can be used for (`ARB_internalformat_query2`): the answers are what the calls do that they are about.

use gl_api::*;

const TARGETS: &[GLenum] = &[
    GL_RENDERBUFFER,
    GL_TEXTURE_1D,
    GL_TEXTURE_1D_ARRAY,
    GL_TEXTURE_2D,
    GL_TEXTURE_2D_ARRAY,
    GL_TEXTURE_3D,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_CUBE_MAP_ARRAY,
    GL_TEXTURE_RECTANGLE,
    GL_TEXTURE_BUFFER,
    GL_TEXTURE_2D_MULTISAMPLE,
    GL_TEXTURE_2D_MULTISAMPLE_ARRAY,
];
const FORMATS: &[GLenum] = &[
    GL_RGBA8,
    GL_RGB5_A1,
    GL_SRGB8_ALPHA8,
    GL_R16F,
    GL_RG32F,
    GL_R11F_G11F_B10F,
    GL_RGB9_E5,
    GL_RGB10_A2,
    GL_RGB10_A2UI,
    GL_R8_SNORM,
    GL_RGBA16,
    GL_RGBA32I,
    GL_RG8UI,
    GL_DEPTH_COMPONENT16,
    GL_DEPTH_COMPONENT32F,
    GL_DEPTH24_STENCIL8,
    GL_DEPTH32F_STENCIL8,
    GL_STENCIL_INDEX8,
    GL_LUMINANCE8,
    GL_ALPHA8,
    GL_INTENSITY16,
    GL_RGBA,
    GL_COMPRESSED_RGBA,
    GL_COMPRESSED_RGBA_S3TC_DXT5_EXT,
    GL_COMPRESSED_RG_RGTC2,
    GL_COMPRESSED_RED,
    GL_DEPTH_COMPONENT,
];

fn context() -> Context {
    Context::new(ContextDesc { width: 8, height: 8, ..ContextDesc::default() }).expect("a device")
}

/// The answer by both calls.
#[track_caller]
fn ask(c: &mut Context, target: GLenum, internal: GLenum, pname: GLenum) -> i64 {
    let (mut small, mut large) = ([-7], [-7]);
    c.get_internalformativ(target, internal, pname, 1, &mut small);
    c.get_internalformati64v(target, internal, pname, 1, &mut large);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    assert_eq!(i64::from(small[0]), large[0].min(i32::MAX.into()));
    large[0]
}

/// Makes an image with pixels of the format and type that a query says, or none; the name of the texture.
fn make(c: &mut Context, target: GLenum, internal: GLenum, [format, ty]: [GLenum; 2]) -> GLuint {
    let mut name = [0];
    c.gen_textures(1, &mut name);
    if target != GL_RENDERBUFFER {
        c.bind_texture(target, name[0]);
    }
    let (of, data) = (internal as GLint, Data::Null);
    match target {
        GL_TEXTURE_1D => c.tex_image_1d(target, 0, of, 8, 0, format, ty, data),
        GL_TEXTURE_2D | GL_TEXTURE_RECTANGLE | GL_TEXTURE_1D_ARRAY => {
            c.tex_image_2d(target, 0, of, 8, 8, 0, format, ty, data);
        }
        GL_TEXTURE_CUBE_MAP => {
            for face in GL_TEXTURE_CUBE_MAP_POSITIVE_X..=GL_TEXTURE_CUBE_MAP_NEGATIVE_Z {
                c.tex_image_2d(face, 0, of, 8, 8, 0, format, ty, Data::Null);
            }
        }
        GL_TEXTURE_2D_MULTISAMPLE => c.tex_image_2d_multisample(target, 4, internal, 8, 8, true),
        GL_TEXTURE_2D_MULTISAMPLE_ARRAY => {
            c.tex_image_3d_multisample(target, 4, internal, 8, 8, 2, true);
        }
        GL_TEXTURE_BUFFER => {
            c.bind_buffer(GL_TEXTURE_BUFFER, 1);
            c.buffer_data(GL_TEXTURE_BUFFER, 64, Data::Null, GL_STATIC_DRAW);
            c.tex_buffer(target, internal, 1);
        }
        GL_RENDERBUFFER => {
            c.bind_renderbuffer(target, 1);
            c.renderbuffer_storage_multisample(target, 4, internal, 8, 8);
        }
        _ => c.tex_image_3d(target, 0, of, 8, 8, 6, 0, format, ty, data),
    }
    name[0]
}

/// Format and type for targets that are not given pixels of this kind: something that goes with the format.
fn fallback(internal: GLenum) -> [GLenum; 2] {
    match internal {
        GL_STENCIL_INDEX8 => [GL_STENCIL_INDEX, GL_UNSIGNED_BYTE],
        GL_DEPTH24_STENCIL8 | GL_DEPTH32F_STENCIL8 => [GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8],
        GL_DEPTH_COMPONENT | GL_DEPTH_COMPONENT16 | GL_DEPTH_COMPONENT32F => {
            [GL_DEPTH_COMPONENT, GL_FLOAT]
        }
        GL_RGB10_A2UI | GL_RGBA32I | GL_RG8UI => [GL_RGBA_INTEGER, GL_INT],
        _ => [GL_RGBA, GL_UNSIGNED_BYTE],
    }
}

/// Images can be made exactly where they are said to be supported, with the pixels that are said to fit.
#[test]
fn what_is_supported_can_be_made() {
    for &target in TARGETS {
        for &internal in FORMATS {
            let mut c = context();
            let supported = ask(&mut c, target, internal, GL_INTERNALFORMAT_SUPPORTED);
            let format = ask(&mut c, target, internal, GL_TEXTURE_IMAGE_FORMAT) as GLenum;
            let ty = ask(&mut c, target, internal, GL_TEXTURE_IMAGE_TYPE) as GLenum;
            let pixels = if format == GL_NONE { fallback(internal) } else { [format, ty] };
            make(&mut c, target, internal, pixels);
            let made = c.get_error() == GL_NO_ERROR;
            let name = format!("{} of {}", enum_name(target), enum_name(internal));
            assert_eq!(supported == 1, made, "{name}: {:?}", c.messages());
            if supported == 0 {
                for pname in [GL_MAX_WIDTH, GL_FILTER, GL_COLOR_ENCODING, GL_NUM_SAMPLE_COUNTS] {
                    assert_eq!(ask(&mut c, target, internal, pname), 0, "{name}");
                }
            }
        }
    }
}

/// Sizes and types are those of a level that is made.
#[test]
fn sizes_and_types_are_those_of_levels() {
    let pairs = [
        (GL_INTERNALFORMAT_RED_SIZE, GL_TEXTURE_RED_SIZE),
        (GL_INTERNALFORMAT_GREEN_SIZE, GL_TEXTURE_GREEN_SIZE),
        (GL_INTERNALFORMAT_BLUE_SIZE, GL_TEXTURE_BLUE_SIZE),
        (GL_INTERNALFORMAT_ALPHA_SIZE, GL_TEXTURE_ALPHA_SIZE),
        (GL_INTERNALFORMAT_DEPTH_SIZE, GL_TEXTURE_DEPTH_SIZE),
        (GL_INTERNALFORMAT_STENCIL_SIZE, GL_TEXTURE_STENCIL_SIZE),
        (GL_INTERNALFORMAT_SHARED_SIZE, GL_TEXTURE_SHARED_SIZE),
        (GL_INTERNALFORMAT_RED_TYPE, GL_TEXTURE_RED_TYPE),
        (GL_INTERNALFORMAT_GREEN_TYPE, GL_TEXTURE_GREEN_TYPE),
        (GL_INTERNALFORMAT_BLUE_TYPE, GL_TEXTURE_BLUE_TYPE),
        (GL_INTERNALFORMAT_ALPHA_TYPE, GL_TEXTURE_ALPHA_TYPE),
        (GL_INTERNALFORMAT_DEPTH_TYPE, GL_TEXTURE_DEPTH_TYPE),
        (GL_TEXTURE_COMPRESSED, GL_TEXTURE_COMPRESSED),
    ];
    for &internal in FORMATS {
        let mut c = context();
        let target = GL_TEXTURE_2D;
        make(&mut c, target, internal, fallback(internal));
        for (asked, of_level) in pairs {
            let mut level = [-1];
            c.get_tex_level_parameteriv(target, 0, of_level, &mut level);
            let name = format!("{} of {}", enum_name(asked), enum_name(internal));
            assert_eq!(ask(&mut c, target, internal, asked), level[0].into(), "{name}");
        }
    }
}

/// Attachments are complete, and levels are made, where that is said.
#[test]
fn attachments_and_mipmaps_are_as_said() {
    for &internal in FORMATS {
        let mut c = context();
        let target = GL_TEXTURE_2D;
        let texture = make(&mut c, target, internal, fallback(internal));
        assert_eq!(c.get_error(), GL_NO_ERROR);
        c.bind_framebuffer(GL_FRAMEBUFFER, 1);
        c.draw_buffer(GL_NONE);
        c.read_buffer(GL_NONE);
        let mut any = false;
        for (pname, point) in [
            (GL_COLOR_RENDERABLE, GL_COLOR_ATTACHMENT0),
            (GL_DEPTH_RENDERABLE, GL_DEPTH_ATTACHMENT),
            (GL_STENCIL_RENDERABLE, GL_STENCIL_ATTACHMENT),
        ] {
            c.framebuffer_texture_2d(GL_FRAMEBUFFER, point, target, texture, 0);
            let complete = c.check_framebuffer_status(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
            c.framebuffer_texture_2d(GL_FRAMEBUFFER, point, target, 0, 0);
            let said = ask(&mut c, target, internal, pname) == 1;
            // Generic compressed formats are stored uncompressed, which the query does not promise.
            let generic = matches!(internal, GL_COMPRESSED_RGBA | GL_COMPRESSED_RED);
            assert!(said == complete || generic, "{} {}", enum_name(internal), enum_name(pname));
            any |= said;
        }
        let renderable = ask(&mut c, target, internal, GL_FRAMEBUFFER_RENDERABLE) as GLenum;
        assert_eq!(renderable, if any { GL_FULL_SUPPORT } else { GL_NONE });
        c.generate_mipmap(target);
        let made = c.get_error() == GL_NO_ERROR;
        let said = ask(&mut c, target, internal, GL_MANUAL_GENERATE_MIPMAP) as GLenum;
        assert_eq!(said == GL_FULL_SUPPORT, made, "{}", enum_name(internal));
    }
}

#[test]
fn limits_are_those_of_the_target() {
    let mut c = context();
    let cases: [(GLenum, [i64; 4], i64); 6] = [
        (GL_TEXTURE_1D, [8192, 0, 0, 0], 8192),
        (GL_TEXTURE_1D_ARRAY, [8192, 2048, 0, 2048], 8192 * 2048),
        (GL_TEXTURE_3D, [512, 512, 512, 0], 512 * 512 * 512),
        (GL_TEXTURE_CUBE_MAP, [8192, 8192, 0, 0], 8192 * 8192 * 6),
        (GL_TEXTURE_2D_MULTISAMPLE_ARRAY, [8192, 8192, 2048, 2048], 8192 * 8192 * 2048 * 4),
        (GL_RENDERBUFFER, [8192, 8192, 0, 0], 8192 * 8192),
    ];
    for (target, sides, combined) in cases {
        let pnames = [GL_MAX_WIDTH, GL_MAX_HEIGHT, GL_MAX_DEPTH, GL_MAX_LAYERS];
        let found = pnames.map(|pname| ask(&mut c, target, GL_RGBA8, pname));
        assert_eq!(found, sides, "{}", enum_name(target));
        assert_eq!(ask(&mut c, target, GL_RGBA8, GL_MAX_COMBINED_DIMENSIONS), combined);
    }
    let of_dxt5 = [
        GL_TEXTURE_COMPRESSED_BLOCK_WIDTH,
        GL_TEXTURE_COMPRESSED_BLOCK_HEIGHT,
        GL_TEXTURE_COMPRESSED_BLOCK_SIZE,
    ]
    .map(|pname| ask(&mut c, GL_TEXTURE_2D, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, pname));
    assert_eq!(of_dxt5, [4, 4, 16]);
    let preferred = [GL_RGBA, GL_RGB5_A1, GL_DEPTH_COMPONENT].map(|internal| {
        ask(&mut c, GL_TEXTURE_2D, internal, GL_INTERNALFORMAT_PREFERRED) as GLenum
    });
    assert_eq!(preferred, [GL_RGBA8, GL_RGB5_A1, GL_DEPTH_COMPONENT24]);
    // Without samples nothing is written.
    let mut samples = [-7; 3];
    c.get_internalformativ(GL_TEXTURE_2D, GL_RGBA8, GL_SAMPLES, 3, &mut samples);
    assert_eq!(samples, [-7; 3]);
    c.get_internalformativ(GL_RENDERBUFFER, GL_RGBA8, GL_SAMPLES, 3, &mut samples);
    assert_eq!((samples, c.get_error()), ([4, -7, -7], GL_NO_ERROR));
}
