//! Compressed blocks of 4×4 texels (EXT_texture_compression_s3tc, EXT_texture_sRGB,
//! ARB_texture_compression_rgtc, EXT_texture_compression_latc), decoded with the formulas of their texts in exact fractions.

use super::{bptc, srgb};
use crate::mutation::{Mutation, Variant};

/// A block format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GL's names")]
pub enum BlockFormat {
    Dxt1Rgb,
    Dxt1Rgba,
    Dxt3,
    Dxt5,
    Rgtc1,
    Rgtc1Signed,
    Rgtc2,
    Rgtc2Signed,
    Latc1,
    Latc1Signed,
    Latc2,
    Latc2Signed,
    Bptc,
    BptcUnsignedFloat,
    BptcSignedFloat,
}

impl BlockFormat {
    /// Bytes of a block.
    pub fn bytes(self) -> usize {
        match self {
            Self::Dxt1Rgb | Self::Dxt1Rgba => 8,
            Self::Rgtc1 | Self::Rgtc1Signed | Self::Latc1 | Self::Latc1Signed => 8,
            Self::Dxt3 | Self::Dxt5 => 16,
            Self::Bptc | Self::BptcUnsignedFloat | Self::BptcSignedFloat => 16,
            Self::Rgtc2 | Self::Rgtc2Signed | Self::Latc2 | Self::Latc2Signed => 16,
        }
    }
}

/// R, G, B, A of texel `at` (`4·row + column`) of a block.
pub fn decode(kind: BlockFormat, block: &[u8], at: usize, variant: Variant) -> [f64; 4] {
    let at = if variant.has(Mutation::BlockColumnsFirst) { at % 4 * 4 + at / 4 } else { at };
    let unsigned = |bytes: &[u8]| line(bytes, at, [0.0, 255.0], variant);
    let signed = |bytes: &[u8]| line(bytes, at, [-127.0, 127.0], variant);
    match kind {
        BlockFormat::Dxt1Rgb => {
            let (rgb, _) = color(block, at, true, variant);
            [rgb[0], rgb[1], rgb[2], 1.0]
        }
        BlockFormat::Dxt1Rgba => {
            let (rgb, alpha) = color(block, at, true, variant);
            [rgb[0], rgb[1], rgb[2], alpha]
        }
        BlockFormat::Dxt3 => {
            let (rgb, _) = color(&block[8..], at, false, variant);
            let nibble = block[at / 2] >> (at % 2 * 4) & 15;
            [rgb[0], rgb[1], rgb[2], f64::from(nibble) / 15.0]
        }
        BlockFormat::Dxt5 => {
            let (rgb, _) = color(&block[8..], at, false, variant);
            [rgb[0], rgb[1], rgb[2], unsigned(block)]
        }
        BlockFormat::Rgtc1 => [unsigned(block), 0.0, 0.0, 1.0],
        BlockFormat::Rgtc1Signed => [signed(block), 0.0, 0.0, 1.0],
        BlockFormat::Rgtc2 => [unsigned(block), unsigned(&block[8..]), 0.0, 1.0],
        BlockFormat::Rgtc2Signed => [signed(block), signed(&block[8..]), 0.0, 1.0],
        BlockFormat::Bptc => bptc::decode(block, at, variant),
        BlockFormat::BptcUnsignedFloat => {
            bptc::decode_floats(block, at, bptc::Sign::Unsigned, variant)
        }
        BlockFormat::BptcSignedFloat => bptc::decode_floats(block, at, bptc::Sign::Signed, variant),
        BlockFormat::Latc1 => luminance(unsigned(block), 1.0, variant),
        BlockFormat::Latc1Signed => luminance(signed(block), 1.0, variant),
        BlockFormat::Latc2 => luminance(unsigned(block), unsigned(&block[8..]), variant),
        BlockFormat::Latc2Signed => luminance(signed(block), signed(&block[8..]), variant),
    }
}

/// (L, L, L, A).
fn luminance(l: f64, a: f64, variant: Variant) -> [f64; 4] {
    if variant.has(Mutation::LatcAsRgtc) { [l, a, 0.0, 1.0] } else { [l, l, l, a] }
}

/// The colour with sRGB-encoded R, G, B made linear.
pub fn decode_srgb(kind: BlockFormat, block: &[u8], at: usize, variant: Variant) -> [f64; 4] {
    srgb::decode_texel(decode(kind, block, at, variant), variant)
}

/// The colour part of S3TC: two colours of 5, 6 and 5 bits, then 2 bits a texel. Where the order
/// of the colours counts and the first is not the larger, code 2 is the mean of both, and code 3 a
/// black that is transparent in DXT1 with alpha.
fn color(block: &[u8], at: usize, order: bool, variant: Variant) -> ([f64; 3], f64) {
    let word = |i: usize| u16::from_le_bytes([block[i], block[i + 1]]);
    let (first, second) = (word(0), word(2));
    let rgb = |c: u16| {
        [f64::from(c >> 11) / 31.0, f64::from(c >> 5 & 63) / 63.0, f64::from(c & 31) / 31.0]
    };
    let (a, b) = (rgb(first), rgb(second));
    let mix = |wa: f64, wb: f64| std::array::from_fn(|i| (wa * a[i] + wb * b[i]) / (wa + wb));
    let code = block[4 + at / 4] >> (at % 4 * 2) & 3;
    let four = !order || first > second || variant.has(Mutation::BlockAlwaysFour);
    let thirds = variant.has(Mutation::BlockCodesSwapped);
    match (code, four) {
        (0, _) => (a, 1.0),
        (1, _) => (b, 1.0),
        (2, true) => (if thirds { mix(1.0, 2.0) } else { mix(2.0, 1.0) }, 1.0),
        (_, true) => (if thirds { mix(2.0, 1.0) } else { mix(1.0, 2.0) }, 1.0),
        (2, false) => (mix(1.0, 1.0), 1.0),
        (_, false) => ([0.0; 3], 0.0),
    }
}

/// The alpha of DXT5 and the components of RGTC: two ends, then 3 bits a texel. Six values between
/// the ends where the first is the larger; else four, and both ends of the range.
fn line(block: &[u8], at: usize, [low, high]: [f64; 2], variant: Variant) -> f64 {
    let end = |byte: u8| if low < 0.0 { f64::from(byte as i8) } else { f64::from(byte) };
    let (first, second) = (end(block[0]), end(block[1]));
    let bits = block[2..8].iter().rev().fold(0u64, |bits, &byte| bits << 8 | u64::from(byte));
    let code = f64::from((bits >> (3 * at)) as u32 & 7);
    let eight = first > second || variant.has(Mutation::BlockAlwaysEight);
    // -128 is -1, as -127 is, once the palette is chosen.
    let (a, b) = (first.max(low), second.max(low));
    let value = match (code, eight) {
        (0.0, _) => a,
        (1.0, _) => b,
        (c, true) => ((8.0 - c) * a + (c - 1.0) * b) / 7.0,
        (6.0, false) => low,
        (7.0, false) => high,
        (c, false) => ((6.0 - c) * a + (c - 1.0) * b) / 5.0,
    };
    value / high
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: Variant = Variant::CORRECT;

    #[test]
    fn colors_by_hand() {
        // White and black; codes 0 1 2 3 in the first row.
        let four = [0xff, 0xff, 0, 0, 0b11_10_01_00, 0, 0, 0];
        let reds = [0, 1, 2, 3].map(|at| decode(BlockFormat::Dxt1Rgb, &four, at, TRUE)[0]);
        assert_eq!(reds, [1.0, 0.0, 2.0 / 3.0, 1.0 / 3.0]);
        let three = [0, 0, 0xff, 0xff, 0b11_10_01_00, 0, 0, 0];
        let values = [0, 1, 2, 3].map(|at| decode(BlockFormat::Dxt1Rgba, &three, at, TRUE));
        assert_eq!(values.map(|v| v[0]), [0.0, 1.0, 0.5, 0.0]);
        assert_eq!(values.map(|v| v[3]), [1.0, 1.0, 1.0, 0.0]);
    }

    #[test]
    fn lines_by_hand() {
        let block = [255, 0, 0b1000_1000, 0b1100_0110, 0xff, 0, 0, 0];
        // Codes from the lowest bit: 0, 1, 2 (010), …
        assert_eq!(decode(BlockFormat::Rgtc1, &block, 0, TRUE)[0], 1.0);
        assert_eq!(decode(BlockFormat::Rgtc1, &block, 1, TRUE)[0], 0.0);
        assert!((decode(BlockFormat::Rgtc1, &block, 2, TRUE)[0] - 6.0 / 7.0).abs() < 1e-15);
        let signed = [0x80, 0x7f, 6 | 7 << 3, 0, 0, 0, 0, 0];
        assert_eq!(decode(BlockFormat::Rgtc1Signed, &signed, 0, TRUE)[0], -1.0);
        assert_eq!(decode(BlockFormat::Rgtc1Signed, &signed, 1, TRUE)[0], 1.0);
    }
}
