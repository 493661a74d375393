//! Uniform blocks: ARB_uniform_buffer_object.

use crate::base::args::{Names, TextOut};
use crate::base::types::*;
use crate::calls::program::blocks as inspect;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_uniform_buffers {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in inspect {
        /// The indices of uniforms by their names.
        get_uniform_indices: glGetUniformIndices (
            program: GLuint, uniform_count: GLsizei, uniform_names: Names<'a>,
            uniform_indices: &'a mut [GLuint]
        );
        /// Reads what is known of uniforms, by index.
        get_active_uniformsiv: glGetActiveUniformsiv (
            program: GLuint, uniform_count: GLsizei, uniform_indices: &'a [GLuint], pname: GLenum,
            params: &'a mut [GLint]
        );
        /// Reads the name of a uniform, by index.
        get_active_uniform_name: glGetActiveUniformName (
            program: GLuint, uniform_index: GLuint, buf_size: GLsizei, length: &'a mut [GLsizei],
            uniform_name: TextOut<'a>
        );
        /// The index of a uniform block, or `GL_INVALID_INDEX`.
        get_uniform_block_index: glGetUniformBlockIndex
            (program: GLuint, uniform_block_name: &'a str) -> GLuint;
        /// Reads what is known of a uniform block.
        get_active_uniform_blockiv: glGetActiveUniformBlockiv
            (program: GLuint, uniform_block_index: GLuint, pname: GLenum, params: &'a mut [GLint]);
        /// Reads the name of a uniform block.
        get_active_uniform_block_name: glGetActiveUniformBlockName (
            program: GLuint, uniform_block_index: GLuint, buf_size: GLsizei,
            length: &'a mut [GLsizei], uniform_block_name: TextOut<'a>
        );
        /// Sets the number of the buffer binding that a uniform block is read from.
        uniform_block_binding: glUniformBlockBinding
            (program: GLuint, uniform_block_index: GLuint, uniform_block_binding: GLuint);
    }
    } };
}
entry_points_uniform_buffers!(implement);
