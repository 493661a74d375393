//! The plan of a texture: how an image is sampled with a sampler, decided once per draw.
//!
//! A plan is data and calls no kernel. The kernels that read it, and the methods of [`SamplePlan`] that sample, are in
//! [`crate::sample`].

mod buffer_texture;
mod describe;
mod direct;
mod lod_range;
mod lookup_facts;
mod prepare;
mod selection;
mod texel_class;
mod texture;

pub(crate) use direct::DirectNearest;
pub(crate) use lod_range::LodRange;
pub use lookup_facts::{AlphaFact, ComponentsFact, LookupFacts};
pub(crate) use texel_class::TexelClass;
pub(crate) use texture::{Alpha, Anisotropy, LevelSelection, SampleKernel, TexelPath, Texture};

use crate::image::{Image, Incomplete, Level, Shape};
use crate::lanes::{I32s, LANES};
use crate::sampler::{Filter, Mipmap, Sampler};
use std::sync::Arc;
use texture::layers;

/// An image with a sampler, and all decisions of how it is sampled. Holds references to the levels that it reads.
#[derive(Clone, Debug)]
pub struct SamplePlan(Result<Texture, Incomplete>);

impl SamplePlan {
    /// Makes the plan. The plan of an incomplete image returns (0, 0, 0, 1) everywhere (GL 2.1,
    /// section 3.8.10); [`Self::incomplete`] has the reason.
    pub fn new(image: &Image, sampler: &Sampler) -> Self {
        Self(Texture::new(image, sampler))
    }

    /// The plan without filtering of alpha, if alpha is 1 in every texel. `None` if it is not, or if alpha is not filtered
    /// already. Scans the texels, so it pays only for textures that are drawn with more than once.
    pub fn without_alpha(&self) -> Option<Self> {
        let texture = self.texture().filter(|texture| texture.has_alpha_to_leave_out())?;
        Some(Self(Ok(Texture { alpha: Alpha::One, ..texture.clone() })))
    }

    /// Why the image is incomplete, if it is.
    pub fn incomplete(&self) -> Option<&Incomplete> {
        self.0.as_ref().err()
    }

    /// Whether λ is computed. If not, derivatives of coordinates are not used.
    pub fn needs_lod(&self) -> bool {
        match &self.0 {
            Ok(texture) => matches!(texture.level_selection, LevelSelection::PerLane { .. }),
            Err(_) => false,
        }
    }

    /// Whether [`Self::sample_fused`] may be called: the image is complete, there is no depth compare, and texels are
    /// numbers to multiply. A product with 1 keeps them, but not the bits of an integer that are those of a signalling NaN.
    pub fn samples_color(&self) -> bool {
        let is_color =
            |texture: &Texture| texture.compare.is_none() && !texture.format.is_integer();
        self.0.as_ref().is_ok_and(is_color)
    }

    /// What is known of the results of lookups, whatever their coordinates.
    pub fn lookup_facts(&self) -> LookupFacts {
        match &self.0 {
            Ok(texture) => texture.lookup_facts(),
            Err(_) => LookupFacts::OF_INCOMPLETE,
        }
    }

    /// The decisions in one line of text.
    pub fn describe(&self) -> String {
        match &self.0 {
            Ok(texture) => texture.describe(),
            Err(reason) => format!("incomplete, every sample is (0, 0, 0, 1): {reason}"),
        }
    }

    /// Which kernel samples, and why the general one.
    pub fn describe_kernel(&self) -> String {
        match &self.0 {
            Ok(texture) => texture.kernel.describe(),
            Err(_) => "no kernel".to_owned(),
        }
    }

    /// Whether a lookup may use [`Addresses::Reuse`](crate::sample::Addresses::Reuse) after a lookup of `other` with the
    /// same points, offset and level of detail: both read the same levels at the same byte offsets.
    pub fn shares_addresses_with(&self, other: &Self) -> bool {
        let (Ok(one), Ok(other)) = (&self.0, &other.0) else { return false };
        let of = |level: &Arc<Level>| (level.size(), level.border, level.format.bytes());
        let [levels, others] = [one, other].map(|texture| texture.levels[0].iter().map(of));
        // Direct lookups keep no addresses.
        one.is_fusible
            && other.is_fusible
            && one.direct.is_none()
            && other.direct.is_none()
            && (one.shape, one.wrap) == (other.shape, other.wrap)
            && one.level_selection == other.level_selection
            && levels.eq(others)
    }

    /// Width, height and depth of a level counted from the base level (`textureSize`); the number
    /// of layers follows the sizes along the filtered axes. 0 if there is no such level.
    pub fn size(&self, level: &I32s) -> [I32s; 3] {
        let mut out = [I32s::ZERO; 3];
        let Ok(texture) = &self.0 else { return out };
        for lane in 0..LANES {
            let found = usize::try_from(level[lane]).ok().and_then(|n| texture.levels[0].get(n));
            let Some(found) = found else { continue };
            let mut size = found.size();
            size[2] = layers(texture.shape, size);
            if texture.shape == Shape::D1Array {
                size.swap(1, 2);
            }
            for (out, side) in out.iter_mut().zip(size) {
                out[lane] = side as i32;
            }
        }
        out
    }

    /// The number of levels from the base level to the last that the sampler and the image allow, whatever the filter; 0
    /// if the image is incomplete.
    pub fn level_count(&self) -> u32 {
        self.0.as_ref().map_or(0, |texture| texture.level_count)
    }

    /// About how many additions of 64 lanes a lookup takes as long as, at most.
    pub fn cost(&self) -> u32 {
        const OVERHEAD: u32 = 32;
        let Ok(texture) = &self.0 else { return OVERHEAD };
        let (per_texel, overhead) = match texture.texel_path {
            TexelPath::Words(_) => (16, OVERHEAD),
            TexelPath::General
            | TexelPath::Blocks(_)
            | TexelPath::ComparedWords(_)
            | TexelPath::ScatteredWords(_) => (64, 4 * OVERHEAD),
        };
        let texels = |filter: Filter| match filter {
            Filter::Nearest => 1,
            Filter::Linear => 1 << texture.shape.axes(),
        };
        match &texture.level_selection {
            LevelSelection::Fixed { filter, .. } => overhead + per_texel * texels(*filter),
            LevelSelection::PerLane { min, mag, range, anisotropy } => {
                let levels = if range.mipmap == Mipmap::Linear { 2 } else { 1 };
                // Footprints are rarely as long as they may be.
                let probes = match anisotropy {
                    Anisotropy::Off => 1,
                    Anisotropy::Probes(most) | Anisotropy::Scan(most) => most.div_ceil(2),
                };
                let texels = texels(*min).max(texels(*mag));
                // Lanes read different levels.
                4 * overhead + 2 * per_texel * texels * levels * probes
            }
        }
    }

    /// The plan without fast paths.
    pub(crate) fn general(&self) -> Self {
        let texel_path = TexelPath::General;
        Self(self.0.clone().map(|texture| {
            let (alpha, direct) = (Alpha::Stored, None);
            let mut texture = Texture { texel_path, alpha, direct, is_fusible: false, ..texture };
            texture.kernel = SampleKernel::new(&texture);
            texture
        }))
    }

    /// What the kernels read, if the image is complete.
    pub(crate) fn texture(&self) -> Option<&Texture> {
        self.0.as_ref().ok()
    }
}
