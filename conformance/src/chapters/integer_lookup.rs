//! Integer textures under every wrap mode, and the packed format of unsigned integers.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::wrap::{self, Index, Wrap};
use crate::probe::{Dialect, ProbeError, wrap_enum};
use crate::rng::Rng;
use gl_api::constants::*;

/// Wrap modes.
pub const WRAP: Check = Check {
    name: "integer-wrap",
    citation: "GL 3.0, 3.8.7 and 3.8.8: nearest lookups of isampler2D and usampler2D",
    what: "texels and integer borders of 7×5 images of 8, 16 and 32 bits under all pairs of wrap modes",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers pass as they are",
    run: wraps,
};

/// Packed unsigned integers.
pub const PACKED: Check = Check {
    name: "rgb10-a2ui",
    citation: "GL 3.3, 3.8.1 and 4.3.1; ARB_texture_rgb10_a2ui",
    what: "words that are uploaded as 2_10_10_10_REV, fetched, written by fragments and read back",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "integers pass as they are",
    run: packed,
};

/// Internal format, bits, and whether it is signed.
const FORMATS: [(u32, u32, bool); 4] = [
    (GL_RGBA32UI, 32, false),
    (GL_RGBA32I, 32, true),
    (GL_RGBA16UI, 16, false),
    (GL_RGBA8I, 8, true),
];

const SIZE: [usize; 2] = [7, 5];

fn wraps(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("integer-wrap");
    let mut borders = 0;
    let rounds = harness.cases(64).max(16);
    for round in 0..rounds {
        let (internal, bits, signed) = FORMATS[round % FORMATS.len()];
        let modes = [Wrap::ALL[round % 8], Wrap::ALL[(round / 8 + round) % 8]];
        let mut texel = || {
            [0; 4].map(|_: i32| {
                let word = rng.integer(0, u32::MAX.into()) as u32;
                if signed { (word as i32 >> (32 - bits)) as u32 } else { word >> (32 - bits) }
            })
        };
        let texels: Vec<[u32; 4]> = (0..SIZE[0] * SIZE[1]).map(|_| texel()).collect();
        let border = texel();
        let cases: Vec<[f32; 2]> = (0..harness.cases(512))
            .map(|_| {
                SIZE.map(|n| {
                    // Away from the edges of texels.
                    let place = rng.integer(-2 * n as i64, 3 * n as i64 - 1) as f32;
                    (place + rng.real(0.01, 0.99)) / n as f32
                })
            })
            .collect();
        let at = |case: &[f32; 2], variant: Variant| {
            [0, 1].map(|i| wrap::nearest(modes[i], case[i].into(), SIZE[i], variant))
        };
        borders +=
            cases.iter().filter(|case| at(case, Variant::CORRECT).contains(&Index::Border)).count();
        let expect = |case: &[f32; 2], variant: Variant| {
            let texel = match at(case, variant) {
                [Index::Texel(i), Index::Texel(j)] => texels[j * SIZE[0] + i],
                [Index::Border, _] | [_, Index::Border] => border,
            };
            texel.map(f64::from)
        };
        let scene = (enum_name(internal), modes);
        harness.compare_with(Dialect::Compatibility, tally, &scene, &cases, expect, |session| {
            let (target, mut name) = (GL_TEXTURE_2D, 0u32);
            glGenTextures(1, &mut name);
            glBindTexture(target, name);
            let ty = if signed { GL_INT } else { GL_UNSIGNED_INT };
            let ([w, h], texels) = (SIZE, texels.as_flattened());
            glTexImage2D(target, 0, internal, w, h, 0, GL_RGBA_INTEGER, ty, texels);
            for (parameter, value) in [
                (GL_TEXTURE_MIN_FILTER, GL_NEAREST),
                (GL_TEXTURE_MAG_FILTER, GL_NEAREST),
                (GL_TEXTURE_WRAP_S, wrap_enum(modes[0])),
                (GL_TEXTURE_WRAP_T, wrap_enum(modes[1])),
            ] {
                glTexParameteri(target, parameter, value);
            }
            if signed {
                glTexParameterIiv(target, GL_TEXTURE_BORDER_COLOR, &border.map(|c| c as i32));
            } else {
                glTexParameterIuiv(target, GL_TEXTURE_BORDER_COLOR, &border);
            }
            let kind = if signed { "i" } else { "u" };
            let body = format!(
                "uniform {kind}sampler2D image;
                 uvec4 value(uvec4 a, uvec4 b) {{
                     return uvec4(texture(image, uintBitsToFloat(a.xy)));
                 }}"
            );
            let inputs: Vec<_> =
                cases.iter().map(|c| [[c[0].to_bits(), c[1].to_bits(), 0, 0], [0; 4]]).collect();
            let words = session.words(&body, &inputs)?;
            Ok(words.into_iter().map(|word| word.map(f64::from)).collect())
        })?;
    }
    tally.reach("lookups of the border", borders, rounds * harness.cases(512) / 8);
    Ok(())
}

fn packed(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("rgb10-a2ui");
    const WIDTH: usize = 256;
    for _ in 0..harness.cases(16) {
        let cases: Vec<u32> = (0..WIDTH).map(|_| rng.integer(0, u32::MAX.into()) as u32).collect();
        let expect = |&word: &u32, variant: Variant| {
            let fields = [word & 1023, word >> 10 & 1023, word >> 20 & 1023, word >> 30];
            let ten_bits = [word >> 22 & 1023, word >> 12 & 1023, word >> 2 & 1023, word & 3];
            let reversed = variant.has(Mutation::PackedReversed);
            (if reversed { ten_bits } else { fields }).map(f64::from)
        };
        let internal = GL_RGB10_A2UI;
        harness.compare_with(Dialect::Core, tally, &"RGB10_A2UI", &cases, expect, |session| {
            let (target, mut name) = (GL_TEXTURE_2D, 0u32);
            glGenTextures(1, &mut name);
            glBindTexture(target, name);
            let (format, ty) = (GL_RGBA_INTEGER, GL_UNSIGNED_INT_2_10_10_10_REV);
            glTexImage2D(target, 0, internal, WIDTH, 1, 0, format, ty, &cases);
            glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
            session.copied_words(internal, WIDTH)
        })?;
        let distinct = cases.iter().filter(|word| (*word >> 30) != (*word & 3)).count();
        tally.reach("words whose ends differ", distinct, WIDTH / 2);
    }
    Ok(())
}
