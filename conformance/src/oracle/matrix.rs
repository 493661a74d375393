//! 4×4 matrices in `f64`.

/// Rows of columns.
pub type Matrix = [[f64; 4]; 4];

/// The sixteen numbers that `glLoadMatrixf` takes, column by column.
pub fn from_columns(m: &[f32; 16]) -> Matrix {
    [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| f64::from(m[4 * j + i])))
}

/// `M · v`.
pub fn apply(m: &Matrix, v: [f64; 4]) -> [f64; 4] {
    m.map(|row| row.iter().zip(v).map(|(a, b)| a * b).sum())
}

/// `v · M`, a row vector, as planes are.
pub fn apply_row(v: [f64; 4], m: &Matrix) -> [f64; 4] {
    [0, 1, 2, 3].map(|j| (0..4).map(|i| v[i] * m[i][j]).sum())
}

/// The inverse, by elimination with the largest pivot; a singular matrix gives no numbers.
pub fn inverse(m: &Matrix) -> Matrix {
    let mut left = *m;
    let mut right: Matrix =
        std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    for column in 0..4 {
        let pivot = (column..4)
            .max_by(|&a, &b| left[a][column].abs().total_cmp(&left[b][column].abs()))
            .unwrap_or(column);
        left.swap(column, pivot);
        right.swap(column, pivot);
        let scale = 1.0 / left[column][column];
        left[column] = left[column].map(|c| c * scale);
        right[column] = right[column].map(|c| c * scale);
        for row in (0..4).filter(|&row| row != column) {
            let factor = left[row][column];
            for k in 0..4 {
                left[row][k] -= factor * left[column][k];
                right[row][k] -= factor * right[column][k];
            }
        }
    }
    right
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_and_back() {
        let m = [
            [2.0, 1.0, 0.0, 3.0],
            [0.0, 0.0, 1.0, 1.0],
            [1.0, 4.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ];
        let v = [1.0, -2.0, 3.0, 1.0];
        let back = apply(&inverse(&m), apply(&m, v));
        assert!(back.iter().zip(v).all(|(a, b)| (a - b).abs() < 1e-12), "{back:?}");
        assert_eq!(apply_row([0.0, 1.0, 0.0, 0.0], &m), [0.0, 0.0, 1.0, 1.0]);
    }
}
