//! The table of texel formats.
//!
//! Texels are stored as what they are; a filter converts the ones it reads. The columns of the
//! table are in [`Format::info`]; the conversions that follow from them in [`convert`].

pub mod convert;
pub mod srgb;

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
    /// (D, D, D, 1) as luminance; see `DEPTH_TEXTURE_MODE`.
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

/// How the channels of a texel are written as bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// A byte `c` is `c / 255`.
    Unorm8,
    /// A byte of a colour channel is sRGB-encoded; alpha is as in [`Encoding::Unorm8`].
    Srgb8,
    /// Two bytes `c`, little end first, are `c / 65535`.
    Unorm16,
    /// The low 24 bits `c` of four bytes, little end first, are `c / 16777215`.
    Unorm24,
    /// An IEEE `f32`, little end first.
    Float32,
}

/// One row of the table of formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FormatInfo {
    /// What the channels mean.
    pub base: BaseFormat,
    /// How they are written.
    pub encoding: Encoding,
    /// Bytes of a texel, 1 to 4.
    pub bytes: usize,
}

/// How a texel is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// One byte of alpha.
    A8,
    /// One byte of luminance.
    L8,
    /// Luminance, alpha.
    La8,
    /// One byte that is all four components.
    I8,
    /// One byte of red.
    R8,
    /// Red, green.
    Rg8,
    /// Red, green, blue, three bytes.
    Rgb8,
    /// Red, green, blue, alpha.
    Rgba8,
    /// sRGB-encoded red, green, blue.
    Srgb8,
    /// sRGB-encoded red, green, blue, and linear alpha.
    Srgb8A8,
    /// sRGB-encoded luminance.
    Sl8,
    /// sRGB-encoded luminance, and linear alpha.
    Sl8A8,
    /// 16-bit unsigned normalized depth.
    D16,
    /// 24-bit unsigned normalized depth in the low bits of a 32-bit word.
    D24,
    /// `f32` depth.
    D32F,
}

impl Format {
    /// Every format, in the order of the table.
    pub const ALL: [Self; 15] = [
        Self::A8,
        Self::L8,
        Self::La8,
        Self::I8,
        Self::R8,
        Self::Rg8,
        Self::Rgb8,
        Self::Rgba8,
        Self::Srgb8,
        Self::Srgb8A8,
        Self::Sl8,
        Self::Sl8A8,
        Self::D16,
        Self::D24,
        Self::D32F,
    ];

    /// The row of this format.
    pub const fn info(self) -> FormatInfo {
        use BaseFormat::{Alpha, Depth, Intensity, Luminance, LuminanceAlpha, Red, Rg, Rgb, Rgba};
        use Encoding::{Float32, Srgb8, Unorm8, Unorm16, Unorm24};
        const fn row(base: BaseFormat, encoding: Encoding, bytes: usize) -> FormatInfo {
            FormatInfo { base, encoding, bytes }
        }
        match self {
            Self::A8 => row(Alpha, Unorm8, 1),
            Self::L8 => row(Luminance, Unorm8, 1),
            Self::La8 => row(LuminanceAlpha, Unorm8, 2),
            Self::I8 => row(Intensity, Unorm8, 1),
            Self::R8 => row(Red, Unorm8, 1),
            Self::Rg8 => row(Rg, Unorm8, 2),
            Self::Rgb8 => row(Rgb, Unorm8, 3),
            Self::Rgba8 => row(Rgba, Unorm8, 4),
            Self::Srgb8 => row(Rgb, Srgb8, 3),
            Self::Srgb8A8 => row(Rgba, Srgb8, 4),
            Self::Sl8 => row(Luminance, Srgb8, 1),
            Self::Sl8A8 => row(LuminanceAlpha, Srgb8, 2),
            Self::D16 => row(Depth, Unorm16, 2),
            Self::D24 => row(Depth, Unorm24, 4),
            Self::D32F => row(Depth, Float32, 4),
        }
    }

    /// Bytes of a texel, 1 to 4.
    pub const fn bytes(self) -> usize {
        self.info().bytes
    }

    /// What the channels mean.
    pub const fn base(self) -> BaseFormat {
        self.info().base
    }

    /// How many channels a texel stores, 1 to 4.
    pub const fn channels(self) -> usize {
        self.base().sources().len()
    }

    /// Whether this is a depth format.
    pub const fn is_depth(self) -> bool {
        matches!(self.base(), BaseFormat::Depth)
    }

    /// Whether colours are stored sRGB-encoded.
    pub const fn is_srgb(self) -> bool {
        matches!(self.info().encoding, Encoding::Srgb8)
    }

    /// Whether this stored channel is sRGB-encoded: colour of an sRGB format, never alpha.
    pub const fn is_srgb_channel(self, channel: usize) -> bool {
        self.is_srgb() && self.base().sources()[channel] != 3
    }
}
