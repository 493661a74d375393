//! Shading: runs batches of fragments, tests those that could not be tested before, and writes
//! their colours.

use super::batch::{Batch, BatchDepth, Interpolate, clamp_depth};
use super::samples::SampleMasks;
use super::tile::{DrawJob, PassJob, TileJob, any};
use super::watched::{Shaded, Tested};
use crate::driver::AlphaToOne;
use crate::output::{Fragments, test, write};
use crate::plan::Timing;
use crate::shader::{Machine, OverBudget, Run};
use crate::target::Place;
use crate::trace::{Fate, When};
use std::sync::atomic::Ordering;
use texunit::lanes::{F32s, Kernel, Simd};

/// Runs batches and writes what comes out.
#[derive(Debug, Default)]
pub struct Shader {
    /// Runs the fragment program.
    pub machine: Machine,
    depth: F32s,
}

impl Shader {
    /// Shades a batch; a shader that runs over its budget stops the draw.
    pub fn shade(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        batch: &Batch,
        place: Place<'_>,
        tile: &mut TileJob,
    ) {
        let watched = tile.watched.as_mut();
        let mut shaded = watched.and_then(|spot| spot.begin(place, any(&batch.masks)));
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
        batch: &Batch,
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
        batch: &Batch,
        (place, mut masks): (Place<'_>, SampleMasks),
        tile: &mut TileJob,
        shaded: &mut Option<Shaded>,
    ) {
        let (isa, plan) = (pass.isa, &job.plan);
        let samples = &plan.samples;
        if any(&masks) == 0 {
            return;
        }
        let stored = shaded.as_ref().map(|_| tile.watched_depth());
        let mut depths = Vec::new();
        if let (Timing::Late(output), Some(target)) = (plan.timing, tile.depth.as_mut()) {
            if let Some(output) = output {
                self.depth = *self.machine.output(output).as_f32();
                isa.run(ClampDepth(&mut self.depth));
            }
            let back = batch.back();
            for (sample, mask) in masks.iter_mut().enumerate().take(samples.count) {
                if let (Some(plane), Some(offset), None) =
                    (plan.depth_plane, samples.offset(sample), output)
                {
                    isa.run(BatchDepth { batch, plane, offset, depth: &mut self.depth });
                }
                let fragments = Fragments { place, depth: &self.depth, back, mask: *mask };
                *mask = test(isa, &plan.tests, target, sample, &fragments);
                if let Some(shaded) = shaded {
                    depths.push(self.depth[shaded.lane]);
                }
            }
            if let (Some(shaded), Some(before)) = (&mut *shaded, stored) {
                let after = &tile.watched_depth();
                let when = When::Late;
                let tested = Tested { when, depths: &depths, before: &before, after };
                shaded.tested(plan, &tested, &masks);
                shaded.ends_unless_in(&masks, Fate::TestFailed);
            }
            if any(&masks) == 0 {
                return;
            }
        }
        let masks = &masks[..samples.count];
        job.count(masks);
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
                shaded.written(color, rgba, masks, [&before, &tile.watched_color(color.target)]);
            }
        }
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
