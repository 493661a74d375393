//! Stored texels as the numbers that uploads and queries see.
//!
//! sRGB formats hold what the client gave: it is encoded already (`EXT_texture_sRGB`).

use super::client::Numbers;
use texunit::format::integer::{set_stencil, stencil};
use texunit::format::{BaseFormat, Encoding, Format};

/// What integers of the client's mean for a texel of this format.
pub(crate) fn numbers(format: Format, client: Numbers) -> Numbers {
    match (client, format.info().encoding) {
        (Numbers::Fixed, Encoding::Snorm) => Numbers::SignedNormalized,
        (Numbers::Fixed | Numbers::SignedNormalized | Numbers::Integer, _) => client,
    }
}

/// The numbers of a texel as R, G, B, A, as queries see them (GL 2.1, table 6.1): luminance and
/// intensity as R alone, depth as R, stencil as G.
pub(crate) fn rgba<T: Copy>(format: Format, [a, b, c, d]: [T; 4], zero: T, one: T) -> [T; 4] {
    match format.base() {
        BaseFormat::Alpha => [zero, zero, zero, a],
        BaseFormat::Depth if format.has_stencil() => [a, b, zero, one],
        BaseFormat::Luminance | BaseFormat::Intensity | BaseFormat::Red | BaseFormat::Depth => {
            [a, zero, zero, one]
        }
        BaseFormat::LuminanceAlpha => [a, zero, zero, b],
        BaseFormat::Rg => [a, b, zero, one],
        BaseFormat::Rgb => [a, b, c, one],
        BaseFormat::Rgba => [a, b, c, d],
    }
}

/// The numbers of a texel from R, G, B, A (depth as R, stencil as G), as GL 2.1, table 3.15 has them.
pub(crate) fn channels<T: Copy>(format: Format, rgba: [T; 4]) -> [T; 4] {
    let mut out = rgba;
    for (channel, &source) in out.iter_mut().zip(format.base().sources()) {
        *channel = rgba[source];
    }
    out
}

/// The stencil of a texel; 0 where its format has none.
pub(crate) fn stencil_of(format: Format, texel: &[u8]) -> u8 {
    stencil(format, texel).unwrap_or(0)
}

/// Puts a stencil into a texel.
pub(crate) fn put_stencil(format: Format, texel: &mut [u8], value: u8) {
    set_stencil(format, texel, value);
}

/// The depth of one texel into another of the same format, whose stencil stays.
pub(crate) fn copy_depth(format: Format, from: &[u8], to: &mut [u8]) {
    let old = stencil(format, to);
    to.copy_from_slice(from);
    if let Some(old) = old {
        set_stencil(format, to, old);
    }
}

/// Whether texels are floats or integers, which a border colour need not be a fraction for.
pub(crate) fn is_wide(format: Format) -> bool {
    match format.info().encoding {
        Encoding::Float | Encoding::SharedExponent | Encoding::Uint | Encoding::Sint => true,
        Encoding::Unorm
        | Encoding::Snorm
        | Encoding::Srgb
        | Encoding::Block(_)
        | Encoding::SrgbBlock(_) => false,
    }
}

/// Whether the driver draws to images of this format: not to compressed ones, and not to shared
/// exponents.
pub(crate) fn is_renderable(format: Format) -> bool {
    match format.info().encoding {
        Encoding::Unorm
        | Encoding::Snorm
        | Encoding::Srgb
        | Encoding::Float
        | Encoding::Uint
        | Encoding::Sint => format != Format::D32,
        Encoding::SharedExponent | Encoding::Block(_) | Encoding::SrgbBlock(_) => false,
    }
}
