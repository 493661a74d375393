//! Shading of [`Pixels`]: what [`Shader::shade`] does with quads, where a pixel has one sample and
//! nobody watches.

use super::{InterpolatePixels, PixelDepth, Pixels};
use crate::output::{Fragments, test, write};
use crate::plan::{DrawPlan, Shading, Timing};
use crate::raster::shading::{ClampDepth, Shader};
use crate::raster::tile::{DrawJob, PassJob, TileJob};
use crate::shader::{OverBudget, Run};
use crate::target::TileTarget;
use std::sync::atomic::Ordering;
use texunit::lanes::Isa;

impl Shader {
    /// Tests a batch, shades what is left and writes its colours; a shader that runs over its budget
    /// stops the draw.
    pub fn shade_pixels(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        pixels: &Pixels,
        tile: &mut TileJob,
    ) {
        let (isa, plan) = (pass.isa, &job.plan);
        let mut mask = pixels.mask();
        if let (Timing::Early, Some(target)) = (plan.timing, tile.depth.as_mut()) {
            mask = self.test_pixels(isa, plan, pixels, target, mask, None);
        }
        if plan.shading == Shading::Off {
            job.count(&[mask]);
            return;
        }
        if mask == 0 {
            return;
        }
        let (machine, depth) = (&mut self.machine, &mut self.depth);
        let at = [tile.x, tile.y];
        isa.run(InterpolatePixels { plan, pixels, tile: at, machine, depth });
        let run = Run {
            isa,
            program: &plan.pipeline.compiled().fragment,
            prepared: &plan.prepared,
            textures: &plan.textures,
            active: mask,
            budget: pass.budget,
        };
        mask &= match self.machine.run(run) {
            Ok(kept) => kept,
            Err(OverBudget) => {
                job.stopped.store(true, Ordering::Relaxed);
                return;
            }
        };
        if let (Timing::Late(output), Some(target)) = (plan.timing, tile.depth.as_mut())
            && mask != 0
        {
            mask = self.test_pixels(isa, plan, pixels, target, mask, output);
        }
        if mask == 0 {
            return;
        }
        job.count(&[mask]);
        for color in &plan.colors {
            let Some(target) = tile.colors[color.target].as_mut() else { continue };
            let machine = &self.machine;
            let rgba =
                color.outputs.map(|output| output.map(|output| machine.output(output).as_f32()));
            write(isa, color, target, 0, pixels.place(), rgba, mask);
        }
    }

    /// The stencil and depth tests of the lanes of `mask`; gives those that passed. `output` is the
    /// program output that holds the depth, if any does.
    fn test_pixels(
        &mut self,
        isa: Isa,
        plan: &DrawPlan,
        pixels: &Pixels,
        target: &mut TileTarget,
        mask: u64,
        output: Option<usize>,
    ) -> u64 {
        let depth = &mut self.depth;
        match (output, plan.depth_plane) {
            (Some(output), _) => {
                *depth = *self.machine.output(output).as_f32();
                isa.run(ClampDepth(depth));
            }
            (None, Some(plane)) => isa.run(PixelDepth { pixels, plane, depth }),
            (None, None) => {}
        }
        let fragments = Fragments { place: pixels.place(), depth, back: pixels.back, mask };
        test(isa, &plan.tests, target, 0, &fragments)
    }
}
