//! How the answers of queries are written to the client's memory (GL 2.1, section 6.1).

use crate::base::convert::unit_to_signed;
use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::base::value::Value;

/// Writes the answer to a query; the slice must have room for all of it.
pub(crate) fn put<T: Copy>(params: &mut [T], values: &[T]) -> Result<()> {
    let (needed, has) = (values.len(), params.len());
    match params.get_mut(..needed) {
        Some(params) => {
            params.copy_from_slice(values);
            Ok(())
        }
        None => invalid_operation(
            "GL 2.1, section 6.1",
            format!("the answer has {needed} values, params has room for {has}"),
        ),
    }
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
