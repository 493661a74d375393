//! Border colours of integers: every bit of them, of textures and of sampler objects, in shaders and
//! in queries.

use super::{context, drawn, program};
use gl_api::formats::{ComponentType, FORMATS, InternalFormat};
use gl_api::*;

/// Beyond what an `f32` holds, and each byte another.
const UINTS: [u32; 4] = [0xFFFF_FFFF, 0x0100_0001, 0x8000_0001, 0xFEDC_BA99];
const INTS: [i32; 4] = [i32::MIN, i32::MAX, -16_777_217, 16_777_219];

/// A texture of one texel, bound to unit 0, whose border a lookup at 2 gives.
fn integer_texture(internal: GLenum, ty: GLenum) {
    let t = GL_TEXTURE_2D;
    glDeleteTextures(1, &1);
    glBindTexture(t, 1);
    glTexParameteri(t, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(t, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(t, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexImage2D(t, 0, internal, 1, 1, 0, GL_RGBA_INTEGER, ty, &[0_u32; 4]);
}

/// The border's components as a shader has them, byte by byte.
fn sampled(kind: &str) -> [u32; 4] {
    let mut words = [0; 4];
    for (component, word) in words.iter_mut().enumerate() {
        let shader = format!(
            "#version 130
            uniform {kind}sampler2D s;
            void main() {{
                uint w = uint(texture(s, vec2(2.0, 0.5))[{component}]);
                gl_FragColor = vec4((uvec4(w) >> uvec4(0u, 8u, 16u, 24u)) & 255u) / 255.0;
            }}"
        );
        let program = program("void main() { gl_Position = gl_Vertex; }", &shader).unwrap();
        *word = u32::from_le_bytes(drawn(program));
        glUseProgram(0);
        glDeleteProgram(program);
    }
    words
}

#[test]
fn a_texture_has_the_border_that_was_set_to_the_bit() {
    let _current = context();
    let t = GL_TEXTURE_2D;
    integer_texture(GL_RGBA32UI, GL_UNSIGNED_INT);
    glTexParameterIuiv(t, GL_TEXTURE_BORDER_COLOR, &UINTS);
    assert_eq!(sampled("u"), UINTS);
    let mut back = [0; 4];
    glGetTexParameterIuiv(t, GL_TEXTURE_BORDER_COLOR, &mut back);
    assert_eq!(back, UINTS);

    integer_texture(GL_RGBA32I, GL_INT);
    glTexParameterIiv(t, GL_TEXTURE_BORDER_COLOR, &INTS);
    assert_eq!(sampled("i"), INTS.map(|c| c as u32));
    let mut back = [0; 4];
    glGetTexParameterIiv(t, GL_TEXTURE_BORDER_COLOR, &mut back);
    assert_eq!(back, INTS);
    assert_eq!(glGetError(), GL_NO_ERROR);
}

#[test]
fn a_sampler_object_has_it_too() {
    let _current = context();
    let mut sampler = 0;
    glGenSamplers(1, &mut sampler);
    for pname in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
        glSamplerParameteri(sampler, pname, GL_NEAREST);
    }
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glBindSampler(0, sampler);

    integer_texture(GL_RGBA32UI, GL_UNSIGNED_INT);
    glSamplerParameterIuiv(sampler, GL_TEXTURE_BORDER_COLOR, &UINTS);
    assert_eq!(sampled("u"), UINTS);
    let mut back = [0; 4];
    glGetSamplerParameterIuiv(sampler, GL_TEXTURE_BORDER_COLOR, &mut back);
    assert_eq!(back, UINTS);

    integer_texture(GL_RGBA32I, GL_INT);
    glSamplerParameterIiv(sampler, GL_TEXTURE_BORDER_COLOR, &INTS);
    assert_eq!(sampled("i"), INTS.map(|c| c as u32));
    let mut back = [0; 4];
    glGetSamplerParameterIiv(sampler, GL_TEXTURE_BORDER_COLOR, &mut back);
    assert_eq!(back, INTS);
    assert_eq!(glGetError(), GL_NO_ERROR);
}

#[test]
fn narrower_integers_hold_the_nearest() {
    let _current = context();
    integer_texture(GL_RGBA8UI, GL_UNSIGNED_INT);
    glTexParameterIuiv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[7_u32, 255, 256, u32::MAX]);
    assert_eq!(sampled("u"), [7, 255, 255, 255]);
    integer_texture(GL_RGBA8I, GL_INT);
    glTexParameterIiv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[-128, -129, 127, i32::MAX]);
    assert_eq!(sampled("i").map(|c| c as i32), [-128, -128, 127, 127]);
    assert_eq!(glGetError(), GL_NO_ERROR);
}

#[test]
fn queries_of_another_type_convert() {
    let _current = context();
    let (t, border) = (GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR);
    let (mut floats, mut ints, mut uints) = ([0.0_f32; 4], [0_i32; 4], [0_u32; 4]);
    glTexParameterfv(t, border, &[0.0_f32, 1.0, -1.0, 2.5]);
    // Fractions are clamped where fragments are (`ARB_color_buffer_float`, section 6.1.2).
    glGetTexParameterfv(t, border, &mut floats);
    assert_eq!(floats, [0.0, 1.0, 0.0, 1.0]);
    glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    glGetTexParameterfv(t, border, &mut floats);
    assert_eq!(floats, [0.0, 1.0, -1.0, 2.5]);
    // Colours scale; the `I` queries round.
    glGetTexParameteriv(t, border, &mut ints);
    assert_eq!(ints[..3], [0, i32::MAX, i32::MIN]);
    glGetTexParameterIiv(t, border, &mut ints);
    assert_eq!(ints, [0, 1, -1, 2]);
    glGetTexParameterIuiv(t, border, &mut uints);
    assert_eq!(uints, [0, 1, 0, 2]);
    // Integers of the other sign keep their bits.
    glTexParameterIiv(t, border, &INTS);
    glGetTexParameterIuiv(t, border, &mut uints);
    assert_eq!(uints, INTS.map(|c| c as u32));
    glGetTexParameterfv(t, border, &mut floats);
    assert_eq!(floats, INTS.map(|c| c as f32));
    assert_eq!(glGetError(), GL_NO_ERROR);
}

/// The least and the largest number of each component that a format can hold, by its name.
fn range(row: &InternalFormat, component: usize) -> [f64; 2] {
    let name = enum_name(row.name);
    // As GL's names have them, 8 in `GL_LUMINANCE8_ALPHA8`.
    let bits = |part: &str| name.contains(part);
    let width = || {
        let alpha_of_rgb10 = name == "GL_RGB10_A2UI" && component == 3;
        let widths = [(alpha_of_rgb10, 2), (bits("10"), 10), (bits("16"), 16), (bits("32"), 32)];
        widths.into_iter().find(|row| row.0).map_or(8, |row| row.1)
    };
    match row.components {
        ComponentType::Unorm => [0.0, 1.0],
        ComponentType::Snorm => [-1.0, 1.0],
        ComponentType::Uint => [0.0, 2_f64.powi(width()) - 1.0],
        ComponentType::Sint => [-(2_f64.powi(width() - 1)), 2_f64.powi(width() - 1) - 1.0],
        // (2 - 2^-mantissa) · 2^15, without a sign
        ComponentType::Float if bits("R11F") => {
            let mantissa = if component == 2 { 5 } else { 6 };
            [0.0, (2.0 - 2_f64.powi(-mantissa)) * 2_f64.powi(15)]
        }
        // (2^9 - 1) / 2^9 · 2^16
        ComponentType::Float if bits("RGB9_E5") => [0.0, 511.0 / 512.0 * 65536.0],
        ComponentType::Float if bits("16F") || bits("BPTC") => {
            let largest = (2.0 - 2_f64.powi(-10)) * 2_f64.powi(15);
            [if bits("UNSIGNED") { 0.0 } else { -largest }, largest]
        }
        ComponentType::Float => [f64::NEG_INFINITY, f64::INFINITY],
    }
}

/// What a lookup gives of the components that a base format has (GL 2.1, table 3.20; `ARB_texture_rg`).
fn components(base: GLenum, [r, g, b, a]: [f64; 4]) -> [f64; 4] {
    match base {
        GL_ALPHA => [0.0, 0.0, 0.0, a],
        GL_LUMINANCE | GL_DEPTH_COMPONENT | GL_DEPTH_STENCIL => [r, r, r, 1.0],
        GL_LUMINANCE_ALPHA => [r, r, r, a],
        GL_INTENSITY => [r; 4],
        GL_RED => [r, 0.0, 0.0, 1.0],
        GL_RG => [r, g, 0.0, 1.0],
        GL_RGB => [r, g, b, 1.0],
        _ => [r, g, b, a],
    }
}

/// A texture of one texel, whatever its value.
fn image(row: &InternalFormat) {
    let t = GL_TEXTURE_2D;
    let is_integer = matches!(row.components, ComponentType::Sint | ComponentType::Uint);
    let (format, ty) = match row.base {
        GL_DEPTH_COMPONENT => (GL_DEPTH_COMPONENT, GL_FLOAT),
        GL_DEPTH_STENCIL => (GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8),
        _ if is_integer => (GL_RGBA_INTEGER, GL_INT),
        _ => (GL_RGBA, GL_FLOAT),
    };
    glTexImage2D(t, 0, row.name, 1, 1, 0, format, ty, &[0_u32; 4]);
    if glGetError() != GL_NO_ERROR {
        let bytes = row.stored.bytes();
        glCompressedTexImage2D(t, 0, row.name, 4, 4, 0, bytes, &[0_u8; 16][..bytes]);
        assert_eq!(glGetError(), GL_NO_ERROR, "{}", enum_name(row.name));
    }
}

#[test]
fn every_format_clamps_the_border_to_what_it_can_hold() {
    const FLOATS: [[f32; 4]; 3] =
        [[-3.0, -0.5, 0.25, -1.0], [1e9, -1e9, 7e4, 2.0], [0.75, 65_000.0, 65_408.0, 1e30]];
    const INTEGERS: [[i32; 4]; 3] =
        [[-3, 300, 70_000, 2], [i32::MIN, -129, 128, -1], [i32::MAX, -32_769, 1023, 1 << 20]];
    let _current = context();
    let t = GL_TEXTURE_2D;
    let mut sampler = 0;
    glGenSamplers(1, &mut sampler);
    for pname in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
        glTexParameteri(t, pname, GL_NEAREST);
        glSamplerParameteri(sampler, pname, GL_NEAREST);
    }
    glTexParameteri(t, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    let programs = ["", "i", "u"].map(|kind| {
        let fragment = format!(
            "#version 130
            uniform {kind}sampler2D s;
            out {kind}vec4 color;
            void main() {{ color = texture(s, vec2(2.0, 0.5)); }}"
        );
        program("void main() { gl_Position = gl_Vertex; }", &fragment).unwrap()
    });
    glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
    glBindFramebuffer(GL_FRAMEBUFFER, 1);
    let colors = |row: &&InternalFormat| row.is_for_textures() && row.base != GL_STENCIL_INDEX;
    let mut count = 0;
    for row in FORMATS.iter().filter(colors) {
        image(row);
        let kind = match row.components {
            ComponentType::Sint => 1,
            ComponentType::Uint => 2,
            ComponentType::Unorm | ComponentType::Snorm | ComponentType::Float => 0,
        };
        glBindRenderbuffer(GL_RENDERBUFFER, 1);
        let target = [GL_RGBA32F, GL_RGBA32I, GL_RGBA32UI][kind];
        glRenderbufferStorage(GL_RENDERBUFFER, target, 2, 2);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 1);
        for case in 0..3 {
            let (floats, integers) = (FLOATS[case], INTEGERS[case]);
            let given = match kind {
                0 => floats.map(f64::from),
                1 => integers.map(f64::from),
                _ => integers.map(|c| f64::from(c as u32)),
            };
            let held = [0, 1, 2, 3].map(|at| {
                let [low, high] = range(row, at);
                given[at].clamp(low, high)
            });
            let want = components(row.base, held);
            for by in [0, sampler] {
                glBindSampler(0, by);
                match (kind, by) {
                    (0, 0) => glTexParameterfv(t, GL_TEXTURE_BORDER_COLOR, &floats),
                    (0, _) => glSamplerParameterfv(by, GL_TEXTURE_BORDER_COLOR, &floats),
                    (1, 0) => glTexParameterIiv(t, GL_TEXTURE_BORDER_COLOR, &integers),
                    (1, _) => glSamplerParameterIiv(by, GL_TEXTURE_BORDER_COLOR, &integers),
                    (_, 0) => {
                        let color = integers.map(|c| c as u32);
                        glTexParameterIuiv(t, GL_TEXTURE_BORDER_COLOR, &color);
                    }
                    _ => {
                        let color = integers.map(|c| c as u32);
                        glSamplerParameterIuiv(by, GL_TEXTURE_BORDER_COLOR, &color);
                    }
                }
                glUseProgram(programs[kind]);
                glRectf(-1, -1, 1, 1);
                let got: [f64; 4] = match kind {
                    0 => {
                        let mut pixel = [0.0_f32; 4];
                        glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, &mut pixel);
                        pixel.map(f64::from)
                    }
                    1 => {
                        let mut pixel = [0_i32; 4];
                        glReadPixels(0, 0, 1, 1, GL_RGBA_INTEGER, GL_INT, &mut pixel);
                        pixel.map(f64::from)
                    }
                    _ => {
                        let mut pixel = [0_u32; 4];
                        glReadPixels(0, 0, 1, 1, GL_RGBA_INTEGER, GL_UNSIGNED_INT, &mut pixel);
                        pixel.map(f64::from)
                    }
                };
                assert_eq!(glGetError(), GL_NO_ERROR, "{}", enum_name(row.name));
                assert_eq!(got, want, "{} {given:?} by {by}", enum_name(row.name));
                count += 1;
            }
        }
    }
    assert!(count > 6 * 150, "{count}");
}
