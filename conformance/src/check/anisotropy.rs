//! The anisotropic filter against its formula.

use super::Check;
use super::bench::{Bench, Tally};
use super::lod::Footprint;
use super::outcome::Unit;
use crate::drive::{DriveError, Precision, shader};
use crate::mutation::Variant;
use crate::oracle::anisotropy;
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{Filter, Filters, LevelRange, LodState, Mipmap};
use crate::oracle::sample::Sampler;
use crate::oracle::texture::{Level, level_count, level_size};
use crate::oracle::wrap::Wrap;
use crate::rng::Rng;

/// `GL_TEXTURE_MAX_ANISOTROPY_EXT`.
pub const ANISOTROPY: Check = Check {
    name: "anisotropy",
    citation: "EXT_texture_filter_anisotropic (scheme: DetGL's, oracle/anisotropy.rs)",
    what: "number, place, λ and mean of the probes of random footprints under limits 2 to 16",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 16) as f64,
    why: "f32: λ and the place of each probe to 2^-18, times a difference of texels up to 1",
    run,
};

fn run(bench: &Bench, tally: &mut Tally) -> Result<(), DriveError> {
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
        while cases.len() < bench.cases(1024) {
            let case = footprint(&mut rng, size);
            let ratio = anisotropy::probes(&case.derivatives(), size, 16.0, Variant::TRUE).ratio;
            // Not where rounding may choose one probe more or fewer, nor so flat that `σ₂` is
            // what the roundings left of it.
            let jump = (ratio - 1.0 / 64.0).fract();
            if (0.02..0.98).contains(&jump) && ratio > 1.05 && ratio < 24.0 {
                cases.push(case);
            }
        }
        let expect = |case: &Footprint, variant: Variant| {
            let probes = anisotropy::probes(&case.derivatives(), size, f64::from(limit), variant);
            anisotropy::sample(&image, &sampler, case.st.map(f64::from), &probes, variant)
        };
        bench.compare(tally, &limit, &cases, expect, |session| {
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

/// A stretched one: one derivative of up to 32 texels, another of up to 4, at any angle, in
/// multiples of 1/64 texel.
fn footprint(rng: &mut Rng, size: [usize; 2]) -> Footprint {
    let mut derivative = |reach: f64| {
        size.map(|n| (f64::from(rng.dyadic(-reach, reach, 1.0 / 64.0)) / n as f64) as f32)
    };
    let (dx, dy) = (derivative(32.0), derivative(4.0));
    let (dx, dy) = if rng.integer(0, 1) == 0 { (dx, dy) } else { (dy, dx) };
    Footprint { st: [0; 2].map(|_: i32| rng.dyadic(0.0, 1.0, 1.0 / 256.0)), dx, dy, bias: 0.0 }
}
