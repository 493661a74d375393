//! Uniform blocks: ARB_uniform_buffer_object. What shaders read is captured with transform feedback
//! and held to the words of the buffers, at the bytes that the specification's rules give.

#[path = "../common/shading.rs"]
mod shading;

mod buffers;
mod layout;
mod linked;
mod values;

use gl_api::*;

fn context() -> Context {
    let desc = ContextDesc { width: 8, height: 8, ..ContextDesc::default() };
    Context::new(desc).expect("a device")
}

/// Nothing was refused.
#[track_caller]
fn fine(c: &mut Context) {
    let messages = c.messages();
    assert_eq!(c.get_error(), GL_NO_ERROR, "{messages:?}");
}

/// What begins a shader with uniform blocks.
const BEGIN: &str = "#version 130\n#extension GL_ARB_uniform_buffer_object : require\n";

/// A linked program, in use, of a vertex shader with these declarations that captures `found`, which
/// has this type and value.
#[track_caller]
fn reading(c: &mut Context, declarations: &str, ty: &str, value: &str) -> GLuint {
    let flat = if ty.contains("vec") && !ty.starts_with(['i', 'u']) || ty == "float" {
        ""
    } else {
        "flat"
    };
    let vertex = format!(
        "{BEGIN}{declarations}\n{flat} out {ty} found;\n\
         void main() {{ found = {value}; gl_Position = vec4(0.0); }}"
    );
    let program = shading::use_program(c, &vertex, "");
    c.transform_feedback_varyings(program, 1, Names(vec!["found"]), GL_INTERLEAVED_ATTRIBS);
    c.link_program(program);
    c.use_program(program);
    let messages = c.messages();
    assert_eq!(c.get_error(), GL_NO_ERROR, "{vertex}\n{messages:?}");
    program
}

/// The buffer that is captured into.
const CAPTURED: GLuint = 90;

/// Draws a point and gives the words that were captured.
#[track_caller]
fn draw(c: &mut Context, count: usize) -> Vec<u32> {
    c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, CAPTURED);
    c.buffer_data(GL_TRANSFORM_FEEDBACK_BUFFER, 4 * count as isize, Data::Null, GL_DYNAMIC_READ);
    c.enable(GL_RASTERIZER_DISCARD);
    c.begin_transform_feedback(GL_POINTS);
    c.draw_arrays(GL_POINTS, 0, 1);
    c.end_transform_feedback();
    c.disable(GL_RASTERIZER_DISCARD);
    let mut bytes = vec![0; 4 * count];
    let size = bytes.len() as isize;
    c.get_buffer_sub_data(GL_TRANSFORM_FEEDBACK_BUFFER, 0, size, DataOut::Bytes(&mut bytes));
    fine(c);
    bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
}

/// The word that [`counted`] has at a byte: another number at each, as a float or an integer.
fn word(byte: u32) -> u32 {
    0x3f00_0000 + byte / 4
}

/// Buffer `name` with the words of [`word`].
fn counted(c: &mut Context, name: GLuint, bytes: u32) {
    let data: Vec<u8> = (0..bytes).step_by(4).flat_map(|byte| word(byte).to_le_bytes()).collect();
    c.bind_buffer(GL_UNIFORM_BUFFER, name);
    c.buffer_data(GL_UNIFORM_BUFFER, data.len() as isize, Data::Bytes(&data), GL_STATIC_DRAW);
    fine(c);
}

/// Buffer `name` with floats.
fn floats(c: &mut Context, name: GLuint, values: &[f32]) {
    let data: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    c.bind_buffer(GL_UNIFORM_BUFFER, name);
    c.buffer_data(GL_UNIFORM_BUFFER, data.len() as isize, Data::Bytes(&data), GL_STATIC_DRAW);
    fine(c);
}

/// What the program found, of one float.
#[track_caller]
fn found(c: &mut Context) -> f32 {
    f32::from_bits(draw(c, 1)[0])
}

/// What a uniform is, by its name.
#[track_caller]
fn of_uniform(c: &mut Context, program: GLuint, name: &str, pname: GLenum) -> i32 {
    let (mut index, mut value) = ([0], [0]);
    c.get_uniform_indices(program, 1, Names(vec![name]), &mut index);
    assert_ne!(index, [GL_INVALID_INDEX], "{name}");
    c.get_active_uniformsiv(program, 1, &index, pname, &mut value);
    fine(c);
    value[0]
}

/// What a block is, by its name.
#[track_caller]
fn of_block(c: &mut Context, program: GLuint, name: &str, pname: GLenum) -> i32 {
    let index = c.get_uniform_block_index(program, name);
    let mut value = [0];
    c.get_active_uniform_blockiv(program, index, pname, &mut value);
    fine(c);
    value[0]
}
