//! What calls on buffer textures refuse (`ARB_texture_buffer_object`, `ARB_texture_buffer_range`).
//! Buffer 1 has 64 bytes and is the store of texture 1.

use super::Case;
use gl_api::*;

const T: GLenum = GL_TEXTURE_BUFFER;

fn context() -> Context {
    let mut c = super::context();
    c.bind_buffer(T, 1);
    c.buffer_data(T, 64, Data::Null, GL_STATIC_DRAW);
    c.bind_texture(T, 1);
    c.tex_buffer(T, GL_R8, 1);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    c
}

const ENUM: GLenum = GL_INVALID_ENUM;
const VALUE: GLenum = GL_INVALID_VALUE;
const OPERATION: GLenum = GL_INVALID_OPERATION;

const ROWS: &[Case] = &[
    (|c| c.tex_buffer(GL_TEXTURE_2D, GL_R8, 1), ENUM, "target = GL_TEXTURE_2D"),
    (|c| c.tex_buffer(T, GL_RGB8, 1), ENUM, "internalformat = GL_RGB8"),
    (|c| c.tex_buffer(T, GL_RGBA, 1), ENUM, "internalformat = GL_RGBA "),
    (|c| c.tex_buffer(T, GL_DEPTH_COMPONENT24, 1), ENUM, "internalformat"),
    (|c| c.tex_buffer(T, GL_SRGB8_ALPHA8, 1), ENUM, "internalformat"),
    (|c| c.tex_buffer(T, GL_R8, 9), OPERATION, "buffer = 9 is no buffer object"),
    (|c| c.tex_buffer_range(GL_TEXTURE_1D, GL_R8, 1, 0, 4), ENUM, "target"),
    (|c| c.tex_buffer_range(T, GL_R8_SNORM, 1, 0, 4), ENUM, "internalformat"),
    (|c| c.tex_buffer_range(T, GL_R8, 9, 0, 4), OPERATION, "buffer = 9"),
    (|c| c.tex_buffer_range(T, GL_R8, 1, -1, 4), VALUE, "offset = -1"),
    (|c| c.tex_buffer_range(T, GL_R8, 1, 0, 0), VALUE, "size = 0"),
    (|c| c.tex_buffer_range(T, GL_R8, 1, 0, -4), VALUE, "size = -4"),
    (|c| c.tex_buffer_range(T, GL_R8, 1, 8, 4), VALUE, "must be a multiple of 16"),
    (|c| c.tex_buffer_range(T, GL_R8, 1, 16, 49), VALUE, "the 64 that"),
    (|c| c.tex_buffer_range(T, GL_R8, 1, isize::MAX, isize::MAX), VALUE, "offset"),
    // There is nothing to set, to specify, to filter or to draw to.
    (|c| c.tex_parameteri(T, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32), ENUM, "no parameters"),
    (|c| c.tex_parameterfv(T, GL_TEXTURE_BORDER_COLOR, &[0.0; 4]), ENUM, "no parameters"),
    (|c| c.get_tex_parameteriv(T, GL_TEXTURE_MIN_FILTER, &mut [0]), ENUM, "no parameters"),
    (|c| c.generate_mipmap(T), ENUM, "no mipmaps"),
    (|c| c.enable(T), ENUM, "GL_TEXTURE_BUFFER"),
    (
        |c| {
            let (rgba, byte) = (GL_RGBA, GL_UNSIGNED_BYTE);
            c.tex_image_1d(T, 0, rgba as i32, 4, 0, rgba, byte, Data::Null);
        },
        ENUM,
        "target = GL_TEXTURE_BUFFER",
    ),
    (
        |c| c.get_tex_image(T, 0, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut [0; 256])),
        ENUM,
        "target = GL_TEXTURE_BUFFER",
    ),
    (|c| c.tex_storage_1d(T, 1, GL_R8, 4), ENUM, "target = GL_TEXTURE_BUFFER"),
    (|c| c.get_tex_level_parameteriv(T, 1, GL_TEXTURE_WIDTH, &mut [0]), VALUE, "level = 1"),
    (|c| c.bind_texture(GL_TEXTURE_1D, 1), OPERATION, "was first bound to GL_TEXTURE_BUFFER"),
];

/// Runs the rows.
pub fn run() {
    super::table(
        "buffer textures",
        context,
        ROWS.iter().map(|(call, flag, words)| (call, *flag, *words)),
    );
    mapped();
}

/// A draw that fetches from a buffer that the client has.
fn mapped() {
    let mut c = context();
    let fragment = "#version 130\n#extension GL_EXT_gpu_shader4 : require\n\
        uniform samplerBuffer s; void main() { gl_FragColor = texelFetchBuffer(s, 0); }";
    let program = c.create_program();
    let shader = c.create_shader(GL_FRAGMENT_SHADER);
    c.shader_source(shader, 1, Strings(vec![fragment]), &[]);
    c.compile_shader(shader);
    c.attach_shader(program, shader);
    c.link_program(program);
    c.use_program(program);
    c.map_buffer(T, GL_READ_ONLY);
    let draw = |c: &mut Context| c.draw_arrays(GL_TRIANGLES, 0, 3);
    super::row(&mut c, "mapped".into(), &draw, OPERATION, "buffer 1 of texture 1 is mapped");
}
