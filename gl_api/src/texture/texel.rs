//! Stored texels as the numbers that uploads and queries see: one definition for each encoding,
//! in `f64`, which holds all of them exactly.
//!
//! sRGB formats hold what the client gave: it is encoded already (`EXT_texture_sRGB`).

use super::client::Numbers;
use texunit::format::client::{read_channel, write_texel};
use texunit::format::integer::{decode_int, set_stencil, stencil};
use texunit::format::{BaseFormat, Encoding, Format};

/// The bytes of a texel, the first ones those that its format has.
pub(crate) type Bytes = [u8; 16];

/// What integers of the client's mean for a texel of this format.
pub(crate) fn numbers(format: Format, client: Numbers) -> Numbers {
    match (client, format.info().encoding) {
        (Numbers::Fixed, Encoding::Snorm) => Numbers::SignedNormalized,
        (Numbers::Fixed | Numbers::SignedNormalized | Numbers::Integer, _) => client,
    }
}

/// The stored channels as R, G, B, A, as queries see them (GL 2.1, table 6.1): luminance and
/// intensity as R alone.
pub(crate) fn rgba(base: BaseFormat, [a, b, c, d]: [f64; 4]) -> [f64; 4] {
    match base {
        BaseFormat::Alpha => [0.0, 0.0, 0.0, a],
        BaseFormat::Luminance | BaseFormat::Intensity | BaseFormat::Red | BaseFormat::Depth => {
            [a, 0.0, 0.0, 1.0]
        }
        BaseFormat::LuminanceAlpha => [a, 0.0, 0.0, b],
        BaseFormat::Rg => [a, b, 0.0, 1.0],
        BaseFormat::Rgb => [a, b, c, 1.0],
        BaseFormat::Rgba => [a, b, c, d],
    }
}

/// The stored channels of R, G, B, A (depth as R), as GL 2.1, table 3.15 has them.
pub(crate) fn channels(base: BaseFormat, rgba: [f64; 4]) -> [f64; 4] {
    let mut out = [0.0; 4];
    for (channel, &source) in out.iter_mut().zip(base.sources()) {
        *channel = rgba[source];
    }
    out
}

/// The bytes of a texel that holds R, G, B, A (depth as R, stencil as G), clamped to what the
/// format can hold.
pub(crate) fn encode(format: Format, rgba: [f64; 4]) -> Bytes {
    let mut texel = write_texel(format, rgba);
    if format.has_stencil() {
        set_stencil(format, &mut texel, rgba[1] as u8);
    }
    texel
}

/// A stored texel as R, G, B, A (depth as R, stencil as G).
pub(crate) fn decode(format: Format, texel: &[u8]) -> [f64; 4] {
    if format.is_integer() {
        return decode_int(format, texel).map(|value| value as f64);
    }
    let mut channels = [0.0; 4];
    for (channel, value) in channels.iter_mut().enumerate().take(format.channels()) {
        *value = read_channel(format, texel, channel);
    }
    let mut rgba = rgba(format.base(), channels);
    if let Some(stencil) = stencil(format, texel) {
        rgba[1] = stencil.into();
    }
    rgba
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
