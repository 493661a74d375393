//! Matrix functions (GLSL 1.40 section 8.5).

use super::Args;
use crate::emit::Emit;
use crate::types::Type;
use rasterizer::ir::{Op, Value};

/// A square matrix, by columns.
struct Square<'a> {
    values: &'a [Value],
    side: usize,
}

impl Square<'_> {
    /// The determinant of the submatrix of these columns and rows, expanded along its first
    /// column.
    fn determinant(&self, emit: &mut Emit, columns: &[usize], rows: &[usize]) -> Value {
        let [column, columns @ ..] = columns else { return emit.float(1.0) };
        let mut sum = None;
        for (number, row) in rows.iter().enumerate() {
            let factor = self.values[column * self.side + row];
            let product = match columns {
                [] => factor,
                _ => {
                    let minor = self.determinant(emit, columns, &without(rows, *row));
                    emit.op(Op::Mul, &[factor, minor])
                }
            };
            sum = Some(match sum {
                None => product,
                Some(sum) if number % 2 == 1 => emit.op(Op::Sub, &[sum, product]),
                Some(sum) => emit.op(Op::Add, &[sum, product]),
            });
        }
        sum.unwrap_or_else(|| emit.float(1.0))
    }
}

/// The numbers without `one`.
fn without(numbers: &[usize], one: usize) -> Vec<usize> {
    numbers.iter().copied().filter(|number| *number != one).collect()
}

/// The determinant, expanded along the first column.
pub fn determinant(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let values = &args.values[0];
    let side = values.len().isqrt();
    let all: Vec<usize> = (0..side).collect();
    vec![Square { values, side }.determinant(emit, &all, &all)]
}

/// The inverse, by Cramer's rule: the matrix of cofactors, transposed, over the determinant. A
/// singular matrix gives the results of the divisions by 0.
pub fn inverse(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let values = &args.values[0];
    let side = values.len().isqrt();
    let (matrix, all) = (Square { values, side }, (0..side).collect::<Vec<_>>());
    let determinant = matrix.determinant(emit, &all, &all);
    let mut inverse = Vec::new();
    for column in 0..side {
        for row in 0..side {
            let cofactor = matrix.determinant(emit, &without(&all, row), &without(&all, column));
            let quotient = emit.op(Op::Div, &[cofactor, determinant]);
            let is_negative = (row + column) % 2 == 1;
            inverse.push(if is_negative { emit.op(Op::Neg, &[quotient]) } else { quotient });
        }
    }
    inverse
}

/// Column vector times row vector.
pub fn outer_product(emit: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let mut all = Vec::new();
    for &row in &args.values[1] {
        for &column in &args.values[0] {
            all.push(emit.op(Op::Mul, &[column, row]));
        }
    }
    all
}

/// The transposed matrix.
pub fn transpose(_: &mut Emit, args: Args<'_>) -> Vec<Value> {
    let Type::Matrix(columns, rows) = args.types[0] else { return args.values[0].clone() };
    let (columns, rows) = (usize::from(columns), usize::from(rows));
    let at = |index: usize| args.values[0][(index % columns) * rows + index / columns];
    (0..columns * rows).map(at).collect()
}
