//! What a default framebuffer is made of.

use rasterizer::driver::possible_samples;
use texunit::format::Format;

/// What the default framebuffer has. By default 8 bits of each colour and alpha, 24 of depth, 8 of
/// stencil, one sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SurfaceDesc {
    /// Its colours.
    pub color: SurfaceColor,
    /// Bits of depth: 0, up to 16, up to 24, or up to 32.
    pub depth_bits: u8,
    /// Bits of stencil: 0, or up to 8.
    pub stencil_bits: u8,
    /// Samples of a pixel: 2 or 4; 0 and 1 are one.
    pub samples: u8,
}

/// The colour buffer of a default framebuffer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum SurfaceColor {
    /// 8 bits each of red, green, blue and alpha.
    #[default]
    Rgba8,
    /// 8 bits each of red, green and blue.
    Rgb8,
    /// 5 bits of red, 6 of green, 5 of blue.
    Rgb565,
    /// 16 bits each of red, green, blue and alpha.
    Rgba16,
    /// Red, green, blue and alpha in single precision.
    Rgba32F,
    /// 8 bits each of sRGB-encoded red, green and blue, and of alpha.
    Srgb8Alpha8,
}

impl SurfaceColor {
    pub(crate) fn format(self) -> Format {
        match self {
            Self::Rgba8 => Format::Rgba8,
            Self::Rgb8 => Format::Rgb8,
            Self::Rgb565 => Format::R5G6B5,
            Self::Rgba16 => Format::Rgba16,
            Self::Rgba32F => Format::Rgba32F,
            Self::Srgb8Alpha8 => Format::Srgb8A8,
        }
    }
}

impl Default for SurfaceDesc {
    fn default() -> Self {
        Self { color: SurfaceColor::default(), depth_bits: 24, stencil_bits: 8, samples: 1 }
    }
}

impl SurfaceDesc {
    /// How depth and stencil are stored, if there are any.
    pub(crate) fn depth_format(self) -> Option<Format> {
        match (self.depth_bits, self.stencil_bits) {
            (0, 0) => None,
            (1..=16, 0) => Some(Format::D16),
            (17..=24, 0) => Some(Format::D24),
            (_, 0) => Some(Format::D32F),
            (0..=24, _) => Some(Format::D24S8),
            (_, _) => Some(Format::D32FS8),
        }
    }

    /// Whether there can be such a framebuffer.
    pub(crate) fn is_possible(self) -> bool {
        let samples = self.samples.max(1);
        self.depth_bits <= 32 && self.stencil_bits <= 8 && samples == possible_samples(samples)
    }
}
