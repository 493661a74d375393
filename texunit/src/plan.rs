//! One decision per draw: how this image is sampled with this sampler.

use crate::image::Image;
use crate::lanes::{F32s, Isa};
use crate::sampler::Sampler;

/// Where the level of detail of a batch comes from.
#[derive(Clone, Copy, Debug)]
pub enum Lod<'a> {
    /// From the differences within each quad of the batch (quad-planar lane order), plus a bias.
    Implicit {
        /// Per lane, added to λ before the clamp.
        bias: Option<&'a F32s>,
    },
    /// This λ, to which the sampler's bias is added.
    Explicit(&'a F32s),
    /// From these derivatives of s, t, r.
    Gradient {
        /// `∂(s, t, r)/∂x`.
        dx: [&'a F32s; 3],
        /// `∂(s, t, r)/∂y`.
        dy: [&'a F32s; 3],
    },
}

/// An image and a sampler, with every decision taken. Keeps the levels it reaches alive.
#[derive(Clone, Debug)]
pub struct SamplePlan {}

impl SamplePlan {
    /// Decides. An incomplete image gives a plan that returns (0, 0, 0, 1) everywhere (GL 2.1,
    /// section 3.8.10); ask the image for the reason.
    pub fn new(image: &Image, sampler: &Sampler) -> Self {
        let _ = (image, sampler);
        Self {}
    }

    /// Samples 64 lanes. `coords` are s, t, r (those the shape has are read); `reference` is
    /// compared when the plan compares. Any bits are legal coordinates in any lane.
    pub fn sample(
        &self,
        isa: Isa,
        coords: [&F32s; 3],
        reference: Option<&F32s>,
        lod: Lod<'_>,
        out: &mut [F32s; 4],
    ) {
        let _ = (isa, coords, reference, lod, out);
    }
}
