//! Internal formats: what a texture or renderbuffer may be asked to store, and what it stores
//! (GL 2.1, tables 3.15 and 3.16; `EXT_texture_sRGB`).

use crate::base::constants::*;
use crate::base::error::Table;
use crate::base::types::*;
use texunit::format::{BaseFormat, Format};

/// What there is but specific compressed formats. Where none is stored with so many bits, the next
/// larger one is; generic compressed formats are not compressed.
pub(crate) const INTERNAL_FORMAT: Table<Format> = Table {
    section: "GL 2.1, table 3.16",
    rows: &[
        (GL_ALPHA, Format::A8),
        (GL_ALPHA4, Format::A8),
        (GL_ALPHA8, Format::A8),
        (GL_ALPHA12, Format::A16),
        (GL_ALPHA16, Format::A16),
        (GL_LUMINANCE, Format::L8),
        (GL_LUMINANCE4, Format::L8),
        (GL_LUMINANCE8, Format::L8),
        (GL_LUMINANCE12, Format::L16),
        (GL_LUMINANCE16, Format::L16),
        (GL_LUMINANCE_ALPHA, Format::La8),
        (GL_LUMINANCE4_ALPHA4, Format::La8),
        (GL_LUMINANCE6_ALPHA2, Format::La8),
        (GL_LUMINANCE8_ALPHA8, Format::La8),
        (GL_LUMINANCE12_ALPHA4, Format::La16),
        (GL_LUMINANCE12_ALPHA12, Format::La16),
        (GL_LUMINANCE16_ALPHA16, Format::La16),
        (GL_INTENSITY, Format::I8),
        (GL_INTENSITY4, Format::I8),
        (GL_INTENSITY8, Format::I8),
        (GL_INTENSITY12, Format::I16),
        (GL_INTENSITY16, Format::I16),
        (GL_RED, Format::R8),
        (GL_R8, Format::R8),
        (GL_R16, Format::R16),
        (GL_RG, Format::Rg8),
        (GL_RG8, Format::Rg8),
        (GL_RG16, Format::Rg16),
        (GL_RGB, Format::Rgb8),
        (GL_R3_G3_B2, Format::R3G3B2),
        (GL_RGB4, Format::R5G6B5),
        (GL_RGB5, Format::R5G6B5),
        (GL_RGB565, Format::R5G6B5),
        (GL_RGB8, Format::Rgb8),
        (GL_RGB10, Format::Rgb10),
        (GL_RGB12, Format::Rgb16),
        (GL_RGB16, Format::Rgb16),
        (GL_RGBA, Format::Rgba8),
        (GL_RGBA2, Format::Rgba4),
        (GL_RGBA4, Format::Rgba4),
        (GL_RGB5_A1, Format::Rgb5A1),
        (GL_RGBA8, Format::Rgba8),
        (GL_RGB10_A2, Format::Rgb10A2),
        (GL_RGBA12, Format::Rgba16),
        (GL_RGBA16, Format::Rgba16),
        (GL_SRGB, Format::Srgb8),
        (GL_SRGB8, Format::Srgb8),
        (GL_SRGB_ALPHA, Format::Srgb8A8),
        (GL_SRGB8_ALPHA8, Format::Srgb8A8),
        (GL_SLUMINANCE, Format::Sl8),
        (GL_SLUMINANCE8, Format::Sl8),
        (GL_SLUMINANCE_ALPHA, Format::Sl8A8),
        (GL_SLUMINANCE8_ALPHA8, Format::Sl8A8),
        (GL_R8_SNORM, Format::R8Snorm),
        (GL_RG8_SNORM, Format::Rg8Snorm),
        (GL_RGB8_SNORM, Format::Rgb8Snorm),
        (GL_RGBA8_SNORM, Format::Rgba8Snorm),
        (GL_R16_SNORM, Format::R16Snorm),
        (GL_RG16_SNORM, Format::Rg16Snorm),
        (GL_RGB16_SNORM, Format::Rgb16Snorm),
        (GL_RGBA16_SNORM, Format::Rgba16Snorm),
        (GL_ALPHA8_SNORM, Format::A8Snorm),
        (GL_ALPHA16_SNORM, Format::A16Snorm),
        (GL_LUMINANCE8_SNORM, Format::L8Snorm),
        (GL_LUMINANCE16_SNORM, Format::L16Snorm),
        (GL_LUMINANCE8_ALPHA8_SNORM, Format::La8Snorm),
        (GL_LUMINANCE16_ALPHA16_SNORM, Format::La16Snorm),
        (GL_INTENSITY8_SNORM, Format::I8Snorm),
        (GL_INTENSITY16_SNORM, Format::I16Snorm),
        (GL_RED_SNORM, Format::R8Snorm),
        (GL_RG_SNORM, Format::Rg8Snorm),
        (GL_RGB_SNORM, Format::Rgb8Snorm),
        (GL_RGBA_SNORM, Format::Rgba8Snorm),
        (GL_ALPHA_SNORM, Format::A8Snorm),
        (GL_LUMINANCE_SNORM, Format::L8Snorm),
        (GL_LUMINANCE_ALPHA_SNORM, Format::La8Snorm),
        (GL_INTENSITY_SNORM, Format::I8Snorm),
        (GL_ALPHA16F_ARB, Format::A16F),
        (GL_LUMINANCE16F_ARB, Format::L16F),
        (GL_LUMINANCE_ALPHA16F_ARB, Format::La16F),
        (GL_INTENSITY16F_ARB, Format::I16F),
        (GL_R16F, Format::R16F),
        (GL_RG16F, Format::Rg16F),
        (GL_RGB16F, Format::Rgb16F),
        (GL_RGBA16F, Format::Rgba16F),
        (GL_ALPHA32F_ARB, Format::A32F),
        (GL_LUMINANCE32F_ARB, Format::L32F),
        (GL_LUMINANCE_ALPHA32F_ARB, Format::La32F),
        (GL_INTENSITY32F_ARB, Format::I32F),
        (GL_R32F, Format::R32F),
        (GL_RG32F, Format::Rg32F),
        (GL_RGB32F, Format::Rgb32F),
        (GL_RGBA32F, Format::Rgba32F),
        (GL_R11F_G11F_B10F, Format::R11G11B10F),
        (GL_RGB9_E5, Format::Rgb9E5),
        (GL_R8I, Format::R8I),
        (GL_R8UI, Format::R8UI),
        (GL_RG8I, Format::Rg8I),
        (GL_RG8UI, Format::Rg8UI),
        (GL_RGB8I, Format::Rgb8I),
        (GL_RGB8UI, Format::Rgb8UI),
        (GL_RGBA8I, Format::Rgba8I),
        (GL_RGBA8UI, Format::Rgba8UI),
        (GL_R16I, Format::R16I),
        (GL_R16UI, Format::R16UI),
        (GL_RG16I, Format::Rg16I),
        (GL_RG16UI, Format::Rg16UI),
        (GL_RGB16I, Format::Rgb16I),
        (GL_RGB16UI, Format::Rgb16UI),
        (GL_RGBA16I, Format::Rgba16I),
        (GL_RGBA16UI, Format::Rgba16UI),
        (GL_R32I, Format::R32I),
        (GL_R32UI, Format::R32UI),
        (GL_RG32I, Format::Rg32I),
        (GL_RG32UI, Format::Rg32UI),
        (GL_RGB32I, Format::Rgb32I),
        (GL_RGB32UI, Format::Rgb32UI),
        (GL_RGBA32I, Format::Rgba32I),
        (GL_RGBA32UI, Format::Rgba32UI),
        (GL_ALPHA8UI_EXT, Format::A8UI),
        (GL_ALPHA8I_EXT, Format::A8I),
        (GL_ALPHA16UI_EXT, Format::A16UI),
        (GL_ALPHA16I_EXT, Format::A16I),
        (GL_ALPHA32UI_EXT, Format::A32UI),
        (GL_ALPHA32I_EXT, Format::A32I),
        (GL_LUMINANCE8UI_EXT, Format::L8UI),
        (GL_LUMINANCE8I_EXT, Format::L8I),
        (GL_LUMINANCE16UI_EXT, Format::L16UI),
        (GL_LUMINANCE16I_EXT, Format::L16I),
        (GL_LUMINANCE32UI_EXT, Format::L32UI),
        (GL_LUMINANCE32I_EXT, Format::L32I),
        (GL_LUMINANCE_ALPHA8UI_EXT, Format::La8UI),
        (GL_LUMINANCE_ALPHA8I_EXT, Format::La8I),
        (GL_LUMINANCE_ALPHA16UI_EXT, Format::La16UI),
        (GL_LUMINANCE_ALPHA16I_EXT, Format::La16I),
        (GL_LUMINANCE_ALPHA32UI_EXT, Format::La32UI),
        (GL_LUMINANCE_ALPHA32I_EXT, Format::La32I),
        (GL_INTENSITY8UI_EXT, Format::I8UI),
        (GL_INTENSITY8I_EXT, Format::I8I),
        (GL_INTENSITY16UI_EXT, Format::I16UI),
        (GL_INTENSITY16I_EXT, Format::I16I),
        (GL_INTENSITY32UI_EXT, Format::I32UI),
        (GL_INTENSITY32I_EXT, Format::I32I),
        (GL_RGB10_A2UI, Format::Rgb10A2UI),
        (GL_DEPTH_COMPONENT, Format::D24),
        (GL_DEPTH_COMPONENT16, Format::D16),
        (GL_DEPTH_COMPONENT24, Format::D24),
        (GL_DEPTH_COMPONENT32, Format::D32F),
        (GL_DEPTH_COMPONENT32F, Format::D32F),
        (GL_DEPTH_STENCIL, Format::D24S8),
        (GL_DEPTH24_STENCIL8, Format::D24S8),
        (GL_DEPTH32F_STENCIL8, Format::D32FS8),
        (GL_COMPRESSED_ALPHA, Format::A8),
        (GL_COMPRESSED_LUMINANCE, Format::L8),
        (GL_COMPRESSED_LUMINANCE_ALPHA, Format::La8),
        (GL_COMPRESSED_INTENSITY, Format::I8),
        (GL_COMPRESSED_RED, Format::R8),
        (GL_COMPRESSED_RG, Format::Rg8),
        (GL_COMPRESSED_RGB, Format::Rgb8),
        (GL_COMPRESSED_RGBA, Format::Rgba8),
        (GL_COMPRESSED_SRGB, Format::Srgb8),
        (GL_COMPRESSED_SRGB_ALPHA, Format::Srgb8A8),
        (GL_COMPRESSED_SLUMINANCE, Format::Sl8),
        (GL_COMPRESSED_SLUMINANCE_ALPHA, Format::Sl8A8),
    ],
};

/// Stencils without depth, for renderbuffers (`EXT_framebuffer_object`, table 2.nnn). They are
/// stored beside a depth that nobody sees.
pub(crate) const STENCIL_FORMAT: Table<Format> = Table {
    section: "EXT_framebuffer_object, section 4.4.2.1",
    rows: &[
        (GL_STENCIL_INDEX, Format::D24S8),
        (GL_STENCIL_INDEX1, Format::D24S8),
        (GL_STENCIL_INDEX4, Format::D24S8),
        (GL_STENCIL_INDEX8, Format::D24S8),
        (GL_STENCIL_INDEX16, Format::D24S8),
    ],
};

/// The generic compressed formats, and the base formats that they have, as nothing is compressed.
const GENERIC: [(GLenum, GLenum); 12] = [
    (GL_COMPRESSED_ALPHA, GL_ALPHA),
    (GL_COMPRESSED_LUMINANCE, GL_LUMINANCE),
    (GL_COMPRESSED_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA),
    (GL_COMPRESSED_INTENSITY, GL_INTENSITY),
    (GL_COMPRESSED_RED, GL_RED),
    (GL_COMPRESSED_RG, GL_RG),
    (GL_COMPRESSED_RGB, GL_RGB),
    (GL_COMPRESSED_RGBA, GL_RGBA),
    (GL_COMPRESSED_SRGB, GL_RGB),
    (GL_COMPRESSED_SRGB_ALPHA, GL_RGBA),
    (GL_COMPRESSED_SLUMINANCE, GL_LUMINANCE),
    (GL_COMPRESSED_SLUMINANCE_ALPHA, GL_LUMINANCE_ALPHA),
];

/// Whether a generic compressed format was asked for, which is no format of renderbuffers.
pub(crate) fn is_generic_compressed(internal: GLenum) -> bool {
    specific(internal) != internal
}

/// The format that is said to be used where this one was asked for (GL 2.1, section 3.8.1): itself,
/// or the base format of a generic compressed one.
pub(crate) fn specific(internal: GLenum) -> GLenum {
    GENERIC.iter().find(|(generic, _)| *generic == internal).map_or(internal, |row| row.1)
}

/// The specific compressed formats (`EXT_texture_compression_s3tc`, `EXT_texture_sRGB`,
/// `ARB_texture_compression_rgtc`, `EXT_texture_compression_latc`, `ATI_texture_compression_3dc`).
pub(crate) const COMPRESSED_FORMAT: Table<Format> = Table {
    section: "GL 2.1, section 3.8.3",
    rows: &[
        (GL_COMPRESSED_RGB_S3TC_DXT1_EXT, Format::Dxt1Rgb),
        (GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, Format::Dxt1Rgba),
        (GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, Format::Dxt3),
        (GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, Format::Dxt5),
        (GL_COMPRESSED_SRGB_S3TC_DXT1_EXT, Format::SrgbDxt1Rgb),
        (GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT, Format::SrgbDxt1Rgba),
        (GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT, Format::SrgbDxt3),
        (GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT, Format::SrgbDxt5),
        (GL_COMPRESSED_RED_RGTC1, Format::Rgtc1),
        (GL_COMPRESSED_SIGNED_RED_RGTC1, Format::Rgtc1Snorm),
        (GL_COMPRESSED_RG_RGTC2, Format::Rgtc2),
        (GL_COMPRESSED_SIGNED_RG_RGTC2, Format::Rgtc2Snorm),
        (GL_COMPRESSED_LUMINANCE_LATC1_EXT, Format::Latc1),
        (GL_COMPRESSED_SIGNED_LUMINANCE_LATC1_EXT, Format::Latc1Snorm),
        (GL_COMPRESSED_LUMINANCE_ALPHA_LATC2_EXT, Format::Latc2),
        (GL_COMPRESSED_SIGNED_LUMINANCE_ALPHA_LATC2_EXT, Format::Latc2Snorm),
        (GL_COMPRESSED_LUMINANCE_ALPHA_3DC_ATI, Format::Latc2),
    ],
};

/// The compressed formats that serve any texture, which `GL_COMPRESSED_TEXTURE_FORMATS` lists: not
/// those of one bit of alpha (`EXT_texture_compression_s3tc`), for sRGB (`EXT_texture_sRGB`) or of
/// fewer channels (`ARB_texture_compression_rgtc`, `EXT_texture_compression_latc`).
pub(crate) fn general_purpose_formats() -> impl ExactSizeIterator<Item = GLenum> {
    const GENERAL: [GLenum; 3] = [
        GL_COMPRESSED_RGB_S3TC_DXT1_EXT,
        GL_COMPRESSED_RGBA_S3TC_DXT3_EXT,
        GL_COMPRESSED_RGBA_S3TC_DXT5_EXT,
    ];
    GENERAL.into_iter()
}

/// The numbers that `glTexImage` takes since GL 1.0.
const COMPONENTS: [(GLenum, Format); 4] =
    [(1, Format::L8), (2, Format::La8), (3, Format::Rgb8), (4, Format::Rgba8)];

/// The names that leave the size of their components open, which storage for good does not take
/// (`ARB_texture_storage`, section 3.8.X).
const UNSIZED: [GLenum; 32] = [
    GL_RED_SNORM,
    GL_RG_SNORM,
    GL_RGB_SNORM,
    GL_RGBA_SNORM,
    GL_ALPHA_SNORM,
    GL_LUMINANCE_SNORM,
    GL_LUMINANCE_ALPHA_SNORM,
    GL_INTENSITY_SNORM,
    GL_ALPHA,
    GL_LUMINANCE,
    GL_LUMINANCE_ALPHA,
    GL_INTENSITY,
    GL_RED,
    GL_RG,
    GL_RGB,
    GL_RGBA,
    GL_SRGB,
    GL_SRGB_ALPHA,
    GL_SLUMINANCE,
    GL_SLUMINANCE_ALPHA,
    GL_COMPRESSED_ALPHA,
    GL_COMPRESSED_LUMINANCE,
    GL_COMPRESSED_LUMINANCE_ALPHA,
    GL_COMPRESSED_INTENSITY,
    GL_COMPRESSED_RED,
    GL_COMPRESSED_RG,
    GL_COMPRESSED_RGB,
    GL_COMPRESSED_RGBA,
    GL_COMPRESSED_SRGB,
    GL_COMPRESSED_SRGB_ALPHA,
    GL_COMPRESSED_SLUMINANCE,
    GL_COMPRESSED_SLUMINANCE_ALPHA,
];

/// The format of storage for good: sized, specific.
pub(crate) fn sized_format(internal: GLenum) -> Option<Format> {
    if UNSIZED.contains(&internal) || [GL_DEPTH_COMPONENT, GL_DEPTH_STENCIL].contains(&internal) {
        return None;
    }
    INTERNAL_FORMAT.get(internal).or_else(|| COMPRESSED_FORMAT.get(internal))
}

/// GL's name of a format: the last that is stored so, which is the most exact.
pub(crate) fn format_name(format: Format) -> String {
    let rows = INTERNAL_FORMAT.rows.iter().chain(STENCIL_FORMAT.rows).chain(COMPRESSED_FORMAT.rows);
    rows.rev().find(|row| row.1 == format).map_or_else(String::new, |row| enum_name(row.0))
}

/// The format of a texture image; the numbers 1 to 4 count too.
pub(crate) fn texture_format(internal: GLenum) -> Option<Format> {
    let named = INTERNAL_FORMAT.get(internal).or_else(|| COMPRESSED_FORMAT.get(internal));
    named.or_else(|| {
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
        Component::Stencil => format.has_stencil(),
    };
    if component == Component::Stencil {
        return format.info().stencil.bits as i32;
    }
    let channel = match component {
        Component::Red | Component::Luminance | Component::Intensity => 0,
        Component::Depth | Component::Stencil => 0,
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
    Stencil,
}
