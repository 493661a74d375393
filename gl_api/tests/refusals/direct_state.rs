//! What the calls refuse that name their objects: `ARB_direct_state_access`. The rules that they share with calls on bound
//! objects are in the rows of those, and in `tests/direct_state`.

use gl_api::*;

/// A call, the error flag that it must set, and words that its message must have.
type Case = (fn(&mut Context), GLenum, &'static str);

const ENUM: GLenum = GL_INVALID_ENUM;
const VALUE: GLenum = GL_INVALID_VALUE;
const OPERATION: GLenum = GL_INVALID_OPERATION;

/// Texture 1 is two-dimensional, texture 2 a cube map, texture 3 has samples, texture 4 is a buffer's; buffer 1 has 8
/// bytes; framebuffer, renderbuffer, vertex array and transform feedback object 1; query 1.
fn prepared() -> Context {
    let mut c = super::context();
    let mut name = [0];
    let targets =
        [GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BUFFER];
    for target in targets {
        c.create_textures(target, 1, &mut name);
    }
    c.create_buffers(1, &mut name);
    c.named_buffer_data(1, 8, Data::Null, GL_STATIC_DRAW);
    c.create_framebuffers(1, &mut name);
    c.create_renderbuffers(1, &mut name);
    c.create_vertex_arrays(1, &mut name);
    c.create_transform_feedbacks(1, &mut name);
    c.create_queries(GL_SAMPLES_PASSED, 1, &mut name);
    assert_eq!((name, c.get_error()), ([1], GL_NO_ERROR));
    c
}

const TEXTURE: &str = "texture = 9 is no texture";
const BUFFER: &str = "buffer = 9 is no buffer";
const FRAMEBUFFER: &str = "framebuffer = 9 is no framebuffer object";
const RENDERBUFFER: &str = "renderbuffer = 9 is no renderbuffer";
const ARRAYS: &str = "vaobj = 9 is no vertex array object";
const FEEDBACK: &str = "xfb = 9 is no transform feedback object";
const BYTE: GLenum = GL_UNSIGNED_BYTE;
const MIN: GLenum = GL_TEXTURE_MIN_FILTER;
const COLOR: GLenum = GL_COLOR_ATTACHMENT0;

const TEXTURES: &[Case] = &[
    (|c| c.create_textures(GL_RENDERBUFFER, 1, &mut [0]), ENUM, "target = GL_RENDERBUFFER"),
    (|c| c.create_textures(GL_TEXTURE_2D, -1, &mut []), VALUE, "n = -1"),
    (|c| c.bind_texture_unit(0, 9), OPERATION, TEXTURE),
    (|c| c.bind_texture_unit(GL_TEXTURE0, 1), VALUE, "it is a number, not GL_TEXTURE0 + i"),
    (|c| c.texture_storage_1d(9, 1, GL_RGBA8, 4), OPERATION, TEXTURE),
    (
        |c| c.texture_storage_1d(1, 1, GL_RGBA8, 4),
        OPERATION,
        "texture 1 is a GL_TEXTURE_2D, which this call",
    ),
    (|c| c.texture_storage_2d(9, 1, GL_RGBA8, 4, 4), OPERATION, TEXTURE),
    (|c| c.texture_storage_2d(0, 1, GL_RGBA8, 4, 4), OPERATION, "texture = 0"),
    (|c| c.texture_storage_2d(3, 1, GL_RGBA8, 4, 4), OPERATION, "GL_TEXTURE_2D_MULTISAMPLE, which"),
    (|c| c.texture_storage_2d(1, 0, GL_RGBA8, 4, 4), VALUE, "levels = 0"),
    (|c| c.texture_storage_2d(1, 4, GL_RGBA8, 4, 4), OPERATION, "levels = 4"),
    (|c| c.texture_storage_2d(1, 1, GL_RGBA, 4, 4), ENUM, "must be sized"),
    (|c| c.texture_storage_3d(9, 1, GL_RGBA8, 4, 4, 4), OPERATION, TEXTURE),
    (
        |c| c.texture_storage_3d(2, 1, GL_RGBA8, 4, 4, 6),
        OPERATION,
        "texture 2 is a GL_TEXTURE_CUBE_MAP",
    ),
    (|c| c.texture_storage_2d_multisample(9, 4, GL_RGBA8, 4, 4, true), OPERATION, TEXTURE),
    (
        |c| c.texture_storage_2d_multisample(1, 4, GL_RGBA8, 4, 4, true),
        OPERATION,
        "texture 1 is a GL_TEXTURE_2D",
    ),
    (|c| c.texture_storage_3d_multisample(9, 4, GL_RGBA8, 4, 4, 1, true), OPERATION, TEXTURE),
    (|c| c.texture_sub_image_1d(9, 0, 0, 1, GL_RGBA, BYTE, Data::Null), OPERATION, TEXTURE),
    (|c| c.texture_sub_image_2d(9, 0, 0, 0, 1, 1, GL_RGBA, BYTE, Data::Null), OPERATION, TEXTURE),
    (
        |c| c.texture_sub_image_2d(2, 0, 0, 0, 1, 1, GL_RGBA, BYTE, Data::Null),
        OPERATION,
        "its faces as layers",
    ),
    (
        |c| c.texture_sub_image_2d(1, 0, 0, 0, 1, 1, GL_RGBA, BYTE, Data::Null),
        OPERATION,
        "no image yet",
    ),
    (
        |c| c.texture_sub_image_3d(9, 0, 0, 0, 0, 1, 1, 1, GL_RGBA, BYTE, Data::Null),
        OPERATION,
        TEXTURE,
    ),
    (
        |c| c.texture_sub_image_3d(1, 0, 0, 0, 0, 1, 1, 1, GL_RGBA, BYTE, Data::Null),
        OPERATION,
        "texture 1 is a GL_TEXTURE_2D",
    ),
    (
        |c| c.texture_sub_image_3d(2, 0, 0, 0, 5, 1, 1, 2, GL_RGBA, BYTE, Data::Null),
        VALUE,
        "reach outside 0 to 6, the faces",
    ),
    (
        |c| c.compressed_texture_sub_image_1d(9, 0, 0, 4, GL_RGBA8, 8, Data::Null),
        OPERATION,
        TEXTURE,
    ),
    (
        |c| c.compressed_texture_sub_image_2d(9, 0, 0, 0, 4, 4, GL_RGBA8, 8, Data::Null),
        OPERATION,
        TEXTURE,
    ),
    (
        |c| c.compressed_texture_sub_image_3d(9, 0, 0, 0, 0, 4, 4, 1, GL_RGBA8, 8, Data::Null),
        OPERATION,
        TEXTURE,
    ),
    (|c| c.copy_texture_sub_image_1d(9, 0, 0, 0, 0, 1), OPERATION, TEXTURE),
    (|c| c.copy_texture_sub_image_2d(9, 0, 0, 0, 0, 0, 1, 1), OPERATION, TEXTURE),
    (|c| c.copy_texture_sub_image_3d(9, 0, 0, 0, 0, 0, 0, 1, 1), OPERATION, TEXTURE),
    (|c| c.texture_buffer(9, GL_RGBA8, 1), OPERATION, TEXTURE),
    (|c| c.texture_buffer(1, GL_RGBA8, 1), OPERATION, "texture 1 is a GL_TEXTURE_2D"),
    (|c| c.texture_buffer(4, GL_RGBA8, 9), OPERATION, "buffer = 9 is no buffer object"),
    (|c| c.texture_buffer_range(9, GL_RGBA8, 1, 0, 4), OPERATION, TEXTURE),
    (|c| c.texture_buffer_range(4, GL_RGBA8, 1, 0, 40), VALUE, "size = 40"),
    (|c| c.generate_texture_mipmap(9), OPERATION, TEXTURE),
    (|c| c.generate_texture_mipmap(3), OPERATION, "which has no mipmaps"),
    (
        |c| c.get_texture_image(9, 0, GL_RGBA, BYTE, 4, DataOut::Bytes(&mut [0; 4])),
        OPERATION,
        TEXTURE,
    ),
    (
        |c| c.get_texture_image(3, 0, GL_RGBA, BYTE, 4, DataOut::Bytes(&mut [0; 4])),
        OPERATION,
        "no texels to read",
    ),
    (
        |c| c.get_texture_image(2, 0, GL_RGBA, BYTE, 4, DataOut::Bytes(&mut [0; 4])),
        OPERATION,
        "faces",
    ),
    (|c| c.get_compressed_texture_image(9, 0, 4, DataOut::Bytes(&mut [0; 4])), OPERATION, TEXTURE),
    (|c| c.get_texture_level_parameteriv(9, 0, GL_TEXTURE_WIDTH, &mut [0]), OPERATION, TEXTURE),
    (|c| c.get_texture_level_parameterfv(9, 0, GL_TEXTURE_WIDTH, &mut [0.0]), OPERATION, TEXTURE),
    (|c| c.texture_parameteri(9, MIN, 0), OPERATION, TEXTURE),
    (|c| c.texture_parameteri(4, MIN, 0), OPERATION, "has no parameters"),
    (
        |c| c.texture_parameteri(3, MIN, GL_NEAREST as i32),
        OPERATION,
        "pname = GL_TEXTURE_MIN_FILTER",
    ),
    (|c| c.texture_parameteri(1, GL_TEXTURE_TARGET, 0), ENUM, "can only be read"),
    (|c| c.texture_parameterf(9, MIN, 0.0), OPERATION, TEXTURE),
    (|c| c.texture_parameteriv(9, MIN, &[0]), OPERATION, TEXTURE),
    (|c| c.texture_parameterfv(9, MIN, &[0.0]), OPERATION, TEXTURE),
    (|c| c.texture_parameter_i_iv(9, MIN, &[0]), OPERATION, TEXTURE),
    (|c| c.texture_parameter_i_uiv(9, MIN, &[0]), OPERATION, TEXTURE),
    (|c| c.get_texture_parameteriv(9, MIN, &mut [0]), OPERATION, TEXTURE),
    (|c| c.get_texture_parameteriv(4, MIN, &mut [0]), OPERATION, "has no parameters"),
    (|c| c.get_texture_parameterfv(9, MIN, &mut [0.0]), OPERATION, TEXTURE),
    (|c| c.get_texture_parameter_i_iv(9, MIN, &mut [0]), OPERATION, TEXTURE),
    (|c| c.get_texture_parameter_i_uiv(9, MIN, &mut [0]), OPERATION, TEXTURE),
    (|c| c.create_samplers(-1, &mut []), VALUE, "n = -1"),
];

const BUFFERS: &[Case] = &[
    (|c| c.create_buffers(-1, &mut []), VALUE, "n = -1"),
    (|c| c.named_buffer_storage(9, 4, Data::Null, 0), OPERATION, BUFFER),
    (|c| c.named_buffer_data(9, 4, Data::Null, GL_STATIC_DRAW), OPERATION, BUFFER),
    (|c| c.named_buffer_data(1, -1, Data::Null, GL_STATIC_DRAW), VALUE, "size = -1"),
    (|c| c.named_buffer_sub_data(9, 0, 4, Data::Null), OPERATION, BUFFER),
    (|c| c.copy_named_buffer_sub_data(9, 1, 0, 0, 4), OPERATION, "readBuffer = 9"),
    (|c| c.copy_named_buffer_sub_data(1, 9, 0, 0, 4), OPERATION, "writeBuffer = 9"),
    (|c| c.copy_named_buffer_sub_data(1, 1, 0, 2, 4), VALUE, "must not overlap"),
    (|c| c.clear_named_buffer_data(9, GL_R8, GL_RED, BYTE, Data::Null), OPERATION, BUFFER),
    (
        |c| c.clear_named_buffer_sub_data(9, GL_R8, 0, 4, GL_RED, BYTE, Data::Null),
        OPERATION,
        BUFFER,
    ),
    (|c| assert!(c.map_named_buffer(9, GL_READ_ONLY).is_null()), OPERATION, BUFFER),
    (|c| assert!(c.map_named_buffer_range(9, 0, 4, GL_MAP_READ_BIT).is_null()), OPERATION, BUFFER),
    (|c| assert!(!c.unmap_named_buffer(9)), OPERATION, BUFFER),
    (|c| assert!(!c.unmap_named_buffer(1)), OPERATION, "not mapped"),
    (|c| c.flush_mapped_named_buffer_range(9, 0, 4), OPERATION, BUFFER),
    (|c| c.get_named_buffer_parameteriv(9, GL_BUFFER_SIZE, &mut [0]), OPERATION, BUFFER),
    (|c| c.get_named_buffer_parameteri64v(9, GL_BUFFER_SIZE, &mut [0]), OPERATION, BUFFER),
    (
        |c| c.get_named_buffer_pointerv(9, GL_BUFFER_MAP_POINTER, &mut [std::ptr::null_mut()]),
        OPERATION,
        BUFFER,
    ),
    (|c| c.get_named_buffer_sub_data(9, 0, 4, DataOut::Bytes(&mut [0; 4])), OPERATION, BUFFER),
];

const FRAMEBUFFERS: &[Case] = &[
    (|c| c.create_framebuffers(-1, &mut []), VALUE, "n = -1"),
    (|c| c.create_renderbuffers(-1, &mut []), VALUE, "n = -1"),
    (|c| c.named_framebuffer_renderbuffer(9, COLOR, GL_RENDERBUFFER, 1), OPERATION, FRAMEBUFFER),
    (
        |c| c.named_framebuffer_renderbuffer(0, COLOR, GL_RENDERBUFFER, 1),
        OPERATION,
        "framebuffer = 0",
    ),
    (|c| c.named_framebuffer_parameteri(9, GL_SAMPLES, 1), OPERATION, FRAMEBUFFER),
    (|c| c.named_framebuffer_parameteri(1, GL_SAMPLES, 1), ENUM, "pname = GL_SAMPLES"),
    (|c| c.named_framebuffer_texture(9, COLOR, 1, 0), OPERATION, FRAMEBUFFER),
    (|c| c.named_framebuffer_texture(1, COLOR, 9, 0), VALUE, "texture = 9"),
    (|c| c.named_framebuffer_texture_layer(9, COLOR, 1, 0, 0), OPERATION, FRAMEBUFFER),
    (|c| c.named_framebuffer_draw_buffer(9, COLOR), OPERATION, FRAMEBUFFER),
    (|c| c.named_framebuffer_draw_buffer(1, GL_BACK), OPERATION, "GL_BACK"),
    (|c| c.named_framebuffer_draw_buffers(9, 1, &[COLOR]), OPERATION, FRAMEBUFFER),
    (|c| c.named_framebuffer_read_buffer(9, COLOR), OPERATION, FRAMEBUFFER),
    (|c| c.invalidate_named_framebuffer_data(9, 0, &[]), OPERATION, FRAMEBUFFER),
    (|c| c.invalidate_named_framebuffer_data(0, 1, &[COLOR]), ENUM, "GL_COLOR_ATTACHMENT0"),
    (|c| c.invalidate_named_framebuffer_sub_data(9, 0, &[], 0, 0, 1, 1), OPERATION, FRAMEBUFFER),
    (|c| c.clear_named_framebufferiv(9, GL_STENCIL, 0, &[0]), OPERATION, FRAMEBUFFER),
    (|c| c.clear_named_framebufferuiv(9, GL_COLOR, 0, &[0; 4]), OPERATION, FRAMEBUFFER),
    (|c| c.clear_named_framebufferfv(9, GL_COLOR, 0, &[0.0; 4]), OPERATION, FRAMEBUFFER),
    (|c| c.clear_named_framebufferfi(9, GL_DEPTH_STENCIL, 0, 0.0, 0), OPERATION, FRAMEBUFFER),
    (
        |c| c.clear_named_framebufferfi(1, GL_DEPTH_STENCIL, 0, 0.0, 0),
        GL_INVALID_FRAMEBUFFER_OPERATION,
        "framebuffer 1 is incomplete",
    ),
    (
        |c| c.blit_named_framebuffer(9, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, GL_NEAREST),
        OPERATION,
        "readFramebuffer = 9",
    ),
    (
        |c| c.blit_named_framebuffer(0, 9, 0, 0, 1, 1, 0, 0, 1, 1, 0, GL_NEAREST),
        OPERATION,
        "drawFramebuffer = 9",
    ),
    (
        |c| assert_eq!(c.check_named_framebuffer_status(9, GL_FRAMEBUFFER), 0),
        OPERATION,
        FRAMEBUFFER,
    ),
    (
        |c| assert_eq!(c.check_named_framebuffer_status(1, COLOR), 0),
        ENUM,
        "target = GL_COLOR_ATTACHMENT0",
    ),
    (|c| c.get_named_framebuffer_parameteriv(9, GL_SAMPLES, &mut [0]), OPERATION, FRAMEBUFFER),
    (|c| c.get_named_framebuffer_parameteriv(1, GL_RGBA, &mut [0]), ENUM, "pname = GL_RGBA"),
    (
        |c| {
            c.get_named_framebuffer_attachment_parameteriv(
                9,
                COLOR,
                GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE,
                &mut [0],
            )
        },
        OPERATION,
        FRAMEBUFFER,
    ),
    (|c| c.named_renderbuffer_storage(9, GL_RGBA8, 4, 4), OPERATION, RENDERBUFFER),
    (|c| c.named_renderbuffer_storage_multisample(9, 4, GL_RGBA8, 4, 4), OPERATION, RENDERBUFFER),
    (
        |c| c.get_named_renderbuffer_parameteriv(9, GL_RENDERBUFFER_WIDTH, &mut [0]),
        OPERATION,
        RENDERBUFFER,
    ),
];

const OTHERS: &[Case] = &[
    (|c| c.create_vertex_arrays(-1, &mut []), VALUE, "n = -1"),
    (|c| c.enable_vertex_array_attrib(9, 0), OPERATION, ARRAYS),
    (|c| c.enable_vertex_array_attrib(1, 99), VALUE, "index = 99"),
    (|c| c.disable_vertex_array_attrib(9, 0), OPERATION, ARRAYS),
    (|c| c.vertex_array_element_buffer(9, 1), OPERATION, ARRAYS),
    (|c| c.vertex_array_element_buffer(1, 9), OPERATION, BUFFER),
    (|c| c.vertex_array_vertex_buffer(9, 0, 1, 0, 4), OPERATION, ARRAYS),
    (|c| c.vertex_array_vertex_buffer(1, 0, 1, -1, 4), VALUE, "offset = -1"),
    (|c| c.vertex_array_vertex_buffers(9, 0, 1, &[1], &[0], &[4]), OPERATION, ARRAYS),
    (|c| c.vertex_array_vertex_buffers(1, 0, -1, &[], &[], &[]), VALUE, "count = -1"),
    (|c| c.vertex_array_vertex_buffers(1, 15, 2, &[], &[], &[]), OPERATION, "reach past"),
    (|c| c.vertex_array_vertex_buffers(1, 0, 1, &[9], &[0], &[4]), OPERATION, "buffers = 9"),
    (|c| c.vertex_array_attrib_format(9, 0, 4, GL_FLOAT, false, 0), OPERATION, ARRAYS),
    (|c| c.vertex_array_attrib_i_format(9, 0, 4, GL_INT, 0), OPERATION, ARRAYS),
    (|c| c.vertex_array_attrib_l_format(9, 0, 4, GL_DOUBLE, 0), OPERATION, ARRAYS),
    (|c| c.vertex_array_attrib_binding(9, 0, 0), OPERATION, ARRAYS),
    (|c| c.vertex_array_binding_divisor(9, 0, 0), OPERATION, ARRAYS),
    (|c| c.get_vertex_arrayiv(9, GL_ELEMENT_ARRAY_BUFFER_BINDING, &mut [0]), OPERATION, ARRAYS),
    (
        |c| c.get_vertex_arrayiv(1, GL_ARRAY_BUFFER_BINDING, &mut [0]),
        ENUM,
        "pname = GL_ARRAY_BUFFER_BINDING",
    ),
    (
        |c| c.get_vertex_array_indexediv(9, 0, GL_VERTEX_ATTRIB_ARRAY_SIZE, &mut [0]),
        OPERATION,
        ARRAYS,
    ),
    (
        |c| c.get_vertex_array_indexediv(1, 0, GL_CURRENT_VERTEX_ATTRIB, &mut [0]),
        ENUM,
        "GL_CURRENT_VERTEX_ATTRIB",
    ),
    (
        |c| c.get_vertex_array_indexed64iv(9, 0, GL_VERTEX_BINDING_OFFSET, &mut [0]),
        OPERATION,
        ARRAYS,
    ),
    (
        |c| c.get_vertex_array_indexed64iv(1, 99, GL_VERTEX_BINDING_OFFSET, &mut [0]),
        VALUE,
        "bindingindex = 99",
    ),
    (|c| c.create_transform_feedbacks(-1, &mut []), VALUE, "n = -1"),
    (|c| c.transform_feedback_buffer_base(9, 0, 1), OPERATION, FEEDBACK),
    (|c| c.transform_feedback_buffer_base(1, 0, 9), VALUE, "buffer = 9"),
    (|c| c.transform_feedback_buffer_base(1, 99, 1), VALUE, "index = 99"),
    (|c| c.transform_feedback_buffer_range(9, 0, 1, 0, 4), OPERATION, FEEDBACK),
    (|c| c.transform_feedback_buffer_range(1, 0, 1, 2, 4), VALUE, "offset = 2"),
    (
        |c| c.get_transform_feedbackiv(9, GL_TRANSFORM_FEEDBACK_ACTIVE, &mut [0]),
        OPERATION,
        FEEDBACK,
    ),
    (|c| c.get_transform_feedbackiv(1, GL_RGBA, &mut [0]), ENUM, "pname = GL_RGBA"),
    (
        |c| c.get_transform_feedbacki_v(9, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, 0, &mut [0]),
        OPERATION,
        FEEDBACK,
    ),
    (
        |c| c.get_transform_feedbacki_v(1, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, 9, &mut [0]),
        VALUE,
        "index = 9",
    ),
    (
        |c| c.get_transform_feedbacki64_v(9, GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, 0, &mut [0]),
        OPERATION,
        FEEDBACK,
    ),
    (|c| c.create_program_pipelines(-1, &mut []), VALUE, "n = -1"),
    (|c| c.create_queries(GL_TEXTURE_2D, 1, &mut [0]), ENUM, "target = GL_TEXTURE_2D"),
    (|c| c.create_queries(GL_TIMESTAMP, -1, &mut []), VALUE, "n = -1"),
    (|c| c.get_query_buffer_objectiv(1, 9, GL_QUERY_RESULT, 0), OPERATION, BUFFER),
    (|c| c.get_query_buffer_objectuiv(9, 1, GL_QUERY_RESULT, 0), OPERATION, "id = 9"),
    (|c| c.get_query_buffer_objecti64v(1, 1, GL_QUERY_RESULT, 1), OPERATION, "8 bytes reach past"),
    (|c| c.get_query_buffer_objectui64v(1, 1, GL_QUERY_RESULT, -1), VALUE, "offset = -1"),
    (|c| c.get_query_buffer_objectiv(1, 1, GL_RGBA, 0), ENUM, "pname = GL_RGBA"),
];

/// Runs the rows.
pub fn run() {
    for cases in [TEXTURES, BUFFERS, FRAMEBUFFERS, OTHERS] {
        super::table(
            "direct state access",
            prepared,
            cases.iter().map(|(call, flag, words)| (call, *flag, *words)),
        );
    }
}
