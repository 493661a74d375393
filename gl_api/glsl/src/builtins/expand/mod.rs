//! What the functions compute that are more than one operation. The order of the operations is the
//! definition of the result.

pub mod angle;
pub mod common;
pub mod derivative;
pub mod geometric;
pub mod matrix;
pub mod noise;
pub mod pack;
pub mod relational;

use crate::emit::Emit;
use crate::types::Type;
use rasterizer::ir::{Op, Value};

/// The arguments of a call.
#[derive(Clone, Copy)]
pub struct Args<'a> {
    /// The scalars of each.
    pub values: &'a [Vec<Value>],
    /// The types of each.
    pub types: &'a [Type],
}

impl Args<'_> {
    /// Component `index` of argument `which`; a scalar goes with every component.
    pub fn at(&self, which: usize, index: usize) -> Value {
        let values = &self.values[which];
        values[index.min(values.len() - 1)]
    }

    /// The number of components that a result of the widest argument has.
    pub fn len(&self) -> usize {
        self.values.iter().map(Vec::len).max().unwrap_or(0)
    }
}

/// The operation on each component; a scalar goes with all components.
pub fn per_component(emit: &mut Emit, args: Args<'_>, op: Op) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let operands: Vec<Value> = (0..args.values.len()).map(at).collect();
        emit.op(op, &operands)
    })
}

/// `f` for each component; its second argument gives an argument's component.
pub fn each(
    emit: &mut Emit,
    args: Args<'_>,
    f: impl Fn(&mut Emit, &dyn Fn(usize) -> Value) -> Value,
) -> Vec<Value> {
    (0..args.len()).map(|index| f(emit, &|which| args.at(which, index))).collect()
}
