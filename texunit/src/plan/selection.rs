//! Which kernels sample an image with a sampler, and whether λ is needed for it.

use super::lod_range::LodRange;
use super::texel_class::TexelClass;
use super::texture::{Anisotropy, LevelSelection, SampleKernel, TexelPath, Texture, WhyGeneral};
use crate::format::Format;
use crate::image::Shape;
use crate::lanes::F32s;
use crate::lanes::math::clamp;
use crate::sampler::{Compare, Filter, MAX_ANISOTROPY, Mipmap, Sampler, Seamless, Wrap};

impl SampleKernel {
    pub fn new(texture: &Texture) -> Self {
        let (anisotropy, min, mag) = match &texture.level_selection {
            LevelSelection::Fixed { filter, .. } => (Anisotropy::Off, *filter, *filter),
            LevelSelection::PerLane { anisotropy, min, mag, .. } => (*anisotropy, *min, *mag),
        };
        match anisotropy {
            Anisotropy::Off => {}
            Anisotropy::Probes(_) => return Self::General(WhyGeneral::Probes),
            Anisotropy::Scan(_) => return Self::RowScan,
        }
        let kernel = match (texture.shape, texture.texel_path) {
            (
                Shape::D2 | Shape::Rect,
                TexelPath::Words(class) | TexelPath::ComparedWords(class),
            ) => Ok(Self::UniformLevel(class)),
            _ if min != mag => Err(WhyGeneral::Filters),
            (Shape::Cube, TexelPath::Words(class)) | (_, TexelPath::ScatteredWords(class)) => {
                scatters(texture, min).map(|()| Self::Scattered(class))
            }
            (Shape::D1 | Shape::D3 | Shape::D1Array, _) => Err(WhyGeneral::Shape),
            (_, TexelPath::Blocks(_)) => Err(WhyGeneral::Blocks),
            (_, TexelPath::General)
            | (
                Shape::Cube | Shape::D2Array | Shape::CubeArray,
                TexelPath::Words(_) | TexelPath::ComparedWords(_),
            ) => Err(WhyGeneral::Format),
        };
        kernel.unwrap_or_else(Self::General)
    }
}

/// Whether the kernel of scattered lanes has the wrap modes of a texture of two axes, which is without border.
fn scatters(texture: &Texture, filter: Filter) -> Result<(), WhyGeneral> {
    let [s, t, _] = texture.wrap;
    let is_known = |wrap: Wrap| match (wrap, filter) {
        (Wrap::Repeat | Wrap::MirroredRepeat | Wrap::ClampToEdge, _)
        | (Wrap::Clamp, Filter::Nearest) => true,
        (Wrap::Clamp, Filter::Linear) => texture.seamless == Seamless::On,
        (
            Wrap::ClampToBorder
            | Wrap::MirrorClamp
            | Wrap::MirrorClampToEdge
            | Wrap::MirrorClampToBorder,
            _,
        ) => false,
    };
    if texture.levels.iter().flatten().any(|level| level.border != [0; 3]) {
        return Err(WhyGeneral::Border);
    }
    if is_known(s) && is_known(t) { Ok(()) } else { Err(WhyGeneral::Wrap) }
}

impl TexelPath {
    pub fn new(shape: Shape, format: Format, compare: Option<Compare>) -> Self {
        let Some(class) = TexelClass::of(format) else {
            return match (shape, format.block(), compare) {
                (Shape::D2 | Shape::Rect | Shape::Cube, Some(block), None) => Self::Blocks(block),
                (_, _, _) => Self::General,
            };
        };
        match (shape, compare) {
            (Shape::D2 | Shape::Rect | Shape::Cube, None) => Self::Words(class),
            (Shape::D2 | Shape::Rect, Some(_)) => Self::ComparedWords(class),
            (Shape::Cube, Some(_)) | (Shape::D2Array | Shape::CubeArray, _) => {
                Self::ScatteredWords(class)
            }
            (Shape::D1 | Shape::D3 | Shape::D1Array, _) => Self::General,
        }
    }
}

impl Anisotropy {
    /// `most` is the maximum ratio of the axes.
    fn new(shape: Shape, sampler: &Sampler, max_probes: u32) -> Self {
        let in_rows = |wrap: Wrap| match wrap_of(shape, sampler.seamless, wrap) {
            Wrap::Repeat | Wrap::MirroredRepeat | Wrap::ClampToEdge => true,
            Wrap::Clamp
            | Wrap::ClampToBorder
            | Wrap::MirrorClamp
            | Wrap::MirrorClampToEdge
            | Wrap::MirrorClampToBorder => false,
        };
        let filters = [sampler.min, sampler.mag] == [Filter::Linear; 2];
        match shape {
            _ if max_probes == 1 => Self::Off,
            Shape::D2 | Shape::Rect
                if filters && in_rows(sampler.wrap[0]) && in_rows(sampler.wrap[1]) =>
            {
                Self::Scan(max_probes)
            }
            // A one-dimensional footprint has no minor axis.
            Shape::D1 | Shape::D1Array => Self::Off,
            Shape::D2
            | Shape::D3
            | Shape::Rect
            | Shape::Cube
            | Shape::D2Array
            | Shape::CubeArray => Self::Probes(max_probes),
        }
    }
}

/// The effective wrap mode: rectangles do not repeat (ARB_texture_rectangle), and a coordinate on a seamless cube face
/// is only clamped to the face.
pub fn wrap_of(shape: Shape, seamless: Seamless, wrap: Wrap) -> Wrap {
    match (shape, seamless, wrap) {
        (Shape::Cube | Shape::CubeArray, Seamless::On, _) => Wrap::Clamp,
        (
            Shape::Rect,
            _,
            Wrap::Repeat
            | Wrap::MirroredRepeat
            | Wrap::MirrorClamp
            | Wrap::MirrorClampToEdge
            | Wrap::MirrorClampToBorder,
        ) => Wrap::ClampToEdge,
        (_, _, wrap) => wrap,
    }
}

impl LevelSelection {
    /// Chooses how lanes select levels: not by λ where λ has no effect. `last` counts from the base level.
    pub fn new(shape: Shape, sampler: &Sampler, last: u32) -> Self {
        let Sampler { min, mipmap, mag, .. } = *sampler;
        // GL 2.1, section 3.8.9: the switch-over point `c`.
        let magnified_to = match (mag, min, mipmap) {
            (Filter::Linear, Filter::Nearest, Mipmap::Nearest | Mipmap::Linear) => 0.5,
            (Filter::Linear, Filter::Nearest, Mipmap::None)
            | (Filter::Linear, Filter::Linear, _)
            | (Filter::Nearest, _, _) => 0.0,
        };
        let fixed = |filter, why| Self::Fixed { filter, level: 0, why, bias: sampler.lod_bias };
        let max_probes = clamp(sampler.max_anisotropy, 1.0, MAX_ANISOTROPY) as u32;
        let anisotropy = Anisotropy::new(shape, sampler, max_probes);
        let is_off = anisotropy == Anisotropy::Off;
        if is_off && sampler.max_lod <= magnified_to {
            return fixed(mag, "the largest LOD never leaves magnification");
        }
        if is_off && min == mag {
            match mipmap {
                Mipmap::None => return fixed(mag, "both filters are alike and without mipmaps"),
                Mipmap::Nearest | Mipmap::Linear if last == 0 => {
                    return fixed(mag, "both filters are alike and there is one level");
                }
                Mipmap::Nearest | Mipmap::Linear => {}
            }
        }
        let mut range = LodRange {
            bias: sampler.lod_bias,
            min: sampler.min_lod,
            max: sampler.max_lod,
            magnified_to,
            mipmap,
            last,
        };
        // λ is clamped to `max`, which bounds the levels that are read.
        let ([first, second], _) = range.levels(&F32s::splat(range.max));
        range.last = first[0].max(second[0]);
        Self::PerLane { min, mag, range, anisotropy }
    }

    /// The last level that is read, counted from the base level.
    pub fn last_level(&self) -> u32 {
        match self {
            Self::Fixed { level, .. } => *level,
            Self::PerLane { range, .. } => range.last,
        }
    }
}
