//! Vertices: GL 2.1, sections 2.6 to 2.9. The attributes of immediate mode are in
//! [`super::attributes`].

use crate::base::args::{Data, DataOut, Pointers};
use crate::base::types::*;
use crate::calls::buffer::{
    clear as buffer_clear, data as buffers, invalidate as buffer_invalidate, map as buffer_map,
};
use crate::calls::vertex::{
    array_objects as vertex_arrays, arrays, bindings, counted, draws as calls, elements, immediate,
    indirect, interleaved, locked, rect, restart, runs,
};
use crate::query::arrays as query_arrays;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_vertices {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Allowed in immediate {
        /// Begins a group of vertices.
        begin: glBegin (mode: GLenum), not_compiled;
        /// Ends a group of vertices and draws them.
        end: glEnd (), not_compiled;
    }
    Refused in locked {
        /// Promises that `count` vertices from `first` on stay as they are.
        lock_arrays: glLockArraysEXT (first: GLint, count: GLsizei), not_compiled;
        /// Ends the promise.
        unlock_arrays: glUnlockArraysEXT (), not_compiled;
    }
    Refused in bindings {
        /// Sets the format of a generic attribute, and where it lies in an element of its binding point.
        vertex_attrib_format: glVertexAttribFormat (
            attribindex: GLuint, size: GLint, ty: GLenum, normalized: bool, relativeoffset: GLuint
        ), not_compiled;
        /// The same for integers that stay integers.
        vertex_attrib_i_format: glVertexAttribIFormat (
            attribindex: GLuint, size: GLint, ty: GLenum, relativeoffset: GLuint
        ), not_compiled;
        /// The same for doubles.
        vertex_attrib_l_format: glVertexAttribLFormat (
            attribindex: GLuint, size: GLint, ty: GLenum, relativeoffset: GLuint
        ), not_compiled;
        /// Sets the binding point that a generic attribute reads.
        vertex_attrib_binding: glVertexAttribBinding
            (attribindex: GLuint, bindingindex: GLuint), not_compiled;
        /// Binds a buffer to a binding point of generic attributes.
        bind_vertex_buffer: glBindVertexBuffer (
            bindingindex: GLuint, buffer: GLuint, offset: GLintptr, stride: GLsizei
        ), not_compiled;
        /// Lets the attributes of a binding point go on once in so many instances; 0 is once a vertex.
        vertex_binding_divisor: glVertexBindingDivisor
            (bindingindex: GLuint, divisor: GLuint), not_compiled;
    }
    Refused in arrays {
        /// Says where positions are. A slice is copied now; later writes to it are not seen.
        vertex_pointer: glVertexPointer
            (size: GLint, ty: GLenum, stride: GLsizei, pointer: Data<'a>), not_compiled;
        /// Says where normals are. A slice is copied now; later writes to it are not seen.
        normal_pointer: glNormalPointer (ty: GLenum, stride: GLsizei, pointer: Data<'a>), not_compiled;
        /// Says where colours are. A slice is copied now; later writes to it are not seen.
        color_pointer: glColorPointer
            (size: GLint, ty: GLenum, stride: GLsizei, pointer: Data<'a>), not_compiled;
        /// Says where secondary colours are. A slice is copied now; later writes to it are not
        /// seen.
        secondary_color_pointer: glSecondaryColorPointer | glSecondaryColorPointerEXT
            (size: GLint, ty: GLenum, stride: GLsizei, pointer: Data<'a>), not_compiled;
        /// Says where fog coordinates are. A slice is copied now; later writes to it are not seen.
        fog_coord_pointer: glFogCoordPointer | glFogCoordPointerEXT
            (ty: GLenum, stride: GLsizei, pointer: Data<'a>), not_compiled;
        /// Says where the client's active unit's texture coordinates are. A slice is copied now;
        /// later writes to it are not seen.
        tex_coord_pointer: glTexCoordPointer
            (size: GLint, ty: GLenum, stride: GLsizei, pointer: Data<'a>), not_compiled;
        /// Says where colour indices are. A slice is copied now; later writes to it are not seen.
        index_pointer: glIndexPointer (ty: GLenum, stride: GLsizei, pointer: Data<'a>), not_compiled;
        /// Says where a generic attribute is. A slice is copied now; later writes to it are not
        /// seen.
        vertex_attrib_pointer: glVertexAttribPointer | glVertexAttribPointerARB (
            index: GLuint, size: GLint, ty: GLenum, normalized: bool, stride: GLsizei,
            pointer: Data<'a>
        ), not_compiled;
        /// Says where a generic attribute of integers is. A slice is copied now; later writes to it
        /// are not seen.
        vertex_attrib_i_pointer: glVertexAttribIPointer | glVertexAttribIPointerEXT (
            index: GLuint, size: GLint, ty: GLenum, stride: GLsizei, pointer: Data<'a>
        ), not_compiled;
        /// Lets a generic attribute go on once in so many instances; 0 is once a vertex.
        vertex_attrib_divisor: glVertexAttribDivisor | glVertexAttribDivisorARB
            (index: GLuint, divisor: GLuint), not_compiled;
        /// Switches the array of a generic attribute on.
        enable_vertex_attrib_array: glEnableVertexAttribArray | glEnableVertexAttribArrayARB
            (index: GLuint), not_compiled;
        /// Switches the array of a generic attribute off.
        disable_vertex_attrib_array: glDisableVertexAttribArray | glDisableVertexAttribArrayARB
            (index: GLuint), not_compiled;
    }
    Refused in counted {
        /// Says where positions are, and how many. A slice is copied now.
        vertex_pointer_ext: glVertexPointerEXT
            (size: GLint, ty: GLenum, stride: GLsizei, count: GLsizei, pointer: Data<'a>), not_compiled;
        /// Says where normals are, and how many. A slice is copied now.
        normal_pointer_ext: glNormalPointerEXT
            (ty: GLenum, stride: GLsizei, count: GLsizei, pointer: Data<'a>), not_compiled;
        /// Says where colours are, and how many. A slice is copied now.
        color_pointer_ext: glColorPointerEXT
            (size: GLint, ty: GLenum, stride: GLsizei, count: GLsizei, pointer: Data<'a>), not_compiled;
        /// Says where texture coordinates are, and how many. A slice is copied now.
        tex_coord_pointer_ext: glTexCoordPointerEXT
            (size: GLint, ty: GLenum, stride: GLsizei, count: GLsizei, pointer: Data<'a>), not_compiled;
        /// Says where colour indices are, and how many. A slice is copied now.
        index_pointer_ext: glIndexPointerEXT
            (ty: GLenum, stride: GLsizei, count: GLsizei, pointer: Data<'a>), not_compiled;
        /// Says where edge flags are, and how many. A slice is copied now.
        edge_flag_pointer_ext: glEdgeFlagPointerEXT
            (stride: GLsizei, count: GLsizei, pointer: Data<'a>), not_compiled;
    }
    Refused in query_arrays {
        /// Where the array of a generic attribute begins; an offset for one in a buffer.
        get_vertex_attrib_pointerv: glGetVertexAttribPointerv | glGetVertexAttribPointervARB
            (index: GLuint, pname: GLenum, pointer: &'a mut [*mut GLvoid]);
        /// Reads what is known of a generic attribute.
        get_vertex_attribfv: glGetVertexAttribfv | glGetVertexAttribfvARB
            (index: GLuint, pname: GLenum, params: &'a mut [GLfloat]);
        /// Reads what is known of a generic attribute.
        get_vertex_attribiv: glGetVertexAttribiv | glGetVertexAttribivARB
            (index: GLuint, pname: GLenum, params: &'a mut [GLint]);
    }
    Allowed in calls {
        /// Sets every attribute that has an array to an element of it, and ends the vertex.
        array_element: glArrayElement | glArrayElementEXT (i: GLint), not_compiled;
    }
    Allowed in restart {
        /// Ends a primitive and begins another, between `glBegin` and `glEnd`.
        primitive_restart: glPrimitiveRestartNV ();
    }
    Refused in rect {
        /// Draws a rectangle.
        rects: glRects (x1: GLshort, y1: GLshort, x2: GLshort, y2: GLshort);
        /// Draws a rectangle.
        rectsv: glRectsv (v1: &'a [GLshort], v2: &'a [GLshort]);
        /// Draws a rectangle.
        recti: glRecti (x1: GLint, y1: GLint, x2: GLint, y2: GLint);
        /// Draws a rectangle.
        rectiv: glRectiv (v1: &'a [GLint], v2: &'a [GLint]);
        /// Draws a rectangle.
        rectf: glRectf (x1: GLfloat, y1: GLfloat, x2: GLfloat, y2: GLfloat);
        /// Draws a rectangle.
        rectfv: glRectfv (v1: &'a [GLfloat], v2: &'a [GLfloat]);
        /// Draws a rectangle.
        rectd: glRectd (x1: GLdouble, y1: GLdouble, x2: GLdouble, y2: GLdouble);
        /// Draws a rectangle.
        rectdv: glRectdv (v1: &'a [GLdouble], v2: &'a [GLdouble]);
    }
    Refused in restart {
        /// The index that restarts a primitive while `GL_PRIMITIVE_RESTART` is on.
        primitive_restart_index: glPrimitiveRestartIndex | glPrimitiveRestartIndexNV
            (index: GLuint), not_compiled;
    }
    Refused in interleaved {
        /// Says where several attributes are that lie side by side, and which arrays are on.
        interleaved_arrays: glInterleavedArrays
            (format: GLenum, stride: GLsizei, pointer: Data<'a>), not_compiled;
    }
    Refused in vertex_arrays {
        /// Makes `n` unused names of vertex array objects.
        gen_vertex_arrays: glGenVertexArrays | glGenVertexArraysOES (n: GLsizei, arrays: &'a mut [GLuint]);
        /// Deletes vertex array objects; a bound one is unbound.
        delete_vertex_arrays: glDeleteVertexArrays | glDeleteVertexArraysOES (n: GLsizei, arrays: &'a [GLuint]), not_compiled;
        /// Makes a vertex array object the current one; 0 is the default one.
        bind_vertex_array: glBindVertexArray | glBindVertexArrayOES (array: GLuint), not_compiled;
        /// Whether a name is a vertex array object that has been bound.
        is_vertex_array: glIsVertexArray | glIsVertexArrayOES (array: GLuint) -> bool;
    }
    Refused in indirect {
        /// Draws with the arguments of `glDrawArraysInstanced` that lie in a buffer.
        draw_arrays_indirect: glDrawArraysIndirect (mode: GLenum, indirect: Data<'a>), not_compiled;
        /// Draws by index with the arguments that lie in a buffer.
        draw_elements_indirect: glDrawElementsIndirect
            (mode: GLenum, ty: GLenum, indirect: Data<'a>), not_compiled;
        /// Several `glDrawArraysIndirect`.
        multi_draw_arrays_indirect: glMultiDrawArraysIndirect (
            mode: GLenum, indirect: Data<'a>, drawcount: GLsizei, stride: GLsizei
        ), not_compiled;
        /// Several `glDrawElementsIndirect`.
        multi_draw_elements_indirect: glMultiDrawElementsIndirect (
            mode: GLenum, ty: GLenum, indirect: Data<'a>, drawcount: GLsizei, stride: GLsizei
        ), not_compiled;
        /// As `glDrawElementsInstanced`; arrays with a divisor begin at element `baseinstance`.
        draw_elements_instanced_base_instance: glDrawElementsInstancedBaseInstance (
            mode: GLenum, count: GLsizei, ty: GLenum, indices: Data<'a>, instancecount: GLsizei,
            baseinstance: GLuint
        ), not_compiled;
        /// As `glDrawElementsInstancedBaseVertex`; arrays with a divisor begin at element `baseinstance`.
        draw_elements_instanced_base_vertex_base_instance: glDrawElementsInstancedBaseVertexBaseInstance (
            mode: GLenum, count: GLsizei, ty: GLenum, indices: Data<'a>, instancecount: GLsizei,
            basevertex: GLint, baseinstance: GLuint
        ), not_compiled;
    }
    Refused in calls {
        /// Draws `count` vertices of the arrays from `first` on.
        draw_arrays: glDrawArrays | glDrawArraysEXT (mode: GLenum, first: GLint, count: GLsizei), not_compiled;
        /// Draws the same vertices of the arrays many times; `gl_InstanceID` counts.
        draw_arrays_instanced: glDrawArraysInstanced | glDrawArraysInstancedARB
                | glDrawArraysInstancedEXT
            (mode: GLenum, first: GLint, count: GLsizei, instancecount: GLsizei), not_compiled;
    }
    Refused in elements {
        /// Draws vertices of the arrays by index many times; `gl_InstanceID` counts.
        draw_elements_instanced: glDrawElementsInstanced | glDrawElementsInstancedARB
                | glDrawElementsInstancedEXT (
            mode: GLenum, count: GLsizei, ty: GLenum, indices: Data<'a>, instancecount: GLsizei
        ), not_compiled;
    }
    Refused in calls {
        /// As `glDrawArraysInstanced`; arrays with a divisor begin at element `baseinstance`.
        draw_arrays_instanced_base_instance: glDrawArraysInstancedBaseInstance (
            mode: GLenum, first: GLint, count: GLsizei, instancecount: GLsizei, baseinstance: GLuint
        ), not_compiled;
    }
    Refused in elements {
        /// Draws vertices of the arrays by index; `basevertex` is added to each.
        draw_elements_base_vertex: glDrawElementsBaseVertex (
            mode: GLenum, count: GLsizei, ty: GLenum, indices: Data<'a>, basevertex: GLint
        ), not_compiled;
        /// As `glDrawElementsBaseVertex`; all indices are promised to be `start` to `end`.
        draw_range_elements_base_vertex: glDrawRangeElementsBaseVertex (
            mode: GLenum, start: GLuint, end: GLuint, count: GLsizei, ty: GLenum,
            indices: Data<'a>, basevertex: GLint
        ), not_compiled;
        /// As `glDrawElementsInstanced`; `basevertex` is added to each index.
        draw_elements_instanced_base_vertex: glDrawElementsInstancedBaseVertex (
            mode: GLenum, count: GLsizei, ty: GLenum, indices: Data<'a>, instancecount: GLsizei,
            basevertex: GLint
        ), not_compiled;
        /// Draws vertices of the arrays by index.
        draw_elements: glDrawElements
            (mode: GLenum, count: GLsizei, ty: GLenum, indices: Data<'a>), not_compiled;
        /// Draws vertices of the arrays by index; all are promised to be `start` to `end`.
        draw_range_elements: glDrawRangeElements | glDrawRangeElementsEXT (
            mode: GLenum, start: GLuint, end: GLuint, count: GLsizei, ty: GLenum,
            indices: Data<'a>
        ), not_compiled;
    }
    Refused in runs {
        /// As `glMultiDrawElements`; each run has its own `basevertex`.
        multi_draw_elements_base_vertex: glMultiDrawElementsBaseVertex (
            mode: GLenum, count: &'a [GLsizei], ty: GLenum, indices: Pointers<'a>,
            drawcount: GLsizei, basevertex: &'a [GLint]
        ), not_compiled;
        /// Draws by several runs of indices.
        multi_draw_elements: glMultiDrawElements | glMultiDrawElementsEXT (
            mode: GLenum, count: &'a [GLsizei], ty: GLenum, indices: Pointers<'a>,
            drawcount: GLsizei
        ), not_compiled;
        /// Draws several runs of vertices of the arrays.
        multi_draw_arrays: glMultiDrawArrays | glMultiDrawArraysEXT
            (mode: GLenum, first: &'a [GLint], count: &'a [GLsizei], primcount: GLsizei), not_compiled;
    }
    Refused in buffers {
        /// Makes `n` unused buffer names.
        gen_buffers: glGenBuffers | glGenBuffersARB (n: GLsizei, buffers: &'a mut [GLuint]);
        /// Deletes buffers; bound ones are unbound.
        delete_buffers: glDeleteBuffers | glDeleteBuffersARB (n: GLsizei, buffers: &'a [GLuint]), not_compiled;
    }
    Setter in buffers {
        /// Makes a buffer the current one of a target.
        bind_buffer: glBindBuffer | glBindBufferARB (target: GLenum, buffer: GLuint), not_compiled;
    }
    Refused in buffers {
        /// Whether a name is a buffer that has been bound.
        is_buffer: glIsBuffer | glIsBufferARB (buffer: GLuint) -> bool;
        /// Fills a buffer anew with `size` bytes; `NULL` gives zeros.
        buffer_data: glBufferData | glBufferDataARB
            (target: GLenum, size: GLsizeiptr, data: Data<'a>, usage: GLenum), not_compiled;
        /// Gives a buffer its bytes for good; `flags` say what may be done with them.
        buffer_storage: glBufferStorage | glBufferStorageEXT
            (target: GLenum, size: GLsizeiptr, data: Data<'a>, flags: GLbitfield), not_compiled;
        /// Replaces a part of a buffer.
        buffer_sub_data: glBufferSubData | glBufferSubDataARB
            (target: GLenum, offset: GLintptr, size: GLsizeiptr, data: Data<'a>), not_compiled;
        /// Reads a part of a buffer.
        get_buffer_sub_data: glGetBufferSubData | glGetBufferSubDataARB
            (target: GLenum, offset: GLintptr, size: GLsizeiptr, data: DataOut<'a>);
    }
    Refused in buffer_clear {
        /// Fills a buffer with one value, converted to a format of buffer textures; zeros where `data` is null.
        clear_buffer_data: glClearBufferData (
            target: GLenum, internalformat: GLenum, format: GLenum, ty: GLenum, data: Data<'a>
        ), not_compiled;
        /// Fills a range of a buffer with one value, converted to a format of buffer textures; zeros where `data` is null.
        clear_buffer_sub_data: glClearBufferSubData (
            target: GLenum, internalformat: GLenum, offset: GLintptr, size: GLsizeiptr,
            format: GLenum, ty: GLenum, data: Data<'a>
        ), not_compiled;
    }
    Refused in buffer_invalidate {
        /// Says that the contents of a buffer will not be used.
        invalidate_buffer_data: glInvalidateBufferData (buffer: GLuint), not_compiled;
        /// Says that a part of the contents of a buffer will not be used.
        invalidate_buffer_sub_data: glInvalidateBufferSubData
            (buffer: GLuint, offset: GLintptr, length: GLsizeiptr), not_compiled;
    }
    Refused in buffer_map {
        /// Gives the buffer's bytes to the client until `glUnmapBuffer`; see also
        /// [`crate::Context::mapped_bytes`].
        map_buffer: glMapBuffer | glMapBufferARB | glMapBufferOES (target: GLenum, access: GLenum) -> *mut GLvoid;
        /// Gives a part of the buffer's bytes to the client until `glUnmapBuffer`.
        map_buffer_range: glMapBufferRange | glMapBufferRangeEXT (
            target: GLenum, offset: GLintptr, length: GLsizeiptr, access: GLbitfield
        ) -> *mut GLvoid;
        /// Says which mapped bytes were written; all are taken at `glUnmapBuffer`.
        flush_mapped_buffer_range: glFlushMappedBufferRange | glFlushMappedBufferRangeEXT
            (target: GLenum, offset: GLintptr, length: GLsizeiptr), not_compiled;
        /// Takes the bytes back; false if it was not mapped.
        unmap_buffer: glUnmapBuffer | glUnmapBufferARB | glUnmapBufferOES (target: GLenum) -> bool;
        /// Copies bytes from a buffer to another, or to itself.
        copy_buffer_sub_data: glCopyBufferSubData (
            readtarget: GLenum, writetarget: GLenum, readoffset: GLintptr, writeoffset: GLintptr,
            size: GLsizeiptr
        ), not_compiled;
        /// Where a buffer is mapped; null if it is not.
        get_buffer_pointerv: glGetBufferPointerv | glGetBufferPointervARB | glGetBufferPointervOES
            (target: GLenum, pname: GLenum, params: &'a mut [*mut GLvoid]);
        /// Reads what is known of a buffer.
        get_buffer_parameteriv: glGetBufferParameteriv | glGetBufferParameterivARB
            (target: GLenum, pname: GLenum, params: &'a mut [GLint]);
        /// Reads what is known of a buffer, with sizes that an integer may not hold.
        get_buffer_parameteri64v: glGetBufferParameteri64v
            (target: GLenum, pname: GLenum, params: &'a mut [GLint64]);
    }
    } };
}
entry_points_vertices!(implement);
