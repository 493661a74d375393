//! Integer texels (`EXT_texture_integer`).

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
    super::words::bytes_of(words)
}

#[cfg(test)]
mod tests {
    use super::super::words::words_of;
    use super::*;

    #[test]
    fn integers_clamp_come_back_and_sign_extend() {
        use Format::{Rg16I, Rgb32UI, Rgba8I, Rgba8UI, Rgba32I};
        let big = 1_i64 << 40;
        for (format, given, want) in [
            (Rgba8UI, [-1, 0, 255, 256], [0_i64, 0, 255, 255]),
            (Rgba8I, [-129, -1, 127, 128], [-128, -1, 127, 127]),
            (Rg16I, [-32_768, 32_768, 7, 7], [-32_768, 32_767, 0, 1]),
            (Rgb32UI, [big, 5, -big, 9], [0xFFFF_FFFF, 5, 0, 1]),
            (Rgba32I, [-big, big, -1, 0], [-0x8000_0000, 0x7FFF_FFFF, -1, 0]),
        ] {
            let texel = encode_int(format, given);
            let words = words_of(format, &texel).map(U32s::splat);
            for (channel, want) in want.into_iter().enumerate().take(format.channels()) {
                let got = decode_int_lanes(format, channel, &words)[63];
                assert_eq!(got, want as u32, "{format:?}");
            }
        }
    }
}
