//! GLSL: functions of matrices (GLSL 1.20, sections 5.10 and 8.5).

use super::matrix::Matrix;
use crate::mutation::{Mutation, Variant};

impl MatrixFunction {
    /// Products.
    pub const PRODUCTS: &[Self] =
        &[Self::TimesVector, Self::VectorTimes, Self::TimesMatrix, Self::Tall, Self::CompMult];

    /// Transposes.
    pub const TRANSPOSES: &[Self] = &[Self::Transpose, Self::OuterProduct];

    /// Determinants.
    pub const DETERMINANTS: &[Self] =
        &[Self::Determinant(2), Self::Determinant(3), Self::Determinant(4)];

    /// Inverses.
    pub const INVERSES: &[Self] = &[Self::Inverse(2), Self::Inverse(3), Self::Inverse(4)];

    /// How many columns the result has.
    pub fn columns(self) -> usize {
        match self {
            Self::TimesVector | Self::VectorTimes | Self::Determinant(_) => 1,
            Self::TimesMatrix | Self::CompMult | Self::Transpose | Self::OuterProduct => 4,
            Self::Tall => 2,
            Self::Inverse(n) => n,
        }
    }

    /// Statements that return a column of the result of `a`, `b` and the matrix `m` of them.
    pub fn glsl(self, column: usize) -> String {
        match self {
            Self::TimesVector => "return m * a;".to_owned(),
            Self::VectorTimes => "return a * m;".to_owned(),
            Self::TimesMatrix => format!("return (m * m)[{column}];"),
            Self::Tall => format!(
                "mat2x4 tall = mat2x4(a, b); mat4x2 wide = mat4x2(b, a);
                return vec4((tall * wide)[{column}].xy, (wide * tall)[{column}]);"
            ),
            Self::CompMult => format!("return matrixCompMult(m, mat4(b, a, b, a))[{column}];"),
            Self::Transpose => format!("return transpose(m)[{column}];"),
            Self::OuterProduct => format!("return outerProduct(a, b)[{column}];"),
            Self::Determinant(n) => format!("return vec4(determinant(mat{n}(m)), 0.0, 0.0, 0.0);"),
            Self::Inverse(n) => format!(
                "vec{n} c = inverse(mat{n}(m))[{column}];
                vec4 result = vec4(0.0);
                for (int i = 0; i < {n}; i++) result[i] = c[i];
                return result;"
            ),
        }
    }

    /// The expected column.
    pub fn column(self, column: usize, a: [f64; 4], b: [f64; 4], variant: Variant) -> [f64; 4] {
        let m = matrix(a, b);
        let rows = variant.has(Mutation::RowsForColumns);
        // Element of row i, column j.
        let at = |i: usize, j: usize| if rows { m[j][i] } else { m[i][j] };
        let each = |of: &dyn Fn(usize) -> f64| [of(0), of(1), of(2), of(3)];
        match self {
            Self::TimesVector => each(&|i| (0..4).map(|k| at(i, k) * a[k]).sum()),
            Self::VectorTimes => each(&|j| (0..4).map(|k| a[k] * at(k, j)).sum()),
            Self::TimesMatrix => each(&|i| (0..4).map(|k| m[i][k] * m[k][column]).sum()),
            Self::Tall => {
                // 4×4 of columns a, b and rows (b0 b2 a0 a2), (b1 b3 a1 a3); and 2×2 the other way round.
                let wide = [[b[0], b[2], a[0], a[2]], [b[1], b[3], a[1], a[3]]];
                let first = |i: usize| a[i] * wide[0][column] + b[i] * wide[1][column];
                let tall = if column == 0 { a } else { b };
                let second = |i: usize| (0..4).map(|k| wide[i][k] * tall[k]).sum::<f64>();
                [first(0), first(1), second(0), second(1)]
            }
            Self::CompMult => {
                each(&|i| m[i][column] * if column.is_multiple_of(2) { b[i] } else { a[i] })
            }
            Self::Transpose => each(&|i| if rows { m[i][column] } else { m[column][i] }),
            Self::OuterProduct => each(&|i| if rows { b[i] * a[column] } else { a[i] * b[column] }),
            Self::Determinant(n) => {
                let sign = if variant.has(Mutation::CofactorSignsIgnored) { 1.0 } else { -1.0 };
                [determinant(&m, n, sign), 0.0, 0.0, 0.0]
            }
            Self::Inverse(n) => {
                let of = inverse(&m, n);
                each(&|i| {
                    if i >= n {
                        0.0
                    } else if variant.has(Mutation::RowsForColumns) {
                        of[column][i]
                    } else {
                        of[i][column]
                    }
                })
            }
        }
    }

    /// Whether small errors of the arguments stay small.
    pub fn is_stable(self, a: [f64; 4], b: [f64; 4]) -> bool {
        match self {
            Self::Inverse(n) => determinant(&matrix(a, b), n, -1.0).abs() >= 1.0,
            Self::TimesVector
            | Self::VectorTimes
            | Self::TimesMatrix
            | Self::Tall
            | Self::CompMult
            | Self::Transpose
            | Self::OuterProduct
            | Self::Determinant(_) => true,
        }
    }
}

/// A function of matrices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the functions' names")]
pub enum MatrixFunction {
    TimesVector,
    VectorTimes,
    TimesMatrix,
    Tall,
    CompMult,
    Transpose,
    OuterProduct,
    Determinant(usize),
    Inverse(usize),
}

/// The matrix that the shaders make of two vectors.
fn matrix(a: [f64; 4], b: [f64; 4]) -> Matrix {
    let columns = [
        a,
        b,
        [0, 1, 2, 3].map(|i: usize| a[(i + 1) % 4] * 0.5 + b[i]),
        [0, 1, 2, 3].map(|i: usize| b[3 - i] - a[i]),
    ];
    [0, 1, 2, 3].map(|i: usize| columns.map(|column| column[i]))
}

/// By cofactors of the first row; `sign` is that of every other one.
fn determinant(m: &Matrix, n: usize, sign: f64) -> f64 {
    if n == 1 {
        return m[0][0];
    }
    (0..n)
        .map(|j| {
            let mut minor = [[0.0; 4]; 4];
            for i in 1..n {
                for (to, from) in (0..n).filter(|&k| k != j).enumerate() {
                    minor[i - 1][to] = m[i][from];
                }
            }
            let here = if j % 2 == 1 { sign } else { 1.0 };
            here * m[0][j] * determinant(&minor, n - 1, sign)
        })
        .sum()
}

/// The inverse of the upper left part: the rest is that of the unit matrix.
fn inverse(m: &Matrix, n: usize) -> Matrix {
    let mut padded = super::transform::IDENTITY;
    for i in 0..n {
        padded[i][..n].copy_from_slice(&m[i][..n]);
    }
    super::matrix::inverse(&padded)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn determinants_by_hand() {
        let m = [[2.0, 0.0, 1.0, 9.0], [1.0, 3.0, 2.0, 9.0], [1.0, 1.0, 4.0, 9.0], [9.0; 4]];
        assert_eq!(determinant(&m, 2, -1.0), 6.0);
        assert_eq!(determinant(&m, 3, -1.0), 18.0);
        let i = inverse(&m, 2);
        assert_eq!([i[0][0], i[0][1], i[1][0], i[1][1]], [0.5, 0.0, -1.0 / 6.0, 1.0 / 3.0]);
    }
}
