//! One decision per draw: how this image is sampled with this sampler.
//!
//! A plan is data that is chosen before anything is sampled. It calls no kernel; the kernels that read it are in
//! [`crate::sample`], which has the methods of [`SamplePlan`] that sample.

mod describe;
mod lod_range;
mod prepare;
mod row;
mod selection;
mod texel_class;
mod texture;

pub(crate) use lod_range::LodRange;
pub(crate) use texel_class::TexelClass;
pub(crate) use texture::{Alpha, Anisotropy, LevelSelection, SampleKernel, TexelPath, Texture};

use crate::image::{Image, Incomplete, Level, Shape};
use crate::lanes::{I32s, LANES};
use crate::sampler::Sampler;
use std::sync::Arc;
use texture::layers;

/// An image and a sampler, with every decision taken. Keeps the levels it reaches alive.
#[derive(Clone, Debug)]
pub struct SamplePlan(Result<Texture, Incomplete>);

impl SamplePlan {
    /// Decides. An incomplete image gives a plan that returns (0, 0, 0, 1) everywhere (GL 2.1,
    /// section 3.8.10); ask the image for the reason.
    pub fn new(image: &Image, sampler: &Sampler) -> Self {
        Self(Texture::new(image, sampler))
    }

    /// The same plan with alpha left out, where it is 1 in every texel; else, and where it is left out already, none.
    /// Reads all texels to know, which a second draw makes up for.
    pub fn without_alpha(&self) -> Option<Self> {
        let texture = self.texture().filter(|texture| texture.has_alpha_to_leave_out())?;
        Some(Self(Ok(Texture { alpha: Alpha::One, ..texture.clone() })))
    }

    /// Why the image cannot be sampled, if it cannot.
    pub fn incomplete(&self) -> Option<&Incomplete> {
        self.0.as_ref().err()
    }

    /// Whether λ is computed. Where it is not, the derivatives of coordinates do not matter.
    pub fn needs_lod(&self) -> bool {
        match &self.0 {
            Ok(texture) => matches!(texture.level_selection, LevelSelection::PerLane { .. }),
            Err(_) => false,
        }
    }

    /// Whether [`Self::sample_fused`] may be lanes: the image is complete, and what it gives is not compared.
    pub fn samples_color(&self) -> bool {
        self.0.as_ref().is_ok_and(|texture| texture.compare.is_none())
    }

    /// The decisions in one line.
    pub fn describe(&self) -> String {
        match &self.0 {
            Ok(texture) => texture.describe(),
            Err(reason) => format!("incomplete, every sample is (0, 0, 0, 1): {reason}"),
        }
    }

    /// Whether a lookup reads the same levels at the same places as one of `other` with the same points, offset and
    /// level of detail does: whether [`Addresses::Reuse`] can be asked for.
    pub fn shares_addresses_with(&self, other: &Self) -> bool {
        let (Ok(one), Ok(other)) = (&self.0, &other.0) else { return false };
        let of = |level: &Arc<Level>| (level.size(), level.border, level.format.bytes());
        let [levels, others] = [one, other].map(|texture| texture.levels[0].iter().map(of));
        one.is_fusible
            && other.is_fusible
            && (one.shape, one.wrap) == (other.shape, other.wrap)
            && one.level_selection == other.level_selection
            && levels.eq(others)
    }

    /// Width, height and depth of a level counted from the base level (`textureSize`); the number
    /// of layers comes after the sizes of what is filtered along. 0 where there is no such level.
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

    /// The same plan without its quicker kernels.
    pub(crate) fn general(&self) -> Self {
        let texel_path = TexelPath::General;
        Self(self.0.clone().map(|texture| {
            let kernel = SampleKernel::new(texture.shape, texel_path, &texture.level_selection);
            Texture { texel_path, kernel, alpha: Alpha::Stored, is_fusible: false, ..texture }
        }))
    }

    /// What the kernels read, if the image is complete.
    pub(crate) fn texture(&self) -> Option<&Texture> {
        self.0.as_ref().ok()
    }
}
