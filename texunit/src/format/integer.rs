//! Integer texels (`EXT_texture_integer`), and the stencil beside a depth.

use super::convert::words_of;
use super::{Encoding, Field, Format};
use crate::lanes::{LANES, U32s};

/// The bits of a field as a number.
#[inline(always)]
fn value(encoding: Encoding, field: Field, word: u32) -> u32 {
    let bits = field.of(word);
    match encoding {
        Encoding::Sint => {
            let unused = 32 - field.bits;
            ((bits << unused) as i32 >> unused) as u32
        }
        Encoding::Uint
        | Encoding::Unorm
        | Encoding::Snorm
        | Encoding::Srgb
        | Encoding::Float
        | Encoding::SharedExponent
        | Encoding::Block(_)
        | Encoding::SrgbBlock(_) => bits,
    }
}

/// The colour of an integer texel: what is not stored is 0, alpha 1. Of other formats, the bits.
pub fn decode_int(format: Format, texel: &[u8]) -> [i64; 4] {
    let (info, words) = (format.info(), words_of(format, texel));
    let mut color = [0, 0, 0, 1];
    for (channel, &source) in format.base().sources().iter().enumerate() {
        let field = info.fields[channel];
        let bits = value(info.encoding, field, words[field.word]);
        color[source] = match info.encoding {
            Encoding::Sint => i64::from(bits as i32),
            Encoding::Uint
            | Encoding::Unorm
            | Encoding::Snorm
            | Encoding::Srgb
            | Encoding::Float
            | Encoding::SharedExponent
            | Encoding::Block(_)
            | Encoding::SrgbBlock(_) => i64::from(bits),
        };
    }
    color
}

/// One stored channel of 64 integer texels, as the bits of an `i32` or `u32`. `words` are the
/// texel's, [`Format::words`] of them.
#[inline(always)]
pub fn decode_int_lanes(format: Format, channel: usize, words: &[U32s]) -> U32s {
    let info = format.info();
    let field = info.fields[channel];
    let words = &words[field.word];
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        out[lane] = value(info.encoding, field, words[lane]);
    }
    out
}

/// The texel of an integer colour, in the first [`Format::bytes`] bytes of the result. Numbers
/// out of range are clamped to it.
pub fn encode_int(format: Format, rgba: [i64; 4]) -> [u8; 16] {
    let info = format.info();
    let mut words = [0_u32; 4];
    for (channel, &source) in format.base().sources().iter().enumerate() {
        let field = info.fields[channel];
        if field.bits == 0 {
            continue;
        }
        let (low, high) = match info.encoding {
            Encoding::Sint => (-1_i64 << (field.bits - 1), (1_i64 << (field.bits - 1)) - 1),
            Encoding::Uint
            | Encoding::Unorm
            | Encoding::Snorm
            | Encoding::Srgb
            | Encoding::Float
            | Encoding::SharedExponent
            | Encoding::Block(_)
            | Encoding::SrgbBlock(_) => (0, i64::from(field.mask())),
        };
        let bits = rgba[source].clamp(low, high) as u32 & field.mask();
        words[field.word] |= bits << field.shift;
    }
    super::convert::bytes_of(words)
}

/// The stencil of a texel, if its format has one.
pub fn stencil(format: Format, texel: &[u8]) -> Option<u8> {
    let field = format.info().stencil;
    format.has_stencil().then(|| field.of(words_of(format, texel)[field.word]) as u8)
}

/// Puts a stencil into a texel whose format has one; a texel of any other stays.
pub fn set_stencil(format: Format, texel: &mut [u8], stencil: u8) {
    // It is the low byte of its word.
    if format.has_stencil()
        && let Some(byte) = texel.get_mut(4 * format.info().stencil.word)
    {
        *byte = stencil;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_clamp_come_back_and_sign_extend() {
        use Format::{Rg16I, Rgb32UI, Rgba8I, Rgba8UI, Rgba32I};
        let big = 1_i64 << 40;
        for (format, given, want) in [
            (Rgba8UI, [-1, 0, 255, 256], [0, 0, 255, 255]),
            (Rgba8I, [-129, -1, 127, 128], [-128, -1, 127, 127]),
            (Rg16I, [-32_768, 32_768, 7, 7], [-32_768, 32_767, 0, 1]),
            (Rgb32UI, [big, 5, -big, 9], [0xFFFF_FFFF, 5, 0, 1]),
            (Rgba32I, [-big, big, -1, 0], [-0x8000_0000, 0x7FFF_FFFF, -1, 0]),
        ] {
            let texel = encode_int(format, given);
            assert_eq!(decode_int(format, &texel), want, "{format:?}");
            let words = words_of(format, &texel).map(U32s::splat);
            for (channel, want) in want.into_iter().enumerate().take(format.channels()) {
                let got = decode_int_lanes(format, channel, &words)[63];
                assert_eq!(got, want as u32, "{format:?}");
            }
        }
    }

    #[test]
    fn a_stencil_lies_beside_its_depth() {
        for format in [Format::D24S8, Format::D32FS8] {
            let mut texel = super::super::convert::encode(format, [0.25; 4]);
            let depth = super::super::convert::decode(format, &texel);
            set_stencil(format, &mut texel, 0xA5);
            assert_eq!(stencil(format, &texel), Some(0xA5));
            assert_eq!(super::super::convert::decode(format, &texel), depth);
        }
        assert_eq!(stencil(Format::D24, &[0; 4]), None);
    }
}
