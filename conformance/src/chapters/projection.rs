//! Projective coordinates: `texture2DProj` with q of either sign.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::filter::{self, Addressing};
use crate::oracle::lod::{Filter, Filters, LevelRange, LodState};
use crate::oracle::projection;
use crate::oracle::sample::Sampler;
use crate::oracle::texture::Level;
use crate::oracle::wrap::Wrap;
use crate::probe::{Precision, ProbeError, shader};
use crate::rng::Rng;

/// The division by q.
pub const PROJECTIVE: Check = Check {
    name: "projective",
    citation: "GL 2.1, 3.8.8: s/q, t/q; GLSL 1.20, 8.7",
    what: "texture2DProj of (s, t, r, q), q of either sign",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 17) as f64,
    why: "f32: s/q up to 8 is off by 2^-22, times 16 texels, in each of two axes: 2^-17",
    run,
};

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("projection");
    let level = Level::from_fn(16, 16, |_, _| [0; 4].map(|_: u8| rng.byte()));
    let at = Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] };
    let sampler = Sampler {
        at,
        filters: Filters::only(Filter::Linear),
        lod: LodState::default(),
        range: LevelRange { base: 0, last: 0 },
    };
    let cases: Vec<[f32; 4]> = (0..harness.cases(8192))
        .map(|_| {
            let q = rng.real(0.01, 100.0) * rng.pick(&[-1.0, 1.0]);
            let [s, t] = [0; 2].map(|_: i32| rng.real(-8.0, 8.0) * q);
            [s, t, rng.real(1.0, 2.0), q]
        })
        .collect();
    let expect = |case: &[f32; 4], variant: Variant| {
        let st = projection::divide(case.map(f64::from), variant);
        filter::linear(&level, &at, st, variant)
    };
    harness.compare(tally, &"16 × 16, GL_REPEAT", &cases, expect, |session| {
        session.texture_2d(std::slice::from_ref(&level), &sampler)?;
        let program =
            session.program(shader::TEXTURE_2D_PROJ, Precision::Exact { components: 4 })?;
        let inputs: Vec<_> = cases.iter().map(|&strq| [strq, [0.0; 4], [0.0; 4]]).collect();
        session.cells(&program, &inputs)
    })
}
