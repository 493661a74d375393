//! `glGetVertexAttrib` in doubles and in integers: GL 2.1, section 6.1.14.

use crate::base::error::Result;
use crate::base::query_value::put;
use crate::base::types::*;
use crate::context::Context;
use crate::query::arrays::{Answer, property};

pub(crate) fn get_vertex_attribdv(
    context: &mut Context,
    index: GLuint,
    pname: GLenum,
    params: &mut [GLdouble],
) -> Result<()> {
    put(params, &property(context, index, pname)?.numbers())
}

/// The words of a property: integers of an attribute travel as the bits of floats.
fn words(context: &Context, index: GLuint, pname: GLenum) -> Result<Vec<u32>> {
    Ok(match property(context, index, pname)? {
        Answer::Number(number) => vec![number as u32],
        Answer::Current(value) => value.map(f32::to_bits).to_vec(),
    })
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
