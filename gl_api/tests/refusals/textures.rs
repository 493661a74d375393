//! What the calls on texture images refuse: rows of arguments, the flag, and words of the message. A 4×4 RGBA8 texture is bound to `GL_TEXTURE_2D`, a 4×4×4 one to
//! `GL_TEXTURE_3D`, a DXT1 one of 8×8 to the face +X of the cube map.

use gl_api::*;

fn context() -> Context {
    let mut c = super::context();
    let (rgba, byte) = (GL_RGBA, GL_UNSIGNED_BYTE);
    c.bind_texture(GL_TEXTURE_2D, 1);
    c.tex_image_2d(GL_TEXTURE_2D, 0, rgba as i32, 4, 4, 0, rgba, byte, Data::Null);
    c.bind_texture(GL_TEXTURE_3D, 2);
    c.tex_image_3d(GL_TEXTURE_3D, 0, rgba as i32, 4, 4, 4, 0, rgba, byte, Data::Null);
    c.bind_texture(GL_TEXTURE_CUBE_MAP, 3);
    let dxt1 = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
    c.compressed_tex_image_2d(FACE, 0, dxt1, 8, 8, 0, 32, Data::Null);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    c
}

pub(super) const FACE: GLenum = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
pub(super) const ENUM: GLenum = GL_INVALID_ENUM;
pub(super) const VALUE: GLenum = GL_INVALID_VALUE;
pub(super) const OPERATION: GLenum = GL_INVALID_OPERATION;

/// Runs a row.
pub(super) fn refused(
    row: &dyn std::fmt::Debug,
    flag: GLenum,
    words: &str,
    call: impl Fn(&mut Context),
) {
    refused_after(row, flag, words, |_| {}, call);
}

/// Runs a row after what it needs.
pub(super) fn refused_after(
    row: &dyn std::fmt::Debug,
    flag: GLenum,
    words: &str,
    prepare: impl Fn(&mut Context),
    call: impl Fn(&mut Context),
) {
    let mut c = context();
    prepare(&mut c);
    super::row(&mut c, format!("{row:?}"), &call, flag, words);
}

/// Runs the rows.
pub fn run() {
    images();
    sub_images();
    copies();
    compressed_images();
    pixel_buffers();
}

/// Dimensions, target, level, internal format, size, border, format, type.
type Image = (u8, GLenum, i32, GLenum, [i32; 3], i32, GLenum, GLenum);

fn image(c: &mut Context, (dimensions, target, level, internal, size, border, format, ty): Image) {
    let ([w, h, d], internal, none) = (size, internal as i32, Data::Null);
    match dimensions {
        1 => c.tex_image_1d(target, level, internal, w, border, format, ty, none),
        2 => c.tex_image_2d(target, level, internal, w, h, border, format, ty, none),
        _ => c.tex_image_3d(target, level, internal, w, h, d, border, format, ty, none),
    }
}

fn images() {
    const U8: GLenum = GL_UNSIGNED_BYTE;
    const C: GLenum = GL_RGBA;
    const D: GLenum = GL_DEPTH_COMPONENT;
    const CUBES: GLenum = GL_TEXTURE_CUBE_MAP_ARRAY;
    const ONE: [i32; 3] = [1; 3];
    let rows: &[(Image, GLenum, &str)] = &[
        // Targets of other dimensions, and proxies where there is none.
        ((1, GL_TEXTURE_2D, 0, C, ONE, 0, C, U8), ENUM, "GL_TEXTURE_1D"),
        ((1, GL_TEXTURE_1D_ARRAY, 0, C, ONE, 0, C, U8), ENUM, "target"),
        ((1, GL_PROXY_TEXTURE_2D, 0, C, ONE, 0, C, U8), ENUM, "GL_PROXY_TEXTURE_1D"),
        ((2, GL_TEXTURE_1D, 0, C, ONE, 0, C, U8), ENUM, "GL_TEXTURE_2D"),
        ((2, GL_TEXTURE_3D, 0, C, ONE, 0, C, U8), ENUM, "target"),
        ((2, GL_TEXTURE_2D_ARRAY, 0, C, ONE, 0, C, U8), ENUM, "target"),
        ((2, CUBES, 0, C, ONE, 0, C, U8), ENUM, "target"),
        ((2, GL_TEXTURE_CUBE_MAP, 0, C, ONE, 0, C, U8), ENUM, "GL_TEXTURE_CUBE_MAP_POSITIVE_X"),
        ((2, GL_PROXY_TEXTURE_3D, 0, C, ONE, 0, C, U8), ENUM, "GL_PROXY_TEXTURE_CUBE_MAP"),
        ((3, GL_TEXTURE_2D, 0, C, ONE, 0, C, U8), ENUM, "GL_TEXTURE_3D"),
        ((3, FACE, 0, C, ONE, 0, C, U8), ENUM, "target"),
        ((3, 0, 0, C, ONE, 0, C, U8), ENUM, "GL_PROXY_TEXTURE_2D_ARRAY"),
        // Levels.
        ((1, GL_TEXTURE_1D, -1, C, ONE, 0, C, U8), VALUE, "level = -1 must be 0 to 13"),
        ((1, GL_TEXTURE_1D, 14, C, ONE, 0, C, U8), VALUE, "level = 14"),
        ((2, GL_TEXTURE_2D, 14, C, ONE, 0, C, U8), VALUE, "level = 14"),
        ((2, FACE, i32::MAX, C, ONE, 0, C, U8), VALUE, "level"),
        (
            (2, GL_TEXTURE_RECTANGLE, 1, C, ONE, 0, C, U8),
            VALUE,
            "of GL_TEXTURE_RECTANGLE must be 0",
        ),
        ((2, GL_TEXTURE_1D_ARRAY, 14, C, ONE, 0, C, U8), VALUE, "level = 14"),
        ((3, GL_TEXTURE_3D, 10, C, ONE, 0, C, U8), VALUE, "level = 10 must be 0 to 9"),
        ((3, GL_TEXTURE_2D_ARRAY, 14, C, ONE, 0, C, U8), VALUE, "level = 14"),
        ((3, CUBES, 14, C, [1, 1, 6], 0, C, U8), VALUE, "level = 14"),
        ((2, GL_PROXY_TEXTURE_2D, 14, C, ONE, 0, C, U8), VALUE, "level = 14"),
        // Internal formats.
        ((1, GL_TEXTURE_1D, 0, 0, ONE, 0, C, U8), VALUE, "internalformat = 0"),
        ((2, GL_TEXTURE_2D, 0, 5, ONE, 0, C, U8), VALUE, "internalformat = 5"),
        ((2, GL_TEXTURE_2D, 0, GL_BGRA, ONE, 0, C, U8), VALUE, "internalformat = GL_BGRA"),
        ((3, GL_TEXTURE_3D, 0, GL_COLOR_INDEX, ONE, 0, C, U8), VALUE, "GL_COLOR_INDEX"),
        // Sizes.
        ((1, GL_TEXTURE_1D, 0, C, [-1, 1, 1], 0, C, U8), VALUE, "width = -1 must not be negative"),
        ((2, GL_TEXTURE_2D, 0, C, [1, -1, 1], 0, C, U8), VALUE, "height = -1"),
        ((3, GL_TEXTURE_3D, 0, C, [1, 1, -1], 0, C, U8), VALUE, "depth = -1"),
        ((1, GL_TEXTURE_1D, 0, C, [8193, 1, 1], 0, C, U8), VALUE, "must not be above 8192"),
        ((1, GL_TEXTURE_1D, 3, C, [1025, 1, 1], 0, C, U8), VALUE, "above 1024 at level 3"),
        ((2, GL_TEXTURE_2D, 0, C, [1, 8193, 1], 0, C, U8), VALUE, "height = 8193"),
        ((2, GL_TEXTURE_2D, 13, C, [2, 1, 1], 0, C, U8), VALUE, "above 1 at level 13"),
        ((2, GL_TEXTURE_RECTANGLE, 0, C, [8193, 1, 1], 0, C, U8), VALUE, "width = 8193"),
        ((2, GL_TEXTURE_1D_ARRAY, 0, C, [1, 2049, 1], 0, C, U8), VALUE, "height = 2049"),
        ((2, FACE, 0, C, [2, 1, 1], 0, C, U8), VALUE, "must be equal"),
        ((2, FACE, 0, C, [8193, 8193, 1], 0, C, U8), VALUE, "width = 8193"),
        ((2, GL_PROXY_TEXTURE_CUBE_MAP, 0, C, [2, 1, 1], 0, C, U8), VALUE, "must be equal"),
        ((3, GL_TEXTURE_3D, 0, C, [513, 1, 1], 0, C, U8), VALUE, "must not be above 512"),
        ((3, GL_TEXTURE_3D, 0, C, [1, 513, 1], 0, C, U8), VALUE, "height = 513"),
        ((3, GL_TEXTURE_3D, 0, C, [1, 1, 513], 0, C, U8), VALUE, "depth = 513"),
        ((3, GL_TEXTURE_3D, 9, C, [1, 1, 2], 0, C, U8), VALUE, "depth = 2"),
        ((3, GL_TEXTURE_2D_ARRAY, 0, C, [1, 1, 2049], 0, C, U8), VALUE, "depth = 2049"),
        ((3, GL_TEXTURE_2D_ARRAY, 13, C, [2, 1, 2048], 0, C, U8), VALUE, "width = 2"),
        ((3, CUBES, 0, C, [1, 1, 7], 0, C, U8), VALUE, "depth = 7 must be a multiple of 6"),
        ((3, CUBES, 0, C, [2, 1, 6], 0, C, U8), VALUE, "width = 2 and height = 1"),
        ((3, CUBES, 0, C, [1, 1, 2052], 0, C, U8), VALUE, "depth = 2052"),
        ((3, CUBES, 13, C, [2, 2, 6], 0, C, U8), VALUE, "width = 2"),
        ((3, GL_PROXY_TEXTURE_CUBE_MAP_ARRAY, 0, C, ONE, 0, C, U8), VALUE, "multiple of 6"),
        // Borders.
        ((1, GL_TEXTURE_1D, 0, C, [4, 1, 1], 2, C, U8), VALUE, "border = 2 must be 0 or 1"),
        ((1, GL_TEXTURE_1D, 0, C, [1, 1, 1], 1, C, U8), VALUE, "must be at least 2"),
        ((2, GL_TEXTURE_2D, 0, C, [3, 1, 1], 1, C, U8), VALUE, "height = 1 must be at least 2"),
        ((2, GL_TEXTURE_2D, 0, C, [3, 3, 1], -1, C, U8), VALUE, "border = -1"),
        ((2, GL_TEXTURE_2D, 0, C, [8195, 3, 1], 1, C, U8), VALUE, "must not be above 8194"),
        ((2, GL_TEXTURE_RECTANGLE, 0, C, [3, 3, 1], 1, C, U8), VALUE, "of a rectangle must be 0"),
        ((3, GL_TEXTURE_3D, 0, C, [3, 3, 1], 1, C, U8), VALUE, "depth = 1 must be at least 2"),
        // Formats and types.
        ((1, GL_TEXTURE_1D, 0, C, ONE, 0, GL_INTENSITY, U8), ENUM, "format = GL_INTENSITY"),
        ((2, GL_TEXTURE_2D, 0, C, ONE, 0, GL_RGBA8, U8), ENUM, "format = GL_RGBA8"),
        ((3, GL_TEXTURE_3D, 0, C, ONE, 0, C, GL_DOUBLE), ENUM, "type = GL_DOUBLE"),
        ((2, GL_TEXTURE_2D, 0, C, ONE, 0, C, GL_BITMAP), ENUM, "type = GL_BITMAP"),
        ((2, GL_TEXTURE_2D, 0, C, ONE, 0, C, GL_UNSIGNED_BYTE_3_3_2), OPERATION, "takes GL_RGB"),
        ((2, GL_TEXTURE_2D, 0, C, ONE, 0, GL_BGR, GL_UNSIGNED_SHORT_5_6_5), OPERATION, "GL_RGB"),
        ((2, GL_TEXTURE_2D, 0, C, ONE, 0, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4), OPERATION, "GL_BGRA"),
        ((2, GL_TEXTURE_2D, 0, C, ONE, 0, GL_RG, GL_UNSIGNED_INT_8_8_8_8), OPERATION, "GL_BGRA"),
        ((2, GL_TEXTURE_2D, 0, C, ONE, 0, C, GL_UNSIGNED_INT_5_9_9_9_REV), OPERATION, "GL_RGB"),
        ((2, GL_TEXTURE_2D, 0, C, ONE, 0, C, GL_UNSIGNED_INT_10F_11F_11F_REV), OPERATION, "GL_RGB"),
        (
            (
                2,
                GL_TEXTURE_2D,
                0,
                GL_RGB8I,
                ONE,
                0,
                GL_RGB_INTEGER,
                GL_UNSIGNED_INT_10F_11F_11F_REV,
            ),
            OPERATION,
            "takes GL_RGB",
        ),
        (
            (
                2,
                GL_TEXTURE_2D,
                0,
                GL_RGB8I,
                ONE,
                0,
                GL_RGB_INTEGER,
                GL_FLOAT_32_UNSIGNED_INT_24_8_REV,
            ),
            OPERATION,
            "takes GL_DEPTH_STENCIL",
        ),
        ((2, GL_TEXTURE_2D, 0, C, ONE, 0, C, GL_UNSIGNED_INT_24_8), OPERATION, "GL_DEPTH_STENCIL"),
        (
            (2, GL_TEXTURE_2D, 0, D, ONE, 0, GL_DEPTH_STENCIL, GL_FLOAT),
            ENUM,
            "GL_UNSIGNED_INT_24_8",
        ),
        (
            (2, GL_TEXTURE_2D, 0, C, ONE, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8),
            OPERATION,
            "go together",
        ),
        ((2, GL_TEXTURE_2D, 0, C, ONE, 0, D, GL_FLOAT), OPERATION, "go together"),
        ((2, GL_TEXTURE_2D, 0, D, ONE, 0, C, GL_FLOAT), OPERATION, "go together"),
        ((1, GL_TEXTURE_1D, 0, D, ONE, 0, C, U8), OPERATION, "go together"),
        ((3, GL_TEXTURE_3D, 0, D, ONE, 0, D, GL_FLOAT), OPERATION, "no depth formats"),
        ((2, GL_TEXTURE_2D, 0, C, ONE, 0, GL_RGBA_INTEGER, U8), OPERATION, "integer"),
        ((2, GL_TEXTURE_2D, 0, GL_RGBA8UI, ONE, 0, C, U8), OPERATION, "integer"),
        ((2, GL_TEXTURE_2D, 0, GL_RGBA8I, ONE, 0, GL_RGBA_INTEGER, GL_FLOAT), ENUM, "as floats"),
        ((2, GL_TEXTURE_2D, 0, GL_R32UI, ONE, 0, GL_RED_INTEGER, GL_HALF_FLOAT), ENUM, "as floats"),
        // Compressed formats.
        (
            (1, GL_TEXTURE_1D, 0, GL_COMPRESSED_RED_RGTC1, ONE, 0, C, U8),
            OPERATION,
            "takes no compressed",
        ),
        (
            (3, GL_TEXTURE_3D, 0, GL_COMPRESSED_RG_RGTC2, ONE, 0, C, U8),
            OPERATION,
            "takes no compressed",
        ),
        (
            (2, GL_TEXTURE_RECTANGLE, 0, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, ONE, 0, C, U8),
            OPERATION,
            "takes no compressed",
        ),
        (
            (2, GL_TEXTURE_2D, 0, GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, [6, 6, 1], 1, C, U8),
            OPERATION,
            "no border",
        ),
        // Within the limits of each side, but not of memory.
        (
            (3, GL_TEXTURE_2D_ARRAY, 0, GL_RGBA32F, [8192, 8192, 2048], 0, C, U8),
            GL_OUT_OF_MEMORY,
            "too large",
        ),
    ];
    for (row, flag, words) in rows {
        refused(row, *flag, words, |c| image(c, *row));
    }
}

/// Dimensions, target, level, offset, size, format.
type Part = (u8, GLenum, i32, [i32; 3], [i32; 3], GLenum);

fn sub_images() {
    const ONE: [i32; 3] = [1; 3];
    const AT: [i32; 3] = [0; 3];
    const C: GLenum = GL_RGBA;
    let rows: &[(Part, GLenum, &str)] = &[
        ((1, GL_TEXTURE_2D, 0, AT, ONE, C), ENUM, "GL_TEXTURE_1D"),
        ((2, GL_TEXTURE_3D, 0, AT, ONE, C), ENUM, "target"),
        ((3, GL_TEXTURE_2D, 0, AT, ONE, C), ENUM, "target"),
        ((1, GL_PROXY_TEXTURE_1D, 0, AT, ONE, C), ENUM, "proxy"),
        ((2, GL_PROXY_TEXTURE_2D, 0, AT, ONE, C), ENUM, "proxy"),
        ((3, GL_PROXY_TEXTURE_3D, 0, AT, ONE, C), ENUM, "proxy"),
        ((3, GL_PROXY_TEXTURE_CUBE_MAP_ARRAY, 0, AT, ONE, C), ENUM, "proxy"),
        ((1, GL_TEXTURE_1D, 0, AT, ONE, C), OPERATION, "no image yet"),
        ((2, GL_TEXTURE_2D, 1, AT, ONE, C), OPERATION, "no image yet"),
        ((3, GL_TEXTURE_2D_ARRAY, 0, AT, ONE, C), OPERATION, "no image yet"),
        ((3, GL_TEXTURE_CUBE_MAP_ARRAY, 0, AT, ONE, C), OPERATION, "no image yet"),
        ((2, GL_TEXTURE_2D, -1, AT, ONE, C), VALUE, "level = -1"),
        ((3, GL_TEXTURE_3D, 10, AT, ONE, C), VALUE, "level = 10"),
        ((2, GL_TEXTURE_RECTANGLE, 1, AT, ONE, C), VALUE, "level = 1"),
        ((2, GL_TEXTURE_2D, 0, AT, [-1, 1, 1], C), VALUE, "width = -1"),
        ((2, GL_TEXTURE_2D, 0, AT, [1, -1, 1], C), VALUE, "height = -1"),
        ((3, GL_TEXTURE_3D, 0, AT, [1, 1, -1], C), VALUE, "depth = -1"),
        ((2, GL_TEXTURE_2D, 0, [-1, 0, 0], ONE, C), VALUE, "xoffset = -1"),
        ((2, GL_TEXTURE_2D, 0, [0, 4, 0], ONE, C), VALUE, "yoffset = 4"),
        ((2, GL_TEXTURE_2D, 0, [i32::MAX, 0, 0], ONE, C), VALUE, "xoffset"),
        ((3, GL_TEXTURE_3D, 0, [0, 0, 4], ONE, C), VALUE, "zoffset = 4"),
        ((3, GL_TEXTURE_3D, 0, [0, 0, -1], ONE, C), VALUE, "zoffset = -1"),
        ((3, GL_TEXTURE_3D, 0, AT, [1, 5, 1], C), VALUE, "height = 5"),
        ((2, GL_TEXTURE_2D, 0, AT, ONE, GL_DEPTH_COMPONENT), OPERATION, "go together"),
        ((2, GL_TEXTURE_2D, 0, AT, ONE, GL_RGBA_INTEGER), OPERATION, "integer"),
        ((2, GL_TEXTURE_2D, 0, AT, ONE, GL_RGBA8), ENUM, "format"),
        ((2, GL_TEXTURE_2D, 0, AT, [4, 4, 1], C), OPERATION, "must not be NULL"),
        ((3, GL_TEXTURE_3D, 0, AT, [4, 4, 4], C), OPERATION, "256 bytes"),
    ];
    for (row, flag, words) in rows {
        refused(row, *flag, words, |c| {
            let &(dimensions, target, level, [x, y, z], [w, h, d], format) = row;
            let (ty, none) = (GL_UNSIGNED_BYTE, Data::Null);
            match dimensions {
                1 => c.tex_sub_image_1d(target, level, x, w, format, ty, none),
                2 => c.tex_sub_image_2d(target, level, x, y, w, h, format, ty, none),
                _ => c.tex_sub_image_3d(target, level, x, y, z, w, h, d, format, ty, none),
            }
        });
    }
    // Blocks of the 8×8 DXT1 face.
    for (at, size) in [([2, 0], [4, 4]), ([0, 1], [4, 4]), ([0, 0], [3, 4]), ([4, 4], [4, 2])] {
        refused(&(at, size), OPERATION, "cuts the 4×4 blocks", |c| {
            let ([x, y], [w, h], pixels) = (at, size, Data::Bytes(&[0; 64]));
            c.tex_sub_image_2d(FACE, 0, x, y, w, h, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
        });
    }
}

fn copies() {
    const ONE: [i32; 3] = [1; 3];
    let rows: &[(Image, GLenum, &str)] = &[
        ((1, GL_TEXTURE_2D, 0, GL_RGB, ONE, 0, 0, 0), ENUM, "GL_TEXTURE_1D"),
        ((1, GL_PROXY_TEXTURE_1D, 0, GL_RGB, ONE, 0, 0, 0), ENUM, "proxy"),
        ((2, GL_TEXTURE_3D, 0, GL_RGB, ONE, 0, 0, 0), ENUM, "target"),
        ((2, GL_PROXY_TEXTURE_2D, 0, GL_RGB, ONE, 0, 0, 0), ENUM, "proxy"),
        ((1, GL_TEXTURE_1D, 14, GL_RGB, ONE, 0, 0, 0), VALUE, "level = 14"),
        ((2, GL_TEXTURE_2D, -1, GL_RGB, ONE, 0, 0, 0), VALUE, "level = -1"),
        ((1, GL_TEXTURE_1D, 0, 3, ONE, 0, 0, 0), ENUM, "internalformat = 3"),
        ((2, GL_TEXTURE_2D, 0, GL_BGR, ONE, 0, 0, 0), ENUM, "internalformat = GL_BGR"),
        ((1, GL_TEXTURE_1D, 0, GL_RGB, [-1, 1, 1], 0, 0, 0), VALUE, "width = -1"),
        ((2, GL_TEXTURE_2D, 0, GL_RGB, [1, -1, 1], 0, 0, 0), VALUE, "height = -1"),
        ((2, GL_TEXTURE_2D, 0, GL_RGB, [8193, 1, 1], 0, 0, 0), VALUE, "above 8192"),
        ((2, FACE, 0, GL_RGB, [1, 2, 1], 0, 0, 0), VALUE, "must be equal"),
        ((2, GL_TEXTURE_2D, 0, GL_RGB, ONE, 2, 0, 0), VALUE, "border = 2"),
        ((2, GL_TEXTURE_RECTANGLE, 0, GL_RGB, [3; 3], 1, 0, 0), VALUE, "rectangle"),
        ((2, GL_TEXTURE_2D, 0, GL_RGBA8UI, ONE, 0, 0, 0), OPERATION, "integers stay"),
        ((1, GL_TEXTURE_1D, 0, GL_R32I, ONE, 0, 0, 0), OPERATION, "integers stay"),
    ];
    for (row, flag, words) in rows {
        refused(row, *flag, words, |c| {
            let &(dimensions, target, level, internal, [w, h, _], border, ..) = row;
            match dimensions {
                1 => c.copy_tex_image_1d(target, level, internal, 0, 0, w, border),
                _ => c.copy_tex_image_2d(target, level, internal, 0, 0, w, h, border),
            }
        });
    }
    let rows: &[(Part, GLenum, &str)] = &[
        ((1, GL_TEXTURE_2D, 0, [0; 3], ONE, 0), ENUM, "GL_TEXTURE_1D"),
        ((2, GL_TEXTURE_1D, 0, [0; 3], ONE, 0), ENUM, "target"),
        ((3, GL_TEXTURE_2D, 0, [0; 3], ONE, 0), ENUM, "target"),
        ((1, GL_TEXTURE_1D, 0, [0; 3], ONE, 0), OPERATION, "no image yet"),
        ((2, GL_TEXTURE_2D, 3, [0; 3], ONE, 0), OPERATION, "no image yet"),
        ((2, GL_TEXTURE_2D, 0, [4, 0, 0], ONE, 0), VALUE, "xoffset = 4"),
        ((2, GL_TEXTURE_2D, 0, [0; 3], [5, 1, 1], 0), VALUE, "width = 5"),
        ((3, GL_TEXTURE_3D, 0, [0, 0, 4], ONE, 0), VALUE, "zoffset = 4"),
        ((3, GL_TEXTURE_3D, 0, [0; 3], [-1, 1, 1], 0), VALUE, "width = -1"),
    ];
    for (row, flag, words) in rows {
        refused(row, *flag, words, |c| {
            let &(dimensions, target, level, [x, y, z], [w, h, _], _) = row;
            match dimensions {
                1 => c.copy_tex_sub_image_1d(target, level, x, 0, 0, w),
                2 => c.copy_tex_sub_image_2d(target, level, x, y, 0, 0, w, h),
                _ => c.copy_tex_sub_image_3d(target, level, x, y, z, 0, 0, w, h),
            }
        });
    }
}

/// Target, format, size, border, `imageSize`, and what is said.
type Blocks = (GLenum, GLenum, [i32; 2], i32, i32, GLenum, &'static str);
/// Target, offset, size, format, `imageSize`, and what is said.
type SubBlocks = (GLenum, [i32; 2], [i32; 2], GLenum, i32, GLenum, &'static str);

fn compressed_images() {
    const DXT1: GLenum = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
    let rows: &[Blocks] = &[
        (GL_TEXTURE_3D, DXT1, [4, 4], 0, 8, ENUM, "target"),
        (GL_TEXTURE_2D, GL_RGBA, [4, 4], 0, 8, ENUM, "internalformat = GL_RGBA"),
        (GL_TEXTURE_2D, GL_COMPRESSED_RGBA, [4, 4], 0, 8, ENUM, "GL_COMPRESSED_RGBA"),
        (GL_TEXTURE_2D, DXT1, [4, 4], 1, 8, VALUE, "border = 1"),
        (GL_TEXTURE_2D, DXT1, [4, 4], 0, 9, VALUE, "take 8 bytes"),
        (GL_TEXTURE_2D, DXT1, [5, 5], 0, 8, VALUE, "take 32 bytes"),
        (GL_TEXTURE_2D, DXT1, [4, 4], 0, -1, VALUE, "imageSize = -1"),
        (GL_TEXTURE_2D, DXT1, [-4, 4], 0, 8, VALUE, "width = -4"),
        (GL_TEXTURE_2D, DXT1, [8196, 4], 0, 8, VALUE, "above 8192"),
        (GL_TEXTURE_RECTANGLE, DXT1, [4, 4], 0, 8, OPERATION, "takes no compressed"),
        (GL_TEXTURE_1D_ARRAY, DXT1, [4, 4], 0, 8, OPERATION, "takes no compressed"),
        (GL_TEXTURE_2D, DXT1, [8, 4], 0, 16, OPERATION, "has 8"),
    ];
    for row in rows {
        let &(target, internal, [w, h], border, size, flag, words) = row;
        refused(row, flag, words, |c| {
            let data = Data::Bytes(&[0; 8]);
            c.compressed_tex_image_2d(target, 0, internal, w, h, border, size, data);
        });
    }
    let rows: &[SubBlocks] = &[
        (FACE, [0, 0], [4, 4], GL_RGBA, 8, ENUM, "format = GL_RGBA"),
        (GL_TEXTURE_2D, [0, 0], [4, 4], DXT1, 8, OPERATION, "must be the level's"),
        (FACE, [0, 0], [4, 4], GL_COMPRESSED_RED_RGTC1, 8, OPERATION, "must be the level's"),
        (FACE, [2, 0], [4, 4], DXT1, 8, OPERATION, "cuts the 4×4 blocks"),
        (FACE, [0, 0], [4, 2], DXT1, 8, OPERATION, "cuts the 4×4 blocks"),
        (FACE, [0, 0], [4, 4], DXT1, 7, VALUE, "take 8 bytes"),
        (FACE, [8, 0], [4, 4], DXT1, 8, VALUE, "xoffset = 8"),
        (FACE, [0, 0], [8, 4], DXT1, 16, OPERATION, "has 8"),
        (GL_TEXTURE_3D, [0, 0], [4, 4], DXT1, 8, ENUM, "target"),
    ];
    for row in rows {
        let &(target, [x, y], [w, h], format, size, flag, words) = row;
        refused(row, flag, words, |c| {
            let data = Data::Bytes(&[0; 8]);
            c.compressed_tex_sub_image_2d(target, 0, x, y, w, h, format, size, data);
        });
    }
    refused(&"1D", OPERATION, "takes no compressed", |c| {
        c.compressed_tex_image_1d(GL_TEXTURE_1D, 0, DXT1, 4, 0, 8, Data::Null);
    });
    refused(&"3D", OPERATION, "takes no compressed", |c| {
        c.compressed_tex_image_3d(GL_TEXTURE_3D, 0, DXT1, 4, 4, 1, 0, 8, Data::Null);
    });
    refused(&"not compressed", OPERATION, "not compressed", |c| {
        c.get_compressed_tex_image(GL_TEXTURE_2D, 0, DataOut::Bytes(&mut [0; 64]));
    });
    refused(&"room", OPERATION, "32 bytes are needed", |c| {
        c.get_compressed_tex_image(FACE, 0, DataOut::Bytes(&mut [0; 31]));
    });
}

fn pixel_buffers() {
    let bound = |c: &mut Context, target| {
        c.bind_buffer(target, 1);
        c.buffer_data(target, 16, Data::Null, GL_STATIC_DRAW);
    };
    let image = |c: &mut Context, ty, pixels: Data<'_>| {
        c.tex_image_2d(GL_TEXTURE_2D, 0, 4, 2, 2, 0, GL_RGBA, ty, pixels);
    };
    refused_after(
        &"slice",
        OPERATION,
        "a buffer is bound",
        |c| bound(c, GL_PIXEL_UNPACK_BUFFER),
        |c| {
            image(c, GL_UNSIGNED_BYTE, Data::Bytes(&[0; 16]));
        },
    );
    refused_after(
        &"length",
        OPERATION,
        "take 16 bytes",
        |c| bound(c, GL_PIXEL_UNPACK_BUFFER),
        |c| {
            image(c, GL_UNSIGNED_BYTE, Data::Offset(4));
        },
    );
    refused_after(
        &"behind",
        OPERATION,
        "lies behind the 16 bytes of buffer 1: while it is bound to GL_PIXEL_UNPACK_BUFFER",
        |c| bound(c, GL_PIXEL_UNPACK_BUFFER),
        |c| {
            image(c, GL_UNSIGNED_BYTE, Data::Offset(17));
        },
    );
    let hundred = |c: &mut Context| {
        c.bind_buffer(GL_PIXEL_UNPACK_BUFFER, 1);
        c.buffer_data(GL_PIXEL_UNPACK_BUFFER, 100, Data::Null, GL_STATIC_DRAW);
    };
    refused_after(&"multiple", OPERATION, "must be a multiple", hundred, |c| {
        image(c, GL_UNSIGNED_SHORT, Data::Offset(3));
    });
    refused(&"no buffer", OPERATION, "no buffer is bound to GL_PIXEL_PACK_BUFFER", |c| {
        c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Offset(8));
    });
    refused_after(
        &"room",
        OPERATION,
        "are needed",
        |c| bound(c, GL_PIXEL_PACK_BUFFER),
        |c| {
            c.read_pixels(0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Null);
        },
    );
}
