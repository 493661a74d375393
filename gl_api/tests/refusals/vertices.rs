//! What the calls on vertices and buffers refuse.

use gl_api::*;

/// A name, what comes before, a call, the flag it must set, and words that its message must have.
type Case = (&'static str, fn(&mut Context), fn(&mut Context), GLenum, &'static str);

/// Most rows need nothing.
fn nothing(_: &mut Context) {}

/// With buffer 1 of 64 bytes bound to `GL_ARRAY_BUFFER`.
const BUFFER_ROWS: &[Case] = &[
    (
        "map: target",
        nothing,
        |c| {
            c.map_buffer(GL_TEXTURE_2D, GL_READ_ONLY);
        },
        GL_INVALID_ENUM,
        "",
    ),
    (
        "map: access",
        nothing,
        |c| {
            c.map_buffer(GL_ARRAY_BUFFER, GL_READ_BUFFER);
        },
        GL_INVALID_ENUM,
        "",
    ),
    (
        "map: none bound",
        nothing,
        |c| {
            c.map_buffer(GL_PIXEL_PACK_BUFFER, GL_READ_ONLY);
        },
        GL_INVALID_OPERATION,
        "",
    ),
    (
        "map: twice",
        |c| {
            c.map_buffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
        },
        |c| {
            c.map_buffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
        },
        GL_INVALID_OPERATION,
        "",
    ),
    (
        "data of a mapped buffer",
        |c| {
            c.map_buffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
        },
        |c| {
            c.buffer_sub_data(GL_ARRAY_BUFFER, 0, 1, Data::Bytes(&[0]));
        },
        GL_INVALID_OPERATION,
        "",
    ),
    (
        "reading a mapped buffer",
        |c| {
            c.map_buffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
        },
        |c| {
            c.get_buffer_sub_data(GL_ARRAY_BUFFER, 0, 1, DataOut::Bytes(&mut [0]));
        },
        GL_INVALID_OPERATION,
        "",
    ),
    (
        "drawing from a mapped buffer",
        |c| {
            c.enable_client_state(GL_VERTEX_ARRAY);
            c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
            c.map_buffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
        },
        |c| {
            c.draw_arrays(GL_TRIANGLES, 0, 3);
        },
        GL_INVALID_OPERATION,
        "GL_VERTEX_ARRAY reads buffer 1, which is mapped: call glUnmapBuffer",
    ),
    (
        "drawing from a mapped buffer by index",
        |c| {
            c.enable_vertex_attrib_array(0);
            c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 0, Data::Offset(0));
            c.map_buffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
        },
        |c| {
            c.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, Data::Bytes(&[0, 1, 2]));
        },
        GL_INVALID_OPERATION,
        "array 0 reads buffer 1, which is mapped",
    ),
    (
        "drawing colours from a mapped buffer",
        |c| {
            c.enable_client_state(GL_COLOR_ARRAY);
            c.color_pointer(4, GL_UNSIGNED_BYTE, 0, Data::Offset(0));
            c.map_buffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
            c.bind_buffer(GL_ARRAY_BUFFER, 0);
            c.enable_client_state(GL_VERTEX_ARRAY);
            c.vertex_pointer(2, GL_FLOAT, 0, Data::Bytes(&[0; 24]));
        },
        |c| {
            c.draw_arrays(GL_TRIANGLES, 0, 3);
        },
        GL_INVALID_OPERATION,
        "GL_COLOR_ARRAY reads buffer 1, which is mapped",
    ),
    (
        "an element of a mapped buffer",
        |c| {
            c.client_active_texture(GL_TEXTURE1);
            c.enable_client_state(GL_TEXTURE_COORD_ARRAY);
            c.tex_coord_pointer(2, GL_FLOAT, 0, Data::Offset(0));
            c.map_buffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
        },
        |c| {
            c.array_element(0);
        },
        GL_INVALID_OPERATION,
        "GL_TEXTURE_COORD_ARRAY of unit 1 reads buffer 1, which is mapped",
    ),
    (
        "indices in a mapped buffer",
        |c| {
            c.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, 1);
            c.map_buffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
        },
        |c| {
            c.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, Data::Offset(0));
        },
        GL_INVALID_OPERATION,
        "buffer 1 is bound to GL_ELEMENT_ARRAY_BUFFER and mapped: call glUnmapBuffer",
    ),
    (
        "more vertices than the buffer has",
        |c| {
            c.enable_vertex_attrib_array(0);
            c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 0, Data::Offset(16));
        },
        |c| {
            c.draw_arrays(GL_TRIANGLES, 0, 9);
        },
        GL_INVALID_OPERATION,
        "vertices 0 to 8 end at byte 88, but array 0 reads buffer 1 (bound to GL_ARRAY_BUFFER when \
         its pointer was set) from byte 16 on, which has 64 bytes",
    ),
    (
        "a pointer for an offset",
        |c| {
            c.enable_client_state(GL_VERTEX_ARRAY);
            c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0x7fff_0000_0000));
        },
        |c| {
            c.draw_arrays(GL_TRIANGLES, 0, 3);
        },
        GL_INVALID_OPERATION,
        "GL_VERTEX_ARRAY reads buffer 1 from byte 140733193388032 on, which looks like a pointer",
    ),
    (
        "no memory",
        |c| {
            c.bind_buffer(GL_ARRAY_BUFFER, 0);
            c.enable_vertex_attrib_array(3);
            c.vertex_attrib_pointer(3, 2, GL_FLOAT, false, 0, Data::Null);
            c.enable_vertex_attrib_array(0);
            c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 0, Data::Null);
        },
        |c| {
            c.draw_arrays(GL_TRIANGLES, 0, 3);
        },
        GL_INVALID_OPERATION,
        "array 0 has no memory: no buffer was bound to GL_ARRAY_BUFFER",
    ),
    (
        "the location of no attribute",
        nothing,
        |c| c.enable_vertex_attrib_array(GLuint::MAX),
        GL_INVALID_VALUE,
        "index = -1 is what glGetAttribLocation answers",
    ),
    (
        "pixels in a mapped buffer",
        |c| {
            c.bind_buffer(GL_PIXEL_UNPACK_BUFFER, 1);
            c.map_buffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
        },
        |c| {
            let (rgb, ty) = (GL_RGB as GLint, GL_UNSIGNED_BYTE);
            c.tex_image_2d(GL_TEXTURE_2D, 0, rgb, 1, 1, 0, GL_RGB, ty, Data::Offset(0));
        },
        GL_INVALID_OPERATION,
        "",
    ),
    (
        "range: negative",
        nothing,
        |c| {
            c.map_buffer_range(GL_ARRAY_BUFFER, -1, 1, GL_MAP_READ_BIT);
        },
        GL_INVALID_VALUE,
        "",
    ),
    (
        "range: too far",
        nothing,
        |c| {
            c.map_buffer_range(GL_ARRAY_BUFFER, 60, 5, GL_MAP_READ_BIT);
        },
        GL_INVALID_VALUE,
        "",
    ),
    (
        "range: bits",
        nothing,
        |c| {
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 1, 0x8000);
        },
        GL_INVALID_VALUE,
        "",
    ),
    (
        "range: empty",
        nothing,
        |c| {
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 0, GL_MAP_READ_BIT);
        },
        GL_INVALID_OPERATION,
        "",
    ),
    (
        "range: neither",
        nothing,
        |c| {
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 1, GL_MAP_UNSYNCHRONIZED_BIT);
        },
        GL_INVALID_OPERATION,
        "",
    ),
    (
        "range: reads what is invalid",
        nothing,
        |c| {
            let access = GL_MAP_READ_BIT | GL_MAP_INVALIDATE_RANGE_BIT;
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 1, access);
        },
        GL_INVALID_OPERATION,
        "",
    ),
    (
        "range: flush without write",
        nothing,
        |c| {
            let access = GL_MAP_READ_BIT | GL_MAP_FLUSH_EXPLICIT_BIT;
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 1, access);
        },
        GL_INVALID_OPERATION,
        "",
    ),
    (
        "flush: not mapped",
        nothing,
        |c| {
            c.flush_mapped_buffer_range(GL_ARRAY_BUFFER, 0, 1);
        },
        GL_INVALID_OPERATION,
        "",
    ),
    (
        "flush: not explicit",
        |c| {
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 1, GL_MAP_WRITE_BIT);
        },
        |c| {
            c.flush_mapped_buffer_range(GL_ARRAY_BUFFER, 0, 1);
        },
        GL_INVALID_OPERATION,
        "",
    ),
    (
        "flush: too far",
        |c| {
            let access = GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT;
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 4, access);
        },
        |c| {
            c.flush_mapped_buffer_range(GL_ARRAY_BUFFER, 2, 3);
        },
        GL_INVALID_VALUE,
        "",
    ),
    (
        "unmap: not mapped",
        nothing,
        |c| {
            c.unmap_buffer(GL_ARRAY_BUFFER);
        },
        GL_INVALID_OPERATION,
        "",
    ),
    (
        "copy: overlap",
        |c| {
            c.bind_buffer(GL_COPY_READ_BUFFER, 1);
        },
        |c| {
            c.copy_buffer_sub_data(GL_COPY_READ_BUFFER, GL_ARRAY_BUFFER, 0, 1, 2);
        },
        GL_INVALID_VALUE,
        "",
    ),
    (
        "copy: too far",
        nothing,
        |c| {
            c.copy_buffer_sub_data(GL_ARRAY_BUFFER, GL_ARRAY_BUFFER, 0, 60, 5);
        },
        GL_INVALID_VALUE,
        "",
    ),
    (
        "pointer: pname",
        nothing,
        |c| {
            let pointer = &mut [std::ptr::null_mut()];
            c.get_buffer_pointerv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, pointer);
        },
        GL_INVALID_ENUM,
        "",
    ),
    (
        "parameter: pname",
        nothing,
        |c| {
            c.get_buffer_parameteriv(GL_ARRAY_BUFFER, GL_TEXTURE_2D, &mut [0]);
        },
        GL_INVALID_ENUM,
        "",
    ),
    (
        "instances in a list",
        |c| c.new_list(1, GL_COMPILE),
        |c| c.draw_arrays_instanced(GL_POINTS, 0, 1, 1),
        GL_INVALID_OPERATION,
        "not compiled into lists",
    ),
    ("instances", nothing, |c| c.draw_arrays_instanced(GL_POINTS, 0, 1, -1), GL_INVALID_VALUE, ""),
    (
        "instances of elements",
        nothing,
        |c| {
            let indices = Data::Bytes(&[0]);
            c.draw_elements_instanced(GL_POINTS, 1, GL_UNSIGNED_BYTE, indices, -1);
        },
        GL_INVALID_VALUE,
        "",
    ),
    ("runs", nothing, |c| c.multi_draw_arrays(GL_POINTS, &[], &[], -1), GL_INVALID_VALUE, ""),
    (
        "too few runs",
        nothing,
        |c| c.multi_draw_arrays(GL_POINTS, &[0], &[], 1),
        GL_INVALID_OPERATION,
        "",
    ),
    (
        "too few runs of indices",
        nothing,
        |c| {
            c.multi_draw_elements(GL_POINTS, &[1], GL_UNSIGNED_BYTE, Pointers(Vec::new()), 1);
        },
        GL_INVALID_OPERATION,
        "",
    ),
    ("element", nothing, |c| c.array_element(-1), GL_INVALID_VALUE, ""),
    ("restart outside", nothing, |c| c.primitive_restart(), GL_INVALID_OPERATION, ""),
    (
        "interleaved: format",
        nothing,
        |c| {
            c.interleaved_arrays(GL_FLOAT, 0, Data::Null);
        },
        GL_INVALID_ENUM,
        "",
    ),
    (
        "interleaved: stride",
        nothing,
        |c| {
            c.interleaved_arrays(GL_V2F, -1, Data::Null);
        },
        GL_INVALID_VALUE,
        "",
    ),
    (
        "integer pointer: type",
        nothing,
        |c| {
            c.vertex_attrib_i_pointer(1, 2, GL_FLOAT, 0, Data::Offset(0));
        },
        GL_INVALID_ENUM,
        "",
    ),
    (
        "integer pointer: size",
        nothing,
        |c| {
            c.vertex_attrib_i_pointer(1, 5, GL_INT, 0, Data::Offset(0));
        },
        GL_INVALID_VALUE,
        "",
    ),
    ("divisor", nothing, |c| c.vertex_attrib_divisor(99, 1), GL_INVALID_VALUE, ""),
    ("vertex array", nothing, |c| c.bind_vertex_array(77), GL_INVALID_OPERATION, ""),
    ("vertex arrays", nothing, |c| c.gen_vertex_arrays(-1, &mut []), GL_INVALID_VALUE, ""),
    ("no vertex arrays", nothing, |c| c.delete_vertex_arrays(-1, &[]), GL_INVALID_VALUE, ""),
    (
        "the position has no value",
        nothing,
        |c| {
            c.get_vertex_attribfv(0, GL_CURRENT_VERTEX_ATTRIB, &mut [0.0; 4]);
        },
        GL_INVALID_OPERATION,
        "",
    ),
];

/// Runs the rows.
pub fn run() {
    for (name, prepare, call, flag, words) in BUFFER_ROWS {
        let mut c = super::context();
        c.bind_buffer(GL_ARRAY_BUFFER, 1);
        c.buffer_data(GL_ARRAY_BUFFER, 64, Data::Null, GL_STATIC_DRAW);
        prepare(&mut c);
        super::row(&mut c, (*name).to_owned(), call, *flag, words);
    }
}
