//! The two filters within one level, on random texels.

use crate::check::{Check, Harness, Tally, Unit};
use crate::oracle::filter::{self, Addressing};
use crate::oracle::lod::{Filter, Filters, LevelRange, LodState};
use crate::oracle::sample::Sampler;
use crate::oracle::texture::Level;
use crate::oracle::wrap::Wrap;
use crate::probe::{Precision, ProbeError, shader};
use crate::rng::Rng;

/// `GL_NEAREST`.
pub const NEAREST: Check = Check {
    name: "nearest",
    citation: "GL 2.1, 3.8.8: i = floor(u), j = floor(v)",
    what: "texel that GL_NEAREST reads",
    unit: Unit::Bytes,
    tolerance: 0.0,
    why: "texels are bytes and come back as they are",
    run: |harness, tally| run(harness, tally, Filter::Nearest),
};

/// `GL_LINEAR`.
pub const BILINEAR: Check = Check {
    name: "bilinear",
    citation: "GL 2.1, 3.8.8: (1-α)(1-β)τ00 + α(1-β)τ10 + (1-α)βτ01 + αβτ11",
    what: "weights and texels of GL_LINEAR",
    unit: Unit::FullScale,
    tolerance: 40.0 / (1 << 24) as f64,
    why: "f32: u up to 64 carries 2^-19 of a texel: 32 · 2^-24 in the axis that is worse, times a difference of texels up to 1",
    run: |harness, tally| run(harness, tally, Filter::Linear),
};

const SIZES: [[usize; 2]; 6] = [[64, 64], [16, 2], [1, 8], [4, 4], [7, 13], [33, 20]];

fn run(harness: &Harness, tally: &mut Tally, filter: Filter) -> Result<(), ProbeError> {
    let mut rng = Rng::named("filter");
    for size in SIZES {
        let level = Level::from_fn(size[0], size[1], |_, _| [0; 4].map(|_: u8| rng.byte()));
        let at = Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] };
        let sampler = Sampler {
            at,
            filters: Filters::only(filter),
            lod: LodState::default(),
            range: LevelRange { base: 0, last: 0 },
        };
        let cases: Vec<[f32; 2]> = (0..harness.cases(4096))
            .map(|_| size.map(|n| coordinate(&mut rng, n, filter)))
            .collect();
        let precision = match filter {
            Filter::Nearest => Precision::Bytes,
            Filter::Linear => Precision::Exact { components: 4 },
        };
        harness.compare(
            tally,
            &size,
            &cases,
            |st, variant| {
                let st = st.map(f64::from);
                match filter {
                    Filter::Nearest => filter::nearest(&level, &at, st, variant),
                    Filter::Linear => filter::linear(&level, &at, st, variant),
                }
            },
            |session| {
                session.texture_2d(std::slice::from_ref(&level), &sampler)?;
                let program = session.program(shader::TEXTURE_2D, precision)?;
                let inputs: Vec<_> =
                    cases.iter().map(|&[s, t]| [[s, t, 0.0, 1.0], [0.0; 4], [0.0; 4]]).collect();
                session.cells(&program, &inputs)
            },
        )?;
    }
    Ok(())
}

/// For `GL_NEAREST`, not within a thousandth of a texel of an edge, where rounding may choose
/// either texel.
fn coordinate(rng: &mut Rng, size: usize, filter: Filter) -> f32 {
    loop {
        let s = rng.real(0.0, 1.0);
        let fraction = (f64::from(s) * size as f64).fract();
        if filter == Filter::Linear || (0.001..0.999).contains(&fraction) {
            return s;
        }
    }
}
