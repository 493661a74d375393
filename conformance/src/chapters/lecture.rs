//! The formulas of the lectures, computed by their GLSL.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::lecture::FORMULAS;
use crate::probe::ProbeError;
use crate::rng::Rng;

/// All formulas of the lectures.
pub const LECTURES: Check = Check {
    name: "lecture-formulas",
    citation: "the four lectures: map shapes, bump, bounce, checker, perspective, multitexture",
    what: "each formula that a lecture prints, as a shader, on random arguments",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 19) as f64,
    why: "f32: 2^-24 a rounding; the plane equation of 1/z over a ratio of 64 loses 6 bits of it; twice the largest error measured is less than that",
    run,
};

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    for formula in FORMULAS {
        let mut rng = Rng::named(formula.what);
        let cases: Vec<[[f32; 4]; 3]> =
            (0..harness.cases(1 << 14)).map(|_| (formula.case)(&mut rng)).collect();
        let expect = |case: &[[f32; 4]; 3], variant: Variant| {
            (formula.value)(&case.map(|v| v.map(f64::from)), variant)
        };
        let scene = format!("{} ({})", formula.what, formula.lecture);
        harness.compare(tally, &scene, &cases, expect, |session| {
            session.field(formula.glsl, 4, &cases)
        })?;
    }
    Ok(())
}
