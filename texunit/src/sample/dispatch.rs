//! Which kernel samples: the methods of [`SamplePlan`] that sample, and each kernel as compiled for an instruction set.

use super::call::SampleCall;
use super::fast::Places;
use super::footprint::{AnyFootprint, FootprintSet, RoundAndProbes, RowScans};
use super::fused::{self, Take};
use super::gather::Gather;
use super::lod_query::Query;
use super::lookup::{Lod, Points};
use super::prefetch::{self, Like};
use super::recorder::{LaneRecorder, NoRecorder};
use super::scratch::{Known, LevelScratch, QuadScratch, Room};
use super::texel_fetch::Fetch;
use super::uniform::{Outcome, UniformCall};
use super::uniform_levels::{self, Read};
use crate::lanes::{Baseline, F32s, I32s, Isa, Kernel, LANES, Simd};
use crate::plan::{SampleKernel, SamplePlan, TexelClass, Texture};
use crate::trace::SampleTrace;
use std::marker::PhantomData;

/// What an incomplete texture gives (GL 2.1, section 3.11.2).
const OPAQUE_BLACK: [F32s; 4] = [F32s::ZERO, F32s::ZERO, F32s::ZERO, F32s::splat(1.0)];

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
        let mut room = Room::default();
        let points = Points { coords, layer: None, reference };
        self.sample_offset(isa, points, [0; 3], lod, Places::Own, &mut room);
        *out = room.lanes;
    }

    /// [`SamplePlan::sample`] with texels added along s, t, r on each level that is read
    /// (`textureOffset`, GLSL 1.30, section 8.7), into the lanes of `room`. λ does not depend on them. With
    /// [`Places::Kept`] what the lookup before found in this room is not looked for again.
    #[inline(always)]
    pub fn sample_offset(
        &self,
        isa: Isa,
        points: Points<'_>,
        offset: [i32; 3],
        lod: Lod<'_>,
        places: Places,
        room: &mut Room,
    ) {
        let Room { lanes: out, squares, detail } = room;
        match self.texture() {
            Some(texture) => {
                let (recorder, footprints) = (&mut NoRecorder, PhantomData::<RoundAndProbes>);
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
                // Kernels of their own: none pays for another's size.
                match (texture.kernel, lod) {
                    (SampleKernel::UniformLevel(class), _) if offset == [0; 3] => {
                        sample.run_uniform(isa, class, places, (squares, detail));
                    }
                    (SampleKernel::RowScan, Lod::Implicit { .. } | Lod::Gradient { .. }) => {
                        sample.with_footprints::<RowScans>().run_on(isa);
                    }
                    // With a level that is told, the footprint is not looked at.
                    (SampleKernel::RowScan, Lod::Explicit(_))
                    | (SampleKernel::UniformLevel(_) | SampleKernel::Probes, _) => {
                        sample.run_on(isa)
                    }
                }
            }
            None => *out = OPAQUE_BLACK,
        }
    }

    /// Asks for the texels that [`SamplePlan::take`] will read around these points (s and t), as part of a kernel.
    /// `like` is of one of the batches that the points are of.
    #[inline(always)]
    pub fn ask<S: Simd>(&self, points: [&F32s; 2], like: Like<'_>) {
        if let Some(texture) = self.texture()
            && S::WIDE
            && texture.is_fusible
        {
            prefetch::ask::<S>(texture, points, like);
        }
    }

    /// Whether what [`SamplePlan::read`] gives is all that [`SamplePlan::take`] needs of the level of detail, where
    /// all lanes read the same.
    pub fn takes_by_reading(&self, isa: Isa) -> bool {
        let takes = |texture: &Texture| texture.is_fusible && texture.fused_always_applies();
        isa.is_wide() && self.texture().is_some_and(takes)
    }

    /// What all lanes of a batch with these coordinates read, for [`SamplePlan::take`], as part of a kernel; `None`
    /// where they read different levels. Where they read two, `weight` takes that of the second.
    #[inline(always)]
    pub fn read<S: Simd>(
        &self,
        coords: [&F32s; 3],
        lod: &Lod<'_>,
        weight: &mut F32s,
    ) -> Option<Read> {
        match self.texture() {
            Some(texture) if S::WIDE && texture.is_fusible => {
                uniform_levels::select::<S>(texture, &coords, lod, weight)
            }
            Some(_) | None => None,
        }
    }

    /// [`SamplePlan::sample`] as part of a kernel, of images that are not compared. What it gives goes to `take`
    /// without a detour, where texels are bytes and all lanes read the same level, or the same two; else by way
    /// of lanes. What is `known` is what [`SamplePlan::read`] gave, of this batch or of one that reads the same.
    #[inline(always)]
    pub fn take<S: Simd, T: Take>(
        &self,
        isa: Isa,
        coords: [&F32s; 3],
        lod: Lod<'_>,
        known: Known<'_>,
        room: &mut Room,
        take: T,
    ) -> T::Output {
        let take = match self.texture() {
            Some(texture) if S::WIDE && texture.is_fusible => {
                let squares = &mut room.squares;
                match fused::sample_fused::<S, T>(texture, coords, known, squares, take) {
                    Ok(output) => return output,
                    Err(take) => take,
                }
            }
            Some(_) | None => take,
        };
        // By the same kernels that shaders call: another copy of them would be a megabyte.
        let points = Points { coords, layer: None, reference: None };
        self.sample_offset(isa, points, [0; 3], lod, Places::Own, room);
        take.take::<S>(&fused::LaneColors(&room.lanes))
    }

    /// The first component of the texels at (i, j + 1), (i + 1, j + 1), (i + 1, j) and (i, j) that a linear filter of the
    /// base level would weigh (`textureGather`). Of two axes; an incomplete image has zeros.
    pub fn gather(&self, isa: Isa, points: Points<'_>, offset: [i32; 2], out: &mut [F32s; 4]) {
        match self.texture() {
            Some(texture) => isa.run(Gather { texture, points, offset, out }),
            None => *out = [F32s::ZERO; 4],
        }
    }

    /// What level of detail a lookup with these coordinates has (`textureQueryLOD`): the level that
    /// it reads, counted from the base level, with a fraction where it mixes two; and λ with every
    /// bias before it is held in the sampler's range. An incomplete image has zeros.
    pub fn query_lod(&self, isa: Isa, coords: [&F32s; 3], lod: Lod<'_>, out: &mut [F32s; 2]) {
        match self.texture() {
            Some(texture) => isa.run(Query { texture, coords, lod, out }),
            None => *out = [F32s::ZERO; 2],
        }
    }

    /// Single texels by column, row and slice (of an array: layer, after the coordinates that are
    /// filtered along), of a level counted from the base level (`texelFetch`). No filter, no wrap,
    /// no compare. A texel or level that is not there gives 0 in all components, and so do the
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
            Some(texture) => isa.run(Fetch { texture, texel, level, offset, out }),
            None => *out = OPAQUE_BLACK,
        }
    }

    /// Samples as [`SamplePlan::sample_offset`] does, and notes how the result of `lane` (below 64)
    /// came about. No steps for an incomplete texture.
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
            let footprints = PhantomData::<AnyFootprint>;
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
    /// Runs it the shortest way if that leads there; texels are of this class.
    #[inline]
    pub fn run_uniform(
        mut self,
        isa: Isa,
        class: TexelClass,
        places: Places,
        (squares, detail): (&mut QuadScratch, &mut LevelScratch),
    ) {
        let sample = &mut self;
        match isa.run_above_baseline(UniformCall { sample, class, places, squares, detail }) {
            Ok(Outcome::Sampled) => {}
            Ok(Outcome::NotUniform) | Err(UniformCall { .. }) => self.run_on(isa),
        }
    }

    /// The same with a kernel that reads other footprints.
    pub fn with_footprints<G: FootprintSet>(self) -> SampleCall<'a, NoRecorder, G> {
        let Self { texture, coords, layer, reference, offset, lod, out, recorder, footprints: _ } =
            self;
        let footprints = PhantomData;
        SampleCall { texture, coords, layer, reference, offset, lod, out, recorder, footprints }
    }

    /// Runs it as compiled for an instruction set.
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

impl SampleCall<'_, LaneRecorder, AnyFootprint> {
    /// The one kernel of the baseline: traces run it too.
    #[inline(never)]
    pub fn run_in_baseline(self) {
        self.run::<Baseline>();
    }
}
