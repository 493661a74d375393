//! The table of state that `glGet` reads: GL 2.1, tables 6.5 to 6.37.

use crate::base::error::Result;
use crate::base::types::*;

/// State, before the conversion to the type that was asked for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Bools(Vec<bool>),
    Ints(Vec<i32>),
    /// A symbol, name or mask; as an integer of 32 bits, the same bits.
    Word(u32),
    Floats(Vec<f64>),
    /// Colours, normals and depths: as integers, 1 is the largest one.
    Unit(Vec<f64>),
}

pub(crate) fn flag(value: bool) -> Result<Value> {
    Ok(Value::Bools(vec![value]))
}

pub(crate) fn symbol(value: GLenum) -> Result<Value> {
    Ok(Value::Word(value))
}

pub(crate) fn float(value: f32) -> Result<Value> {
    Ok(Value::Floats(vec![value.into()]))
}

pub(crate) fn floats(values: &[f32]) -> Result<Value> {
    Ok(Value::Floats(values.iter().map(|&value| value.into()).collect()))
}

pub(crate) fn unit(values: &[f32]) -> Result<Value> {
    Ok(Value::Unit(values.iter().map(|&value| value.into()).collect()))
}
