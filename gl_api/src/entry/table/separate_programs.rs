//! Separable programs and their pipelines: ARB_separate_shader_objects.

use crate::base::args::{Names, TextOut};
use crate::base::types::*;
use crate::calls::program::{pipelines, uniform};

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_separate_programs {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in pipelines {
        /// Makes a separable program of one shader.
        create_shader_programv: glCreateShaderProgramv
            (ty: GLenum, count: GLsizei, strings: Names<'a>) -> GLuint;
        /// Gives names of program pipelines.
        gen_program_pipelines: glGenProgramPipelines (n: GLsizei, pipelines: &'a mut [GLuint]);
        /// Deletes program pipelines.
        delete_program_pipelines: glDeleteProgramPipelines (n: GLsizei, pipelines: &'a [GLuint]), not_compiled;
        /// Whether a name is a program pipeline.
        is_program_pipeline: glIsProgramPipeline (pipeline: GLuint) -> bool;
        /// Makes a program pipeline the one that draws use where no program is in use.
        bind_program_pipeline: glBindProgramPipeline (pipeline: GLuint), not_compiled;
        /// Takes stages of a pipeline from a program.
        use_program_stages: glUseProgramStages (pipeline: GLuint, stages: GLbitfield, program: GLuint);
        /// Chooses the program of a pipeline whose uniforms `glUniform` sets.
        active_shader_program: glActiveShaderProgram (pipeline: GLuint, program: GLuint);
        /// Checks whether a pipeline could run as things stand.
        validate_program_pipeline: glValidateProgramPipeline (pipeline: GLuint), not_compiled;
        /// Reads what is known of a pipeline.
        get_program_pipelineiv: glGetProgramPipelineiv
            (pipeline: GLuint, pname: GLenum, params: &'a mut [GLint]);
        /// Reads what the last validation of a pipeline said.
        get_program_pipeline_info_log: glGetProgramPipelineInfoLog
            (pipeline: GLuint, buf_size: GLsizei, length: &'a mut [GLsizei], info_log: TextOut<'a>);
    }
    Refused in uniform {
        /// Sets a `float`, or a `bool`, of a program that need not be in use.
        program_uniform_1f: glProgramUniform1f (program: GLuint, location: GLint, x: GLfloat);
        /// Sets a `vec2`, or a `bvec2`, of a program that need not be in use.
        program_uniform_2f: glProgramUniform2f
            (program: GLuint, location: GLint, x: GLfloat, y: GLfloat);
        /// Sets a `vec3`, or a `bvec3`, of a program that need not be in use.
        program_uniform_3f: glProgramUniform3f
            (program: GLuint, location: GLint, x: GLfloat, y: GLfloat, z: GLfloat);
        /// Sets a `vec4`, or a `bvec4`, of a program that need not be in use.
        program_uniform_4f: glProgramUniform4f
            (program: GLuint, location: GLint, x: GLfloat, y: GLfloat, z: GLfloat, w: GLfloat);
        /// Sets an `int`, a `bool`, or the texture unit of a sampler, of a program that need not be in use.
        program_uniform_1i: glProgramUniform1i (program: GLuint, location: GLint, x: GLint);
        /// Sets an `ivec2`, or a `bvec2`, of a program that need not be in use.
        program_uniform_2i: glProgramUniform2i
            (program: GLuint, location: GLint, x: GLint, y: GLint);
        /// Sets an `ivec3`, or a `bvec3`, of a program that need not be in use.
        program_uniform_3i: glProgramUniform3i
            (program: GLuint, location: GLint, x: GLint, y: GLint, z: GLint);
        /// Sets an `ivec4`, or a `bvec4`, of a program that need not be in use.
        program_uniform_4i: glProgramUniform4i
            (program: GLuint, location: GLint, x: GLint, y: GLint, z: GLint, w: GLint);
        /// Sets a `uint`, or a `bool`, of a program that need not be in use.
        program_uniform_1ui: glProgramUniform1ui (program: GLuint, location: GLint, x: GLuint);
        /// Sets a `uvec2`, or a `bvec2`, of a program that need not be in use.
        program_uniform_2ui: glProgramUniform2ui
            (program: GLuint, location: GLint, x: GLuint, y: GLuint);
        /// Sets a `uvec3`, or a `bvec3`, of a program that need not be in use.
        program_uniform_3ui: glProgramUniform3ui
            (program: GLuint, location: GLint, x: GLuint, y: GLuint, z: GLuint);
        /// Sets a `uvec4`, or a `bvec4`, of a program that need not be in use.
        program_uniform_4ui: glProgramUniform4ui
            (program: GLuint, location: GLint, x: GLuint, y: GLuint, z: GLuint, w: GLuint);
        /// Sets `count` elements of `float`, of a program that need not be in use.
        program_uniform_1fv: glProgramUniform1fv
            (program: GLuint, location: GLint, count: GLsizei, value: &'a [GLfloat]);
        /// Sets `count` elements of `vec2`, of a program that need not be in use.
        program_uniform_2fv: glProgramUniform2fv
            (program: GLuint, location: GLint, count: GLsizei, value: &'a [GLfloat]);
        /// Sets `count` elements of `vec3`, of a program that need not be in use.
        program_uniform_3fv: glProgramUniform3fv
            (program: GLuint, location: GLint, count: GLsizei, value: &'a [GLfloat]);
        /// Sets `count` elements of `vec4`, of a program that need not be in use.
        program_uniform_4fv: glProgramUniform4fv
            (program: GLuint, location: GLint, count: GLsizei, value: &'a [GLfloat]);
        /// Sets `count` elements of `int`, or texture units of samplers, of a program that need not be in use.
        program_uniform_1iv: glProgramUniform1iv
            (program: GLuint, location: GLint, count: GLsizei, value: &'a [GLint]);
        /// Sets `count` elements of `ivec2`, of a program that need not be in use.
        program_uniform_2iv: glProgramUniform2iv
            (program: GLuint, location: GLint, count: GLsizei, value: &'a [GLint]);
        /// Sets `count` elements of `ivec3`, of a program that need not be in use.
        program_uniform_3iv: glProgramUniform3iv
            (program: GLuint, location: GLint, count: GLsizei, value: &'a [GLint]);
        /// Sets `count` elements of `ivec4`, of a program that need not be in use.
        program_uniform_4iv: glProgramUniform4iv
            (program: GLuint, location: GLint, count: GLsizei, value: &'a [GLint]);
        /// Sets `count` elements of `uint`, of a program that need not be in use.
        program_uniform_1uiv: glProgramUniform1uiv
            (program: GLuint, location: GLint, count: GLsizei, value: &'a [GLuint]);
        /// Sets `count` elements of `uvec2`, of a program that need not be in use.
        program_uniform_2uiv: glProgramUniform2uiv
            (program: GLuint, location: GLint, count: GLsizei, value: &'a [GLuint]);
        /// Sets `count` elements of `uvec3`, of a program that need not be in use.
        program_uniform_3uiv: glProgramUniform3uiv
            (program: GLuint, location: GLint, count: GLsizei, value: &'a [GLuint]);
        /// Sets `count` elements of `uvec4`, of a program that need not be in use.
        program_uniform_4uiv: glProgramUniform4uiv
            (program: GLuint, location: GLint, count: GLsizei, value: &'a [GLuint]);
        /// Sets `count` elements of `mat2`, of a program that need not be in use.
        program_uniform_matrix_2fv: glProgramUniformMatrix2fv
            (program: GLuint, location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat3`, of a program that need not be in use.
        program_uniform_matrix_3fv: glProgramUniformMatrix3fv
            (program: GLuint, location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat4`, of a program that need not be in use.
        program_uniform_matrix_4fv: glProgramUniformMatrix4fv
            (program: GLuint, location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat2x3`, of a program that need not be in use.
        program_uniform_matrix_2x3fv: glProgramUniformMatrix2x3fv
            (program: GLuint, location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat3x2`, of a program that need not be in use.
        program_uniform_matrix_3x2fv: glProgramUniformMatrix3x2fv
            (program: GLuint, location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat2x4`, of a program that need not be in use.
        program_uniform_matrix_2x4fv: glProgramUniformMatrix2x4fv
            (program: GLuint, location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat4x2`, of a program that need not be in use.
        program_uniform_matrix_4x2fv: glProgramUniformMatrix4x2fv
            (program: GLuint, location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat3x4`, of a program that need not be in use.
        program_uniform_matrix_3x4fv: glProgramUniformMatrix3x4fv
            (program: GLuint, location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat4x3`, of a program that need not be in use.
        program_uniform_matrix_4x3fv: glProgramUniformMatrix4x3fv
            (program: GLuint, location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
    }
    } };
}
entry_points_separate_programs!(implement);
