//! Pixels in the client's memory to stored texels and back.
//!
//! sRGB formats hold what the client gave: it is encoded already (`EXT_texture_sRGB`).

use super::client::{ClientFormat, ClientType, Layout};
use crate::framebuffer::Region;
use texunit::format::client::{read_channel, write_texel};
use texunit::format::{BaseFormat, Encoding, Format};
use texunit::image::Level;

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
        && format.bytes() == format.channels()
        && matches!(format.info().encoding, Encoding::Unorm | Encoding::Srgb)
        && match format.base() {
            BaseFormat::Rgba => layout.format == ClientFormat::Rgba,
            BaseFormat::Rgb => layout.format == ClientFormat::Rgb,
            BaseFormat::Red => layout.format == ClientFormat::Red,
            BaseFormat::Rg => layout.format == ClientFormat::Rg,
            BaseFormat::Alpha => layout.format == ClientFormat::Alpha,
            BaseFormat::Luminance | BaseFormat::Intensity => {
                matches!(layout.format, ClientFormat::Luminance | ClientFormat::Red)
            }
            BaseFormat::LuminanceAlpha => layout.format == ClientFormat::LuminanceAlpha,
            BaseFormat::Depth => false,
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
            texels.extend_from_slice(&write_texel(format, layout.format.expand(values))[..size]);
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
        .flat_map(|texel| write_texel(to, decode(from, texel)).into_iter().take(to.bytes()))
        .collect()
}
