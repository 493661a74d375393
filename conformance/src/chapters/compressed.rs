//! Compressed textures: random blocks, each of their 16 texels sampled.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::block::{self, BlockFormat};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// S3TC, RGTC, LATC and BPTC.
pub const COMPRESSED: Check = Check {
    name: "compressed",
    citation: "EXT_texture_compression_s3tc, EXT_texture_sRGB, ARB_texture_compression_rgtc, \
               EXT_texture_compression_latc, ARB_texture_compression_bptc",
    what: "each texel of random blocks of 20 compressed formats, uploaded and sampled",
    unit: Unit::Ulp,
    tolerance: 0.5,
    why: "one rounding of the exact fraction to f32; the table of sRGB is of constants that are rounded once",
    run,
};

/// Format, how it decodes, and whether it is sRGB-encoded.
const FORMATS: [(u32, BlockFormat, bool); 20] = [
    (GL_COMPRESSED_RGB_S3TC_DXT1_EXT, BlockFormat::Dxt1Rgb, false),
    (GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, BlockFormat::Dxt1Rgba, false),
    (GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, BlockFormat::Dxt3, false),
    (GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, BlockFormat::Dxt5, false),
    (GL_COMPRESSED_SRGB_S3TC_DXT1_EXT, BlockFormat::Dxt1Rgb, true),
    (GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT, BlockFormat::Dxt1Rgba, true),
    (GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT, BlockFormat::Dxt3, true),
    (GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT, BlockFormat::Dxt5, true),
    (GL_COMPRESSED_RED_RGTC1, BlockFormat::Rgtc1, false),
    (GL_COMPRESSED_SIGNED_RED_RGTC1, BlockFormat::Rgtc1Signed, false),
    (GL_COMPRESSED_RG_RGTC2, BlockFormat::Rgtc2, false),
    (GL_COMPRESSED_SIGNED_RG_RGTC2, BlockFormat::Rgtc2Signed, false),
    (GL_COMPRESSED_LUMINANCE_LATC1_EXT, BlockFormat::Latc1, false),
    (GL_COMPRESSED_SIGNED_LUMINANCE_LATC1_EXT, BlockFormat::Latc1Signed, false),
    (GL_COMPRESSED_LUMINANCE_ALPHA_LATC2_EXT, BlockFormat::Latc2, false),
    (GL_COMPRESSED_SIGNED_LUMINANCE_ALPHA_LATC2_EXT, BlockFormat::Latc2Signed, false),
    (GL_COMPRESSED_RGBA_BPTC_UNORM, BlockFormat::Bptc, false),
    (GL_COMPRESSED_SRGB_ALPHA_BPTC_UNORM, BlockFormat::Bptc, true),
    (GL_COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT, BlockFormat::BptcUnsignedFloat, false),
    (GL_COMPRESSED_RGB_BPTC_SIGNED_FLOAT, BlockFormat::BptcSignedFloat, false),
];

/// Blocks in a row of the texture.
const ACROSS: usize = 16;

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("compressed");
    for (internal, kind, is_srgb) in FORMATS {
        let rows = harness.cases(16);
        let size = [4 * ACROSS, 4 * rows];
        let mut bytes: Vec<u8> = (0..ACROSS * rows * kind.bytes()).map(|_| rng.byte()).collect();
        for block in bytes.chunks_exact_mut(kind.bytes()) {
            // Of half of the blocks all modes are as frequent.
            if matches!(kind, BlockFormat::Bptc) && rng.integer(0, 1) == 0 {
                block[0] = 1 << rng.integer(0, 7);
                continue;
            }
            // Every other block has the larger of its ends first, some have equal ones.
            match rng.integer(0, 3) {
                0 => block[..2].sort_unstable(),
                1 => block[1] = block[0],
                _ => {}
            }
        }
        let cases: Vec<[usize; 2]> =
            (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| [x, y])).collect();
        let expect = |&[x, y]: &[usize; 2], variant: Variant| {
            let number = y / 4 * ACROSS + x / 4;
            let block = &bytes[number * kind.bytes()..][..kind.bytes()];
            let at = y % 4 * 4 + x % 4;
            if is_srgb {
                block::decode_srgb(kind, block, at, variant)
            } else {
                block::decode(kind, block, at, variant)
            }
        };
        harness.compare(tally, &enum_name(internal), &cases, expect, |session| {
            session.compressed_texture(internal, size, &bytes)?;
            let centre = |n: usize, size: usize| (n as f32 + 0.5) / size as f32;
            let inputs: Vec<_> = cases
                .iter()
                .map(|&[x, y]| {
                    [[centre(x, size[0]), centre(y, size[1]), 0.0, 0.0], [0.0; 4], [0.0; 4]]
                })
                .collect();
            let body = "uniform sampler2D image; vec4 value() { return texture2D(image, a.xy); }";
            session.field(body, 4, &inputs)
        })?;
    }
    Ok(())
}
