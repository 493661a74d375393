//! Depth textures: the comparison of the texel with the third coordinate.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::compare::Compare;
use crate::oracle::lod::Filter;
use crate::probe::{DepthTexture, Precision, ProbeError, shader};
use crate::rng::Rng;

/// The eight comparison functions.
pub const COMPARE: Check = Check {
    name: "shadow-compare",
    citation: "GL 2.1, 3.8.14: r OP D",
    what: "the 8 comparisons of GL_COMPARE_R_TO_TEXTURE, below, above and at the texel",
    unit: Unit::Bytes,
    tolerance: 0.0,
    why: "the answer is 0 or 1",
    run,
};

/// Texel and reference, at texel `column` of the image.
#[derive(Clone, Copy, Debug)]
struct Case {
    column: usize,
    depth: u16,
    reference: f32,
}

const WIDTH: usize = 256;

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("shadow");
    let depths: Vec<u16> = (0..WIDTH)
        .map(|i| match i % 4 {
            0 => 0,
            1 => u16::MAX,
            _ => rng.integer(1, i64::from(u16::MAX) - 1) as u16,
        })
        .collect();
    let cases: Vec<Case> = (0..harness.cases(WIDTH * 4))
        .map(|i| {
            let (column, depth) = (i % WIDTH, depths[i % WIDTH]);
            Case { column, depth, reference: reference(&mut rng, depth) }
        })
        .collect();
    for compare in Compare::ALL {
        let expect = |case: &Case, variant: Variant| {
            let texel = f64::from(case.depth) / f64::from(u16::MAX);
            let holds = compare.holds(f64::from(case.reference), texel, variant);
            [f64::from(u8::from(holds)), 0.0, 0.0, 0.0]
        };
        harness.compare(tally, &compare, &cases, expect, |session| {
            let filter = Filter::Nearest;
            session.depth_texture(&DepthTexture { compare, filter, row: &depths })?;
            let program = session.program(shader::SHADOW_2D, Precision::Bytes)?;
            let inputs: Vec<_> = cases
                .iter()
                .map(|case| {
                    let s = (case.column as f32 + 0.5) / WIDTH as f32;
                    [[s, 0.5, case.reference, 1.0], [0.0; 4], [0.0; 4]]
                })
                .collect();
            let answers = session.cells(&program, &inputs)?;
            Ok(answers.iter().map(|c| [c[0], 0.0, 0.0, 0.0]).collect())
        })?;
    }
    Ok(())
}

/// A reference on either side of the texel by at least half a step of 16 bits. Equality is tried
/// where it is exact in binary: at 0 and 1.
fn reference(rng: &mut Rng, depth: u16) -> f32 {
    let at = f64::from(depth);
    let steps = match (depth, rng.integer(0, 2)) {
        (0 | u16::MAX, 0) => at,
        (0, _) => f64::from(rng.real(0.5, 65535.0)),
        (u16::MAX, _) => f64::from(rng.real(0.0, 65534.5)),
        (_, 0) => at - 0.5,
        (_, 1) => at + 0.5,
        (_, _) => at + if rng.integer(0, 1) == 0 { -0.75 } else { 0.75 },
    };
    (steps / f64::from(u16::MAX)) as f32
}
