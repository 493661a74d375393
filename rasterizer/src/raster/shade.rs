//! A batch of fragments from the early tests to the attachments of its tile.

use super::batch::{Batch, BatchDepth, BlockDepth, BlockOf, Interpolate, clamp_depth};
use super::samples::{SampleMasks, moved};
use super::tile::{DrawJob, PassJob, TileJob};
use crate::driver::AlphaToOne;
use crate::output::{Fragments, test, write};
use crate::plan::{DrawPlan, Shading, Timing};
use crate::primitive::Facing;
use crate::shader::{Machine, Run};
use crate::target::{Place, TileTarget};
use std::sync::atomic::Ordering;
use texunit::lanes::{F32s, Isa, Kernel, Simd};

/// The lanes of which any sample is covered.
#[inline]
pub fn any(masks: &[u64]) -> u64 {
    masks.iter().fold(0, |all, mask| all | mask)
}

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
    for (sample, mask) in masks.iter_mut().enumerate().take(plan.samples.count) {
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
    pub machine: Machine,
    depth: F32s,
}

impl Shader {
    /// Tests, shades and writes a batch. What fails an early test is taken out of its masks.
    pub fn shade(&mut self, pass: &PassJob, job: &DrawJob, batch: &mut Batch, tile: &mut TileJob) {
        let (isa, plan) = (pass.isa, &job.plan);
        let samples = &plan.samples;
        if plan.timing == Timing::Early && batch.tested != !0 {
            if let Some(target) = tile.depth.as_mut() {
                let due = batch.masks.map(|mask| mask & !batch.tested);
                let passed = self.test(isa, plan, batch, target, due, None);
                for (mask, passed) in batch.masks.iter_mut().zip(passed) {
                    *mask = *mask & batch.tested | passed;
                }
            }
        }
        if plan.shading == Shading::Off {
            job.count(&batch.masks[..samples.count]);
            return;
        }
        let batch = &*batch;
        if any(&batch.masks) == 0 {
            return;
        }
        isa.run(Interpolate { plan, batch, machine: &mut self.machine, depth: &mut self.depth });
        let compiled = plan.pipeline.compiled();
        let kept = self.machine.run(Run {
            isa,
            program: &compiled.fragment,
            prepared: &plan.prepared,
            textures: &plan.textures,
            active: batch.active(),
            budget: pass.budget,
        });
        let Ok(kept) = kept else {
            job.stopped.store(true, Ordering::Relaxed);
            return;
        };
        let mut masks = batch.masks.map(|mask| mask & kept);
        if let Some(alpha) = samples.alpha {
            samples.mask_by_alpha(isa, self.machine.output(alpha).as_f32(), &mut masks);
        }
        if any(&masks) == 0 {
            return;
        }
        if let (Timing::Late(output), Some(target)) = (plan.timing, tile.depth.as_mut()) {
            masks = self.test(isa, plan, batch, target, masks, output);
            if any(&masks) == 0 {
                return;
            }
        }
        let masks = &masks[..samples.count];
        job.count(masks);
        for color in &plan.colors {
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
                    write(isa, color, target, sample, batch.place(), rgba, mask);
                }
            }
        }
    }

    /// The stencil and depth tests of the lanes of `masks`; gives those that passed. `output` is the
    /// program output that holds the depth, if any does.
    fn test(
        &mut self,
        isa: Isa,
        plan: &DrawPlan,
        batch: &Batch,
        target: &mut TileTarget,
        mut masks: SampleMasks,
        output: Option<usize>,
    ) -> SampleMasks {
        if let Some(output) = output {
            self.depth = *self.machine.output(output).as_f32();
            isa.run(ClampDepth(&mut self.depth));
        }
        let back = batch.back();
        for (sample, mask) in masks.iter_mut().enumerate().take(plan.samples.count) {
            let offset = plan.samples.offset(sample);
            if let (Some(plane), None) = (plan.depth_plane, output)
                && (sample == 0 || offset.is_some())
            {
                isa.run(BatchDepth { batch, plane, offset, depth: &mut self.depth });
            }
            let place = batch.place();
            let fragments = Fragments { place, depth: &self.depth, back, mask: *mask };
            *mask = test(isa, &plan.tests, target, sample, &fragments);
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
