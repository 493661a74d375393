//! What can be asked of assembly programs: ARB_vertex_program, section 6.1.12.

use crate::assembly::program::{Counts, Target};
use crate::base::args::{DataOut, LocatedOut};
use crate::base::assembly_limits as limits;
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum, invalid_operation};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::program::assembly::parameters;
use crate::context::Context;
use crate::interface::MAX_VERTEX_ATTRIBS;
use crate::objects::assemblies::{Assembly, TARGET};
use crate::state::assembly::{SECTION, Scope, checked};
use parking_lot::Mutex;

fn parameter(
    context: &Context,
    scope: Scope,
    target: GLenum,
    index: GLuint,
) -> Result<[GLfloat; 4]> {
    let target = TARGET.decode("target", target)?;
    let index = checked(scope, index, 1)?;
    Ok(parameters(context, target, scope).get(index).copied().unwrap_or_default())
}

pub(crate) fn get_program_env_parameterfv(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    params: &mut [GLfloat],
) -> Result<()> {
    put(params, &parameter(context, Scope::Env, target, index)?)
}

pub(crate) fn get_program_env_parameterdv(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    params: &mut [GLdouble],
) -> Result<()> {
    put(params, &parameter(context, Scope::Env, target, index)?.map(GLdouble::from))
}

pub(crate) fn get_program_local_parameterfv(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    params: &mut [GLfloat],
) -> Result<()> {
    put(params, &parameter(context, Scope::Local, target, index)?)
}

pub(crate) fn get_program_local_parameterdv(
    context: &mut Context,
    target: GLenum,
    index: GLuint,
    params: &mut [GLdouble],
) -> Result<()> {
    put(params, &parameter(context, Scope::Local, target, index)?.map(GLdouble::from))
}

fn bound(context: &Context, target: Target) -> &Assembly {
    context.objects.assembly(target, &context.state.assembly.bound[target as usize])
}

/// What the bound program has of something that is limited, and the limit. Limits are the
/// implementation's own, "native" ones too.
fn counted(target: Target, counts: &Counts, pname: GLenum) -> Option<u32> {
    let attributes = match target {
        Target::Vertex => MAX_VERTEX_ATTRIBS.into(),
        Target::Fragment => limits::MAX_FRAGMENT_ATTRIBS,
    };
    let addresses = match target {
        Target::Vertex => limits::MAX_ADDRESS_REGISTERS,
        Target::Fragment => 0,
    };
    Some(match pname {
        GL_PROGRAM_INSTRUCTIONS_ARB | GL_PROGRAM_NATIVE_INSTRUCTIONS_ARB => counts.instructions,
        GL_PROGRAM_TEMPORARIES_ARB | GL_PROGRAM_NATIVE_TEMPORARIES_ARB => counts.temporaries,
        GL_PROGRAM_PARAMETERS_ARB | GL_PROGRAM_NATIVE_PARAMETERS_ARB => counts.parameters,
        GL_PROGRAM_ATTRIBS_ARB | GL_PROGRAM_NATIVE_ATTRIBS_ARB => counts.attributes,
        GL_PROGRAM_ADDRESS_REGISTERS_ARB | GL_PROGRAM_NATIVE_ADDRESS_REGISTERS_ARB => {
            counts.addresses
        }
        GL_MAX_PROGRAM_INSTRUCTIONS_ARB | GL_MAX_PROGRAM_NATIVE_INSTRUCTIONS_ARB => {
            limits::MAX_INSTRUCTIONS
        }
        GL_MAX_PROGRAM_TEMPORARIES_ARB | GL_MAX_PROGRAM_NATIVE_TEMPORARIES_ARB => {
            limits::MAX_TEMPORARIES
        }
        GL_MAX_PROGRAM_PARAMETERS_ARB | GL_MAX_PROGRAM_NATIVE_PARAMETERS_ARB => {
            limits::MAX_PARAMETERS
        }
        GL_MAX_PROGRAM_ATTRIBS_ARB | GL_MAX_PROGRAM_NATIVE_ATTRIBS_ARB => attributes,
        GL_MAX_PROGRAM_ADDRESS_REGISTERS_ARB | GL_MAX_PROGRAM_NATIVE_ADDRESS_REGISTERS_ARB => {
            addresses
        }
        GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB => limits::MAX_LOCAL_PARAMETERS,
        GL_MAX_PROGRAM_ENV_PARAMETERS_ARB => limits::MAX_ENV_PARAMETERS,
        _ => return fragment_counted(target, counts, pname),
    })
}

/// What fragment programs alone have (ARB_fragment_program, section 6.1.12).
fn fragment_counted(target: Target, counts: &Counts, pname: GLenum) -> Option<u32> {
    if target == Target::Vertex {
        return None;
    }
    Some(match pname {
        GL_PROGRAM_ALU_INSTRUCTIONS_ARB | GL_PROGRAM_NATIVE_ALU_INSTRUCTIONS_ARB => {
            counts.instructions - counts.lookups
        }
        GL_PROGRAM_TEX_INSTRUCTIONS_ARB | GL_PROGRAM_NATIVE_TEX_INSTRUCTIONS_ARB => counts.lookups,
        GL_PROGRAM_TEX_INDIRECTIONS_ARB | GL_PROGRAM_NATIVE_TEX_INDIRECTIONS_ARB => {
            counts.indirections
        }
        GL_MAX_PROGRAM_ALU_INSTRUCTIONS_ARB
        | GL_MAX_PROGRAM_NATIVE_ALU_INSTRUCTIONS_ARB
        | GL_MAX_PROGRAM_TEX_INSTRUCTIONS_ARB
        | GL_MAX_PROGRAM_NATIVE_TEX_INSTRUCTIONS_ARB
        | GL_MAX_PROGRAM_TEX_INDIRECTIONS_ARB
        | GL_MAX_PROGRAM_NATIVE_TEX_INDIRECTIONS_ARB => limits::MAX_INSTRUCTIONS,
        _ => return None,
    })
}

pub(crate) fn get_assembly_programiv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let target = TARGET.decode("target", target)?;
    let program = bound(context, target);
    let counts = program.loaded.as_ref().map_or_else(Counts::default, |loaded| loaded.counts);
    let value = match pname {
        GL_PROGRAM_LENGTH_ARB => program.text.len() as u32,
        GL_PROGRAM_FORMAT_ARB => GL_PROGRAM_FORMAT_ASCII_ARB,
        GL_PROGRAM_BINDING_ARB => context.state.assembly.bound[target as usize].name(),
        GL_PROGRAM_UNDER_NATIVE_LIMITS_ARB => 1,
        _ => match counted(target, &counts, pname) {
            Some(value) => value,
            None => {
                let name = enum_name(pname);
                let rule = format!("pname = {name} is nothing that programs of this target have");
                return invalid_enum("ARB_vertex_program, section 6.1.12", rule);
            }
        },
    };
    put(params, &[value as GLint])
}

pub(crate) fn get_program_string(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    string: DataOut<'_>,
) -> Result<()> {
    const STRING: Table<()> = Table { section: SECTION, rows: &[(GL_PROGRAM_STRING_ARB, ())] };
    let target = TARGET.decode("target", target)?;
    STRING.decode("pname", pname)?;
    let text = bound(context, target).text.as_bytes();
    let destination = match string.locate(0, text.len()) {
        LocatedOut::Bytes(bytes) => bytes.get_mut(..text.len()),
        LocatedOut::Offset(_) | LocatedOut::Null => None,
    };
    match destination {
        Some(destination) => destination.copy_from_slice(text),
        None => {
            let needs = text.len();
            return invalid_operation(SECTION, format!("string must have room for {needs} bytes"));
        }
    }
    Ok(())
}

/// Text that stays, as `glGetString` promises: made once for each different one.
pub(crate) fn kept(text: &str) -> &'static str {
    static KEPT: Mutex<Vec<&str>> = Mutex::new(Vec::new());
    let mut kept = KEPT.lock();
    if let Some(known) = kept.iter().find(|known| **known == text) {
        return known;
    }
    let new: &'static str = String::leak(text.to_owned());
    kept.push(new);
    new
}
