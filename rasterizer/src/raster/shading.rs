//! Shading: runs the program over batches of fragments, runs their late tests, and writes
//! their colours.

use super::batch::{Batch, BatchPixels, BlockOf};
use super::block_group::BlockGroup;
use super::budget::TileBudget;
use super::fragment_depth::BatchDepth;
use super::inputs::{Interpolate, InterpolateGroup};
use super::job::{DrawJob, PassJob, TileJob};
use super::texel_product::{Multiply, Products, WordSlot, Words};
use super::watched::{Shaded, Tested};
use crate::attachment::{BatchLayout, BlockDepth, TileTarget, clamp_depth};
use crate::desc::{AlphaToOne, Facing};
use crate::kernels::PixelKernel;
use crate::output::{
    BlockColors, ColorClass, ColorPlan, Fragments, Reference, store_samples, test, write_blocks,
    write_samples,
};
use crate::plan::{DrawPlan, SampleMasks, ShaderTestOutputs, Shading, TestTiming, moved};
use crate::shader::{Invocation, MAX_REGISTER_FILES, Machine, OverBudget, TexelProduct};
use crate::trace::{Fate, When};
use texunit::lanes::{F32s, Isa, Kernel, Simd, U32s};

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
                isa.run(BlockDepth { plane, depths: plan.viewport.depths() })
            }
            None => F32s::ZERO,
        };
        let (layout, reference) = (&BatchLayout::Block(of.block), Reference::OfFace);
        let fragments = Fragments { layout, depth: &depth, reference, back, mask: *mask };
        *mask = test(isa, &plan.tests, target, sample, &fragments);
    }
}

/// Writes the colours of a block group, the second ones those of its program: of a register file, an attachment's plan and a component.
#[inline(always)]
fn write_group<'a>(
    isa: Isa,
    job: &'a DrawJob,
    blocks: &BlockGroup,
    tile: &mut TileJob,
    machine: &'a Machine,
    color_of: impl Fn(usize, &'a ColorPlan, usize) -> &'a F32s,
) {
    for plan in &job.plan.colors {
        let Some(target) = tile.colors[plan.target].as_mut() else { continue };
        let colors_of = |file: usize| {
            let (block, masks) = blocks.covered(file);
            let of = |component| color_of(file, plan, component);
            // Not `map`, which stays a call for each.
            let color = [of(0), of(1), of(2), of(3)];
            let second = plan.second_color(|output| machine.output_of(file, output).as_f32());
            BlockColors { block, color, second, mask: masks.any() }
        };
        if job.plan.samples.count > 1 {
            for file in 0..blocks.len() {
                let (block, masks) = blocks.covered(file);
                let layout = &BatchLayout::Block(block);
                write_samples(isa, plan, target, layout, colors_of(file), masks);
            }
            continue;
        }
        // Entries beyond the last repeat the last and are not read. Written out, so that none is copied.
        let last = blocks.len().saturating_sub(1);
        let colors: [_; MAX_REGISTER_FILES] =
            [colors_of(0), colors_of(1.min(last)), colors_of(2.min(last)), colors_of(last)];
        write_blocks(isa, plan, target, &colors[..blocks.len()]);
    }
}

/// Runs batches and writes their results.
#[derive(Debug, Default)]
pub struct Shader {
    /// Runs the fragment program.
    pub machine: Machine,
    /// How long the current draw may run in the current tile.
    pub budget: TileBudget,
    products: Products,
    /// The words of the blocks of a group, of attachments with several samples.
    sampled_words: Box<[U32s; MAX_REGISTER_FILES]>,
    depth: F32s,
    /// The sample at which the batch is shaded and its planes are; none where fragments are shaded once.
    pub(super) sample: Option<usize>,
    /// The lanes of the batch that are neither discarded nor failed a test.
    left: SampleMasks,
}

impl Shader {
    /// Runs the early tests of a batch that are due, and shades the lanes that pass; a shader that
    /// runs over its budget stops the draw.
    pub fn shade(&mut self, pass: &PassJob, job: &DrawJob, batch: &Batch<'_>, tile: &mut TileJob) {
        if self.budget.is_stopped() {
            return;
        }
        let plan = &job.plan;
        match batch.pixels {
            BatchPixels::Block(_) => PixelKernel::Block.note(),
            BatchPixels::Packed(_) => PixelKernel::Quads.note(),
            BatchPixels::Pixels(_) => PixelKernel::Pixels.note(),
        }
        let is_due = plan.timing == TestTiming::Early && batch.tested != !0;
        match tile.depth.as_mut().filter(|_| is_due) {
            Some(target) => {
                PixelKernel::EarlyTests.note();
                self.left.set(batch.masks, !batch.tested);
                self.test(pass.isa, plan, batch, target, ShaderTestOutputs::default(), |_| {});
                let masks = &self.left.or(batch.masks, batch.tested);
                self.shade_tested(pass, job, &Batch { masks, ..*batch }, tile);
            }
            None => self.shade_tested(pass, job, batch, tile),
        }
    }

    /// Shades a block group, whose early tests are done, and empties it. Its plan has no late tests.
    pub fn shade_group(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        blocks: &mut BlockGroup,
        tile: &mut TileJob,
    ) {
        PixelKernel::BlockGroup.note();
        let (isa, plan, machine) = (pass.isa, &job.plan, &mut self.machine);
        tile.prefetch(plan, blocks.numbers());
        let program = &plan.pipeline.compiled().fragment;
        let product = plan.product.as_ref().zip(program.product());
        let all = &plan.interpolated_inputs[..];
        let inputs = match product {
            Some((of, _)) => self.products.inputs_of(plan, of, blocks),
            None => [all; 2],
        };
        isa.run(InterpolateGroup {
            plan,
            inputs,
            block_group: blocks,
            tile: [tile.x, tile.y],
            machine,
        });
        let invocation = Invocation {
            isa,
            program,
            prepared: &plan.prepared,
            textures: &plan.textures,
            active: !0,
            budget: u64::MAX,
        };
        let done = match product {
            Some((_, product)) => {
                self.products.begin(&mut self.machine, &invocation, product, blocks.len())
            }
            None => self.machine.run_files(invocation, blocks.len()),
        };
        if done.is_ok() {
            for file in 0..blocks.len() {
                job.count(blocks.covered(file).1);
            }
        }
        match (done, product) {
            (Ok(()), Some((_, product))) => self.multiply(isa, job, product, blocks, tile),
            (Ok(()), None) => {
                let machine = &self.machine;
                write_group(isa, job, blocks, tile, machine, |file, color, i| {
                    match color.outputs[i] {
                        Some(output) => machine.output_of(file, output).as_f32(),
                        None => color.unwritten(i),
                    }
                });
            }
            (Err(OverBudget), _) => self.budget.stop(),
        }
        blocks.clear();
    }

    /// Shades a block group of a program that is a product.
    fn multiply(
        &mut self,
        isa: Isa,
        job: &DrawJob,
        product: &TexelProduct,
        blocks: &BlockGroup,
        tile: &mut TileJob,
    ) {
        let Self { machine, products, sampled_words, .. } = self;
        let plan = &job.plan;
        let mut words = None;
        // Those of several samples are computed before they are stored in each.
        let mut sampled = None;
        if let [color] = &plan.colors[..]
            && color.class == ColorClass::Bytes
            && color.blend.is_none()
            && let Some(target) = tile.colors[color.target].as_mut()
        {
            let mut slots = [WordSlot::default(); MAX_REGISTER_FILES];
            if plan.samples.count > 1 {
                for (file, slot) in slots.iter_mut().enumerate() {
                    *slot = WordSlot { at: file, mask: !0 };
                }
                words = Some(Words { color, blocks: &mut sampled_words[..], slots });
                sampled = Some((color, target));
            } else if let [plane] = target.sample(0) {
                for (file, slot) in slots.iter_mut().enumerate().take(blocks.len()) {
                    let (block, masks) = blocks.covered(file);
                    *slot = WordSlot { at: block, mask: masks.any() };
                    plane.materialize(block, color.load_op_for_mask(slot.mask));
                }
                words = Some(Words { color, blocks: plane.materialized_blocks(), slots });
            }
        }
        let is_done = words.is_some();
        match (is_done, &sampled) {
            (true, Some(_)) => PixelKernel::ProductSamples.note(),
            (true, None) => PixelKernel::Product.note(),
            (false, _) => PixelKernel::ProductWritten.note(),
        }
        isa.run(Multiply { isa, plan, product, machine, block_group: blocks, products, words });
        products.finish_group(blocks);
        if let Some((color, target)) = sampled {
            for (file, word) in sampled_words.iter().enumerate().take(blocks.len()) {
                let (block, masks) = blocks.covered(file);
                store_samples(isa, color, target, (block, word), masks);
            }
        }
        if !is_done {
            let Self { machine, products, .. } = &*self;
            write_group(isa, job, blocks, tile, machine, |file, _, component| {
                products.color(file, component)
            });
        }
    }

    /// Shades the lanes that passed the early tests.
    pub(super) fn shade_tested(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        batch: &Batch<'_>,
        tile: &mut TileJob,
    ) {
        let plan = &job.plan;
        if plan.shading == Shading::Off {
            PixelKernel::DepthOnly.note();
            job.count(batch.masks);
            return;
        }
        if batch.masks.any() == 0 {
            return;
        }
        if plan.samples.is_shaded_each() && self.sample.is_none() {
            PixelKernel::SampleShading.note();
            self.shade_samples(pass, job, batch, tile);
        } else if tile.watched.is_some() {
            self.shade_watched(pass, job, batch, tile);
        } else {
            self.shade_and_trace(pass, job, batch, tile, &mut None);
        }
    }

    /// As [`Self::shade_and_trace`], in a tile of which a pixel is watched, outlined: its speed does not matter.
    #[cold]
    #[inline(never)]
    fn shade_watched(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        batch: &Batch<'_>,
        tile: &mut TileJob,
    ) {
        let pixel = tile.watched.as_mut();
        let mut shaded = pixel.and_then(|pixel| pixel.begin(batch.layout(), batch.masks.any()));
        self.shade_and_trace(pass, job, batch, tile, &mut shaded);
        if let (Some(pixel), Some(shaded)) = (&mut tile.watched, shaded) {
            pixel.end(shaded);
        }
    }

    /// Runs the program, the late tests and the output of a batch; records the watched fragment in `shaded`.
    #[inline(always)]
    fn shade_and_trace(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        batch: &Batch<'_>,
        tile: &mut TileJob,
        shaded: &mut Option<Shaded>,
    ) {
        match self.run(pass, job, batch, shaded) {
            Ok(()) => self.output(pass, job, batch, tile, shaded),
            Err(OverBudget) => self.budget.stop(),
        }
    }

    /// Runs the fragment program; leaves in `self.left` the lanes that are not discarded, by sample.
    #[inline(always)]
    fn run(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        batch: &Batch<'_>,
        shaded: &mut Option<Shaded>,
    ) -> Result<(), OverBudget> {
        let (isa, plan) = (pass.isa, &job.plan);
        let (machine, depth) = (&mut self.machine, &mut self.depth);
        let sample = self.sample.unwrap_or(0);
        isa.run(Interpolate { plan, batch, machine, depth, sample });
        let invocation = Invocation {
            isa,
            program: &plan.pipeline.compiled().fragment,
            prepared: &plan.prepared,
            textures: &plan.textures,
            active: batch.active(),
            budget: self.budget.of_batch(),
        };
        let alive = match shaded {
            None => self.machine.run(invocation)?,
            Some(shaded) => shaded.run(&mut self.machine, plan, batch, invocation)?,
        };
        self.budget.batch_left(self.machine.left());
        let samples = &plan.samples;
        self.left.set(batch.masks, alive);
        if let Some(mask) = samples.mask {
            samples.mask_by_program(self.machine.output(mask), &mut self.left);
        }
        if let Some(alpha) = samples.alpha {
            samples.mask_by_alpha(isa, self.machine.output(alpha).as_f32(), &mut self.left);
        }
        if let Some(shaded) = shaded {
            shaded.ends_unless_in(&self.left, Fate::Discarded);
        }
        Ok(())
    }

    /// The late tests, and the output of colours.
    #[inline(always)]
    fn output(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        batch: &Batch<'_>,
        tile: &mut TileJob,
        shaded: &mut Option<Shaded>,
    ) {
        let (isa, plan, layout) = (pass.isa, &job.plan, &batch.layout());
        let samples = &plan.samples;
        if let TestTiming::Late(written) = plan.timing
            && self.left.any() != 0
        {
            PixelKernel::LateTests.note();
            self.late_tests(isa, plan, batch, tile, written, shaded);
        }
        let masks = &self.left;
        if masks.any() == 0 {
            return;
        }
        job.count(masks);
        for color in &plan.colors {
            let before = shaded.as_ref().map(|_| tile.watched_color(color.target));
            let Some(target) = tile.colors[color.target].as_mut() else { continue };
            let machine = &self.machine;
            let output = |i: usize| match color.outputs[i] {
                Some(output) => machine.output(output).as_f32(),
                None => color.unwritten(i),
            };
            let mut rgba = [output(0), output(1), output(2), output(3)];
            if samples.alpha_to_one == AlphaToOne::On {
                rgba[3] = color.unwritten(3);
            }
            let mut second = color.second_color(|output| machine.output(output).as_f32());
            // Of each colour (GL 3.3, section 4.1.3).
            if let (AlphaToOne::On, Some(second)) = (samples.alpha_to_one, &mut second) {
                second[3] = color.unwritten(3);
            }
            let colors = BlockColors { block: 0, color: rgba, second, mask: 0 };
            write_samples(isa, color, target, layout, colors, masks);
            if let (Some(shaded), Some(before)) = (&mut *shaded, before) {
                shaded.written(
                    color,
                    (rgba, second),
                    masks,
                    [&before, &tile.watched_color(color.target)],
                );
            }
        }
    }

    /// The tests after the program, which has `written` some of the tested values.
    fn late_tests(
        &mut self,
        isa: Isa,
        plan: &DrawPlan,
        batch: &Batch<'_>,
        tile: &mut TileJob,
        written: ShaderTestOutputs,
        shaded: &mut Option<Shaded>,
    ) {
        let before = shaded.as_ref().map(|_| tile.watched_depth());
        let Some(target) = tile.depth.as_mut() else { return };
        let mut depths = Vec::new();
        self.test(isa, plan, batch, target, written, |depth| {
            if let Some(shaded) = &*shaded {
                depths.push(depth[shaded.lane]);
            }
        });
        if let (Some(shaded), Some(before)) = (shaded, before) {
            let (when, after) = (When::Late, &tile.watched_depth());
            let word = |output| self.machine.output(output)[shaded.lane] as u8;
            let reference = written.reference.map(word);
            let tested = Tested { when, depths: &depths, reference, before: &before, after };
            shaded.tested(plan, &tested, &self.left);
            shaded.ends_unless_in(&self.left, Fate::TestFailed);
        }
    }

    /// The stencil and depth tests of the remaining lanes; lanes that fail are removed. `written` are the outputs of
    /// the program for the tests; `record_depth` is called with the depth of each sample.
    fn test(
        &mut self,
        isa: Isa,
        plan: &DrawPlan,
        batch: &Batch<'_>,
        target: &mut TileTarget,
        written: ShaderTestOutputs,
        mut record_depth: impl FnMut(&F32s),
    ) {
        let depths = plan.viewport.depths();
        if let Some(output) = written.depth {
            self.depth = *self.machine.output(output).as_f32();
            isa.run(ClampDepth(&mut self.depth, depths));
        }
        let reference = match written.reference {
            Some(output) => Reference::Each(self.machine.output(output)),
            None => Reference::OfFace,
        };
        let (back, layout) = (batch.back(), &batch.layout());
        for (sample, mask) in self.left.iter_mut().enumerate() {
            let offset = plan.samples.offset(sample).filter(|_| self.sample.is_none());
            if let (Some(plane), None) = (plan.depth_plane, written.depth)
                && (sample == 0 || offset.is_some())
            {
                let depth = &mut self.depth;
                isa.run(BatchDepth { batch, plane, offset, depths, depth });
            }
            let depth = &self.depth;
            let fragments = Fragments { layout, depth, reference, back, mask: *mask };
            *mask = test(isa, &plan.tests, target, sample, &fragments);
            record_depth(&self.depth);
        }
    }
}

/// [`clamp_depth`] as a kernel.
struct ClampDepth<'a>(&'a mut F32s, [f32; 2]);

impl Kernel for ClampDepth<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        clamp_depth(self.0, self.1);
    }
}
