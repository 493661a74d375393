//! Pixels in the client's memory to stored texels and back.
//!
//! sRGB formats hold what the client gave: it is encoded already (`EXT_texture_sRGB`).

use super::client::{ClientFormat, ClientType, Layout};
use crate::framebuffer::Region;
use crate::state::viewport::unit;
use texunit::format::{BaseFormat, Format};
use texunit::image::Level;

/// How many channels a texel stores, and which of R, G, B, A each takes (GL 2.1, table 3.15).
fn sources(base: BaseFormat) -> &'static [usize] {
    base.sources()
}

/// A channel of a stored texel as a number; depth and unsigned normalized alike.
fn read_channel(format: Format, texel: &[u8], channel: usize) -> f64 {
    match format {
        Format::D16 => f64::from(u16::from_le_bytes([texel[0], texel[1]])) / 65_535.0,
        Format::D24 => {
            f64::from(u32::from_le_bytes([texel[0], texel[1], texel[2], 0])) / 16_777_215.0
        }
        Format::D32F => f64::from(f32::from_le_bytes([texel[0], texel[1], texel[2], texel[3]])),
        Format::A8
        | Format::L8
        | Format::La8
        | Format::I8
        | Format::R8
        | Format::Rg8
        | Format::Rgb8
        | Format::Rgba8
        | Format::Srgb8
        | Format::Srgb8A8
        | Format::Sl8
        | Format::Sl8A8 => f64::from(texel[channel]) / 255.0,
    }
}

/// The bytes of a texel that holds R, G, B, A (depth as R), clamped to [0, 1].
fn encode(format: Format, rgba: [f64; 4]) -> [u8; 4] {
    let unorm = |value: f64, largest: f64| (unit(value) * largest).round_ties_even() as u32;
    match format {
        Format::D16 => unorm(rgba[0], 65_535.0).to_le_bytes(),
        Format::D24 => unorm(rgba[0], 16_777_215.0).to_le_bytes(),
        Format::D32F => (unit(rgba[0]) as f32).to_le_bytes(),
        Format::A8
        | Format::L8
        | Format::La8
        | Format::I8
        | Format::R8
        | Format::Rg8
        | Format::Rgb8
        | Format::Rgba8
        | Format::Srgb8
        | Format::Srgb8A8
        | Format::Sl8
        | Format::Sl8A8 => {
            let mut texel = [0; 4];
            for (byte, &source) in texel.iter_mut().zip(sources(format.base())) {
                *byte = unorm(rgba[source], 255.0) as u8;
            }
            texel
        }
    }
}

/// A stored texel as R, G, B, A, as queries see it (GL 2.1, table 6.1): luminance and intensity as
/// R alone.
fn decode(format: Format, texel: &[u8]) -> [f64; 4] {
    let channel = |channel| read_channel(format, texel, channel);
    match format.base() {
        BaseFormat::Alpha => [0.0, 0.0, 0.0, channel(0)],
        BaseFormat::Luminance | BaseFormat::Intensity | BaseFormat::Red | BaseFormat::Depth => {
            [channel(0), 0.0, 0.0, 1.0]
        }
        BaseFormat::LuminanceAlpha => [channel(0), 0.0, 0.0, channel(1)],
        BaseFormat::Rg => [channel(0), channel(1), 0.0, 1.0],
        BaseFormat::Rgb => [channel(0), channel(1), channel(2), 1.0],
        BaseFormat::Rgba => [channel(0), channel(1), channel(2), channel(3)],
    }
}

/// Whether bytes can be copied as they are.
fn is_same(layout: &Layout, format: Format) -> bool {
    layout.ty == ClientType::U8
        && match format {
            Format::Rgba8 | Format::Srgb8A8 => layout.format == ClientFormat::Rgba,
            Format::Rgb8 | Format::Srgb8 => layout.format == ClientFormat::Rgb,
            Format::R8 => layout.format == ClientFormat::Red,
            Format::Rg8 => layout.format == ClientFormat::Rg,
            Format::A8 => layout.format == ClientFormat::Alpha,
            Format::L8 | Format::Sl8 => {
                matches!(layout.format, ClientFormat::Luminance | ClientFormat::Red)
            }
            Format::La8 | Format::Sl8A8 => layout.format == ClientFormat::LuminanceAlpha,
            Format::I8 => matches!(layout.format, ClientFormat::Luminance | ClientFormat::Red),
            Format::D16 | Format::D24 | Format::D32F => false,
        }
}

/// The client's pixels as texels of `format`, tightly packed. `bytes` has `layout.needed` bytes.
pub(crate) fn unpack(layout: &Layout, bytes: &[u8], format: Format) -> Vec<u8> {
    let size = format.bytes();
    let mut texels = Vec::with_capacity(layout.width * layout.height * size);
    let (pixel, component) = (layout.pixel_bytes(), layout.ty.size());
    for row in 0..layout.height {
        let at = layout.start + row * layout.stride;
        let row = &bytes[at..at + layout.width * pixel];
        if is_same(layout, format) {
            texels.extend_from_slice(row);
            continue;
        }
        for pixel in row.chunks_exact(pixel) {
            let mut values = [0.0; 4];
            for (value, bytes) in values.iter_mut().zip(pixel.chunks_exact(component)) {
                let mut word = [0; 4];
                word[..component].copy_from_slice(bytes);
                if layout.swap {
                    word[..component].reverse();
                }
                *value = layout.ty.read(word);
            }
            texels.extend_from_slice(&encode(format, layout.format.expand(values))[..size]);
        }
    }
    texels
}

/// A region of a level into the client's memory, which has `layout.needed` bytes. Pixels outside
/// the level are left as they are.
pub(crate) fn pack(level: &Level, region: Region, layout: &Layout, bytes: &mut [u8]) {
    let (size, pixel, component) = (level.format.bytes(), layout.pixel_bytes(), layout.ty.size());
    let Some(visible) = region.within(level.width, level.height) else { return };
    for y in visible.y..visible.y + visible.height {
        let row =
            &level.texels[y * level.row_bytes()..][visible.x * size..][..visible.width * size];
        let at = layout.start
            + (y as i64 - region.y) as usize * layout.stride
            + (visible.x as i64 - region.x) as usize * pixel;
        let out = &mut bytes[at..at + visible.width * pixel];
        if is_same(layout, level.format) {
            out.copy_from_slice(row);
            continue;
        }
        for (texel, out) in row.chunks_exact(size).zip(out.chunks_exact_mut(pixel)) {
            let values = layout.format.select(decode(level.format, texel));
            for (value, out) in values.into_iter().zip(out.chunks_exact_mut(component)) {
                let mut word = layout.ty.write(value);
                if layout.swap {
                    word[..component].reverse();
                }
                out.copy_from_slice(&word[..component]);
            }
        }
    }
}

/// Texels of one format as texels of another, as a copy from a framebuffer makes them: luminance
/// and intensity take R (GL 2.1, table 3.15).
pub(crate) fn transcode(from: Format, texels: &[u8], to: Format) -> Vec<u8> {
    if from == to {
        return texels.to_vec();
    }
    texels
        .chunks_exact(from.bytes())
        .flat_map(|texel| encode(to, decode(from, texel)).into_iter().take(to.bytes()))
        .collect()
}
