//! Integer textures read by shaders: all bits, and the border.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::{Mutation, Variant};
use crate::probe::{IntegerRow, ProbeError};
use crate::rng::Rng;
use gl_api::constants::*;

/// `isampler2D` and `usampler2D`.
pub const SAMPLED: Check = Check {
    name: "integer-sampler",
    citation: "EXT_texture_integer, 3.8; GLSL 1.30, 8.7: gvec4",
    what: "random integers of 8, 16 and 32 bits through isampler2D and usampler2D, and a border \
           colour beyond 2^24",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers pass as they are",
    run,
};

/// Internal format, bits, whether signed, how many components are stored.
const FORMATS: [(u32, u32, bool, usize); 10] = [
    (GL_RGBA8I, 8, true, 4),
    (GL_RGBA8UI, 8, false, 4),
    (GL_RGBA16I, 16, true, 4),
    (GL_RGBA16UI, 16, false, 4),
    (GL_RGBA32I, 32, true, 4),
    (GL_RGBA32UI, 32, false, 4),
    (GL_R32I, 32, true, 1),
    (GL_RG16UI, 16, false, 2),
    (GL_RGB8UI, 8, false, 3),
    (GL_RGB32I, 32, true, 3),
];

const WIDTH: usize = 64;

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("integer-sampler");
    for (internal, bits, signed, components) in FORMATS {
        let mut number = || {
            let word = u32::from_le_bytes([rng.byte(), rng.byte(), rng.byte(), rng.byte()]);
            if signed { (word as i32 >> (32 - bits)) as u32 } else { word >> (32 - bits) }
        };
        let mut texel = || [number(), number(), number(), number()];
        let texels: Vec<[u32; 4]> = (0..WIDTH).map(|_| texel()).collect();
        let border = texel();
        // The column after the last is the border.
        let cases: Vec<usize> = (0..=harness.cases(WIDTH).min(WIDTH)).chain([WIDTH]).collect();
        let expect = |&column: &usize, variant: Variant| {
            let edge = if variant.has(Mutation::BorderAsEdge) { texels[WIDTH - 1] } else { border };
            let stored = texels.get(column).copied().unwrap_or(edge);
            let one = [0, 0, 0, 1];
            std::array::from_fn(|i| {
                let word = if i < components { stored[i] } else { one[i] };
                if !variant.has(Mutation::IntegersThroughFloats) {
                    return f64::from(word);
                }
                if signed {
                    f64::from(word as i32 as f32 as i32 as u32)
                } else {
                    f64::from(word as f32)
                }
            })
        };
        harness.compare(tally, &enum_name(internal), &cases, expect, |session| {
            session.integer_texture(&IntegerRow { internal, signed, texels: &texels, border })?;
            // Two rows for each case: the lower and the upper halves of the words.
            let inputs: Vec<_> = cases
                .iter()
                .flat_map(|&column| {
                    let s = (column as f32 + 0.5) / WIDTH as f32;
                    [0.0, 16.0].map(|shift| [[s, 0.5, shift, 0.0], [0.0; 4], [0.0; 4]])
                })
                .collect();
            let kind = if signed { "i" } else { "u" };
            let body = format!(
                "uniform {kind}sampler2D image;
                 vec4 value() {{
                     uvec4 words = uvec4(texture(image, a.xy));
                     return vec4(words >> uvec4(uint(a.z)) & 65535u);
                 }}"
            );
            let halves = session.field(&body, 4, &inputs)?;
            let whole =
                |pair: &[[f64; 4]]| std::array::from_fn(|i| pair[0][i] + 65536.0 * pair[1][i]);
            Ok(halves.chunks_exact(2).map(whole).collect())
        })?;
    }
    Ok(())
}
