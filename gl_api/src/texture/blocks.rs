//! Compressed texels (`EXT_texture_compression_s3tc`, `ARB_texture_compression_rgtc`): pixels to
//! blocks and back, by way of `f32` colours. What the client gives for sRGB is encoded already, so
//! blocks are made and read as those of the format without sRGB.

use super::sub::room;
use crate::error::Result;
use texunit::format::{BaseFormat, Format, block};
use texunit::image::Level;

/// How colours are on their way to and from blocks.
pub(super) const COLORS: Format = Format::Rgba32F;

/// The format whose blocks are the same, but not sRGB.
fn plain(format: Format) -> Format {
    match format {
        Format::SrgbDxt1Rgb => Format::Dxt1Rgb,
        Format::SrgbDxt1Rgba => Format::Dxt1Rgba,
        Format::SrgbDxt3 => Format::Dxt3,
        Format::SrgbDxt5 => Format::Dxt5,
        other => other,
    }
}

/// Compresses tightly packed [`COLORS`] into a level of this size.
pub(super) fn compress(format: Format, size: [u32; 3], colors: &[u8]) -> Result<Level> {
    let mut level = Level::with_size(plain(format), size, [0; 3])
        .map_err(|error| super::storage_error("GL 2.1, section 3.8.3", &error))?;
    let [width, height, _] = size.map(|side| side as usize);
    level.fill(|at| {
        let [x, y, z] = at.map(|at| at as usize);
        let texel = &colors[((z * height + y) * width + x) * COLORS.bytes()..][..COLORS.bytes()];
        let mut color = [0.0; 4];
        for (value, bytes) in color.iter_mut().zip(texel.chunks_exact(4)) {
            *value = f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
        }
        color
    });
    level.format = format;
    Ok(level)
}

/// A colour as it is read back: luminance is R, and does not become G and B (GL 2.1, section 6.1.4).
fn unexpanded(base: BaseFormat, color: [f32; 4]) -> [f32; 4] {
    match base {
        BaseFormat::Luminance | BaseFormat::LuminanceAlpha => [color[0], 0.0, 0.0, color[3]],
        BaseFormat::Alpha
        | BaseFormat::Intensity
        | BaseFormat::Red
        | BaseFormat::Rg
        | BaseFormat::Rgb
        | BaseFormat::Rgba
        | BaseFormat::Depth => color,
    }
}

/// The tightly packed [`COLORS`] of a compressed level, as they are read back.
pub(super) fn decompress(level: &Level) -> Result<Vec<u8>> {
    let [width, height, depth] = level.size().map(|side| side as usize);
    let mut colors = room(COLORS, [width, height, depth])?;
    let format = plain(level.format);
    let mut out = colors.chunks_exact_mut(COLORS.bytes());
    for z in 0..depth as i32 {
        for y in 0..height as i32 {
            for x in 0..width as i32 {
                let within = (x & 3) + 4 * (y & 3);
                let color = block::decode(format, level.texel_at([x, y, z]), within as u32);
                let color = unexpanded(format.base(), color);
                if let Some(out) = out.next() {
                    for (bytes, value) in out.chunks_exact_mut(4).zip(color) {
                        bytes.copy_from_slice(&value.to_le_bytes());
                    }
                }
            }
        }
    }
    Ok(colors)
}
