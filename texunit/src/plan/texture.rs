//! The data of a plan: a complete image with its sampler, as the kernels read it.

use super::direct::DirectNearest;
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
    /// The number of levels from the base level to the last allowed one.
    pub level_count: u32,
    /// Effective wrap modes of s, t, r.
    pub wrap: [Wrap; 3],
    /// `Off` unless the image is a cube.
    pub seamless: Seamless,
    /// Border colour, as stored channels.
    pub border: [f32; 4],
    /// Set only for depth formats.
    pub compare: Option<Compare>,
    pub depth_mode: DepthMode,
    pub swizzle: [Swizzle; 4],
    pub texel_path: TexelPath,
    pub level_selection: LevelSelection,
    pub kernel: SampleKernel,
    pub alpha: Alpha,
    /// Set where all but the coordinates of a lookup is known.
    pub direct: Option<DirectNearest>,
    /// Whether lookups can be fused into other kernels ([`crate::sample::TexelConsumer`]): texels are red, green, blue and
    /// perhaps alpha, a byte each, without swizzle.
    pub is_fusible: bool,
    /// Whether the texels of a face are such texels, of whatever shape.
    pub has_fusible_texels: bool,
}

/// Whether alpha must be filtered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Alpha {
    /// It is filtered as other channels are.
    Stored,
    /// It is 1 in every texel of the filtered levels, and is not filtered.
    One,
}

/// The kernel that samples. Where several apply, they give the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SampleKernel {
    /// Two-dimensional textures of a fast texel class.
    UniformLevel(TexelClass),
    /// Cubes and arrays of a fast texel class, with one filter for magnification and minification, without border.
    Scattered(TexelClass),
    /// The general kernel, with probes for anisotropic footprints.
    General(WhyGeneral),
    /// The general kernel, with a row scan for anisotropic footprints. Batches of bytes whose footprints are all round, and
    /// alike, are scanned by the kernel of uniform levels.
    RowScan,
}

/// Why the general kernel samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum WhyGeneral {
    /// Anisotropic footprints have several probes.
    Probes,
    /// Magnification and minification have different filters, and the texture is a cube or an array.
    Filters,
    /// No other kernel has one or three axes.
    Shape,
    /// No other kernel has compressed texels.
    Blocks,
    /// No other kernel has the texel format.
    Format,
    /// No other kernel has border texels of faces and layers.
    Border,
    /// No other kernel has the wrap modes of faces and layers.
    Wrap,
    /// Texels are fetched by their numbers.
    Fetch,
}

/// How texels are read. All paths give the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TexelPath {
    /// Any texture.
    General,
    /// The fast path of two-dimensional textures and of cubes, without depth compare.
    Words(TexelClass),
    /// The fast path of compressed two-dimensional textures.
    Blocks(Block),
    /// Two-dimensional depth textures with compare: fast in the kernel of uniform levels, else general.
    ComparedWords(TexelClass),
    /// Arrays of two-dimensional textures and of cubes, and cubes with depth compare: fast in the kernel of scattered
    /// lanes, else general.
    ScatteredWords(TexelClass),
}

/// How a lane's filter and levels are selected.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum LevelSelection {
    /// The same for all lanes: λ has no effect.
    Fixed {
        filter: Filter,
        level: u32,
        /// Why λ is not computed.
        why: &'static str,
        /// The sampler's bias, for `textureQueryLOD`.
        bias: f32,
    },
    /// By λ.
    PerLane { min: Filter, mag: Filter, range: LodRange, anisotropy: Anisotropy },
}

/// How anisotropic footprints are filtered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anisotropy {
    /// As isotropic footprints.
    Off,
    /// With up to this many probes along the major axis.
    Probes(u32),
    /// With a row scan, up to this ratio of the axes.
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

    /// Whether the fused lookup applies to every batch whose lanes all read the same levels: no border can be read,
    /// nearest texels of two levels are not mixed, and footprints are not scanned (a fused scan does not cross the edges
    /// of a level).
    pub fn fused_always_applies(&self) -> bool {
        match &self.level_selection {
            LevelSelection::Fixed { filter, .. } => !self.reaches_border(*filter),
            LevelSelection::PerLane { anisotropy: Anisotropy::Scan(_), .. } => false,
            LevelSelection::PerLane { min, mag, range, .. } => {
                let both = *min == Filter::Nearest && range.mipmap == Mipmap::Linear;
                !both && !self.reaches_border(*min) && !self.reaches_border(*mag)
            }
        }
    }

    /// Whether one coordinate is a layer.
    #[inline(always)]
    pub fn is_array(&self) -> bool {
        matches!(self.shape, Shape::D1Array | Shape::D2Array | Shape::CubeArray)
    }

    /// Number of layers.
    #[inline(always)]
    pub fn layers(&self) -> u32 {
        layers(self.shape, self.size)
    }
}

/// Number of layers of an image of this size; for an array of cubes, of cubes.
#[inline(always)]
pub fn layers(shape: Shape, size: [u32; 3]) -> u32 {
    if shape == Shape::CubeArray { size[2] / FACES as u32 } else { size[2] }
}
