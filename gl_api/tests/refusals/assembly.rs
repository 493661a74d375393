//! What the calls of assembly programs refuse (ARB_vertex_program, section 2.14.1).

use super::row;
use gl_api::*;

/// A call, the flag it must set, and words that its message must have.
type Case = (fn(&mut Context), GLenum, &'static str);

const VERTEX: GLenum = GL_VERTEX_PROGRAM_ARB;
const FRAGMENT: GLenum = GL_FRAGMENT_PROGRAM_ARB;

/// With program 1 of the fragment target.
fn ready() -> Context {
    let mut c = super::context();
    c.bind_program(FRAGMENT, 1);
    assert_eq!(c.get_error(), GL_NO_ERROR);
    c
}

fn text(c: &mut Context, target: GLenum, format: GLenum, len: GLsizei, text: &str) {
    c.program_string(target, format, len, text);
}

const ROWS: &[Case] = &[
    (|c| c.gen_programs(-1, &mut []), GL_INVALID_VALUE, "negative"),
    (|c| c.gen_programs(2, &mut [0]), GL_INVALID_OPERATION, "1 elements"),
    (|c| c.delete_programs(-1, &[]), GL_INVALID_VALUE, "negative"),
    (|c| c.bind_program(GL_TEXTURE_2D, 1), GL_INVALID_ENUM, "GL_VERTEX_PROGRAM_ARB"),
    (|c| c.bind_program(VERTEX, 1), GL_INVALID_OPERATION, "first bound"),
    (
        |c| text(c, GL_TEXTURE_2D, GL_PROGRAM_FORMAT_ASCII_ARB, 0, ""),
        GL_INVALID_ENUM,
        "GL_FRAGMENT_PROGRAM_ARB",
    ),
    (|c| text(c, VERTEX, GL_RGBA, 0, ""), GL_INVALID_ENUM, "GL_PROGRAM_FORMAT_ASCII_ARB"),
    (
        |c| text(c, VERTEX, GL_PROGRAM_FORMAT_ASCII_ARB, -1, ""),
        GL_INVALID_VALUE,
        "must not be negative",
    ),
    (
        |c| text(c, VERTEX, GL_PROGRAM_FORMAT_ASCII_ARB, 9, "!!ARBvp"),
        GL_INVALID_OPERATION,
        "has 7 bytes",
    ),
    (
        |c| c.program_env_parameter_4f(GL_RGBA, 0, 0.0, 0.0, 0.0, 0.0),
        GL_INVALID_ENUM,
        "GL_VERTEX_PROGRAM_ARB",
    ),
    (
        |c| c.program_env_parameter_4f(VERTEX, 256, 0.0, 0.0, 0.0, 0.0),
        GL_INVALID_VALUE,
        "GL_MAX_PROGRAM_ENV_PARAMETERS_ARB",
    ),
    (
        |c| c.program_env_parameter_4d(VERTEX, !0, 0.0, 0.0, 0.0, 0.0),
        GL_INVALID_VALUE,
        "GL_MAX_PROGRAM_ENV_PARAMETERS_ARB",
    ),
    (|c| c.program_env_parameter_4fv(VERTEX, 0, &[0.0; 3]), GL_INVALID_OPERATION, "3 of 4"),
    (|c| c.program_env_parameter_4dv(VERTEX, 256, &[0.0; 4]), GL_INVALID_VALUE, "beyond"),
    (|c| c.program_env_parameters_4fv(VERTEX, 0, -1, &[]), GL_INVALID_VALUE, "negative"),
    (|c| c.program_env_parameters_4fv(VERTEX, 255, 2, &[0.0; 8]), GL_INVALID_VALUE, "2 parameters"),
    (
        |c| c.program_local_parameter_4f(FRAGMENT, 2048, 0.0, 0.0, 0.0, 0.0),
        GL_INVALID_VALUE,
        "GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB",
    ),
    (
        |c| c.program_local_parameter_4d(FRAGMENT, 2048, 0.0, 0.0, 0.0, 0.0),
        GL_INVALID_VALUE,
        "GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB",
    ),
    (|c| c.program_local_parameter_4fv(GL_RGBA, 0, &[0.0; 4]), GL_INVALID_ENUM, "target"),
    (|c| c.program_local_parameter_4dv(VERTEX, 0, &[0.0; 3]), GL_INVALID_OPERATION, "3 of 4"),
    (
        |c| c.program_local_parameters_4fv(VERTEX, 0, 2, &[0.0; 7]),
        GL_INVALID_OPERATION,
        "7 numbers",
    ),
    (|c| c.get_program_env_parameterfv(GL_RGBA, 0, &mut [0.0; 4]), GL_INVALID_ENUM, "target"),
    (|c| c.get_program_env_parameterdv(VERTEX, 256, &mut [0.0; 4]), GL_INVALID_VALUE, "beyond"),
    (|c| c.get_program_local_parameterfv(VERTEX, 2048, &mut [0.0; 4]), GL_INVALID_VALUE, "beyond"),
    (|c| c.get_program_local_parameterdv(GL_RGBA, 0, &mut [0.0; 4]), GL_INVALID_ENUM, "target"),
    (
        |c| c.get_assembly_programiv(GL_RGBA, GL_PROGRAM_LENGTH_ARB, &mut [0]),
        GL_INVALID_ENUM,
        "target = GL_RGBA must be GL_VERTEX_PROGRAM_ARB",
    ),
    (|c| c.get_assembly_programiv(VERTEX, GL_RGBA, &mut [0]), GL_INVALID_ENUM, "GL_RGBA"),
    (
        |c| c.get_assembly_programiv(VERTEX, GL_PROGRAM_TEX_INSTRUCTIONS_ARB, &mut [0]),
        GL_INVALID_ENUM,
        "programs of this target",
    ),
    (
        |c| c.get_program_string(VERTEX, GL_RGBA, DataOut::Null),
        GL_INVALID_ENUM,
        "GL_PROGRAM_STRING_ARB",
    ),
    (
        |c| c.get_program_string(VERTEX, GL_PROGRAM_STRING_ARB, DataOut::Null),
        GL_INVALID_OPERATION,
        "room",
    ),
];

pub fn run() {
    for (number, (call, flag, words)) in ROWS.iter().enumerate() {
        row(&mut ready(), format!("assembly {number}"), call, *flag, words);
    }
}
