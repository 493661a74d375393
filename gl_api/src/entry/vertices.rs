//! Vertices: GL 2.1, sections 2.6 to 2.9. The attributes of immediate mode are in
//! [`super::attributes`].

use super::{Data, DataOut};
use crate::draw::{arrays, calls, immediate};
use crate::object::buffers;
use crate::types::*;

entry_points! {
    VERTICES;
    Anywhere in immediate {
        /// Begins a group of vertices.
        begin: glBegin (mode: GLenum);
        /// Ends a group of vertices and draws them.
        end: glEnd ();
    }
    Outside in arrays {
        /// Says where positions are. A slice is copied now; later writes to it are not seen.
        vertex_pointer: glVertexPointer
            (size: GLint, ty: GLenum, stride: GLsizei, pointer: Data<'a>);
        /// Says where normals are. A slice is copied now; later writes to it are not seen.
        normal_pointer: glNormalPointer (ty: GLenum, stride: GLsizei, pointer: Data<'a>);
        /// Says where colours are. A slice is copied now; later writes to it are not seen.
        color_pointer: glColorPointer
            (size: GLint, ty: GLenum, stride: GLsizei, pointer: Data<'a>);
        /// Says where secondary colours are. A slice is copied now; later writes to it are not
        /// seen.
        secondary_color_pointer: glSecondaryColorPointer | glSecondaryColorPointerEXT
            (size: GLint, ty: GLenum, stride: GLsizei, pointer: Data<'a>);
        /// Says where fog coordinates are. A slice is copied now; later writes to it are not seen.
        fog_coord_pointer: glFogCoordPointer | glFogCoordPointerEXT
            (ty: GLenum, stride: GLsizei, pointer: Data<'a>);
        /// Says where the client's active unit's texture coordinates are. A slice is copied now;
        /// later writes to it are not seen.
        tex_coord_pointer: glTexCoordPointer
            (size: GLint, ty: GLenum, stride: GLsizei, pointer: Data<'a>);
        /// Says where a generic attribute is. A slice is copied now; later writes to it are not
        /// seen.
        vertex_attrib_pointer: glVertexAttribPointer | glVertexAttribPointerARB (
            index: GLuint, size: GLint, ty: GLenum, normalized: bool, stride: GLsizei,
            pointer: Data<'a>
        );
        /// Switches the array of a generic attribute on.
        enable_vertex_attrib_array: glEnableVertexAttribArray | glEnableVertexAttribArrayARB
            (index: GLuint);
        /// Switches the array of a generic attribute off.
        disable_vertex_attrib_array: glDisableVertexAttribArray | glDisableVertexAttribArrayARB
            (index: GLuint);
        /// Reads what is known of a generic attribute.
        get_vertex_attribfv: glGetVertexAttribfv | glGetVertexAttribfvARB
            (index: GLuint, pname: GLenum, params: &'a mut [GLfloat]);
        /// Reads what is known of a generic attribute.
        get_vertex_attribiv: glGetVertexAttribiv | glGetVertexAttribivARB
            (index: GLuint, pname: GLenum, params: &'a mut [GLint]);
    }
    Outside in calls {
        /// Draws `count` vertices of the arrays from `first` on.
        draw_arrays: glDrawArrays (mode: GLenum, first: GLint, count: GLsizei);
        /// Draws several runs of vertices of the arrays.
        multi_draw_arrays: glMultiDrawArrays
            (mode: GLenum, first: &'a [GLint], count: &'a [GLsizei], primcount: GLsizei);
        /// Draws vertices of the arrays by index.
        draw_elements: glDrawElements
            (mode: GLenum, count: GLsizei, ty: GLenum, indices: Data<'a>);
        /// Draws vertices of the arrays by index; all are promised to be `start` to `end`.
        draw_range_elements: glDrawRangeElements (
            mode: GLenum, start: GLuint, end: GLuint, count: GLsizei, ty: GLenum,
            indices: Data<'a>
        );
    }
    Outside in buffers {
        /// Makes `n` unused buffer names.
        gen_buffers: glGenBuffers | glGenBuffersARB (n: GLsizei, buffers: &'a mut [GLuint]);
        /// Deletes buffers; bound ones are unbound.
        delete_buffers: glDeleteBuffers | glDeleteBuffersARB (n: GLsizei, buffers: &'a [GLuint]);
        /// Makes a buffer the current one of a target.
        bind_buffer: glBindBuffer | glBindBufferARB (target: GLenum, buffer: GLuint);
        /// Whether a name is a buffer that has been bound.
        is_buffer: glIsBuffer | glIsBufferARB (buffer: GLuint) -> bool;
        /// Fills a buffer anew with `size` bytes; `NULL` gives zeros.
        buffer_data: glBufferData | glBufferDataARB
            (target: GLenum, size: GLsizeiptr, data: Data<'a>, usage: GLenum);
        /// Replaces a part of a buffer.
        buffer_sub_data: glBufferSubData | glBufferSubDataARB
            (target: GLenum, offset: GLintptr, size: GLsizeiptr, data: Data<'a>);
        /// Reads a part of a buffer.
        get_buffer_sub_data: glGetBufferSubData | glGetBufferSubDataARB
            (target: GLenum, offset: GLintptr, size: GLsizeiptr, data: DataOut<'a>);
        /// Reads what is known of a buffer.
        get_buffer_parameteriv: glGetBufferParameteriv | glGetBufferParameterivARB
            (target: GLenum, pname: GLenum, params: &'a mut [GLint]);
    }
}
