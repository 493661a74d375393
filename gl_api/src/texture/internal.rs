//! Internal formats: what a texture or renderbuffer may be asked to store, and what it stores
//! (GL 2.1, tables 3.15 and 3.16; `EXT_texture_sRGB`).

use crate::constants::*;
use crate::error::Table;
use crate::types::*;
use texunit::format::{BaseFormat, Format};

/// What is implemented. Formats of less than 8 bits a component are stored with 8.
pub(crate) const INTERNAL_FORMAT: Table<Format> = Table {
    section: "GL 2.1, table 3.16",
    rows: &[
        (GL_ALPHA, Format::A8),
        (GL_ALPHA8, Format::A8),
        (GL_ALPHA4, Format::A8),
        (GL_LUMINANCE, Format::L8),
        (GL_LUMINANCE8, Format::L8),
        (GL_LUMINANCE4, Format::L8),
        (GL_LUMINANCE_ALPHA, Format::La8),
        (GL_LUMINANCE8_ALPHA8, Format::La8),
        (GL_LUMINANCE4_ALPHA4, Format::La8),
        (GL_LUMINANCE6_ALPHA2, Format::La8),
        (GL_INTENSITY, Format::I8),
        (GL_INTENSITY8, Format::I8),
        (GL_INTENSITY4, Format::I8),
        (GL_RED, Format::R8),
        (GL_R8, Format::R8),
        (GL_RG, Format::Rg8),
        (GL_RG8, Format::Rg8),
        (GL_RGB, Format::Rgb8),
        (GL_RGB8, Format::Rgb8),
        (GL_R3_G3_B2, Format::Rgb8),
        (GL_RGB4, Format::Rgb8),
        (GL_RGB5, Format::Rgb8),
        (GL_RGBA, Format::Rgba8),
        (GL_RGBA8, Format::Rgba8),
        (GL_RGBA2, Format::Rgba8),
        (GL_RGBA4, Format::Rgba8),
        (GL_RGB5_A1, Format::Rgba8),
        (GL_SRGB, Format::Srgb8),
        (GL_SRGB8, Format::Srgb8),
        (GL_SRGB_ALPHA, Format::Srgb8A8),
        (GL_SRGB8_ALPHA8, Format::Srgb8A8),
        (GL_SLUMINANCE, Format::Sl8),
        (GL_SLUMINANCE8, Format::Sl8),
        (GL_SLUMINANCE_ALPHA, Format::Sl8A8),
        (GL_SLUMINANCE8_ALPHA8, Format::Sl8A8),
        (GL_DEPTH_COMPONENT, Format::D24),
        (GL_DEPTH_COMPONENT16, Format::D16),
        (GL_DEPTH_COMPONENT24, Format::D24),
        (GL_DEPTH_COMPONENT32, Format::D32F),
        (GL_DEPTH_COMPONENT32F, Format::D32F),
    ],
};

/// The numbers that `glTexImage` takes since GL 1.0.
const COMPONENTS: [(GLenum, Format); 4] =
    [(1, Format::L8), (2, Format::La8), (3, Format::Rgb8), (4, Format::Rgba8)];

/// The format of a texture image; the numbers 1 to 4 count too.
pub(crate) fn texture_format(internal: GLenum) -> Option<Format> {
    INTERNAL_FORMAT.get(internal).or_else(|| {
        COMPONENTS.iter().find(|(number, _)| *number == internal).map(|(_, format)| *format)
    })
}

/// Bits of a component of a stored format, as `glGetTexLevelParameter` reports them.
pub(crate) fn component_bits(format: Format, component: Component) -> i32 {
    use BaseFormat::{Alpha, Depth, Intensity, Luminance, LuminanceAlpha, Red, Rg, Rgb, Rgba};
    let base = format.base();
    let there = match component {
        Component::Red => matches!(base, Red | Rg | Rgb | Rgba),
        Component::Green => matches!(base, Rg | Rgb | Rgba),
        Component::Blue => matches!(base, Rgb | Rgba),
        Component::Alpha => matches!(base, Alpha | LuminanceAlpha | Rgba),
        Component::Luminance => matches!(base, Luminance | LuminanceAlpha),
        Component::Intensity => matches!(base, Intensity),
        Component::Depth => matches!(base, Depth),
    };
    let channel = match component {
        Component::Red | Component::Luminance | Component::Intensity | Component::Depth => 0,
        Component::Green => 1,
        Component::Blue => 2,
        Component::Alpha => format.channels() - 1,
    };
    if there { format.channel_bits(channel) as i32 } else { 0 }
}

/// A component that has a size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Component {
    Red,
    Green,
    Blue,
    Alpha,
    Luminance,
    Intensity,
    Depth,
}
