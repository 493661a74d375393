//! What the columns of the table of formats say: what channels mean, what numbers they are, where their bits lie.

/// A kind of block, 8 or 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Block {
    /// Four colours on a line, or three and a transparent black.
    Dxt1,
    /// 4 bits of alpha a texel, and four colours on a line.
    Dxt3,
    /// Eight or six alphas on a line, and four colours on another.
    Dxt5,
    /// Eight or six reds on a line.
    Rgtc1,
    /// The same, signed.
    Rgtc1Snorm,
    /// Reds on a line, greens on another.
    Rgtc2,
    /// The same, signed.
    Rgtc2Snorm,
    /// Colours on one to three lines, in eight modes.
    Bptc,
    /// The same of half floats without a sign.
    BptcUnsignedFloat,
    /// The same of half floats.
    BptcSignedFloat,
}

impl Block {
    /// Whether it is BPTC, of bytes or of floats.
    pub(super) const fn is_bptc(self) -> bool {
        match self {
            Self::Bptc | Self::BptcUnsignedFloat | Self::BptcSignedFloat => true,
            Self::Dxt1
            | Self::Dxt3
            | Self::Dxt5
            | Self::Rgtc1
            | Self::Rgtc1Snorm
            | Self::Rgtc2
            | Self::Rgtc2Snorm => false,
        }
    }

    /// Bits of a channel's end points.
    pub(super) const fn channel_bits(self, channel: usize) -> u32 {
        let alpha = match self {
            Self::Dxt1 => 1,
            Self::Dxt3 => 4,
            Self::Dxt5 => 8,
            Self::Rgtc1 | Self::Rgtc1Snorm | Self::Rgtc2 | Self::Rgtc2Snorm | Self::Bptc => {
                return 8;
            }
            Self::BptcUnsignedFloat | Self::BptcSignedFloat => return 16,
        };
        [5, 6, 5, alpha][channel]
    }
}

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

    /// What R, G, B and A of a sample are (GL 2.1, table 3.15); of depth, as luminance.
    pub(crate) const fn components(self) -> [Component; 4] {
        use Component::{One, Stored, Zero};
        match self {
            Self::Alpha => [Zero, Zero, Zero, Stored(0)],
            Self::Luminance | Self::Depth => [Stored(0), Stored(0), Stored(0), One],
            Self::LuminanceAlpha => [Stored(0), Stored(0), Stored(0), Stored(1)],
            Self::Intensity => [Stored(0); 4],
            Self::Red => [Stored(0), Zero, Zero, One],
            Self::Rg => [Stored(0), Stored(1), Zero, One],
            Self::Rgb => [Stored(0), Stored(1), Stored(2), One],
            Self::Rgba => [Stored(0), Stored(1), Stored(2), Stored(3)],
        }
    }
}

/// What a component of a sample is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Component {
    /// The stored channel of this number.
    Stored(usize),
    /// Zero.
    Zero,
    /// One.
    One,
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
    pub(super) const NONE: Self = Self { word: 0, shift: 0, bits: 0 };

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
    pub(super) const fn uniform(base: BaseFormat, encoding: Encoding, bits: u32) -> Self {
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
    pub(super) const fn packed(
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
    pub(super) const fn depth(encoding: Encoding, bytes: usize, shift: u32, bits: u32) -> Self {
        let none = (0, 0);
        Self::packed(BaseFormat::Depth, encoding, bytes, [(shift, bits), none, none, none])
    }

    /// The same with a stencil in the low byte of this word.
    pub(super) const fn with_stencil(mut self, word: usize) -> Self {
        self.stencil = Field { word, shift: 0, bits: 8 };
        self
    }

    pub(super) const fn blocks(base: BaseFormat, encoding: Encoding, bytes: usize) -> Self {
        Self { base, encoding, bytes, fields: [Field::NONE; 4], stencil: Field::NONE }
    }
}
