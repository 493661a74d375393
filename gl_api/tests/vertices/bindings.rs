//! Formats of attributes and the buffers that they read, apart (`ARB_vertex_attrib_binding`), and buffers that stay mapped
//! while they are used (`ARB_buffer_storage`).

use super::*;

const VERTEX: &str = "#version 120
    attribute vec4 position; attribute vec4 extra; varying vec4 color;
    void main() { gl_Position = position; color = extra; }";
const FRAGMENT: &str = "#version 120
    varying vec4 color; void main() { gl_FragColor = color; }";

/// Interleaved: x, y as floats, then a colour in bytes, 16 bytes a vertex; 8 bytes of nothing before.
fn vertices() -> Vec<u8> {
    let mut bytes = vec![0; 8];
    for corner in CORNERS.chunks_exact(2) {
        bytes.extend_from_slice(bytemuck::cast_slice(corner));
        bytes.extend_from_slice(&[200, 100, 50, 255, 0, 0, 0, 0]);
    }
    bytes
}

fn with_vertices() -> Context {
    let mut c = context();
    program(&mut c, VERTEX, FRAGMENT);
    let bytes = vertices();
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    let size = bytes.len() as GLsizeiptr;
    c.buffer_data(GL_ARRAY_BUFFER, size, Data::Bytes(&bytes), GL_STATIC_DRAW);
    c.enable_vertex_attrib_array(0);
    c.enable_vertex_attrib_array(1);
    c
}

/// The picture of pointer calls.
fn wanted() -> Vec<u8> {
    let mut c = with_vertices();
    c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 16, Data::Offset(8));
    c.vertex_attrib_pointer(1, 4, GL_UNSIGNED_BYTE, true, 16, Data::Offset(16));
    c.draw_arrays(GL_TRIANGLES, 0, 6);
    picture(&mut c)
}

fn read(c: &mut Context, pname: GLenum, index: GLuint) -> GLint {
    let mut value = [0];
    c.get_integeri_v(pname, index, &mut value);
    value[0]
}

fn attribute(c: &mut Context, pname: GLenum, index: GLuint) -> GLint {
    let mut value = [0];
    c.get_vertex_attribiv(index, pname, &mut value);
    value[0]
}

#[test]
fn two_attributes_read_one_binding_point() {
    let mut c = with_vertices();
    c.bind_buffer(GL_ARRAY_BUFFER, 0);
    c.vertex_attrib_format(0, 2, GL_FLOAT, false, 0);
    c.vertex_attrib_format(1, 4, GL_UNSIGNED_BYTE, true, 8);
    c.vertex_attrib_binding(0, 5);
    c.vertex_attrib_binding(1, 5);
    c.bind_vertex_buffer(5, 1, 8, 16);
    c.draw_arrays(GL_TRIANGLES, 0, 6);
    assert_eq!(picture(&mut c), wanted());
    for (pname, value) in [
        (GL_VERTEX_BINDING_OFFSET, 8),
        (GL_VERTEX_BINDING_STRIDE, 16),
        (GL_VERTEX_BINDING_DIVISOR, 0),
        (GL_VERTEX_BINDING_BUFFER, 1),
    ] {
        assert_eq!(read(&mut c, pname, 5), value, "{pname:#x}");
    }
    assert_eq!(attribute(&mut c, GL_VERTEX_ATTRIB_BINDING, 1), 5);
    assert_eq!(attribute(&mut c, GL_VERTEX_ATTRIB_RELATIVE_OFFSET, 1), 8);
    assert_eq!(attribute(&mut c, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, 1), 1);
    // A pointer call gives the attribute its own binding point.
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    c.vertex_attrib_pointer(1, 4, GL_UNSIGNED_BYTE, true, 16, Data::Offset(16));
    assert_eq!(attribute(&mut c, GL_VERTEX_ATTRIB_BINDING, 1), 1);
    assert_eq!(attribute(&mut c, GL_VERTEX_ATTRIB_RELATIVE_OFFSET, 1), 0);
    assert_eq!(read(&mut c, GL_VERTEX_BINDING_OFFSET, 1), 16);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.draw_arrays(GL_TRIANGLES, 0, 6);
    assert_eq!(picture(&mut c), wanted());
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

#[test]
fn a_stride_of_zero_and_a_divisor_repeat_one_element() {
    for divisor in [0, 1] {
        let mut c = with_vertices();
        c.vertex_attrib_format(0, 2, GL_FLOAT, false, 0);
        c.bind_vertex_buffer(0, 1, 8, 16);
        c.vertex_attrib_format(1, 4, GL_UNSIGNED_BYTE, true, 0);
        c.vertex_attrib_binding(1, 3);
        c.bind_vertex_buffer(3, 1, 16, if divisor == 0 { 0 } else { 16 });
        c.vertex_binding_divisor(3, divisor);
        assert_eq!(attribute(&mut c, GL_VERTEX_ATTRIB_ARRAY_DIVISOR, 1), divisor as GLint);
        // Twice, as the second may be added to the first.
        c.draw_arrays(GL_TRIANGLES, 0, 3);
        c.draw_arrays(GL_TRIANGLES, 3, 3);
        assert_eq!(picture(&mut c), wanted(), "divisor {divisor}");
    }
}

#[test]
fn what_a_client_writes_to_a_persistent_mapping_is_drawn() {
    let mut c = with_vertices();
    let bytes = vertices();
    c.bind_buffer(GL_ARRAY_BUFFER, 2);
    let flags = GL_MAP_WRITE_BIT | GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT;
    let size = bytes.len() as GLsizeiptr;
    c.buffer_storage(GL_ARRAY_BUFFER, size, Data::Null, flags | GL_DYNAMIC_STORAGE_BIT);
    c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 16, Data::Offset(8));
    c.vertex_attrib_pointer(1, 4, GL_UNSIGNED_BYTE, true, 16, Data::Offset(16));
    c.map_buffer_range(GL_ARRAY_BUFFER, 0, size, flags);
    // The first triangle, then the second, with the same call.
    for triangle in 0..2 {
        let mapped = c.mapped_bytes(GL_ARRAY_BUFFER).expect("it is mapped");
        mapped[8..56].copy_from_slice(&bytes[8 + 48 * triangle..56 + 48 * triangle]);
        c.draw_arrays(GL_TRIANGLES, 0, 3);
    }
    assert_eq!(picture(&mut c), wanted());
    // What GL writes is in the mapping, and what the client has written stays.
    c.mapped_bytes(GL_ARRAY_BUFFER).expect("it is mapped")[1] = 7;
    c.buffer_sub_data(GL_ARRAY_BUFFER, 4, 2, Data::Bytes(&[1, 2]));
    let mapped = c.mapped_bytes(GL_ARRAY_BUFFER).expect("it is mapped");
    assert_eq!(mapped[..8], [0, 7, 0, 0, 1, 2, 0, 0]);
    let mut found = [0; 8];
    c.get_buffer_sub_data(GL_ARRAY_BUFFER, 0, 8, DataOut::Bytes(&mut found));
    assert_eq!(found, [0, 7, 0, 0, 1, 2, 0, 0]);
    assert!(c.unmap_buffer(GL_ARRAY_BUFFER));
    c.get_buffer_sub_data(GL_ARRAY_BUFFER, 0, 8, DataOut::Bytes(&mut found));
    assert_eq!(found, [0, 7, 0, 0, 1, 2, 0, 0]);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

#[test]
fn storage_that_is_immutable_is_not_replaced() {
    let mut c = context();
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    c.buffer_storage(GL_ARRAY_BUFFER, 8, Data::Bytes(&[1; 8]), GL_MAP_READ_BIT);
    for (pname, wanted) in
        [(GL_BUFFER_IMMUTABLE_STORAGE, 1), (GL_BUFFER_STORAGE_FLAGS, GL_MAP_READ_BIT as GLint)]
    {
        let mut value = [0];
        c.get_buffer_parameteriv(GL_ARRAY_BUFFER, pname, &mut value);
        assert_eq!(value, [wanted]);
    }
    c.map_buffer_range(GL_ARRAY_BUFFER, 0, 8, GL_MAP_READ_BIT);
    assert_eq!(c.get_error(), GL_NO_ERROR);
    c.unmap_buffer(GL_ARRAY_BUFFER);
    let refused: &[fn(&mut Context)] = &[
        |c| c.buffer_data(GL_ARRAY_BUFFER, 8, Data::Null, GL_STATIC_DRAW),
        |c| c.buffer_sub_data(GL_ARRAY_BUFFER, 0, 1, Data::Bytes(&[2])),
        |c| c.buffer_storage(GL_ARRAY_BUFFER, 8, Data::Null, GL_MAP_READ_BIT),
        |c| {
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 8, GL_MAP_WRITE_BIT);
        },
        |c| {
            c.map_buffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
        },
    ];
    for call in refused {
        call(&mut c);
        assert_eq!(c.get_error(), GL_INVALID_OPERATION, "{:?}", c.messages());
    }
}
