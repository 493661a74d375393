//! A complete image with its sampler, as the kernels read it, and what was decided of it.

use super::lod_range::LodRange;
use super::texel_class::TexelClass;
use crate::format::{Block, Format};
use crate::image::{FACES, Level, Shape};
use crate::sampler::{Compare, DepthMode, Filter, Mipmap, Seamless, Swizzle, Wrap};
use std::sync::Arc;

/// A complete image with its sampler, as the kernels read it.
#[derive(Clone, Debug)]
pub(crate) struct Texture {
    pub shape: Shape,
    pub format: Format,
    /// Width, height and depth (layers) of the base level.
    pub size: [u32; 3],
    /// Texels of the base level per unit of s, t, r.
    pub scale: [f32; 3],
    /// `levels[face][level]`, levels counted from the base level: those that a filter reaches,
    /// and those that fit them, which only a fetch reads. In an array of cubes, all faces are
    /// slices of the same levels.
    pub levels: Vec<Vec<Arc<Level>>>,
    /// Wrap of s, t, r.
    pub wrap: [Wrap; 3],
    /// Only ever on for cubes.
    pub seamless: Seamless,
    /// The border colour as stored channels.
    pub border: [f32; 4],
    /// Set only where texels are depths.
    pub compare: Option<Compare>,
    pub depth_mode: DepthMode,
    pub swizzle: [Swizzle; 4],
    pub texel_path: TexelPath,
    pub level_selection: LevelSelection,
    pub kernel: SampleKernel,
    pub alpha: Alpha,
    /// Whether texels may go to who looks them up as words of bytes: red, green, blue and, if any, alpha.
    pub is_fusible: bool,
}

/// What there is to alpha.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Alpha {
    /// It is a channel like others, or made of them.
    Stored,
    /// It is 1 in every texel that a filter reaches: means of it need not be computed.
    One,
}

/// Which kernel samples. Where several can, they give the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SampleKernel {
    /// Of most textures: in a plane, one filter, texels of a class that has a short way.
    UniformLevel(TexelClass),
    /// Of any whose footprints are not read row by row.
    Probes,
    /// Of those whose are, where a lookup has a footprint.
    RowScan,
}

/// Which kernels read texels. All give the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TexelPath {
    /// Any texture.
    General,
    /// Two-dimensional, not compared, of a class of texels that is worth loops of its own.
    Words(TexelClass),
    /// The same of compressed texels.
    Blocks(Block),
    /// Depths in a plane that are compared, of such a class: short where a filter takes one texel.
    ComparedWords(TexelClass),
}

/// How lanes come to their filter and level.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum LevelSelection {
    /// Every lane alike: λ decides nothing.
    Fixed {
        filter: Filter,
        level: u32,
        /// Why λ is not computed.
        why: &'static str,
        /// The sampler's bias, for who asks for λ all the same.
        bias: f32,
    },
    /// λ decides.
    PerLane { min: Filter, mag: Filter, range: LodRange, anisotropy: Anisotropy },
}

/// How footprints that are longer than wide are filtered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anisotropy {
    /// As wide as they are long.
    Off,
    /// In so many samples along the major axis at most.
    Probes(u32),
    /// Row by row, up to this ratio of the axes.
    Scan(u32),
}

impl Texture {
    /// Whether a sample with this filter can mix in the border colour.
    #[inline(always)]
    pub fn reaches_border(&self, filter: Filter) -> bool {
        let axes = self.shape.axes();
        self.seamless == Seamless::Off
            && (self.wrap[0].reaches_border(filter)
                || (axes > 1 && self.wrap[1].reaches_border(filter))
                || (axes > 2 && self.wrap[2].reaches_border(filter)))
    }

    /// Whether no texel that is read can be the border's, wherever all lanes read the same levels, and no mean of two
    /// levels of one texel each is taken.
    pub fn fused_always_applies(&self) -> bool {
        match &self.level_selection {
            LevelSelection::Fixed { filter, .. } => !self.reaches_border(*filter),
            LevelSelection::PerLane { min, range, .. } => {
                let both = *min == Filter::Nearest && range.mipmap == Mipmap::Linear;
                !both && !self.reaches_border(*min)
            }
        }
    }

    /// Whether one coordinate is a layer.
    #[inline(always)]
    pub fn is_array(&self) -> bool {
        matches!(self.shape, Shape::D1Array | Shape::D2Array | Shape::CubeArray)
    }

    /// How many layers a lookup chooses from.
    #[inline(always)]
    pub fn layers(&self) -> u32 {
        layers(self.shape, self.size)
    }
}

/// The layers of an image of this size: of an array of cubes, the cubes.
#[inline(always)]
pub fn layers(shape: Shape, size: [u32; 3]) -> u32 {
    if shape == Shape::CubeArray { size[2] / FACES as u32 } else { size[2] }
}
