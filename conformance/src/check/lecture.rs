//! The lectures' formulas, run as their GLSL.

use super::Check;
use super::bench::{Bench, Tally};
use super::outcome::Unit;
use crate::drive::DriveError;
use crate::mutation::Variant;
use crate::oracle::lecture::FORMULAS;
use crate::rng::Rng;

/// All of them.
pub const LECTURES: Check = Check {
    name: "lecture-formulas",
    citation: "the four lectures: map shapes, bump, bounce, checker, perspective, multitexture",
    what: "each formula that a lecture prints, as a shader, on random arguments",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 18) as f64,
    why: "f32: 2^-24 a rounding; the plane equation of 1/z over a ratio of 64 loses 6 bits of it",
    run,
};

fn run(bench: &Bench, tally: &mut Tally) -> Result<(), DriveError> {
    for formula in FORMULAS {
        let mut rng = Rng::named(formula.what);
        let cases: Vec<[[f32; 4]; 3]> =
            (0..bench.cases(1 << 14)).map(|_| (formula.case)(&mut rng)).collect();
        let expect = |case: &[[f32; 4]; 3], variant: Variant| {
            (formula.value)(&case.map(|v| v.map(f64::from)), variant)
        };
        let scene = format!("{} ({})", formula.what, formula.lecture);
        bench.compare(tally, &scene, &cases, expect, |session| {
            session.field(formula.glsl, 4, &cases)
        })?;
    }
    Ok(())
}
