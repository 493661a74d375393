//! Queries that name their vertex array object: `ARB_direct_state_access`, section 10.5.

use crate::base::constants::*;
use crate::base::error::{Result, Table};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::vertex::array_objects::ChosenArrays;
use crate::calls::vertex::bindings::binding_point;
use crate::context::Context;
use crate::query::arrays::array_property;

pub(crate) fn get_vertex_arrayiv(
    context: &mut Context,
    vaobj: GLuint,
    pname: GLenum,
    param: &mut [GLint],
) -> Result<()> {
    const PARAMETER: Table<()> = Table {
        section: "ARB_direct_state_access, section 10.5",
        rows: &[(GL_ELEMENT_ARRAY_BUFFER_BINDING, ())],
    };
    let chosen = ChosenArrays::named(context, vaobj)?;
    PARAMETER.decode("pname", pname)?;
    put(param, &[chosen.element_array_buffer(context).name() as GLint])
}

pub(crate) fn get_vertex_array_indexediv(
    context: &mut Context,
    vaobj: GLuint,
    index: GLuint,
    pname: GLenum,
    param: &mut [GLint],
) -> Result<()> {
    let chosen = ChosenArrays::named(context, vaobj)?;
    let value = array_property(chosen.arrays(context), index, pname)?;
    put(param, &[value as GLint])
}

pub(crate) fn get_vertex_array_indexed64iv(
    context: &mut Context,
    vaobj: GLuint,
    index: GLuint,
    pname: GLenum,
    param: &mut [GLint64],
) -> Result<()> {
    const PARAMETER: Table<()> = Table {
        section: "ARB_direct_state_access, section 10.5",
        rows: &[(GL_VERTEX_BINDING_OFFSET, ())],
    };
    let chosen = ChosenArrays::named(context, vaobj)?;
    let binding = usize::from(binding_point(index)?);
    PARAMETER.decode("pname", pname)?;
    put(param, &[chosen.arrays(context).bindings[binding].offset as GLint64])
}
