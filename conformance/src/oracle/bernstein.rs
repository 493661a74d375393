//! Evaluators (section 5.1): Bernstein polynomials, their derivatives and grids.

use crate::mutation::{Mutation, Variant};

/// `B_i^n(u)`, equation 5.1.
pub fn basis(n: usize, i: usize, u: f64) -> f64 {
    let choose = (1..=i).fold(1.0, |c, k| c * (n + 1 - k) as f64 / k as f64);
    choose * u.powi(i as i32) * (1.0 - u).powi((n - i) as i32)
}

/// A domain, and the parameter in [0, 1] of a value.
pub fn parameter([low, high]: [f64; 2], u: f64, variant: Variant) -> f64 {
    if variant.has(Mutation::DomainIgnored) { u } else { (u - low) / (high - low) }
}

/// The curve of control points at a parameter in [0, 1].
pub fn curve(points: &[[f64; 4]], u: f64, variant: Variant) -> [f64; 4] {
    let n = points.len() - 1;
    let mut sum = [0.0; 4];
    for (i, point) in points.iter().enumerate() {
        let at = if variant.has(Mutation::ControlPointsReversed) { n - i } else { i };
        let weight = basis(n, at, u);
        sum = std::array::from_fn(|c| sum[c] + weight * point[c]);
    }
    sum
}

/// The surface of rows of control points, of which each is a curve along v.
pub fn surface(rows: &[Vec<[f64; 4]>], [u, v]: [f64; 2], variant: Variant) -> [f64; 4] {
    let (u, v) = if variant.has(Mutation::ParametersSwapped) { (v, u) } else { (u, v) };
    let along: Vec<[f64; 4]> = rows.iter().map(|row| curve(row, v, variant)).collect();
    curve(&along, u, variant)
}

/// The derivative of a curve at a parameter.
fn derivative(points: &[[f64; 4]], u: f64) -> [f64; 4] {
    let n = points.len() - 1;
    let steps: Vec<[f64; 4]> = points
        .windows(2)
        .map(|pair| std::array::from_fn(|c| n as f64 * (pair[1][c] - pair[0][c])))
        .collect();
    if steps.is_empty() { [0.0; 4] } else { curve(&steps, u, Variant::CORRECT) }
}

/// The normal of `GL_AUTO_NORMAL`: ∂p/∂u × ∂p/∂v, of unit length, of a surface of three coordinates.
pub fn normal(rows: &[Vec<[f64; 4]>], [u, v]: [f64; 2], variant: Variant) -> [f64; 3] {
    let at_v: Vec<[f64; 4]> = rows.iter().map(|row| curve(row, v, Variant::CORRECT)).collect();
    let along_v: Vec<[f64; 4]> = rows.iter().map(|row| derivative(row, v)).collect();
    let (a, b) = (derivative(&at_v, u), curve(&along_v, u, Variant::CORRECT));
    let sign = if variant.has(Mutation::CrossReversed) { -1.0 } else { 1.0 };
    let cross = [0, 1, 2].map(|i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        sign * (a[j] * b[k] - a[k] * b[j])
    });
    let length = cross.iter().map(|c| c * c).sum::<f64>().sqrt();
    cross.map(|c| c / length)
}

/// The value at a place of a grid of `count` steps.
pub fn grid([low, high]: [f64; 2], count: usize, i: usize, variant: Variant) -> f64 {
    let count = if variant.has(Mutation::GridOneLess) { count + 1 } else { count };
    low + i as f64 * (high - low) / count as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn the_basis_by_hand() {
        assert_eq!(basis(3, 1, 0.5), 0.375);
        assert!(((0..=5).map(|i| basis(5, i, 0.3)).sum::<f64>() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_parabola_and_a_plane() {
        let points = [[0.0; 4], [1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 0.0, 1.0]];
        assert_eq!(curve(&points, 0.5, TRUE)[0], 0.5);
        let plane: Vec<Vec<[f64; 4]>> =
            (0..2).map(|i| (0..2).map(|j| [i as f64, j as f64, 0.0, 1.0]).collect()).collect();
        assert_eq!(surface(&plane, [0.25, 0.75], TRUE), [0.25, 0.75, 0.0, 1.0]);
        assert_eq!(normal(&plane, [0.5, 0.5], TRUE), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn domains_and_grids() {
        assert_eq!(parameter([2.0, 6.0], 3.0, TRUE), 0.25);
        assert_eq!(grid([2.0, 6.0], 8, 3, TRUE), 3.5);
    }
}
