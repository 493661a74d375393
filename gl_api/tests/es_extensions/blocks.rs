//! Textures in blocks. The texels are those that the blocks' formulas give.

use crate::{Use, sampled, texture};
use gl_api::*;

pub const USES: &[Use] = &[
    ("EXT_texture_compression_bptc", |c| {
        assert_eq!(block(c, GL_COMPRESSED_RGBA_BPTC_UNORM, &bptc()), [255, 1, 1, 255]);
    }),
    ("EXT_texture_compression_dxt1", |c| {
        assert_eq!(block(c, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, &RED), [255, 0, 0, 255]);
        // The two colours are in ascending order, the texels are of the fourth: black, and transparent.
        let clear = [0, 0, 0x00, 0xF8, 0xFF, 0xFF, 0xFF, 0xFF];
        assert_eq!(block(c, GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, &clear), [0; 4]);
    }),
    ("EXT_texture_compression_rgtc", |c| {
        let channel = [0x5A, 0, 0, 0, 0, 0, 0, 0];
        assert_eq!(block(c, GL_COMPRESSED_RED_RGTC1_EXT, &channel), [0x5A, 0, 0, 255]);
        let both = [channel, [7, 0, 0, 0, 0, 0, 0, 0]].concat();
        assert_eq!(block(c, GL_COMPRESSED_RED_GREEN_RGTC2_EXT, &both), [0x5A, 7, 0, 255]);
    }),
    ("EXT_texture_compression_s3tc", |c| {
        let explicit = [[0x88; 8], RED].concat();
        assert_eq!(block(c, GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, &explicit), [255, 0, 0, 0x88]);
        let interpolated = [[0x80, 0, 0, 0, 0, 0, 0, 0], RED].concat();
        assert_eq!(block(c, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, &interpolated), [255, 0, 0, 0x80]);
    }),
    ("OES_compressed_ETC1_RGB8_texture", |c| {
        // Individual mode: both halves of base colour 8, 4, 2 of 15, of the first table; every texel adds its first, 2.
        let etc = [0x88, 0x44, 0x22, 0, 0, 0, 0, 0];
        assert_eq!(block(c, GL_ETC1_RGB8_OES, &etc), [0x8A, 0x46, 0x24, 255]);
    }),
];

/// Red, 5 bits of 31, is the first colour; all texels are of it.
const RED: [u8; 8] = [0x00, 0xF8, 0, 0, 0, 0, 0, 0];

/// Mode 6: one subset, endpoints of 7 bits (red and alpha 127, green and blue 0) and a lowest bit each, which is 1; all
/// indices are 0.
fn bptc() -> [u8; 16] {
    let ones = |count: u32| (1_u128 << count) - 1;
    (1_u128 << 6 | ones(14) << 7 | ones(14) << 49 | 1 << 63 | 1 << 64).to_le_bytes()
}

/// What is sampled of a texture of one block.
fn block(c: &mut Context, internal: GLenum, bytes: &[u8]) -> [u8; 4] {
    texture(c, GL_NEAREST);
    let size = bytes.len() as GLsizei;
    c.compressed_tex_image_2d(GL_TEXTURE_2D, 0, internal, 4, 4, 0, size, Data::Bytes(bytes));
    sampled(c)
}
