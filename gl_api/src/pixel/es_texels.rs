//! What OpenGL ES stores for the pixels of a call: the combinations of `internalformat`, `format` and `type` that it has
//! (OpenGL ES 3.0, tables 3.2 and 3.3, and extensions).

use crate::base::constants::*;
use crate::base::error::{Result, invalid_operation, invalid_value};
use crate::base::types::*;
use crate::pixel::formats::{self, FormatClass};
use texunit::format::Format::{self, *};

const SECTION: &str = "OpenGL ES 3.0, table 3.2";

/// Sized internal formats (table 3.2; the last five of `OES_required_internalformat`, table 3.4.x): the `format` and the values of `type` that go with each.
#[rustfmt::skip]
const SIZED: &[(GLenum, GLenum, &[GLenum])] = &[
    (GL_RGBA8, GL_RGBA, &[GL_UNSIGNED_BYTE]),
    (GL_RGB5_A1, GL_RGBA, &[GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT_5_5_5_1, GL_UNSIGNED_INT_2_10_10_10_REV]),
    (GL_RGBA4, GL_RGBA, &[GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT_4_4_4_4]),
    (GL_SRGB8_ALPHA8, GL_RGBA, &[GL_UNSIGNED_BYTE]),
    (GL_RGBA8_SNORM, GL_RGBA, &[GL_BYTE]),
    (GL_RGB10_A2, GL_RGBA, &[GL_UNSIGNED_INT_2_10_10_10_REV]),
    (GL_RGBA16F, GL_RGBA, &[GL_HALF_FLOAT, GL_FLOAT]),
    (GL_RGBA32F, GL_RGBA, &[GL_FLOAT]),
    (GL_RGBA8UI, GL_RGBA_INTEGER, &[GL_UNSIGNED_BYTE]),
    (GL_RGBA8I, GL_RGBA_INTEGER, &[GL_BYTE]),
    (GL_RGBA16UI, GL_RGBA_INTEGER, &[GL_UNSIGNED_SHORT]),
    (GL_RGBA16I, GL_RGBA_INTEGER, &[GL_SHORT]),
    (GL_RGBA32UI, GL_RGBA_INTEGER, &[GL_UNSIGNED_INT]),
    (GL_RGBA32I, GL_RGBA_INTEGER, &[GL_INT]),
    (GL_RGB10_A2UI, GL_RGBA_INTEGER, &[GL_UNSIGNED_INT_2_10_10_10_REV]),
    (GL_RGB8, GL_RGB, &[GL_UNSIGNED_BYTE]),
    (GL_RGB565, GL_RGB, &[GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT_5_6_5]),
    (GL_SRGB8, GL_RGB, &[GL_UNSIGNED_BYTE]),
    (GL_RGB8_SNORM, GL_RGB, &[GL_BYTE]),
    (GL_R11F_G11F_B10F, GL_RGB, &[GL_UNSIGNED_INT_10F_11F_11F_REV, GL_HALF_FLOAT, GL_FLOAT]),
    (GL_RGB9_E5, GL_RGB, &[GL_UNSIGNED_INT_5_9_9_9_REV, GL_HALF_FLOAT, GL_FLOAT]),
    (GL_RGB16F, GL_RGB, &[GL_HALF_FLOAT, GL_FLOAT]),
    (GL_RGB32F, GL_RGB, &[GL_FLOAT]),
    (GL_RGB8UI, GL_RGB_INTEGER, &[GL_UNSIGNED_BYTE]),
    (GL_RGB8I, GL_RGB_INTEGER, &[GL_BYTE]),
    (GL_RGB16UI, GL_RGB_INTEGER, &[GL_UNSIGNED_SHORT]),
    (GL_RGB16I, GL_RGB_INTEGER, &[GL_SHORT]),
    (GL_RGB32UI, GL_RGB_INTEGER, &[GL_UNSIGNED_INT]),
    (GL_RGB32I, GL_RGB_INTEGER, &[GL_INT]),
    (GL_RG8, GL_RG, &[GL_UNSIGNED_BYTE]),
    (GL_RG8_SNORM, GL_RG, &[GL_BYTE]),
    (GL_RG16F, GL_RG, &[GL_HALF_FLOAT, GL_FLOAT]),
    (GL_RG32F, GL_RG, &[GL_FLOAT]),
    (GL_RG8UI, GL_RG_INTEGER, &[GL_UNSIGNED_BYTE]),
    (GL_RG8I, GL_RG_INTEGER, &[GL_BYTE]),
    (GL_RG16UI, GL_RG_INTEGER, &[GL_UNSIGNED_SHORT]),
    (GL_RG16I, GL_RG_INTEGER, &[GL_SHORT]),
    (GL_RG32UI, GL_RG_INTEGER, &[GL_UNSIGNED_INT]),
    (GL_RG32I, GL_RG_INTEGER, &[GL_INT]),
    (GL_R8, GL_RED, &[GL_UNSIGNED_BYTE]),
    (GL_R8_SNORM, GL_RED, &[GL_BYTE]),
    (GL_R16F, GL_RED, &[GL_HALF_FLOAT, GL_FLOAT]),
    (GL_R32F, GL_RED, &[GL_FLOAT]),
    (GL_R8UI, GL_RED_INTEGER, &[GL_UNSIGNED_BYTE]),
    (GL_R8I, GL_RED_INTEGER, &[GL_BYTE]),
    (GL_R16UI, GL_RED_INTEGER, &[GL_UNSIGNED_SHORT]),
    (GL_R16I, GL_RED_INTEGER, &[GL_SHORT]),
    (GL_R32UI, GL_RED_INTEGER, &[GL_UNSIGNED_INT]),
    (GL_R32I, GL_RED_INTEGER, &[GL_INT]),
    (GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, &[GL_UNSIGNED_SHORT, GL_UNSIGNED_INT]),
    (GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, &[GL_UNSIGNED_INT]),
    (GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, &[GL_FLOAT]),
    (GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, &[GL_UNSIGNED_INT_24_8]),
    (GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, &[GL_FLOAT_32_UNSIGNED_INT_24_8_REV]),
    (GL_ALPHA8, GL_ALPHA, &[GL_UNSIGNED_BYTE]),
    (GL_LUMINANCE8, GL_LUMINANCE, &[GL_UNSIGNED_BYTE]),
    (GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, &[GL_UNSIGNED_BYTE]),
    (GL_LUMINANCE4_ALPHA4, GL_LUMINANCE_ALPHA, &[GL_UNSIGNED_BYTE]),
    (GL_RGB10, GL_RGB, &[GL_UNSIGNED_INT_2_10_10_10_REV]),
];

/// Formats of blocks that pixels are compressed to (`EXT_texture_compression_bptc`).
#[rustfmt::skip]
const COMPRESSED: &[(GLenum, GLenum, &[GLenum])] = &[
    (GL_COMPRESSED_RGBA_BPTC_UNORM, GL_RGBA, &[GL_UNSIGNED_BYTE]),
    (GL_COMPRESSED_SRGB_ALPHA_BPTC_UNORM, GL_RGBA, &[GL_UNSIGNED_BYTE]),
    (GL_COMPRESSED_RGB_BPTC_SIGNED_FLOAT, GL_RGB, &[GL_HALF_FLOAT, GL_FLOAT]),
    (GL_COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT, GL_RGB, &[GL_HALF_FLOAT, GL_FLOAT]),
];

/// Unsized internal formats, whose `format` is the same (table 3.3; `OES_texture_float`, `OES_texture_half_float`,
/// `EXT_texture_rg`, `OES_depth_texture`, `OES_packed_depth_stencil`, `EXT_texture_type_2_10_10_10_REV`,
/// `EXT_texture_format_BGRA8888`, `EXT_sRGB`): the `type`, and what is stored.
#[rustfmt::skip]
const UNSIZED: &[(GLenum, GLenum, Format)] = &[
    (GL_RGBA, GL_UNSIGNED_BYTE, Rgba8),
    (GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, Rgba8),
    (GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, Rgba8),
    (GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, Rgb10A2),
    (GL_RGBA, GL_FLOAT, Rgba32F),
    (GL_RGBA, GL_HALF_FLOAT, Rgba16F),
    (GL_RGB, GL_UNSIGNED_BYTE, Rgb8),
    (GL_RGB, GL_UNSIGNED_SHORT_5_6_5, Rgb8),
    (GL_RGB, GL_UNSIGNED_INT_2_10_10_10_REV, Rgb10),
    (GL_RGB, GL_FLOAT, Rgb32F),
    (GL_RGB, GL_HALF_FLOAT, Rgb16F),
    (GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, La8),
    (GL_LUMINANCE_ALPHA, GL_FLOAT, La32F),
    (GL_LUMINANCE_ALPHA, GL_HALF_FLOAT, La16F),
    (GL_LUMINANCE, GL_UNSIGNED_BYTE, L8),
    (GL_LUMINANCE, GL_FLOAT, L32F),
    (GL_LUMINANCE, GL_HALF_FLOAT, L16F),
    (GL_ALPHA, GL_UNSIGNED_BYTE, A8),
    (GL_ALPHA, GL_FLOAT, A32F),
    (GL_ALPHA, GL_HALF_FLOAT, A16F),
    (GL_RED, GL_UNSIGNED_BYTE, R8),
    (GL_RED, GL_FLOAT, R32F),
    (GL_RED, GL_HALF_FLOAT, R16F),
    (GL_RG, GL_UNSIGNED_BYTE, Rg8),
    (GL_RG, GL_FLOAT, Rg32F),
    (GL_RG, GL_HALF_FLOAT, Rg16F),
    (GL_BGRA, GL_UNSIGNED_BYTE, Rgba8),
    (GL_SRGB, GL_UNSIGNED_BYTE, Srgb8),
    (GL_SRGB_ALPHA, GL_UNSIGNED_BYTE, Srgb8A8),
    (GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, D16),
    (GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, D24),
    (GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, D24S8),
];

/// `type` without the name that `OES_texture_half_float` and `OES_vertex_half_float` have for half floats.
pub(crate) fn plain_type(ty: GLenum) -> GLenum {
    if ty == GL_HALF_FLOAT_OES { GL_HALF_FLOAT } else { ty }
}

/// The order of components of `format`: `EXT_sRGB` has names of its own for texels of sRGB.
pub(crate) fn plain_format(format: GLenum) -> GLenum {
    match format {
        GL_SRGB => GL_RGB,
        GL_SRGB_ALPHA => GL_RGBA,
        _ => format,
    }
}

/// What is stored of an image that `glTexImage` specifies.
///
/// # Errors
/// `GL_INVALID_VALUE` for an internal format that OpenGL ES does not have, `GL_INVALID_OPERATION` for a combination that
/// it does not have.
pub(crate) fn stored(internal: GLenum, format: GLenum, ty: GLenum) -> Result<Format> {
    let ty = plain_type(ty);
    if let Some(row) = SIZED.iter().chain(COMPRESSED).find(|row| row.0 == internal) {
        check_sized(row, format, ty)?;
        return match formats::texture_format(internal) {
            Some(stored) => Ok(stored),
            None => invalid_value(SECTION, format!("internalformat = {}", enum_name(internal))),
        };
    }
    let mut rows = UNSIZED.iter().filter(|row| row.0 == internal).peekable();
    if rows.peek().is_none() {
        let rule = format!(
            "internalformat = {} is none that glTexImage takes in OpenGL ES: name one as GL_RGBA8, or GL_RGBA",
            enum_name(internal)
        );
        return invalid_value(SECTION, rule);
    }
    match rows.find(|row| row.1 == ty && internal == format) {
        Some(row) => Ok(row.2),
        None => {
            let types = UNSIZED.iter().filter(|row| row.0 == internal).map(|row| row.1);
            let types: Vec<String> = types.map(enum_name).collect();
            refused(internal, (format, ty), internal, &types)
        }
    }
}

fn check_sized(
    &(internal, expected, types): &(GLenum, GLenum, &[GLenum]),
    format: GLenum,
    ty: GLenum,
) -> Result<()> {
    if format == expected && types.contains(&ty) {
        return Ok(());
    }
    let types: Vec<String> = types.iter().copied().map(enum_name).collect();
    refused(internal, (format, ty), expected, &types)
}

#[cold]
fn refused<T>(
    internal: GLenum,
    (format, ty): (GLenum, GLenum),
    expected: GLenum,
    types: &[String],
) -> Result<T> {
    let [internal, format, ty, expected] = [internal, format, ty, expected].map(enum_name);
    let types = types.join(" or ");
    let rule = format!(
        "format = {format} and type = {ty} do not go with {internal}, which takes {expected} with {types}"
    );
    invalid_operation(SECTION, rule)
}

/// Checks that pixels can overwrite texels of an image: not in blocks.
///
/// # Errors
/// `GL_INVALID_OPERATION`.
pub(crate) fn check_copied(internal: GLenum) -> Result<()> {
    let mut names = SIZED.iter().map(|row| row.0).chain(UNSIZED.iter().map(|row| row.0));
    if names.any(|name| name == internal) {
        return Ok(());
    }
    let rule = format!("the level is of {}, which takes blocks alone", enum_name(internal));
    invalid_operation(SECTION, rule)
}

/// Checks the pixels of a call that overwrites texels of an image.
///
/// # Errors
/// `GL_INVALID_OPERATION` for pixels that `glTexImage` would not take for that internal format.
pub(crate) fn check_replaced(internal: GLenum, format: GLenum, ty: GLenum) -> Result<()> {
    check_copied(internal)?;
    stored(internal, format, ty).map(|_| ())
}

/// Whether images that were asked for so are drawn to (OpenGL ES 3.0, section 4.4.4): what the types of extensions make of
/// unsized colours is not (`OES_texture_float`, `EXT_texture_type_2_10_10_10_REV`), nor is sRGB without alpha (`EXT_sRGB`).
pub(crate) fn is_drawn_to(internal: GLenum, stored: Format) -> bool {
    let by_type = [Rgba32F, Rgb32F, Rgb10A2, Rgb10].contains(&stored);
    if by_type && [GL_RGBA, GL_RGB].contains(&internal) || internal == GL_SRGB {
        return false;
    }
    [GL_BGRA, GL_SRGB_ALPHA].contains(&internal)
        || formats::find(internal).is_some_and(|format| format.is_drawn_to_in_es())
}

/// Whether the levels of a mipmap can be made from an image (OpenGL ES 3.0, section 3.8.10.5): of an unsized format, or
/// of one that can be drawn to and is filtered; not of the unsized ones of sRGB (`EXT_sRGB`).
pub(crate) fn has_mipmaps(internal: GLenum) -> bool {
    let Some(format) = formats::find(internal) else { return internal == GL_BGRA };
    let is_depth = matches!(format.base, GL_DEPTH_COMPONENT | GL_DEPTH_STENCIL);
    let sized = format.class == FormatClass::Sized;
    !is_depth
        && ![GL_SRGB, GL_SRGB_ALPHA].contains(&internal)
        && !format.is_compressed()
        && (!sized || format.is_drawn_to_in_es() && format.is_filtered_in_es())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sized_format_of_the_table_is_one_of_textures() {
        for (internal, format, types) in SIZED.iter().chain(COMPRESSED) {
            for ty in *types {
                assert!(stored(*internal, *format, *ty).is_ok(), "{}", enum_name(*internal));
            }
        }
        assert_eq!(SIZED.len(), 59);
    }

    #[test]
    fn combinations_are_those_of_the_tables() {
        let refused = [
            (GL_RGBA, GL_RGB, GL_UNSIGNED_BYTE),
            (GL_RGBA, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5),
            (GL_RGBA8, GL_RGBA, GL_FLOAT),
            (GL_RGBA32F, GL_RGBA, GL_HALF_FLOAT),
            (GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT),
            (GL_R16, GL_RED, GL_UNSIGNED_SHORT),
        ];
        for (internal, format, ty) in refused {
            assert!(stored(internal, format, ty).is_err(), "{}", enum_name(internal));
        }
        assert_eq!(stored(GL_RGBA, GL_RGBA, GL_HALF_FLOAT_OES).ok(), Some(Rgba16F));
        assert!(has_mipmaps(GL_RGBA) && has_mipmaps(GL_LUMINANCE) && has_mipmaps(GL_RGBA16F));
        assert!(!has_mipmaps(GL_RGBA8UI) && !has_mipmaps(GL_RGB9_E5));
        assert!(!has_mipmaps(GL_DEPTH_COMPONENT16));
    }
}
