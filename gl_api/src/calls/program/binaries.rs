//! Program binaries (`ARB_get_program_binary`; OpenGL ES 3.0, section 2.12.4), of which there is no format: programs are
//! always linked from shaders.

use crate::base::args::{Data, DataOut};
use crate::base::constants::*;
use crate::base::error::{
    Result, Table, invalid_enum, invalid_operation, invalid_value, not_negative,
};
use crate::base::types::*;
use crate::calls::program::programs::program;
use crate::context::Context;
use crate::glsl::Separable;

const SECTION: &str = "ARB_get_program_binary";

pub(crate) fn get_program_binary(
    context: &mut Context,
    name: GLuint,
    bufsize: GLsizei,
    _: &mut [GLsizei],
    _: &mut [GLenum],
    _: DataOut<'_>,
) -> Result<()> {
    not_negative(SECTION, "bufSize", bufsize.into())?;
    program(context, name)?;
    invalid_operation(
        SECTION,
        format!(
            "program {name} has no binary: there is no format, see GL_NUM_PROGRAM_BINARY_FORMATS"
        ),
    )
}

pub(crate) fn program_binary(
    context: &mut Context,
    name: GLuint,
    binary_format: GLenum,
    _: Data<'_>,
    length: GLsizei,
) -> Result<()> {
    program(context, name)?;
    not_negative(SECTION, "length", length.into())?;
    let format = enum_name(binary_format);
    let rule =
        format!("binaryFormat = {format}: there is no format, see GL_NUM_PROGRAM_BINARY_FORMATS");
    invalid_enum(SECTION, rule)
}

/// What the next link takes over: `GL_PROGRAM_SEPARABLE` (`ARB_separate_shader_objects`), and
/// `GL_PROGRAM_BINARY_RETRIEVABLE_HINT`, which has no effect.
pub(crate) fn program_parameteri(
    context: &mut Context,
    name: GLuint,
    pname: GLenum,
    value: GLint,
) -> Result<()> {
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    enum Parameter {
        BinaryHint,
        Separable,
    }
    const PARAMETER: Table<Parameter> = Table {
        section: SECTION,
        rows: &[
            (GL_PROGRAM_BINARY_RETRIEVABLE_HINT, Parameter::BinaryHint),
            (GL_PROGRAM_SEPARABLE, Parameter::Separable),
        ],
    };
    let program = program(context, name)?;
    let parameter = PARAMETER.decode("pname", pname)?;
    let value = match value {
        0 => false,
        1 => true,
        _ => return invalid_value(SECTION, format!("value = {value} must be GL_FALSE or GL_TRUE")),
    };
    match parameter {
        Parameter::BinaryHint => program.next_binary_hint = value,
        Parameter::Separable => {
            program.separable = if value { Separable::Yes } else { Separable::No };
        }
    }
    Ok(())
}
