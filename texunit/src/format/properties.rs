//! What follows from the row of a format.

use super::{BaseFormat, Block, Encoding, Format, FormatInfo};

impl Format {
    /// Bytes of a texel, 1 to 16; of a compressed format, of a block of 4×4 texels.
    pub const fn bytes(self) -> usize {
        self.info().bytes
    }

    /// Words of four bytes that a texel (or a block) takes, 1 to 4, the last perhaps in part.
    pub const fn words(self) -> usize {
        self.bytes().div_ceil(4)
    }

    /// What the channels mean.
    pub const fn base(self) -> BaseFormat {
        self.info().base
    }

    /// How many channels a texel stores, 1 to 4.
    pub const fn channels(self) -> usize {
        self.base().sources().len()
    }

    /// Whether this is a depth format, with or without stencil.
    pub const fn is_depth(self) -> bool {
        matches!(self.base(), BaseFormat::Depth)
    }

    /// Whether a stencil is stored beside the depth.
    pub const fn has_stencil(self) -> bool {
        self.info().stencil.bits > 0
    }

    /// Whether texels are integers, which are not filtered and reach a shader as integers.
    pub const fn is_integer(self) -> bool {
        matches!(self.info().encoding, Encoding::Uint | Encoding::Sint)
    }

    /// The kind of block, of a compressed format.
    pub const fn block(self) -> Option<Block> {
        match self.info().encoding {
            Encoding::Block(block) | Encoding::SrgbBlock(block) => Some(block),
            Encoding::Unorm
            | Encoding::Snorm
            | Encoding::Srgb
            | Encoding::Float
            | Encoding::SharedExponent
            | Encoding::Uint
            | Encoding::Sint => None,
        }
    }

    /// Whether volumes may be of it: of any format without blocks, and of BPTC.
    pub const fn has_volumes(self) -> bool {
        match self.block() {
            None => true,
            Some(block) => block.is_bptc(),
        }
    }

    /// How many texels wide and high a unit of storage is: 4 of a compressed format, else 1.
    pub const fn block_side(self) -> u32 {
        if self.block().is_some() { 4 } else { 1 }
    }

    /// Whether colours are stored sRGB-encoded.
    pub const fn is_srgb(self) -> bool {
        matches!(self.info().encoding, Encoding::Srgb | Encoding::SrgbBlock(_))
    }

    /// The format with the same bytes whose colours are numbers like others.
    pub const fn without_srgb(self) -> Self {
        match self {
            Self::Srgb8 => Self::Rgb8,
            Self::Srgb8A8 => Self::Rgba8,
            Self::Sl8 => Self::L8,
            Self::Sl8A8 => Self::La8,
            Self::SrgbDxt1Rgb => Self::Dxt1Rgb,
            Self::SrgbDxt1Rgba => Self::Dxt1Rgba,
            Self::SrgbDxt3 => Self::Dxt3,
            Self::SrgbDxt5 => Self::Dxt5,
            Self::SrgbBptc => Self::Bptc,
            other => other,
        }
    }

    /// Whether this stored channel is sRGB-encoded: colour of an sRGB format, never alpha.
    pub const fn is_srgb_channel(self, channel: usize) -> bool {
        self.is_srgb() && self.base().sources()[channel] != 3
    }

    /// Whether this stored channel is byte number `channel` of the texel, over 255.
    #[inline(always)]
    pub const fn is_byte_channel(self, channel: usize) -> bool {
        let FormatInfo { encoding, fields, .. } = self.info();
        fields[channel].bits == 8
            && fields[channel].shift == 8 * channel as u32
            && match encoding {
                Encoding::Unorm => true,
                Encoding::Srgb => !self.is_srgb_channel(channel),
                Encoding::Snorm
                | Encoding::Float
                | Encoding::SharedExponent
                | Encoding::Uint
                | Encoding::Sint
                | Encoding::Block(_)
                | Encoding::SrgbBlock(_) => false,
            }
    }

    /// Whether every channel is a byte over 255, one after the other.
    #[inline(always)]
    pub const fn is_bytes(self) -> bool {
        let channels = self.channels();
        let mut channel = 0;
        while channel < channels {
            if !self.is_byte_channel(channel) {
                return false;
            }
            channel += 1;
        }
        true
    }

    /// Bits of a stored channel; of a compressed format, those of a decoded texel.
    pub const fn channel_bits(self, channel: usize) -> u32 {
        match self.info().encoding {
            Encoding::Block(block) | Encoding::SrgbBlock(block) => block.channel_bits(channel),
            Encoding::Unorm
            | Encoding::Snorm
            | Encoding::Srgb
            | Encoding::Float
            | Encoding::SharedExponent
            | Encoding::Uint
            | Encoding::Sint => self.info().fields[channel].bits,
        }
    }
}

/// Whether texels are blocks whose colours are sRGB-encoded once they are decoded.
#[inline(always)]
pub(crate) const fn is_srgb_block(format: Format) -> bool {
    matches!(format.info().encoding, Encoding::SrgbBlock(_))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fields_of_a_texel_lie_within_its_bytes_and_apart() {
        for format in Format::ALL {
            let info = format.info();
            let mut taken = [0_u32; 4];
            let stencil = format.has_stencil().then_some(info.stencil);
            for field in info.fields.into_iter().filter(|f| f.bits > 0).chain(stencil) {
                let bits = field.mask() << field.shift;
                assert_eq!(bits.count_ones(), field.bits, "{format:?}");
                assert_eq!(taken[field.word] & bits, 0, "{format:?}");
                assert!(4 * field.word * 8 + (field.shift + field.bits) as usize <= 8 * info.bytes);
                taken[field.word] |= bits;
            }
            let there = info.fields.iter().filter(|f| f.bits > 0).count();
            let want = if format.block().is_some() { 0 } else { format.channels() };
            assert_eq!(there, want, "{format:?}");
        }
    }
}
