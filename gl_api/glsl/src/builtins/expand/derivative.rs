//! Derivatives (GLSL 1.30 section 8.8).

use super::{Args, each};
use crate::emit::Emit;
use rasterizer::ir::{Axis, Op, Value};

/// `|dFdx(p)| + |dFdy(p)|`.
pub fn fwidth(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let [x, y] = [Axis::X, Axis::Y].map(|axis| {
            let slope = emit.derivative(axis, at(0));
            emit.op(Op::Abs, &[slope])
        });
        emit.op(Op::Add, &[x, y])
    })
}
