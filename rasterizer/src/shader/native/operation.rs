//! The steps of machine code that an operation of the IR takes.

use crate::ir::Op;
use texunit::lanes::code::{Binary, Block, Compare, Rounding, Step, Unary, Value};

const SIGN: u32 = 1 << 31;

fn constant(block: &mut Block, word: u32) -> Value {
    block.value(Step::Constant(word))
}

fn float(block: &mut Block, value: f32) -> Value {
    constant(block, value.to_bits())
}

fn unary(block: &mut Block, op: Unary, a: Value) -> Value {
    block.value(Step::Unary(op, a))
}

fn binary(block: &mut Block, op: Binary, a: Value, b: Value) -> Value {
    block.value(Step::Binary(op, a, b))
}

fn select(block: &mut Block, condition: Value, b: Value, c: Value) -> Value {
    block.value(Step::Select(condition, b, c))
}

fn not(block: &mut Block, a: Value) -> Value {
    let ones = constant(block, !0);
    binary(block, Binary::Xor, a, ones)
}

/// An integer as a float, 0 with the sign +.
fn round(block: &mut Block, rounding: Rounding, a: Value) -> Value {
    let whole = unary(block, Unary::Round(rounding), a);
    let zero = float(block, 0.0);
    binary(block, Binary::Add, whole, zero)
}

fn compare(block: &mut Block, compare: Compare, a: Value, b: Value) -> Value {
    binary(block, Binary::Compare(compare), a, b)
}

/// A shift by the low five bits of the count.
fn shift(block: &mut Block, op: Binary, a: Value, count: Value) -> Value {
    let low = constant(block, 31);
    let count = binary(block, Binary::And, count, low);
    binary(block, op, a, count)
}

/// `a - b` times the integer nearest to `a` times the inverse, see [`texunit::lanes::math::modulo`].
fn modulo_rest(block: &mut Block, a: Value, b: Value, inverse: Value) -> Value {
    let product = binary(block, Binary::Mul, a, inverse);
    let nearest = unary(block, Unary::Round(Rounding::Even), product);
    let whole = binary(block, Binary::Mul, b, nearest);
    binary(block, Binary::Sub, a, whole)
}

/// The steps of an operation, as its row in `ir/ops.rs` has it; `None` for those that have no machine code.
pub(super) fn operation(block: &mut Block, op: Op, [a, b, c]: [Value; 3]) -> Option<Value> {
    Some(match op {
        Op::Add => binary(block, Binary::Add, a, b),
        Op::Sub => binary(block, Binary::Sub, a, b),
        Op::Mul => binary(block, Binary::Mul, a, b),
        Op::Div => binary(block, Binary::Div, a, b),
        Op::Neg => {
            let sign = constant(block, SIGN);
            binary(block, Binary::Xor, a, sign)
        }
        Op::Abs => {
            let magnitude = constant(block, !SIGN);
            binary(block, Binary::And, a, magnitude)
        }
        Op::Sign => {
            let [zero, one, minus] = [0.0, 1.0, -1.0].map(|value| float(block, value));
            let above = compare(block, Compare::Less, zero, a);
            let below = compare(block, Compare::Less, a, zero);
            let above = binary(block, Binary::And, above, one);
            let below = binary(block, Binary::And, below, minus);
            binary(block, Binary::Or, above, below)
        }
        Op::Min => number(block, Binary::Min, a, b),
        Op::Max => number(block, Binary::Max, a, b),
        Op::AtMost => binary(block, Binary::Min, a, b),
        Op::AtLeast => binary(block, Binary::Max, a, b),
        Op::Floor => round(block, Rounding::Down, a),
        Op::Ceil => round(block, Rounding::Up, a),
        Op::Trunc => round(block, Rounding::Zero, a),
        Op::RoundEven => unary(block, Unary::Round(Rounding::Even), a),
        Op::Fract => {
            let floor = round(block, Rounding::Down, a);
            binary(block, Binary::Sub, a, floor)
        }
        Op::ModNear => {
            let left = modulo_rest(block, a, b, c);
            let sign = constant(block, SIGN);
            let sign = binary(block, Binary::And, c, sign);
            let along = binary(block, Binary::Xor, left, sign);
            let zero = float(block, 0.0);
            let is_below = compare(block, Compare::Less, along, zero);
            let next = binary(block, Binary::Add, left, b);
            select(block, is_below, next, left)
        }
        Op::ModPositive => {
            let left = modulo_rest(block, a, b, c);
            let next = binary(block, Binary::Add, left, b);
            binary(block, Binary::UintMin, left, next)
        }
        Op::Sqrt => unary(block, Unary::Sqrt, a),
        Op::InverseSqrt => {
            let root = unary(block, Unary::Sqrt, a);
            let one = float(block, 1.0);
            binary(block, Binary::Div, one, root)
        }
        Op::Less => compare(block, Compare::Less, a, b),
        Op::LessEqual => compare(block, Compare::LessEqual, a, b),
        Op::Equal => compare(block, Compare::Equal, a, b),
        Op::NotEqual => compare(block, Compare::NotEqual, a, b),
        Op::IAdd | Op::UAdd => binary(block, Binary::IntAdd, a, b),
        Op::ISub | Op::USub => binary(block, Binary::IntSub, a, b),
        Op::IMul | Op::UMul => binary(block, Binary::IntMul, a, b),
        Op::INeg => {
            let zero = constant(block, 0);
            binary(block, Binary::IntSub, zero, a)
        }
        Op::IAbs => {
            let zero = constant(block, 0);
            let opposite = binary(block, Binary::IntSub, zero, a);
            binary(block, Binary::IntMax, a, opposite)
        }
        Op::ISign => {
            // Truth is -1.
            let zero = constant(block, 0);
            let below = binary(block, Binary::IntGreater, zero, a);
            let above = binary(block, Binary::IntGreater, a, zero);
            binary(block, Binary::IntSub, below, above)
        }
        Op::IMin => binary(block, Binary::IntMin, a, b),
        Op::IMax => binary(block, Binary::IntMax, a, b),
        Op::ILess => binary(block, Binary::IntGreater, b, a),
        Op::ILessEqual => {
            let greater = binary(block, Binary::IntGreater, a, b);
            not(block, greater)
        }
        Op::IEqual => binary(block, Binary::IntEqual, a, b),
        Op::INotEqual => {
            let equal = binary(block, Binary::IntEqual, a, b);
            not(block, equal)
        }
        Op::IShiftRight => shift(block, Binary::ShiftRightSigned, a, b),
        Op::UMin => binary(block, Binary::UintMin, a, b),
        Op::UMax => binary(block, Binary::UintMax, a, b),
        Op::ULess => {
            let least = binary(block, Binary::UintMin, b, a);
            let not_above = binary(block, Binary::IntEqual, least, b);
            not(block, not_above)
        }
        Op::ULessEqual => {
            let least = binary(block, Binary::UintMin, a, b);
            binary(block, Binary::IntEqual, least, a)
        }
        Op::FloatBits | Op::BitsFloat | Op::IntToUint | Op::UintToInt => a,
        Op::BitAnd | Op::And => binary(block, Binary::And, a, b),
        Op::BitOr | Op::Or => binary(block, Binary::Or, a, b),
        Op::BitXor | Op::Xor => binary(block, Binary::Xor, a, b),
        Op::BitNot | Op::Not => not(block, a),
        Op::ShiftLeft => shift(block, Binary::ShiftLeft, a, b),
        Op::UShiftRight => shift(block, Binary::ShiftRight, a, b),
        Op::SelectF | Op::SelectI | Op::SelectU | Op::SelectB => select(block, a, b, c),
        Op::FloatToInt => {
            let [low, high] = [-2_147_483_648.0, 2_147_483_520.0].map(|value| float(block, value));
            let a = binary(block, Binary::Max, a, low);
            let a = binary(block, Binary::Min, a, high);
            unary(block, Unary::FloatToInt, a)
        }
        Op::FloatToUint => {
            let [low, high] = [0.0, 4_294_967_040.0].map(|value| float(block, value));
            let a = binary(block, Binary::Max, a, low);
            let a = binary(block, Binary::Min, a, high);
            // Through two halves of 31 bits.
            let half = float(block, 2_147_483_648.0);
            let is_high = compare(block, Compare::LessEqual, half, a);
            let above = binary(block, Binary::Sub, a, half);
            let inside = select(block, is_high, above, a);
            let bits = unary(block, Unary::FloatToInt, inside);
            let sign = constant(block, SIGN);
            let high = binary(block, Binary::And, is_high, sign);
            binary(block, Binary::Or, bits, high)
        }
        Op::IntToFloat => unary(block, Unary::IntToFloat, a),
        Op::UintToFloat => {
            // Both halves and the product are exact, so that the sum rounds once.
            let (low, by) = (constant(block, 0xffff), constant(block, 16));
            let low = binary(block, Binary::And, a, low);
            let high = binary(block, Binary::ShiftRight, a, by);
            let [low, high] = [low, high].map(|half| unary(block, Unary::IntToFloat, half));
            let scale = float(block, 65_536.0);
            let high = binary(block, Binary::Mul, high, scale);
            binary(block, Binary::Add, high, low)
        }
        Op::BoolToFloat => {
            let one = float(block, 1.0);
            binary(block, Binary::And, a, one)
        }
        Op::BoolToInt | Op::BoolToUint => {
            let one = constant(block, 1);
            binary(block, Binary::And, a, one)
        }
        // They have rare operands, or are functions of many steps.
        Op::Mod
        | Op::Norm
        | Op::InverseNorm
        | Op::Sin
        | Op::Cos
        | Op::Tan
        | Op::Asin
        | Op::Acos
        | Op::Atan
        | Op::Atan2
        | Op::Sinh
        | Op::Cosh
        | Op::Tanh
        | Op::Asinh
        | Op::Acosh
        | Op::Atanh
        | Op::Exp
        | Op::Exp2
        | Op::Log
        | Op::Log2
        | Op::Pow
        | Op::IDiv
        | Op::IRem
        | Op::UDiv
        | Op::URem => return None,
    })
}

/// The smaller or larger of two numbers; the other if one is NaN.
fn number(block: &mut Block, op: Binary, a: Value, b: Value) -> Value {
    let of_both = binary(block, op, a, b);
    let is_nan = compare(block, Compare::Unordered, b, b);
    select(block, is_nan, a, of_both)
}
