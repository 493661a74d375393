//! Matrices (section 2.11.2): inverses, and the matrices that shaders read.

use crate::{Random, assert_close, context, point, probe, probed};
use gl_api::*;
use glam::DMat4;

/// `gl_ModelViewMatrixInverse` of a matrix with condition 1e12, whose inverse is known: `A B` with
/// `A` and `B` of integers and determinant 1 has the exact inverse `B⁻¹ A⁻¹`.
#[test]
fn ill_conditioned_matrices_are_inverted_to_the_last_digits() {
    let n = 1000.0;
    // Unit triangular matrices of integers; their inverses are of integers too.
    let lower = DMat4::from_cols_array_2d(&[
        [1.0, n, 7.0, 0.0],
        [0.0, 1.0, n, 3.0],
        [0.0, 0.0, 1.0, n],
        [0.0, 0.0, 0.0, 1.0],
    ]);
    let inverse = DMat4::from_cols_array_2d(&[
        [1.0, -n, n * n - 7.0, -(n * n * n) + 7.0 * n + 3.0 * n],
        [0.0, 1.0, -n, n * n - 3.0],
        [0.0, 0.0, 1.0, -n],
        [0.0, 0.0, 0.0, 1.0],
    ]);
    assert_eq!(lower * inverse, DMat4::IDENTITY, "the test's own inverse");
    let largest = inverse.to_cols_array().into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    assert!(largest * n > 0.9e12);
    let mut c = context();
    for column in 0..4 {
        for row in 0..4 {
            let exact = inverse.to_cols_array_2d()[column][row];
            let scale = if exact == 0.0 { 1.0 } else { exact };
            // 1/2 where the element is exact.
            let value =
                format!("vec4(0.5 * gl_ModelViewMatrixInverse[{column}][{row}] / {scale:e})");
            let mask = probe(&mut c, &value);
            c.matrix_mode(GL_PROJECTION);
            c.load_identity();
            c.scalef(0.0, 0.0, 0.0);
            c.matrix_mode(GL_MODELVIEW);
            c.load_matrixd(&lower.to_cols_array());
            let found = probed(&mut c, mask, |c| {
                c.matrix_mode(GL_PROJECTION);
                c.load_matrixd(&flattened(lower).to_cols_array());
                c.matrix_mode(GL_MODELVIEW);
                point(c, 0.0);
            });
            let expected = if exact == 0.0 { 0.0 } else { 0.5 };
            assert_close(found, [expected; 4], 1.2e-7, &(column, row, exact));
        }
    }
}

/// A projection that brings the point at the origin to the middle, whatever the matrix.
fn flattened(modelview: DMat4) -> DMat4 {
    let origin = modelview.w_axis;
    DMat4::from_cols_array_2d(&[[0.0; 4], [0.0; 4], [0.0; 4], [0.0, 0.0, 0.0, 1.0 / origin.w]])
}

#[test]
fn a_matrix_without_an_inverse_counts_as_the_identity() {
    let mut c = context();
    let mask = probe(&mut c, "gl_ModelViewMatrixInverse[1] * 0.5");
    c.scalef(1.0, 0.0, 1.0);
    let found = probed(&mut c, mask, |c| point(c, 0.0));
    assert_close(found, [0.0, 0.5, 0.0, 0.0], 1e-7, &"singular");
}

#[test]
fn transposed_loads_are_transposed() {
    let mut c = context();
    let mut random = Random::new(77);
    let numbers: [f32; 16] = std::array::from_fn(|_| random.between(-1.0, 1.0) as f32);
    let transposed: [f32; 16] = std::array::from_fn(|i| numbers[i % 4 * 4 + i / 4]);
    let mut found = [0.0; 16];
    c.load_transpose_matrixf(&numbers);
    c.get_floatv(GL_MODELVIEW_MATRIX, &mut found);
    assert_eq!(found, transposed);
    c.get_floatv(GL_TRANSPOSE_MODELVIEW_MATRIX, &mut found);
    assert_eq!(found, numbers);
    c.load_identity();
    c.mult_transpose_matrixf(&numbers);
    c.get_floatv(GL_MODELVIEW_MATRIX, &mut found);
    assert_eq!(found, transposed);
}

/// Programs read a matrix between passes, load it again, and compare depths for equality.
#[test]
fn a_matrix_that_was_read_and_loaded_again_is_the_same() {
    let mut c = context();
    c.rotatef(37.0, 0.3, 0.5, 0.7);
    c.translatef(0.1, 0.2, 0.3);
    c.mult_matrixd(&std::array::from_fn::<_, 16, _>(|at| 1.0 / (at as f64 + 3.0)));
    let (mut before, mut read, mut after) = ([0.0; 16], [0.0; 16], [0.0; 16]);
    c.get_doublev(GL_MODELVIEW_MATRIX, &mut before);
    c.get_floatv(GL_MODELVIEW_MATRIX, &mut read);
    c.load_identity();
    c.load_matrixf(&read);
    c.get_doublev(GL_MODELVIEW_MATRIX, &mut after);
    assert_eq!(before, after);
}
