//! `glGetVertexAttrib` in doubles and in integers: GL 2.1, section 6.1.14.

use crate::base::constants::GL_CURRENT_VERTEX_ATTRIB;
use crate::base::error::Result;
use crate::base::query_value::put;
use crate::base::types::*;
use crate::context::Context;
use crate::query::arrays::property;

pub(crate) fn get_vertex_attribdv(
    context: &mut Context,
    index: GLuint,
    pname: GLenum,
    params: &mut [GLdouble],
) -> Result<()> {
    let values = property(context, index, pname)?;
    put(params, &values.into_iter().map(f64::from).collect::<Vec<_>>())
}

/// The words of a property: integers of an attribute travel as the bits of floats.
fn words(context: &Context, index: GLuint, pname: GLenum) -> Result<Vec<u32>> {
    let word = |value: f32| match pname {
        GL_CURRENT_VERTEX_ATTRIB => value.to_bits(),
        _ => value as u32,
    };
    Ok(property(context, index, pname)?.into_iter().map(word).collect())
}

pub(crate) fn get_vertex_attrib_i_iv(
    context: &mut Context,
    index: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let words = words(context, index, pname)?;
    put(params, &words.into_iter().map(u32::cast_signed).collect::<Vec<_>>())
}

pub(crate) fn get_vertex_attrib_i_uiv(
    context: &mut Context,
    index: GLuint,
    pname: GLenum,
    params: &mut [GLuint],
) -> Result<()> {
    put(params, &words(context, index, pname)?)
}
