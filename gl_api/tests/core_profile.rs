//! Core contexts (GL 3.3, appendix E): what they refuse, with which words, and that they draw.

#[path = "common/shading.rs"]
mod shading;

use gl_api::*;
use shading::use_program;

fn context(api: Api) -> Context {
    let desc = ContextDesc {
        api,
        version: Version::new(3, 3),
        width: 8,
        height: 8,
        ..ContextDesc::default()
    };
    Context::new(desc).expect("a device")
}

/// The last message.
fn message(c: &mut Context) -> String {
    c.messages().last().map(ToString::to_string).unwrap_or_default()
}

type Call = fn(&mut Context);

/// Calls that core contexts refuse and compatibility contexts do not; the error, and words of the message.
const REMOVED: &[(&str, Call, GLenum, &str)] = &[
    ("a command", |c| c.begin(GL_TRIANGLES), GL_INVALID_OPERATION, "glDrawArrays"),
    ("an attribute", |c| c.color_3f(1.0, 0.0, 0.0), GL_INVALID_OPERATION, "removed from core"),
    ("matrices", |c| c.load_identity(), GL_INVALID_OPERATION, "glUniformMatrix4fv"),
    ("lists", |c| c.new_list(1, GL_COMPILE), GL_INVALID_OPERATION, "vertex array objects"),
    ("a capability", |c| c.enable(GL_LIGHTING), GL_INVALID_ENUM, "shaders"),
    ("textures of the fixed function", |c| c.enable(GL_TEXTURE_2D), GL_INVALID_ENUM, "glEnable"),
    ("a mode", |c| c.draw_arrays(GL_QUADS, 0, 0), GL_INVALID_ENUM, "draw triangles"),
    (
        "a wrap mode",
        |c| c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP as i32),
        GL_INVALID_ENUM,
        "GL_CLAMP_TO_EDGE",
    ),
    (
        "a parameter of textures",
        |c| c.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1),
        GL_INVALID_ENUM,
        "glGenerateMipmap",
    ),
    (
        "an internal format",
        |c| image(c, GL_LUMINANCE as i32, 0, GL_RGBA),
        GL_INVALID_VALUE,
        "GL_TEXTURE_SWIZZLE_RGBA",
    ),
    ("a number of components", |c| image(c, 4, 0, GL_RGBA), GL_INVALID_VALUE, "GL_RGBA8"),
    ("a border", |c| image(c, GL_RGBA8 as i32, 1, GL_RGBA), GL_INVALID_VALUE, "GL_CLAMP_TO_BORDER"),
    (
        "a format of pixels",
        |c| image(c, GL_RGBA8 as i32, 0, GL_LUMINANCE),
        GL_INVALID_ENUM,
        "GL_RED",
    ),
    ("one face", |c| c.polygon_mode(GL_FRONT, GL_LINE), GL_INVALID_ENUM, "GL_FRONT_AND_BACK"),
    (
        "state",
        |c| c.get_floatv(GL_MODELVIEW_MATRIX, &mut [0.0; 16]),
        GL_INVALID_ENUM,
        "glUniformMatrix4fv",
    ),
    ("state of a unit", |c| c.get_integerv(GL_TEXTURE_2D, &mut [0]), GL_INVALID_ENUM, "removed"),
    (
        "all extensions",
        |c| {
            c.get_string(GL_EXTENSIONS);
        },
        GL_INVALID_ENUM,
        "glGetStringi",
    ),
    (
        "a texture's name",
        |c| c.bind_texture(GL_TEXTURE_2D, 77),
        GL_INVALID_OPERATION,
        "glGenTextures",
    ),
    (
        "a buffer's name",
        |c| c.bind_buffer(GL_ARRAY_BUFFER, 77),
        GL_INVALID_OPERATION,
        "glGenBuffers",
    ),
    (
        "a framebuffer's name",
        |c| c.bind_framebuffer(GL_FRAMEBUFFER, 77),
        GL_INVALID_OPERATION,
        "glGenFramebuffers",
    ),
    (
        "arrays without an object",
        |c| c.enable_vertex_attrib_array(0),
        GL_INVALID_OPERATION,
        "glBindVertexArray",
    ),
    (
        "draws without an object",
        |c| c.draw_arrays(GL_TRIANGLES, 0, 0),
        GL_INVALID_OPERATION,
        "glBindVertexArray",
    ),
];

fn image(c: &mut Context, internal: i32, border: i32, format: GLenum) {
    let side = 2 + 2 * border;
    let texels = [0_u8; 64];
    c.tex_image_2d(
        GL_TEXTURE_2D,
        0,
        internal,
        side,
        side,
        border,
        format,
        GL_UNSIGNED_BYTE,
        texels[..].arg(),
    );
}

#[test]
fn what_was_removed_is_refused_with_what_takes_its_place() {
    for &(what, call, error, words) in REMOVED {
        let mut core = context(Api::Core);
        call(&mut core);
        assert_eq!(core.get_error(), error, "{what}: {}", message(&mut core));
        let text = message(&mut core);
        assert!(text.contains(words), "{what}: {text}");

        let mut compatibility = context(Api::Compatibility);
        call(&mut compatibility);
        if what == "a command" {
            compatibility.end();
        }
        assert_eq!(compatibility.get_error(), GL_NO_ERROR, "{what} in the compatibility profile");
    }
}

#[test]
fn the_profile_can_be_asked_for() {
    for (api, bit, name) in [
        (Api::Core, GL_CONTEXT_CORE_PROFILE_BIT, "3.3 (Core Profile)"),
        (Api::Compatibility, GL_CONTEXT_COMPATIBILITY_PROFILE_BIT, "3.3 (Compatibility Profile)"),
    ] {
        let mut c = context(api);
        let mut mask = [0];
        c.get_integerv(GL_CONTEXT_PROFILE_MASK, &mut mask);
        assert_eq!(mask[0] as u32, bit);
        assert!(c.get_string(GL_VERSION).starts_with(name));
        assert_eq!(c.get_string(GL_SHADING_LANGUAGE_VERSION), "3.30");
        let mut count = [0];
        c.get_integerv(GL_NUM_EXTENSIONS, &mut count);
        let names: Vec<&str> =
            (0..count[0]).map(|at| c.get_stringi(GL_EXTENSIONS, at as u32)).collect();
        assert_eq!(names.contains(&"GL_ARB_compatibility"), api == Api::Compatibility);
        assert!(names.contains(&"GL_ARB_texture_storage"));
        assert_eq!(c.get_error(), GL_NO_ERROR);
    }
}

#[test]
fn versions_and_apis_that_are_not_there_are_refused() {
    let of = |api, major, minor| {
        let version = Version::new(major, minor);
        Context::new(ContextDesc { api, version, ..ContextDesc::default() })
    };
    let error = of(Api::Core, 4, 0).expect_err("there is no 4.0").to_string();
    assert!(error.contains("4.0") && error.contains("3.3"), "{error}");
    let error = of(Api::Es1, 1, 1).expect_err("there is no OpenGL ES 1.1").to_string();
    assert!(error.contains("Es1"), "{error}");
}

#[test]
fn forward_compatible_contexts_have_no_wide_lines() {
    for (forward_compatible, error) in
        [(ForwardCompatible::No, GL_NO_ERROR), (ForwardCompatible::Yes, GL_INVALID_VALUE)]
    {
        let desc = ContextDesc { api: Api::Core, forward_compatible, ..ContextDesc::default() };
        let mut c = Context::new(desc).expect("a device");
        c.line_width(2.0);
        assert_eq!(c.get_error(), error);
    }
}

const QUAD: &str = "#version 330 core\n\
    void main() {\n\
      vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n\
      gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);\n\
      gl_PointSize = 8.0;\n\
    }";

fn pixel(c: &mut Context) -> [u8; 4] {
    let mut pixel = [0; 4];
    c.read_pixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    pixel
}

#[test]
fn a_core_context_draws_what_a_vertex_array_object_has() {
    let mut c = context(Api::Core);
    let fragment = "#version 330 core\n\
        uniform sampler2D depth;\n\
        layout(location = 0) out vec4 color;\n\
        void main() { color = texture(depth, vec2(0.5)); }";
    use_program(&mut c, QUAD, fragment);
    // A depth texture is read as red.
    let mut names = [0];
    c.gen_textures(1, &mut names);
    c.bind_texture(GL_TEXTURE_2D, names[0]);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32);
    let depth = [1.0_f32];
    c.tex_image_2d(
        GL_TEXTURE_2D,
        0,
        GL_DEPTH_COMPONENT24 as i32,
        1,
        1,
        0,
        GL_DEPTH_COMPONENT,
        GL_FLOAT,
        depth[..].arg(),
    );
    let mut arrays = [0];
    c.gen_vertex_arrays(1, &mut arrays);
    c.bind_vertex_array(arrays[0]);
    c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
    assert_eq!(pixel(&mut c), [255, 0, 0, 255]);
}

#[test]
fn points_of_core_contexts_have_coordinates() {
    let mut c = context(Api::Core);
    let fragment = "#version 330 core\n\
        out vec4 color;\n\
        void main() { color = vec4(gl_PointCoord, 0.0, 1.0); }";
    let vertex = "#version 330 core\n\
        void main() { gl_Position = vec4(0.0, 0.0, 0.0, 1.0); gl_PointSize = 8.0; }";
    use_program(&mut c, vertex, fragment);
    let mut arrays = [0];
    c.gen_vertex_arrays(1, &mut arrays);
    c.bind_vertex_array(arrays[0]);
    c.enable(GL_PROGRAM_POINT_SIZE);
    c.draw_arrays(GL_POINTS, 0, 1);
    // Pixel (4, 4) is right of and above the centre: s = 9/16, t = 7/16 from the top.
    assert_eq!(pixel(&mut c), [143, 112, 0, 255]);
}

#[test]
fn without_a_program_a_message_says_why_nothing_is_drawn() {
    let mut c = context(Api::Core);
    let mut arrays = [0];
    c.gen_vertex_arrays(1, &mut arrays);
    c.bind_vertex_array(arrays[0]);
    c.draw_arrays(GL_TRIANGLES, 0, 3);
    assert_eq!(c.get_error(), GL_NO_ERROR);
    assert!(message(&mut c).contains("glUseProgram"), "{}", message(&mut c));
}

/// `EXT_framebuffer_sRGB` is listed, and programs by `glium` ask whether there is such a framebuffer.
#[test]
fn core_contexts_say_whether_what_is_drawn_to_is_srgb() {
    let mut c = context(Api::Core);
    for (internal, want) in [(GL_RGBA8, GL_FALSE), (GL_SRGB8_ALPHA8, GL_TRUE)] {
        let mut names = [0; 2];
        c.gen_framebuffers(1, &mut names[..1]);
        c.gen_renderbuffers(1, &mut names[1..]);
        c.bind_framebuffer(GL_FRAMEBUFFER, names[0]);
        c.bind_renderbuffer(GL_RENDERBUFFER, names[1]);
        c.renderbuffer_storage(GL_RENDERBUFFER, internal, 2, 2);
        c.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[1]);
        let mut found = [7];
        c.get_booleanv(GL_FRAMEBUFFER_SRGB_CAPABLE_EXT, &mut found);
        assert_eq!((c.get_error(), found), (GL_NO_ERROR, [want as u8]));
    }
}

/// What programs look for in core contexts: the names, and that the values are taken.
#[test]
fn core_contexts_have_anisotropic_filters_and_seamless_textures() {
    let mut c = context(Api::Core);
    let mut count = [0];
    c.get_integerv(GL_NUM_EXTENSIONS, &mut count);
    let names: Vec<_> = (0..count[0] as u32).map(|at| c.get_stringi(GL_EXTENSIONS, at)).collect();
    for name in [
        "GL_ARB_invalidate_subdata",
        "GL_ARB_seamless_cubemap_per_texture",
        "GL_ARB_texture_barrier",
        "GL_ARB_texture_filter_anisotropic",
        "GL_EXT_texture_filter_anisotropic",
    ] {
        assert!(names.contains(&name), "{name}");
    }
    let mut texture = [0];
    c.gen_textures(1, &mut texture);
    c.bind_texture(GL_TEXTURE_CUBE_MAP, texture[0]);
    for (pname, set) in [(GL_TEXTURE_MAX_ANISOTROPY_EXT, 4), (GL_TEXTURE_CUBE_MAP_SEAMLESS, 1)] {
        c.tex_parameteri(GL_TEXTURE_CUBE_MAP, pname, set);
        let mut value = [0];
        c.get_tex_parameteriv(GL_TEXTURE_CUBE_MAP, pname, &mut value);
        assert_eq!((c.get_error(), value[0]), (GL_NO_ERROR, set));
    }
    let mut most = [0.0];
    c.get_floatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &mut most);
    assert_eq!((c.get_error(), most[0] >= 16.0), (GL_NO_ERROR, true));
    // What is invalidated is kept.
    c.invalidate_tex_image(texture[0], 0);
    c.texture_barrier();
    assert_eq!(c.get_error(), GL_NO_ERROR);
}
