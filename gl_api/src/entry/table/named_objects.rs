//! Buffers, framebuffers, vertex arrays and other objects by their names: `ARB_direct_state_access`.

use crate::base::args::{Data, DataOut};
use crate::base::types::*;
use crate::calls::buffer::named as named_buffers;
use crate::calls::captured_buffers;
use crate::calls::framebuffer::named as named_framebuffers;
use crate::calls::program::pipelines as named_pipelines;
use crate::calls::sync::named as named_queries;
use crate::calls::vertex::named as named_arrays;
use crate::query::vertex_array_objects;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_named_objects {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in captured_buffers {
        /// Makes `n` transform feedback objects.
        create_transform_feedbacks: glCreateTransformFeedbacks
            (n: GLsizei, ids: &'a mut [GLuint]);
        /// Binds a buffer, as long as it is when it is used, to a number of a transform feedback object.
        transform_feedback_buffer_base: glTransformFeedbackBufferBase
            (xfb: GLuint, index: GLuint, buffer: GLuint), not_compiled;
        /// Binds a part of a buffer to a number of a transform feedback object.
        transform_feedback_buffer_range: glTransformFeedbackBufferRange (
            xfb: GLuint, index: GLuint, buffer: GLuint, offset: GLintptr, size: GLsizeiptr
        ), not_compiled;
        /// Reads whether a transform feedback object is active or paused.
        get_transform_feedbackiv: glGetTransformFeedbackiv
            (xfb: GLuint, pname: GLenum, param: &'a mut [GLint]);
        /// Reads the name of a buffer of a transform feedback object.
        get_transform_feedbacki_v: glGetTransformFeedbacki_v
            (xfb: GLuint, pname: GLenum, index: GLuint, param: &'a mut [GLint]);
        /// Reads the range of a buffer of a transform feedback object.
        get_transform_feedbacki64_v: glGetTransformFeedbacki64_v
            (xfb: GLuint, pname: GLenum, index: GLuint, param: &'a mut [GLint64]);
    }
    Refused in named_buffers {
        /// Makes `n` buffers.
        create_buffers: glCreateBuffers (n: GLsizei, buffers: &'a mut [GLuint]);
        /// Gives a buffer its bytes for good.
        named_buffer_storage: glNamedBufferStorage
            (buffer: GLuint, size: GLsizeiptr, data: Data<'a>, flags: GLbitfield), not_compiled;
        /// Gives a buffer its bytes.
        named_buffer_data: glNamedBufferData
            (buffer: GLuint, size: GLsizeiptr, data: Data<'a>, usage: GLenum), not_compiled;
        /// Replaces some bytes of a buffer.
        named_buffer_sub_data: glNamedBufferSubData
            (buffer: GLuint, offset: GLintptr, size: GLsizeiptr, data: Data<'a>), not_compiled;
        /// Copies bytes from one buffer to another, or within one.
        copy_named_buffer_sub_data: glCopyNamedBufferSubData (
            read_buffer: GLuint, write_buffer: GLuint, read_offset: GLintptr,
            write_offset: GLintptr, size: GLsizeiptr
        ), not_compiled;
        /// Fills a buffer with one value.
        clear_named_buffer_data: glClearNamedBufferData (
            buffer: GLuint, internalformat: GLenum, format: GLenum, ty: GLenum, data: Data<'a>
        ), not_compiled;
        /// Fills a part of a buffer with one value.
        clear_named_buffer_sub_data: glClearNamedBufferSubData (
            buffer: GLuint, internalformat: GLenum, offset: GLintptr, size: GLsizeiptr,
            format: GLenum, ty: GLenum, data: Data<'a>
        ), not_compiled;
        /// Maps all bytes of a buffer.
        map_named_buffer: glMapNamedBuffer (buffer: GLuint, access: GLenum) -> *mut GLvoid;
        /// Maps some bytes of a buffer.
        map_named_buffer_range: glMapNamedBufferRange (
            buffer: GLuint, offset: GLintptr, length: GLsizeiptr, access: GLbitfield
        ) -> *mut GLvoid;
        /// Ends the mapping of a buffer.
        unmap_named_buffer: glUnmapNamedBuffer (buffer: GLuint) -> bool;
        /// Says that mapped bytes of a buffer were written.
        flush_mapped_named_buffer_range: glFlushMappedNamedBufferRange
            (buffer: GLuint, offset: GLintptr, length: GLsizeiptr), not_compiled;
        /// Reads what is known of a buffer.
        get_named_buffer_parameteriv: glGetNamedBufferParameteriv
            (buffer: GLuint, pname: GLenum, params: &'a mut [GLint]);
        /// Reads what is known of a buffer as integers of 64 bits.
        get_named_buffer_parameteri64v: glGetNamedBufferParameteri64v
            (buffer: GLuint, pname: GLenum, params: &'a mut [GLint64]);
        /// Reads where the mapped bytes of a buffer are.
        get_named_buffer_pointerv: glGetNamedBufferPointerv
            (buffer: GLuint, pname: GLenum, params: &'a mut [*mut GLvoid]);
        /// Reads some bytes of a buffer.
        get_named_buffer_sub_data: glGetNamedBufferSubData
            (buffer: GLuint, offset: GLintptr, size: GLsizeiptr, data: DataOut<'a>);
    }
    Refused in named_framebuffers {
        /// Makes `n` framebuffer objects.
        create_framebuffers: glCreateFramebuffers (n: GLsizei, framebuffers: &'a mut [GLuint]);
        /// Attaches a renderbuffer to a framebuffer.
        named_framebuffer_renderbuffer: glNamedFramebufferRenderbuffer (
            framebuffer: GLuint, attachment: GLenum, renderbuffertarget: GLenum,
            renderbuffer: GLuint
        ), not_compiled;
        /// Sets what a framebuffer object without attachments draws to.
        named_framebuffer_parameteri: glNamedFramebufferParameteri
            (framebuffer: GLuint, pname: GLenum, param: GLint), not_compiled;
        /// Attaches all layers of a level of a texture to a framebuffer.
        named_framebuffer_texture: glNamedFramebufferTexture
            (framebuffer: GLuint, attachment: GLenum, texture: GLuint, level: GLint), not_compiled;
        /// Attaches a slice of a volume or a layer of an array to a framebuffer.
        named_framebuffer_texture_layer: glNamedFramebufferTextureLayer (
            framebuffer: GLuint, attachment: GLenum, texture: GLuint, level: GLint, layer: GLint
        ), not_compiled;
        /// Sets which colour buffer of a framebuffer is drawn to.
        named_framebuffer_draw_buffer: glNamedFramebufferDrawBuffer
            (framebuffer: GLuint, buf: GLenum), not_compiled;
        /// Sets which colour buffer of a framebuffer each fragment colour is drawn to.
        named_framebuffer_draw_buffers: glNamedFramebufferDrawBuffers
            (framebuffer: GLuint, n: GLsizei, bufs: &'a [GLenum]), not_compiled;
        /// Sets which colour buffer of a framebuffer is read from.
        named_framebuffer_read_buffer: glNamedFramebufferReadBuffer
            (framebuffer: GLuint, src: GLenum), not_compiled;
        /// Says that the contents of attachments will not be used.
        invalidate_named_framebuffer_data: glInvalidateNamedFramebufferData (
            framebuffer: GLuint, num_attachments: GLsizei, attachments: &'a [GLenum]
        ), not_compiled;
        /// Says that a part of the contents of attachments will not be used.
        invalidate_named_framebuffer_sub_data: glInvalidateNamedFramebufferSubData (
            framebuffer: GLuint, num_attachments: GLsizei, attachments: &'a [GLenum], x: GLint,
            y: GLint, width: GLsizei, height: GLsizei
        ), not_compiled;
        /// Clears colours of signed integers, or stencils.
        clear_named_framebufferiv: glClearNamedFramebufferiv
            (framebuffer: GLuint, buffer: GLenum, drawbuffer: GLint, value: &'a [GLint]), not_compiled;
        /// Clears colours of unsigned integers.
        clear_named_framebufferuiv: glClearNamedFramebufferuiv
            (framebuffer: GLuint, buffer: GLenum, drawbuffer: GLint, value: &'a [GLuint]), not_compiled;
        /// Clears colours of floats or fractions, or depths.
        clear_named_framebufferfv: glClearNamedFramebufferfv
            (framebuffer: GLuint, buffer: GLenum, drawbuffer: GLint, value: &'a [GLfloat]), not_compiled;
        /// Clears depths and stencils.
        clear_named_framebufferfi: glClearNamedFramebufferfi (
            framebuffer: GLuint, buffer: GLenum, drawbuffer: GLint, depth: GLfloat, stencil: GLint
        ), not_compiled;
        /// Copies a rectangle of one framebuffer to another one, scaled or mirrored.
        blit_named_framebuffer: glBlitNamedFramebuffer (
            read_framebuffer: GLuint, draw_framebuffer: GLuint, src_x0: GLint, src_y0: GLint,
            src_x1: GLint, src_y1: GLint, dst_x0: GLint, dst_y0: GLint, dst_x1: GLint,
            dst_y1: GLint, mask: GLbitfield, filter: GLenum
        ), not_compiled;
        /// Whether a framebuffer can be used: `GL_FRAMEBUFFER_COMPLETE`, or why not.
        check_named_framebuffer_status: glCheckNamedFramebufferStatus
            (framebuffer: GLuint, target: GLenum) -> GLenum;
        /// Reads what is known of a framebuffer.
        get_named_framebuffer_parameteriv: glGetNamedFramebufferParameteriv
            (framebuffer: GLuint, pname: GLenum, params: &'a mut [GLint]);
        /// Reads what is known of an attachment of a framebuffer.
        get_named_framebuffer_attachment_parameteriv: glGetNamedFramebufferAttachmentParameteriv
            (framebuffer: GLuint, attachment: GLenum, pname: GLenum, params: &'a mut [GLint]);
        /// Makes `n` renderbuffers.
        create_renderbuffers: glCreateRenderbuffers
            (n: GLsizei, renderbuffers: &'a mut [GLuint]);
        /// Gives a renderbuffer a format and a size.
        named_renderbuffer_storage: glNamedRenderbufferStorage (
            renderbuffer: GLuint, internalformat: GLenum, width: GLsizei, height: GLsizei
        ), not_compiled;
        /// Gives a renderbuffer a format, a size and a number of samples.
        named_renderbuffer_storage_multisample: glNamedRenderbufferStorageMultisample (
            renderbuffer: GLuint, samples: GLsizei, internalformat: GLenum, width: GLsizei,
            height: GLsizei
        ), not_compiled;
        /// Reads what is known of a renderbuffer.
        get_named_renderbuffer_parameteriv: glGetNamedRenderbufferParameteriv
            (renderbuffer: GLuint, pname: GLenum, params: &'a mut [GLint]);
    }
    Refused in named_arrays {
        /// Makes `n` vertex array objects.
        create_vertex_arrays: glCreateVertexArrays (n: GLsizei, arrays: &'a mut [GLuint]);
        /// Lets an attribute not be read from its array.
        disable_vertex_array_attrib: glDisableVertexArrayAttrib
            (vaobj: GLuint, index: GLuint), not_compiled;
        /// Lets an attribute be read from its array.
        enable_vertex_array_attrib: glEnableVertexArrayAttrib
            (vaobj: GLuint, index: GLuint), not_compiled;
        /// Sets the buffer of a vertex array object's indices.
        vertex_array_element_buffer: glVertexArrayElementBuffer
            (vaobj: GLuint, buffer: GLuint), not_compiled;
        /// Attaches a buffer to a binding point.
        vertex_array_vertex_buffer: glVertexArrayVertexBuffer (
            vaobj: GLuint, bindingindex: GLuint, buffer: GLuint, offset: GLintptr, stride: GLsizei
        ), not_compiled;
        /// Attaches buffers to binding points.
        vertex_array_vertex_buffers: glVertexArrayVertexBuffers (
            vaobj: GLuint, first: GLuint, count: GLsizei, buffers: &'a [GLuint],
            offsets: &'a [GLintptr], strides: &'a [GLsizei]
        ), not_compiled;
        /// Sets the format of an attribute of floats, or of integers that become such.
        vertex_array_attrib_format: glVertexArrayAttribFormat (
            vaobj: GLuint, attribindex: GLuint, size: GLint, ty: GLenum, normalized: bool,
            relativeoffset: GLuint
        ), not_compiled;
        /// Sets the format of an attribute of integers.
        vertex_array_attrib_i_format: glVertexArrayAttribIFormat (
            vaobj: GLuint, attribindex: GLuint, size: GLint, ty: GLenum, relativeoffset: GLuint
        ), not_compiled;
        /// Sets the format of an attribute of doubles.
        vertex_array_attrib_l_format: glVertexArrayAttribLFormat (
            vaobj: GLuint, attribindex: GLuint, size: GLint, ty: GLenum, relativeoffset: GLuint
        ), not_compiled;
        /// Sets the binding point that an attribute reads.
        vertex_array_attrib_binding: glVertexArrayAttribBinding
            (vaobj: GLuint, attribindex: GLuint, bindingindex: GLuint), not_compiled;
        /// Sets how many instances share an element of a binding point.
        vertex_array_binding_divisor: glVertexArrayBindingDivisor
            (vaobj: GLuint, bindingindex: GLuint, divisor: GLuint), not_compiled;
    }
    Refused in vertex_array_objects {
        /// Reads the buffer of a vertex array object's indices.
        get_vertex_arrayiv: glGetVertexArrayiv
            (vaobj: GLuint, pname: GLenum, param: &'a mut [GLint]);
        /// Reads what is known of an attribute's array.
        get_vertex_array_indexediv: glGetVertexArrayIndexediv
            (vaobj: GLuint, index: GLuint, pname: GLenum, param: &'a mut [GLint]);
        /// Reads where the first element of a binding point is.
        get_vertex_array_indexed64iv: glGetVertexArrayIndexed64iv
            (vaobj: GLuint, index: GLuint, pname: GLenum, param: &'a mut [GLint64]);
    }
    Refused in named_pipelines {
        /// Makes `n` program pipeline objects.
        create_program_pipelines: glCreateProgramPipelines
            (n: GLsizei, pipelines: &'a mut [GLuint]);
    }
    Refused in named_queries {
        /// Makes `n` queries of a target.
        create_queries: glCreateQueries (target: GLenum, n: GLsizei, ids: &'a mut [GLuint]);
        /// Writes what a query answers to a buffer.
        get_query_buffer_objecti64v: glGetQueryBufferObjecti64v
            (id: GLuint, buffer: GLuint, pname: GLenum, offset: GLintptr), not_compiled;
        /// Writes what a query answers to a buffer.
        get_query_buffer_objectiv: glGetQueryBufferObjectiv
            (id: GLuint, buffer: GLuint, pname: GLenum, offset: GLintptr), not_compiled;
        /// Writes what a query answers to a buffer.
        get_query_buffer_objectui64v: glGetQueryBufferObjectui64v
            (id: GLuint, buffer: GLuint, pname: GLenum, offset: GLintptr), not_compiled;
        /// Writes what a query answers to a buffer.
        get_query_buffer_objectuiv: glGetQueryBufferObjectuiv
            (id: GLuint, buffer: GLuint, pname: GLenum, offset: GLintptr), not_compiled;
    }
    } };
}
entry_points_named_objects!(implement);
