//! Arrays of cube maps: which cube a layer selects, and filtering across the edges of its faces.

use super::seamless::direction;
use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::{Mutation, Variant};
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{Filter, Filters, LevelRange, LodState};
use crate::oracle::sample::Sampler;
use crate::oracle::texture::Level;
use crate::oracle::wrap::Wrap;
use crate::oracle::{seamless, target};
use crate::probe::{ProbeError, shader};
use crate::rng::Rng;

/// `samplerCubeArray`.
pub const FILTER: Check = Check {
    name: "cube-array",
    citation: "ARB_texture_cube_map_array: layer-faces 6 · layer + face; ARB_seamless_cube_map, 3.8.8",
    what: "bilinear filter about the edges and corners of the cubes of an array, layers in and out \
           of range",
    unit: Unit::FullScale,
    tolerance: 20.0 / (1 << 24) as f64,
    why: "f32: s carries 2^-24 of the face, times 16 texels: 16 · 2^-24; the mix a few more",
    run,
};

const CUBES: usize = 3;

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("cube-array");
    for size in [1, 2, 16] {
        let faces: Vec<Level> = (0..6 * CUBES)
            .map(|_| Level::from_fn(size, size, |_, _| [0; 4].map(|_: u8| rng.byte())))
            .collect();
        let sampler = Sampler {
            at: Addressing { wrap: [Wrap::Repeat; 2], border: [0.0; 4] },
            filters: Filters::only(Filter::Linear),
            lod: LodState::default(),
            range: LevelRange { base: 0, last: 0 },
        };
        // Layers away from the middle between two integers.
        let cases: Vec<[f32; 4]> = (0..harness.cases(8192))
            .map(|_| {
                let [x, y, z] = direction(&mut rng, size);
                [x, y, z, rng.integer(-1, CUBES as i64) as f32 + rng.real(-0.45, 0.45)]
            })
            .collect();
        let expect = |&[x, y, z, q]: &[f32; 4], variant: Variant| {
            let layer = target::layer(q.into(), CUBES, variant);
            let cube: Vec<Level> = match variant.has(Mutation::LayersOfFaces) {
                false => faces[6 * layer..][..6].to_vec(),
                true => faces.iter().skip(layer).step_by(CUBES).cloned().collect(),
            };
            seamless::linear(&cube, [x, y, z].map(f64::from), variant)
        };
        harness.compare(tally, &size, &cases, expect, |session| {
            session.seamless_cubes()?;
            session.texture_cube_array(&faces, &sampler)?;
            let inputs: Vec<_> = cases.iter().map(|&case| [case, [0.0; 4], [0.0; 4]]).collect();
            session.field(shader::TEXTURE_CUBE_ARRAY, 4, &inputs)
        })?;
    }
    Ok(())
}
