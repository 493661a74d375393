//! Angles (GLSL 1.30 section 8.1).

use super::{Args, each};
use crate::emit::Emit;
use rasterizer::ir::{Op, Value};

// Both factors are rounded once: 180 over the f32 next to π would be an ULP off.

/// `x · π / 180`.
pub fn radians(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let factor = emit.float((std::f64::consts::PI / 180.0) as f32);
    each(emit, args, |emit, at| emit.op(Op::Mul, &[at(0), factor]))
}

/// `x · 180 / π`.
pub fn degrees(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let factor = emit.float((180.0 / std::f64::consts::PI) as f32);
    each(emit, args, |emit, at| emit.op(Op::Mul, &[at(0), factor]))
}
