//! Values that queries return, and their conversion to the type that was asked for (GL 2.1, section 6.1.2).

use crate::base::convert::unit_to_signed;
use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;

/// State before the conversion to the type that was asked for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum QueryValue {
    Bools(Vec<bool>),
    Ints(Vec<i32>),
    /// A named constant, object name or mask; as an integer of 32 bits, the same bits.
    Word(u32),
    Floats(Vec<f64>),
    /// Normalized values (colours, normals, depths): as an integer, 1 is the largest one.
    Unit(Vec<f64>),
}

pub(crate) fn flag(value: bool) -> Result<QueryValue> {
    Ok(QueryValue::Bools(vec![value]))
}

pub(crate) fn symbol(value: GLenum) -> Result<QueryValue> {
    Ok(QueryValue::Word(value))
}

pub(crate) fn float(value: f32) -> Result<QueryValue> {
    Ok(QueryValue::Floats(vec![value.into()]))
}

pub(crate) fn floats(values: &[f32]) -> Result<QueryValue> {
    Ok(QueryValue::Floats(values.iter().map(|&value| value.into()).collect()))
}

pub(crate) fn unit(values: &[f32]) -> Result<QueryValue> {
    Ok(QueryValue::Unit(values.iter().map(|&value| value.into()).collect()))
}

/// Copies query results to `params`, which must be long enough for all of them.
pub(crate) fn put<T: Copy>(params: &mut [T], values: &[T]) -> Result<()> {
    destination(params, values.len())?.copy_from_slice(values);
    Ok(())
}

/// The elements of `params` that as many values are written to.
pub(crate) fn destination<T>(params: &mut [T], needed: usize) -> Result<&mut [T]> {
    let has = params.len();
    match params.get_mut(..needed) {
        Some(params) => Ok(params),
        None => invalid_operation(
            "GL 2.1, section 6.1",
            format!("the answer has {needed} values, params has room for {has}"),
        ),
    }
}

/// Writes booleans: `GL_TRUE` for all but zero.
pub(crate) fn put_bools(params: &mut [GLboolean], value: QueryValue) -> Result<()> {
    let values: Vec<GLboolean> = match value {
        QueryValue::Bools(values) => values.into_iter().map(u8::from).collect(),
        QueryValue::Ints(values) => values.into_iter().map(|value| u8::from(value != 0)).collect(),
        QueryValue::Word(value) => vec![u8::from(value != 0)],
        QueryValue::Floats(values) | QueryValue::Unit(values) => {
            values.into_iter().map(|value| u8::from(value != 0.0)).collect()
        }
    };
    put(params, &values)
}

/// Writes integers: floats are rounded, normalized values scaled to the whole range.
pub(crate) fn put_ints(params: &mut [GLint], value: QueryValue) -> Result<()> {
    let values: Vec<GLint> = match value {
        QueryValue::Bools(values) => values.into_iter().map(GLint::from).collect(),
        QueryValue::Ints(values) => values,
        QueryValue::Word(value) => vec![value as GLint],
        QueryValue::Floats(values) => {
            values.into_iter().map(|value| value.round() as GLint).collect()
        }
        QueryValue::Unit(values) => values.into_iter().map(unit_to_signed).collect(),
    };
    put(params, &values)
}

/// Writes 64-bit integers: floats are rounded; of normalized values, 1 is the largest integer of 32 bits (GL 3.2, section
/// 6.1.2).
pub(crate) fn put_longs(params: &mut [GLint64], value: QueryValue) -> Result<()> {
    let values: Vec<GLint64> = match value {
        QueryValue::Unit(values) => {
            values.into_iter().map(|value| unit_to_signed(value).into()).collect()
        }
        QueryValue::Bools(_)
        | QueryValue::Ints(_)
        | QueryValue::Word(_)
        | QueryValue::Floats(_) => {
            doubles(value).into_iter().map(|value| value.round() as GLint64).collect()
        }
    };
    put(params, &values)
}

/// Writes single precision.
pub(crate) fn put_floats(params: &mut [GLfloat], value: QueryValue) -> Result<()> {
    put(params, &doubles(value).into_iter().map(|value| value as GLfloat).collect::<Vec<_>>())
}

/// Writes double precision.
pub(crate) fn put_doubles(params: &mut [GLdouble], value: QueryValue) -> Result<()> {
    put(params, &doubles(value))
}

fn doubles(value: QueryValue) -> Vec<f64> {
    match value {
        QueryValue::Bools(values) => values.into_iter().map(|on| f64::from(u8::from(on))).collect(),
        QueryValue::Ints(values) => values.into_iter().map(f64::from).collect(),
        QueryValue::Word(value) => vec![value.into()],
        QueryValue::Floats(values) | QueryValue::Unit(values) => values,
    }
}
