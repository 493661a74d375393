//! The Bernstein polynomials of evaluators (GL 2.1, equations 5.1 to 5.4), in `f64`.

use crate::state::evaluators::{EvaluatorMap, MAX_EVAL_ORDER};

/// A number for each polynomial of an order; zeros behind them.
type Weights = [f64; MAX_EVAL_ORDER];

/// The values at `t` of the polynomials of an order, of which there are as many: one number after
/// the other from the order before it.
fn bernstein(order: usize, t: f64) -> Weights {
    let mut values = [0.0; MAX_EVAL_ORDER];
    values[0] = 1.0;
    for degree in 1..order {
        let mut carried = 0.0;
        for value in &mut values[..=degree] {
            let below = *value;
            *value = below * (1.0 - t) + carried;
            carried = below * t;
        }
    }
    values
}

/// Their derivatives: `n (B(n-1, i-1) - B(n-1, i))`.
fn derivative(order: usize, t: f64) -> Weights {
    let mut values = [0.0; MAX_EVAL_ORDER];
    if order < 2 {
        return values;
    }
    let below = bernstein(order - 1, t);
    let degree = (order - 1) as f64;
    let mut before = 0.0;
    for (value, below) in values[..order].iter_mut().zip(below) {
        *value = degree * (before - below);
        before = below;
    }
    values
}

/// What a map is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wanted {
    Value,
    /// How it changes along the first parameter, or the second.
    Slope(usize),
}

/// A map at a point of its parameters; of a map with one, the second does not matter.
pub(crate) fn evaluate(map: &EvaluatorMap, at: [f64; 2], wanted: Wanted) -> [f64; 4] {
    let weights = [0, 1].map(|axis| {
        let [start, end] = map.domain[axis];
        let t = (at[axis] - start) / (end - start);
        if wanted == Wanted::Slope(axis) {
            let per = 1.0 / (end - start);
            derivative(map.order[axis], t).map(|value| value * per)
        } else {
            bernstein(map.order[axis], t)
        }
    });
    let mut sum = [0.0; 4];
    let [rows, columns] = map.order;
    for (u, row) in weights[0][..rows].iter().zip(map.points.chunks(columns * map.components)) {
        for (v, point) in weights[1].iter().zip(row.chunks_exact(map.components)) {
            let weight = u * v;
            for (sum, &component) in sum.iter_mut().zip(point) {
                *sum += weight * f64::from(component);
            }
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use crate::calls::evaluate::basis::*;

    /// `binomial(n, i) t^i (1 - t)^(n - i)`, as the specification writes it.
    fn oracle(order: usize, i: usize, t: f64) -> f64 {
        let n = order - 1;
        let mut binomial = 1.0;
        for k in 0..i {
            binomial = binomial * (n - k) as f64 / (k + 1) as f64;
        }
        binomial * t.powi(i as i32) * (1.0 - t).powi((n - i) as i32)
    }

    #[test]
    fn the_polynomials_are_bernsteins() {
        for order in 1..=30 {
            for t in [0.0, 0.125, 0.5, 0.7, 1.0] {
                for (i, value) in bernstein(order, t).into_iter().take(order).enumerate() {
                    assert!((value - oracle(order, i, t)).abs() < 1e-13, "{order} {i} {t}");
                }
                let step = 1e-6;
                for (i, slope) in derivative(order, t).into_iter().take(order).enumerate() {
                    let near =
                        (oracle(order, i, t + step) - oracle(order, i, t - step)) / (2.0 * step);
                    assert!((slope - near).abs() < 1e-5, "{order} {i} {t}: {slope} {near}");
                }
            }
        }
    }
}
