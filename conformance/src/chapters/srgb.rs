//! sRGB decoding: every code of every channel, through the texture unit.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{Filter, Filters, LevelRange, LodState};
use crate::oracle::sample::Sampler;
use crate::oracle::srgb;
use crate::oracle::texture::Level;
use crate::oracle::wrap::Wrap;
use crate::probe::{Precision, ProbeError, Storage, shader};

/// All 256 codes.
pub const DECODE: Check = Check {
    name: "srgb",
    citation: "GL 2.1, 3.8.15",
    what: "linear value of each of the 256 codes of GL_SRGB8_ALPHA8",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 25) as f64,
    why: "f32: a table of constants that are rounded once: 2^-25",
    run,
};

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    // Each channel runs through all codes, from another start and in another direction.
    let level = Level::from_fn(256, 1, |i, _| {
        let c = i as u8;
        [c, !c, c.wrapping_add(85), c.wrapping_mul(3)]
    });
    let sampler = Sampler {
        at: Addressing { wrap: [Wrap::ClampToEdge; 2], border: [0.0; 4] },
        filters: Filters::only(Filter::Nearest),
        lod: LodState::default(),
        range: LevelRange { base: 0, last: 0 },
    };
    let cases: Vec<usize> = (0..256).collect();
    let expect = |&i: &usize, variant: Variant| srgb::decode_texel(level.texel(i, 0), variant);
    harness.compare(tally, &"GL_SRGB8_ALPHA8", &cases, expect, |session| {
        session.texture_2d_as(Storage::Srgb, std::slice::from_ref(&level), &sampler)?;
        let program = session.program(shader::TEXTURE_2D, Precision::Exact { components: 4 })?;
        let inputs: Vec<_> = cases
            .iter()
            .map(|&i| [[(i as f32 + 0.5) / 256.0, 0.5, 0.0, 1.0], [0.0; 4], [0.0; 4]])
            .collect();
        session.cells(&program, &inputs)
    })
}
