//! The depth test of fragments.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::compare::Compare;
use crate::probe::ProbeError;
use crate::rng::Rng;

/// The eight comparison functions.
pub const TEST: Check = Check {
    name: "depth-test",
    citation: "GL 2.1, 4.1.6",
    what: "the 8 functions of glDepthFunc, nearer, farther and equal",
    unit: Unit::Bytes,
    tolerance: 0.0,
    why: "a fragment is drawn or not",
    run,
};

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("depth-test");
    // Normalized device depths with 8 bits: distinct in any depth buffer.
    let cases: Vec<[f32; 2]> = (0..harness.cases(1024))
        .map(|_| {
            let stored = rng.dyadic(-1.0, 1.0, 1.0 / 128.0);
            let other = rng.dyadic(-1.0, 1.0, 1.0 / 128.0);
            [if rng.integer(0, 2) == 0 { stored } else { other }, stored]
        })
        .collect();
    for compare in Compare::ALL {
        let expect = |&[incoming, stored]: &[f32; 2], variant: Variant| {
            let drawn = compare.holds(f64::from(incoming), f64::from(stored), variant);
            [f64::from(u8::from(drawn)), 0.0, 0.0, 0.0]
        };
        harness.compare(tally, &compare, &cases, expect, |session| {
            session.depth_tested(compare, &cases)
        })?;
    }
    Ok(())
}
