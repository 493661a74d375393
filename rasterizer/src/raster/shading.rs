//! Shading: runs batches of fragments, tests those that could not be tested before, and writes
//! their colours.

use super::batch::{Batch, BlockOf};
use super::inputs::{BatchDepth, BlockDepth, Interpolate, clamp_depth};
use super::samples::{SampleMasks, moved};
use super::tile::{DrawJob, PassJob, TileJob};
use super::watched::{Shaded, Tested};
use crate::driver::AlphaToOne;
use crate::output::{Fragments, test, write};
use crate::plan::{DrawPlan, Shading, Timing};
use crate::primitive::Facing;
use crate::shader::{Machine, OverBudget, Run};
use crate::target::{Place, TileTarget};
use crate::trace::{Fate, When};
use std::sync::atomic::Ordering;
use texunit::lanes::{F32s, Isa, Kernel, Simd};

/// The early tests of a whole block of one shape.
pub fn early_tests(
    isa: Isa,
    plan: &DrawPlan,
    of: &BlockOf<'_>,
    masks: &mut SampleMasks,
    tile: &mut TileJob,
) {
    let Some(target) = tile.depth.as_mut() else { return };
    let back = match of.facing {
        Facing::Front => 0,
        Facing::Back => !0,
    };
    for (sample, mask) in masks.iter_mut().enumerate() {
        let depth = match plan.depth_plane {
            Some(index) => {
                let plane = moved(of.planes[index], plan.samples.offset(sample));
                isa.run(BlockDepth { plane })
            }
            None => F32s::ZERO,
        };
        let fragments =
            Fragments { place: Place::Block(of.block), depth: &depth, back, mask: *mask };
        *mask = test(isa, &plan.tests, target, sample, &fragments);
    }
}

/// Runs batches and writes what comes out.
#[derive(Debug, Default)]
pub struct Shader {
    /// Runs the fragment program.
    pub machine: Machine,
    depth: F32s,
}

impl Shader {
    /// Makes the early tests that a batch still has to make, and shades what is left; a shader that
    /// runs over its budget stops the draw.
    pub fn shade(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        mut batch: Batch<'_>,
        tile: &mut TileJob,
    ) {
        let plan = &job.plan;
        let is_due = plan.timing == Timing::Early && batch.tested != !0;
        if is_due && let Some(target) = tile.depth.as_mut() {
            let due = batch.masks.map(|mask| mask & !batch.tested);
            let passed = self.test(pass.isa, plan, &batch, target, due, None, |_| {});
            for (mask, passed) in batch.masks.iter_mut().zip(passed.iter()) {
                *mask = *mask & batch.tested | passed;
            }
        }
        let batch = &batch;
        if plan.shading == Shading::Off {
            job.count(&batch.masks);
            return;
        }
        if batch.masks.any() == 0 {
            return;
        }
        let place = batch.place();
        let watched = tile.watched.as_mut();
        let mut shaded = watched.and_then(|spot| spot.begin(place, batch.masks.any()));
        match self.run(pass, job, batch, &mut shaded) {
            Ok(masks) => self.output(pass, job, batch, (place, masks), tile, &mut shaded),
            Err(OverBudget) => job.stopped.store(true, Ordering::Relaxed),
        }
        if let (Some(spot), Some(shaded)) = (&mut tile.watched, shaded) {
            spot.end(shaded);
        }
    }

    /// Runs the fragment program; gives the lanes that are left, by sample.
    fn run(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        batch: &Batch<'_>,
        shaded: &mut Option<Shaded>,
    ) -> Result<SampleMasks, OverBudget> {
        let (isa, plan) = (pass.isa, &job.plan);
        isa.run(Interpolate { plan, batch, machine: &mut self.machine, depth: &mut self.depth });
        let run = Run {
            isa,
            program: &plan.pipeline.compiled().fragment,
            prepared: &plan.prepared,
            textures: &plan.textures,
            active: batch.active(),
            budget: pass.budget,
        };
        let kept = match shaded {
            None => self.machine.run(run)?,
            Some(shaded) => shaded.run(&mut self.machine, plan, batch, run)?,
        };
        let samples = &plan.samples;
        let mut masks = batch.masks.map(|mask| mask & kept);
        if let Some(alpha) = samples.alpha {
            samples.mask_by_alpha(isa, self.machine.output(alpha).as_f32(), &mut masks);
        }
        if let Some(shaded) = shaded {
            shaded.ends_unless_in(&masks, Fate::Discarded);
        }
        Ok(masks)
    }

    /// The tests that had to wait, and the colours.
    fn output(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        batch: &Batch<'_>,
        (place, mut masks): (Place<'_>, SampleMasks),
        tile: &mut TileJob,
        shaded: &mut Option<Shaded>,
    ) {
        let (isa, plan) = (pass.isa, &job.plan);
        let samples = &plan.samples;
        if masks.any() == 0 {
            return;
        }
        let stored = shaded.as_ref().map(|_| tile.watched_depth());
        let mut depths = Vec::new();
        if let (Timing::Late(output), Some(target)) = (plan.timing, tile.depth.as_mut()) {
            masks = self.test(isa, plan, batch, target, masks, output, |depth| {
                if let Some(shaded) = &*shaded {
                    depths.push(depth[shaded.lane]);
                }
            });
            if let (Some(shaded), Some(before)) = (&mut *shaded, stored) {
                let after = &tile.watched_depth();
                let when = When::Late;
                let tested = Tested { when, depths: &depths, before: &before, after };
                shaded.tested(plan, &tested, &masks);
                shaded.ends_unless_in(&masks, Fate::TestFailed);
            }
            if masks.any() == 0 {
                return;
            }
        }
        job.count(&masks);
        for color in &plan.colors {
            let before = shaded.as_ref().map(|_| tile.watched_color(color.target));
            let Some(target) = tile.colors[color.target].as_mut() else { continue };
            let machine = &self.machine;
            let mut rgba = [0, 1, 2, 3]
                .map(|i| color.outputs[i].map(|output| machine.output(output).as_f32()));
            if samples.alpha_to_one == AlphaToOne::On {
                // A component that no program writes: alpha is 1.
                rgba[3] = None;
            }
            for (sample, &mask) in masks.iter().enumerate() {
                if mask != 0 {
                    write(isa, color, target, sample, place, rgba, mask);
                }
            }
            if let (Some(shaded), Some(before)) = (&mut *shaded, before) {
                shaded.written(color, rgba, &masks, [&before, &tile.watched_color(color.target)]);
            }
        }
    }
}

impl Shader {
    /// The stencil and depth tests of the lanes of `masks`; gives those that passed. `output` is the
    /// program output that holds the depth, if any does; `see` is shown the depth of each sample.
    #[expect(clippy::too_many_arguments, reason = "of a test that two places make")]
    fn test(
        &mut self,
        isa: Isa,
        plan: &DrawPlan,
        batch: &Batch<'_>,
        target: &mut TileTarget,
        mut masks: SampleMasks,
        output: Option<usize>,
        mut see: impl FnMut(&F32s),
    ) -> SampleMasks {
        if let Some(output) = output {
            self.depth = *self.machine.output(output).as_f32();
            isa.run(ClampDepth(&mut self.depth));
        }
        let (back, place) = (batch.back(), batch.place());
        for (sample, mask) in masks.iter_mut().enumerate() {
            let offset = plan.samples.offset(sample);
            if let (Some(plane), None) = (plan.depth_plane, output)
                && (sample == 0 || offset.is_some())
            {
                isa.run(BatchDepth { batch, plane, offset, depth: &mut self.depth });
            }
            let fragments = Fragments { place, depth: &self.depth, back, mask: *mask };
            *mask = test(isa, &plan.tests, target, sample, &fragments);
            see(&self.depth);
        }
        masks
    }
}

/// [`clamp_depth`] as a kernel.
struct ClampDepth<'a>(&'a mut F32s);

impl Kernel for ClampDepth<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        clamp_depth(self.0);
    }
}
