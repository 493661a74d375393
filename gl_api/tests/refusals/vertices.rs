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
        "target = GL_TEXTURE_2D must be GL_ARRAY_BUFFER",
    ),
    (
        "map: access",
        nothing,
        |c| {
            c.map_buffer(GL_ARRAY_BUFFER, GL_READ_BUFFER);
        },
        GL_INVALID_ENUM,
        "access = GL_READ_BUFFER must be GL_READ_ONLY, GL_WRITE_ONLY or GL_READ_WRITE",
    ),
    (
        "map: none bound",
        nothing,
        |c| {
            c.map_buffer(GL_PIXEL_PACK_BUFFER, GL_READ_ONLY);
        },
        GL_INVALID_OPERATION,
        "no buffer is bound to GL_PIXEL_PACK_BUFFER",
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
        "the buffer is mapped: call glUnmapBuffer",
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
        "the buffer is mapped: call glUnmapBuffer",
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
        "the buffer is mapped: call glUnmapBuffer",
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
        "more bytes of indices than a pointer of 32 bits can count",
        |c| {
            c.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, 1);
        },
        |c| {
            c.draw_elements(GL_TRIANGLES, 1 << 30, GL_UNSIGNED_INT, Data::Offset(0));
        },
        GL_INVALID_OPERATION,
        "count = 1073741824 indices from byte 0 reach past the buffer's 64 bytes",
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
            c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0xf7ff_0000));
        },
        |c| {
            c.draw_arrays(GL_TRIANGLES, 0, 3);
        },
        GL_INVALID_OPERATION,
        "GL_VERTEX_ARRAY reads buffer 1 from byte 4160684032 on, which looks like a pointer",
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
        "buffer 1 is bound for pixels and mapped",
    ),
    (
        "range: negative",
        nothing,
        |c| {
            c.map_buffer_range(GL_ARRAY_BUFFER, -1, 1, GL_MAP_READ_BIT);
        },
        GL_INVALID_VALUE,
        "offset = -1 must not be negative",
    ),
    (
        "range: too far",
        nothing,
        |c| {
            c.map_buffer_range(GL_ARRAY_BUFFER, 60, 5, GL_MAP_READ_BIT);
        },
        GL_INVALID_VALUE,
        "reach past the buffer's 64 bytes",
    ),
    (
        "range: bits",
        nothing,
        |c| {
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 1, 0x8000);
        },
        GL_INVALID_VALUE,
        "access = 0x8000 has bits that are none",
    ),
    (
        "range: empty",
        nothing,
        |c| {
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 0, GL_MAP_READ_BIT);
        },
        GL_INVALID_OPERATION,
        "length = 0 must be above 0",
    ),
    (
        "range: neither",
        nothing,
        |c| {
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 1, GL_MAP_UNSYNCHRONIZED_BIT);
        },
        GL_INVALID_OPERATION,
        "must have GL_MAP_READ_BIT or GL_MAP_WRITE_BIT",
    ),
    (
        "range: reads what is invalid",
        nothing,
        |c| {
            let access = GL_MAP_READ_BIT | GL_MAP_INVALIDATE_RANGE_BIT;
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 1, access);
        },
        GL_INVALID_OPERATION,
        "GL_MAP_READ_BIT goes with no INVALIDATE or UNSYNCHRONIZED bit",
    ),
    (
        "range: flush without write",
        nothing,
        |c| {
            let access = GL_MAP_READ_BIT | GL_MAP_FLUSH_EXPLICIT_BIT;
            c.map_buffer_range(GL_ARRAY_BUFFER, 0, 1, access);
        },
        GL_INVALID_OPERATION,
        "GL_MAP_FLUSH_EXPLICIT_BIT, which needs GL_MAP_WRITE_BIT",
    ),
    (
        "flush: not mapped",
        nothing,
        |c| {
            c.flush_mapped_buffer_range(GL_ARRAY_BUFFER, 0, 1);
        },
        GL_INVALID_OPERATION,
        "the buffer is not mapped",
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
        "mapped without GL_MAP_FLUSH_EXPLICIT_BIT: add it to the access of glMapBufferRange",
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
        "reach past the 4 mapped bytes",
    ),
    (
        "unmap: not mapped",
        nothing,
        |c| {
            c.unmap_buffer(GL_ARRAY_BUFFER);
        },
        GL_INVALID_OPERATION,
        "the buffer is not mapped",
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
        "bytes 0..2 and 1..3 of the same buffer must not overlap",
    ),
    (
        "copy: too far",
        nothing,
        |c| {
            c.copy_buffer_sub_data(GL_ARRAY_BUFFER, GL_ARRAY_BUFFER, 0, 60, 5);
        },
        GL_INVALID_VALUE,
        "reach past the buffer's 64 bytes",
    ),
    (
        "pointer: pname",
        nothing,
        |c| {
            let pointer = &mut [std::ptr::null_mut()];
            c.get_buffer_pointerv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, pointer);
        },
        GL_INVALID_ENUM,
        "pname = GL_BUFFER_SIZE must be GL_BUFFER_MAP_POINTER",
    ),
    (
        "parameter: pname",
        nothing,
        |c| {
            c.get_buffer_parameteriv(GL_ARRAY_BUFFER, GL_TEXTURE_2D, &mut [0]);
        },
        GL_INVALID_ENUM,
        "pname = GL_TEXTURE_2D must be GL_BUFFER_SIZE",
    ),
    (
        "parameter of 64 bits: pname",
        nothing,
        |c| {
            c.get_buffer_parameteri64v(GL_ARRAY_BUFFER, GL_TEXTURE_2D, &mut [0]);
        },
        GL_INVALID_ENUM,
        "pname = GL_TEXTURE_2D must be GL_BUFFER_SIZE",
    ),
    (
        "instances in a list",
        |c| c.new_list(1, GL_COMPILE),
        |c| c.draw_arrays_instanced(GL_POINTS, 0, 1, 1),
        GL_INVALID_OPERATION,
        "not compiled into lists",
    ),
    (
        "instances",
        nothing,
        |c| c.draw_arrays_instanced(GL_POINTS, 0, 1, -1),
        GL_INVALID_VALUE,
        "primcount = -1 must not be negative",
    ),
    (
        "instances of elements",
        nothing,
        |c| {
            let indices = Data::Bytes(&[0]);
            c.draw_elements_instanced(GL_POINTS, 1, GL_UNSIGNED_BYTE, indices, -1);
        },
        GL_INVALID_VALUE,
        "primcount = -1 must not be negative",
    ),
    (
        "runs",
        nothing,
        |c| c.multi_draw_arrays(GL_POINTS, &[], &[], -1),
        GL_INVALID_VALUE,
        "primcount = -1 must not be negative",
    ),
    (
        "too few runs",
        nothing,
        |c| c.multi_draw_arrays(GL_POINTS, &[0], &[], 1),
        GL_INVALID_OPERATION,
        "primcount = 1, but",
    ),
    (
        "too few runs of indices",
        nothing,
        |c| {
            c.multi_draw_elements(GL_POINTS, &[1], GL_UNSIGNED_BYTE, Pointers(Vec::new()), 1);
        },
        GL_INVALID_OPERATION,
        "primcount = 1, but",
    ),
    ("element", nothing, |c| c.array_element(-1), GL_INVALID_VALUE, "i = -1 must not be negative"),
    (
        "restart outside",
        nothing,
        |c| c.primitive_restart(),
        GL_INVALID_OPERATION,
        "must be called between glBegin and glEnd",
    ),
    (
        "interleaved: format",
        nothing,
        |c| {
            c.interleaved_arrays(GL_FLOAT, 0, Data::Null);
        },
        GL_INVALID_ENUM,
        "format = GL_FLOAT must be GL_V2F",
    ),
    (
        "interleaved: stride",
        nothing,
        |c| {
            c.interleaved_arrays(GL_V2F, -1, Data::Null);
        },
        GL_INVALID_VALUE,
        "stride = -1 must not be negative",
    ),
    (
        "integer pointer: type",
        nothing,
        |c| {
            c.vertex_attrib_i_pointer(1, 2, GL_FLOAT, 0, Data::Offset(0));
        },
        GL_INVALID_ENUM,
        "type = GL_FLOAT must be GL_BYTE",
    ),
    (
        "integer pointer: size",
        nothing,
        |c| {
            c.vertex_attrib_i_pointer(1, 5, GL_INT, 0, Data::Offset(0));
        },
        GL_INVALID_VALUE,
        "size = 5 must be 1 to 4",
    ),
    (
        "divisor",
        nothing,
        |c| c.vertex_attrib_divisor(99, 1),
        GL_INVALID_VALUE,
        "must be below GL_MAX_VERTEX_ATTRIBS, 16",
    ),
    (
        "the position has no value",
        nothing,
        |c| {
            c.get_vertex_attribfv(0, GL_CURRENT_VERTEX_ATTRIB, &mut [0.0; 4]);
        },
        GL_INVALID_OPERATION,
        "index = 0 has no current value: it is the position",
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
