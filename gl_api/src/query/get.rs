//! `glGetError`, and `glGet` in each type: GL 2.1, sections 2.5 and 6.1.2.

use crate::base::constants::*;
use crate::base::error::Result;
use crate::base::query_value::{put_bools, put_doubles, put_floats, put_ints, put_longs};
use crate::base::types::*;
use crate::context::Context;
use crate::query::state::state_value;

/// Between `glBegin` and `glEnd` this is refused like any other call, which sets the flag.
pub(crate) fn get_error(context: &mut Context) -> Result<GLenum> {
    Ok(context.debug.take_flag().map_or(GL_NO_ERROR, crate::base::error::ErrorCode::to_gl))
}

pub(crate) fn get_booleanv(
    context: &mut Context,
    pname: GLenum,
    params: &mut [GLboolean],
) -> Result<()> {
    put_bools(params, state_value(context, pname)?)
}

pub(crate) fn get_integerv(
    context: &mut Context,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    put_ints(params, state_value(context, pname)?)
}

pub(crate) fn get_integer64v(
    context: &mut Context,
    pname: GLenum,
    params: &mut [GLint64],
) -> Result<()> {
    put_longs(params, state_value(context, pname)?)
}

pub(crate) fn get_floatv(
    context: &mut Context,
    pname: GLenum,
    params: &mut [GLfloat],
) -> Result<()> {
    put_floats(params, state_value(context, pname)?)
}

pub(crate) fn get_doublev(
    context: &mut Context,
    pname: GLenum,
    params: &mut [GLdouble],
) -> Result<()> {
    put_doubles(params, state_value(context, pname)?)
}
