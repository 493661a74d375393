//! Attributes whose components share a word (`ARB_vertex_type_2_10_10_10_rev`), and those in the order
//! blue, green, red, alpha (`EXT_vertex_array_bgra`).

use super::shading::use_program;
use super::{context, fine};
use gl_api::*;

const SIGNED: GLenum = GL_INT_2_10_10_10_REV;
const UNSIGNED: GLenum = GL_UNSIGNED_INT_2_10_10_10_REV;

/// x, y, z and w in a word.
fn word([x, y, z, w]: [i32; 4]) -> u32 {
    let bits = |c: i32, count: u32| c as u32 & ((1 << count) - 1);
    bits(x, 10) | bits(y, 10) << 10 | bits(z, 10) << 20 | bits(w, 2) << 30
}

/// What generic attribute 0 of a draw is.
fn read(c: &mut Context) -> [f32; 4] {
    c.draw_arrays(GL_POINTS, 0, 1);
    let mut found = [0.0_f32; 4];
    let mut bytes = [0; 16];
    c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, DataOut::Bytes(&mut bytes));
    for (value, bytes) in found.iter_mut().zip(bytes.as_chunks().0) {
        *value = f32::from_le_bytes(*bytes);
    }
    fine(c);
    found
}

/// A pixel of floats, to which a program writes generic attribute 0.
fn prepared() -> Context {
    let mut c = context(1, 1);
    c.bind_framebuffer(GL_FRAMEBUFFER, 1);
    c.bind_renderbuffer(GL_RENDERBUFFER, 1);
    c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA32F, 1, 1);
    let (target, color) = (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0);
    c.framebuffer_renderbuffer(target, color, GL_RENDERBUFFER, 1);
    c.clamp_color(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
    let vertex = "attribute vec4 value; varying vec4 v;
        void main() { gl_Position = vec4(0.0, 0.0, 0.0, 1.0); v = value; }";
    let program = use_program(&mut c, vertex, "varying vec4 v; void main() { gl_FragColor = v; }");
    c.bind_attrib_location(program, 0, "value");
    c.link_program(program);
    c.use_program(program);
    c.enable_vertex_attrib_array(0);
    fine(&mut c);
    c
}

#[test]
fn arrays_of_words_and_of_the_other_order() {
    let mut c = prepared();
    let numbers = [511, -512, 100, 1];
    let signed = |c: i32, largest: f64| ((2.0 * f64::from(c) + 1.0) / largest) as f32;
    let [x, y, z] = [511, -512, 100].map(|c| signed(c, 1023.0));
    let [r, g, b] = [511, 512, 100].map(|c| (f64::from(c) / 1023.0) as f32);
    let a = (1.0_f64 / 3.0) as f32;
    let bgra = GL_BGRA as i32;
    let cases = [
        (4, SIGNED, false, [511.0, -512.0, 100.0, 1.0]),
        (4, SIGNED, true, [x, y, z, 1.0]),
        (4, UNSIGNED, false, [511.0, 512.0, 100.0, 1.0]),
        (4, UNSIGNED, true, [r, g, b, a]),
        (bgra, SIGNED, true, [z, y, x, 1.0]),
        (bgra, UNSIGNED, true, [b, g, r, a]),
    ];
    for (size, ty, normalized, want) in cases {
        let bytes = word(numbers).to_le_bytes();
        c.vertex_attrib_pointer(0, size, ty, normalized, 0, Data::Bytes(&bytes));
        let name = format!("{size:#x} {} {normalized}", enum_name(ty));
        assert_eq!(read(&mut c), want, "{name}");
        let mut value = [0];
        c.get_vertex_attribiv(0, GL_VERTEX_ATTRIB_ARRAY_SIZE, &mut value);
        assert_eq!(value, [size], "{name}");
        c.get_vertex_attribiv(0, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, &mut value);
        assert_eq!(value, [i32::from(normalized)], "{name}");
        c.get_vertex_attribiv(0, GL_VERTEX_ATTRIB_ARRAY_TYPE, &mut value);
        assert_eq!(value, [ty as i32], "{name}");
    }
    // Bytes, as pictures often have them; and every word is four bytes on.
    c.vertex_attrib_pointer(0, bgra, GL_UNSIGNED_BYTE, true, 0, Data::Bytes(&[255, 51, 0, 102]));
    assert_eq!(read(&mut c), [0.0, 0.2, 1.0, 0.4]);
    let words = [word([1, 2, 3, 0]), word([4, 5, 6, 1])];
    c.enable_vertex_attrib_array(1);
    c.vertex_attrib_pointer(1, 4, SIGNED, false, 0, words.as_slice().arg());
    c.begin(GL_POINTS);
    c.array_element(1);
    c.end();
    let mut value = [0.0; 4];
    c.get_vertex_attribfv(1, GL_CURRENT_VERTEX_ATTRIB, &mut value);
    assert_eq!(value, [4.0, 5.0, 6.0, 1.0]);
    fine(&mut c);
}

#[test]
fn colours_in_the_other_order_are_answered_so() {
    let mut c = context(1, 1);
    c.color_pointer(GL_BGRA as i32, GL_UNSIGNED_BYTE, 0, Data::Bytes(&[255, 51, 0, 102]));
    c.secondary_color_pointer(GL_BGRA as i32, UNSIGNED, 0, Data::Bytes(&[0; 4]));
    for pname in [GL_COLOR_ARRAY_SIZE, GL_SECONDARY_COLOR_ARRAY_SIZE] {
        let mut size = [0];
        c.get_integerv(pname, &mut size);
        assert_eq!(size, [GL_BGRA as i32]);
    }
    c.enable_client_state(GL_COLOR_ARRAY);
    c.begin(GL_POINTS);
    c.array_element(0);
    c.end();
    let mut color = [0.0; 4];
    c.get_floatv(GL_CURRENT_COLOR, &mut color);
    assert_eq!(color, [0.0, 0.2, 1.0, 0.4]);
    // Three components of a normal are a word too.
    c.normal_pointer(SIGNED, 0, Data::Bytes(&word([511, 0, -512, 0]).to_le_bytes()));
    c.enable_client_state(GL_NORMAL_ARRAY);
    c.begin(GL_POINTS);
    c.array_element(0);
    c.end();
    let mut normal = [0.0; 3];
    c.get_floatv(GL_CURRENT_NORMAL, &mut normal);
    assert_eq!(normal, [1.0, 1.0 / 1023.0, -1.0]);
    fine(&mut c);
}

#[test]
fn immediate_mode_takes_words() {
    let mut c = context(1, 1);
    let (plain, fraction) = ([3, -4, 5, 1], [511, 511, 511, 1]);
    let (coords, ones) = (word(plain), word(fraction));
    let current = |c: &mut Context, pname: GLenum| {
        let mut value = [9.0; 4];
        c.get_floatv(pname, &mut value);
        fine(c);
        value
    };
    let texture = GL_CURRENT_TEXTURE_COORDS;
    c.tex_coord_p1ui(SIGNED, coords);
    assert_eq!(current(&mut c, texture), [3.0, 0.0, 0.0, 1.0]);
    c.tex_coord_p2uiv(SIGNED, &[coords]);
    assert_eq!(current(&mut c, texture), [3.0, -4.0, 0.0, 1.0]);
    c.multi_tex_coord_p3ui(GL_TEXTURE0, SIGNED, coords);
    assert_eq!(current(&mut c, texture), [3.0, -4.0, 5.0, 1.0]);
    c.multi_tex_coord_p4uiv(GL_TEXTURE0, UNSIGNED, &[coords]);
    assert_eq!(current(&mut c, texture), [3.0, 1020.0, 5.0, 1.0]);
    c.color_p3ui(SIGNED, ones);
    assert_eq!(current(&mut c, GL_CURRENT_COLOR), [1.0; 4]);
    c.color_p4uiv(UNSIGNED, &[word([1023, 0, 0, 0])]);
    assert_eq!(current(&mut c, GL_CURRENT_COLOR), [1.0, 0.0, 0.0, 0.0]);
    c.secondary_color_p3ui(SIGNED, ones);
    assert_eq!(current(&mut c, GL_CURRENT_SECONDARY_COLOR)[..3], [1.0; 3]);
    c.normal_p3ui(SIGNED, word([-512, 511, -512, 0]));
    assert_eq!(current(&mut c, GL_CURRENT_NORMAL)[..3], [-1.0, 1.0, -1.0]);
    // Generic ones, as they are or as fractions, and in a list.
    c.new_list(1, GL_COMPILE);
    c.vertex_attrib_p4ui(3, SIGNED, false, coords);
    c.vertex_attrib_p2uiv(4, UNSIGNED, true, &[word([1023, 0, 1023, 3])]);
    c.end_list();
    c.call_list(1);
    let mut value = [9.0; 4];
    c.get_vertex_attribfv(3, GL_CURRENT_VERTEX_ATTRIB, &mut value);
    assert_eq!(value, [3.0, -4.0, 5.0, 1.0]);
    c.get_vertex_attribfv(4, GL_CURRENT_VERTEX_ATTRIB, &mut value);
    assert_eq!(value, [1.0, 0.0, 0.0, 1.0]);
    // Positions end vertices.
    c.feedback_buffer(16, GL_2D, DataOut::Null);
    c.ortho(0.0, 1.0, 0.0, 1.0, -1.0, 1.0);
    c.render_mode(GL_FEEDBACK);
    c.begin(GL_POINTS);
    c.vertex_p2ui(SIGNED, word([1, 0, 77, 0]));
    c.vertex_p3uiv(SIGNED, &[word([0, 1, 0, 0])]);
    c.vertex_p4ui(UNSIGNED, word([1, 1, 0, 1]));
    c.end();
    let point = GL_POINT_TOKEN as f32;
    assert_eq!(c.render_mode(GL_RENDER), 9);
    assert_eq!(c.feedback(), [point, 1.0, 0.0, point, 0.0, 1.0, point, 1.0, 1.0]);
    fine(&mut c);
}

/// `ARB_vertex_type_10f_11f_11f_rev`: 2.5, 65024 and 2^-19 are 1.25 · 2^1, the largest number of 11 bits and the least of 10.
#[test]
fn words_of_three_floats() {
    let mut c = prepared();
    let floats = GL_UNSIGNED_INT_10F_11F_11F_REV;
    let word: u32 = (16 << 6 | 16) | 0x7BF << 11 | 1 << 22;
    let want = [2.5, 65024.0, 2.0_f32.powi(-19), 1.0];
    for normalized in [false, true] {
        let bytes = word.to_le_bytes();
        c.vertex_attrib_pointer(0, 3, floats, normalized, 0, Data::Bytes(&bytes));
        assert_eq!(read(&mut c), want);
        let mut value = [0];
        c.get_vertex_attribiv(0, GL_VERTEX_ATTRIB_ARRAY_TYPE, &mut value);
        assert_eq!(value, [floats as i32]);
    }
    let current = |c: &mut Context| {
        let mut value = [0.0; 4];
        c.get_vertex_attribfv(1, GL_CURRENT_VERTEX_ATTRIB, &mut value);
        fine(c);
        value
    };
    c.vertex_attrib_p1ui(1, floats, false, word);
    assert_eq!(current(&mut c), [want[0], 0.0, 0.0, 1.0]);
    c.vertex_attrib_p2uiv(1, floats, true, &[word]);
    assert_eq!(current(&mut c), [want[0], want[1], 0.0, 1.0]);
    c.vertex_attrib_p3ui(1, floats, false, word);
    assert_eq!(current(&mut c), want);
    c.vertex_attrib_p4ui(1, floats, false, word);
    assert_eq!(current(&mut c), want);
}
