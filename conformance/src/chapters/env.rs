//! The five texture environments, with every base format that they are defined for.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::env::{self, Base, Inputs, Mode};
use crate::probe::{FixedCell, ProbeError};
use crate::rng::Rng;

/// `GL_TEXTURE_ENV_MODE`.
pub const ENVIRONMENT: Check = Check {
    name: "env",
    citation: "GL 2.1, 3.8.13: texture functions",
    what: "GL_REPLACE, GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD × 6 base formats",
    unit: Unit::Bytes,
    tolerance: 0.5 + 1.0 / (1 << 14) as f64,
    why: "the fixed function writes 8-bit colours: half a step; f32: up to four roundings of values below 2 by 2^-24 each, which is 2^-14 of 255",
    run,
};

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("env");
    for mode in Mode::ALL {
        for base in Base::ALL.into_iter().filter(|&base| mode.defined_for(base)) {
            let constant = [0; 4].map(|_: i32| rng.dyadic(0.0, 1.0, 1.0 / 64.0));
            let cases: Vec<FixedCell> = (0..harness.cases(1024))
                .map(|_| FixedCell {
                    color: [0; 4].map(|_: i32| rng.real(0.0, 1.0)),
                    texel: [0; 4].map(|_: i32| rng.byte()),
                })
                .collect();
            let expect = |case: &FixedCell, variant: Variant| {
                let inputs = Inputs {
                    previous: case.color.map(f64::from),
                    texel: case.texel.map(|c| f64::from(c) / 255.0),
                    constant: constant.map(f64::from),
                };
                env::apply(mode, base, &inputs, variant)
            };
            harness.compare(tally, &(mode, base, constant), &cases, expect, |session| {
                session.fixed_cells(mode, base, constant, &cases)
            })?;
        }
    }
    Ok(())
}
