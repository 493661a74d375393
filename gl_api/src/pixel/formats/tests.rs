//! The table against the tables of the specifications, and its columns against each other.

use super::{ComponentType, FORMATS, FormatClass, InternalFormat, Renderable, find};
use crate::base::availability::{Api, Availability, Version};
use crate::base::constants::*;
use crate::base::es_extensions::EXTENSIONS_OF_ES;
use crate::base::types::*;
use crate::pixel::texel;
use crate::query::extensions::EXTENSIONS;
use std::collections::BTreeSet;
use texunit::format::{BaseFormat, Block, Encoding};

/// GL 3.3 core, section 3.8.1, "Required Texture Formats": of textures and renderbuffers.
#[rustfmt::skip]
const CORE_33: &[GLenum] = &[
    GL_RGBA32F, GL_RGBA32I, GL_RGBA32UI, GL_RGBA16, GL_RGBA16F, GL_RGBA16I, GL_RGBA16UI,
    GL_RGBA8, GL_RGBA8I, GL_RGBA8UI, GL_SRGB8_ALPHA8, GL_RGB10_A2, GL_RGB10_A2UI, GL_R11F_G11F_B10F,
    GL_RG32F, GL_RG32I, GL_RG32UI, GL_RG16, GL_RG16F, GL_RG16I, GL_RG16UI, GL_RG8, GL_RG8I, GL_RG8UI,
    GL_R32F, GL_R32I, GL_R32UI, GL_R16F, GL_R16I, GL_R16UI, GL_R16, GL_R8, GL_R8I, GL_R8UI,
    GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT16,
    GL_DEPTH32F_STENCIL8, GL_DEPTH24_STENCIL8,
];

/// The same, of textures alone.
#[rustfmt::skip]
const CORE_33_TEXTURES: &[GLenum] = &[
    GL_RGBA16_SNORM, GL_RGBA8_SNORM, GL_RGB32F, GL_RGB32I, GL_RGB32UI, GL_RGB16_SNORM, GL_RGB16F,
    GL_RGB16I, GL_RGB16UI, GL_RGB16, GL_RGB8_SNORM, GL_RGB8, GL_RGB8I, GL_RGB8UI, GL_SRGB8,
    GL_RGB9_E5, GL_RG16_SNORM, GL_RG8_SNORM, GL_COMPRESSED_RG_RGTC2, GL_COMPRESSED_SIGNED_RG_RGTC2,
    GL_R16_SNORM, GL_R8_SNORM, GL_COMPRESSED_RED_RGTC1, GL_COMPRESSED_SIGNED_RED_RGTC1,
];

/// OpenGL ES 2.0, table 4.5: formats of renderbuffers.
const ES_20_RENDERBUFFERS: &[GLenum] =
    &[GL_RGBA4, GL_RGB565, GL_RGB5_A1, GL_DEPTH_COMPONENT16, GL_STENCIL_INDEX8];

/// OpenGL ES 3.0, table 3.13: sized formats, and whether they are renderable (`r`) and filterable (`f`). Depth formats
/// are of table 3.14.
#[rustfmt::skip]
const ES_30: &[(GLenum, &str)] = &[
    (GL_R8, "rf"), (GL_R8_SNORM, "f"), (GL_RG8, "rf"), (GL_RG8_SNORM, "f"),
    (GL_RGB8, "rf"), (GL_RGB8_SNORM, "f"), (GL_RGB565, "rf"), (GL_RGBA4, "rf"),
    (GL_RGB5_A1, "rf"), (GL_RGBA8, "rf"), (GL_RGBA8_SNORM, "f"), (GL_RGB10_A2, "rf"),
    (GL_RGB10_A2UI, "r"), (GL_SRGB8, "f"), (GL_SRGB8_ALPHA8, "rf"),
    (GL_R16F, "f"), (GL_RG16F, "f"), (GL_RGB16F, "f"), (GL_RGBA16F, "f"),
    (GL_R32F, ""), (GL_RG32F, ""), (GL_RGB32F, ""), (GL_RGBA32F, ""),
    (GL_R11F_G11F_B10F, "f"), (GL_RGB9_E5, "f"),
    (GL_R8I, "r"), (GL_R8UI, "r"), (GL_R16I, "r"), (GL_R16UI, "r"), (GL_R32I, "r"), (GL_R32UI, "r"),
    (GL_RG8I, "r"), (GL_RG8UI, "r"), (GL_RG16I, "r"), (GL_RG16UI, "r"), (GL_RG32I, "r"),
    (GL_RG32UI, "r"), (GL_RGB8I, ""), (GL_RGB8UI, ""), (GL_RGB16I, ""), (GL_RGB16UI, ""),
    (GL_RGB32I, ""), (GL_RGB32UI, ""), (GL_RGBA8I, "r"), (GL_RGBA8UI, "r"), (GL_RGBA16I, "r"),
    (GL_RGBA16UI, "r"), (GL_RGBA32I, "r"), (GL_RGBA32UI, "r"),
    (GL_DEPTH_COMPONENT16, "r"), (GL_DEPTH_COMPONENT24, "r"), (GL_DEPTH_COMPONENT32F, "r"),
    (GL_DEPTH24_STENCIL8, "r"), (GL_DEPTH32F_STENCIL8, "r"),
];

/// The names for which one use is available.
fn names(
    of: impl Fn(&InternalFormat) -> Availability,
    api: Api,
    (major, minor): (u8, u8),
) -> BTreeSet<String> {
    let there = |format: &&InternalFormat| of(format).is_in(api, Version::new(major, minor));
    FORMATS.iter().filter(there).map(|format| enum_name(format.name)).collect()
}

fn set(names: impl IntoIterator<Item = GLenum>) -> BTreeSet<String> {
    names.into_iter().map(enum_name).collect()
}

#[test]
fn core_has_what_it_requires() {
    let textures = names(|format| format.texture, Api::Core, (3, 3));
    let required = set(CORE_33.iter().chain(CORE_33_TEXTURES).copied());
    assert_eq!(required.difference(&textures).collect::<Vec<_>>(), Vec::<&String>::new());
    let renderbuffers = names(|format| format.renderbuffer, Api::Core, (3, 3));
    let required = set(CORE_33.iter().copied());
    assert_eq!(required.difference(&renderbuffers).collect::<Vec<_>>(), Vec::<&String>::new());
    for format in FORMATS.iter().filter(|format| format.texture.core.is_some()) {
        let deprecated =
            matches!(format.base, GL_ALPHA | GL_LUMINANCE | GL_LUMINANCE_ALPHA | GL_INTENSITY);
        assert!(!deprecated, "{}", enum_name(format.name));
    }
}

#[test]
fn es_has_what_its_tables_say() {
    let renderbuffers = names(|format| format.renderbuffer, Api::Es2, (2, 0));
    assert_eq!(renderbuffers, set(ES_20_RENDERBUFFERS.iter().copied()));
    let unsized_formats = [GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA];
    for (api, version) in [(Api::Es1, (1, 0)), (Api::Es2, (2, 0))] {
        assert_eq!(names(|format| format.texture, api, version), set(unsized_formats));
    }
    let with = |flag| {
        let rows = ES_30.iter().filter(move |row| row.1.contains(flag));
        rows.map(|row| row.0)
    };
    let textures = names(|format| format.texture, Api::Es2, (3, 0));
    assert_eq!(textures, set(ES_30.iter().map(|row| row.0).chain(unsized_formats)));
    let renderbuffers = names(|format| format.renderbuffer, Api::Es2, (3, 0));
    assert_eq!(renderbuffers, set(with('r').chain([GL_STENCIL_INDEX8])));
    let filtered = names(|format| format.filter, Api::Es2, (3, 0));
    assert_eq!(filtered, set(with('f').chain(unsized_formats)));
}

#[test]
fn contexts_have_every_format_by_version_or_by_an_extension_that_they_name() {
    for format in FORMATS {
        let name = enum_name(format.name);
        assert!(format.is_for_textures() || format.is_for_renderbuffers(), "{name}");
        for used in [format.texture, format.renderbuffer, format.filter, format.texel_buffer] {
            for extension in used.extensions {
                let is_claimed = EXTENSIONS.contains(&extension.name)
                    || EXTENSIONS_OF_ES.contains(&extension.name);
                assert!(is_claimed, "{name}: {}", extension.name);
            }
        }
    }
}

#[test]
fn every_format_stands_once() {
    let unique: BTreeSet<GLenum> = FORMATS.iter().map(|format| format.name).collect();
    assert_eq!(unique.len(), FORMATS.len());
    assert!(find(GL_RGBA8).is_some_and(|format| format.name == GL_RGBA8));
}

#[test]
fn columns_agree_with_what_is_stored() {
    for format in FORMATS {
        let name = enum_name(format.name);
        let base = match format.stored.base() {
            BaseFormat::Alpha => GL_ALPHA,
            BaseFormat::Luminance => GL_LUMINANCE,
            BaseFormat::LuminanceAlpha => GL_LUMINANCE_ALPHA,
            BaseFormat::Intensity => GL_INTENSITY,
            BaseFormat::Red => GL_RED,
            BaseFormat::Rg => GL_RG,
            BaseFormat::Rgb => GL_RGB,
            BaseFormat::Rgba => GL_RGBA,
            BaseFormat::Depth if format.renderable == Renderable::Stencil => GL_STENCIL_INDEX,
            BaseFormat::Depth if format.stored.has_stencil() => GL_DEPTH_STENCIL,
            BaseFormat::Depth => GL_DEPTH_COMPONENT,
        };
        assert_eq!(format.base, base, "{name}");
        let components = match format.stored.info().encoding {
            // Fractions of 32 bits are stored as floats.
            Encoding::Float if format.name == GL_DEPTH_COMPONENT32 => ComponentType::Unorm,
            Encoding::Unorm if format.renderable == Renderable::Stencil => ComponentType::Uint,
            Encoding::Unorm | Encoding::Srgb | Encoding::SrgbBlock(_) => ComponentType::Unorm,
            Encoding::Block(Block::Rgtc1Snorm | Block::Rgtc2Snorm) => ComponentType::Snorm,
            Encoding::Block(Block::BptcUnsignedFloat | Block::BptcSignedFloat) => {
                ComponentType::Float
            }
            Encoding::Block(_) => ComponentType::Unorm,
            Encoding::Snorm => ComponentType::Snorm,
            Encoding::Float | Encoding::SharedExponent => ComponentType::Float,
            Encoding::Uint => ComponentType::Uint,
            Encoding::Sint => ComponentType::Sint,
        };
        assert_eq!(format.components, components, "{name}");
        let renderable = match format.base {
            _ if !texel::is_renderable(format.stored) => Renderable::No,
            GL_STENCIL_INDEX => Renderable::Stencil,
            GL_DEPTH_STENCIL => Renderable::DepthStencil,
            GL_DEPTH_COMPONENT => Renderable::Depth,
            _ => Renderable::Color,
        };
        assert_eq!(format.renderable, renderable, "{name}");
        assert_eq!(format.is_compressed(), format.stored.block().is_some(), "{name}");
        let generic = format.class == FormatClass::GenericCompressed;
        assert!(!generic || find(format.base).is_some(), "{name}");
    }
}
