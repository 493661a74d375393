//! Matrix stacks with a large condition number.

use super::definition::Sweep;
use super::series::{Compared, Series};
use crate::probe::{MatrixStep, ProbeError, Session};

/// A product of transformations and their inverses.
pub const CONDITION: Sweep = Sweep {
    name: "matrix-condition",
    what: "product of a scale by (√k, 1/√k, 1), a rotation, and their inverses: its largest \
           difference from the identity, over k·2^-24",
    parameter: "k, the condition number",
    unit: "of k·2^-24",
    bound: 0.8,
    why: "each product is rounded to f32, and the way back magnifies that k times; a few products",
    breaks: "from 1.7e7 on the way back magnifies rounding to more than the identity itself: the \
             error is k·2^-24 still, and a matrix that is inverted by GL is no better",
    kept: 1.0,
    distinct: 0.9,
    before: &[],
    run: condition,
};

fn condition() -> Result<Vec<Series>, ProbeError> {
    let conditions = (0..=24).map(|step| 10f64.powf(f64::from(step) / 2.0));
    let line = Series::measured("largest error", conditions, |k| {
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
        let mut compared = Compared::new();
        for (i, m) in matrix.into_iter().enumerate() {
            let (m, one) = (f64::from(m), if i % 5 == 0 { 1.0 } else { 0.0 });
            compared.add((m - one).abs() / (k * 2f64.powi(-24)), &[m]);
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}
