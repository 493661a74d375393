//! The calls of `ARB_shader_objects`, whose handles are of shaders or programs, that GL 2.0 does not have. Those that
//! GL 2.0 has under other names are rows of the table of entry points.

use crate::base::args::TextOut;
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::program::inspect::{get_program_info_log, get_programiv};
use crate::calls::program::programs::delete_program;
use crate::calls::program::shaders::{delete_shader, get_shader_info_log, get_shaderiv};
use crate::context::Context;
use crate::objects::programs::ShaderOrProgram;

const SECTION: &str = "ARB_shader_objects, section 6.1.12";

/// What a handle is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ObjectType {
    Shader,
    Program,
}

fn object_type(context: &Context, object: GLuint) -> Result<ObjectType> {
    match context.objects.shared.programs.get(object) {
        Some(ShaderOrProgram::Shader(_)) => Ok(ObjectType::Shader),
        Some(ShaderOrProgram::Program(_)) => Ok(ObjectType::Program),
        None => invalid_value(SECTION, format!("obj = {object} is no shader and no program")),
    }
}

pub(crate) fn get_object_parameteriv(
    context: &mut Context,
    object: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let object_type = object_type(context, object)?;
    match (pname, object_type) {
        (GL_OBJECT_TYPE_ARB, ObjectType::Shader) => put(params, &[GL_SHADER_OBJECT_ARB as GLint]),
        (GL_OBJECT_TYPE_ARB, ObjectType::Program) => put(params, &[GL_PROGRAM_OBJECT_ARB as GLint]),
        (GL_OBJECT_SUBTYPE_ARB, ObjectType::Program) => {
            invalid_operation(SECTION, "pname = GL_OBJECT_SUBTYPE_ARB is of shaders alone")
        }
        // The values of the others are GL 2.0's; the subtype is the shader's type.
        (_, ObjectType::Shader) => get_shaderiv(context, object, pname, params),
        (_, ObjectType::Program) => get_programiv(context, object, pname, params),
    }
}

pub(crate) fn get_object_parameterfv(
    context: &mut Context,
    object: GLuint,
    pname: GLenum,
    params: &mut [GLfloat],
) -> Result<()> {
    let mut value = [0];
    get_object_parameteriv(context, object, pname, &mut value)?;
    put(params, &[value[0] as GLfloat])
}

pub(crate) fn get_info_log(
    context: &mut Context,
    object: GLuint,
    max_length: GLsizei,
    length: &mut [GLsizei],
    info_log: TextOut<'_>,
) -> Result<()> {
    match object_type(context, object)? {
        ObjectType::Shader => get_shader_info_log(context, object, max_length, length, info_log),
        ObjectType::Program => get_program_info_log(context, object, max_length, length, info_log),
    }
}

pub(crate) fn get_handle(context: &mut Context, pname: GLenum) -> Result<GLuint> {
    const HANDLE: Table<()> = Table { section: SECTION, rows: &[(GL_PROGRAM_OBJECT_ARB, ())] };
    HANDLE.decode("pname", pname)?;
    Ok(context.state.bindings.program.name())
}

pub(crate) fn delete_object(context: &mut Context, object: GLuint) -> Result<()> {
    if object == 0 {
        return Ok(());
    }
    match object_type(context, object)? {
        ObjectType::Shader => delete_shader(context, object),
        ObjectType::Program => delete_program(context, object),
    }
}
