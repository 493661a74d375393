//! Vector relational functions (GLSL 1.30 section 8.6).

use super::{Args, each};
use crate::emit::Emit;
use rasterizer::ir::{Op, Ty, Value};

/// `a > b`.
pub fn greater(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::Less, &[at(1), at(0)]))
}

/// `a > b`.
pub fn greater_int(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::ILess, &[at(1), at(0)]))
}

/// `a > b`.
pub fn greater_uint(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::ULess, &[at(1), at(0)]))
}

/// `a >= b`.
pub fn greater_equal(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::LessEqual, &[at(1), at(0)]))
}

/// `a >= b`.
pub fn greater_equal_int(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::ILessEqual, &[at(1), at(0)]))
}

/// `a >= b`.
pub fn greater_equal_uint(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::ULessEqual, &[at(1), at(0)]))
}

/// `a == b`, for each component.
pub fn equal(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.equal(at(0), at(1)))
}

/// `a != b`, for each component.
pub fn not_equal(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let equal = emit.equal(at(0), at(1));
        emit.op(Op::Not, &[equal])
    })
}

/// Whether a component is true.
pub fn any(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let none = emit.constant(0, Ty::Bool);
    vec![args.values[0].iter().fold(none, |found, &x| emit.op(Op::Or, &[found, x]))]
}

/// Whether all components are true.
pub fn all(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let first = args.values[0][0];
    vec![args.values[0][1..].iter().fold(first, |found, &x| emit.op(Op::And, &[found, x]))]
}
