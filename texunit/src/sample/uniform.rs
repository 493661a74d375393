//! The shortest way: a texture in a plane whose texels have a short way ([`super::fast`]) and whose two
//! filters are alike, of which all lanes read the same level, or the same two. Most batches of most draws are so.
//!
//! A kernel of its own, so that these do not carry the stack and the branches of probes, faces, layers
//! and lanes that read different levels. Every number is computed by the functions of the general way.

use super::call::SampleCall;
use super::compare::{compare, unit_range};
use super::fast::Places;
use super::interpolate::mix;
use super::recorder::NoRecorder;
use super::scratch::{Known, LevelScratch, QuadScratch};
use super::uniform_levels::{Read, plane_view, select};
use super::{expand, fast, fused};
use crate::lanes::{F32s, Kernel, Simd};
use crate::plan::TexelClass;
use crate::sampler::Filter;

/// One call: 64 samples of a texture that goes this way, of texels of this class.
pub(crate) struct UniformCall<'s, 'a, F> {
    pub sample: &'s mut SampleCall<'a, NoRecorder, F>,
    pub class: TexelClass,
    pub places: Places,
    pub squares: &'s mut QuadScratch,
    pub detail: &'s mut LevelScratch,
}

/// What became of a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    Sampled,
    /// Lanes read different levels, or texels that have no short way: nothing is done.
    NotUniform,
}

impl<F> Kernel for UniformCall<'_, '_, F> {
    type Output = Outcome;

    #[inline(always)]
    fn run<S: Simd>(self) -> Outcome {
        let Self { sample, class, places, squares, detail } = self;
        let texture = sample.texture;
        let LevelScratch { read: found, weight } = detail;
        if places == Places::Own {
            *found = select::<S>(texture, sample.coords, sample.lod, weight);
        }
        let Some(Read { filter, levels }) = *found else { return Outcome::NotUniform };
        if texture.is_fusible && filter == Filter::Linear {
            let spread = fused::WriteLanes(&mut *sample.out);
            let known = Known { read: *found, weight, places };
            let taken =
                fused::sample_fused::<S, _>(texture, *sample.coords, known, squares, spread);
            return if taken.is_ok() { Outcome::Sampled } else { Outcome::NotUniform };
        }
        // Takes no time where there is no second level.
        let mut second = None;
        let reads_both = levels[0] != levels[1];
        for (turn, number) in levels.into_iter().take(1 + usize::from(reads_both)).enumerate() {
            let view = plane_view(texture, filter, number);
            let out = match turn {
                0 => &mut *sample.out,
                _ => second.get_or_insert([F32s::ZERO; 4]),
            };
            let is_done = match filter {
                Filter::Nearest => fast::nearest::<S>(&view, class, *sample.coords, out),
                Filter::Linear => fast::linear::<S>(&view, class, *sample.coords, out),
            };
            if !is_done {
                return Outcome::NotUniform;
            }
            // Each texel by itself, which is why there is only one a lane.
            if let Some(op) = texture.compare {
                let reference = unit_range(sample.reference.unwrap_or(sample.coords[2]));
                compare(op, &reference, &mut out[0]);
            }
        }
        if let Some(second) = &second {
            let channels = texture.format.channels();
            for (out, second) in sample.out.iter_mut().zip(second).take(channels) {
                let first = *out;
                mix(&first, second, weight, out);
            }
        }
        expand::expand(texture.format, texture.depth_mode, sample.out);
        expand::swizzle(texture.format, texture.swizzle, sample.out);
        Outcome::Sampled
    }
}
