//! Common functions (GLSL 1.30 section 8.3).

use super::{Args, each};
use crate::emit::Emit;
use rasterizer::ir::{Op, Value};
use texunit::lanes::math::NAN;

/// The smaller.
pub fn min(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    extreme(emit, args, Op::Min)
}

/// The larger.
pub fn max(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    extreme(emit, args, Op::Max)
}

/// `Op::Min` and `Op::Max` with a constant as second operand are a single instruction, so a
/// constant first operand is swapped, unless it is zero: of two zeros the second is the result,
/// whatever their signs.
fn extreme(emit: &mut Emit, args: Args<'_>, op: Op) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let [a, b] = [at(0), at(1)];
        let first = emit.known(a).filter(|_| emit.known(b).is_none()).map(f32::from_bits);
        match first {
            Some(0.0) => {
                let order = if op == Op::Min { [b, a] } else { [a, b] };
                let is_second = emit.op(Op::LessEqual, &order);
                emit.op(Op::SelectF, &[is_second, b, a])
            }
            Some(_) => emit.op(op, &[b, a]),
            None => emit.op(op, &[a, b]),
        }
    })
}

/// The bits as a signed integer.
pub fn float_bits_to_int(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let bits = float_bits(emit, at(0));
        emit.op(Op::UintToInt, &[bits])
    })
}

/// The bits as an unsigned integer.
pub fn float_bits_to_uint(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| float_bits(emit, at(0)))
}

/// The bits as [`texunit::lanes::math::bits`] gives them.
pub(super) fn float_bits(emit: &mut Emit, x: Value) -> Value {
    let bits = emit.op(Op::FloatBits, &[x]);
    let [signed, unsigned] = [NAN | 1 << 31, NAN].map(|bits| emit.uint(bits));
    let is_signed = emit.equal(bits, signed);
    emit.select(is_signed, unsigned, bits)
}

/// The float with the bits of a signed integer.
pub fn int_bits_to_float(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let bits = emit.op(Op::IntToUint, &[at(0)]);
        emit.op(Op::BitsFloat, &[bits])
    })
}

/// `x - y · floor(x / y)`. `y` is often constant; then its inverse is folded.
pub fn modulo(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let one = emit.float(1.0);
    each(emit, args, |emit, at| {
        let inverse = emit.op(Op::Div, &[one, at(1)]);
        let is_finite = emit.known(inverse).is_some_and(|bits| f32::from_bits(bits).is_finite());
        emit.op(if is_finite { Op::ModNear } else { Op::Mod }, &[at(0), at(1), inverse])
    })
}

fn clamp_with(emit: &mut Emit, args: Args<'_>, min: Op, max: Op) -> Vec<Value> {
    each(emit, args, |emit, at| {
        let above = emit.op(max, &[at(0), at(1)]);
        emit.op(min, &[above, at(2)])
    })
}

/// `min(max(x, low), high)`.
pub fn clamp(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    clamp_with(emit, args, Op::Min, Op::Max)
}

/// `min(max(x, low), high)`.
pub fn clamp_int(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    clamp_with(emit, args, Op::IMin, Op::IMax)
}

/// `min(max(x, low), high)`.
pub fn clamp_uint(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    clamp_with(emit, args, Op::UMin, Op::UMax)
}

/// `x · (1 - a) + y · a`.
pub fn mix(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let one = emit.float(1.0);
    each(emit, args, |emit, at| {
        let rest = emit.op(Op::Sub, &[one, at(2)]);
        let left = emit.op(Op::Mul, &[at(0), rest]);
        let right = emit.op(Op::Mul, &[at(1), at(2)]);
        emit.op(Op::Add, &[left, right])
    })
}

/// `y` where `a`, else `x`.
pub fn mix_select(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::SelectF, &[at(2), at(1), at(0)]))
}

/// 0 where `x < edge`, else 1.
pub fn step(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let (zero, one) = (emit.float(0.0), emit.float(1.0));
    each(emit, args, |emit, at| {
        let below = emit.op(Op::Less, &[at(1), at(0)]);
        emit.op(Op::SelectF, &[below, zero, one])
    })
}

/// `t² · (3 - 2t)` of `t = clamp((x - edge0) / (edge1 - edge0), 0, 1)`.
pub fn smoothstep(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let [zero, one, two, three] = [0.0, 1.0, 2.0, 3.0].map(|x| emit.float(x));
    each(emit, args, |emit, at| {
        let above = emit.op(Op::Sub, &[at(2), at(0)]);
        let width = emit.op(Op::Sub, &[at(1), at(0)]);
        let t = emit.op(Op::Div, &[above, width]);
        let t = emit.op(Op::Max, &[t, zero]);
        let t = emit.op(Op::Min, &[t, one]);
        let square = emit.op(Op::Mul, &[t, t]);
        let double = emit.op(Op::Mul, &[two, t]);
        let rest = emit.op(Op::Sub, &[three, double]);
        emit.op(Op::Mul, &[square, rest])
    })
}

/// Whether `x` differs from itself.
pub fn isnan(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    each(emit, args, |emit, at| emit.op(Op::NotEqual, &[at(0), at(0)]))
}

/// Whether `|x|` is infinite.
pub fn isinf(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let infinity = emit.float(f32::INFINITY);
    each(emit, args, |emit, at| {
        let size = emit.op(Op::Abs, &[at(0)]);
        emit.op(Op::Equal, &[size, infinity])
    })
}
