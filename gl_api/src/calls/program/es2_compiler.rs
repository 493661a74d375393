//! The calls of OpenGL ES 2.0 about the compiler (`ARB_ES2_compatibility`): it is always there, takes no
//! binaries, and calculates with 32 bits whatever precision is written.

use crate::base::args::Data;
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum, not_negative};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::context::Context;
use crate::objects::shaders::STAGE;

const SECTION: &str = "ARB_ES2_compatibility";

/// The numbers that a precision is asked of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Numbers {
    Floats,
    Integers,
}

const PRECISION: Table<Numbers> = Table {
    section: SECTION,
    rows: &[
        (GL_LOW_FLOAT, Numbers::Floats),
        (GL_MEDIUM_FLOAT, Numbers::Floats),
        (GL_HIGH_FLOAT, Numbers::Floats),
        (GL_LOW_INT, Numbers::Integers),
        (GL_MEDIUM_INT, Numbers::Integers),
        (GL_HIGH_INT, Numbers::Integers),
    ],
};

/// There is nothing to release: what a compilation takes goes with it.
pub(crate) fn release_shader_compiler(_: &mut Context) -> Result<()> {
    Ok(())
}

pub(crate) fn shader_binary(
    _: &mut Context,
    count: GLsizei,
    _: &[GLuint],
    binary_format: GLenum,
    _: Data<'_>,
    length: GLsizei,
) -> Result<()> {
    not_negative(SECTION, "count", count.into())?;
    not_negative(SECTION, "length", length.into())?;
    let name = enum_name(binary_format);
    let rule =
        format!("binaryFormat = {name}: there is no format, see GL_NUM_SHADER_BINARY_FORMATS");
    invalid_enum(SECTION, rule)
}

/// Ranges are logarithms to the base 2, rounded down.
pub(crate) fn get_shader_precision_format(
    _: &mut Context,
    shader_type: GLenum,
    precision_type: GLenum,
    range: &mut [GLint],
    precision: &mut [GLint],
) -> Result<()> {
    STAGE.decode("shaderType", shader_type)?;
    let (ends, bits) = match PRECISION.decode("precisionType", precision_type)? {
        Numbers::Floats => ([127, 127], 23),
        Numbers::Integers => ([31, 30], 0),
    };
    put(range, &ends)?;
    put(precision, &[bits])
}
