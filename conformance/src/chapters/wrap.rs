//! Wrap modes: all pairs of modes for s and t, on powers of two and other sizes.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::filter::{self, Addressing};
use crate::oracle::lod::{Filter, Filters, LevelRange, LodState};
use crate::oracle::sample::Sampler;
use crate::oracle::texture::Level;
use crate::oracle::wrap::Wrap;
use crate::probe::{Precision, ProbeError, shader};
use crate::rng::Rng;

/// Which texel each wrap mode reads.
pub const NEAREST: Check = Check {
    name: "wrap-nearest",
    citation: "GL 2.1, 3.8.7",
    what: "texel or border that each pair of wrap modes reads",
    unit: Unit::Bytes,
    tolerance: 0.0,
    why: "texels are bytes and come back as they are",
    run: |harness, tally| run(harness, tally, Filter::Nearest),
};

/// What a linear filter mixes at the edges.
pub const LINEAR: Check = Check {
    name: "wrap-linear",
    citation: "GL 2.1, 3.8.7 and 3.8.8",
    what: "texels and border that a linear filter mixes under each pair of wrap modes",
    unit: Unit::FullScale,
    tolerance: 12.0 / (1 << 24) as f64,
    why: "f32: u up to 64 carries 2^-19 of a texel, where coordinates are no dyadic numbers; a quarter of it of texels of bytes",
    run: |harness, tally| run(harness, tally, Filter::Linear),
};

const SIZES: [[usize; 2]; 4] = [[8, 4], [2, 16], [1, 1], [5, 3]];
const BORDER: [f64; 4] = [1.0, 0.5019607843137255, 0.2, 0.0];

/// Half of the coordinates are multiples of 2^-10, which fall on texel edges and centres of
/// power-of-two sizes exactly. The others are random but for those within a thousandth of a texel
/// of an edge, where rounding may choose either texel.
fn coordinate(rng: &mut Rng, size: usize, filter: Filter) -> f32 {
    if size.is_power_of_two() && rng.integer(0, 1) == 0 {
        return rng.dyadic(-4.0, 4.0, 1.0 / 1024.0);
    }
    loop {
        let s = rng.real(-4.0, 4.0);
        let fraction = (f64::from(s) * size as f64).rem_euclid(1.0);
        if filter == Filter::Linear || (0.001..0.999).contains(&fraction) {
            return s;
        }
    }
}

fn run(harness: &Harness, tally: &mut Tally, filter: Filter) -> Result<(), ProbeError> {
    let mut rng = Rng::named("wrap");
    for size in SIZES {
        let level = Level::from_fn(size[0], size[1], |i, j| {
            [(i * 15) as u8, (j * 15) as u8, rng.byte(), 255]
        });
        for wrap in Wrap::ALL.iter().flat_map(|&s| Wrap::ALL.map(|t| [s, t])) {
            let at = Addressing { wrap, border: BORDER };
            let sampler = Sampler {
                at,
                filters: Filters::only(filter),
                lod: LodState::default(),
                range: LevelRange { base: 0, last: 0 },
            };
            let cases: Vec<[f32; 2]> = (0..harness.cases(512))
                .map(|_| size.map(|n| coordinate(&mut rng, n, filter)))
                .collect();
            let expect = |st: &[f32; 2], variant: Variant| {
                let st = st.map(f64::from);
                match filter {
                    Filter::Nearest => filter::nearest(&level, &at, st, variant),
                    Filter::Linear => filter::linear(&level, &at, st, variant),
                }
            };
            let precision = match filter {
                Filter::Nearest => Precision::Bytes,
                Filter::Linear => Precision::Exact { components: 4 },
            };
            harness.compare(tally, &(size, wrap), &cases, expect, |session| {
                session.texture_2d(std::slice::from_ref(&level), &sampler)?;
                let program = session.program(shader::TEXTURE_2D, precision)?;
                let inputs: Vec<_> =
                    cases.iter().map(|&[s, t]| [[s, t, 0.0, 1.0], [0.0; 4], [0.0; 4]]).collect();
                session.cells(&program, &inputs)
            })?;
        }
    }
    Ok(())
}
