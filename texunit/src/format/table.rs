//! The table: one row per format, `Name: layout(base, encoding, …)`.

use super::layout::Block::{
    Bptc, BptcSignedFloat, BptcUnsignedFloat, Dxt1, Dxt3, Dxt5, Rgtc1, Rgtc1Snorm, Rgtc2,
    Rgtc2Snorm,
};
use super::{BaseFormat, Encoding, Field, FormatInfo};
use BaseFormat::{Alpha, Intensity, Luminance, LuminanceAlpha, Red, Rg, Rgb, Rgba};
use Encoding::{Block, Float, SharedExponent, Sint, Snorm, Srgb, SrgbBlock, Uint, Unorm};

/// The place of a channel that a packed format lacks.
const NONE: (u32, u32) = (0, 0);

macro_rules! formats {
    ($($(#[$doc:meta])* $Name:ident: $row:expr,)*) => {
        /// How a texel is stored. The number is the width of a channel in bits; `I` and `UI` are
        /// integers, `F` is a float.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Format {
            $($(#[$doc])* $Name,)*
        }

        impl Format {
            /// Every format, in the order of the table.
            pub const ALL: [Self; [$(stringify!($Name)),*].len()] = [$(Self::$Name,)*];

            /// The row of this format.
            #[inline(always)]
            pub const fn info(self) -> FormatInfo {
                ROWS[self as usize]
            }

            /// Where a stored channel is. (The row would be copied, to be indexed.)
            #[inline(always)]
            pub const fn field(self, channel: usize) -> Field {
                ROWS[self as usize].fields[channel]
            }
        }

        // One table: a constant would be copied into whatever reads it.
        static ROWS: [FormatInfo; Format::ALL.len()] = {
            use FormatInfo as Row;
            [$($row,)*]
        };
    };
}

formats! {
    /// A byte of alpha.
    A8: Row::uniform(Alpha, Unorm, 8),
    /// A byte of luminance.
    L8: Row::uniform(Luminance, Unorm, 8),
    /// A byte each of luminance and alpha.
    La8: Row::uniform(LuminanceAlpha, Unorm, 8),
    /// A byte of intensity.
    I8: Row::uniform(Intensity, Unorm, 8),
    /// A byte of red.
    R8: Row::uniform(Red, Unorm, 8),
    /// A byte each of red and green.
    Rg8: Row::uniform(Rg, Unorm, 8),
    /// A byte each of red, green and blue.
    Rgb8: Row::uniform(Rgb, Unorm, 8),
    /// A byte each of red, green, blue and alpha.
    Rgba8: Row::uniform(Rgba, Unorm, 8),
    /// sRGB-encoded red, green and blue.
    Srgb8: Row::uniform(Rgb, Srgb, 8),
    /// sRGB-encoded red, green and blue, and linear alpha.
    Srgb8A8: Row::uniform(Rgba, Srgb, 8),
    /// sRGB-encoded luminance.
    Sl8: Row::uniform(Luminance, Srgb, 8),
    /// sRGB-encoded luminance, and linear alpha.
    Sl8A8: Row::uniform(LuminanceAlpha, Srgb, 8),
    /// 16 bits of alpha.
    A16: Row::uniform(Alpha, Unorm, 16),
    /// 16 bits of luminance.
    L16: Row::uniform(Luminance, Unorm, 16),
    /// 16 bits each of luminance and alpha.
    La16: Row::uniform(LuminanceAlpha, Unorm, 16),
    /// 16 bits of intensity.
    I16: Row::uniform(Intensity, Unorm, 16),
    /// 16 bits of red.
    R16: Row::uniform(Red, Unorm, 16),
    /// 16 bits each of red and green.
    Rg16: Row::uniform(Rg, Unorm, 16),
    /// 16 bits each of red, green and blue.
    Rgb16: Row::uniform(Rgb, Unorm, 16),
    /// 16 bits each of red, green, blue and alpha.
    Rgba16: Row::uniform(Rgba, Unorm, 16),
    /// Red in the top 3 bits of a byte, green, and blue in the lowest 2.
    R3G3B2: Row::packed(Rgb, Unorm, 1, [(5, 3), (2, 3), (0, 2), NONE]),
    /// Red in the top 5 bits of 16, green in 6, blue in the lowest 5. Also holds `GL_RGB4` and
    /// `GL_RGB5`.
    R5G6B5: Row::packed(Rgb, Unorm, 2, [(11, 5), (5, 6), (0, 5), NONE]),
    /// Four bits each, red the highest. Also holds `GL_RGBA2`.
    Rgba4: Row::packed(Rgba, Unorm, 2, [(12, 4), (8, 4), (4, 4), (0, 4)]),
    /// Five bits each of red, green, blue, red the highest, and alpha in the lowest.
    Rgb5A1: Row::packed(Rgba, Unorm, 2, [(11, 5), (6, 5), (1, 5), (0, 1)]),
    /// Ten bits each of red, green, blue, red the lowest; two are not used.
    Rgb10: Row::packed(Rgb, Unorm, 4, [(0, 10), (10, 10), (20, 10), NONE]),
    /// Ten bits each of red, green, blue, red the lowest, and two of alpha.
    Rgb10A2: Row::packed(Rgba, Unorm, 4, [(0, 10), (10, 10), (20, 10), (30, 2)]),
    /// A signed normalized byte of red.
    R8Snorm: Row::uniform(Red, Snorm, 8),
    /// A signed normalized byte each of red and green.
    Rg8Snorm: Row::uniform(Rg, Snorm, 8),
    /// A signed normalized byte each of red, green and blue.
    Rgb8Snorm: Row::uniform(Rgb, Snorm, 8),
    /// A signed normalized byte each of red, green, blue and alpha.
    Rgba8Snorm: Row::uniform(Rgba, Snorm, 8),
    /// 16 signed normalized bits of red.
    R16Snorm: Row::uniform(Red, Snorm, 16),
    /// 16 signed normalized bits each of red and green.
    Rg16Snorm: Row::uniform(Rg, Snorm, 16),
    /// 16 signed normalized bits each of red, green and blue.
    Rgb16Snorm: Row::uniform(Rgb, Snorm, 16),
    /// 16 signed normalized bits each of red, green, blue and alpha.
    Rgba16Snorm: Row::uniform(Rgba, Snorm, 16),
    /// 8 signed normalized bits of alpha.
    A8Snorm: Row::uniform(Alpha, Snorm, 8),
    /// 16 signed normalized bits of alpha.
    A16Snorm: Row::uniform(Alpha, Snorm, 16),
    /// 8 signed normalized bits of luminance.
    L8Snorm: Row::uniform(Luminance, Snorm, 8),
    /// 16 signed normalized bits of luminance.
    L16Snorm: Row::uniform(Luminance, Snorm, 16),
    /// 8 signed normalized bits each of luminance and alpha.
    La8Snorm: Row::uniform(LuminanceAlpha, Snorm, 8),
    /// 16 signed normalized bits each of luminance and alpha.
    La16Snorm: Row::uniform(LuminanceAlpha, Snorm, 16),
    /// 8 signed normalized bits of intensity.
    I8Snorm: Row::uniform(Intensity, Snorm, 8),
    /// 16 signed normalized bits of intensity.
    I16Snorm: Row::uniform(Intensity, Snorm, 16),
    /// A half float of alpha.
    A16F: Row::uniform(Alpha, Float, 16),
    /// A half float of luminance.
    L16F: Row::uniform(Luminance, Float, 16),
    /// A half float each of luminance and alpha.
    La16F: Row::uniform(LuminanceAlpha, Float, 16),
    /// A half float of intensity.
    I16F: Row::uniform(Intensity, Float, 16),
    /// A half float of red.
    R16F: Row::uniform(Red, Float, 16),
    /// A half float each of red and green.
    Rg16F: Row::uniform(Rg, Float, 16),
    /// A half float each of red, green and blue.
    Rgb16F: Row::uniform(Rgb, Float, 16),
    /// A half float each of red, green, blue and alpha.
    Rgba16F: Row::uniform(Rgba, Float, 16),
    /// An `f32` of alpha.
    A32F: Row::uniform(Alpha, Float, 32),
    /// An `f32` of luminance.
    L32F: Row::uniform(Luminance, Float, 32),
    /// An `f32` each of luminance and alpha.
    La32F: Row::uniform(LuminanceAlpha, Float, 32),
    /// An `f32` of intensity.
    I32F: Row::uniform(Intensity, Float, 32),
    /// An `f32` of red.
    R32F: Row::uniform(Red, Float, 32),
    /// An `f32` each of red and green.
    Rg32F: Row::uniform(Rg, Float, 32),
    /// An `f32` each of red, green and blue.
    Rgb32F: Row::uniform(Rgb, Float, 32),
    /// An `f32` each of red, green, blue and alpha.
    Rgba32F: Row::uniform(Rgba, Float, 32),
    /// Unsigned floats: 11 bits each of red and green, red the lowest, 10 of blue.
    R11G11B10F: Row::packed(Rgb, Float, 4, [(0, 11), (11, 11), (22, 10), NONE]),
    /// Mantissas of 9 bits, red the lowest, and one exponent above them.
    Rgb9E5: Row::packed(Rgb, SharedExponent, 4, [(0, 9), (9, 9), (18, 9), NONE]),
    /// An unsigned integer of 8 bits of red.
    R8UI: Row::uniform(Red, Uint, 8),
    /// An unsigned integer of 8 bits each of red and green.
    Rg8UI: Row::uniform(Rg, Uint, 8),
    /// An unsigned integer of 8 bits each of red, green and blue.
    Rgb8UI: Row::uniform(Rgb, Uint, 8),
    /// An unsigned integer of 8 bits each of red, green, blue and alpha.
    Rgba8UI: Row::uniform(Rgba, Uint, 8),
    /// A signed integer of 8 bits of red.
    R8I: Row::uniform(Red, Sint, 8),
    /// A signed integer of 8 bits each of red and green.
    Rg8I: Row::uniform(Rg, Sint, 8),
    /// A signed integer of 8 bits each of red, green and blue.
    Rgb8I: Row::uniform(Rgb, Sint, 8),
    /// A signed integer of 8 bits each of red, green, blue and alpha.
    Rgba8I: Row::uniform(Rgba, Sint, 8),
    /// An unsigned integer of 16 bits of red.
    R16UI: Row::uniform(Red, Uint, 16),
    /// An unsigned integer of 16 bits each of red and green.
    Rg16UI: Row::uniform(Rg, Uint, 16),
    /// An unsigned integer of 16 bits each of red, green and blue.
    Rgb16UI: Row::uniform(Rgb, Uint, 16),
    /// An unsigned integer of 16 bits each of red, green, blue and alpha.
    Rgba16UI: Row::uniform(Rgba, Uint, 16),
    /// A signed integer of 16 bits of red.
    R16I: Row::uniform(Red, Sint, 16),
    /// A signed integer of 16 bits each of red and green.
    Rg16I: Row::uniform(Rg, Sint, 16),
    /// A signed integer of 16 bits each of red, green and blue.
    Rgb16I: Row::uniform(Rgb, Sint, 16),
    /// A signed integer of 16 bits each of red, green, blue and alpha.
    Rgba16I: Row::uniform(Rgba, Sint, 16),
    /// An unsigned integer of 32 bits of red.
    R32UI: Row::uniform(Red, Uint, 32),
    /// An unsigned integer of 32 bits each of red and green.
    Rg32UI: Row::uniform(Rg, Uint, 32),
    /// An unsigned integer of 32 bits each of red, green and blue.
    Rgb32UI: Row::uniform(Rgb, Uint, 32),
    /// An unsigned integer of 32 bits each of red, green, blue and alpha.
    Rgba32UI: Row::uniform(Rgba, Uint, 32),
    /// A signed integer of 32 bits of red.
    R32I: Row::uniform(Red, Sint, 32),
    /// A signed integer of 32 bits each of red and green.
    Rg32I: Row::uniform(Rg, Sint, 32),
    /// A signed integer of 32 bits each of red, green and blue.
    Rgb32I: Row::uniform(Rgb, Sint, 32),
    /// A signed integer of 32 bits each of red, green, blue and alpha.
    Rgba32I: Row::uniform(Rgba, Sint, 32),
    /// An unsigned integer of 8 bits of alpha.
    A8UI: Row::uniform(Alpha, Uint, 8),
    /// A signed integer of 8 bits of alpha.
    A8I: Row::uniform(Alpha, Sint, 8),
    /// An unsigned integer of 16 bits of alpha.
    A16UI: Row::uniform(Alpha, Uint, 16),
    /// A signed integer of 16 bits of alpha.
    A16I: Row::uniform(Alpha, Sint, 16),
    /// An unsigned integer of 32 bits of alpha.
    A32UI: Row::uniform(Alpha, Uint, 32),
    /// A signed integer of 32 bits of alpha.
    A32I: Row::uniform(Alpha, Sint, 32),
    /// An unsigned integer of 8 bits of luminance.
    L8UI: Row::uniform(Luminance, Uint, 8),
    /// A signed integer of 8 bits of luminance.
    L8I: Row::uniform(Luminance, Sint, 8),
    /// An unsigned integer of 16 bits of luminance.
    L16UI: Row::uniform(Luminance, Uint, 16),
    /// A signed integer of 16 bits of luminance.
    L16I: Row::uniform(Luminance, Sint, 16),
    /// An unsigned integer of 32 bits of luminance.
    L32UI: Row::uniform(Luminance, Uint, 32),
    /// A signed integer of 32 bits of luminance.
    L32I: Row::uniform(Luminance, Sint, 32),
    /// An unsigned integer of 8 bits each of luminance and alpha.
    La8UI: Row::uniform(LuminanceAlpha, Uint, 8),
    /// A signed integer of 8 bits each of luminance and alpha.
    La8I: Row::uniform(LuminanceAlpha, Sint, 8),
    /// An unsigned integer of 16 bits each of luminance and alpha.
    La16UI: Row::uniform(LuminanceAlpha, Uint, 16),
    /// A signed integer of 16 bits each of luminance and alpha.
    La16I: Row::uniform(LuminanceAlpha, Sint, 16),
    /// An unsigned integer of 32 bits each of luminance and alpha.
    La32UI: Row::uniform(LuminanceAlpha, Uint, 32),
    /// A signed integer of 32 bits each of luminance and alpha.
    La32I: Row::uniform(LuminanceAlpha, Sint, 32),
    /// An unsigned integer of 8 bits of intensity.
    I8UI: Row::uniform(Intensity, Uint, 8),
    /// A signed integer of 8 bits of intensity.
    I8I: Row::uniform(Intensity, Sint, 8),
    /// An unsigned integer of 16 bits of intensity.
    I16UI: Row::uniform(Intensity, Uint, 16),
    /// A signed integer of 16 bits of intensity.
    I16I: Row::uniform(Intensity, Sint, 16),
    /// An unsigned integer of 32 bits of intensity.
    I32UI: Row::uniform(Intensity, Uint, 32),
    /// A signed integer of 32 bits of intensity.
    I32I: Row::uniform(Intensity, Sint, 32),
    /// Unsigned integers: ten bits each of red, green, blue, red the lowest, and two of alpha.
    Rgb10A2UI: Row::packed(Rgba, Uint, 4, [(0, 10), (10, 10), (20, 10), (30, 2)]),
    /// 16-bit unsigned normalized depth.
    D16: Row::depth(Unorm, 2, 0, 16),
    /// 24-bit unsigned normalized depth in the low bits of a 32-bit word.
    D24: Row::depth(Unorm, 4, 0, 24),
    /// 32-bit unsigned normalized depth.
    D32: Row::depth(Unorm, 4, 0, 32),
    /// `f32` depth.
    D32F: Row::depth(Float, 4, 0, 32),
    /// 24 bits of depth above 8 of stencil (the layout of `GL_UNSIGNED_INT_24_8`).
    D24S8: Row::depth(Unorm, 4, 8, 24).with_stencil(0),
    /// `f32` depth, and stencil in the low byte of the next word
    /// (`GL_FLOAT_32_UNSIGNED_INT_24_8_REV`).
    D32FS8: Row::depth(Float, 8, 0, 32).with_stencil(1),
    /// DXT1 without alpha.
    Dxt1Rgb: Row::blocks(Rgb, Block(Dxt1), 8),
    /// DXT1 with an alpha of 0 or 1.
    Dxt1Rgba: Row::blocks(Rgba, Block(Dxt1), 8),
    /// DXT3: alpha of 4 bits.
    Dxt3: Row::blocks(Rgba, Block(Dxt3), 16),
    /// DXT5: interpolated alpha.
    Dxt5: Row::blocks(Rgba, Block(Dxt5), 16),
    /// sRGB-encoded DXT1 without alpha.
    SrgbDxt1Rgb: Row::blocks(Rgb, SrgbBlock(Dxt1), 8),
    /// sRGB-encoded DXT1 with an alpha of 0 or 1.
    SrgbDxt1Rgba: Row::blocks(Rgba, SrgbBlock(Dxt1), 8),
    /// sRGB-encoded DXT3: alpha of 4 bits.
    SrgbDxt3: Row::blocks(Rgba, SrgbBlock(Dxt3), 16),
    /// sRGB-encoded DXT5: interpolated alpha.
    SrgbDxt5: Row::blocks(Rgba, SrgbBlock(Dxt5), 16),
    /// RGTC of red (`ARB_texture_compression_rgtc`).
    Rgtc1: Row::blocks(Red, Block(Rgtc1), 8),
    /// RGTC of signed red.
    Rgtc1Snorm: Row::blocks(Red, Block(Rgtc1Snorm), 8),
    /// RGTC of red and green.
    Rgtc2: Row::blocks(Rg, Block(Rgtc2), 16),
    /// RGTC of signed red and green.
    Rgtc2Snorm: Row::blocks(Rg, Block(Rgtc2Snorm), 16),
    /// RGTC's block as luminance (`EXT_texture_compression_latc`).
    Latc1: Row::blocks(Luminance, Block(Rgtc1), 8),
    /// RGTC's block as signed luminance.
    Latc1Snorm: Row::blocks(Luminance, Block(Rgtc1Snorm), 8),
    /// RGTC's blocks as luminance and alpha.
    Latc2: Row::blocks(LuminanceAlpha, Block(Rgtc2), 16),
    /// RGTC's blocks as signed luminance and alpha.
    Latc2Snorm: Row::blocks(LuminanceAlpha, Block(Rgtc2Snorm), 16),
    /// BPTC of bytes (`ARB_texture_compression_bptc`).
    Bptc: Row::blocks(Rgba, Block(Bptc), 16),
    /// sRGB-encoded BPTC of bytes.
    SrgbBptc: Row::blocks(Rgba, SrgbBlock(Bptc), 16),
    /// BPTC of half floats.
    BptcSignedFloat: Row::blocks(Rgb, Block(BptcSignedFloat), 16),
    /// BPTC of half floats without a sign.
    BptcUnsignedFloat: Row::blocks(Rgb, Block(BptcUnsignedFloat), 16),
}
