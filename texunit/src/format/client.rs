//! Texels as the numbers that a client uploads and reads back: in `f64`, so that 32-bit
//! normalized values are kept, and as stored: sRGB colours stay encoded (`EXT_texture_sRGB`).

use super::convert::{decode_channels, encode, words_of};
use super::{Encoding, Format};

/// A stored channel as a number: a fraction of its largest where it is normalized, sRGB included.
pub fn read_channel(format: Format, texel: &[u8], channel: usize) -> f64 {
    let info = format.info();
    let field = info.fields[channel];
    match info.encoding {
        Encoding::Unorm | Encoding::Srgb => {
            let bits = field.of(words_of(format, texel)[field.word]);
            f64::from(bits) / f64::from(field.mask().max(1))
        }
        Encoding::Snorm
        | Encoding::Float
        | Encoding::SharedExponent
        | Encoding::Uint
        | Encoding::Sint
        | Encoding::Block(_)
        | Encoding::SrgbBlock(_) => f64::from(decode_channels(format, texel)[channel]),
    }
}

/// The texel of a colour (depth as R), sRGB already encoded, as [`encode`] otherwise: normalized
/// channels are clamped and rounded to nearest, halves to even.
pub fn write_texel(format: Format, rgba: [f64; 4]) -> [u8; 16] {
    let info = format.info();
    match info.encoding {
        Encoding::Unorm | Encoding::Srgb => {
            let mut words = [0; 4];
            for (channel, &source) in format.base().sources().iter().enumerate() {
                let field = info.fields[channel];
                let x = if rgba[source].is_nan() { 0.0 } else { rgba[source].clamp(0.0, 1.0) };
                let bits = (x * f64::from(field.mask())).round_ties_even() as u32;
                words[field.word] |= bits << field.shift;
            }
            super::convert::bytes_of(words)
        }
        // Integers of 32 bits would lose some on the way through `f32`.
        Encoding::Uint | Encoding::Sint => {
            super::integer::encode_int(format, rgba.map(|x| x.round_ties_even() as i64))
        }
        Encoding::Snorm
        | Encoding::Float
        | Encoding::SharedExponent
        | Encoding::Block(_)
        | Encoding::SrgbBlock(_) => encode(format, rgba.map(|x| x as f32)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_written_is_read() {
        for format in Format::ALL {
            if format.block().is_some() {
                continue;
            }
            let rgba = [0.2, 0.4, 0.8, 1.0];
            let texel = write_texel(format, rgba);
            for (channel, &source) in format.base().sources().iter().enumerate() {
                let got = read_channel(format, &texel, channel);
                let bits = format.channel_bits(channel);
                let step = match format.info().encoding {
                    Encoding::Unorm | Encoding::Srgb => 0.5 / (2.0_f64.powi(bits as i32) - 1.0),
                    Encoding::Snorm => 0.5 / (2.0_f64.powi(bits as i32 - 1) - 1.0),
                    Encoding::Uint | Encoding::Sint => 0.5,
                    Encoding::Float | Encoding::SharedExponent => 1.0 / 64.0,
                    Encoding::Block(_) | Encoding::SrgbBlock(_) => unreachable!("left out"),
                };
                assert!((got - rgba[source]).abs() <= step * 1.000_001 + 1e-8, "{format:?}");
            }
        }
    }

    #[test]
    fn thirty_two_bits_are_kept() {
        for bits in [0_u32, 1, 0x7FFF_FFFF, 0xFFFF_FFFE, u32::MAX] {
            let depth = f64::from(bits) / f64::from(u32::MAX);
            let texel = write_texel(Format::D32, [depth; 4]);
            assert_eq!(texel[..4], bits.to_le_bytes());
            assert_eq!(read_channel(Format::D32, &texel, 0), depth);
        }
    }
}
