//! Nearest lookups of which all but the coordinates is known with the plan.

use super::texel_class::TexelClass;
use super::texture::{LevelSelection, SampleKernel, Texture};
use crate::format::Component;
use crate::sampler::{Filter, Swizzle};

/// A nearest lookup of one level of a plane, without border, whose texels are one word each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DirectNearest {
    pub level: usize,
    /// Texels across and up.
    pub size: [u32; 2],
    /// Border texels on either side, across and up.
    pub border: [u32; 2],
    /// Texels per unit of s and t.
    pub scale: [f32; 2],
    /// Bytes of a texel, and of a row.
    pub bytes: [u32; 2],
    /// The byte offset of the first texel.
    pub origin: u32,
    pub class: TexelClass,
    /// Red, green, blue and alpha.
    pub components: [Component; 4],
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
        let components = swizzled(format.base().components(), texture.swizzle);
        let level = level as usize;
        let of = texture.levels[0].get(level).filter(|_| is_direct)?;
        let (size, [border_s, border_t, _]) = ([of.width, of.height], of.border);
        let scale = size.map(|size| texture.shape.scale(size));
        Some(Self {
            level,
            size,
            border: [border_s, border_t],
            scale,
            // The offsets of a level's texels are 32 bits wide.
            bytes: [format.bytes() as u32, of.row_bytes() as u32],
            origin: of.origin() as u32,
            class,
            components,
        })
    }
}

/// The components of a format, then the swizzle (EXT_texture_swizzle).
fn swizzled(components: [Component; 4], swizzle: [Swizzle; 4]) -> [Component; 4] {
    swizzle.map(|source| match source {
        Swizzle::Red => components[0],
        Swizzle::Green => components[1],
        Swizzle::Blue => components[2],
        Swizzle::Alpha => components[3],
        Swizzle::Zero => Component::Zero,
        Swizzle::One => Component::One,
    })
}
