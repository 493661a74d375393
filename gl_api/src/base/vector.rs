//! Vector arithmetic on IR values, for the shader generators.

use crate::base::clamp::Clamp;
use rasterizer::ir::{Builder, Op, Ty, Value};

/// An operation component by component.
pub(crate) fn each<const N: usize>(
    b: &mut Builder,
    op: Op,
    left: [Value; N],
    right: [Value; N],
) -> [Value; N] {
    std::array::from_fn(|i| b.op(op, &[left[i], right[i]]))
}

/// A vector times a number.
pub(crate) fn scale<const N: usize>(
    b: &mut Builder,
    vector: [Value; N],
    factor: Value,
) -> [Value; N] {
    vector.map(|component| b.op(Op::Mul, &[component, factor]))
}

/// The products of the components, summed from the left.
pub(crate) fn dot<const N: usize>(b: &mut Builder, left: [Value; N], right: [Value; N]) -> Value {
    let products = each(b, Op::Mul, left, right);
    products.into_iter().reduce(|sum, product| b.op(Op::Add, &[sum, product])).expect("N > 0")
}

/// A vector of length one, and the length it had. A vector of length zero stays what it is.
pub(crate) fn unit(b: &mut Builder, vector: [Value; 3]) -> ([Value; 3], Value) {
    let length = b.op(Op::Norm, &vector);
    let least = b.float(f32::MIN_POSITIVE);
    let length = b.op(Op::Max, &[length, least]);
    (vector.map(|component| b.op(Op::Div, &[component, length])), length)
}

/// `N` uniform words that follow one another.
pub(crate) fn words<const N: usize>(b: &mut Builder, first: u32) -> [Value; N] {
    std::array::from_fn(|i| b.uniform(first + i as u32, Ty::F32))
}

/// The larger of a value and zero; NaN gives 0.
pub(crate) fn at_least_zero(b: &mut Builder, value: Value) -> Value {
    let zero = b.float(0.0);
    b.op(Op::Max, &[value, zero])
}

/// Clamped to [0, 1]; NaN gives 0.
pub(crate) fn clamp(b: &mut Builder, value: Value) -> Value {
    let value = at_least_zero(b, value);
    let one = b.float(1.0);
    b.op(Op::Min, &[value, one])
}

/// The same, where colours are clamped.
pub(crate) fn clamped(b: &mut Builder, clamps: Clamp, value: Value) -> Value {
    match clamps {
        Clamp::On => clamp(b, value),
        Clamp::Off => value,
    }
}

/// A matrix, whose words are column by column, times a vector: columns summed from the left.
pub(crate) fn transform<const N: usize>(
    b: &mut Builder,
    first: u32,
    vector: [Value; N],
) -> [Value; N] {
    let size = N as u32;
    std::array::from_fn(|row| {
        let elements = std::array::from_fn(|column| {
            b.uniform(first + size * column as u32 + row as u32, Ty::F32)
        });
        dot(b, elements, vector)
    })
}
