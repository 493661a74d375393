//! Classes of texels that have a fast path.

use crate::format::{Encoding, Format};

/// How the channels of a texel are stored, one after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TexelClass {
    /// Bytes over 255.
    Bytes,
    /// sRGB-encoded bytes; alpha is a byte over 255.
    Srgb,
    /// Half floats.
    Halves,
    /// Floats.
    Floats,
    /// Normalized depths of up to 24 bits.
    Depth {
        /// Where the bits lie in the word.
        shift: u32,
        /// The largest depth, `2^bits - 1`.
        largest: u32,
    },
}

impl TexelClass {
    /// The class of a format, if it has one.
    pub fn of(format: Format) -> Option<Self> {
        let info = format.info();
        let depth = info.fields[0];
        let bits = depth.bits;
        // Depths of more than 24 bits are not exact in `f32`.
        if format.is_depth() && info.encoding == Encoding::Unorm && bits <= 24 && depth.word == 0 {
            return Some(Self::Depth { shift: depth.shift, largest: depth.mask() });
        }
        let class = match (info.encoding, bits) {
            (Encoding::Unorm, 8) => Self::Bytes,
            (Encoding::Srgb, 8) => Self::Srgb,
            (Encoding::Float, 16) => Self::Halves,
            (Encoding::Float, 32) => Self::Floats,
            (
                Encoding::Unorm
                | Encoding::Snorm
                | Encoding::Srgb
                | Encoding::Float
                | Encoding::SharedExponent
                | Encoding::Uint
                | Encoding::Sint
                | Encoding::Block(_)
                | Encoding::SrgbBlock(_),
                _,
            ) => return None,
        };
        let in_order = (0..format.channels()).all(|channel| {
            let (field, at) = (info.fields[channel], channel as u32 * bits);
            field.bits == bits && field.word as u32 == at / 32 && field.shift == at % 32
        });
        (in_order && !format.has_stencil()).then_some(class)
    }
}
