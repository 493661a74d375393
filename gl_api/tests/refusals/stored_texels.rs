//! What calls on stored texels and on buffers refuse: `ARB_copy_image`, `ARB_clear_texture`, `ARB_clear_buffer_object`, `ARB_invalidate_subdata`,
//! `ARB_draw_indirect`, `ARB_vertex_attrib_binding`, `ARB_buffer_storage`, `ARB_transform_feedback3`.

use gl_api::*;

/// The preparation, the call, the flag that it must set, and words of its message.
type Row = (fn(&mut Context), fn(&mut Context), GLenum, &'static str);

/// Most rows need nothing more.
fn nothing(_: &mut Context) {}

const ENUM: GLenum = GL_INVALID_ENUM;
const VALUE: GLenum = GL_INVALID_VALUE;
const OPERATION: GLenum = GL_INVALID_OPERATION;
const D2: GLenum = GL_TEXTURE_2D;

/// Texture 1 has 8×8 texels, texture 2 the same in blocks, texture 3 none, texture 4 those of a buffer; buffer 1 has 32
/// bytes.
fn prepared() -> Context {
    let mut c = super::context();
    for (name, internal) in [(1, GL_RGBA8), (2, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT)] {
        c.bind_texture(D2, name);
        c.tex_storage_2d(D2, 1, internal, 8, 8);
    }
    c.bind_texture(D2, 3);
    c.bind_texture(GL_TEXTURE_BUFFER, 4);
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    c.buffer_data(GL_ARRAY_BUFFER, 32, Data::Null, GL_STATIC_DRAW);
    c
}

/// A copy between places of 2D textures.
fn copy(c: &mut Context, from: (GLuint, [GLint; 3]), to: (GLuint, [GLint; 3]), size: [GLsizei; 3]) {
    let ((from, a), (to, b)) = (from, to);
    let [width, height, depth] = size;
    c.copy_image_sub_data(
        from, D2, 0, a[0], a[1], a[2], to, D2, 0, b[0], b[1], b[2], width, height, depth,
    );
}

/// A copy of no texels that names its targets and levels.
fn named(c: &mut Context, name: GLuint, target: GLenum, level: GLint) {
    c.copy_image_sub_data(name, target, level, 0, 0, 0, 1, D2, 0, 0, 0, 0, 0, 0, 0);
}

fn clear(c: &mut Context, name: GLuint, level: GLint, format: GLenum) {
    c.clear_tex_image(name, level, format, GL_UNSIGNED_BYTE, Data::Null);
}

fn clear_box(c: &mut Context, [x, y, z]: [GLint; 3], [width, height, depth]: [GLsizei; 3]) {
    let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
    c.clear_tex_sub_image(1, 0, x, y, z, width, height, depth, format, ty, Data::Null);
}

fn fill(c: &mut Context, internal: GLenum, offset: GLintptr, size: GLsizeiptr, format: GLenum) {
    let (target, ty) = (GL_ARRAY_BUFFER, GL_UNSIGNED_BYTE);
    c.clear_buffer_sub_data(target, internal, offset, size, format, ty, Data::Null);
}

/// Binds 32 bytes of arguments, and indices.
fn with_arguments(c: &mut Context) {
    c.bind_buffer(GL_DRAW_INDIRECT_BUFFER, 1);
    c.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, 1);
}

fn mapped_arguments(c: &mut Context) {
    with_arguments(c);
    c.map_buffer(GL_DRAW_INDIRECT_BUFFER, GL_READ_ONLY);
}

fn mapped(c: &mut Context) {
    c.map_buffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
}

const ROWS: &[Row] = &[
    (nothing, |c| named(c, 1, GL_TEXTURE_BUFFER, 0), ENUM, "other than GL_TEXTURE_BUFFER"),
    (nothing, |c| named(c, 1, GL_TEXTURE_3D, 0), ENUM, "srcTarget = GL_TEXTURE_3D"),
    (nothing, |c| named(c, 9, D2, 0), VALUE, "srcName = 9"),
    (nothing, |c| named(c, 9, GL_RENDERBUFFER, 0), VALUE, "srcName = 9"),
    (nothing, |c| named(c, 3, D2, 0), OPERATION, "srcName = 3 has no image"),
    (nothing, |c| named(c, 1, D2, 5), VALUE, "srcLevel = 5"),
    (nothing, |c| named(c, 1, D2, -1), VALUE, "srcLevel = -1"),
    (nothing, |c| copy(c, (1, [0; 3]), (1, [0; 3]), [1, -1, 1]), VALUE, "srcHeight = -1"),
    (
        nothing,
        |c| copy(c, (1, [5, 0, 0]), (1, [0; 3]), [4, 1, 1]),
        VALUE,
        "ends at 9, the level has 8",
    ),
    (nothing, |c| copy(c, (1, [0; 3]), (1, [0, 5, 0]), [4, 4, 1]), VALUE, "dstY = 5"),
    (nothing, |c| copy(c, (1, [0; 3]), (1, [0, 0, -1]), [4, 4, 1]), VALUE, "dstZ = -1"),
    (nothing, |c| copy(c, (2, [1, 0, 0]), (2, [0; 3]), [4, 4, 1]), VALUE, "cut blocks of 4"),
    (nothing, |c| copy(c, (2, [0; 3]), (2, [0; 3]), [3, 4, 1]), VALUE, "cut blocks of 4"),
    (nothing, |c| copy(c, (2, [0; 3]), (1, [0; 3]), [4, 4, 1]), OPERATION, "are none of"),
    (nothing, |c| clear(c, 0, 0, GL_RGBA), OPERATION, "texture = 0"),
    (nothing, |c| clear(c, 9, 0, GL_RGBA), OPERATION, "texture = 9"),
    (nothing, |c| clear(c, 4, 0, GL_RGBA), OPERATION, "glClearBufferData"),
    (nothing, |c| clear(c, 1, 1, GL_RGBA), OPERATION, "level = 1"),
    (nothing, |c| clear(c, 2, 0, GL_RGBA), OPERATION, "compressed"),
    (
        nothing,
        |c| clear(c, 1, 0, GL_DEPTH_COMPONENT),
        OPERATION,
        "go together, and not with colours",
    ),
    (nothing, |c| clear(c, 1, 0, GL_RGBA_INTEGER), OPERATION, "formats of integers"),
    (nothing, |c| clear(c, 1, 0, GL_LINEAR), ENUM, "format"),
    (
        nothing,
        |c| c.clear_tex_image(1, 0, GL_RGBA, GL_UNSIGNED_BYTE, Data::Bytes(&[0; 3])),
        OPERATION,
        "a pixel has 4 bytes, data 3",
    ),
    (nothing, |c| clear_box(c, [-1, 0, 0], [1; 3]), OPERATION, "along x from -1"),
    (nothing, |c| clear_box(c, [0, 5, 0], [1, 4, 1]), OPERATION, "4 texels along y from 5"),
    (nothing, |c| clear_box(c, [0; 3], [1, 1, -1]), OPERATION, "-1 texels along z"),
    (nothing, |c| c.invalidate_tex_image(0, 0), VALUE, "texture = 0"),
    (nothing, |c| c.invalidate_tex_image(9, 0), VALUE, "texture = 9"),
    (nothing, |c| c.invalidate_tex_image(1, -1), VALUE, "level = -1"),
    (nothing, |c| c.invalidate_tex_image(4, 1), VALUE, "must be 0"),
    (nothing, |c| c.invalidate_tex_sub_image(9, 0, 0, 0, 0, 1, 1, 1), VALUE, "texture = 9"),
    (nothing, |c| c.invalidate_tex_sub_image(1, 40, 0, 0, 0, 1, 1, 1), VALUE, "level = 40"),
    (nothing, |c| c.invalidate_tex_sub_image(1, 0, -1, 0, 0, 1, 1, 1), VALUE, "along x from -1"),
    (nothing, |c| c.invalidate_tex_sub_image(1, 0, 0, 5, 0, 1, 4, 1), VALUE, "4 texels along y"),
    (nothing, |c| c.invalidate_tex_sub_image(1, 0, 0, 0, 0, 1, 1, -1), VALUE, "-1 texels along z"),
    (nothing, |c| c.invalidate_tex_sub_image(1, 1, 0, 0, 0, 1, 1, 1), VALUE, "outside 0 to 0"),
    (nothing, |c| c.invalidate_buffer_data(9), VALUE, "buffer = 9"),
    (mapped, |c| c.invalidate_buffer_data(1), OPERATION, "are mapped"),
    (nothing, |c| c.invalidate_buffer_sub_data(9, 0, 1), VALUE, "buffer = 9"),
    (nothing, |c| c.invalidate_buffer_sub_data(1, 0, 33), VALUE, "past the buffer's 32 bytes"),
    (nothing, |c| c.invalidate_buffer_sub_data(1, -1, 1), VALUE, "offset = -1"),
    (mapped, |c| c.invalidate_buffer_sub_data(1, 8, 8), OPERATION, "are mapped"),
    (nothing, |c| fill(c, GL_RGBA, 0, 4, GL_RGBA), ENUM, "internalformat = GL_RGBA"),
    (nothing, |c| fill(c, GL_RGBA8, 2, 4, GL_RGBA), VALUE, "multiples of the texel's 4 bytes"),
    (nothing, |c| fill(c, GL_RGBA8, 0, 36, GL_RGBA), VALUE, "reach past the buffer's 32 bytes"),
    (nothing, |c| fill(c, GL_RGBA8, 0, 4, GL_RGBA_INTEGER), OPERATION, "formats of integers"),
    (
        nothing,
        |c| {
            let target = GL_UNIFORM_BUFFER;
            c.clear_buffer_data(target, GL_R8, GL_RED, GL_UNSIGNED_BYTE, Data::Null);
        },
        VALUE,
        "no buffer is bound to GL_UNIFORM_BUFFER",
    ),
    (
        mapped,
        |c| {
            c.clear_buffer_data(GL_ARRAY_BUFFER, GL_R8, GL_RED, GL_UNSIGNED_BYTE, Data::Null);
        },
        OPERATION,
        "are mapped",
    ),
    (
        nothing,
        |c| {
            let data = Data::Null;
            c.clear_buffer_data(GL_TEXTURE_2D, GL_R8, GL_RED, GL_UNSIGNED_BYTE, data);
        },
        ENUM,
        "target",
    ),
    (
        nothing,
        |c| c.draw_arrays_indirect(GL_TRIANGLES, Data::Offset(0)),
        OPERATION,
        "GL_DRAW_INDIRECT_BUFFER",
    ),
    (nothing, |c| c.draw_arrays_indirect(GL_FLOAT, Data::Offset(0)), ENUM, "mode"),
    (
        nothing,
        |c| c.draw_elements_indirect(GL_TRIANGLES, GL_UNSIGNED_BYTE, Data::Offset(0)),
        OPERATION,
        "GL_ELEMENT_ARRAY_BUFFER",
    ),
    (
        nothing,
        |c| c.draw_elements_indirect(GL_TRIANGLES, GL_FLOAT, Data::Offset(0)),
        ENUM,
        "type = GL_FLOAT",
    ),
    (
        with_arguments,
        |c| {
            c.draw_arrays_indirect(GL_TRIANGLES, Data::Offset(2));
        },
        VALUE,
        "multiple of 4",
    ),
    (
        with_arguments,
        |c| {
            c.draw_elements_indirect(GL_TRIANGLES, GL_UNSIGNED_BYTE, Data::Offset(16));
        },
        OPERATION,
        "take 20 bytes, which are not there",
    ),
    (
        with_arguments,
        |c| {
            c.multi_draw_arrays_indirect(GL_TRIANGLES, Data::Offset(0), 2, 6);
        },
        VALUE,
        "stride = 6",
    ),
    (
        with_arguments,
        |c| {
            c.multi_draw_arrays_indirect(GL_TRIANGLES, Data::Offset(0), -1, 0);
        },
        VALUE,
        "drawcount = -1",
    ),
    (
        with_arguments,
        |c| {
            let (ty, indirect) = (GL_UNSIGNED_BYTE, Data::Offset(0));
            c.multi_draw_elements_indirect(GL_TRIANGLES, ty, indirect, 2, 0);
        },
        OPERATION,
        "take 40 bytes",
    ),
    (
        mapped_arguments,
        |c| {
            c.draw_arrays_indirect(GL_TRIANGLES, Data::Offset(0));
        },
        OPERATION,
        "mapped",
    ),
    (
        nothing,
        |c| c.draw_arrays_instanced_base_instance(GL_TRIANGLES, 0, 3, -1, 0),
        VALUE,
        "primcount = -1",
    ),
    (
        nothing,
        |c| {
            let (ty, indices) = (GL_UNSIGNED_BYTE, Data::Bytes(&[0; 3]));
            c.draw_elements_instanced_base_instance(GL_TRIANGLES, -3, ty, indices, 1, 0);
        },
        VALUE,
        "count = -3",
    ),
    (
        nothing,
        |c| {
            let (ty, indices) = (GL_FLOAT, Data::Bytes(&[0; 3]));
            let mode = GL_TRIANGLES;
            c.draw_elements_instanced_base_vertex_base_instance(mode, 3, ty, indices, 1, 0, 0);
        },
        ENUM,
        "type = GL_FLOAT",
    ),
    (nothing, |c| c.vertex_attrib_format(16, 4, GL_FLOAT, false, 0), VALUE, "index = 16"),
    (nothing, |c| c.vertex_attrib_format(0, 5, GL_FLOAT, false, 0), VALUE, "size = 5"),
    (
        nothing,
        |c| c.vertex_attrib_format(0, 4, GL_FLOAT, false, 2048),
        VALUE,
        "relativeoffset = 2048",
    ),
    (nothing, |c| c.vertex_attrib_i_format(0, 4, GL_FLOAT, 0), ENUM, "type = GL_FLOAT"),
    (nothing, |c| c.vertex_attrib_l_format(0, 4, GL_FLOAT, 0), ENUM, "type = GL_FLOAT"),
    (nothing, |c| c.vertex_attrib_binding(0, 16), VALUE, "bindingindex = 16"),
    (nothing, |c| c.bind_vertex_buffer(16, 1, 0, 4), VALUE, "bindingindex = 16"),
    (nothing, |c| c.bind_vertex_buffer(0, 1, -1, 4), VALUE, "offset = -1"),
    (nothing, |c| c.bind_vertex_buffer(0, 1, 0, -4), VALUE, "stride = -4"),
    (nothing, |c| c.bind_vertex_buffer(0, 99, 0, 4), OPERATION, "buffer = 99"),
    (nothing, |c| c.vertex_binding_divisor(16, 1), VALUE, "bindingindex = 16"),
    (
        nothing,
        |c| c.buffer_storage(GL_UNIFORM_BUFFER, 4, Data::Null, 0),
        OPERATION,
        "no buffer is bound",
    ),
    (nothing, |c| c.buffer_storage(GL_ARRAY_BUFFER, 0, Data::Null, 0), VALUE, "size = 0"),
    (
        nothing,
        |c| c.buffer_storage(GL_ARRAY_BUFFER, 4, Data::Null, 1 << 30),
        VALUE,
        "none of glBufferStorage's",
    ),
    (
        nothing,
        |c| c.buffer_storage(GL_ARRAY_BUFFER, 4, Data::Null, GL_MAP_PERSISTENT_BIT),
        VALUE,
        "needs GL_MAP_READ_BIT or GL_MAP_WRITE_BIT",
    ),
    (
        nothing,
        |c| {
            let flags = GL_MAP_READ_BIT | GL_MAP_COHERENT_BIT;
            c.buffer_storage(GL_ARRAY_BUFFER, 4, Data::Null, flags);
        },
        VALUE,
        "needs GL_MAP_PERSISTENT_BIT",
    ),
    (
        nothing,
        |c| {
            let access = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT;
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 4, access);
        },
        OPERATION,
        "which the flags of glBufferStorage lack",
    ),
    (
        nothing,
        |c| c.begin_query_indexed(GL_PRIMITIVES_GENERATED, 1, 1),
        VALUE,
        "index = 1 must be below GL_MAX_VERTEX_STREAMS",
    ),
    (nothing, |c| c.begin_query_indexed(GL_SAMPLES_PASSED, 1, 1), VALUE, "index = 1 must be 0"),
    (nothing, |c| c.end_query_indexed(GL_SAMPLES_PASSED, 1), VALUE, "index = 1 must be 0"),
    (
        nothing,
        |c| c.get_query_indexediv(GL_SAMPLES_PASSED, 1, GL_CURRENT_QUERY, &mut [0]),
        VALUE,
        "index = 1 must be 0",
    ),
    (
        nothing,
        |c| c.draw_transform_feedback_stream(GL_POINTS, 0, 1),
        VALUE,
        "stream = 1 must be below",
    ),
];

/// Runs the rows.
pub fn run() {
    for (number, &(prepare, call, flag, words)) in ROWS.iter().enumerate() {
        let mut c = prepared();
        prepare(&mut c);
        super::row(&mut c, format!("stored texels {number}"), &call, flag, words);
    }
}
