//! Compressed texels (`EXT_texture_compression_s3tc`, `ARB_texture_compression_rgtc`): pixels to
//! blocks and back, through `f32` colours. The client's sRGB values are encoded already, so blocks are
//! compressed and decompressed as those of the format without sRGB.

use crate::base::error::Result;
use crate::pixel::texel;
use std::borrow::Cow;
use texunit::format::Format;
use texunit::image::Level;
use texunit::lanes::{F32s, Isa, LANES};
use texunit::pixel;

/// The intermediate format of colours on both ways.
pub(crate) const COLORS: Format = Format::Rgba32F;

/// Compresses tightly packed [`COLORS`] into a level of this size.
pub(crate) fn compress(format: Format, size: [u32; 3], colors: &[u8]) -> Result<Level> {
    let mut level = Level::with_size(format.without_srgb(), size, [0; 3]).map_err(|error| {
        crate::pixel::storage_error::storage_error("GL 2.1, section 3.8.3", &error)
    })?;
    level.compress(colors);
    level.format = format;
    Ok(level)
}

/// The rows of a compressed level as [`COLORS`], as they are read back.
pub(crate) fn rows(isa: Isa, level: &Level) -> impl Iterator<Item = Vec<u8>> {
    let [width, height, depth] = level.size();
    let format = level.format.without_srgb();
    let level = match level.format == format {
        true => Cow::Borrowed(level),
        false => Cow::Owned(Level { format, ..level.clone() }),
    };
    let places = (0..depth).flat_map(move |z| (0..height).map(move |y| [y, z]));
    places.map(move |[y, z]| {
        let mut row = vec![0; width as usize * COLORS.bytes()];
        let runs = row.chunks_mut(LANES * COLORS.bytes());
        for (x, out) in (0..width).step_by(LANES).zip(runs) {
            let (mut channels, one) = ([F32s::ZERO; 4], F32s::splat(1.0));
            level.channels_of_row_span(isa, [x, y, z], &mut channels);
            let rgba = texel::rgba(format, channels.each_ref(), &F32s::ZERO, &one);
            pixel::write_floats(isa, rgba, out);
        }
        row
    })
}
