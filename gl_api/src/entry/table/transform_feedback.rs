//! Transform feedback: GL 3.0, section 2.15 (`EXT_transform_feedback`).

use crate::base::args::{Names, TextOut};
use crate::base::types::*;
use crate::calls::buffer::indexed as indexed_buffers;
use crate::calls::program::varyings;
use crate::calls::transform_feedback as calls;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_transform_feedback {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in calls {
        /// Begins to capture what the vertex shader makes of points, lines or triangles.
        begin_transform_feedback: glBeginTransformFeedback | glBeginTransformFeedbackEXT
            (primitive_mode: GLenum);
        /// Ends it.
        end_transform_feedback: glEndTransformFeedback | glEndTransformFeedbackEXT ();
        /// Makes `n` unused names of transform feedback objects.
        gen_transform_feedbacks: glGenTransformFeedbacks (n: GLsizei, ids: &'a mut [GLuint]);
        /// Deletes transform feedback objects; the bound one is replaced by that of name 0.
        delete_transform_feedbacks: glDeleteTransformFeedbacks
            (n: GLsizei, ids: &'a [GLuint]), not_compiled;
        /// Whether a name is a transform feedback object that has been bound.
        is_transform_feedback: glIsTransformFeedback (id: GLuint) -> bool;
        /// Makes a transform feedback object the current one.
        bind_transform_feedback: glBindTransformFeedback (target: GLenum, id: GLuint);
        /// Captures nothing until it is resumed.
        pause_transform_feedback: glPauseTransformFeedback ();
        /// Captures again.
        resume_transform_feedback: glResumeTransformFeedback ();
        /// Draws the vertices that an object has captured.
        draw_transform_feedback: glDrawTransformFeedback (mode: GLenum, id: GLuint);
        /// The same of one vertex stream.
        draw_transform_feedback_stream: glDrawTransformFeedbackStream
            (mode: GLenum, id: GLuint, stream: GLuint);
    }
    Refused in indexed_buffers {
        /// Binds a part of a buffer to a numbered binding.
        bind_buffer_range: glBindBufferRange | glBindBufferRangeEXT
            (target: GLenum, index: GLuint, buffer: GLuint, offset: GLintptr, size: GLsizeiptr), not_compiled;
        /// Binds a buffer from a byte on to a numbered binding.
        bind_buffer_offset_ext: glBindBufferOffsetEXT
            (target: GLenum, index: GLuint, buffer: GLuint, offset: GLintptr), not_compiled;
        /// Binds a buffer, as long as it is when it is used, to a numbered binding.
        bind_buffer_base: glBindBufferBase | glBindBufferBaseEXT
            (target: GLenum, index: GLuint, buffer: GLuint), not_compiled;
    }
    Refused in varyings {
        /// Sets what a program captures after its next link.
        transform_feedback_varyings: glTransformFeedbackVaryings | glTransformFeedbackVaryingsEXT
            (program: GLuint, count: GLsizei, varyings: Names<'a>, buffer_mode: GLenum), not_compiled;
        /// Reads name, type and size of what a program captures, by index.
        get_transform_feedback_varying: glGetTransformFeedbackVarying
            | glGetTransformFeedbackVaryingEXT (
                program: GLuint, index: GLuint, max_length: GLsizei, length: &'a mut [GLsizei],
                size: &'a mut [GLsizei], ty: &'a mut [GLenum], name: TextOut<'a>
            );
    }
    } };
}
entry_points_transform_feedback!(implement);
