//! Assembly programs: ARB_vertex_program, ARB_fragment_program, EXT_gpu_program_parameters.

use crate::base::args::DataOut;
use crate::base::types::*;
use crate::calls::program::{
    assembly as calls, assembly_names as assemblies, assembly_query as query,
};

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_assembly {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in assemblies {
        /// Reserves names for assembly programs.
        gen_programs: glGenProgramsARB (n: GLsizei, programs: &'a mut [GLuint]);
        /// Deletes assembly programs; where one is bound, 0 is bound.
        delete_programs: glDeleteProgramsARB (n: GLsizei, programs: &'a [GLuint]), not_compiled;
        /// Makes an assembly program the one of its target.
        bind_program: glBindProgramARB (target: GLenum, program: GLuint);
        /// Whether a name is an assembly program.
        is_assembly_program: glIsProgramARB (program: GLuint) -> bool;
    }
    Refused in calls {
        /// Loads the text of the bound assembly program.
        program_string: glProgramStringARB (target: GLenum, format: GLenum, len: GLsizei, string: &'a str);
        /// Sets a parameter that all programs of a target read.
        program_env_parameter_4f: glProgramEnvParameter4fARB (
            target: GLenum, index: GLuint, x: GLfloat, y: GLfloat, z: GLfloat, w: GLfloat
        );
        /// Sets a parameter that all programs of a target read.
        program_env_parameter_4d: glProgramEnvParameter4dARB (
            target: GLenum, index: GLuint, x: GLdouble, y: GLdouble, z: GLdouble, w: GLdouble
        );
        /// Sets a parameter that all programs of a target read.
        program_env_parameter_4fv: glProgramEnvParameter4fvARB
            (target: GLenum, index: GLuint, params: &'a [GLfloat]);
        /// Sets a parameter that all programs of a target read.
        program_env_parameter_4dv: glProgramEnvParameter4dvARB
            (target: GLenum, index: GLuint, params: &'a [GLdouble]);
        /// Sets `count` parameters that all programs of a target read.
        program_env_parameters_4fv: glProgramEnvParameters4fvEXT
            (target: GLenum, index: GLuint, count: GLsizei, params: &'a [GLfloat]);
        /// Sets a parameter of the bound program.
        program_local_parameter_4f: glProgramLocalParameter4fARB (
            target: GLenum, index: GLuint, x: GLfloat, y: GLfloat, z: GLfloat, w: GLfloat
        );
        /// Sets a parameter of the bound program.
        program_local_parameter_4d: glProgramLocalParameter4dARB (
            target: GLenum, index: GLuint, x: GLdouble, y: GLdouble, z: GLdouble, w: GLdouble
        );
        /// Sets a parameter of the bound program.
        program_local_parameter_4fv: glProgramLocalParameter4fvARB
            (target: GLenum, index: GLuint, params: &'a [GLfloat]);
        /// Sets a parameter of the bound program.
        program_local_parameter_4dv: glProgramLocalParameter4dvARB
            (target: GLenum, index: GLuint, params: &'a [GLdouble]);
        /// Sets `count` parameters of the bound program.
        program_local_parameters_4fv: glProgramLocalParameters4fvEXT
            (target: GLenum, index: GLuint, count: GLsizei, params: &'a [GLfloat]);
    }
    Refused in query {
        /// Reads a parameter that all programs of a target read.
        get_program_env_parameterfv: glGetProgramEnvParameterfvARB
            (target: GLenum, index: GLuint, params: &'a mut [GLfloat]);
        /// Reads a parameter that all programs of a target read.
        get_program_env_parameterdv: glGetProgramEnvParameterdvARB
            (target: GLenum, index: GLuint, params: &'a mut [GLdouble]);
        /// Reads a parameter of the bound program.
        get_program_local_parameterfv: glGetProgramLocalParameterfvARB
            (target: GLenum, index: GLuint, params: &'a mut [GLfloat]);
        /// Reads a parameter of the bound program.
        get_program_local_parameterdv: glGetProgramLocalParameterdvARB
            (target: GLenum, index: GLuint, params: &'a mut [GLdouble]);
        /// Reads what is known of the bound program, or a limit of its target.
        get_assembly_programiv: glGetProgramivARB (target: GLenum, pname: GLenum, params: &'a mut [GLint]);
        /// Reads the text of the bound program.
        get_program_string: glGetProgramStringARB (target: GLenum, pname: GLenum, string: DataOut<'a>);
    }
    } };
}
entry_points_assembly!(implement);
