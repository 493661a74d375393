//! Constants, and identities that are exact for every operand, NaN and both zeros included.

use super::super::Facts;
use crate::ir::{Expr, Module, Op, TRUE, Value};

/// What an operation turns out to be.
pub(super) enum Folded {
    /// These bits.
    Const(u32),
    /// One of its operands, or of theirs.
    Value(Value),
    /// What this one makes of the same operands, in fewer steps.
    Op(Op),
    /// Itself.
    Unchanged,
}

const ONE: u32 = 0x3f80_0000;
const MINUS_ZERO: u32 = 0x8000_0000;

/// Looks at an operation whose operands are simplified already.
#[inline(never)]
pub(super) fn fold(module: &Module, facts: &Facts, op: Op, args: [Value; 3]) -> Folded {
    let known = args.map(|value| module.constant(value));
    let arity = op.args().len();
    if let Some(words) = all(&known[..arity]) {
        return Folded::Const(op.eval(words));
    }
    let [a, b, c] = args;
    match (op, known[0], known[1]) {
        (Op::Mul, Some(ONE), _) => Folded::Value(b),
        // No infinity, no NaN, and no negative number.
        (Op::Mul, Some(0), _) if facts.bound(module, b).is_some() => Folded::Const(0),
        (Op::Mul, _, Some(0)) if facts.bound(module, a).is_some() => Folded::Const(0),
        (Op::Mul | Op::Div, _, Some(ONE)) => Folded::Value(a),
        // x + -0 is x even for -0; x + 0 is not.
        (Op::Add, Some(MINUS_ZERO), _) => Folded::Value(b),
        (Op::Add, _, Some(MINUS_ZERO)) | (Op::Sub, _, Some(0)) => Folded::Value(a),
        (Op::Add, Some(0), _) if is_never_minus_zero(module, facts, b) => Folded::Value(b),
        (Op::Add, _, Some(0)) if is_never_minus_zero(module, facts, a) => Folded::Value(a),
        (Op::Neg | Op::INeg | Op::Not | Op::BitNot, ..) => undo(module, op, op, a),
        (Op::IntToUint, ..) => undo(module, op, Op::UintToInt, a),
        (Op::UintToInt, ..) => undo(module, op, Op::IntToUint, a),

        (Op::IAdd | Op::UAdd | Op::BitOr | Op::BitXor, Some(0), _) => Folded::Value(b),
        (Op::IAdd | Op::ISub | Op::UAdd | Op::USub | Op::BitOr | Op::BitXor, _, Some(0))
        | (Op::ShiftLeft | Op::UShiftRight | Op::IShiftRight, _, Some(0)) => Folded::Value(a),
        (Op::IMul | Op::UMul, Some(1), _) | (Op::BitAnd, Some(u32::MAX), _) => Folded::Value(b),
        (Op::IMul | Op::UMul | Op::IDiv | Op::UDiv, _, Some(1))
        | (Op::BitAnd, _, Some(u32::MAX)) => Folded::Value(a),
        (Op::IMul | Op::UMul | Op::BitAnd, Some(0), _)
        | (Op::IMul | Op::UMul | Op::BitAnd, _, Some(0)) => Folded::Const(0),

        (Op::And, Some(TRUE), _) | (Op::Or | Op::Xor, Some(0), _) => Folded::Value(b),
        (Op::And, _, Some(TRUE)) | (Op::Or | Op::Xor, _, Some(0)) => Folded::Value(a),
        (Op::And, Some(0), _) | (Op::And, _, Some(0)) => Folded::Const(0),
        (Op::Or, Some(TRUE), _) | (Op::Or, _, Some(TRUE)) => Folded::Const(TRUE),
        (Op::And | Op::Or | Op::Min | Op::Max, ..) if a == b => Folded::Value(a),
        (Op::Min, _, Some(b)) if is_number(b) => Folded::Op(Op::AtMost),
        (Op::Max, _, Some(b)) if is_number(b) => Folded::Op(Op::AtLeast),
        (Op::ModNear, _, Some(b)) if f32::from_bits(b) > 0.0 => Folded::Op(Op::ModPositive),
        (Op::IMin | Op::IMax | Op::UMin | Op::UMax, ..) if a == b => Folded::Value(a),

        (Op::SelectF | Op::SelectI | Op::SelectU | Op::SelectB, Some(0), _) => Folded::Value(c),
        (Op::SelectF | Op::SelectI | Op::SelectU | Op::SelectB, Some(_), _) => Folded::Value(b),
        (Op::SelectF | Op::SelectI | Op::SelectU | Op::SelectB, ..) if b == c => Folded::Value(b),
        (Op::SelectB, _, Some(TRUE)) if known[2] == Some(0) => Folded::Value(a),
        _ => Folded::Unchanged,
    }
}

/// Whether it is known that a value is not -0.
fn is_never_minus_zero(module: &Module, facts: &Facts, value: Value) -> bool {
    if facts.bound(module, value).is_some() {
        return true;
    }
    let is_other = |value| module.constant(value).is_some_and(|bits| bits != MINUS_ZERO);
    match module.expr(value) {
        // A sum is -0 where both are.
        Expr::Op { op: Op::Add, args: [a, b, _] } => is_other(*a) || is_other(*b),
        Expr::Op { op, .. } => {
            matches!(op, Op::Floor | Op::Ceil | Op::Trunc | Op::IntToFloat | Op::UintToFloat)
        }
        Expr::Const { .. }
        | Expr::Input(_)
        | Expr::Uniform { .. }
        | Expr::UniformAt { .. }
        | Expr::Load(_)
        | Expr::LoadAt { .. }
        | Expr::Derivative { .. }
        | Expr::Tabulated { .. }
        | Expr::Sample(_)
        | Expr::Component { .. } => is_other(value),
    }
}

fn is_number(bits: u32) -> bool {
    !f32::from_bits(bits).is_nan()
}

fn all(known: &[Option<u32>]) -> Option<[u32; 3]> {
    let mut words = [0; 3];
    for (word, known) in words.iter_mut().zip(known) {
        *word = (*known)?;
    }
    Some(words)
}

/// `op(inverse(x))` is `x`.
fn undo(module: &Module, op: Op, inverse: Op, arg: Value) -> Folded {
    if let Expr::Op { op: inner, args } = module.expr(arg)
        && *inner == inverse
    {
        debug_assert_eq!(op.args(), &[inverse.result()]);
        return Folded::Value(args[0]);
    }
    Folded::Unchanged
}
