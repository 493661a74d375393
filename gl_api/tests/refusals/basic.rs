//! What the calls of the first chapters refuse. A 2×2 RGBA texture is bound to `GL_TEXTURE_2D`.

use super::Case;
use gl_api::*;

fn image(context: &mut Context, width: i32, height: i32, bytes: &[u8]) {
    context.tex_image_2d(
        GL_TEXTURE_2D,
        0,
        GL_RGB as i32,
        width,
        height,
        0,
        GL_RGB,
        GL_UNSIGNED_BYTE,
        Data::Bytes(bytes),
    );
}

fn typed(context: &mut Context, internal: GLenum, format: GLenum, ty: GLenum) {
    let pixels = Data::Bytes(&[0; 256]);
    context.tex_image_2d(GL_TEXTURE_2D, 0, internal as i32, 2, 2, 0, format, ty, pixels);
}

fn sub_image(context: &mut Context, level: i32, area: [i32; 4], bytes: &[u8]) {
    let [x, y, width, height] = area;
    let pixels = Data::Bytes(bytes);
    let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
    context.tex_sub_image_2d(GL_TEXTURE_2D, level, x, y, width, height, format, ty, pixels);
}

const CASES: &[Case] = &[
    // Textures.
    (|c| c.bind_texture(GL_TEXTURE0, 1), GL_INVALID_ENUM, "GL_TEXTURE0 must be GL_TEXTURE_1D"),
    (|c| c.bind_texture(GL_TEXTURE_CUBE_MAP, 1), GL_INVALID_OPERATION, "first bound to"),
    (|c| c.gen_textures(-1, &mut []), GL_INVALID_VALUE, "n = -1 must not be negative"),
    (|c| c.gen_textures(3, &mut [0]), GL_INVALID_OPERATION, "has 1"),
    (|c| c.delete_textures(-2, &[]), GL_INVALID_VALUE, "n = -2"),
    (|c| c.delete_textures(2, &[1]), GL_INVALID_OPERATION, "has 1"),
    (
        |c| c.active_texture(GL_TEXTURE0 + 48),
        GL_INVALID_ENUM,
        "texture = GL_TEXTURE0 + 48 must be below GL_TEXTURE0 + 48",
    ),
    (
        |c| c.active_texture(GL_FLOAT),
        GL_INVALID_ENUM,
        "GL_FLOAT must be GL_TEXTURE0 to GL_TEXTURE47",
    ),
    (|c| c.active_texture(1), GL_INVALID_ENUM, "texture = 1 must be a name: GL_TEXTURE0 + 1"),
    (|c| c.client_active_texture(GL_TEXTURE31), GL_INVALID_ENUM, "GL_TEXTURE0 + 31 must be below"),
    (|c| image(c, -1, 1, &[]), GL_INVALID_VALUE, "width = -1 must not be negative"),
    (|c| image(c, 1, -1, &[]), GL_INVALID_VALUE, "height = -1 must not be negative"),
    (|c| image(c, 8193, 1, &[]), GL_INVALID_VALUE, "must not be above 8192"),
    (|c| image(c, i32::MAX, i32::MAX, &[]), GL_INVALID_VALUE, "must not be above"),
    (|c| image(c, 8192, 8192, &[0; 9]), GL_INVALID_OPERATION, "201326592 bytes; the memory has 9"),
    (|c| image(c, 5, 5, &[0; 75]), GL_INVALID_OPERATION, "glPixelStorei(GL_UNPACK_ALIGNMENT, 1)"),
    (|c| image(c, 4, 4, &[0; 47]), GL_INVALID_OPERATION, "take 48 bytes; the memory has 47"),
    (
        |c| typed(c, GL_BGRA, GL_RGBA, GL_FLOAT),
        GL_INVALID_VALUE,
        "GL_BGRA must be one of 169 values; near in name: GL_",
    ),
    (|c| typed(c, 5, GL_RGBA, GL_FLOAT), GL_INVALID_VALUE, "internalformat = 5 must be 1 to 4, or"),
    (|c| typed(c, GL_RGBA, GL_COLOR, GL_FLOAT), GL_INVALID_ENUM, "format = GL_COLOR"),
    (|c| typed(c, GL_RGBA, GL_RGBA, GL_BITMAP), GL_INVALID_ENUM, "bits are GL_COLOR_INDEX"),
    (|c| typed(c, GL_RGBA, GL_DEPTH_COMPONENT, GL_FLOAT), GL_INVALID_OPERATION, "go together"),
    (|c| typed(c, GL_DEPTH_COMPONENT, GL_RGBA, GL_FLOAT), GL_INVALID_OPERATION, "go together"),
    (
        |c| c.tex_image_2d(GL_TEXTURE_2D, 14, 3, 1, 1, 0, GL_RGB, GL_FLOAT, Data::Null),
        GL_INVALID_VALUE,
        "level = 14 must be 0 to 13",
    ),
    (
        |c| c.tex_image_2d(GL_TEXTURE_2D, -1, 3, 1, 1, 0, GL_RGB, GL_FLOAT, Data::Null),
        GL_INVALID_VALUE,
        "level = -1",
    ),
    (
        |c| c.tex_image_2d(GL_TEXTURE_2D, 0, 3, 3, 3, 2, GL_RGB, GL_FLOAT, Data::Null),
        GL_INVALID_VALUE,
        "border = 2 must be 0 or 1",
    ),
    (
        |c| c.tex_image_2d(GL_TEXTURE_CUBE_MAP, 0, 3, 1, 1, 0, GL_RGB, GL_FLOAT, Data::Null),
        GL_INVALID_ENUM,
        "GL_TEXTURE_CUBE_MAP_POSITIVE_X",
    ),
    (
        |c| {
            let target = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
            c.tex_image_2d(target, 0, 3, 2, 1, 0, GL_RGB, GL_FLOAT, Data::Null);
        },
        GL_INVALID_VALUE,
        "must be equal",
    ),
    (
        |c| c.tex_image_2d(GL_TEXTURE_2D, 0, 3, 1, 1, 0, GL_RGB, GL_FLOAT, Data::Offset(64)),
        GL_INVALID_OPERATION,
        "no buffer is bound to GL_PIXEL_UNPACK_BUFFER",
    ),
    (|c| sub_image(c, 3, [0, 0, 1, 1], &[0; 4]), GL_INVALID_OPERATION, "call glTexImage2D first"),
    (|c| sub_image(c, 0, [1, 0, 2, 1], &[0; 8]), GL_INVALID_VALUE, "reach outside 0 to 2"),
    (|c| sub_image(c, 0, [-1, 0, 1, 1], &[0; 8]), GL_INVALID_VALUE, "xoffset = -1"),
    (|c| sub_image(c, 0, [0, i32::MAX, 1, 1], &[0; 8]), GL_INVALID_VALUE, "yoffset"),
    (|c| sub_image(c, 0, [0, 0, 2, 2], &[0; 15]), GL_INVALID_OPERATION, "take 16 bytes"),
    (
        |c| c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_REPEAT as i32),
        GL_INVALID_ENUM,
        "param = GL_REPEAT must be GL_NEAREST",
    ),
    (
        |c| c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR as i32),
        GL_INVALID_ENUM,
        "must be GL_NEAREST or GL_LINEAR",
    ),
    (
        |c| c.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, f32::NAN),
        GL_INVALID_ENUM,
        "must be GL_REPEAT",
    ),
    (
        |c| c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, -1),
        GL_INVALID_ENUM,
        "GL_COMPARE_R_TO_TEXTURE",
    ),
    (|c| c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, 1), GL_INVALID_ENUM, "pname"),
    (
        |c| c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, -1),
        GL_INVALID_VALUE,
        "GL_TEXTURE_MAX_LEVEL = -1 must not be negative",
    ),
    (
        |c| c.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1.0),
        GL_INVALID_ENUM,
        "use glTexParameterfv",
    ),
    (
        |c| c.tex_parameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[1.0; 3]),
        GL_INVALID_OPERATION,
        "3 of 4 values",
    ),
    (
        |c| c.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_LINEAR as i32),
        GL_INVALID_ENUM,
        "param = GL_LINEAR must be GL_REPLACE",
    ),
    (|c| c.tex_envi(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, 0), GL_INVALID_ENUM, "target"),
    (|c| c.tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &[]), GL_INVALID_OPERATION, "0 of 4"),
    (
        |c| c.copy_tex_image_2d(GL_TEXTURE_2D, 0, 3, 0, 0, 1, 1, 0),
        GL_INVALID_ENUM,
        "internalformat = 3",
    ),
    (|c| c.generate_mipmap(GL_TEXTURE_CUBE_MAP), GL_INVALID_OPERATION, "no image at level 0"),
    // Pixels.
    (|c| c.pixel_storei(GL_UNPACK_ALIGNMENT, 3), GL_INVALID_VALUE, "must be 1, 2, 4 or 8"),
    (|c| c.pixel_storei(GL_UNPACK_ROW_LENGTH, -1), GL_INVALID_VALUE, "must not be negative"),
    (|c| c.pixel_storei(GL_TEXTURE_2D, 1), GL_INVALID_ENUM, "GL_UNPACK_ALIGNMENT"),
    (
        |c| {
            let out = DataOut::Bytes(&mut [0; 7]);
            c.read_pixels(0, 0, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, out);
        },
        GL_INVALID_OPERATION,
        "take 8 bytes; the memory has 7",
    ),
    (
        |c| c.read_pixels(0, 0, 2, -1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Null),
        GL_INVALID_VALUE,
        "height = -1",
    ),
    (
        |c| c.read_pixels(0, 0, 2, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, DataOut::Null),
        GL_INVALID_OPERATION,
        "format = GL_COLOR_INDEX",
    ),
    (
        |c| {
            let out = DataOut::Bytes(&mut [0; 8]);
            c.readn_pixels(0, 0, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, 7, out);
        },
        GL_INVALID_OPERATION,
        "bufSize = 7, but 8 bytes are needed",
    ),
    (
        |c| c.readn_pixels(0, 0, -2, 1, GL_RGBA, GL_UNSIGNED_BYTE, 8, DataOut::Null),
        GL_INVALID_VALUE,
        "width = -2",
    ),
    // Transformation.
    (|c| c.matrix_mode(GL_FRONT), GL_INVALID_ENUM, "GL_MODELVIEW"),
    (|c| c.pop_matrix(), GL_STACK_UNDERFLOW, "cannot be popped"),
    (
        |c| {
            c.matrix_mode(GL_TEXTURE);
            for _ in 0..10 {
                c.push_matrix();
            }
            for _ in 0..9 {
                c.pop_matrix();
            }
            c.matrix_mode(GL_MODELVIEW);
        },
        GL_STACK_OVERFLOW,
        "holds 10 matrices",
    ),
    (|c| c.frustum(0.0, 1.0, 0.0, 1.0, 0.0, 1.0), GL_INVALID_VALUE, "must be positive"),
    (|c| c.frustum(1.0, 1.0, 0.0, 1.0, 1.0, 2.0), GL_INVALID_VALUE, "left and right must differ"),
    (|c| c.ortho(0.0, 1.0, 2.0, 2.0, 1.0, 2.0), GL_INVALID_VALUE, "bottom and top must differ"),
    (|c| c.load_matrixf(&[0.0; 15]), GL_INVALID_OPERATION, "15 of the 16"),
    (|c| c.viewport(0, 0, -1, 0), GL_INVALID_VALUE, "width = -1"),
    // Rasterization and fragments.
    (|c| c.enable(GL_TEXTURE_2D_ARRAY), GL_INVALID_ENUM, "shaders alone, which need no glEnable"),
    (|c| c.enable(GL_CLIP_DISTANCE0 + 9), GL_INVALID_ENUM, "such as GL_ALPHA_TEST, GL_AUTO_NORMAL"),
    (|c| c.enable(GL_TEXTURE_GEN_MODE), GL_INVALID_ENUM, "near in name: GL_TEXTURE_GEN_S"),
    (|c| c.enable(GL_LINEAR), GL_INVALID_ENUM, "cap = GL_LINEAR must be one of 69 values"),
    (|c| c.enable_client_state(GL_TEXTURE_2D), GL_INVALID_ENUM, "GL_VERTEX_ARRAY"),
    (|c| c.cull_face(GL_CW), GL_INVALID_ENUM, "mode = GL_CW must be GL_FRONT, GL_BACK or"),
    (|c| c.front_face(GL_FRONT), GL_INVALID_ENUM, "GL_CCW or GL_CW"),
    (
        |c| c.clip_control(GL_LEFT, GL_ZERO_TO_ONE),
        GL_INVALID_ENUM,
        "GL_LOWER_LEFT or GL_UPPER_LEFT",
    ),
    (
        |c| c.clip_control(GL_UPPER_LEFT, GL_UPPER_LEFT),
        GL_INVALID_ENUM,
        "GL_NEGATIVE_ONE_TO_ONE or GL_ZERO_TO_ONE",
    ),
    (|c| c.shade_model(GL_FILL), GL_INVALID_ENUM, "GL_SMOOTH or GL_FLAT"),
    (|c| c.provoking_vertex(GL_FLAT), GL_INVALID_ENUM, "mode = GL_FLAT"),
    (|c| c.line_width(0.0), GL_INVALID_VALUE, "width = 0 must be positive"),
    (|c| c.point_size(f32::NAN), GL_INVALID_VALUE, "size = NaN must be positive"),
    (|c| c.hint(GL_FOG_HINT, GL_LINEAR), GL_INVALID_ENUM, "GL_FASTEST"),
    (|c| c.blend_func(GL_LINEAR, GL_ZERO), GL_INVALID_ENUM, "source factor = GL_LINEAR"),
    (|c| c.blend_func(GL_ONE, GL_MAX), GL_INVALID_ENUM, "destination factor = GL_MAX"),
    (|c| c.blend_equation(GL_ONE), GL_INVALID_ENUM, "GL_FUNC_ADD"),
    (|c| c.depth_func(GL_ONE), GL_INVALID_ENUM, "GL_NEVER, GL_LESS"),
    (|c| c.alpha_func(GL_LINEAR, 0.5), GL_INVALID_ENUM, "func = GL_LINEAR"),
    (|c| c.scissor(0, 0, 1, -1), GL_INVALID_VALUE, "height = -1"),
    (|c| c.clear(1), GL_INVALID_VALUE, "bits that name no buffer: 0x1"),
    // Vertices.
    (|c| c.begin(42), GL_INVALID_ENUM, "GL_POINTS"),
    (|c| c.end(), GL_INVALID_OPERATION, "no glBegin is open"),
    (|c| c.multi_tex_coord_2f(GL_TEXTURE0 + 9, 0.0, 0.0), GL_INVALID_ENUM, "GL_TEXTURE0 + 9"),
    (|c| c.vertex_attrib_1f(16, 0.0), GL_INVALID_VALUE, "must be below GL_MAX_VERTEX_ATTRIBS"),
    (|c| c.color_3fv(&[1.0; 2]), GL_INVALID_OPERATION, "2 of 3 numbers"),
    (
        |c| {
            c.begin(GL_TRIANGLES);
            c.enable(GL_BLEND);
            c.end();
        },
        GL_INVALID_OPERATION,
        "between glBegin and glEnd",
    ),
    (|c| c.vertex_pointer(1, GL_FLOAT, 0, Data::Null), GL_INVALID_VALUE, "size = 1 must be 2 to 4"),
    (|c| c.vertex_pointer(3, GL_BYTE, 0, Data::Null), GL_INVALID_ENUM, "type = GL_BYTE"),
    (|c| c.vertex_pointer(3, GL_FLOAT, -4, Data::Null), GL_INVALID_VALUE, "stride = -4"),
    (
        |c| c.vertex_pointer(3, GL_FLOAT, 0, Data::Offset(8)),
        GL_INVALID_OPERATION,
        "GL_ARRAY_BUFFER",
    ),
    (|c| c.draw_arrays(GL_LINEAR, 0, 3), GL_INVALID_ENUM, "mode"),
    (|c| c.draw_arrays(GL_TRIANGLES, 0, -1), GL_INVALID_VALUE, "count = -1"),
    (|c| c.draw_arrays(GL_TRIANGLES, -1, 0), GL_INVALID_VALUE, "first = -1"),
    (
        |c| c.draw_elements(GL_TRIANGLES, 3, GL_FLOAT, Data::Null),
        GL_INVALID_ENUM,
        "GL_UNSIGNED_BYTE",
    ),
    (
        |c| c.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, Data::Bytes(&[0; 11])),
        GL_INVALID_OPERATION,
        "count = 3 indices take 12 bytes",
    ),
    (
        |c| c.draw_range_elements(GL_TRIANGLES, 2, 1, 0, GL_UNSIGNED_INT, Data::Null),
        GL_INVALID_VALUE,
        "end = 1 must not be below start = 2",
    ),
    (|c| c.bind_buffer(GL_TEXTURE_2D, 1), GL_INVALID_ENUM, "GL_ARRAY_BUFFER"),
    (
        |c| c.buffer_data(GL_ARRAY_BUFFER, 4, Data::Null, GL_STATIC_DRAW),
        GL_INVALID_OPERATION,
        "call glBindBuffer",
    ),
    // Framebuffers.
    (|c| c.bind_framebuffer(GL_RENDERBUFFER, 1), GL_INVALID_ENUM, "GL_FRAMEBUFFER"),
    (
        |c| {
            c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 1, 0);
        },
        GL_INVALID_OPERATION,
        "the default framebuffer is bound",
    ),
    (
        |c| c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_STENCIL, GL_TEXTURE_2D, 1, 0),
        GL_INVALID_ENUM,
        "attachment = GL_STENCIL",
    ),
    (
        |c| c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, 1, 1),
        GL_INVALID_OPERATION,
        "no renderbuffer is bound",
    ),
    (
        |c| c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, 9000, 1),
        GL_INVALID_VALUE,
        "must not be above 8192",
    ),
    (|c| c.draw_buffer(GL_COLOR_ATTACHMENT0), GL_INVALID_OPERATION, "use GL_BACK"),
    (|c| c.draw_buffer(GL_RIGHT), GL_INVALID_OPERATION, "no such buffer"),
    (|c| c.draw_buffer(GL_LINEAR), GL_INVALID_ENUM, "must name a colour buffer"),
    (|c| c.draw_buffers(9, &[GL_NONE; 9]), GL_INVALID_VALUE, "must not be above 8"),
    (|c| c.draw_buffers(2, &[GL_BACK_LEFT; 2]), GL_INVALID_OPERATION, "was named before"),
    (|c| c.draw_buffers(1, &[GL_BACK]), GL_INVALID_ENUM, "may name several buffers"),
    (|c| c.draw_buffers(1, &[GL_FRONT_AND_BACK]), GL_INVALID_ENUM, "may name several buffers"),
    // Programs and queries.
    (|c| assert_eq!(c.create_shader(GL_TEXTURE_2D), 0), GL_INVALID_ENUM, "GL_VERTEX_SHADER"),
    (|c| c.compile_shader(7), GL_INVALID_VALUE, "shader = 7 is no shader"),
    (|c| c.link_program(7), GL_INVALID_VALUE, "program = 7 is no program"),
    (|c| c.use_program(7), GL_INVALID_VALUE, "program = 7"),
    (|c| c.uniform_1f(0, 1.0), GL_INVALID_OPERATION, "no linked program is in use"),
    (|c| assert_eq!(c.get_string(GL_TEXTURE), ""), GL_INVALID_ENUM, "GL_VENDOR"),
    (|c| c.get_integerv(GL_LINEAR, &mut [0]), GL_INVALID_ENUM, "GL_LINEAR names no state"),
    (|c| c.get_integerv(GL_VIEWPORT, &mut [0]), GL_INVALID_OPERATION, "has 4 values"),
];

fn context() -> Context {
    let mut c = super::context();
    c.bind_texture(GL_TEXTURE_2D, 1);
    let texels: Vec<u8> = (0..16).collect();
    let pixels = Data::Bytes(&texels);
    c.tex_image_2d(GL_TEXTURE_2D, 0, 4, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    c
}

/// Runs the rows.
pub fn run() {
    super::table("basic", context, CASES.iter().map(|(call, flag, words)| (call, *flag, *words)));
}
