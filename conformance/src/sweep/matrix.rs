//! Matrix stacks with a large condition number.

use super::definition::{Sweep, decades};
use crate::plot::Line;
use crate::probe::{MatrixStep, ProbeError, Session};

/// A product of transformations and their inverses.
pub const CONDITION: Sweep = Sweep {
    name: "matrix-condition",
    what: "product of a scale by (√k, 1/√k, 1), a rotation, and their inverses: its largest \
           difference from the identity, over k·2^-24",
    parameter: "k, the condition number",
    unit: "of k·2^-24",
    bound: 2.0,
    why: "each product is rounded to f32, and the way back magnifies that k times; a few products",
    before: &[],
    run: condition,
};

fn condition() -> Result<Vec<Line>, ProbeError> {
    let line = decades("largest error", 0..=12, |k| {
        let session = Session::open()?;
        let axis = [0.3, -0.5, 0.8];
        let root = k.sqrt();
        let steps = [
            MatrixStep::Scale([root, 1.0 / root, 1.0]),
            MatrixStep::Rotate(37.0, axis),
            MatrixStep::Rotate(-37.0, axis),
            MatrixStep::Scale([1.0 / root, root, 1.0]),
        ];
        let matrix = session.model_view(&steps)?;
        let errors = matrix.iter().enumerate().map(|(i, m)| {
            let one = if i % 5 == 0 { 1.0 } else { 0.0 };
            (f64::from(*m) - one).abs()
        });
        Ok(errors.fold(0.0, f64::max) / (k * 2f64.powi(-24)))
    })?;
    Ok(vec![line])
}
