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
    why: "f32: in z2 + t(z1 - z2) a product of up to 64 is rounded by 2^-19, and the sum is at least 1; all other formulas have smaller numbers",
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
