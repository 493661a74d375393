//! Cube maps: face, coordinates on it, and filtering within it.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::cube;
use crate::oracle::filter::{self, Addressing};
use crate::oracle::lod::{Filter, Filters, LevelRange, LodState};
use crate::oracle::sample::Sampler;
use crate::oracle::texture::Level;
use crate::oracle::wrap::Wrap;
use crate::probe::{Precision, ProbeError, shader};
use crate::rng::Rng;

/// Which texel of which face.
pub const FACE: Check = Check {
    name: "cube-face",
    citation: "GL 2.1, 3.8.6: faces by major axis",
    what: "face and texel that a direction selects",
    unit: Unit::Bytes,
    tolerance: 0.0,
    why: "texels are bytes and come back as they are",
    run: |harness, tally| run(harness, tally, Filter::Nearest),
};

/// The weighted mean within a face.
pub const FILTER: Check = Check {
    name: "cube-linear",
    citation: "GL 2.1, 3.8.6 and 3.8.8",
    what: "bilinear filter on the selected face, GL_CLAMP_TO_EDGE",
    unit: Unit::FullScale,
    tolerance: 20.0 / (1 << 24) as f64,
    why: "f32: s carries 2^-24 of the face, times 16 texels: 16 · 2^-24; the mix a few more",
    run: |harness, tally| run(harness, tally, Filter::Linear),
};

const SIZES: [usize; 3] = [1, 4, 16];

fn run(harness: &Harness, tally: &mut Tally, filter: Filter) -> Result<(), ProbeError> {
    let mut rng = Rng::named("cube");
    for size in SIZES {
        let faces: Vec<Level> = (0..6)
            .map(|face| {
                Level::from_fn(size, size, |i, j| {
                    [40 * face as u8 + 20, (i * 15) as u8, (j * 15) as u8, rng.byte()]
                })
            })
            .collect();
        let at = Addressing { wrap: [Wrap::ClampToEdge; 2], border: [0.0; 4] };
        let sampler = Sampler {
            at,
            filters: Filters::only(filter),
            lod: LodState::default(),
            range: LevelRange { base: 0, last: 0 },
        };
        let cases: Vec<[f32; 3]> =
            (0..harness.cases(4096)).map(|_| direction(&mut rng, size, filter)).collect();
        let expect = |r: &[f32; 3], variant: Variant| {
            let (face, st) = cube::select(r.map(f64::from), variant);
            let level = &faces[face as usize];
            match filter {
                Filter::Nearest => filter::nearest(level, &at, st, variant),
                Filter::Linear => filter::linear(level, &at, st, variant),
            }
        };
        let precision = match filter {
            Filter::Nearest => Precision::Bytes,
            Filter::Linear => Precision::Exact { components: 4 },
        };
        harness.compare(tally, &size, &cases, expect, |session| {
            session.texture_cube(&faces, &sampler)?;
            let program = session.program(shader::TEXTURE_CUBE, precision)?;
            let inputs: Vec<_> =
                cases.iter().map(|&[x, y, z]| [[x, y, z, 1.0], [0.0; 4], [0.0; 4]]).collect();
            session.cells(&program, &inputs)
        })?;
    }
    Ok(())
}

/// A direction of any length, not within a thousandth of where two faces meet, nor, for a nearest
/// filter, of a texel's edge.
fn direction(rng: &mut Rng, size: usize, filter: Filter) -> [f32; 3] {
    loop {
        let length = rng.pick(&[0.01, 1.0, 300.0]);
        let r = [0; 3].map(|_: i32| rng.real(-length, length));
        let mut sorted = r.map(|c| f64::from(c.abs()));
        sorted.sort_by(f64::total_cmp);
        let (_, st) = cube::select(r.map(f64::from), Variant::CORRECT);
        let inside = |c: f64| {
            let fraction = (c * size as f64).fract();
            filter == Filter::Linear || (0.001..0.999).contains(&fraction)
        };
        if sorted[1] < 0.999 * sorted[2] && st.into_iter().all(inside) {
            return r;
        }
    }
}
