//! The table of texel formats.
//!
//! Texels are stored as what they are; a filter converts the ones it reads. The table itself is
//! in `format/table.rs`; the conversions that follow from its columns in [`convert`], [`integer`]
//! and [`block`].

pub mod block;
pub mod convert;
pub mod integer;
pub mod shared_exponent;
pub mod small_float;
pub mod srgb;
mod table;

pub use block::Block;
pub use table::Format;

/// What a format's components mean, and so what a sample of it returns (GL 2.1, table 3.15).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BaseFormat {
    /// (0, 0, 0, A).
    Alpha,
    /// (L, L, L, 1).
    Luminance,
    /// (L, L, L, A).
    LuminanceAlpha,
    /// (I, I, I, I).
    Intensity,
    /// (R, 0, 0, 1).
    Red,
    /// (R, G, 0, 1).
    Rg,
    /// (R, G, B, 1).
    Rgb,
    /// (R, G, B, A).
    Rgba,
    /// (D, D, D, 1) as luminance; see `DEPTH_TEXTURE_MODE`. With or without a stencil beside it.
    Depth,
}

impl BaseFormat {
    /// Which of R, G, B, A each stored channel is taken from when a colour becomes a texel
    /// (GL 2.1, table 3.15). Its length is the number of channels.
    pub const fn sources(self) -> &'static [usize] {
        match self {
            Self::Alpha => &[3],
            Self::Luminance | Self::Intensity | Self::Red | Self::Depth => &[0],
            Self::LuminanceAlpha => &[0, 3],
            Self::Rg => &[0, 1],
            Self::Rgb => &[0, 1, 2],
            Self::Rgba => &[0, 1, 2, 3],
        }
    }
}

/// What number the bits of a channel are. `n` is the channel's width in bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// `c` is `c / (2^n - 1)`.
    Unorm,
    /// `c`, in two's complement, is `max(c / (2^(n-1) - 1), -1)` (`EXT_texture_snorm`).
    Snorm,
    /// A byte of a colour channel is sRGB-encoded; alpha is as in [`Encoding::Unorm`].
    Srgb,
    /// IEEE `f32` (32 bits) and half float (16), and their unsigned forms of 11 and 10 bits with
    /// a mantissa of 6 and 5 (`EXT_packed_float`).
    Float,
    /// A mantissa of 9 bits, the exponent of all channels in the top 5 bits of the word
    /// (`EXT_texture_shared_exponent`).
    SharedExponent,
    /// An unsigned integer (`EXT_texture_integer`).
    Uint,
    /// An integer in two's complement (`EXT_texture_integer`).
    Sint,
    /// A block of 4×4 texels.
    Block(Block),
    /// A block whose colours are sRGB-encoded once it is decoded.
    SrgbBlock(Block),
}

impl Encoding {
    /// The numbers from 0 to 1.
    pub const UNIT: [f32; 2] = [0.0, 1.0];

    /// The least and the largest number that fixed-point channels hold: what colours are clamped to
    /// (`ARB_color_buffer_float`, section 4.1.8). `None` for what is no fixed-point number.
    #[inline(always)]
    pub const fn range(self) -> Option<[f32; 2]> {
        match self {
            Self::Unorm | Self::Srgb => Some(Self::UNIT),
            Self::Snorm => Some([-1.0, 1.0]),
            Self::Float
            | Self::SharedExponent
            | Self::Uint
            | Self::Sint
            | Self::Block(_)
            | Self::SrgbBlock(_) => None,
        }
    }
}

/// Where the bits of one channel are: in which word of the texel, from which bit on, how many.
/// Words are of four bytes, little end first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Field {
    /// 0 to 3.
    pub word: usize,
    /// 0 to 31.
    pub shift: u32,
    /// 1 to 32; 0 where there is no such channel.
    pub bits: u32,
}

impl Field {
    const NONE: Self = Self { word: 0, shift: 0, bits: 0 };

    /// All ones in as many bits as the field has.
    #[inline(always)]
    pub const fn mask(self) -> u32 {
        if self.bits == 0 { 0 } else { u32::MAX >> (32 - self.bits) }
    }

    /// The bits of the field in its word.
    #[inline(always)]
    pub const fn of(self, word: u32) -> u32 {
        word >> self.shift & self.mask()
    }

    /// Bits in their place in the word.
    #[inline(always)]
    pub const fn put(self, bits: u32) -> u32 {
        (bits & self.mask()) << self.shift
    }
}

/// One row of the table of formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FormatInfo {
    /// What the channels mean.
    pub base: BaseFormat,
    /// What number the bits of a channel are.
    pub encoding: Encoding,
    /// Bytes of a texel, 1 to 16; of a compressed format, of a block of 4×4 texels.
    pub bytes: usize,
    /// Where each channel is. None of a compressed format.
    pub fields: [Field; 4],
    /// Where the stencil is, in a format of depth and stencil.
    pub stencil: Field,
}

impl FormatInfo {
    /// Channels of `bits` each, one after the other.
    const fn uniform(base: BaseFormat, encoding: Encoding, bits: u32) -> Self {
        let channels = base.sources().len();
        let mut fields = [Field::NONE; 4];
        let mut channel = 0;
        while channel < channels {
            let at = channel * bits as usize;
            fields[channel] = Field { word: at / 32, shift: (at % 32) as u32, bits };
            channel += 1;
        }
        let bytes = channels * bits as usize / 8;
        Self { base, encoding, bytes, fields, stencil: Field::NONE }
    }

    /// Channels in one word of `bytes`, each given as (shift, bits).
    const fn packed(
        base: BaseFormat,
        encoding: Encoding,
        bytes: usize,
        places: [(u32, u32); 4],
    ) -> Self {
        let mut fields = [Field::NONE; 4];
        let mut channel = 0;
        while channel < 4 {
            let (shift, bits) = places[channel];
            fields[channel] = Field { word: 0, shift, bits };
            channel += 1;
        }
        Self { base, encoding, bytes, fields, stencil: Field::NONE }
    }

    /// Depth of `bits` in the first word, from bit `shift` on, and no stencil.
    const fn depth(encoding: Encoding, bytes: usize, shift: u32, bits: u32) -> Self {
        let none = (0, 0);
        Self::packed(BaseFormat::Depth, encoding, bytes, [(shift, bits), none, none, none])
    }

    /// The same with a stencil in the low byte of this word.
    const fn with_stencil(mut self, word: usize) -> Self {
        self.stencil = Field { word, shift: 0, bits: 8 };
        self
    }

    const fn blocks(base: BaseFormat, encoding: Encoding, bytes: usize) -> Self {
        Self { base, encoding, bytes, fields: [Field::NONE; 4], stencil: Field::NONE }
    }
}

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
