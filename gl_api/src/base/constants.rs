//! Every `GL_*` constant, from the Khronos registry.

#![allow(non_upper_case_globals, reason = "the registry's own names, such as ASTC_4x4")]

include!(concat!(env!("OUT_DIR"), "/constants.rs"));

/// `GL_2_BYTES`, 0x1407, which no version of the registry requires.
pub const GL_2_BYTES: u32 = 0x1407;
/// `GL_3_BYTES`, 0x1408, which no version of the registry requires.
pub const GL_3_BYTES: u32 = 0x1408;
/// `GL_4_BYTES`, 0x1409, which no version of the registry requires.
pub const GL_4_BYTES: u32 = 0x1409;

/// `GL_2D`, 0x0600, which no version of the registry requires.
pub const GL_2D: u32 = 0x0600;
/// `GL_3D`, 0x0601, as [`GL_2D`].
pub const GL_3D: u32 = 0x0601;
/// `GL_3D_COLOR`, 0x0602, as [`GL_2D`].
pub const GL_3D_COLOR: u32 = 0x0602;
/// `GL_3D_COLOR_TEXTURE`, 0x0603, as [`GL_2D`].
pub const GL_3D_COLOR_TEXTURE: u32 = 0x0603;
/// `GL_4D_COLOR_TEXTURE`, 0x0604, as [`GL_2D`].
pub const GL_4D_COLOR_TEXTURE: u32 = 0x0604;

/// `GL_COMPRESSED_LUMINANCE_ALPHA_3DC_ATI` of `ATI_texture_compression_3dc`, which the registry
/// lists under no extension.
pub const GL_COMPRESSED_LUMINANCE_ALPHA_3DC_ATI: u32 = 0x8837;

/// The name of a value for messages: `GL_TEXTURE_2D`; a number where no name is known or where
/// the value is so small that a name says nothing.
pub fn enum_name(value: u32) -> String {
    match VALUES.binary_search_by_key(&value, |row| row.0) {
        Ok(row) if value > 0xff => {
            let end = VALUES.get(row + 1).map_or(NAMES.len(), |next| next.1 as usize);
            format!("GL_{}", &NAMES[VALUES[row].1 as usize..end])
        }
        _ if value > 9 => format!("{value:#06x}"),
        _ => value.to_string(),
    }
}
