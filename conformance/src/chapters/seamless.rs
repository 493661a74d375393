//! Cube maps filtered across edges and corners.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{Filter, Filters, LevelRange, LodState};
use crate::oracle::sample::Sampler;
use crate::oracle::seamless;
use crate::oracle::texture::Level;
use crate::oracle::wrap::Wrap;
use crate::probe::{ProbeError, shader};
use crate::rng::Rng;

/// `GL_TEXTURE_CUBE_MAP_SEAMLESS`.
pub const SEAMLESS: Check = Check {
    name: "cube-seamless",
    citation: "ARB_seamless_cube_map, 3.8.8",
    what: "bilinear filter about the 12 edges and 8 corners of a cube map",
    unit: Unit::FullScale,
    tolerance: 24.0 / (1 << 24) as f64,
    why: "f32: s carries 2^-24 of the face, times 16 texels per axis: 16 · 2^-24 each, of random signs",
    run,
};

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("seamless");
    for size in [1, 2, 16] {
        let faces: Vec<Level> = (0..6)
            .map(|_| Level::from_fn(size, size, |_, _| [0; 4].map(|_: u8| rng.byte())))
            .collect();
        let sampler = Sampler {
            at: Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] },
            filters: Filters::only(Filter::Linear),
            lod: LodState::default(),
            range: LevelRange { base: 0, last: 0 },
        };
        let cases: Vec<[f32; 3]> =
            (0..harness.cases(8192)).map(|_| direction(&mut rng, size)).collect();
        let expect =
            |r: &[f32; 3], variant: Variant| seamless::linear(&faces, r.map(f64::from), variant);
        harness.compare(tally, &size, &cases, expect, |session| {
            session.seamless_cubes()?;
            session.texture_cube(&faces, &sampler)?;
            let inputs: Vec<_> =
                cases.iter().map(|&[x, y, z]| [[x, y, z, 1.0], [0.0; 4], [0.0; 4]]).collect();
            session.field(shader::TEXTURE_CUBE, 4, &inputs)
        })?;
    }
    Ok(())
}

/// A direction within a texel of an edge or corner more often than not, but not so near that `f32`
/// may take it for the other face.
pub(super) fn direction(rng: &mut Rng, size: usize) -> [f32; 3] {
    loop {
        let mut r = [0; 3].map(|_: i32| rng.real(-1.0, 1.0));
        let edges = rng.integer(0, 2) as usize;
        let near = 1.0 - rng.real(0.0, 1.0) / size as f32;
        for component in &mut r[..=edges] {
            *component = if *component < 0.0 { -near } else { near } * rng.real(0.98, 1.0);
        }
        let turn = rng.integer(0, 2) as usize;
        r.rotate_left(turn);
        let mut sorted = r.map(f32::abs);
        sorted.sort_by(f32::total_cmp);
        if sorted[1] < 0.9999 * sorted[2] {
            return r;
        }
    }
}
