//! The table of texel formats.
//!
//! Texels are stored as what they are; a filter converts the ones it reads.

/// What a format's components mean, and so what a sample of it returns (GL 2.1, table 3.15).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BaseFormat {
    /// (0, 0, 0, A).
    Alpha,
    /// (L, L, L, 1).
    Luminance,
    /// (L, L, L, A).
    LuminanceAlpha,
    /// (I, I, I, I).
    Intensity,
    /// (R, 0, 0, 1).
    Red,
    /// (R, G, 0, 1).
    Rg,
    /// (R, G, B, 1).
    Rgb,
    /// (R, G, B, A).
    Rgba,
    /// (D, D, D, 1) as luminance; see `DEPTH_TEXTURE_MODE`.
    Depth,
}

/// How a texel is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// One byte of alpha.
    A8,
    /// One byte of luminance.
    L8,
    /// Luminance, alpha.
    La8,
    /// One byte that is all four components.
    I8,
    /// One byte of red.
    R8,
    /// Red, green.
    Rg8,
    /// Red, green, blue, three bytes.
    Rgb8,
    /// Red, green, blue, alpha.
    Rgba8,
    /// sRGB-encoded red, green, blue.
    Srgb8,
    /// sRGB-encoded red, green, blue, and linear alpha.
    Srgb8A8,
    /// sRGB-encoded luminance.
    Sl8,
    /// sRGB-encoded luminance, and linear alpha.
    Sl8A8,
    /// 16-bit unsigned normalized depth.
    D16,
    /// 24-bit unsigned normalized depth in the low bits of a 32-bit word.
    D24,
    /// `f32` depth.
    D32F,
}
