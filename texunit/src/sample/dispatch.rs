//! Kernel dispatch: the methods of [`SamplePlan`] that sample.

use super::call::SampleCall;
use super::direct::DirectLookup;
use super::fast::Addresses;
use super::footprint::{AllFootprints, FootprintSet, IsotropicAndProbes, RowScans};
use super::fused::{self, TexelConsumer};
use super::gather::Gather;
use super::lod_query::Query;
use super::lookup::{Lod, Points};
use super::prefetch::{self, LevelHint};
use super::recorder::{LaneRecorder, NoRecorder};
use super::scattered::ScatteredCall;
use super::scratch::{AxisTexels, LevelScratch, LookupScratch, QuadScratch, SelectedLevels};
use super::texel_fetch::Fetch;
use super::uniform::{Outcome, UniformCall};
use super::uniform_levels::{self, UniformLevels};
use crate::kernels::LookupKernel;
use crate::lanes::{Baseline, F32s, I32s, Isa, Kernel, LANES, Simd, U32s};
use crate::plan::{SampleKernel, SamplePlan, TexelClass, Texture};
use crate::trace::SampleTrace;
use std::marker::PhantomData;

/// The texel of an incomplete texture (GL 2.1, section 3.11.2).
const OPAQUE_BLACK: [F32s; 4] = [F32s::ZERO, F32s::ZERO, F32s::ZERO, F32s::splat(1.0)];

/// Lookups with the plan select levels or filters, or read more than one texel of one word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotDirect;

impl SamplePlan {
    /// Samples 64 lanes at these [`Points`], those of an array of cubes in its first. Components of
    /// integer formats are bits, not numbers.
    pub fn sample(
        &self,
        isa: Isa,
        coords: [&F32s; 3],
        reference: Option<&F32s>,
        lod: Lod<'_>,
        out: &mut [F32s; 4],
    ) {
        let mut scratch = LookupScratch::default();
        let points = Points { coords, layer: None, reference };
        self.sample_offset(isa, points, [0; 3], lod, Addresses::Compute, &mut scratch);
        *out = scratch.lanes;
    }

    /// [`SamplePlan::sample`] with texels added along s, t, r on each level that is read
    /// (`textureOffset`, GLSL 1.30, section 8.7). The result is in `scratch.lanes`. λ does not depend on the offset.
    /// With [`Addresses::Reuse`], levels and texel addresses are those of the previous lookup, in `scratch`.
    #[inline(always)]
    pub fn sample_offset(
        &self,
        isa: Isa,
        points: Points<'_>,
        offset: [i32; 3],
        lod: Lod<'_>,
        addresses: Addresses,
        scratch: &mut LookupScratch,
    ) {
        let LookupScratch { lanes: out, quads, levels, axes: _ } = scratch;
        match self.texture() {
            Some(texture) => {
                let (recorder, footprints) = (&mut NoRecorder, PhantomData::<IsotropicAndProbes>);
                let Points { coords, layer, reference } = points;
                let (coords, lod) = (&coords, &lod);
                let sample = SampleCall {
                    texture,
                    coords,
                    layer,
                    reference,
                    offset,
                    lod,
                    out,
                    recorder,
                    footprints,
                };
                // Separate kernels keep the code of each small.
                match (texture.kernel, lod) {
                    (SampleKernel::UniformLevel(class), _) if offset == [0; 3] => {
                        let scratch = (quads, levels);
                        sample.run_uniform::<IsotropicAndProbes>(isa, class, addresses, scratch);
                    }
                    (SampleKernel::RowScan, Lod::Gradient { bias: None, .. })
                        if offset == [0; 3] && texture.is_fusible =>
                    {
                        let (class, scratch) = (TexelClass::Bytes, (quads, levels));
                        sample.run_uniform::<RowScans>(isa, class, addresses, scratch);
                    }
                    (SampleKernel::Scattered(class), _) if offset == [0; 3] => {
                        sample.run_scattered(isa, class, quads);
                    }
                    (SampleKernel::RowScan, Lod::Implicit { .. } | Lod::Gradient { .. }) => {
                        sample.with_footprints::<RowScans>().run_on(isa);
                    }
                    // With an explicit λ there is no footprint.
                    (SampleKernel::RowScan, Lod::Explicit(_))
                    | (
                        SampleKernel::UniformLevel(_)
                        | SampleKernel::Scattered(_)
                        | SampleKernel::General(_),
                        _,
                    ) => {
                        sample.run_on(isa);
                    }
                }
            }
            None => *out = OPAQUE_BLACK,
        }
    }

    /// A lookup without offset within a kernel, from coordinates in `registers` to components in `registers`, those that
    /// are used. Same bits as [`SamplePlan::sample_offset`]. `axes` says of s and t whether texels are computed.
    ///
    /// # Errors
    /// When lookups with this plan are not of that form: nothing is written.
    #[inline(always)]
    pub fn sample_registers<S: Simd>(
        &self,
        registers: &mut [U32s],
        coords: [usize; 2],
        (axes, scratch): ([AxisTexels; 2], &mut LookupScratch),
        out: [Option<usize>; 4],
    ) -> Result<(), NotDirect> {
        match self.texture() {
            Some(texture) if S::WIDE => {
                let Some(nearest) = &texture.direct else { return Err(NotDirect) };
                let kept = &mut scratch.axes;
                S::outlined(DirectLookup { texture, nearest, registers, coords, axes, kept, out });
                Ok(())
            }
            Some(_) | None => Err(NotDirect),
        }
    }

    /// Prefetches texels that [`SamplePlan::sample_fused`] will read at these points (s and t), within a kernel. The
    /// points may be of several batches; `hint` is about one of them.
    #[inline(always)]
    pub fn prefetch<S: Simd>(&self, points: [&F32s; 2], hint: LevelHint<'_>) {
        if let Some(texture) = self.texture()
            && S::WIDE
            && texture.is_fusible
        {
            prefetch::prefetch::<S>(texture, points, hint);
        }
    }

    /// Whether [`SamplePlan::uniform_levels`] may return levels: they depend on the level of detail alone.
    pub fn selects_uniform_levels(&self, isa: Isa) -> bool {
        isa.is_wide() && self.texture().is_some_and(|texture| texture.is_fusible)
    }

    /// Whether [`SamplePlan::sample_fused`] takes its fast path wherever [`SamplePlan::uniform_levels`] returns levels:
    /// it then reads nothing of `lod`.
    pub fn fuses_uniform_levels(&self, isa: Isa) -> bool {
        let always = |texture: &Texture| texture.is_fusible && texture.fused_always_applies();
        isa.is_wide() && self.texture().is_some_and(always)
    }

    /// The levels that all lanes of a batch with these coordinates read, within a kernel; `None` where lanes read
    /// different levels, or the plan has no fused lookup. `weight` gets the weight of the second level.
    #[inline(always)]
    pub fn uniform_levels<S: Simd>(
        &self,
        coords: [&F32s; 3],
        lod: &Lod<'_>,
        weight: &mut F32s,
    ) -> Option<UniformLevels> {
        match self.texture() {
            Some(texture) if S::WIDE && texture.is_fusible => {
                uniform_levels::select::<S>(texture, &coords, lod, weight)
            }
            Some(_) | None => None,
        }
    }

    /// [`SamplePlan::sample`] within a kernel, without depth compare. `consumer` is compiled into the filter where texels
    /// are bytes and all lanes read the same level, or the same two; else it reads lanes that were stored. `selected` is
    /// what [`SamplePlan::uniform_levels`] returned for this batch, or for one that reads the same levels.
    #[inline(always)]
    pub fn sample_fused<S: Simd, T: TexelConsumer>(
        &self,
        isa: Isa,
        coords: [&F32s; 3],
        lod: Lod<'_>,
        selected: SelectedLevels<'_>,
        scratch: &mut LookupScratch,
        consumer: T,
    ) -> T::Output {
        let consumer = match self.texture() {
            Some(texture) if S::WIDE && texture.is_fusible => {
                let quads = &mut scratch.quads;
                match fused::sample_fused::<S, T>(texture, coords, selected, quads, consumer) {
                    Ok(output) => return output,
                    Err(consumer) => consumer,
                }
            }
            Some(_) | None => consumer,
        };
        // The kernels that shaders call, too: inlined here, they would add a megabyte of code.
        LookupKernel::FusedStored.note();
        let points = Points { coords, layer: None, reference: None };
        self.sample_offset(isa, points, [0; 3], lod, Addresses::Compute, scratch);
        consumer.consume::<S>(&fused::LaneColors(&scratch.lanes))
    }

    /// The first component of the texels at (i, j + 1), (i + 1, j + 1), (i + 1, j) and (i, j) that a linear filter of the
    /// base level would weigh (`textureGather`). Of two axes; an incomplete image has zeros.
    pub fn gather(&self, isa: Isa, points: Points<'_>, offset: [i32; 2], out: &mut [F32s; 4]) {
        match self.texture() {
            Some(texture) => {
                LookupKernel::Gather.note();
                isa.run(Gather { texture, points, offset, out });
            }
            None => *out = [F32s::ZERO; 4],
        }
    }

    /// The level of detail of a lookup with these coordinates (`textureQueryLOD`): the level that
    /// it reads, counted from the base level, with a fraction where it mixes two; and λ with every
    /// bias before it is held in the sampler's range. An incomplete image has zeros.
    pub fn query_lod(&self, isa: Isa, coords: [&F32s; 3], lod: Lod<'_>, out: &mut [F32s; 2]) {
        match self.texture() {
            Some(texture) => {
                LookupKernel::LodQuery.note();
                isa.run(Query { texture, coords, lod, out });
            }
            None => *out = [F32s::ZERO; 2],
        }
    }

    /// Single texels by column, row and slice (of an array: layer, after the coordinates that are
    /// filtered along), of a level counted from the base level (`texelFetch`). No filter, no wrap,
    /// no compare. A texel or level out of range reads as 0 in all components, and so do the
    /// border's texels.
    pub fn fetch(
        &self,
        isa: Isa,
        texel: [&I32s; 3],
        level: &I32s,
        offset: [i32; 3],
        out: &mut [F32s; 4],
    ) {
        match self.texture() {
            Some(texture) => {
                LookupKernel::TexelFetch.note();
                isa.run(Fetch { texture, texel, level, offset, out });
            }
            None => *out = OPAQUE_BLACK,
        }
    }

    /// Samples as [`SamplePlan::sample_offset`] does, and records the steps of `lane` (below 64). No steps for an incomplete texture.
    pub fn trace(
        &self,
        lane: usize,
        points: Points<'_>,
        offset: [i32; 3],
        lod: Lod<'_>,
    ) -> SampleTrace {
        let lane = lane % LANES;
        let mut out = [F32s::ZERO, F32s::ZERO, F32s::ZERO, F32s::splat(1.0)];
        let mut recorder = LaneRecorder::new(lane);
        if let Some(texture) = self.general().texture() {
            let (out, recorder) = (&mut out, &mut recorder);
            let footprints = PhantomData::<AllFootprints>;
            let Points { coords, layer, reference } = points;
            let (coords, lod) = (&coords, &lod);
            let sample = SampleCall {
                texture,
                coords,
                layer,
                reference,
                offset,
                lod,
                out,
                recorder,
                footprints,
            };
            sample.run_in_baseline();
        }
        SampleTrace {
            coords: points.coords.map(|coord| coord[lane]),
            steps: recorder.steps,
            result: out.map(|channel| channel[lane]),
        }
    }
}

impl<'a, F: FootprintSet> SampleCall<'a, NoRecorder, F> {
    /// Runs the kernel of [`super::uniform`] if it applies, else the general one for these footprints. Texels are of this
    /// class.
    #[inline]
    pub fn run_uniform<G: FootprintSet>(
        mut self,
        isa: Isa,
        class: TexelClass,
        addresses: Addresses,
        (quads, levels): (&mut QuadScratch, &mut LevelScratch),
    ) {
        let sample = &mut self;
        match isa.run_above_baseline(UniformCall { sample, class, addresses, quads, levels }) {
            Ok(Outcome::Sampled) => {}
            Ok(Outcome::NotUniform) | Err(UniformCall { .. }) => {
                self.with_footprints::<G>().run_on(isa);
            }
        }
    }

    /// Runs the kernel of [`super::scattered`], on the baseline the general one. Texels are of this class.
    #[inline]
    pub fn run_scattered(mut self, isa: Isa, class: TexelClass, quads: &mut QuadScratch) {
        let sample = &mut self;
        if isa.run_above_baseline(ScatteredCall { sample, class, quads }).is_err() {
            self.run_on(isa);
        }
    }

    /// The call with a kernel for other footprints.
    pub fn with_footprints<G: FootprintSet>(self) -> SampleCall<'a, NoRecorder, G> {
        let Self { texture, coords, layer, reference, offset, lod, out, recorder, footprints: _ } =
            self;
        let footprints = PhantomData;
        SampleCall { texture, coords, layer, reference, offset, lod, out, recorder, footprints }
    }

    /// Runs the general kernel as compiled for an instruction set.
    #[inline]
    pub fn run_on(self, isa: Isa) {
        if let Err(sample) = isa.run_above_baseline(self) {
            let Self { texture, coords, layer, reference, offset, lod, out, .. } = sample;
            let (recorder, footprints) = (&mut LaneRecorder::disabled(), PhantomData);
            SampleCall {
                texture,
                coords,
                layer,
                reference,
                offset,
                lod,
                out,
                recorder,
                footprints,
            }
            .run_in_baseline();
        }
    }
}

impl SampleCall<'_, LaneRecorder, AllFootprints> {
    /// The only kernel of the baseline, and that of traces: one copy of the code.
    #[inline(never)]
    pub fn run_in_baseline(self) {
        self.run::<Baseline>();
    }
}
