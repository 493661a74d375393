//! The anisotropic filter against its formula.

use super::lod::Footprint;
use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::anisotropy;
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{Filter, Filters, LevelRange, LodState, Mipmap};
use crate::oracle::sample::Sampler;
use crate::oracle::texture::{Level, level_count, level_size};
use crate::oracle::wrap::Wrap;
use crate::probe::{Precision, ProbeError, shader};
use crate::rng::Rng;

/// `GL_TEXTURE_MAX_ANISOTROPY_EXT`.
pub const ANISOTROPY: Check = Check {
    name: "anisotropy",
    citation: "EXT_texture_filter_anisotropic (scheme: DetGL's, oracle/anisotropy.rs)",
    what: "rows, slope, weights and λ of random footprints under limits 2 to 16",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 13) as f64,
    why: "weights of 2^-14, places of rows of 2^-16 texels, times a difference of texels up to 1",
    run,
};

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("anisotropy");
    let size = [128, 64];
    let top = level_count(size) - 1;
    let image: Vec<Level> = (0..=top)
        .map(|l| {
            let [w, h] = level_size(size, l);
            Level::from_fn(w, h, |_, _| [0; 4].map(|_: u8| rng.byte()))
        })
        .collect();
    let sampler = Sampler {
        at: Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] },
        filters: Filters { min: Filter::Linear, mipmap: Mipmap::Linear, mag: Filter::Linear },
        lod: LodState::default(),
        range: LevelRange { base: 0, last: top },
    };
    for limit in [2.0, 4.0, 8.0, 16.0f32] {
        let mut cases = Vec::new();
        while cases.len() < harness.cases(1024) {
            let case = footprint(&mut rng, size);
            let (d, limit) = (case.derivatives(), f64::from(limit));
            let footprint = anisotropy::footprint(&d, size, limit, Variant::CORRECT);
            // Without footprints so flat that `σ₂` is mostly rounding error, and without samples
            // where rounding may choose either of two texels.
            let st = case.st.map(f64::from);
            let step = anisotropy::nearest_step(&image, &sampler, st, &footprint);
            if footprint.ratio < 24.0 && step > 1e-3 {
                cases.push(case);
            }
        }
        let expect = |case: &Footprint, variant: Variant| {
            let (d, limit) = (case.derivatives(), f64::from(limit));
            let footprint = anisotropy::footprint(&d, size, limit, variant);
            anisotropy::sample(&image, &sampler, case.st.map(f64::from), &footprint, variant)
        };
        harness.compare(tally, &limit, &cases, expect, |session| {
            session.texture_2d(&image, &sampler)?;
            session.anisotropy(limit)?;
            let precision = Precision::Exact { components: 4 };
            let program = session.program(shader::TEXTURE_2D_BIAS, precision)?;
            let inputs: Vec<_> = cases.iter().map(Footprint::inputs).collect();
            session.cells(&program, &inputs)
        })?;
    }
    Ok(())
}

/// A stretched footprint: one derivative of up to 32 texels, another of up to 4, at any angle, in
/// multiples of 1/64 texel.
fn footprint(rng: &mut Rng, size: [usize; 2]) -> Footprint {
    let mut derivative = |reach: f64| {
        size.map(|n| (f64::from(rng.dyadic(-reach, reach, 1.0 / 64.0)) / n as f64) as f32)
    };
    let (dx, dy) = (derivative(32.0), derivative(4.0));
    let (dx, dy) = if rng.integer(0, 1) == 0 { (dx, dy) } else { (dy, dx) };
    Footprint { st: [0; 2].map(|_: i32| rng.dyadic(0.0, 1.0, 1.0 / 256.0)), dx, dy, bias: 0.0 }
}
