//! How the components of a pixel are written in the client's memory (GL 2.1, table 3.5; GL 3.0 for
//! floats), and the numbers that they stand for.

use super::Numbers::{self, Fixed, Integer};
use crate::constants::*;
use crate::error::Table;
use crate::state::viewport::unit;
use crate::texture::packed::{PACKED, Packed};
use crate::types::*;
use texunit::format::shared_exponent;
use texunit::format::small_float::{decode_half, decode_unsigned, encode_half, encode_unsigned};

/// How the components of a pixel are written (GL 2.1, table 3.5).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ClientType {
    /// A bit, eight to a byte; it is taken apart to a byte before it is read.
    Bit,
    U8,
    I8,
    U16,
    I16,
    U32,
    I32,
    F16,
    F32,
    /// All components in one word.
    Packed(Packed),
    /// Three 9-bit mantissas with a common exponent (`EXT_texture_shared_exponent`).
    Rgb9E5,
    /// Unsigned floats of 11, 11 and 10 bits (`EXT_packed_float`).
    R11G11B10F,
    /// 24 bits of depth above 8 of stencil.
    Depth24Stencil8,
    /// A float of depth, then a word with 8 bits of stencil.
    Depth32FStencil8,
}

const PLAIN: [(GLenum, ClientType); 13] = [
    (GL_BITMAP, ClientType::Bit),
    (GL_UNSIGNED_BYTE, ClientType::U8),
    (GL_BYTE, ClientType::I8),
    (GL_UNSIGNED_SHORT, ClientType::U16),
    (GL_SHORT, ClientType::I16),
    (GL_UNSIGNED_INT, ClientType::U32),
    (GL_INT, ClientType::I32),
    (GL_FLOAT, ClientType::F32),
    (GL_HALF_FLOAT, ClientType::F16),
    (GL_UNSIGNED_INT_5_9_9_9_REV, ClientType::Rgb9E5),
    (GL_UNSIGNED_INT_10F_11F_11F_REV, ClientType::R11G11B10F),
    (GL_UNSIGNED_INT_24_8, ClientType::Depth24Stencil8),
    (GL_FLOAT_32_UNSIGNED_INT_24_8_REV, ClientType::Depth32FStencil8),
];

const TYPES: [(GLenum, ClientType); PLAIN.len() + PACKED.len()] = {
    let mut rows = [PLAIN[0]; PLAIN.len() + PACKED.len()];
    let mut row = 0;
    while row < rows.len() {
        rows[row] = if row < PLAIN.len() {
            PLAIN[row]
        } else {
            let (name, packed) = PACKED[row - PLAIN.len()];
            (name, ClientType::Packed(packed))
        };
        row += 1;
    }
    rows
};

/// What `type` can be.
pub(crate) const TYPE: Table<ClientType> = Table { section: "GL 2.1, table 3.5", rows: &TYPES };

/// The nearest of `0 ..= largest`; clamps, NaN gives 0.
fn unsigned(value: f64, largest: f64) -> f64 {
    (unit(value) * largest).round_ties_even()
}

impl ClientType {
    /// Bytes of an element, a component or a whole packed pixel: what alignment and byte order
    /// are about.
    pub fn size(self) -> usize {
        match self {
            Self::Bit | Self::U8 | Self::I8 => 1,
            Self::U16 | Self::I16 | Self::F16 => 2,
            Self::U32 | Self::I32 | Self::F32 => 4,
            Self::Rgb9E5 | Self::R11G11B10F | Self::Depth24Stencil8 | Self::Depth32FStencil8 => 4,
            Self::Packed(packed) => packed.bytes.into(),
        }
    }

    /// Elements of a pixel of so many components.
    pub fn elements(self, components: usize) -> usize {
        match self {
            Self::U8 | Self::I8 | Self::U16 | Self::I16 | Self::U32 | Self::I32 => components,
            Self::Bit | Self::F16 | Self::F32 => components,
            Self::Packed(_) | Self::Rgb9E5 | Self::R11G11B10F | Self::Depth24Stencil8 => 1,
            Self::Depth32FStencil8 => 2,
        }
    }

    pub(super) fn is_float(self) -> bool {
        match self {
            Self::F16 | Self::F32 => true,
            // Packed types go with a row of formats.
            Self::Rgb9E5 | Self::R11G11B10F | Self::Depth32FStencil8 => false,
            Self::U8 | Self::I8 | Self::U16 | Self::I16 | Self::U32 | Self::I32 => false,
            Self::Bit | Self::Packed(_) | Self::Depth24Stencil8 => false,
        }
    }

    /// Bits and sign of the integers, if it is of integers of its own.
    fn integer(self) -> Option<(u32, bool)> {
        Some(match self {
            Self::Bit | Self::U8 => (8, false),
            Self::I8 => (8, true),
            Self::U16 => (16, false),
            Self::I16 => (16, true),
            Self::U32 => (32, false),
            Self::I32 => (32, true),
            Self::F16 | Self::F32 | Self::Packed(_) | Self::Rgb9E5 | Self::R11G11B10F => {
                return None;
            }
            Self::Depth24Stencil8 | Self::Depth32FStencil8 => return None,
        })
    }

    /// The components of a pixel from its elements.
    #[inline]
    pub fn read(self, words: [u32; 4], numbers: Numbers) -> [f64; 4] {
        if let Some((bits, is_signed)) = self.integer() {
            return words.map(|word| {
                if is_signed {
                    read_signed(
                        f64::from((word << (32 - bits)) as i32 >> (32 - bits)),
                        bits,
                        numbers,
                    )
                } else {
                    read_unsigned(word, u32::MAX >> (32 - bits), numbers)
                }
            });
        }
        let [first, second, ..] = words;
        match self {
            Self::F16 => words.map(|word| decode_half(word).into()),
            Self::Packed(packed) => {
                let fields = packed.split(first);
                let mut out = [0.0; 4];
                for index in 0..packed.bits.len() {
                    out[index] = read_unsigned(fields[index], packed.field(index).1, numbers);
                }
                out
            }
            Self::Rgb9E5 => read_rgb9e5(first),
            Self::R11G11B10F => [
                decode_unsigned(first & 0x7FF, 6).into(),
                decode_unsigned(first >> 11 & 0x7FF, 6).into(),
                decode_unsigned(first >> 22, 5).into(),
                0.0,
            ],
            Self::Depth24Stencil8 => {
                [f64::from(first >> 8) / 16_777_215.0, f64::from(first & 0xFF), 0.0, 0.0]
            }
            Self::Depth32FStencil8 => {
                [f64::from(f32::from_bits(first)), f64::from(second & 0xFF), 0.0, 0.0]
            }
            Self::F32
            | Self::Bit
            | Self::U8
            | Self::I8
            | Self::U16
            | Self::I16
            | Self::U32
            | Self::I32 => words.map(|word| f64::from(f32::from_bits(word))),
        }
    }

    /// The elements of a pixel from its components.
    #[inline]
    pub fn write(self, values: [f64; 4], numbers: Numbers) -> [u32; 4] {
        if let Some((bits, is_signed)) = self.integer() {
            let mask = u32::MAX >> (32 - bits);
            return values.map(|value| {
                if is_signed {
                    write_signed(value, bits, numbers) & mask
                } else {
                    write_unsigned(value, mask, numbers)
                }
            });
        }
        let [a, b, ..] = values;
        match self {
            Self::F16 => values.map(|value| encode_half(value as f32)),
            Self::Packed(packed) => {
                let mut fields = [0; 4];
                for index in 0..packed.bits.len() {
                    fields[index] = write_unsigned(values[index], packed.field(index).1, numbers);
                }
                [packed.join(fields), 0, 0, 0]
            }
            Self::Rgb9E5 => {
                let [r, g, b, _] = values.map(|value| value as f32);
                [shared_exponent::encode(r, g, b), 0, 0, 0]
            }
            Self::R11G11B10F => {
                let [r, g, b, _] = values.map(|value| value as f32);
                let word = encode_unsigned(r, 6)
                    | encode_unsigned(g, 6) << 11
                    | encode_unsigned(b, 5) << 22;
                [word, 0, 0, 0]
            }
            Self::Depth24Stencil8 => {
                [(unsigned(a, 16_777_215.0) as u32) << 8 | b as u8 as u32, 0, 0, 0]
            }
            Self::Depth32FStencil8 => [(a as f32).to_bits(), (b as u8).into(), 0, 0],
            Self::F32
            | Self::Bit
            | Self::U8
            | Self::I8
            | Self::U16
            | Self::I16
            | Self::U32
            | Self::I32 => values.map(|value| (value as f32).to_bits()),
        }
    }
}

fn read_unsigned(value: u32, largest: u32, numbers: Numbers) -> f64 {
    match numbers {
        Fixed | Numbers::SignedNormalized => f64::from(value) / f64::from(largest),
        Integer => value.into(),
    }
}

fn read_signed(value: f64, bits: u32, numbers: Numbers) -> f64 {
    match numbers {
        Fixed => (2.0 * value + 1.0) / f64::from(u32::MAX >> (32 - bits)),
        Numbers::SignedNormalized => (value / f64::from(i32::MAX >> (32 - bits))).max(-1.0),
        Integer => value,
    }
}

fn write_unsigned(value: f64, largest: u32, numbers: Numbers) -> u32 {
    match numbers {
        Fixed | Numbers::SignedNormalized => unsigned(value, largest.into()) as u32,
        Integer => (value as i64).clamp(0, largest.into()) as u32,
    }
}

/// GL 2.1, table 4.9: `((2^b - 1) f - 1) / 2`, of a value clamped to [-1, 1].
fn write_signed(value: f64, bits: u32, numbers: Numbers) -> u32 {
    let (low, high) = (i32::MIN >> (32 - bits), i32::MAX >> (32 - bits));
    let integer = match numbers {
        Fixed => {
            let all = f64::from(u32::MAX >> (32 - bits));
            ((value.clamp(-1.0, 1.0) * all - 1.0) / 2.0).round_ties_even()
        }
        Numbers::SignedNormalized => (value.clamp(-1.0, 1.0) * f64::from(high)).round_ties_even(),
        Integer => value,
    };
    (integer as i64).clamp(low.into(), high.into()) as u32
}

/// `2^exponent`, of exponents that `f64` has without denormals.
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// `EXT_texture_shared_exponent`, section 3.8.X: `mantissa · 2^(exponent - 15 - 9)`.
fn read_rgb9e5(word: u32) -> [f64; 4] {
    let scale = power_of_two((word >> 27) as i32 - 24);
    [0, 9, 18, 27].map(
        |shift| {
            if shift == 27 { 0.0 } else { f64::from(word >> shift & 0x1FF) * scale }
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packed_floats_read_back() {
        for word in (0..u32::MAX).step_by(65_537) {
            let ty = ClientType::Rgb9E5;
            let color = ty.read([word; 4], Fixed);
            assert_eq!(ty.read(ty.write(color, Fixed), Fixed), color, "{word:#x}");
            let ty = ClientType::R11G11B10F;
            let color = ty.read([word; 4], Fixed);
            if color.iter().all(|c| c.is_finite()) {
                assert_eq!(ty.write(color, Fixed)[0], word);
            }
        }
    }

    #[test]
    fn every_word_of_every_integer_type_reads_back() {
        for ty in [ClientType::U8, ClientType::I8, ClientType::U16, ClientType::I16] {
            let bits = 8 * ty.size() as u32;
            for numbers in [Fixed, Numbers::SignedNormalized, Integer] {
                for word in 0..1_u32 << bits {
                    let values = ty.read([word; 4], numbers);
                    let back = ty.write(values, numbers)[0];
                    let lowest = word == 1 << (bits - 1) && numbers == Numbers::SignedNormalized;
                    assert!(back == word || lowest, "{ty:?} {numbers:?} {word}: {back}");
                }
            }
        }
        for (_, packed) in PACKED {
            let ty = ClientType::Packed(packed);
            for word in (0..u32::MAX >> (32 - 8 * ty.size())).step_by(251) {
                assert_eq!(ty.write(ty.read([word; 4], Fixed), Fixed)[0], word, "{ty:?}");
            }
        }
    }
}
