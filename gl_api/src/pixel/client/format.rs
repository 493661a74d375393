//! `format` of pixels in client memory: their components (GL 2.1, table 3.6; GL 3.0 for integers), and how integers
//! are interpreted.

use crate::base::constants::*;
use crate::base::error::Table;
use crate::pixel::client::format::Numbers::{Fixed, Integer};
use crate::pixel::transfer::TransferKind;
use ClientFormat::*;

/// The components of a pixel in memory (GL 2.1, table 3.6).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum ClientFormat {
    Red,
    Green,
    Blue,
    Alpha,
    Rg,
    Rgb,
    Bgr,
    Rgba,
    Bgra,
    /// `EXT_abgr`.
    Abgr,
    Luminance,
    LuminanceAlpha,
    Depth,
    /// Stencil alone, an integer.
    Stencil,
    /// Depth, then stencil.
    DepthStencil,
    /// An index into the pixel maps from indices to colours, which stand for it from then on.
    ColorIndex,
}

/// How the integers of a pixel are interpreted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Numbers {
    /// Fractions: unsigned `c / (2^b - 1)`, signed `(2c + 1) / (2^b - 1)` (GL 2.1, table 2.9).
    Fixed,
    /// As `Fixed`, but signed `max(c / (2^(b-1) - 1), -1)`: to and from signed normalized texels
    /// (`EXT_texture_snorm`).
    SignedNormalized,
    /// Themselves (`EXT_texture_integer`).
    Integer,
}

/// How luminance is computed from a colour that goes to the client.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LuminanceOf {
    /// R + G + B, of pixels of a framebuffer (GL 2.1, section 4.3.2).
    Sum,
    /// R, of texels (section 6.1.4: they are not converted to luminance).
    Red,
}

/// The values of `format`.
pub(crate) const FORMAT: Table<(ClientFormat, Numbers)> = Table {
    section: "GL 2.1, table 3.6",
    rows: &[
        (GL_RED, (Red, Fixed)),
        (GL_GREEN, (Green, Fixed)),
        (GL_BLUE, (Blue, Fixed)),
        (GL_ALPHA, (Alpha, Fixed)),
        (GL_RG, (Rg, Fixed)),
        (GL_RGB, (Rgb, Fixed)),
        (GL_BGR, (Bgr, Fixed)),
        (GL_RGBA, (Rgba, Fixed)),
        (GL_BGRA, (Bgra, Fixed)),
        (GL_ABGR_EXT, (Abgr, Fixed)),
        (GL_LUMINANCE, (Luminance, Fixed)),
        (GL_LUMINANCE_ALPHA, (LuminanceAlpha, Fixed)),
        (GL_DEPTH_COMPONENT, (Depth, Fixed)),
        (GL_STENCIL_INDEX, (Stencil, Integer)),
        (GL_DEPTH_STENCIL, (DepthStencil, Fixed)),
        (GL_COLOR_INDEX, (ColorIndex, Fixed)),
        (GL_RED_INTEGER, (Red, Integer)),
        (GL_GREEN_INTEGER, (Green, Integer)),
        (GL_BLUE_INTEGER, (Blue, Integer)),
        (GL_ALPHA_INTEGER_EXT, (Alpha, Integer)),
        (GL_RG_INTEGER, (Rg, Integer)),
        (GL_RGB_INTEGER, (Rgb, Integer)),
        (GL_BGR_INTEGER, (Bgr, Integer)),
        (GL_RGBA_INTEGER, (Rgba, Integer)),
        (GL_BGRA_INTEGER, (Bgra, Integer)),
        (GL_LUMINANCE_INTEGER_EXT, (Luminance, Integer)),
        (GL_LUMINANCE_ALPHA_INTEGER_EXT, (LuminanceAlpha, Integer)),
    ],
};

impl ClientFormat {
    /// Components of a pixel.
    pub fn components(self) -> usize {
        match self {
            Red | Green | Blue | Alpha | Luminance | Depth | Stencil | ColorIndex => 1,
            Rg | LuminanceAlpha | DepthStencil => 2,
            Rgb | Bgr => 3,
            Rgba | Bgra | Abgr => 4,
        }
    }

    /// Which steps of pixel transfer apply.
    pub fn kind(self) -> TransferKind {
        match self {
            Depth => TransferKind::Depth,
            DepthStencil => TransferKind::DepthStencil,
            Stencil => TransferKind::Stencil,
            ColorIndex => TransferKind::ColorIndex,
            Red | Green | Blue | Alpha | Rg | Rgb | Bgr | Rgba | Bgra | Abgr | Luminance
            | LuminanceAlpha => TransferKind::Color,
        }
    }

    /// Whether it is of depth or stencil, not of colour.
    pub fn is_depth(self) -> bool {
        match self.kind() {
            TransferKind::Depth | TransferKind::DepthStencil | TransferKind::Stencil => true,
            TransferKind::Color | TransferKind::ColorIndex => false,
        }
    }

    /// The pixel as R, G, B, A; depth and index as R, stencil beside a depth as G (GL 2.1, section
    /// 3.6.4, final expansion).
    pub fn expand<T: Copy>(self, [a, b, c, d]: [T; 4], zero: T, one: T) -> [T; 4] {
        match self {
            Red | Depth | Stencil | ColorIndex => [a, zero, zero, one],
            Green => [zero, a, zero, one],
            Blue => [zero, zero, a, one],
            Alpha => [zero, zero, zero, a],
            Rg | DepthStencil => [a, b, zero, one],
            Rgb => [a, b, c, one],
            Bgr => [c, b, a, one],
            Rgba => [a, b, c, d],
            Bgra => [c, b, a, d],
            Abgr => [d, c, b, a],
            Luminance => [a, a, a, one],
            LuminanceAlpha => [a, a, a, b],
        }
    }

    /// The components of the pixel R, G, B, A, of which `l` is the luminance (GL 2.1, section 4.3.2).
    pub fn select<T: Copy>(self, [r, g, b, a]: [T; 4], zero: T, l: T) -> [T; 4] {
        match self {
            Red | Depth | Stencil | ColorIndex => [r, zero, zero, zero],
            Green => [g, zero, zero, zero],
            Blue => [b, zero, zero, zero],
            Alpha => [a, zero, zero, zero],
            Rg | DepthStencil => [r, g, zero, zero],
            Rgb => [r, g, b, zero],
            Bgr => [b, g, r, zero],
            Rgba => [r, g, b, a],
            Bgra => [b, g, r, a],
            Abgr => [a, b, g, r],
            Luminance => [l, zero, zero, zero],
            LuminanceAlpha => [l, a, zero, zero],
        }
    }
}
