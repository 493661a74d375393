//! Values of enums that OpenGL ES 3.0 does not have, by whichever call they come; values that it shares with other enums;
//! and what is asked of formats, storage and integers.

#[path = "common/shading.rs"]
mod shading;

use gl_api::*;
use shading::use_program;

fn context(api: Api) -> Context {
    let version = Version::new(3, if api == Api::Es2 { 0 } else { 3 });
    Context::new(ContextDesc { api, version, width: 8, height: 8, ..ContextDesc::default() })
        .expect("a device")
}

fn es() -> Context {
    context(Api::Es2)
}

fn texture(c: &mut Context, target: GLenum) -> GLuint {
    let mut name = [0];
    c.gen_textures(1, &mut name);
    c.bind_texture(target, name[0]);
    name[0]
}

fn parameter(c: &mut Context, pname: GLenum) -> GLint {
    let mut value = [-1];
    c.get_tex_parameteriv(GL_TEXTURE_2D, pname, &mut value);
    value[0]
}

/// The calls that set a wrap mode, of the bound texture and of a sampler object.
type SetMode = fn(&mut Context, GLuint, GLenum);
const SET_MODE: &[(&str, SetMode)] = &[
    ("i", |c, _, mode| c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, mode as i32)),
    ("f", |c, _, mode| c.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, mode as f32)),
    ("iv", |c, _, mode| c.tex_parameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &[mode as i32])),
    ("fv", |c, _, mode| c.tex_parameterfv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &[mode as f32])),
    ("sampler i", |c, s, mode| c.sampler_parameteri(s, GL_TEXTURE_WRAP_S, mode as i32)),
    ("sampler f", |c, s, mode| c.sampler_parameterf(s, GL_TEXTURE_WRAP_S, mode as f32)),
    ("sampler iv", |c, s, mode| c.sampler_parameteriv(s, GL_TEXTURE_WRAP_S, &[mode as i32])),
    ("sampler fv", |c, s, mode| c.sampler_parameterfv(s, GL_TEXTURE_WRAP_S, &[mode as f32])),
];

#[test]
fn wrap_modes_are_refused_by_every_call() {
    let es_has_not = [GL_CLAMP, GL_MIRROR_CLAMP_EXT, GL_MIRROR_CLAMP_TO_BORDER_EXT];
    for (api, modes) in [(Api::Es2, &es_has_not[..]), (Api::Core, &[GL_CLAMP])] {
        let mut c = context(api);
        texture(&mut c, GL_TEXTURE_2D);
        let mut sampler = [0];
        c.gen_samplers(1, &mut sampler);
        for (call, set) in SET_MODE {
            for &mode in modes {
                set(&mut c, sampler[0], mode);
                assert_eq!(c.get_error(), GL_INVALID_ENUM, "{api:?}, {call}, {mode:#x}");
            }
            assert_eq!(parameter(&mut c, GL_TEXTURE_WRAP_S), GL_REPEAT as i32);
            set(&mut c, sampler[0], GL_REPEAT);
            assert_eq!(c.get_error(), GL_NO_ERROR, "{api:?}, {call}");
        }
    }
}

/// From `GL_TEXTURE32` on, units have the values of other enums.
#[test]
fn every_unit_can_be_active() {
    for api in [Api::Es2, Api::Core, Api::Compatibility] {
        let mut c = context(api);
        let mut count = [0];
        c.get_integerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &mut count);
        for unit in 0..count[0] as GLenum {
            c.active_texture(GL_TEXTURE0 + unit);
            let mut active = [0];
            c.get_integerv(GL_ACTIVE_TEXTURE, &mut active);
            assert_eq!(c.get_error(), GL_NO_ERROR, "{api:?}, unit {unit}");
            assert_eq!(active[0] as GLenum, GL_TEXTURE0 + unit, "{api:?}");
        }
        c.active_texture(GL_TEXTURE0 + count[0] as GLenum);
        assert_eq!(c.get_error(), GL_INVALID_ENUM, "{api:?}");
    }
}

/// `GL_LIGHT0` is `GL_COLOR_BUFFER_BIT`, and targets of textures are enums of every profile.
#[test]
fn capabilities_of_the_fixed_function_are_not_asked_for() {
    let capabilities =
        [GL_LIGHT0, GL_LIGHT7, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, GL_VERTEX_ARRAY];
    for api in [Api::Es2, Api::Core] {
        let mut c = context(api);
        for capability in capabilities {
            assert!(!c.is_enabled(capability));
            assert_eq!(c.get_error(), GL_INVALID_ENUM, "{api:?}, {capability:#x}");
            c.enable(capability);
            assert_eq!(c.get_error(), GL_INVALID_ENUM, "{api:?}, {capability:#x}");
            c.get_integerv(capability, &mut [0; 16]);
            assert_eq!(c.get_error(), GL_INVALID_ENUM, "{api:?}, {capability:#x}");
        }
    }
}

#[test]
fn only_indexed_buffers_have_indexed_state() {
    let mut c = es();
    let buffers = [
        GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
        GL_TRANSFORM_FEEDBACK_BUFFER_START,
        GL_TRANSFORM_FEEDBACK_BUFFER_SIZE,
        GL_UNIFORM_BUFFER_BINDING,
        GL_UNIFORM_BUFFER_START,
        GL_UNIFORM_BUFFER_SIZE,
    ];
    for target in buffers {
        c.get_integeri_v(target, 0, &mut [0; 4]);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{target:#x}");
    }
    let others =
        [GL_BLEND, GL_COLOR_WRITEMASK, GL_BLEND_SRC_RGB, GL_TEXTURE_BINDING_2D, GL_VIEWPORT];
    for target in others {
        c.get_integeri_v(target, 0, &mut [0; 4]);
        assert_eq!(c.get_error(), GL_INVALID_ENUM, "{target:#x}");
    }
}

/// A format of two components that only OpenGL has, and that the registry does not know.
#[test]
fn blocks_of_3dc_are_opengls_alone() {
    let mut c = es();
    texture(&mut c, GL_TEXTURE_2D);
    let blocks: &[u8] = &[0; 16];
    let format = GL_COMPRESSED_LUMINANCE_ALPHA_3DC_ATI;
    c.compressed_tex_image_2d(GL_TEXTURE_2D, 0, format, 4, 4, 0, 16, blocks.arg());
    assert_eq!(c.get_error(), GL_INVALID_ENUM);
    let format = GL_COMPRESSED_RGBA_S3TC_DXT5_EXT;
    c.compressed_tex_image_2d(GL_TEXTURE_2D, 0, format, 4, 4, 0, 16, blocks.arg());
    assert_eq!(c.get_error(), GL_NO_ERROR);
}

#[test]
fn a_cube_map_has_no_layers() {
    let mut c = es();
    let cube = texture(&mut c, GL_TEXTURE_CUBE_MAP);
    c.tex_storage_2d(GL_TEXTURE_CUBE_MAP, 1, GL_RGBA8, 4, 4);
    let mut framebuffer = [0];
    c.gen_framebuffers(1, &mut framebuffer);
    c.bind_framebuffer(GL_FRAMEBUFFER, framebuffer[0]);
    c.framebuffer_texture_layer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, cube, 0, 0);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION);
    assert_eq!(
        c.check_framebuffer_status(GL_FRAMEBUFFER),
        GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT
    );
}

#[test]
fn samples_of_unsized_formats_are_known() {
    let mut c = es();
    let mut most = [0];
    c.get_integerv(GL_MAX_SAMPLES, &mut most);
    for format in [GL_RGB, GL_RGBA, GL_RGBA8] {
        let (mut count, mut samples) = ([-1], [-1]);
        c.get_internalformativ(GL_RENDERBUFFER, format, GL_NUM_SAMPLE_COUNTS, 1, &mut count);
        c.get_internalformativ(GL_RENDERBUFFER, format, GL_SAMPLES, 1, &mut samples);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{format:#x}");
        assert_eq!((count, samples), ([1], most), "{format:#x}");
    }
    c.get_internalformativ(GL_RENDERBUFFER, GL_LUMINANCE, GL_SAMPLES, 1, &mut [0]);
    assert_eq!(c.get_error(), GL_INVALID_ENUM);
}

const VERTEX: &str = "#version 300 es
    out highp vec2 at;
    void main() {
        vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
        at = corner;
        gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
    }";

/// Base and largest level are bounded where they are used, so that the order in which they are set does not matter.
#[test]
fn levels_of_immutable_storage_are_bounded_where_they_are_used() {
    let mut c = es();
    texture(&mut c, GL_TEXTURE_2D);
    c.tex_storage_2d(GL_TEXTURE_2D, 3, GL_RGBA8, 4, 4);
    for (level, side) in [(0, 4), (1, 2), (2, 1)] {
        let texels: &[u8] = &[50 * (level as u8 + 1); 64];
        let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
        c.tex_sub_image_2d(GL_TEXTURE_2D, level, 0, 0, side, side, format, ty, texels.arg());
    }
    assert_eq!(parameter(&mut c, GL_TEXTURE_MAX_LEVEL), 1000);
    let fragment = "#version 300 es
        precision highp float;
        uniform highp sampler2D levels;
        uniform float lod;
        out vec4 color;
        void main() { color = textureLod(levels, vec2(0.5), lod); }";
    let program = use_program(&mut c, VERTEX, fragment);
    let lod = c.get_uniform_location(program, "lod");
    // Base level, largest level, λ, and the level that is read.
    let table = [(7, 1000, 0.0, 2), (7, 0, 5.0, 2), (0, 0, 5.0, 0), (0, 1, 5.0, 1), (1, 9, 0.0, 1)];
    for (base, most, lambda, read) in table {
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, base);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, most);
        c.uniform_1f(lod, lambda);
        c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
        let mut pixel = [0_u8; 4];
        c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, (&mut pixel).arg());
        assert_eq!(pixel[0], 50 * (read + 1), "base {base}, largest {most}, λ {lambda}");
    }
}

/// Integers whose bits are those of signalling NaN, of infinity and of -0 as `f32` are sampled as they are.
#[test]
fn every_integer_is_sampled_as_it_is() {
    let mut c = es();
    let texels: Vec<u32> = (0..64)
        .map(|at| [0x7F80_0001, 0xFFB8_1234, 0x8000_0000, 0x7F80_0000, 7][at as usize % 5] + at % 3)
        .collect();
    let mut names = [0];
    c.gen_renderbuffers(1, &mut names);
    c.bind_renderbuffer(GL_RENDERBUFFER, names[0]);
    c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA32UI, 8, 8);
    let mut framebuffer = [0];
    c.gen_framebuffers(1, &mut framebuffer);
    c.bind_framebuffer(GL_FRAMEBUFFER, framebuffer[0]);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[0]);
    texture(&mut c, GL_TEXTURE_2D);
    let (format, ty) = (GL_RED_INTEGER, GL_UNSIGNED_INT);
    c.tex_image_2d(GL_TEXTURE_2D, 0, GL_R32UI as i32, 8, 8, 0, format, ty, texels.as_slice().arg());
    for filter in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
        c.tex_parameteri(GL_TEXTURE_2D, filter, GL_NEAREST as i32);
    }
    let fragment = "#version 300 es
        precision highp float;
        uniform highp usampler2D numbers;
        in vec2 at;
        out highp uvec4 color;
        void main() { color = texture(numbers, at); }";
    use_program(&mut c, VERTEX, fragment);
    c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
    let mut pixels = [0_u32; 256];
    c.read_pixels(0, 0, 8, 8, GL_RGBA_INTEGER, GL_UNSIGNED_INT, (&mut pixels).arg());
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    let red: Vec<u32> = pixels.chunks(4).map(|pixel| pixel[0]).collect();
    assert_eq!(red, texels);
}

fn integer(c: &mut Context, pname: GLenum) -> GLint {
    let mut value = [-1; 4];
    c.get_integerv(pname, &mut value);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{pname:#x}");
    value[0]
}

#[test]
fn versions_and_limits_are_those_of_es() {
    let mut c = es();
    assert_eq!([GL_MAJOR_VERSION, GL_MINOR_VERSION].map(|pname| integer(&mut c, pname)), [3, 0]);
    // gl_MaxVertexOutputVectors and gl_MaxFragmentInputVectors, as shaders see them.
    let fragment = "#version 300 es
        precision highp float;
        out vec4 color;
        void main() {
            color = vec4(gl_MaxVertexOutputVectors, gl_MaxFragmentInputVectors, 0, 255) / 255.0;
        }";
    use_program(&mut c, VERTEX, fragment);
    c.draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
    let mut pixel = [0_u8; 4];
    c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, (&mut pixel).arg());
    for (at, pname) in
        [GL_MAX_VERTEX_OUTPUT_COMPONENTS, GL_MAX_FRAGMENT_INPUT_COMPONENTS].into_iter().enumerate()
    {
        assert_eq!(integer(&mut c, pname), i32::from(pixel[at]) * 4, "{pname:#x}");
    }
}

/// Every format that an image of blocks may have.
#[test]
fn formats_of_blocks_are_listed() {
    let mut c = es();
    let count = integer(&mut c, GL_NUM_COMPRESSED_TEXTURE_FORMATS) as usize;
    let mut listed = vec![0; count];
    c.get_integerv(GL_COMPRESSED_TEXTURE_FORMATS, &mut listed);
    texture(&mut c, GL_TEXTURE_2D);
    for format in 0..0x1_0000 {
        c.compressed_tex_image_2d(GL_TEXTURE_2D, 0, format, 0, 0, 0, 0, NULL.arg());
        let is_taken = c.get_error() == GL_NO_ERROR;
        assert_eq!(is_taken, listed.contains(&(format as i32)), "{format:#x}");
    }
}

/// Only shaders of version 1.00 may have two attributes at one location.
#[test]
fn attributes_of_version_300_have_locations_of_their_own() {
    let bodies = [
        ("#version 100\nattribute vec4 a, b;", "#version 100\nvoid main() {}", true),
        ("#version 300 es\nin vec4 a, b;", "#version 300 es\nvoid main() {}", false),
    ];
    for (declarations, fragment, links) in bodies {
        let mut c = es();
        let vertex = format!("{declarations} void main() {{ gl_Position = a + b; }}");
        let program = c.create_program();
        for (stage, source) in [(GL_VERTEX_SHADER, &*vertex), (GL_FRAGMENT_SHADER, fragment)] {
            let shader = c.create_shader(stage);
            c.shader_source(shader, 1, Strings(vec![source]), &[]);
            c.compile_shader(shader);
            c.attach_shader(program, shader);
        }
        c.bind_attrib_location(program, 3, "a");
        c.bind_attrib_location(program, 3, "b");
        let linked = |c: &mut Context| {
            let mut status = [-1];
            c.link_program(program);
            c.get_programiv(program, GL_LINK_STATUS, &mut status);
            status[0] == 1
        };
        assert_eq!(linked(&mut c), links, "{declarations}");
        c.bind_attrib_location(program, 4, "b");
        assert!(linked(&mut c), "{declarations}");
    }
}

/// What a full-window draw with the bound texture gives.
fn sampled(c: &mut Context) -> [u8; 4] {
    let vertex = "#version 300 es
        void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }";
    let fragment = "#version 300 es
        precision mediump float;
        uniform sampler2D image;
        out vec4 color;
        void main() { color = texture(image, vec2(0.5)); }";
    use_program(c, vertex, fragment);
    c.draw_arrays(GL_TRIANGLES, 0, 3);
    let mut pixel = [0; 4];
    c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    pixel
}

/// An internal format, `format` and `type`, a texel, and what is sampled of it.
type SampledFormat<'a> = (GLenum, GLenum, GLenum, &'a [u8], [u8; 4]);

#[test]
fn required_internal_formats_are_there() {
    let mut c = es();
    let (byte, ten) = (GL_UNSIGNED_BYTE, GL_UNSIGNED_INT_2_10_10_10_REV);
    let thirds = (341_u32 | 682 << 10 | 1023 << 20).to_le_bytes();
    let rows: [SampledFormat<'_>; 5] = [
        (GL_ALPHA8, GL_ALPHA, byte, &[0x5a], [0, 0, 0, 0x5a]),
        (GL_LUMINANCE8, GL_LUMINANCE, byte, &[0x5a], [0x5a, 0x5a, 0x5a, 255]),
        (GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, byte, &[1, 2], [1, 1, 1, 2]),
        (GL_LUMINANCE4_ALPHA4, GL_LUMINANCE_ALPHA, byte, &[0x33, 0xcc], [0x33, 0x33, 0x33, 0xcc]),
        (GL_RGB10, GL_RGB, ten, &thirds, [85, 170, 255, 255]),
    ];
    for (internal, format, ty, texel, expected) in rows {
        texture(&mut c, GL_TEXTURE_2D);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR as GLint);
        let (stored, data) = (internal as GLint, Data::Bytes(texel));
        c.tex_image_2d(GL_TEXTURE_2D, 0, stored, 1, 1, 0, format, ty, data);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{internal:#x}");
        assert_eq!(sampled(&mut c), expected, "{internal:#x}");
        c.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 1, 1, format, ty, data);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{internal:#x}");
        // The type of another format, a format with other channels, a renderbuffer.
        c.tex_image_2d(GL_TEXTURE_2D, 0, stored, 1, 1, 0, format, GL_FLOAT, Data::Null);
        assert_eq!(c.get_error(), GL_INVALID_OPERATION, "{internal:#x}");
        c.tex_image_2d(GL_TEXTURE_2D, 0, stored, 1, 1, 0, GL_RGBA, byte, Data::Null);
        assert_eq!(c.get_error(), GL_INVALID_OPERATION, "{internal:#x}");
        let mut renderbuffer = [0];
        c.gen_renderbuffers(1, &mut renderbuffer);
        c.bind_renderbuffer(GL_RENDERBUFFER, renderbuffer[0]);
        c.renderbuffer_storage(GL_RENDERBUFFER, internal, 1, 1);
        assert_eq!(c.get_error(), GL_INVALID_ENUM, "{internal:#x}");
    }
    // From the window, whose components have 8 bits.
    c.clear_color(0.2, 0.4, 0.6, 0.8);
    let copied = [
        (GL_ALPHA8, [0, 0, 0, 204]),
        (GL_LUMINANCE8, [51, 51, 51, 255]),
        (GL_LUMINANCE8_ALPHA8, [51, 51, 51, 204]),
    ];
    for (internal, expected) in copied {
        c.clear(GL_COLOR_BUFFER_BIT);
        c.copy_tex_image_2d(GL_TEXTURE_2D, 0, internal, 0, 0, 1, 1, 0);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{internal:#x}");
        assert_eq!(sampled(&mut c), expected, "{internal:#x}");
    }
    // No extension has these.
    for internal in [GL_ALPHA16, GL_LUMINANCE6_ALPHA2, GL_INTENSITY8, GL_RGB12] {
        let (stored, data) = (internal as GLint, Data::Null);
        c.tex_image_2d(GL_TEXTURE_2D, 0, stored, 1, 1, 0, GL_RGBA, byte, data);
        assert_eq!(c.get_error(), GL_INVALID_VALUE, "{internal:#x}");
    }
}
