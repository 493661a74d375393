//! Rules of OpenGL ES 3.0 that are stricter than OpenGL's, or other ones: of framebuffers, of copies between them, of
//! transform feedback, of vertex arrays and of what is asked for.

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

/// A texture of two dimensions with one level, bound.
fn texture(c: &mut Context, internal: GLenum, format: GLenum, ty: GLenum) -> GLuint {
    let mut name = [0];
    c.gen_textures(1, &mut name);
    c.bind_texture(GL_TEXTURE_2D, name[0]);
    image(c, 0, 8, (internal, format, ty));
    name[0]
}

/// An image of a level of the bound texture.
fn image(
    c: &mut Context,
    level: GLint,
    side: GLsizei,
    (internal, format, ty): (GLenum, GLenum, GLenum),
) {
    let texels: &[u8] = &[60; 8 * 8 * 16];
    c.tex_image_2d(GL_TEXTURE_2D, level, internal as i32, side, side, 0, format, ty, texels.arg());
}

/// A framebuffer that is bound to a target, with a level of a texture as its first colour.
fn framebuffer(c: &mut Context, target: GLenum, texture: GLuint, level: GLint) {
    let mut name = [0];
    c.gen_framebuffers(1, &mut name);
    c.bind_framebuffer(target, name[0]);
    c.framebuffer_texture_2d(target, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, level);
}

/// The same with a new texture.
fn framebuffer_of(c: &mut Context, target: GLenum, internal: GLenum, format: GLenum, ty: GLenum) {
    let texture = texture(c, internal, format, ty);
    framebuffer(c, target, texture, 0);
}

/// The same with a new renderbuffer.
fn renderbuffer(c: &mut Context, target: GLenum, samples: GLsizei, internal: GLenum) {
    let (mut name, mut object) = ([0], [0]);
    c.gen_renderbuffers(1, &mut name);
    c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
    c.renderbuffer_storage_multisample(GL_RENDERBUFFER, samples, internal, 8, 8);
    c.gen_framebuffers(1, &mut object);
    c.bind_framebuffer(target, object[0]);
    c.framebuffer_renderbuffer(target, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, name[0]);
}

fn blit(c: &mut Context, by: GLint) {
    c.blit_framebuffer(0, 0, 4, 4, by, by, by + 4, by + 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

fn asked(c: &mut Context, attachment: GLenum, pname: GLenum) -> GLint {
    let mut value = [-1];
    c.get_framebuffer_attachment_parameteriv(GL_FRAMEBUFFER, attachment, pname, &mut value);
    value[0]
}

type Call = fn(&mut Context);

/// Calls that OpenGL ES refuses; the error, words of the message, and what a compatibility context says.
const REFUSED: &[(&str, Call, GLenum, &str, GLenum)] = &[
    (
        "a clear of an accumulation buffer",
        |c| c.clear(GL_ACCUM_BUFFER_BIT),
        GL_INVALID_VALUE,
        "0x200",
        GL_NO_ERROR,
    ),
    (
        "a buffer of another name",
        |c| {
            framebuffer_of(c, GL_FRAMEBUFFER, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
            c.read_buffer(GL_FRONT);
        },
        GL_INVALID_ENUM,
        "GL_FRONT",
        GL_INVALID_OPERATION,
    ),
    (
        "a colour attachment that is read but not there",
        |c| {
            framebuffer_of(c, GL_FRAMEBUFFER, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
            c.read_buffer(GL_COLOR_ATTACHMENT31);
        },
        GL_INVALID_OPERATION,
        "GL_COLOR_ATTACHMENT0 to 7",
        GL_INVALID_ENUM,
    ),
    (
        "a colour attachment that is not there",
        |c| {
            framebuffer_of(c, GL_FRAMEBUFFER, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
            c.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT8, GL_RENDERBUFFER, 0);
        },
        GL_INVALID_OPERATION,
        "GL_COLOR_ATTACHMENT0 to 7",
        GL_INVALID_ENUM,
    ),
    (
        "too many samples",
        |c| renderbuffer(c, GL_FRAMEBUFFER, 5, GL_RGBA4),
        GL_INVALID_OPERATION,
        "samples = 5",
        GL_INVALID_VALUE,
    ),
    (
        "a copy to several samples",
        |c| {
            framebuffer_of(c, GL_READ_FRAMEBUFFER, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
            renderbuffer(c, GL_DRAW_FRAMEBUFFER, 4, GL_RGBA8);
            blit(c, 0);
        },
        GL_INVALID_OPERATION,
        "samples a pixel",
        GL_NO_ERROR,
    ),
    (
        "samples that are resolved to another place",
        |c| {
            renderbuffer(c, GL_READ_FRAMEBUFFER, 4, GL_RGBA8);
            framebuffer_of(c, GL_DRAW_FRAMEBUFFER, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
            blit(c, 2);
        },
        GL_INVALID_OPERATION,
        "in place",
        GL_NO_ERROR,
    ),
    (
        "samples that are resolved to another format",
        |c| {
            renderbuffer(c, GL_READ_FRAMEBUFFER, 4, GL_RGBA8);
            framebuffer_of(c, GL_DRAW_FRAMEBUFFER, GL_R8, GL_RED, GL_UNSIGNED_BYTE);
            blit(c, 0);
        },
        GL_INVALID_OPERATION,
        "resolved",
        GL_NO_ERROR,
    ),
    (
        "a copy within one image",
        |c| {
            framebuffer_of(c, GL_FRAMEBUFFER, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
            blit(c, 4);
        },
        GL_INVALID_OPERATION,
        "one image",
        GL_NO_ERROR,
    ),
    (
        "sRGB made of other colours",
        |c| c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, 0, 0, 4, 4, 0),
        GL_INVALID_OPERATION,
        "sRGB",
        GL_NO_ERROR,
    ),
    (
        "an exponent that is shared",
        |c| c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGB9_E5, 0, 0, 4, 4, 0),
        GL_INVALID_OPERATION,
        "GL_RGB9_E5",
        GL_NO_ERROR,
    ),
    (
        "components of another size",
        |c| c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGB10_A2, 0, 0, 4, 4, 0),
        GL_INVALID_OPERATION,
        "sizes",
        GL_NO_ERROR,
    ),
    (
        "integers of the other kind",
        |c| {
            framebuffer_of(c, GL_FRAMEBUFFER, GL_RGBA8I, GL_RGBA_INTEGER, GL_BYTE);
            c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8UI, 0, 0, 4, 4, 0);
        },
        GL_INVALID_OPERATION,
        "not copied",
        GL_NO_ERROR,
    ),
    (
        "fractions with a sign of others",
        |c| c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8_SNORM, 0, 0, 4, 4, 0),
        GL_INVALID_OPERATION,
        "not copied",
        GL_NO_ERROR,
    ),
    (
        "pixels of a known format and a known type that do not go together",
        |c| image(c, 0, 2, (GL_RGBA8, GL_DEPTH_STENCIL, GL_UNSIGNED_BYTE)),
        GL_INVALID_OPERATION,
        "does not go with",
        GL_INVALID_ENUM,
    ),
    (
        "the front of the default framebuffer",
        |c| {
            asked(c, GL_FRONT_LEFT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
        },
        GL_INVALID_ENUM,
        "GL_BACK",
        GL_NO_ERROR,
    ),
    (
        "the name of a buffer of the default framebuffer",
        |c| {
            asked(c, GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME);
        },
        GL_INVALID_ENUM,
        "GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME",
        GL_NO_ERROR,
    ),
];

#[test]
fn stricter_rules_are_errors_with_a_reason() {
    for (what, call, error, words, in_opengl) in REFUSED {
        let mut c = es();
        call(&mut c);
        let message = c.messages().last().map(ToString::to_string).unwrap_or_default();
        assert_eq!(c.get_error(), *error, "{what}: {message}");
        assert!(message.contains(words), "{what}: {message}");
        let mut c = context(Api::Compatibility);
        call(&mut c);
        assert_eq!(c.get_error(), *in_opengl, "{what} in a compatibility context");
    }
}

/// State that begins otherwise or is asked for otherwise (OpenGL ES 3.0, sections 4.1.7, 4.2.3, 6.1.12, 6.1.13).
#[test]
fn what_is_asked_for_is_what_was_set() {
    let mut c = es();
    let (mut color, mut value) = ([0.0; 4], [0]);
    c.clear_color(0.5, -0.5, 2.0, 1.0);
    c.get_floatv(GL_COLOR_CLEAR_VALUE, &mut color);
    assert_eq!(color, [0.5, -0.5, 2.0, 1.0]);
    c.blend_color(0.5, -0.5, 2.0, 1.0);
    c.get_floatv(GL_BLEND_COLOR, &mut color);
    assert_eq!(color, [0.5, -0.5, 2.0, 1.0]);
    c.vertex_attrib_4f(0, 1.0, 2.0, 3.0, 4.0);
    c.get_vertex_attribfv(0, GL_CURRENT_VERTEX_ATTRIB, &mut color);
    assert_eq!(color, [1.0, 2.0, 3.0, 4.0]);
    let mut name = [0];
    c.gen_renderbuffers(1, &mut name);
    c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
    c.get_renderbuffer_parameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT, &mut value);
    assert_eq!(value[0] as u32, GL_RGBA4);
    let ty = asked(&mut c, GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE);
    assert_eq!(ty as u32, GL_UNSIGNED_INT);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

/// Levels of a mutable texture are drawn to if they are sampled, or the base level (OpenGL ES 3.0, section 4.4.4.1).
#[test]
fn attached_levels_are_those_of_a_complete_pyramid() {
    let rgba = (GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
    let status = |levels: &[(GLint, GLsizei)], (base, max): (GLint, GLint), attached: GLint| {
        let mut c = es();
        let name = texture(&mut c, rgba.0, rgba.1, rgba.2);
        for &(level, side) in levels {
            image(&mut c, level, side, rgba);
        }
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, base);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, max);
        framebuffer(&mut c, GL_FRAMEBUFFER, name, attached);
        let status = c.check_framebuffer_status(GL_FRAMEBUFFER);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
        status == GL_FRAMEBUFFER_COMPLETE
    };
    let all = [(1, 4), (2, 2), (3, 1)];
    assert!(status(&all, (0, 1000), 0) && status(&all, (0, 1000), 3));
    // A level is missing, or does not fit; the base level is drawn to all the same.
    assert!(!status(&all[..2], (0, 1000), 1) && status(&all[..2], (0, 1000), 0));
    assert!(!status(&[(1, 2)], (0, 1), 1) && status(&all[..1], (0, 1), 1));
    // Levels that are not sampled.
    assert!(!status(&all, (0, 1), 2) && !status(&all, (2, 3), 1) && status(&all, (2, 3), 3));
}

const CAPTURE: &str =
    "#version 300 es\nin vec4 a; flat out vec4 o; void main() { o = a; gl_Position = vec4(0.0); }";

/// A program that captures the attribute 0, in use, and a buffer for so many vertices.
fn capture(c: &mut Context, vertices: usize) {
    let program = c.create_program();
    let fragment = "#version 300 es\nvoid main() {}";
    for (ty, text) in [(GL_VERTEX_SHADER, CAPTURE), (GL_FRAGMENT_SHADER, fragment)] {
        let shader = c.create_shader(ty);
        c.shader_source(shader, 1, Strings(vec![text]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
    }
    c.transform_feedback_varyings(program, 1, Names(vec!["o"]), GL_INTERLEAVED_ATTRIBS);
    c.link_program(program);
    c.use_program(program);
    let mut buffer = [0];
    c.gen_buffers(1, &mut buffer);
    c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer[0]);
    let size = (vertices * 16) as isize;
    c.buffer_data(
        GL_TRANSFORM_FEEDBACK_BUFFER,
        size,
        vec![0_u8; vertices * 16][..].arg(),
        GL_STREAM_READ,
    );
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

/// What does not fit into the buffers is an error of the draw, and nothing is captured (OpenGL ES 3.0, section 2.14.2).
#[test]
fn draws_of_transform_feedback_have_the_mode_and_room() {
    let mut c = es();
    capture(&mut c, 8);
    c.begin_transform_feedback(GL_TRIANGLES);
    let indices: [u8; 3] = [0, 1, 2];
    let by_index = |c: &mut Context| {
        c.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, indices[..].arg());
        c.get_error()
    };
    assert_eq!(by_index(&mut c), GL_INVALID_OPERATION);
    for mode in [GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_LINES] {
        c.draw_arrays(mode, 0, 3);
        assert_eq!(c.get_error(), GL_INVALID_OPERATION, "{mode}");
    }
    // Three triangles do not fit. Vertices that make no triangle do not count.
    c.draw_arrays_instanced(GL_TRIANGLES, 0, 3, 3);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    let message = c.messages().last().map(ToString::to_string).unwrap_or_default();
    assert!(message.contains("no room for 9 vertices"), "{message}");
    c.draw_arrays(GL_TRIANGLES, 0, 5);
    c.draw_arrays(GL_TRIANGLES, 0, 3);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    c.draw_arrays(GL_TRIANGLES, 0, 3);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    c.pause_transform_feedback();
    assert_eq!(by_index(&mut c), GL_NO_ERROR);
    c.end_transform_feedback();
    // OpenGL captures what fits.
    let mut c = context(Api::Compatibility);
    let vertex =
        "#version 130\nin vec4 a; flat out vec4 o; void main() { o = a; gl_Position = vec4(0.0); }";
    let program = use_program(&mut c, vertex, "");
    c.transform_feedback_varyings(program, 1, Names(vec!["o"]), GL_INTERLEAVED_ATTRIBS);
    c.link_program(program);
    let mut buffer = [0];
    c.gen_buffers(1, &mut buffer);
    c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer[0]);
    c.buffer_data(GL_TRANSFORM_FEEDBACK_BUFFER, 16, [0_u8; 16][..].arg(), GL_STREAM_READ);
    c.begin_transform_feedback(GL_TRIANGLES);
    c.draw_arrays(GL_TRIANGLES, 0, 3);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

/// Signed integers that are fractions have a zero (OpenGL ES 3.0, equation 2.2).
#[test]
fn signed_fractions_of_vertex_arrays_have_a_zero() {
    let cases: [(GLenum, &[u8], [f32; 4]); 4] = [
        (GL_BYTE, &[0x80, 0x81, 0, 0x7F], [-1.0, -1.0, 0.0, 1.0]),
        (GL_SHORT, &[0, 0x80, 1, 0x80, 0, 0, 0xFF, 0x7F], [-1.0, -1.0, 0.0, 1.0]),
        (
            GL_INT,
            &[0, 0, 0, 0x80, 1, 0, 0, 0x80, 0, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0x7F],
            [-1.0, -1.0, 0.0, 1.0],
        ),
        // -512, -511, 0 and -2.
        (GL_INT_2_10_10_10_REV, &[0, 6, 8, 0x80], [-1.0, -1.0, 0.0, -1.0]),
    ];
    for (ty, bytes, expected) in cases {
        let mut c = es();
        capture(&mut c, 1);
        c.enable_vertex_attrib_array(0);
        c.vertex_attrib_pointer(0, 4, ty, true, 0, bytes.arg());
        let mut is_normalized = [0];
        c.get_vertex_attribiv(0, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, &mut is_normalized);
        assert_eq!(is_normalized, [1]);
        c.begin_transform_feedback(GL_POINTS);
        c.draw_arrays(GL_POINTS, 0, 1);
        c.end_transform_feedback();
        c.map_buffer_range(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 16, GL_MAP_READ_BIT);
        let bytes = c.mapped_bytes(GL_TRANSFORM_FEEDBACK_BUFFER).expect("it is mapped");
        let found: Vec<f32> = bytes
            .chunks_exact(4)
            .map(|word| f32::from_le_bytes([word[0], word[1], word[2], word[3]]))
            .collect();
        assert_eq!(found, expected, "{ty:#x}");
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    }
}

/// Half floats have a value of their own in `OES_vertex_half_float`.
#[test]
fn half_floats_of_vertex_arrays_have_two_names() {
    for ty in [GL_HALF_FLOAT, GL_HALF_FLOAT_OES] {
        let mut c = es();
        capture(&mut c, 1);
        c.enable_vertex_attrib_array(0);
        let halves: &[u8] = &[0, 0x3C, 0, 0xC1];
        c.vertex_attrib_pointer(0, 2, ty, false, 0, halves.arg());
        c.begin_transform_feedback(GL_POINTS);
        c.draw_arrays(GL_POINTS, 0, 1);
        c.end_transform_feedback();
        c.map_buffer_range(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 8, GL_MAP_READ_BIT);
        let bytes = c.mapped_bytes(GL_TRANSFORM_FEEDBACK_BUFFER).expect("it is mapped").to_vec();
        assert_eq!(bytes[..4], 1.0_f32.to_le_bytes(), "{ty:#x}");
        assert_eq!(bytes[4..8], (-2.5_f32).to_le_bytes(), "{ty:#x}");
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    }
    let mut c = context(Api::Compatibility);
    c.vertex_attrib_pointer(0, 2, GL_HALF_FLOAT_OES, false, 0, Data::Null);
    assert_eq!(c.get_error(), GL_INVALID_ENUM);
}

/// Depths of sized formats are filtered only as they are compared (OpenGL ES 3.0, section 3.8.13).
#[test]
fn depths_that_are_not_compared_are_not_filtered() {
    let vertex = "#version 300 es\n\
        void main() {\n\
          vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n\
          gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);\n\
        }";
    let fragment = "#version 300 es\n\
        precision highp float;\n\
        uniform sampler2D image;\n\
        out vec4 color;\n\
        void main() { color = texture(image, vec2(0.5)); }";
    let red = |internal: GLenum, filter: GLenum| {
        let mut c = es();
        use_program(&mut c, vertex, fragment);
        texture(&mut c, internal, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter as i32);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter as i32);
        c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
        let mut pixel = [0; 4];
        c.read_pixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
        pixel[0]
    };
    assert_eq!(red(GL_DEPTH_COMPONENT16, GL_NEAREST), 60);
    assert_eq!(red(GL_DEPTH_COMPONENT16, GL_LINEAR), 0);
    // OES_depth_texture filters its unsized format.
    assert_eq!(red(GL_DEPTH_COMPONENT, GL_LINEAR), 60);
}

/// Beyond the edge lies a colour (`EXT_texture_border_clamp`).
#[test]
fn textures_and_samplers_have_borders() {
    let vertex = "#version 300 es\n\
        void main() {\n\
          vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n\
          gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);\n\
        }";
    let fragment = "#version 300 es\n\
        precision highp float;\n\
        uniform sampler2D image;\n\
        out vec4 color;\n\
        void main() { color = texture(image, vec2(1.5)); }";
    let mut c = es();
    use_program(&mut c, vertex, fragment);
    texture(&mut c, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
    for (pname, value) in [
        (GL_TEXTURE_MIN_FILTER, GL_NEAREST),
        (GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER),
        (GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER),
    ] {
        c.tex_parameteri(GL_TEXTURE_2D, pname, value as i32);
    }
    c.tex_parameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[1.0, 0.0, 0.2, 1.0]);
    c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
    let mut pixel = [0; 4];
    c.read_pixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!(pixel, [255, 0, 51, 255]);
    let mut sampler = [0];
    c.gen_samplers(1, &mut sampler);
    c.sampler_parameter_i_iv(sampler[0], GL_TEXTURE_BORDER_COLOR, &[1, -2, 3, 4]);
    let mut border = [0; 4];
    c.get_sampler_parameter_i_iv(sampler[0], GL_TEXTURE_BORDER_COLOR, &mut border);
    assert_eq!(border, [1, -2, 3, 4]);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}
