//! Draws whose arguments lie in a buffer, and base instances (`ARB_draw_indirect`, `ARB_multi_draw_indirect`,
//! `ARB_base_instance`).

use super::{context, fine, pixel, shading};
use gl_api::*;

const SIDE: u32 = 8;

const VERTEX: &str = "#version 130
    in vec2 corner;
    in float column;
    in vec3 tint;
    out vec3 color;
    void main() {
        color = tint;
        gl_Position = vec4((corner.x + column) / 4.0 - 1.0, corner.y, 0.0, 1.0);
    }";
const FRAGMENT: &str = "#version 130
    in vec3 color;
    void main() { gl_FragColor = vec4(color, 1.0); }";

/// Columns of one pixel: 2 triangles at `column`, whose tint is that of the instance. With `client`, instanced arrays
/// are in the client's memory.
fn prepared() -> Context {
    let mut c = context(SIDE, SIDE);
    let program = shading::use_program(&mut c, VERTEX, FRAGMENT);
    let location = |c: &mut Context, name: &str| c.get_attrib_location(program, name) as GLuint;
    let (corner, column, tint) =
        (location(&mut c, "corner"), location(&mut c, "column"), location(&mut c, "tint"));
    // Vertices 0 to 2 lie nowhere.
    let mut corners = vec![[0.0_f32; 2]; 3];
    corners.extend([[0.0, -1.0], [1.0, -1.0], [1.0, 1.0], [0.0, -1.0], [1.0, 1.0], [0.0, 1.0]]);
    let columns: Vec<f32> = (0..8).map(|column| column as f32).collect();
    let tints: Vec<[f32; 3]> = (0..4).map(|at| [at as f32 / 3.0, 1.0, 0.0]).collect();
    let array = |c: &mut Context, (buffer, at): (GLuint, GLuint), size, data: &[u8], divisor| {
        c.bind_buffer(GL_ARRAY_BUFFER, buffer);
        let bytes = data.len() as GLsizeiptr;
        c.buffer_data(GL_ARRAY_BUFFER, bytes, Data::Bytes(data), GL_STATIC_DRAW);
        c.vertex_attrib_pointer(at, size, GL_FLOAT, false, 0, Data::Offset(0));
        c.enable_vertex_attrib_array(at);
        c.vertex_attrib_divisor(at, divisor);
    };
    array(&mut c, (1, corner), 2, bytemuck::cast_slice(&corners), 0);
    array(&mut c, (2, column), 1, bytemuck::cast_slice(&columns), 1);
    array(&mut c, (3, tint), 3, bytemuck::cast_slice(&tints), 2);
    let indices: Vec<u16> = (0..9).collect();
    let bytes = Data::Bytes(bytemuck::cast_slice(&indices));
    c.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, 4);
    c.buffer_data(GL_ELEMENT_ARRAY_BUFFER, 18, bytes, GL_STATIC_DRAW);
    c.bind_buffer(GL_DRAW_INDIRECT_BUFFER, 5);
    fine(&mut c);
    c
}

fn set(c: &mut Context, words: &[u32]) {
    let bytes = Data::Bytes(bytemuck::cast_slice(words));
    let size = 4 * words.len() as GLsizeiptr;
    c.buffer_data(GL_DRAW_INDIRECT_BUFFER, size, bytes, GL_STATIC_DRAW);
}

/// The red of each column; none where nothing is drawn.
fn row(c: &mut Context) -> Vec<Option<u8>> {
    let row = (0..SIDE as i32).map(|x| pixel(c, x, 3)).collect::<Vec<_>>();
    c.clear(GL_COLOR_BUFFER_BIT);
    row.into_iter().map(|[red, green, ..]| (green == 255).then_some(red)).collect()
}

#[test]
fn arrays_and_elements_take_their_arguments_from_the_buffer() {
    let mut c = prepared();
    // Six vertices, three instances, from vertex 3 on; element 1 of the instanced arrays is the first.
    set(&mut c, &[99, 6, 3, 3, 1]);
    c.draw_arrays_indirect(GL_TRIANGLES, Data::Offset(4));
    // Instance n has tint 1 + n / 2.
    let wanted = [None, Some(85), Some(85), Some(170), None, None, None, None];
    assert_eq!(row(&mut c), wanted);
    // Index 1 on, base vertex 2: vertices 3 on.
    set(&mut c, &[6, 3, 1, 2, 1]);
    c.draw_elements_indirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, Data::Offset(0));
    assert_eq!(row(&mut c), wanted);
    // The same as arguments.
    c.draw_arrays_instanced_base_instance(GL_TRIANGLES, 3, 6, 3, 1);
    assert_eq!(row(&mut c), wanted);
    let (ty, indices) = (GL_UNSIGNED_SHORT, Data::Offset(6));
    c.draw_elements_instanced_base_instance(GL_TRIANGLES, 6, ty, indices, 3, 1);
    assert_eq!(row(&mut c), wanted);
    let indices = Data::Offset(2);
    c.draw_elements_instanced_base_vertex_base_instance(GL_TRIANGLES, 6, ty, indices, 3, 2, 1);
    assert_eq!(row(&mut c), wanted);
    fine(&mut c);
}

#[test]
fn several_draws_lie_a_stride_apart() {
    let mut c = prepared();
    set(&mut c, &[6, 1, 3, 0, 77, 6, 2, 3, 4, 77]);
    c.multi_draw_arrays_indirect(GL_TRIANGLES, Data::Offset(0), 2, 20);
    let wanted = [Some(0), None, None, None, None, None, None, None];
    // Elements 4 and 5 of the tints are not there: they read as zeros.
    assert_eq!(row(&mut c), wanted);
    set(&mut c, &[6, 1, 3, 0, 2, 6, 2, 3, 0, 3]);
    c.multi_draw_elements_indirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, Data::Offset(0), 2, 0);
    let wanted = [None, None, Some(170), Some(255), Some(255), None, None, None];
    assert_eq!(row(&mut c), wanted);
    fine(&mut c);
}

#[test]
fn a_draw_with_a_base_is_not_repeated_by_the_next_one() {
    let mut c = prepared();
    c.draw_arrays_instanced_base_instance(GL_TRIANGLES, 3, 6, 1, 2);
    c.draw_arrays_instanced(GL_TRIANGLES, 3, 6, 1);
    c.draw_arrays_instanced_base_instance(GL_TRIANGLES, 3, 6, 1, 3);
    let wanted = [Some(0), None, Some(170), Some(255), None, None, None, None];
    assert_eq!(row(&mut c), wanted);
    fine(&mut c);
}

#[test]
fn instanced_arrays_of_the_client_begin_at_the_base() {
    let mut c = prepared();
    let columns: Vec<f32> = (0..8).map(|column| column as f32).collect();
    let mut program = [0];
    c.get_integerv(GL_CURRENT_PROGRAM, &mut program);
    let program = program[0] as GLuint;
    let at = c.get_attrib_location(program, "column") as GLuint;
    c.bind_buffer(GL_ARRAY_BUFFER, 0);
    let memory = Data::Bytes(bytemuck::cast_slice(&columns));
    c.vertex_attrib_pointer(at, 1, GL_FLOAT, false, 0, memory);
    c.draw_arrays_instanced_base_instance(GL_TRIANGLES, 3, 6, 2, 1);
    let wanted = [None, Some(85), Some(85), None, None, None, None, None];
    assert_eq!(row(&mut c), wanted);
    fine(&mut c);
}
