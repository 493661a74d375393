//! Which buffer a block is read from: bindings, ranges, writes of every kind.

use super::{context, draw, fine, floats, found, of_block, reading};
use gl_api::*;

const BLOCK: &str = "layout(std140) uniform B { float f; };";

/// The number that a buffer has in 16 bytes from an offset on.
fn rows(values: &[f32]) -> Vec<f32> {
    values.iter().flat_map(|&value| [value, 0.0, 0.0, 0.0]).collect()
}

#[test]
fn the_number_of_the_block_says_which_buffer() {
    let mut c = context();
    let program =
        reading(&mut c, "uniform A { float a; }; uniform B { float b; };", "vec2", "vec2(a, b)");
    floats(&mut c, 1, &rows(&[1.0]));
    floats(&mut c, 2, &rows(&[2.0]));
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, 1);
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 5, 2);
    let read = |c: &mut Context| draw(c, 2).into_iter().map(f32::from_bits).collect::<Vec<_>>();
    assert_eq!(read(&mut c), [1.0, 1.0]);
    let [a, b] = ["A", "B"].map(|name| c.get_uniform_block_index(program, name));
    c.uniform_block_binding(program, b, 5);
    assert_eq!(read(&mut c), [1.0, 2.0]);
    c.uniform_block_binding(program, a, 5);
    c.uniform_block_binding(program, b, 0);
    assert_eq!(read(&mut c), [2.0, 1.0]);
    assert_eq!(of_block(&mut c, program, "A", GL_UNIFORM_BLOCK_BINDING), 5);
    // A link begins anew.
    c.link_program(program);
    assert_eq!(of_block(&mut c, program, "A", GL_UNIFORM_BLOCK_BINDING), 0);
    assert_eq!(read(&mut c), [1.0, 1.0]);
}

#[test]
fn a_range_begins_at_its_offset() {
    let mut c = context();
    reading(&mut c, BLOCK, "float", "f");
    floats(&mut c, 1, &rows(&[1.0, 2.0, 3.0]));
    for (offset, size, expected) in [(0, 16, 1.0), (16, 16, 2.0), (32, 16, 3.0), (16, 4, 2.0)] {
        c.bind_buffer_range(GL_UNIFORM_BUFFER, 0, 1, offset, size);
        assert_eq!(found(&mut c), expected);
    }
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, 1);
    assert_eq!(found(&mut c), 1.0);
}

/// What is not there is 0, and a message says so once.
#[test]
fn what_lies_past_the_end_is_zero() {
    let block = "layout(std140) uniform B { vec4 a[4]; };";
    let mut c = context();
    let value = "vec4(a[0].x, a[1].x, a[2].x, a[3].w)";
    reading(&mut c, block, "vec4", value);
    let read = |c: &mut Context| draw(c, 4).into_iter().map(f32::from_bits).collect::<Vec<_>>();
    let warned = |c: &mut Context| {
        let says = |text: &str| text.contains("needs 64 bytes") || text.contains("has no buffer");
        c.messages().iter().filter(|message| says(&message.to_string())).count()
    };
    c.messages();
    for times in [1, 0] {
        c.draw_arrays(GL_POINTS, 0, 1);
        assert_eq!(warned(&mut c), times);
    }
    assert_eq!(read(&mut c), [0.0; 4]);
    floats(&mut c, 1, &[[1.0; 4], [2.0; 4], [3.0; 4], [4.0; 4]].concat());
    for (offset, size, expected) in [
        (0, 64, [1.0, 2.0, 3.0, 4.0]),
        (0, 62, [1.0, 2.0, 3.0, 0.0]),
        (0, 32, [1.0, 2.0, 0.0, 0.0]),
        (32, 64, [3.0, 4.0, 0.0, 0.0]),
        (4096, 64, [0.0; 4]),
    ] {
        c.bind_buffer_range(GL_UNIFORM_BUFFER, 0, 1, offset, size);
        assert_eq!(read(&mut c), expected, "{offset} {size}");
    }
    fine(&mut c);
}

#[test]
fn every_write_is_seen() {
    let mut c = context();
    reading(&mut c, BLOCK, "float", "f");
    floats(&mut c, 1, &rows(&[1.0, 2.0]));
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, 1);
    assert_eq!(found(&mut c), 1.0);
    floats(&mut c, 1, &rows(&[3.0, 4.0]));
    assert_eq!(found(&mut c), 3.0, "glBufferData");
    c.buffer_sub_data(GL_UNIFORM_BUFFER, 0, 4, Data::Bytes(&5_f32.to_le_bytes()));
    assert_eq!(found(&mut c), 5.0, "glBufferSubData");
    c.bind_buffer(GL_COPY_READ_BUFFER, 1);
    c.copy_buffer_sub_data(GL_COPY_READ_BUFFER, GL_UNIFORM_BUFFER, 16, 0, 4);
    assert_eq!(found(&mut c), 4.0, "glCopyBufferSubData");
    c.map_buffer(GL_UNIFORM_BUFFER, GL_WRITE_ONLY);
    let bytes = c.mapped_bytes(GL_UNIFORM_BUFFER).expect("mapped");
    bytes[..4].copy_from_slice(&6_f32.to_le_bytes());
    c.draw_arrays(GL_POINTS, 0, 1);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION, "mapped");
    c.messages();
    c.unmap_buffer(GL_UNIFORM_BUFFER);
    assert_eq!(found(&mut c), 6.0, "glUnmapBuffer");
    // Pixels that are read into it.
    c.clear_color(0.5, 0.0, 0.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.bind_buffer(GL_PIXEL_PACK_BUFFER, 1);
    c.read_pixels(0, 0, 1, 1, GL_RED, GL_FLOAT, DataOut::Offset(0));
    c.bind_buffer(GL_PIXEL_PACK_BUFFER, 0);
    assert_eq!((found(&mut c) * 255.0).round(), 128.0, "glReadPixels");
    // What transform feedback captures.
    floats(&mut c, 2, &rows(&[7.0]));
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, 2);
    assert_eq!(found(&mut c), 7.0);
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, super::CAPTURED);
    assert_eq!(f32::from_bits(draw(&mut c, 4)[0]), 0.0, "it was emptied");
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, 2);
    assert_eq!(f32::from_bits(draw(&mut c, 4)[0]), 7.0);
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, super::CAPTURED);
    c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 2);
    c.begin_transform_feedback(GL_POINTS);
    c.draw_arrays(GL_POINTS, 0, 1);
    c.end_transform_feedback();
    let mut bytes = [0; 4];
    c.get_buffer_sub_data(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 4, DataOut::Bytes(&mut bytes));
    assert_eq!(f32::from_le_bytes(bytes), 7.0, "transform feedback");
    fine(&mut c);
}

/// A draw that waits keeps what it saw.
#[test]
fn recorded_draws_keep_their_values() {
    let mut c = context();
    let fragment = format!("{}{BLOCK} void main() {{ gl_FragColor = vec4(f); }}", super::BEGIN);
    super::shading::use_program(&mut c, "", &fragment);
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, 1);
    c.buffer_data(GL_UNIFORM_BUFFER, 16, Data::Null, GL_STREAM_DRAW);
    for (value, [left, right]) in [(1.0_f32, [-1.0, 0.0]), (0.0, [0.0, 1.0])] {
        c.buffer_sub_data(GL_UNIFORM_BUFFER, 0, 4, Data::Bytes(&value.to_le_bytes()));
        c.rectf(left, -1.0, right, 1.0);
    }
    c.delete_buffers(1, &[1]);
    let mut pixels = [9; 8];
    c.read_pixels(0, 0, 8, 1, GL_RED, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixels));
    assert_eq!(pixels, [255, 255, 255, 255, 0, 0, 0, 0]);
    fine(&mut c);
}

#[test]
fn a_deleted_buffer_is_bound_nowhere() {
    let mut c = context();
    reading(&mut c, BLOCK, "float", "f");
    floats(&mut c, 1, &rows(&[1.0]));
    c.bind_buffer_range(GL_UNIFORM_BUFFER, 0, 1, 0, 16);
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 3, 1);
    assert_eq!(found(&mut c), 1.0);
    c.delete_buffers(1, &[1]);
    for index in [0, 3] {
        for pname in [GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE] {
            let mut value = [9];
            c.get_integeri_v(pname, index, &mut value);
            assert_eq!(value, [0], "{index} {}", enum_name(pname));
        }
    }
    let mut bound = [9];
    c.get_integerv(GL_UNIFORM_BUFFER_BINDING, &mut bound);
    assert_eq!(bound, [0]);
    assert_eq!(found(&mut c), 0.0);
    // Another of the same name is another.
    floats(&mut c, 1, &rows(&[2.0]));
    c.bind_buffer_range(GL_UNIFORM_BUFFER, 0, 1, 0, 16);
    assert_eq!(found(&mut c), 2.0);
}

#[test]
fn bindings_can_be_asked_for() {
    let mut c = context();
    c.bind_buffer_range(GL_UNIFORM_BUFFER, 7, 3, 256, 100);
    let names = [GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE];
    for (pname, expected) in names.into_iter().zip([3, 256, 100]) {
        let (mut value, mut long) = ([9], [9]);
        c.get_integeri_v(pname, 7, &mut value);
        c.get_integer64i_v(pname, 7, &mut long);
        assert_eq!((value, long), ([expected], [expected.into()]), "{}", enum_name(pname));
    }
    let mut bound = [0];
    c.get_integerv(GL_UNIFORM_BUFFER_BINDING, &mut bound);
    assert_eq!(bound, [3]);
    // Of a whole buffer there is no range.
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 7, 4);
    for (pname, expected) in names.into_iter().zip([4, 0, 0]) {
        let mut value = [9];
        c.get_integeri_v(pname, 7, &mut value);
        assert_eq!(value, [expected], "{}", enum_name(pname));
    }
    fine(&mut c);
}

/// glBindBufferBase happens at once, glUniformBlockBinding when the list is called.
#[test]
fn lists_keep_what_is_a_command() {
    let mut c = context();
    let program = reading(&mut c, BLOCK, "float", "f");
    floats(&mut c, 1, &rows(&[1.0]));
    floats(&mut c, 2, &rows(&[2.0]));
    c.new_list(1, GL_COMPILE);
    c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, 1);
    c.bind_buffer_range(GL_UNIFORM_BUFFER, 1, 2, 0, 16);
    c.uniform_block_binding(program, 0, 1);
    c.end_list();
    assert_eq!(found(&mut c), 1.0);
    c.call_list(1);
    assert_eq!(found(&mut c), 2.0);
}
