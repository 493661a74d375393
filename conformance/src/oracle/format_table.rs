//! The internal formats as data (tables 3.15 and 3.16 and the extensions' own): what each holds and
//! with how many bits. The specification lets an implementation store more bits than the name says;
//! where DetGL does, the row says so.

use super::format::{Base, Encoding, Sign};
use gl_api::constants::*;

/// An internal format: its name, its base format and how it is stored.
pub type Row = (u32, Base, Encoding);

/// Every format of numbers; compressed ones are the blocks'.
pub const FORMATS: &[Row] = {
    use Base::*;
    use Encoding::*;
    &[
        (GL_ALPHA4, Alpha, Unorm([8; 4])),
        (GL_ALPHA8, Alpha, Unorm([8; 4])),
        (GL_ALPHA12, Alpha, Unorm([16; 4])),
        (GL_ALPHA16, Alpha, Unorm([16; 4])),
        (GL_LUMINANCE4, Luminance, Unorm([8; 4])),
        (GL_LUMINANCE8, Luminance, Unorm([8; 4])),
        (GL_LUMINANCE12, Luminance, Unorm([16; 4])),
        (GL_LUMINANCE16, Luminance, Unorm([16; 4])),
        (GL_LUMINANCE4_ALPHA4, LuminanceAlpha, Unorm([8; 4])),
        (GL_LUMINANCE6_ALPHA2, LuminanceAlpha, Unorm([8; 4])),
        (GL_LUMINANCE8_ALPHA8, LuminanceAlpha, Unorm([8; 4])),
        (GL_LUMINANCE12_ALPHA4, LuminanceAlpha, Unorm([16; 4])),
        (GL_LUMINANCE12_ALPHA12, LuminanceAlpha, Unorm([16; 4])),
        (GL_LUMINANCE16_ALPHA16, LuminanceAlpha, Unorm([16; 4])),
        (GL_INTENSITY4, Intensity, Unorm([8; 4])),
        (GL_INTENSITY8, Intensity, Unorm([8; 4])),
        (GL_INTENSITY12, Intensity, Unorm([16; 4])),
        (GL_INTENSITY16, Intensity, Unorm([16; 4])),
        (GL_R8, Red, Unorm([8; 4])),
        (GL_R16, Red, Unorm([16; 4])),
        (GL_RG8, Rg, Unorm([8; 4])),
        (GL_RG16, Rg, Unorm([16; 4])),
        (GL_R3_G3_B2, Rgb, Unorm([3, 3, 2, 0])),
        // Five bits and one more of green hold what asks for four or five.
        (GL_RGB4, Rgb, Unorm([5, 6, 5, 0])),
        (GL_RGB5, Rgb, Unorm([5, 6, 5, 0])),
        (GL_RGB8, Rgb, Unorm([8; 4])),
        (GL_RGB10, Rgb, Unorm([10; 4])),
        (GL_RGB12, Rgb, Unorm([16; 4])),
        (GL_RGB16, Rgb, Unorm([16; 4])),
        (GL_RGBA2, Rgba, Unorm([4; 4])),
        (GL_RGBA4, Rgba, Unorm([4; 4])),
        (GL_RGB5_A1, Rgba, Unorm([5, 5, 5, 1])),
        (GL_RGBA8, Rgba, Unorm([8; 4])),
        (GL_RGB10_A2, Rgba, Unorm([10, 10, 10, 2])),
        (GL_RGBA12, Rgba, Unorm([16; 4])),
        (GL_RGBA16, Rgba, Unorm([16; 4])),
        (GL_SRGB8, Rgb, Srgb),
        (GL_SRGB8_ALPHA8, Rgba, Srgb),
        (GL_SLUMINANCE8, Luminance, Srgb),
        (GL_SLUMINANCE8_ALPHA8, LuminanceAlpha, Srgb),
        (GL_R8_SNORM, Red, Snorm(8)),
        (GL_RG8_SNORM, Rg, Snorm(8)),
        (GL_RGB8_SNORM, Rgb, Snorm(8)),
        (GL_RGBA8_SNORM, Rgba, Snorm(8)),
        (GL_R16_SNORM, Red, Snorm(16)),
        (GL_RG16_SNORM, Rg, Snorm(16)),
        (GL_RGB16_SNORM, Rgb, Snorm(16)),
        (GL_RGBA16_SNORM, Rgba, Snorm(16)),
        (GL_ALPHA16F_ARB, Alpha, Half),
        (GL_LUMINANCE16F_ARB, Luminance, Half),
        (GL_LUMINANCE_ALPHA16F_ARB, LuminanceAlpha, Half),
        (GL_INTENSITY16F_ARB, Intensity, Half),
        (GL_R16F, Red, Half),
        (GL_RG16F, Rg, Half),
        (GL_RGB16F, Rgb, Half),
        (GL_RGBA16F, Rgba, Half),
        (GL_ALPHA32F_ARB, Alpha, Single),
        (GL_LUMINANCE32F_ARB, Luminance, Single),
        (GL_LUMINANCE_ALPHA32F_ARB, LuminanceAlpha, Single),
        (GL_INTENSITY32F_ARB, Intensity, Single),
        (GL_R32F, Red, Single),
        (GL_RG32F, Rg, Single),
        (GL_RGB32F, Rgb, Single),
        (GL_RGBA32F, Rgba, Single),
        (GL_R11F_G11F_B10F, Rgb, PackedFloat),
        (GL_RGB9_E5, Rgb, SharedExponent),
        (GL_DEPTH_COMPONENT16, Depth, Unorm([16; 4])),
        (GL_DEPTH_COMPONENT24, Depth, Unorm([24; 4])),
        // Floats of 32 bits hold 32-bit depth.
        (GL_DEPTH_COMPONENT32, Depth, Single),
        (GL_DEPTH_COMPONENT32F, Depth, Single),
        (GL_DEPTH24_STENCIL8, Depth, Unorm([24; 4])),
        (GL_DEPTH32F_STENCIL8, Depth, Single),
    ]
};

/// Every integer format.
pub const INTEGER_FORMATS: &[Row] = {
    use Base::{Red, Rg, Rgb, Rgba};
    use Encoding::Integer;
    use Sign::{Signed, Unsigned};
    &[
        (GL_R8I, Red, Integer(8, Signed)),
        (GL_R8UI, Red, Integer(8, Unsigned)),
        (GL_RG8I, Rg, Integer(8, Signed)),
        (GL_RG8UI, Rg, Integer(8, Unsigned)),
        (GL_RGB8I, Rgb, Integer(8, Signed)),
        (GL_RGB8UI, Rgb, Integer(8, Unsigned)),
        (GL_RGBA8I, Rgba, Integer(8, Signed)),
        (GL_RGBA8UI, Rgba, Integer(8, Unsigned)),
        (GL_R16I, Red, Integer(16, Signed)),
        (GL_R16UI, Red, Integer(16, Unsigned)),
        (GL_RG16I, Rg, Integer(16, Signed)),
        (GL_RG16UI, Rg, Integer(16, Unsigned)),
        (GL_RGB16I, Rgb, Integer(16, Signed)),
        (GL_RGB16UI, Rgb, Integer(16, Unsigned)),
        (GL_RGBA16I, Rgba, Integer(16, Signed)),
        (GL_RGBA16UI, Rgba, Integer(16, Unsigned)),
        (GL_R32I, Red, Integer(32, Signed)),
        (GL_R32UI, Red, Integer(32, Unsigned)),
        (GL_RG32I, Rg, Integer(32, Signed)),
        (GL_RG32UI, Rg, Integer(32, Unsigned)),
        (GL_RGB32I, Rgb, Integer(32, Signed)),
        (GL_RGB32UI, Rgb, Integer(32, Unsigned)),
        (GL_RGBA32I, Rgba, Integer(32, Signed)),
        (GL_RGBA32UI, Rgba, Integer(32, Unsigned)),
    ]
};
