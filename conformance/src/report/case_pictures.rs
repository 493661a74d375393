//! The cases of a check as pictures, one case a pixel.

use crate::check::{Outcome, Unit};
use crate::tradeoff::Picture;

/// Fewer cases than this make no picture.
const FEWEST: usize = 256;
/// The longest side of a picture.
const LARGEST: usize = 128;

/// Measured and expected values, if they are colours, and the error, which is white at the tolerance.
pub fn pictures(outcome: &Outcome) -> Vec<Picture> {
    let compared = &outcome.compared;
    if compared.errors.len() < FEWEST {
        return Vec::new();
    }
    let side = compared.errors.len().isqrt().min(LARGEST);
    let picture = |of: &str, pixels: Vec<[f64; 4]>| Picture {
        name: format!("check-{}-{of}", outcome.name),
        pixels,
        side,
    };
    let values = |which: usize| -> Vec<[f64; 4]> {
        compared.values.iter().take(side * side).map(|pair| visible(pair[which])).collect()
    };
    let error = |&error: &f64| match (error, outcome.tolerance) {
        (0.0, _) => [0.0; 4],
        (_, 0.0) => [1.0; 4],
        (error, tolerance) => [(error / tolerance).min(1.0); 4],
    };
    let mut pictures = Vec::new();
    match outcome.unit {
        Unit::FullScale | Unit::Bytes | Unit::Draws => {
            pictures.push(picture("driver", values(1)));
            pictures.push(picture("formula", values(0)));
        }
        Unit::Texels | Unit::Levels | Unit::Ulp | Unit::Codes => {}
    }
    let errors = compared.errors.iter().take(side * side).map(error).collect();
    pictures.push(picture("error", errors));
    pictures
}

/// A value as a colour; one component alone is grey.
fn visible(value: [f64; 4]) -> [f64; 4] {
    let [first, rest @ ..] = value;
    if rest[..2] == [0.0; 2] { [first, first, first, 1.0] } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::{ComparedCases, Verdict};

    #[test]
    fn the_tolerance_is_white() {
        let errors = (0..256).map(|case| f64::from(case) / 128.0).collect();
        let compared = ComparedCases { values: vec![[[0.5, 0.0, 0.0, 0.0]; 2]; 256], errors };
        let outcome = Outcome {
            reached: Vec::new(),
            name: "test",
            citation: "",
            what: "",
            cases: 256,
            largest_error: 2.0,
            unit: Unit::Bytes,
            tolerance: 1.0,
            why: "",
            worst: String::new(),
            digest: String::new(),
            seconds: 0.0,
            verdict: Verdict::Fail,
            compared,
        };
        let [driver, _, error] = &pictures(&outcome)[..] else { panic!("three pictures") };
        assert_eq!(driver.pixels[0], [0.5, 0.5, 0.5, 1.0]);
        assert_eq!([0, 64, 128, 255].map(|at| error.pixels[at][0]), [0.0, 0.5, 1.0, 1.0]);
    }
}
