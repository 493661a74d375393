//! The kernel of most batches: a two-dimensional texture that has a fast path ([`super::fast`]), where all lanes read the
//! same level, or the same two, with the same filter.
//!
//! It is separate from [`super::general`], so that it has neither the stack nor the branches of probes, faces, layers
//! and lanes that read different levels. The functions that compute are the same, and so are the bits.

use super::call::SampleCall;
use super::compare::{compare, unit_range};
use super::fast::{Addresses, LinearCompared};
use super::filter::{FastPath, FastTexels};
use super::interpolate::mix;
use super::recorder::NoRecorder;
use super::scratch::{LevelScratch, QuadScratch, SelectedLevels};
use super::uniform_levels::{UniformLevels, face_view, select};
use super::{expand, fused};
use crate::kernels::LookupKernel;
use crate::lanes::{F32s, Kernel, Simd};
use crate::plan::TexelClass;
use crate::sampler::Filter;

/// One call: 64 samples of a texture with texels of this class.
pub(crate) struct UniformCall<'s, 'a, F> {
    pub sample: &'s mut SampleCall<'a, NoRecorder, F>,
    pub class: TexelClass,
    pub addresses: Addresses,
    pub quads: &'s mut QuadScratch,
    pub levels: &'s mut LevelScratch,
}

/// Whether the kernel applied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// The result is stored.
    Sampled,
    /// Lanes read different levels, or texels without a fast path: no result is stored.
    NotUniform,
}

impl<F> Kernel for UniformCall<'_, '_, F> {
    type Output = Outcome;

    #[inline(always)]
    fn run<S: Simd>(self) -> Outcome {
        let Self { sample, class, addresses, quads, levels: selected } = self;
        let texture = sample.texture;
        let LevelScratch { levels: uniform, weight } = selected;
        if addresses == Addresses::Compute {
            *uniform = select::<S>(texture, sample.coords, sample.lod, weight);
        }
        let known = SelectedLevels { levels: *uniform, weight, addresses };
        sample_uniform::<S, F>(sample, *sample.coords, class, known, quads)
    }
}

/// Samples where all lanes read the same level, or the same two, of one face, at these coordinates.
#[inline(always)]
pub(super) fn sample_uniform<S: Simd, F>(
    sample: &mut SampleCall<'_, NoRecorder, F>,
    coords: [&F32s; 3],
    class: TexelClass,
    selected: SelectedLevels<'_>,
    quads: &mut QuadScratch,
) -> Outcome {
    let texture = sample.texture;
    let Some(UniformLevels { filter, face, levels }) = selected.levels else {
        return Outcome::NotUniform;
    };
    if texture.has_fusible_texels && filter == Filter::Linear {
        let consumer = fused::WriteLanes(&mut *sample.out);
        let result = fused::sample_fused::<S, _>(texture, coords, selected, quads, consumer);
        return if result.is_ok() { Outcome::Sampled } else { Outcome::NotUniform };
    }
    let reference = match texture.compare {
        Some(_) => unit_range(sample.reference.unwrap_or(sample.coords[2])),
        None => F32s::ZERO,
    };
    // Initialized only where there is a second level.
    let mut second = None;
    let is_mixed = levels[0] != levels[1];
    for (index, number) in levels.into_iter().take(1 + usize::from(is_mixed)).enumerate() {
        let view = face_view(texture, filter, face, number);
        let out = match index {
            0 => &mut *sample.out,
            _ => second.get_or_insert([F32s::ZERO; 4]),
        };
        let is_done = match (filter, texture.compare) {
            (Filter::Linear, Some(op)) => {
                let (view, at, reference, out) = (&view, coords, &reference, &mut out[0]);
                LookupKernel::UniformCompared.note();
                S::outlined(LinearCompared { view, class, at, op, reference, out })
            }
            (Filter::Nearest, _) | (Filter::Linear, None) => {
                match filter {
                    Filter::Nearest => LookupKernel::UniformNearest.note(),
                    Filter::Linear => LookupKernel::UniformLinear.note(),
                }
                let (view, texels, out) = (&view, FastTexels::Words(class), &mut *out);
                S::outlined(FastPath { view, texels, at: coords, out })
            }
        };
        if !is_done {
            return Outcome::NotUniform;
        }
        if let (Filter::Nearest, Some(op)) = (filter, texture.compare) {
            LookupKernel::UniformNearestCompared.note();
            compare(op, &reference, &mut out[0]);
        }
    }
    if let Some(second) = &second {
        LookupKernel::UniformTwoLevels.note();
        let channels = texture.format.channels();
        for (out, second) in sample.out.iter_mut().zip(second).take(channels) {
            let first = *out;
            mix(&first, second, selected.weight, out);
        }
    }
    expand::expand(texture.format, texture.depth_mode, sample.out);
    expand::swizzle(texture.format, texture.swizzle, sample.out);
    Outcome::Sampled
}
