//! What the calls for parts of textures refuse: `ARB_get_texture_sub_image`.

use gl_api::*;

/// A texture, level, offset, size, and format; the flag it must set, and words of its message.
type Row = (GLuint, GLint, [GLint; 3], [GLsizei; 3], GLenum, GLenum, &'static str);

const ENUM: GLenum = GL_INVALID_ENUM;
const VALUE: GLenum = GL_INVALID_VALUE;
const OPERATION: GLenum = GL_INVALID_OPERATION;

/// Texture 1 has 8×8 texels at level 0, and is compressed at level 1; texture 2 has samples.
fn prepared() -> Context {
    let mut c = super::context();
    c.bind_texture(GL_TEXTURE_2D, 1);
    c.tex_image_2d(
        GL_TEXTURE_2D,
        0,
        GL_RGBA as i32,
        8,
        8,
        0,
        GL_RGBA,
        GL_UNSIGNED_BYTE,
        Data::Null,
    );
    let format = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
    c.compressed_tex_image_2d(GL_TEXTURE_2D, 1, format, 8, 8, 0, 32, Data::Bytes(&[0; 32]));
    c.bind_texture(GL_TEXTURE_2D_MULTISAMPLE, 2);
    c
}

const ROWS: &[Row] = &[
    (9, 0, [0; 3], [1; 3], GL_RGBA, OPERATION, "texture = 9 is no texture"),
    (2, 0, [0; 3], [1; 3], GL_RGBA, OPERATION, "several samples"),
    (1, -1, [0; 3], [1; 3], GL_RGBA, VALUE, "level = -1"),
    (1, 99, [0; 3], [1; 3], GL_RGBA, VALUE, "level = 99"),
    (1, 2, [0; 3], [1; 3], GL_RGBA, VALUE, "ends at x = 1; the level has 0"),
    (1, 0, [-1, 0, 0], [1; 3], GL_RGBA, VALUE, "xoffset = -1"),
    (1, 0, [0; 3], [1, -1, 1], GL_RGBA, VALUE, "height = -1"),
    (1, 0, [0, 5, 0], [4, 4, 1], GL_RGBA, VALUE, "ends at y = 9; the level has 8"),
    (1, 0, [0, 0, 1], [1; 3], GL_RGBA, VALUE, "ends at z = 2"),
    (1, 0, [0; 3], [1; 3], GL_LINEAR, ENUM, "format"),
    (1, 0, [0; 3], [1; 3], GL_COLOR_INDEX, ENUM, "no indices"),
    (1, 0, [0; 3], [1; 3], GL_DEPTH_COMPONENT, OPERATION, "go together, and not with colours"),
    (1, 0, [0; 3], [8, 8, 1], GL_RGBA, OPERATION, "bufSize = 255, but 256 bytes"),
];

/// The same of compressed levels, whose format nobody asks for.
const COMPRESSED: &[Row] = &[
    (9, 1, [0; 3], [4, 4, 1], GL_NONE, OPERATION, "texture = 9"),
    (1, 0, [0; 3], [4, 4, 1], GL_NONE, OPERATION, "not compressed"),
    (1, 1, [1, 0, 0], [4, 4, 1], GL_NONE, VALUE, "from 1 to 5 cuts blocks"),
    (1, 1, [0; 3], [4, 3, 1], GL_NONE, VALUE, "from 0 to 3 cuts blocks"),
    (1, 1, [8, 0, 0], [4, 4, 1], GL_NONE, VALUE, "ends at x = 12"),
];

/// Runs the rows.
pub fn run() {
    for (number, row) in ROWS.iter().enumerate() {
        let &(texture, level, [x, y, z], [w, h, d], format, flag, words) = row;
        let call = |c: &mut Context| {
            let (ty, mut bytes) = (GL_UNSIGNED_BYTE, [0; 256]);
            let out = DataOut::Bytes(&mut bytes);
            c.get_texture_sub_image(texture, level, x, y, z, w, h, d, format, ty, 255, out);
        };
        super::row(&mut prepared(), format!("glGetTextureSubImage {number}"), &call, flag, words);
    }
    for (number, row) in COMPRESSED.iter().enumerate() {
        let &(texture, level, [x, y, z], [w, h, d], _, flag, words) = row;
        let call = |c: &mut Context| {
            let mut bytes = [0; 256];
            let out = DataOut::Bytes(&mut bytes);
            c.get_compressed_texture_sub_image(texture, level, x, y, z, w, h, d, 256, out);
        };
        super::row(&mut prepared(), format!("blocks {number}"), &call, flag, words);
    }
    let small = |c: &mut Context| {
        let mut bytes = [0; 256];
        let out = DataOut::Bytes(&mut bytes);
        c.get_compressed_texture_sub_image(1, 1, 0, 0, 0, 8, 8, 1, 31, out);
    };
    super::row(&mut prepared(), "blocks".into(), &small, OPERATION, "32 bytes are needed");
}
