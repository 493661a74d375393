//! Shaders and programs: GL 2.1, sections 2.15, 3.11 and 6.1.14.

use crate::base::args::{Data, DataOut, Strings, TextOut};
use crate::base::types::*;
use crate::calls::program::{
    binaries, es2_compiler, inspect, programs, shader_objects_arb, shaders, uniform,
    uniform_values, validate,
};

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_programs {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in shaders {
        /// Makes a shader object for a stage.
        create_shader: glCreateShader | glCreateShaderObjectARB (ty: GLenum) -> GLuint;
        /// Deletes a shader, once it is attached to no program.
        delete_shader: glDeleteShader (shader: GLuint), not_compiled;
        /// Whether a name is a shader.
        is_shader: glIsShader (shader: GLuint) -> bool;
        /// Replaces a shader's source by strings, of which `lengths` may say how long they are.
        shader_source: glShaderSource | glShaderSourceARB
            (shader: GLuint, count: GLsizei, strings: Strings<'a>, lengths: &'a [GLint]), not_compiled;
        /// Compiles a shader; `glGetShaderiv` says whether it worked.
        compile_shader: glCompileShader | glCompileShaderARB (shader: GLuint), not_compiled;
        /// Reads what is known of a shader.
        get_shaderiv: glGetShaderiv (shader: GLuint, pname: GLenum, params: &'a mut [GLint]);
        /// Reads what the compiler said.
        get_shader_info_log: glGetShaderInfoLog
            (shader: GLuint, max_length: GLsizei, length: &'a mut [GLsizei], info_log: TextOut<'a>);
        /// Reads a shader's source.
        get_shader_source: glGetShaderSource | glGetShaderSourceARB
            (shader: GLuint, max_length: GLsizei, length: &'a mut [GLsizei], source: TextOut<'a>);
    }
    Refused in es2_compiler {
        /// Says that no shader is compiled for a while.
        release_shader_compiler: glReleaseShaderCompiler (), not_compiled;
        /// Loads compiled shaders, of which there is no format.
        shader_binary: glShaderBinary
            (count: GLsizei, shaders: &'a [GLuint], binary_format: GLenum, binary: Data<'a>, length: GLsizei), not_compiled;
        /// Reads the range and the precision of the numbers of a stage.
        get_shader_precision_format: glGetShaderPrecisionFormat
            (shader_type: GLenum, precision_type: GLenum, range: &'a mut [GLint], precision: &'a mut [GLint]);
    }
    Refused in binaries {
        /// Reads a linked program, of which there is no format.
        get_program_binary: glGetProgramBinary (
            program: GLuint, bufsize: GLsizei, length: &'a mut [GLsizei], binary_format: &'a mut [GLenum],
            binary: DataOut<'a>
        );
        /// Loads a linked program, of which there is no format.
        program_binary: glProgramBinary
            (program: GLuint, binary_format: GLenum, binary: Data<'a>, length: GLsizei), not_compiled;
        /// Says whether the binary of a program will be read.
        program_parameteri: glProgramParameteri | glProgramParameteriARB
            (program: GLuint, pname: GLenum, value: GLint), not_compiled;
    }
    Refused in programs {
        /// Makes a program object.
        create_program: glCreateProgram | glCreateProgramObjectARB () -> GLuint;
        /// Deletes a program, once it is not in use.
        delete_program: glDeleteProgram (program: GLuint), not_compiled;
        /// Whether a name is a program.
        is_program: glIsProgram (program: GLuint) -> bool;
        /// Adds a shader to a program.
        attach_shader: glAttachShader | glAttachObjectARB (program: GLuint, shader: GLuint), not_compiled;
        /// Takes a shader from a program.
        detach_shader: glDetachShader | glDetachObjectARB (program: GLuint, shader: GLuint), not_compiled;
        /// Sets the location that an attribute gets at the next link.
        bind_attrib_location: glBindAttribLocation | glBindAttribLocationARB (program: GLuint, index: GLuint, name: &'a str), not_compiled;
        /// Sets the colour number that a fragment output gets at the next link.
        bind_frag_data_location: glBindFragDataLocation | glBindFragDataLocationEXT
            (program: GLuint, color: GLuint, name: &'a str), not_compiled;
        /// Sets the draw buffer and the colour of it, first or second, that a fragment output gets at the next link.
        bind_frag_data_location_indexed: glBindFragDataLocationIndexed | glBindFragDataLocationIndexedEXT
            (program: GLuint, color_number: GLuint, index: GLuint, name: &'a str), not_compiled;
        /// Links a program; `glGetProgramiv` says whether it worked.
        link_program: glLinkProgram | glLinkProgramARB (program: GLuint), not_compiled;
    }
    Setter in programs {
        /// Makes a program the one that draws use; 0 brings the fixed function back.
        use_program: glUseProgram | glUseProgramObjectARB (program: GLuint);
    }
    Refused in validate {
        /// Checks whether a program could run as things stand.
        validate_program: glValidateProgram | glValidateProgramARB (program: GLuint), not_compiled;
    }
    Refused in inspect {
        /// Reads what is known of a program.
        get_programiv: glGetProgramiv (program: GLuint, pname: GLenum, params: &'a mut [GLint]);
        /// Reads what the linker said.
        get_program_info_log: glGetProgramInfoLog
            (program: GLuint, max_length: GLsizei, length: &'a mut [GLsizei], info_log: TextOut<'a>);
        /// Reads which shaders are attached.
        get_attached_shaders: glGetAttachedShaders | glGetAttachedObjectsARB
            (program: GLuint, max_count: GLsizei, count: &'a mut [GLsizei], shaders: &'a mut [GLuint]);
        /// Reads name, type and size of a uniform by index.
        get_active_uniform: glGetActiveUniform | glGetActiveUniformARB (
            program: GLuint, index: GLuint, max_length: GLsizei, length: &'a mut [GLsizei],
            size: &'a mut [GLint], ty: &'a mut [GLenum], name: TextOut<'a>
        );
        /// Reads name, type and size of an attribute by index.
        get_active_attrib: glGetActiveAttrib | glGetActiveAttribARB (
            program: GLuint, index: GLuint, max_length: GLsizei, length: &'a mut [GLsizei],
            size: &'a mut [GLint], ty: &'a mut [GLenum], name: TextOut<'a>
        );
        /// The location of a uniform, or -1.
        get_uniform_location: glGetUniformLocation | glGetUniformLocationARB (program: GLuint, name: &'a str) -> GLint;
        /// The location of an attribute, or -1.
        get_attrib_location: glGetAttribLocation | glGetAttribLocationARB (program: GLuint, name: &'a str) -> GLint;
        /// The colour number of a fragment output, or -1.
        get_frag_data_location: glGetFragDataLocation | glGetFragDataLocationEXT
            (program: GLuint, name: &'a str) -> GLint;
        /// Which colour of its draw buffer a fragment output is, 0 or 1, or -1.
        get_frag_data_index: glGetFragDataIndex | glGetFragDataIndexEXT (program: GLuint, name: &'a str) -> GLint;
    }
    Refused in uniform_values {
        /// Reads a uniform.
        get_uniformfv: glGetUniformfv | glGetUniformfvARB (program: GLuint, location: GLint, params: &'a mut [GLfloat]);
        /// Reads a uniform.
        get_uniformiv: glGetUniformiv | glGetUniformivARB (program: GLuint, location: GLint, params: &'a mut [GLint]);
    }
    Refused in shader_objects_arb {
        /// Reads what is known of a shader or program (`ARB_shader_objects`).
        get_object_parameteriv: glGetObjectParameterivARB
            (object: GLuint, pname: GLenum, params: &'a mut [GLint]);
        /// Reads what is known of a shader or program (`ARB_shader_objects`).
        get_object_parameterfv: glGetObjectParameterfvARB
            (object: GLuint, pname: GLenum, params: &'a mut [GLfloat]);
        /// Reads what the compiler or the linker said (`ARB_shader_objects`).
        get_info_log: glGetInfoLogARB
            (object: GLuint, max_length: GLsizei, length: &'a mut [GLsizei], info_log: TextOut<'a>);
        /// The program in use, or 0 (`ARB_shader_objects`).
        get_handle: glGetHandleARB (pname: GLenum) -> GLuint;
        /// Deletes a shader or program (`ARB_shader_objects`).
        delete_object: glDeleteObjectARB (object: GLuint), not_compiled;
    }
    Refused in uniform {
        /// Sets a `float`, or a `bool`.
        uniform_1f: glUniform1f | glUniform1fARB (location: GLint, x: GLfloat);
        /// Sets a `vec2`, or a `bvec2`.
        uniform_2f: glUniform2f | glUniform2fARB (location: GLint, x: GLfloat, y: GLfloat);
        /// Sets a `vec3`, or a `bvec3`.
        uniform_3f: glUniform3f | glUniform3fARB (location: GLint, x: GLfloat, y: GLfloat, z: GLfloat);
        /// Sets a `vec4`, or a `bvec4`.
        uniform_4f: glUniform4f | glUniform4fARB
            (location: GLint, x: GLfloat, y: GLfloat, z: GLfloat, w: GLfloat);
        /// Sets an `int`, a `bool`, or the texture unit of a sampler.
        uniform_1i: glUniform1i | glUniform1iARB (location: GLint, x: GLint);
        /// Sets an `ivec2`, or a `bvec2`.
        uniform_2i: glUniform2i | glUniform2iARB (location: GLint, x: GLint, y: GLint);
        /// Sets an `ivec3`, or a `bvec3`.
        uniform_3i: glUniform3i | glUniform3iARB (location: GLint, x: GLint, y: GLint, z: GLint);
        /// Sets an `ivec4`, or a `bvec4`.
        uniform_4i: glUniform4i | glUniform4iARB (location: GLint, x: GLint, y: GLint, z: GLint, w: GLint);
        /// Sets a `uint`, or a `bool`.
        uniform_1ui: glUniform1ui | glUniform1uiEXT (location: GLint, x: GLuint);
        /// Sets a `uvec2`, or a `bvec2`.
        uniform_2ui: glUniform2ui | glUniform2uiEXT (location: GLint, x: GLuint, y: GLuint);
        /// Sets a `uvec3`, or a `bvec3`.
        uniform_3ui: glUniform3ui | glUniform3uiEXT (location: GLint, x: GLuint, y: GLuint, z: GLuint);
        /// Sets a `uvec4`, or a `bvec4`.
        uniform_4ui: glUniform4ui | glUniform4uiEXT (location: GLint, x: GLuint, y: GLuint, z: GLuint, w: GLuint);
        /// Sets `count` elements of `float`.
        uniform_1fv: glUniform1fv | glUniform1fvARB (location: GLint, count: GLsizei, value: &'a [GLfloat]);
        /// Sets `count` elements of `vec2`.
        uniform_2fv: glUniform2fv | glUniform2fvARB (location: GLint, count: GLsizei, value: &'a [GLfloat]);
        /// Sets `count` elements of `vec3`.
        uniform_3fv: glUniform3fv | glUniform3fvARB (location: GLint, count: GLsizei, value: &'a [GLfloat]);
        /// Sets `count` elements of `vec4`.
        uniform_4fv: glUniform4fv | glUniform4fvARB (location: GLint, count: GLsizei, value: &'a [GLfloat]);
        /// Sets `count` elements of `int`, or texture units of samplers.
        uniform_1iv: glUniform1iv | glUniform1ivARB (location: GLint, count: GLsizei, value: &'a [GLint]);
        /// Sets `count` elements of `ivec2`.
        uniform_2iv: glUniform2iv | glUniform2ivARB (location: GLint, count: GLsizei, value: &'a [GLint]);
        /// Sets `count` elements of `ivec3`.
        uniform_3iv: glUniform3iv | glUniform3ivARB (location: GLint, count: GLsizei, value: &'a [GLint]);
        /// Sets `count` elements of `ivec4`.
        uniform_4iv: glUniform4iv | glUniform4ivARB (location: GLint, count: GLsizei, value: &'a [GLint]);
        /// Sets `count` elements of `uint`.
        uniform_1uiv: glUniform1uiv | glUniform1uivEXT (location: GLint, count: GLsizei, value: &'a [GLuint]);
        /// Sets `count` elements of `uvec2`.
        uniform_2uiv: glUniform2uiv | glUniform2uivEXT (location: GLint, count: GLsizei, value: &'a [GLuint]);
        /// Sets `count` elements of `uvec3`.
        uniform_3uiv: glUniform3uiv | glUniform3uivEXT (location: GLint, count: GLsizei, value: &'a [GLuint]);
        /// Sets `count` elements of `uvec4`.
        uniform_4uiv: glUniform4uiv | glUniform4uivEXT (location: GLint, count: GLsizei, value: &'a [GLuint]);
        /// Sets `count` elements of `mat2`.
        uniform_matrix_2fv: glUniformMatrix2fv | glUniformMatrix2fvARB
            (location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat3`.
        uniform_matrix_3fv: glUniformMatrix3fv | glUniformMatrix3fvARB
            (location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat4`.
        uniform_matrix_4fv: glUniformMatrix4fv | glUniformMatrix4fvARB
            (location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat2x3`.
        uniform_matrix_2x3fv: glUniformMatrix2x3fv
            (location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat3x2`.
        uniform_matrix_3x2fv: glUniformMatrix3x2fv
            (location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat2x4`.
        uniform_matrix_2x4fv: glUniformMatrix2x4fv
            (location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat4x2`.
        uniform_matrix_4x2fv: glUniformMatrix4x2fv
            (location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat3x4`.
        uniform_matrix_3x4fv: glUniformMatrix3x4fv
            (location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
        /// Sets `count` elements of `mat4x3`.
        uniform_matrix_4x3fv: glUniformMatrix4x3fv
            (location: GLint, count: GLsizei, transpose: bool, value: &'a [GLfloat]);
    }
    } };
}
entry_points_programs!(implement);
