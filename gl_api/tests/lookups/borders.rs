//! Border colours of integers: every bit of them, of textures and of sampler objects, in shaders and
//! in queries.

use super::{context, drawn, program};
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
