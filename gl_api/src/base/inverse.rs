//! Inverses of matrices, in `f64`.

use glam::{DMat3, DMat4, DVec4};

/// The inverse of a matrix; of one that has none (its determinant is zero, or something in it is
/// not finite), the identity, where the specification leaves the result undefined.
///
/// Where a matrix is badly conditioned, two steps of Newton's iteration with a residual of twice the
/// precision make the inverse right to the last digits of `f32` for condition numbers beyond 1e12.
pub(crate) fn inverse(matrix: DMat4) -> DMat4 {
    let determinant = matrix.determinant();
    if determinant == 0.0 || !determinant.is_finite() {
        return DMat4::IDENTITY;
    }
    let plain = matrix.inverse();
    if !plain.is_finite() {
        return DMat4::IDENTITY;
    }
    if largest(&matrix) * largest(&plain) < WELL_CONDITIONED {
        return plain;
    }
    let mut refined = plain;
    for _ in 0..2 {
        refined += refined * residual(&matrix, &refined);
    }
    if refined.is_finite() { refined } else { plain }
}

/// Below this product of the largest elements of a matrix and its inverse, `f64` loses so little
/// that `f32` does not show it.
const WELL_CONDITIONED: f64 = 1e6;

/// The magnitude of the largest element.
fn largest(matrix: &DMat4) -> f64 {
    matrix.to_cols_array().into_iter().fold(0.0, |most, element| element.abs().max(most))
}

/// The upper left three rows and columns of the inverse, which normals go through (GL 2.1, section
/// 2.11.3).
pub(crate) fn inverse_3(matrix: DMat4) -> DMat3 {
    if matrix.row(3) == DVec4::W {
        // They are the inverse of the upper left three, too.
        return DMat3::from_mat4(inverse(DMat4::from_mat3(DMat3::from_mat4(matrix))));
    }
    DMat3::from_mat4(inverse(matrix))
}

/// The factor of `GL_RESCALE_NORMAL`, from what normals go through (GL 2.1, section 2.11.3).
pub(crate) fn rescale_factor(inverse: &DMat3) -> f64 {
    1.0 / inverse.row(2).length()
}

/// `1 - matrix * inverse`.
fn residual(matrix: &DMat4, inverse: &DMat4) -> DMat4 {
    let rows = matrix.transpose().to_cols_array_2d();
    let columns = inverse.to_cols_array_2d();
    let element = |row: usize, column: usize| {
        let mut sum = [if row == column { -1.0 } else { 0.0 }, 0.0];
        for (a, b) in rows[row].iter().zip(columns[column]) {
            sum = add_product(sum, *a, b);
        }
        -(sum[0] + sum[1])
    };
    DMat4::from_cols_array_2d(&std::array::from_fn(|column| {
        std::array::from_fn(|row| element(row, column))
    }))
}

/// A sum in two parts, and `a * b` exactly: Dekker's product and Knuth's sum.
fn add_product([high, low]: [f64; 2], a: f64, b: f64) -> [f64; 2] {
    let split = |x: f64| {
        let scaled = x * 134_217_729.0;
        let top = scaled - (scaled - x);
        [top, x - top]
    };
    let product = a * b;
    let ([a1, a2], [b1, b2]) = (split(a), split(b));
    let rest = ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2;
    let sum = high + product;
    let part = sum - high;
    let lost = (high - (sum - part)) + (product - part);
    [sum, low + (lost + rest)]
}
