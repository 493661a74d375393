//! Makes a [`Texture`] from an image and a sampler: levels, wrap modes, border colour, kernel.

use super::direct::DirectNearest;
use super::selection::wrap_of;
use super::texel_class::TexelClass;
use super::texture::{
    Alpha, Anisotropy, LevelSelection, SampleKernel, TexelPath, Texture, WhyGeneral,
};
use crate::format::block::is_decoded_whole;
use crate::format::{BaseFormat, Block, Encoding, Format, shared_exponent, small_float};
use crate::image::{FACES, Image, Incomplete, Level, Shape};
use crate::lanes::math::clamp;
use crate::sampler::{Border, Filter, Sampler, Seamless, SrgbRead, Swizzle};
use std::sync::Arc;

impl Texture {
    /// Makes the plan's data.
    ///
    /// # Errors
    /// When the image is incomplete for this sampler.
    pub(super) fn new(image: &Image, sampler: &Sampler) -> Result<Self, Incomplete> {
        let reached = image.completeness(sampler)?;
        let shape = image.shape();
        let mut level_selection = LevelSelection::new(shape, sampler, reached.last - reached.base);
        let mut levels = levels(image, reached.base, level_selection.last_level());
        if sampler.srgb == SrgbRead::AsIs {
            levels.iter_mut().flatten().for_each(without_srgb);
        }
        // Blocks hold fewer numbers than what they are decoded to.
        let stored = levels[0][0].format;
        if let Some(decoded) = decoded(&levels) {
            levels = decoded;
        }
        if shape == Shape::CubeArray {
            // Kernels index levels by face; `LevelView::slice` selects the slice of the face.
            levels = vec![levels[0].clone(); FACES];
        }
        let base = &levels[0][0];
        let (format, size) = (base.format, base.size());
        let compare = if format.is_depth() { sampler.compare } else { None };
        if let LevelSelection::PerLane { anisotropy, .. } = &mut level_selection {
            *anisotropy = match *anisotropy {
                // Integers are not averaged.
                _ if format.is_integer() => Anisotropy::Off,
                Anisotropy::Scan(most) if compare.is_some() => Anisotropy::Probes(most),
                any @ (Anisotropy::Off | Anisotropy::Probes(_) | Anisotropy::Scan(_)) => any,
            };
        }
        let mut border = [0.0; 4];
        for (channel, (to, &from)) in border.iter_mut().zip(format.base().sources()).enumerate() {
            *to = border_channel(stored, channel, sampler.border, from);
        }
        let texel_path = TexelPath::new(shape, format, compare);
        let mut texture = Self {
            shape,
            format,
            size,
            scale: size.map(|side| shape.scale(side)),
            level_count: (levels[0].len() as u32)
                .min(sampler.max_level.saturating_sub(reached.base).saturating_add(1)),
            levels,
            wrap: sampler.wrap.map(|wrap| wrap_of(shape, sampler.seamless, wrap)),
            seamless: if shape.is_cube() { sampler.seamless } else { Seamless::Off },
            border,
            compare,
            depth_mode: sampler.depth_mode,
            swizzle: sampler.swizzle,
            texel_path,
            alpha: if format.base() == BaseFormat::Rgb { Alpha::One } else { Alpha::Stored },
            direct: None,
            is_fusible: false,
            has_fusible_texels: texel_path == TexelPath::Words(TexelClass::Bytes)
                && matches!(format.base(), BaseFormat::Rgb | BaseFormat::Rgba)
                && sampler.swizzle == Swizzle::IDENTITY,
            kernel: SampleKernel::General(WhyGeneral::Format),
            level_selection,
        };
        texture.kernel = SampleKernel::new(&texture);
        texture.is_fusible = texture.has_fusible_texels
            && matches!(texture.kernel, SampleKernel::UniformLevel(_) | SampleKernel::RowScan);
        texture.direct = DirectNearest::new(&texture);
        Ok(texture)
    }

    /// Whether alpha is filtered although it is 255 in every texel of the filtered levels.
    pub(super) fn has_alpha_to_leave_out(&self) -> bool {
        let is_byte = match self.texel_path {
            TexelPath::Words(TexelClass::Bytes | TexelClass::Srgb) => self.format.channels() == 4,
            TexelPath::Words(
                TexelClass::Halves | TexelClass::Floats | TexelClass::Depth { .. },
            )
            | TexelPath::General
            | TexelPath::Blocks(_)
            | TexelPath::ComparedWords(_)
            | TexelPath::ScatteredWords(_) => false,
        };
        let has_means = match &self.level_selection {
            LevelSelection::Fixed { filter, .. } => *filter == Filter::Linear,
            LevelSelection::PerLane { min, mag, .. } => [min, mag].contains(&&Filter::Linear),
        };
        let filtered = self.level_selection.last_level() as usize + 1;
        let mut levels = self.levels.iter().flat_map(|face| face.iter().take(filtered));
        is_byte
            && has_means
            && self.alpha == Alpha::Stored
            && levels.all(|level| is_opaque(&level.texels))
    }
}

/// Whether the last of the four bytes of each texel is 255.
fn is_opaque(texels: &[u8]) -> bool {
    // In chunks of 4 KiB, to stop early.
    texels.as_chunks::<4>().0.chunks(1024).all(|page| {
        page.iter().fold(!0, |all, &texel| all & u32::from_le_bytes(texel)) >> 24 == 0xFF
    })
}

/// Component `from` of the border colour as a stored channel, clamped to the numbers that the channel
/// can hold (GL 3.1, section 3.8.8; OpenGL 4.6, section 8.14.2). Integers as bits.
fn border_channel(format: Format, channel: usize, border: Border, from: usize) -> f32 {
    let info = format.info();
    let largest = i64::from(info.fields[channel].mask());
    let integer = || border.integers()[from];
    let number = border.floats()[from];
    match info.encoding {
        Encoding::Uint => f32::from_bits(integer().clamp(0, largest) as u32),
        Encoding::Sint => {
            let most = largest >> 1;
            f32::from_bits(integer().clamp(-most - 1, most) as i32 as u32)
        }
        Encoding::Snorm | Encoding::Block(Block::Rgtc1Snorm | Block::Rgtc2Snorm) => {
            clamp(number, -1.0, 1.0)
        }
        Encoding::Unorm
        | Encoding::Srgb
        | Encoding::SrgbBlock(_)
        | Encoding::Block(
            Block::Dxt1 | Block::Dxt3 | Block::Dxt5 | Block::Rgtc1 | Block::Rgtc2 | Block::Bptc,
        ) => clamp(number, 0.0, 1.0),
        // Half floats.
        Encoding::Block(Block::BptcUnsignedFloat) => {
            clamp(small_float::clamp_to_range(number, 16), 0.0, f32::INFINITY)
        }
        Encoding::Block(Block::BptcSignedFloat) => small_float::clamp_to_range(number, 16),
        Encoding::Float => small_float::clamp_to_range(number, info.fields[channel].bits),
        // `clamp` gives the lower bound where the number is NaN.
        Encoding::SharedExponent => clamp(number, 0.0, shared_exponent::LARGEST),
    }
}

/// Replaces an sRGB level by a copy in the linear format with the same bytes. Kernels decode by a level's format.
fn without_srgb(level: &mut Arc<Level>) {
    if level.format.is_srgb() {
        let format = level.format.without_srgb();
        *level = Arc::new(Level { format, ..Level::clone(level) });
    }
}

/// Levels whose texels take long to decode, as plain texels; `None` if they are others, or there is no memory.
fn decoded(levels: &[Vec<Arc<Level>>]) -> Option<Vec<Vec<Arc<Level>>>> {
    let is_slow = |level: &Arc<Level>| is_decoded_whole(level.format);
    if !levels.iter().flatten().any(is_slow) {
        return None;
    }
    let faces = levels.iter();
    faces.map(|face| face.iter().map(|level| level.decoded().map(Arc::new)).collect()).collect()
}

/// The levels of each face from `base` on: `last` more, and the consistent levels after them.
fn levels(image: &Image, base: u32, last: u32) -> Vec<Vec<Arc<Level>>> {
    let mut levels = vec![Vec::new(); image.shape().faces()];
    for number in 0.. {
        let found = |face: usize| image.level(face, (base + number) as usize);
        let all: Option<Vec<_>> = (0..levels.len()).map(found).collect();
        let Some(all) = all else { return levels };
        if number > last {
            let before: &Arc<Level> = &levels[0][number as usize - 1];
            let half = image.shape().halved(before.size());
            let fits = |level: &&Arc<Level>| level.size() == half && level.format == before.format;
            if before.size() == half || !all.iter().all(fits) {
                return levels;
            }
        }
        for (face, level) in levels.iter_mut().zip(all) {
            face.push(Arc::clone(level));
        }
    }
    levels
}
