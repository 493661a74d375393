//! `glGetError` and the conversions of `glGet`: GL 2.1, section 6.1.2.

use crate::base::constants::*;
use crate::base::error::Result;
use crate::base::types::*;
use crate::base::value::Value;
use crate::calls::query::put;
use crate::calls::query::table::state_value;
use crate::context::Context;
use crate::state::env::unit_to_signed;

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

/// Answers in truth values: whether it is not zero.
pub(crate) fn put_bools(params: &mut [GLboolean], value: Value) -> Result<()> {
    let values: Vec<GLboolean> = match value {
        Value::Bools(values) => values.into_iter().map(u8::from).collect(),
        Value::Ints(values) => values.into_iter().map(|value| u8::from(value != 0)).collect(),
        Value::Word(value) => vec![u8::from(value != 0)],
        Value::Floats(values) | Value::Unit(values) => {
            values.into_iter().map(|value| u8::from(value != 0.0)).collect()
        }
    };
    put(params, &values)
}

/// Answers in integers: floats are rounded, fractions scaled to the whole range.
pub(crate) fn put_ints(params: &mut [GLint], value: Value) -> Result<()> {
    let values: Vec<GLint> = match value {
        Value::Bools(values) => values.into_iter().map(GLint::from).collect(),
        Value::Ints(values) => values,
        Value::Word(value) => vec![value as GLint],
        Value::Floats(values) => values.into_iter().map(|value| value.round() as GLint).collect(),
        Value::Unit(values) => {
            values.into_iter().map(|value| unit_to_signed(value as f32)).collect()
        }
    };
    put(params, &values)
}

/// Answers in integers of 64 bits: floats are rounded.
pub(crate) fn put_longs(params: &mut [GLint64], value: Value) -> Result<()> {
    let values = doubles(value).into_iter().map(|value| value.round() as GLint64);
    put(params, &values.collect::<Vec<_>>())
}

/// Answers in single precision.
pub(crate) fn put_floats(params: &mut [GLfloat], value: Value) -> Result<()> {
    put(params, &doubles(value).into_iter().map(|value| value as GLfloat).collect::<Vec<_>>())
}

/// Answers in double precision.
pub(crate) fn put_doubles(params: &mut [GLdouble], value: Value) -> Result<()> {
    put(params, &doubles(value))
}

fn doubles(value: Value) -> Vec<f64> {
    match value {
        Value::Bools(values) => values.into_iter().map(|on| f64::from(u8::from(on))).collect(),
        Value::Ints(values) => values.into_iter().map(f64::from).collect(),
        Value::Word(value) => vec![value.into()],
        Value::Floats(values) | Value::Unit(values) => values,
    }
}
