//! Contexts of OpenGL ES 3.0: what they refuse, which shaders they compile, and that they draw and read back what the
//! tables of the specification say.

#[path = "common/shading.rs"]
mod shading;

use gl_api::*;
use shading::use_program;

fn context(api: Api) -> Context {
    let version = Version::new(if api == Api::Es2 { 2 } else { 3 }, 0);
    Context::new(ContextDesc { api, version, width: 8, height: 8, ..ContextDesc::default() })
        .expect("a device")
}

fn es() -> Context {
    context(Api::Es2)
}

type Call = fn(&mut Context);

fn image(c: &mut Context, internal: GLenum, format: GLenum, ty: GLenum) {
    let texels: &[u8] = &[0; 64];
    c.tex_image_2d(GL_TEXTURE_2D, 0, internal as i32, 2, 2, 0, format, ty, texels.arg());
}

/// Calls that OpenGL ES refuses and compatibility contexts do not; the error, and words of the message.
const FOREIGN: &[(&str, Call, GLenum, &str)] = &[
    ("a command", |c| c.begin(GL_TRIANGLES), GL_INVALID_OPERATION, "OpenGL ES"),
    ("a double", |c| c.clear_depth(0.5), GL_INVALID_OPERATION, "OpenGL ES"),
    ("a capability", |c| c.enable(GL_MULTISAMPLE), GL_INVALID_ENUM, "OpenGL ES"),
    ("a target", |c| c.bind_texture(GL_TEXTURE_1D, 0), GL_INVALID_ENUM, "OpenGL ES"),
    (
        "a wrap mode",
        |c| c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP as i32),
        GL_INVALID_ENUM,
        "OpenGL ES",
    ),
    ("a mode", |c| c.draw_arrays(GL_QUADS, 0, 0), GL_INVALID_ENUM, "triangles"),
    ("state of OpenGL", |c| c.get_integerv(GL_POLYGON_MODE, &mut [0; 2]), GL_INVALID_ENUM, "ES"),
    (
        "a number of components",
        |c| image(c, 4, GL_RGBA, GL_UNSIGNED_BYTE),
        GL_INVALID_VALUE,
        "GL_RGBA8",
    ),
    (
        "a conversion",
        |c| image(c, GL_RGBA8, GL_RGB, GL_UNSIGNED_BYTE),
        GL_INVALID_OPERATION,
        "GL_RGBA with GL_UNSIGNED_BYTE",
    ),
    ("a type", |c| image(c, GL_RGBA8, GL_RGBA, GL_FLOAT), GL_INVALID_OPERATION, "GL_UNSIGNED_BYTE"),
    (
        "a format",
        |c| image(c, GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT),
        GL_INVALID_VALUE,
        "OpenGL ES",
    ),
    (
        "pixels of another type",
        |c| c.read_pixels(0, 0, 1, 1, GL_RGB, GL_FLOAT, DataOut::Bytes(&mut [0; 12])),
        GL_INVALID_OPERATION,
        "GL_RGBA with GL_UNSIGNED_BYTE",
    ),
];

#[test]
fn what_is_not_in_opengl_es_is_refused_with_a_reason() {
    for (what, call, error, words) in FOREIGN {
        let mut c = es();
        call(&mut c);
        assert_eq!(c.get_error(), *error, "{what}");
        let message = c.messages().last().map(ToString::to_string).unwrap_or_default();
        assert!(message.contains(words), "{what}: {message}");
        let mut c = context(Api::Compatibility);
        call(&mut c);
        // Errors cannot be asked for after glBegin.
        if *what != "a command" {
            assert_eq!(c.get_error(), GL_NO_ERROR, "{what} in a compatibility context");
        }
    }
}

#[test]
fn the_version_and_the_extensions_can_be_asked_for() {
    let mut c = es();
    assert!(c.get_string(GL_VERSION).starts_with("OpenGL ES 3.0 "));
    assert_eq!(c.get_string(GL_SHADING_LANGUAGE_VERSION), "OpenGL ES GLSL ES 3.00");
    let joined: Vec<&str> = c.get_string(GL_EXTENSIONS).split(' ').collect();
    let mut count = [0];
    c.get_integerv(GL_NUM_EXTENSIONS, &mut count);
    let single: Vec<&str> =
        (0..count[0]).map(|at| c.get_stringi(GL_EXTENSIONS, at as u32)).collect();
    assert_eq!(joined, single);
    assert!(single.contains(&"GL_OES_texture_npot") && !single.contains(&"GL_ARB_texture_storage"));
    assert_eq!(c.get_error(), GL_NO_ERROR);
    let later =
        ContextDesc { api: Api::Es2, version: Version::new(3, 1), ..ContextDesc::default() };
    let error = Context::new(later).expect_err("there is no 3.1").to_string();
    assert!(error.contains("3.1") && error.contains("3.0"), "{error}");
}

const QUAD: &str = "#version 300 es\n\
    void main() {\n\
      vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n\
      gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);\n\
    }";

fn pixel(c: &mut Context) -> [u8; 4] {
    let mut pixel = [0; 4];
    c.read_pixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    pixel
}

/// A shader without a version is of GLSL ES 1.00; its attributes come from the client's memory, its points have the size
/// that it writes and coordinates.
#[test]
fn shaders_of_1_00_draw_from_client_memory() {
    let mut c = es();
    let vertex = "attribute vec2 position;\n\
        void main() { gl_Position = vec4(position, 0.0, 1.0); gl_PointSize = 8.0; }";
    let fragment = "precision mediump float;\n\
        void main() { gl_FragColor = vec4(gl_PointCoord, 0.0, 1.0); }";
    let program = use_program(&mut c, vertex, fragment);
    let location = c.get_attrib_location(program, "position") as u32;
    let positions = [0.0_f32, 0.0];
    c.enable_vertex_attrib_array(location);
    c.vertex_attrib_pointer(location, 2, GL_FLOAT, false, 0, positions[..].arg());
    c.draw_arrays(GL_POINTS, 0, 1);
    // Pixel (4, 4) is right of and above the centre: s = 9/16, t = 7/16 from the top.
    assert_eq!(pixel(&mut c), [143, 112, 0, 255]);
}

/// All signed fractions are `max(c / (2^(b-1) - 1), -1)` (OpenGL ES 3.0 equation 2.2): 0 is 0, both least numbers are -1.
#[test]
fn signed_fractions_in_arrays_have_a_zero() {
    let mut c = es();
    let vertex = "#version 300 es\n\
        layout(location = 0) in vec3 given; out vec3 value;\n\
        void main() { value = given; gl_Position = vec4(0.0, 0.0, 0.0, 1.0); gl_PointSize = 8.0; }";
    let fragment = "#version 300 es\n\
        precision highp float; in vec3 value; out vec4 color;\n\
        void main() { color = vec4(equal(value, vec3(-1.0, 0.0, 1.0)), true); }";
    use_program(&mut c, vertex, fragment);
    c.enable_vertex_attrib_array(0);
    let packed = (0x1ff_u32 << 20 | 0x200).to_le_bytes();
    let words = [i32::MIN, 0, i32::MAX].map(i32::to_le_bytes);
    let cases: [(GLenum, i32, &[u8]); 5] = [
        (GL_BYTE, 3, &[0x80, 0, 0x7f]),
        (GL_BYTE, 3, &[0x81, 0, 0x7f]),
        (GL_SHORT, 3, &[0, 0x80, 0, 0, 0xff, 0x7f]),
        (GL_INT, 3, words.as_flattened()),
        (GL_INT_2_10_10_10_REV, 4, &packed),
    ];
    for (ty, size, bytes) in cases {
        c.vertex_attrib_pointer(0, size, ty, true, 0, bytes.arg());
        c.draw_arrays(GL_POINTS, 0, 1);
        assert_eq!(pixel(&mut c), [255; 4], "{}", enum_name(ty));
        let mut normalized = [0];
        c.get_vertex_attribiv(0, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, &mut normalized);
        assert_eq!(normalized, [1]);
    }
}

/// What is packed and unpacked again is what was rounded to 16 bits (GLSL ES 3.00 section 8.4).
#[test]
fn shaders_of_3_00_pack_half_floats_and_fractions() {
    let mut c = es();
    let fragment = "#version 300 es\n\
        precision highp float;\n\
        uniform vec4 given;\n\
        uniform uvec3 expected;\n\
        out vec4 color;\n\
        void main() {\n\
          uvec3 found = uvec3(packHalf2x16(given.xy), packUnorm2x16(given.zw), packSnorm2x16(given.zw));\n\
          vec2 half_floats = unpackHalf2x16(expected.x);\n\
          bool again = packHalf2x16(half_floats) == expected.x;\n\
          color = vec4(equal(found, expected), again);\n\
        }";
    let program = use_program(&mut c, QUAD, fragment);
    let [given, expected] = ["given", "expected"].map(|name| c.get_uniform_location(program, name));
    // 65519 is below the middle of 65504 and 2^16, 2^-25 ties to 0, 1.5 · 2^-25 rounds to 2^-24; fractions round to the
    // nearest and are clamped.
    let cases: [([f32; 4], [u32; 3]); 4] = [
        ([1.0, -2.0, 0.5, 1.5], [0xc000_3c00, 0xffff_8000, 0x7fff_4000]),
        ([65519.0, 65520.0, -0.25, -1.0], [0x7c00_7bff, 0, 0x8001_e000]),
        (
            [2.0f32.powi(-25), 1.5 * 2.0f32.powi(-25), 0.0, 1.0],
            [0x0001_0000, 0xffff_0000, 0x7fff_0000],
        ),
        ([0.333_251_95, f32::INFINITY, 1.0 / 65535.0, 0.0], [0x7c00_3555, 1, 0]),
    ];
    for (values, words) in cases {
        c.uniform_4f(given, values[0], values[1], values[2], values[3]);
        c.uniform_3ui(expected, words[0], words[1], words[2]);
        c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
        assert_eq!(pixel(&mut c), [255; 4], "{values:?}");
    }
}

/// A program needs a shader of each stage, of one version, with precisions that agree.
#[test]
fn programs_that_do_not_fit_together_do_not_link() {
    let cases = [
        ("#version 300 es\nvoid main() {}", "void main() {}", "GLSL ES 1.00"),
        ("void main() {}", "", "no fragment shader"),
        (
            "#version 300 es\nuniform float f; void main() { gl_Position = vec4(f); }",
            "#version 300 es\nprecision highp float; uniform mediump float f; out vec4 o; void main() { o = vec4(f); }",
            "mediump",
        ),
    ];
    for (vertex, fragment, words) in cases {
        let mut c = es();
        let program = c.create_program();
        for (ty, text) in [(GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, fragment)] {
            if !text.is_empty() {
                let shader = c.create_shader(ty);
                c.shader_source(shader, 1, Strings(vec![text]), &[]);
                c.compile_shader(shader);
                let mut compiled = [0];
                c.get_shaderiv(shader, GL_COMPILE_STATUS, &mut compiled);
                assert_eq!(compiled, [1], "{text}");
                c.attach_shader(program, shader);
            }
        }
        c.link_program(program);
        let mut linked = [1];
        c.get_programiv(program, GL_LINK_STATUS, &mut linked);
        assert_eq!(linked, [0], "{words}");
        let messages: Vec<String> = c.messages().iter().map(ToString::to_string).collect();
        assert!(messages.iter().any(|message| message.contains(words)), "{messages:?}");
    }
}

/// A block of one colour: R, G and B of 5 bits, and a difference of 0.
#[test]
fn blocks_of_etc2_are_sampled_as_the_specification_decodes_them() {
    let mut c = es();
    let fragment = "#version 300 es\n\
        precision highp float;\n\
        uniform sampler2D image;\n\
        out vec4 color;\n\
        void main() { color = texture(image, vec2(0.5)); }";
    use_program(&mut c, QUAD, fragment);
    let mut names = [0];
    c.gen_textures(1, &mut names);
    c.bind_texture(GL_TEXTURE_2D, names[0]);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32);
    // Differential, row 0 of table C.8: 2 is added to 8 bits of 16, 8 and 31.
    let block = [16 << 3, 8 << 3, 31 << 3, 0b10, 0, 0, 0, 0_u8];
    c.compressed_tex_image_2d(
        GL_TEXTURE_2D,
        0,
        GL_COMPRESSED_RGB8_ETC2,
        4,
        4,
        0,
        8,
        block[..].arg(),
    );
    c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
    assert_eq!(pixel(&mut c), [134, 68, 255, 255]);
    // Pixels do not replace a part of blocks; blocks do.
    c.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, [0_u8; 4][..].arg());
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    let black = [0, 0, 0, 0b10, 0, 0, 0, 0_u8];
    let all = (0, 0, 4, 4);
    c.compressed_tex_sub_image_2d(
        GL_TEXTURE_2D,
        0,
        all.0,
        all.1,
        all.2,
        all.3,
        GL_COMPRESSED_RGB8_ETC2,
        8,
        black[..].arg(),
    );
    c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
    assert_eq!(pixel(&mut c), [2, 2, 2, 255]);
}

/// The table of formats that are drawn to is shorter than OpenGL's (OpenGL ES 3.0, table 3.13).
#[test]
fn framebuffers_are_complete_with_formats_that_opengl_es_draws_to() {
    let cases = [
        (GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, true),
        (GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, true),
        (GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, true),
        (GL_RGBA8_SNORM, GL_RGBA, GL_BYTE, false),
        (GL_RGB9_E5, GL_RGB, GL_FLOAT, false),
        (GL_SRGB8, GL_RGB, GL_UNSIGNED_BYTE, false),
        (GL_LUMINANCE, GL_LUMINANCE, GL_UNSIGNED_BYTE, false),
        // What extensions store of unsized colours (OES_texture_float, OES_texture_half_float with
        // EXT_color_buffer_half_float, EXT_texture_type_2_10_10_10_REV).
        (GL_RGBA, GL_RGBA, GL_FLOAT, false),
        (GL_RGBA, GL_RGBA, GL_HALF_FLOAT, true),
        (GL_RGBA, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, false),
        (GL_RGB, GL_RGB, GL_UNSIGNED_INT_2_10_10_10_REV, false),
    ];
    for (internal, format, ty, is_complete) in cases {
        let mut c = es();
        let (mut texture, mut framebuffer) = ([0], [0]);
        c.gen_textures(1, &mut texture);
        c.bind_texture(GL_TEXTURE_2D, texture[0]);
        image(&mut c, internal, format, ty);
        c.gen_framebuffers(1, &mut framebuffer);
        c.bind_framebuffer(GL_FRAMEBUFFER, framebuffer[0]);
        c.framebuffer_texture_2d(
            GL_FRAMEBUFFER,
            GL_COLOR_ATTACHMENT0,
            GL_TEXTURE_2D,
            texture[0],
            0,
        );
        let status = c.check_framebuffer_status(GL_FRAMEBUFFER);
        assert_eq!(status == GL_FRAMEBUFFER_COMPLETE, is_complete, "{internal:#x}");
        assert_eq!(c.get_error(), GL_NO_ERROR, "{internal:#x}: {:?}", c.messages());
    }
}

/// Two objects capture in turn while each is paused (OpenGL ES 3.0, section 2.14.1).
#[test]
fn transform_feedback_objects_keep_what_they_have_captured() {
    let mut c = es();
    let program = c.create_program();
    let sources = [
        (
            GL_VERTEX_SHADER,
            "#version 300 es\nin float x; out float y; void main() { y = x; gl_Position = vec4(0.0); }",
        ),
        (GL_FRAGMENT_SHADER, "#version 300 es\nvoid main() {}"),
    ];
    for (ty, text) in sources {
        let shader = c.create_shader(ty);
        c.shader_source(shader, 1, Strings(vec![text]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
    }
    c.transform_feedback_varyings(program, 1, Names(vec!["y"]), GL_INTERLEAVED_ATTRIBS);
    c.link_program(program);
    c.use_program(program);
    let (mut objects, mut buffers) = ([0; 2], [0; 2]);
    c.gen_transform_feedbacks(2, &mut objects);
    c.gen_buffers(2, &mut buffers);
    for at in 0..2 {
        c.bind_transform_feedback(GL_TRANSFORM_FEEDBACK, objects[at]);
        c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers[at]);
        c.buffer_data(GL_TRANSFORM_FEEDBACK_BUFFER, 8, [0_u8; 8][..].arg(), GL_DYNAMIC_READ);
        c.begin_transform_feedback(GL_POINTS);
        c.pause_transform_feedback();
    }
    for value in [1.0, 2.0, 3.0, 4.0] {
        let at = usize::from(value == 2.0 || value == 4.0);
        c.bind_transform_feedback(GL_TRANSFORM_FEEDBACK, objects[at]);
        c.resume_transform_feedback();
        c.vertex_attrib_1f(0, value);
        c.draw_arrays(GL_POINTS, 0, 1);
        c.pause_transform_feedback();
    }
    for (at, expected) in [[1.0_f32, 3.0], [2.0, 4.0]].into_iter().enumerate() {
        c.bind_transform_feedback(GL_TRANSFORM_FEEDBACK, objects[at]);
        c.end_transform_feedback();
        c.bind_buffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffers[at]);
        c.map_buffer_range(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 8, GL_MAP_READ_BIT);
        let bytes = c.mapped_bytes(GL_TRANSFORM_FEEDBACK_BUFFER).expect("it is mapped").to_vec();
        let found = [0, 4]
            .map(|at| f32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]));
        assert_eq!(found, expected);
        c.unmap_buffer(GL_TRANSFORM_FEEDBACK_BUFFER);
    }
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

/// The largest index of a type ends a strip (OpenGL ES 3.0, section 2.9.1).
#[test]
fn the_largest_index_restarts_primitives() {
    let mut c = es();
    let vertex = "#version 300 es\n\
        layout(location = 0) in vec2 position;\n\
        void main() { gl_Position = vec4(position, 0.0, 1.0); }";
    let fragment = "#version 300 es\n\
        precision highp float;\n\
        out vec4 color;\n\
        void main() { color = vec4(1.0); }";
    use_program(&mut c, vertex, fragment);
    // Two triangles left and right of the middle, which a strip would join over it.
    let positions: [f32; 12] = [-1.0, -1.0, -0.5, -1.0, -1.0, 1.0, 1.0, 1.0, 1.0, -1.0, 0.75, -1.0];
    c.enable_vertex_attrib_array(0);
    c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 0, positions[..].arg());
    c.enable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
    let indices: [u8; 7] = [0, 1, 2, 255, 3, 4, 5];
    c.draw_elements(GL_TRIANGLE_STRIP, 7, GL_UNSIGNED_BYTE, indices[..].arg());
    assert_eq!(pixel(&mut c), [0; 4]);
    // Without it, the strip reaches over the middle.
    let indices: [u8; 6] = [0, 1, 2, 3, 4, 5];
    c.draw_elements(GL_TRIANGLE_STRIP, 6, GL_UNSIGNED_BYTE, indices[..].arg());
    assert_eq!(pixel(&mut c), [255; 4]);
}

/// Draw buffers keep the order of the attachments (section 4.2.1), and copies make no channels up (table 3.15).
#[test]
fn draw_buffers_and_copies_follow_the_stricter_rules() {
    let mut c = es();
    let mut buffer = [0];
    c.get_integerv(GL_DRAW_BUFFER0, &mut buffer);
    assert_eq!(buffer[0] as u32, GL_BACK);
    c.draw_buffers(1, &[GL_NONE]);
    c.draw_buffers(1, &[GL_BACK]);
    assert_eq!(c.get_error(), GL_NO_ERROR);
    c.draw_buffers(1, &[GL_COLOR_ATTACHMENT0]);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    let (mut texture, mut framebuffer) = ([0], [0]);
    c.gen_textures(1, &mut texture);
    c.bind_texture(GL_TEXTURE_2D, texture[0]);
    image(&mut c, GL_RGB, GL_RGB, GL_UNSIGNED_BYTE);
    c.gen_framebuffers(1, &mut framebuffer);
    c.bind_framebuffer(GL_FRAMEBUFFER, framebuffer[0]);
    c.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture[0], 0);
    c.draw_buffers(2, &[GL_NONE, GL_COLOR_ATTACHMENT1]);
    assert_eq!(c.get_error(), GL_NO_ERROR);
    c.draw_buffers(2, &[GL_COLOR_ATTACHMENT1, GL_NONE]);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    c.bind_texture(GL_TEXTURE_2D, 0);
    c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_LUMINANCE, 0, 0, 1, 1, 0);
    assert_eq!(c.get_error(), GL_NO_ERROR);
    c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 1, 1, 0);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
}

/// The numbers of samples are those that renderbuffers get; integers have none.
#[test]
fn sample_counts_can_be_asked_for() {
    let mut c = es();
    let mut counts = |format, pname| {
        let mut values = [-1; 2];
        c.get_internalformativ(GL_RENDERBUFFER, format, pname, 2, &mut values);
        assert_eq!(c.get_error(), GL_NO_ERROR);
        values
    };
    assert_eq!(counts(GL_RGBA8, GL_NUM_SAMPLE_COUNTS), [1, -1]);
    assert_eq!(counts(GL_RGBA8, GL_SAMPLES), [4, -1]);
    assert_eq!(counts(GL_RGBA8UI, GL_NUM_SAMPLE_COUNTS), [0, -1]);
}

/// `EXT_disjoint_timer_query`, `KHR_robustness` and `EXT_robustness`.
#[test]
fn time_is_queried_and_reads_are_bounded() {
    let mut c = es();
    let mut ids = [0; 2];
    c.gen_queries(2, &mut ids);
    c.begin_query(GL_TIME_ELAPSED, ids[0]);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.end_query(GL_TIME_ELAPSED);
    c.query_counter(ids[1], GL_TIMESTAMP);
    let (mut bits, mut elapsed, mut then, mut now) = ([0], [0], [0], [0]);
    c.get_queryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &mut bits);
    assert!(bits[0] >= 30, "{bits:?}");
    c.get_query_objectui64v(ids[0], GL_QUERY_RESULT, &mut elapsed);
    c.get_query_objecti64v(ids[1], GL_QUERY_RESULT, &mut then);
    c.get_integer64v(GL_TIMESTAMP, &mut now);
    assert!(elapsed[0] > 0 && elapsed[0] < 1 << 40 && now[0] >= then[0], "{elapsed:?}");
    let mut disjoint = [7];
    c.get_integerv(GL_GPU_DISJOINT_EXT, &mut disjoint);
    assert_eq!((c.get_error(), disjoint), (GL_NO_ERROR, [0]));
    let (mut strategy, mut robust) = ([0], [0]);
    c.get_integerv(GL_RESET_NOTIFICATION_STRATEGY, &mut strategy);
    c.get_integerv(GL_CONTEXT_ROBUST_ACCESS, &mut robust);
    assert_eq!((strategy, robust), ([GL_NO_RESET_NOTIFICATION as i32], [1]));
    assert_eq!(c.get_graphics_reset_status(), GL_NO_ERROR);
    let mut texels = [0; 16];
    c.clear_color(1.0, 0.0, 0.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
    c.readn_pixels(0, 0, 2, 2, format, ty, 16, DataOut::Bytes(&mut texels));
    assert_eq!((c.get_error(), &texels[12..]), (GL_NO_ERROR, &[255, 0, 0, 255][..]));
    c.readn_pixels(0, 0, 2, 2, format, ty, 15, DataOut::Bytes(&mut texels));
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
}
