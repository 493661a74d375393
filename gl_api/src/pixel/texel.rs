//! Components of stored texels as uploads and queries see them. sRGB values are not decoded: the client's are encoded
//! already (`EXT_texture_sRGB`).

use crate::pixel::client::format::Numbers;
use rasterizer::driver::DepthWrite;
use texunit::format::{BaseFormat, Encoding, Format};

/// How the client's integers are interpreted for a texel of this format.
pub(crate) fn numbers(format: Format, client: Numbers) -> Numbers {
    match (client, format.info().encoding) {
        (Numbers::Fixed, Encoding::Snorm) => Numbers::SignedNormalized,
        (Numbers::Fixed | Numbers::SignedNormalized | Numbers::Integer, _) => client,
    }
}

/// How the components of texels are interpreted by a copy.
pub(crate) fn numbers_of(format: Format) -> Numbers {
    if format.is_integer() { Numbers::Integer } else { Numbers::Fixed }
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

/// Depths, if they are written, and these bits of stencils of texels into others of the same format.
pub(crate) fn merge(format: Format, depth: DepthWrite, bits: u8, from: &[u8], to: &mut [u8]) {
    // A stencil is the low byte of its word.
    let stencil = format.has_stencil().then(|| 4 * format.info().stencil.word);
    match (stencil, format.bytes()) {
        (Some(byte), 4) => merge_sized::<4>(byte, depth, bits, from, to),
        (Some(byte), _) => merge_sized::<8>(byte, depth, bits, from, to),
        (None, _) if depth == DepthWrite::On => to.copy_from_slice(from),
        (None, _) => {}
    }
}

/// Whether two formats store depths alike, beside a stencil or not.
pub(crate) fn same_depths(a: Format, b: Format) -> bool {
    let [x, y] = [a, b].map(Format::info);
    a.is_depth() && b.is_depth() && x.encoding == y.encoding && x.fields[0].bits == y.fields[0].bits
}

/// Texels of a format of depth or stencil as those of another one that stores what it has alike; what only the other
/// one has is zero.
pub(crate) fn relaid(from: Format, to: Format, texels: &[u8]) -> Vec<u8> {
    if from == to {
        return texels.to_vec();
    }
    let fields = |format: Format| [format.info().fields[0], format.info().stencil];
    let (sources, destinations) = (fields(from), fields(to));
    let mut out = Vec::with_capacity(texels.len() / from.bytes() * to.bytes());
    for texel in texels.chunks_exact(from.bytes()) {
        let mut words = [0_u32; 2];
        for (source, destination) in sources.iter().zip(&destinations) {
            if source.bits == 0 || destination.bits == 0 {
                continue;
            }
            let bytes = texel[4 * source.word..].first_chunk().copied().unwrap_or_default();
            let value = u32::from_le_bytes(bytes) >> source.shift & (!0 >> (32 - source.bits));
            words[destination.word] |= value << destination.shift;
        }
        let bytes = words.map(u32::to_le_bytes);
        out.extend_from_slice(&bytes.as_flattened()[..to.bytes()]);
    }
    out
}

fn merge_sized<const SIZE: usize>(
    byte: usize,
    depth: DepthWrite,
    bits: u8,
    from: &[u8],
    to: &mut [u8],
) {
    for (to, from) in to.as_chunks_mut::<SIZE>().0.iter_mut().zip(from.as_chunks::<SIZE>().0) {
        let stencil = from[byte] & bits | to[byte] & !bits;
        if depth == DepthWrite::On {
            *to = *from;
        }
        to[byte] = stencil;
    }
}

/// Whether texels are floats or integers, which need not be from -1 to 1.
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
