//! Transform feedback: GL 3.0, section 2.15 (`EXT_transform_feedback`). What is captured is held to
//! what the shader computes, written out in `f64` or as words.

#[path = "../common/shading.rs"]
mod shading;

mod captured;
mod gaps;
mod linked;

use gl_api::*;

fn context() -> Context {
    let desc = ContextDesc { width: 16, height: 16, ..ContextDesc::default() };
    Context::new(desc).expect("a device")
}

/// Nothing was refused.
#[track_caller]
fn fine(c: &mut Context) {
    let messages = c.messages();
    assert_eq!(c.get_error(), GL_NO_ERROR, "{messages:?}");
}

/// A linked program of a vertex shader that captures these names.
#[track_caller]
fn capturing(c: &mut Context, vertex: &str, names: &[&str], mode: GLenum) -> GLuint {
    let program = shading::use_program(c, vertex, "");
    c.transform_feedback_varyings(program, names.len() as i32, Names(names.to_vec()), mode);
    c.link_program(program);
    let log = log(c, program);
    c.use_program(program);
    let messages = c.messages();
    assert_eq!(c.get_error(), GL_NO_ERROR, "{log}\n{messages:?}");
    program
}

/// What the linker said.
fn log(c: &mut Context, program: GLuint) -> String {
    let (mut text, mut length) = (vec![0; 4096], [0]);
    c.get_program_info_log(program, 4096, &mut length, TextOut::Bytes(&mut text));
    String::from_utf8(text[..length[0] as usize].to_vec()).expect("text")
}

/// Buffer `name` of this many words, each `0xdead_beef`, bound to an index.
fn buffer(c: &mut Context, name: GLuint, index: GLuint, words: usize) {
    let bytes = 0xdead_beef_u32.to_le_bytes().repeat(words);
    c.bind_buffer(GL_TRANSFORM_FEEDBACK_BUFFER, name);
    let size = bytes.len() as isize;
    c.buffer_data(GL_TRANSFORM_FEEDBACK_BUFFER, size, Data::Bytes(&bytes), GL_DYNAMIC_READ);
    c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, index, name);
    fine(c);
}

/// The words of a buffer.
fn words(c: &mut Context, name: GLuint, count: usize) -> Vec<u32> {
    let mut bytes = vec![0; 4 * count];
    c.bind_buffer(GL_ARRAY_BUFFER, name);
    let size = bytes.len() as isize;
    c.get_buffer_sub_data(GL_ARRAY_BUFFER, 0, size, DataOut::Bytes(&mut bytes));
    c.bind_buffer(GL_ARRAY_BUFFER, 0);
    fine(c);
    bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
}

/// The floats of a buffer.
fn floats(c: &mut Context, name: GLuint, count: usize) -> Vec<f32> {
    words(c, name, count).into_iter().map(f32::from_bits).collect()
}

/// What was never written.
const UNTOUCHED: u32 = 0xdead_beef;
