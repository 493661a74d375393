//! The classes of formats that views may have of each other's texels (GL 4.3, table 8.22;
//! `EXT_texture_compression_s3tc`).

use crate::base::constants::*;
use crate::base::types::*;
use std::slice;

const CLASSES: &[(GLenum, &[GLenum])] = &[
    (GL_VIEW_CLASS_128_BITS, &[GL_RGBA32F, GL_RGBA32UI, GL_RGBA32I]),
    (GL_VIEW_CLASS_96_BITS, &[GL_RGB32F, GL_RGB32UI, GL_RGB32I]),
    (
        GL_VIEW_CLASS_64_BITS,
        &[
            GL_RGBA16F,
            GL_RG32F,
            GL_RGBA16UI,
            GL_RG32UI,
            GL_RGBA16I,
            GL_RG32I,
            GL_RGBA16,
            GL_RGBA16_SNORM,
        ],
    ),
    (GL_VIEW_CLASS_48_BITS, &[GL_RGB16, GL_RGB16_SNORM, GL_RGB16F, GL_RGB16UI, GL_RGB16I]),
    (
        GL_VIEW_CLASS_32_BITS,
        &[
            GL_RG16F,
            GL_R11F_G11F_B10F,
            GL_R32F,
            GL_RGB10_A2UI,
            GL_RGBA8UI,
            GL_RG16UI,
            GL_R32UI,
            GL_RGBA8I,
            GL_RG16I,
            GL_R32I,
            GL_RGB10_A2,
            GL_RGBA8,
            GL_RG16,
            GL_RGBA8_SNORM,
            GL_RG16_SNORM,
            GL_SRGB8_ALPHA8,
            GL_RGB9_E5,
        ],
    ),
    (GL_VIEW_CLASS_24_BITS, &[GL_RGB8, GL_RGB8_SNORM, GL_SRGB8, GL_RGB8UI, GL_RGB8I]),
    (
        GL_VIEW_CLASS_16_BITS,
        &[
            GL_R16F,
            GL_RG8UI,
            GL_R16UI,
            GL_RG8I,
            GL_R16I,
            GL_RG8,
            GL_R16,
            GL_RG8_SNORM,
            GL_R16_SNORM,
        ],
    ),
    (GL_VIEW_CLASS_8_BITS, &[GL_R8UI, GL_R8I, GL_R8, GL_R8_SNORM]),
    (GL_VIEW_CLASS_RGTC1_RED, &[GL_COMPRESSED_RED_RGTC1, GL_COMPRESSED_SIGNED_RED_RGTC1]),
    (GL_VIEW_CLASS_RGTC2_RG, &[GL_COMPRESSED_RG_RGTC2, GL_COMPRESSED_SIGNED_RG_RGTC2]),
    (
        GL_VIEW_CLASS_BPTC_UNORM,
        &[GL_COMPRESSED_RGBA_BPTC_UNORM, GL_COMPRESSED_SRGB_ALPHA_BPTC_UNORM],
    ),
    (
        GL_VIEW_CLASS_BPTC_FLOAT,
        &[GL_COMPRESSED_RGB_BPTC_SIGNED_FLOAT, GL_COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT],
    ),
    (
        GL_VIEW_CLASS_S3TC_DXT1_RGB,
        &[GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_SRGB_S3TC_DXT1_EXT],
    ),
    (
        GL_VIEW_CLASS_S3TC_DXT1_RGBA,
        &[GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT],
    ),
    (
        GL_VIEW_CLASS_S3TC_DXT3_RGBA,
        &[GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT],
    ),
    (
        GL_VIEW_CLASS_S3TC_DXT5_RGBA,
        &[GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT],
    ),
];

fn row(internal: GLenum) -> Option<&'static (GLenum, &'static [GLenum])> {
    CLASSES.iter().find(|(_, formats)| formats.contains(&internal))
}

/// The class of an internal format, if it has one: others are compatible with themselves alone.
pub(crate) fn view_class(internal: GLenum) -> Option<GLenum> {
    row(internal).map(|(class, _)| *class)
}

/// The internal formats that a view of texels of this one may have.
pub(crate) fn viewed_as(internal: &GLenum) -> &[GLenum] {
    row(*internal).map_or(slice::from_ref(internal), |(_, formats)| formats)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pixel::formats::find;

    /// So that texels of one are texels of the others.
    #[test]
    fn formats_of_a_class_are_stored_in_as_many_bytes() {
        for (class, formats) in CLASSES {
            let stored = |name: &GLenum| find(*name).expect("there is a row").stored;
            let kind = |name| (stored(name).bytes(), stored(name).block_side());
            for name in *formats {
                assert_eq!(kind(name), kind(&formats[0]), "{}", enum_name(*class));
            }
        }
    }
}
