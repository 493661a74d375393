//! Choice of level and filter: all twelve filter pairs, base and maximum level, on random texels.

use super::lod::Footprint;
use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{Filter, Filters, LevelRange, LodState};
use crate::oracle::sample::{self, Sampler};
use crate::oracle::texture::{Level, level_count, level_size};
use crate::oracle::wrap::Wrap;
use crate::probe::{Precision, ProbeError, shader};
use crate::rng::Rng;

/// Which levels and filter a sample uses.
pub const LEVEL: Check = Check {
    name: "level",
    citation: "GL 2.1, 3.8.8 (d, d1, d2) and 3.8.9 (c)",
    what: "level and filter that λ chooses, for 6 minification × 2 magnification filters",
    unit: Unit::FullScale,
    tolerance: 8.0 / (1 << 24) as f64,
    why: "f32: half an ulp of λ below 4: 2^-23, times a difference of texels up to 1; bilinear twice and their mix: 2^-22",
    run,
};

const SIZES: [[usize; 2]; 2] = [[64, 64], [16, 64]];

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("level");
    for size in SIZES {
        let top = level_count(size) - 1;
        let image: Vec<Level> = (0..=top)
            .map(|l| {
                let [w, h] = level_size(size, l);
                Level::from_fn(w, h, |_, _| [0; 4].map(|_: u8| rng.byte()))
            })
            .collect();
        for (filters, (base, last)) in Filters::all()
            .into_iter()
            .flat_map(|f| [(0, top), (0, 3), (2, top), (1, 4)].map(|range| (f, range)))
        {
            let sampler = Sampler {
                at: Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] },
                filters,
                lod: LodState::default(),
                range: LevelRange { base, last },
            };
            let cases = cases(harness, &mut rng, &image, &sampler);
            let expect = |case: &Footprint, variant: Variant| {
                let st = case.st.map(f64::from);
                sample::sample(&image, &sampler, st, &case.derivatives(), variant)
            };
            harness.compare(tally, &(size, filters, base, last), &cases, expect, |session| {
                session.texture_2d(&image, &sampler)?;
                let precision = Precision::Exact { components: 4 };
                let program = session.program(shader::TEXTURE_2D_BIAS, precision)?;
                let inputs: Vec<_> = cases.iter().map(Footprint::inputs).collect();
                session.cells(&program, &inputs)
            })?;
        }
    }
    Ok(())
}

/// Random footprints away from where the answer jumps: λ not within a thousandth of a half, nor
/// (s, t) of a texel's edge in any level where a nearest filter reads it.
fn cases(harness: &Harness, rng: &mut Rng, image: &[Level], sampler: &Sampler) -> Vec<Footprint> {
    let size = [image[0].width, image[0].height];
    let nearest = [sampler.filters.min, sampler.filters.mag].contains(&Filter::Nearest);
    let mut cases = Vec::new();
    while cases.len() < harness.cases(512) {
        let mut case = Footprint::random(rng, size, 0.0);
        if nearest {
            // An odd multiple of 1/256 lies between the edges of every level up to 128 texels.
            case.st = case.st.map(|s| ((s * 128.0).floor() + 0.5) / 128.0);
        }
        let lambda = sample::lambda(image, sampler, &case.derivatives(), Variant::CORRECT);
        let to_half = (lambda * 2.0 - (lambda * 2.0).round()).abs() / 2.0;
        if to_half > 0.001 {
            cases.push(case);
        }
    }
    cases
}
