//! Nearest lookups of which all but the coordinates is known with the plan.

use super::texel_class::TexelClass;
use super::texture::{LevelSelection, SampleKernel, Texture};
use crate::format::BaseFormat;
use crate::sampler::{Filter, Swizzle};

/// A nearest lookup of one level of a plane, without border, whose texels are one word each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct DirectNearest {
    pub level: u32,
    pub class: TexelClass,
    /// The sources of red, green, blue and alpha.
    pub sources: [ChannelSource; 4],
}

/// What a component of a lookup is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ChannelSource {
    /// This stored channel.
    Stored(usize),
    Zero,
    One,
}

impl DirectNearest {
    /// `None` where a lookup selects levels or filters, reads the border, compares, or reads more than one word.
    pub fn new(texture: &Texture) -> Option<Self> {
        let SampleKernel::UniformLevel(class) = texture.kernel else { return None };
        let LevelSelection::Fixed { filter: Filter::Nearest, level, .. } = texture.level_selection
        else {
            return None;
        };
        let is_color = match class {
            TexelClass::Bytes | TexelClass::Srgb | TexelClass::Halves | TexelClass::Floats => true,
            TexelClass::Depth { .. } => false,
        };
        let format = texture.format;
        // Texels of depth attachments may be stored in tiles.
        let is_direct = is_color
            && !format.is_depth()
            && format.words() == 1
            && texture.compare.is_none()
            && !texture.reaches_border(Filter::Nearest);
        is_direct.then(|| Self { level, class, sources: sources(format.base(), texture.swizzle) })
    }
}

/// Stored channels to R, G, B, A (GL 2.1, section 3.8.13 and table 3.15), then the swizzle (EXT_texture_swizzle).
fn sources(base: BaseFormat, swizzle: [Swizzle; 4]) -> [ChannelSource; 4] {
    use ChannelSource::{One, Stored, Zero};
    let expanded = match base {
        BaseFormat::Alpha => [Zero, Zero, Zero, Stored(0)],
        BaseFormat::Luminance | BaseFormat::Depth => [Stored(0), Stored(0), Stored(0), One],
        BaseFormat::LuminanceAlpha => [Stored(0), Stored(0), Stored(0), Stored(1)],
        BaseFormat::Intensity => [Stored(0); 4],
        BaseFormat::Red => [Stored(0), Zero, Zero, One],
        BaseFormat::Rg => [Stored(0), Stored(1), Zero, One],
        BaseFormat::Rgb => [Stored(0), Stored(1), Stored(2), One],
        BaseFormat::Rgba => [Stored(0), Stored(1), Stored(2), Stored(3)],
    };
    swizzle.map(|source| match source {
        Swizzle::Red => expanded[0],
        Swizzle::Green => expanded[1],
        Swizzle::Blue => expanded[2],
        Swizzle::Alpha => expanded[3],
        Swizzle::Zero => Zero,
        Swizzle::One => One,
    })
}
