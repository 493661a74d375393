//! Per-fragment tests and operations: alpha test, stencil test, logical operations.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::{glColor4f, glVertex4f};
use crate::mutation::Variant;
use crate::oracle::compare::Compare;
use crate::oracle::fragment::{Stencil, StencilOp, logic};
use crate::probe::ProbeError;
use crate::rng::Rng;

/// The alpha test.
pub const ALPHA: Check = Check {
    name: "alpha-test",
    citation: "GL 2.1, 4.1.4: alpha OP reference",
    what: "fragments that the 8 comparisons let through, below, above and at the reference",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a fragment is drawn or not",
    run: alpha,
};

/// The stencil buffer.
pub const STENCIL: Check = Check {
    name: "stencil",
    citation: "GL 2.1, 4.1.5",
    what: "value and fragment after random comparisons, masks and operations",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers",
    run: stencil,
};

/// Logical operations.
pub const LOGIC: Check = Check {
    name: "logic-op",
    citation: "GL 2.1, 4.1.10, table 4.2",
    what: "the 16 logical operations on random bytes",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers",
    run: logic_ops,
};

fn alpha(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("alpha-test");
    for compare in Compare::ALL {
        let reference = rng.dyadic(0.25, 0.75, 1.0 / 256.0);
        let cases: Vec<f32> = (0..harness.cases(256).max(48))
            .map(|i| if i % 3 == 0 { reference } else { rng.dyadic(0.0, 1.0, 1.0 / 256.0) })
            .collect();
        let expect = |&alpha: &f32, variant: Variant| {
            let holds = compare.holds(alpha.into(), reference.into(), variant);
            [f64::from(u8::from(holds)), 0.0, 0.0, 0.0]
        };
        harness.compare(tally, &(compare, reference), &cases, expect, |session| {
            session.float_target()?;
            session.alpha_test(compare, reference)?;
            let point = |k: usize| {
                glColor4f(1, 0, 0, cases[k]);
                glVertex4f(0, 0, 0, 1);
            };
            let drawn = session.points(cases.len(), point)?;
            Ok(drawn.into_iter().map(|[red, ..]| [red, 0.0, 0.0, 0.0]).collect())
        })?;
    }
    Ok(())
}

fn stencil(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("stencil");
    let cases: Vec<Stencil> = (0..harness.cases(1024))
        .map(|_| {
            // Values near each other and at the ends, so that every operation shows.
            let mut value = || rng.pick(&[0, 1, 2, 3, 127, 128, 254, 255]);
            let (reference, stored) = (value(), value());
            Stencil {
                compare: rng.pick(&Compare::ALL),
                reference,
                mask: rng.pick(&[0xff, 0xff, 0x0f, 0x81]),
                operations: [0; 3].map(|_: i32| rng.pick(&StencilOp::ALL)),
                write_mask: rng.pick(&[0xff, 0xff, 0xff, 0x3c]),
                stored,
                depth_passes: rng.integer(0, 1) == 1,
            }
        })
        .collect();
    let expect = |case: &Stencil, variant: Variant| {
        let (value, drawn) = case.apply(variant);
        [value.into(), f64::from(u8::from(drawn)), 0.0, 0.0]
    };
    harness.compare(tally, &"8 bits", &cases, expect, |session| {
        session.stencil_buffer()?;
        cases.iter().map(|case| session.stenciled(case)).collect()
    })
}

fn logic_ops(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("logic-op");
    for operation in 0..16 {
        let cases: Vec<[[u8; 4]; 2]> = (0..harness.cases(64))
            .map(|_| [0; 2].map(|_: i32| [0; 4].map(|_: i32| rng.byte())))
            .collect();
        let expect = |[source, destination]: &[[u8; 4]; 2], variant: Variant| {
            std::array::from_fn(|c| logic(operation, source[c], destination[c], variant).into())
        };
        harness.compare(tally, &operation, &cases, expect, |session| {
            session.logic_op(operation, &cases)
        })?;
    }
    Ok(())
}
