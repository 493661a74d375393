//! Stored texels as the numbers that uploads and queries see: one definition for each encoding,
//! in `f64`, which holds all of them exactly.
//!
//! sRGB formats hold what the client gave: it is encoded already (`EXT_texture_sRGB`).

use super::client::Numbers;
use crate::state::viewport::unit;
use texunit::format::{BaseFormat, Encoding, Format};

/// The most bytes of a texel.
pub(crate) const TEXEL_BYTES: usize = 16;

/// The bytes of a texel, the first ones those that its format has.
pub(crate) type Bytes = [u8; TEXEL_BYTES];

/// What integers of the client's mean for a texel of this format.
pub(crate) fn numbers(format: Format, client: Numbers) -> Numbers {
    match format.info().encoding {
        Encoding::Unorm8
        | Encoding::Srgb8
        | Encoding::Unorm16
        | Encoding::Unorm24
        | Encoding::Float32 => client,
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

fn word(texel: &[u8]) -> u32 {
    let mut bytes = [0; 4];
    for (to, from) in bytes.iter_mut().zip(texel) {
        *to = *from;
    }
    u32::from_le_bytes(bytes)
}

/// The channels of a texel.
fn read(format: Format, texel: &[u8]) -> [f64; 4] {
    let mut out = [0.0; 4];
    let bytes = format.bytes() / format.channels();
    for (value, texel) in out.iter_mut().zip(texel.chunks_exact(bytes)) {
        let word = word(texel);
        *value = match format.info().encoding {
            Encoding::Unorm8 | Encoding::Srgb8 => f64::from(word) / 255.0,
            Encoding::Unorm16 => f64::from(word) / 65_535.0,
            Encoding::Unorm24 => f64::from(word & 0xFF_FFFF) / 16_777_215.0,
            Encoding::Float32 => f32::from_bits(word).into(),
        };
    }
    out
}

fn write(format: Format, channels: [f64; 4]) -> Bytes {
    let unorm = |value: f64, largest: f64| (unit(value) * largest).round_ties_even() as u32;
    let mut out = [0; TEXEL_BYTES];
    let bytes = format.bytes() / format.channels();
    for (value, out) in
        channels.into_iter().zip(out.chunks_exact_mut(bytes)).take(format.channels())
    {
        let word = match format.info().encoding {
            Encoding::Unorm8 | Encoding::Srgb8 => unorm(value, 255.0),
            Encoding::Unorm16 => unorm(value, 65_535.0),
            Encoding::Unorm24 => unorm(value, 16_777_215.0),
            Encoding::Float32 if format.is_depth() => (unit(value) as f32).to_bits(),
            Encoding::Float32 => (value as f32).to_bits(),
        };
        out.copy_from_slice(&word.to_le_bytes()[..bytes]);
    }
    out
}

/// The bytes of a texel that holds R, G, B, A (depth as R), clamped to what the format can hold.
pub(crate) fn encode(format: Format, rgba: [f64; 4]) -> Bytes {
    write(format, channels(format.base(), rgba))
}

/// A stored texel as R, G, B, A (depth as R).
pub(crate) fn decode(format: Format, texel: &[u8]) -> [f64; 4] {
    rgba(format.base(), read(format, texel))
}

/// Whether texels hold stencil beside depth.
pub(crate) fn has_stencil(_: Format) -> bool {
    false
}

/// Whether texels are integers that are no fractions.
pub(crate) fn is_integer(_: Format) -> bool {
    false
}

/// Whether texels are floats or integers, which a border colour need not be a fraction for.
pub(crate) fn is_wide(_: Format) -> bool {
    false
}
