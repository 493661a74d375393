//! Blending: equations and factors, over destinations of every colour.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::blend::{self, Colors, Equation, Factor};
use crate::probe::{BlendState, BlendedCell, ProbeError};
use crate::rng::Rng;

/// The arithmetic of `glBlendEquation` and `glBlendFunc`.
pub const BLEND: Check = Check {
    name: "blend",
    citation: "GL 2.1, 4.1.8",
    what: "5 equations × 15 source × 14 destination factors",
    unit: Unit::Bytes,
    tolerance: 0.5 + 1.0 / (1 << 14) as f64,
    why: "the framebuffer holds 8-bit colours: half a step; f32: two products and a sum up to 2 are rounded by 2^-24 each, which is 2^-14 of 255",
    run,
};

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("blend");
    for round in 0..harness.cases(512) {
        let state = BlendState {
            // Every source factor meets every equation within 75 rounds.
            equation: Equation::ALL[(round + round / 15) % 5],
            factors: [Factor::ALL[round % 15], rng.pick(&Factor::ALL[..14])],
            constant: [0; 4].map(|_: i32| rng.dyadic(0.0, 1.0, 1.0 / 64.0)),
        };
        let cases: Vec<BlendedCell> = (0..64)
            .map(|_| BlendedCell {
                destination: [0; 4].map(|_: i32| rng.byte()),
                source: [0; 4].map(|_: i32| rng.real(0.0, 1.0)),
            })
            .collect();
        let expect = |case: &BlendedCell, variant: Variant| {
            let colors = Colors {
                source: case.source.map(f64::from),
                destination: case.destination.map(|c| f64::from(c) / 255.0),
                constant: state.constant.map(f64::from),
            };
            blend::blend(state.equation, state.factors, &colors, variant)
        };
        harness
            .compare(tally, &state, &cases, expect, |session| session.blended(&state, &cases))?;
    }
    Ok(())
}
