//! A tile: everything of a pass that touches its 64×64 pixels, in order.

mod block_tests;
mod fill;
mod fill_large;

use super::batch::{EarlyTests, Packed};
use super::block::BlockAt;
use super::block_group::{BlockGroup, UniformOverShape};
use super::clear::clear;
use super::hidden::TileCover;
use super::interpolate::PlaneSetup;
use super::job::{Chunk, DrawJob, PassJob, TileCommand, TileJob};
use super::large_triangles::LargeTriangle;
use super::pack_pixels::{Pack, Stop};
use super::pixel_batch::Pixels;
use super::plane_group::PlaneGroup;
use super::sampled_triangle::SampledTriangle;
use super::shading::Shader;
use super::shape_cover::Cover;
use super::shape_lanes::ShapeLanes;
use super::small_triangles::Windows;
use super::tile_planes::TilePlanes;
use super::window_blocks::{DivideWindows, WindowBlock, WindowBlocks};
use crate::kernels::PixelKernel;
use crate::plan::{FragmentInput, Packing, SampleMasks};
use crate::primitive::{ConstantDirection, DepthSetup};
use fill::ShapeBlock;
use texunit::lanes::{F32s, LANES, U32s, prefetch};

/// The least number of shapes in a group for which windows are computed.
const WINDOWS_FROM: usize = 4;

/// Scratch of a thread that runs tiles, kept from tile to tile.
#[derive(Debug, Default)]
pub struct TileRenderer {
    shader: Shader,
    /// Quads of the current draw that are collected for a batch.
    pending_quads: Packed,
    /// Pixels of the current draw that are collected for a batch.
    pending_pixels: Pixels,
    /// Blocks of the current draw that are collected for a block group.
    pending_blocks: BlockGroup,
    /// The shapes of the group, over lanes.
    shapes: Box<ShapeLanes>,
    group: PlaneGroup,
    windows: Box<Windows>,
    window_blocks: Box<WindowBlocks>,
    large_triangle: LargeTriangle,
    /// The planes of the current large triangle.
    tile_planes: TilePlanes,
    sampled_triangle: Box<SampledTriangle>,
    /// Of the current block: each plane's value at its first pixel and steps.
    planes: Vec<[f32; 3]>,
    /// The fraction of each lane's pixel that the shape covers.
    coverage: F32s,
    /// The outline of the current shape relative to each sample; one if all samples share it.
    outlines: Vec<Cover>,
    /// The current draw.
    draw: Option<usize>,
    /// What is uniform over the current shape.
    uniform: UniformOverShape,
    /// The number of shapes numbered so far.
    shape_count: u64,
}

impl TileRenderer {
    /// Runs all commands of a tile.
    pub fn run(&mut self, pass: &PassJob, tile: &mut TileJob) {
        self.shader.budget.begin_tile();
        let cover = TileCover::last(pass, tile);
        if cover.is_some() {
            PixelKernel::Covered.note();
        }
        let commands = std::mem::take(&mut tile.commands);
        for (number, command) in commands.into_iter().enumerate() {
            let visible = match &cover {
                Some(cover) => cover.visible(pass, number, command),
                None => Some(command),
            };
            let Some(command) = visible else { continue };
            match command {
                TileCommand::Clear(index) => {
                    PixelKernel::Clear.note();
                    self.flush(pass, tile);
                    clear(pass, &pass.clears[index as usize], tile);
                    tile.record_clear(&pass.clears[index as usize]);
                }
                TileCommand::Shapes { chunk, first, end } => {
                    let chunk = &pass.chunks[chunk as usize];
                    let mut groups =
                        chunk.lists.binned[first as usize..end as usize].chunks(LANES).peekable();
                    while let Some(group) = groups.next() {
                        for &index in groups.peek().copied().unwrap_or_default() {
                            prefetch(&chunk.lists.shapes[index as usize]);
                        }
                        self.fill_group(pass, tile, chunk, group);
                    }
                }
            }
        }
        self.flush(pass, tile);
        self.charge(tile);
        self.draw = None;
        if let Some(pixel) = tile.watched.take() {
            pixel.finish();
        }
    }

    /// Makes `draw` the current draw.
    fn select(&mut self, pass: &PassJob, tile: &mut TileJob, draw: usize) {
        if self.draw == Some(draw) {
            return;
        }
        let last = self.draw.map(|last| &pass.draws[last]);
        if last.is_some_and(|last| last.can_share_batches(&pass.draws[draw]))
            && tile.watched.is_none()
        {
            self.draw = Some(draw);
            return;
        }
        self.flush(pass, tile);
        self.charge(tile);
        self.draw = Some(draw);
        self.shader.budget.begin(&pass.draws[draw].budget);
        let plan = &pass.draws[draw].plan;
        let machine = &mut self.shader.machine;
        machine.begin(&plan.pipeline.compiled().fragment);
        for (index, &input) in plan.inputs.iter().enumerate() {
            if input == FragmentInput::Zero {
                (0..plan.blocks_per_group)
                    .for_each(|file| machine.inputs_of(file)[index] = U32s::ZERO);
            }
        }
        self.pending_quads.clear(plan.planes.len(), plan.samples.count);
        self.pending_pixels.clear(plan.planes.len());
        self.planes.resize(plan.planes.len(), [0.0; 3]);
    }

    /// Charges the current draw for what it has run.
    fn charge(&mut self, tile: &mut TileJob) {
        tile.charges.extend(self.draw.and_then(|draw| self.shader.budget.charge(draw)));
    }

    /// Shades all pending fragments.
    fn flush(&mut self, pass: &PassJob, tile: &mut TileJob) {
        let Some(draw) = self.draw else { return };
        let job = &pass.draws[draw];
        self.flush_quads(pass, job, tile);
        self.flush_pixels(pass, job, tile);
        self.flush_blocks(pass, job, tile);
    }

    /// Shades the pending batches that hold fragments of these samples of a block: fragments of a sample keep their order.
    /// A sample is in one pending batch at most, so that no other batch has to precede them.
    #[inline]
    fn flush_overlapping(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        tile: &mut TileJob,
        block: usize,
        masks: &SampleMasks,
    ) {
        if self.pending_quads.has_pending(block, masks) {
            self.flush_quads(pass, job, tile);
        }
        // Draws with several samples have no pending pixels.
        if self.pending_pixels.has_pending(block, masks.any()) {
            self.flush_pixels(pass, job, tile);
        }
        if self.pending_blocks.has_pending(block, masks) {
            self.flush_blocks(pass, job, tile);
        }
    }

    /// Shades the pending quads.
    fn flush_quads(&mut self, pass: &PassJob, job: &DrawJob, tile: &mut TileJob) {
        if !self.pending_quads.is_empty() {
            self.shader.shade(pass, job, &self.pending_quads.batch(), tile);
            self.pending_quads.clear(job.plan.planes.len(), job.plan.samples.count);
        }
    }

    /// Shades the pending blocks.
    fn flush_blocks(&mut self, pass: &PassJob, job: &DrawJob, tile: &mut TileJob) {
        if self.pending_blocks.len() > 0 {
            self.shader.shade_group(pass, job, &mut self.pending_blocks, tile);
        }
    }

    /// Shades the pending pixels.
    fn flush_pixels(&mut self, pass: &PassJob, job: &DrawJob, tile: &mut TileJob) {
        if !self.pending_pixels.is_empty() {
            let batch = self.pending_pixels.batch(pass.isa, [tile.x, tile.y]);
            self.shader.shade(pass, job, &batch, tile);
            self.pending_pixels.clear(job.plan.planes.len());
        }
    }

    /// Fills shapes of one chunk, at most 64.
    fn fill_group(&mut self, pass: &PassJob, tile: &mut TileJob, chunk: &Chunk, group: &[u32]) {
        self.select(pass, tile, chunk.draw);
        let job = &pass.draws[chunk.draw];
        // Draws that share batches share the budget in the tile; whether one is stopped is its own.
        if job.budget.is_stopped || self.shader.budget.is_stopped() {
            return;
        }
        let plan = &job.plan;
        let setup = PlaneSetup {
            sources: &plan.planes,
            depth: DepthSetup {
                viewport: plan.viewport,
                offset: plan.offset,
                resolution: plan.resolution,
            },
            origin: plan.raster.point.origin,
            line_constant: ConstantDirection::of(&plan.raster.line),
        };
        let shapes = group.iter().map(|&index| &chunk.lists.shapes[index as usize]);
        self.shapes.load(shapes.clone());
        self.group.compute(pass.isa, &setup, &chunk.geometry, &self.shapes, shapes.clone());
        let has_windows =
            group.len() >= WINDOWS_FROM && plan.covers_by_outline() && tile.watched.is_none();
        if has_windows {
            let at = [tile.x, tile.y];
            self.windows.compute(pass.isa, at, &self.shapes);
            if plan.packing == Packing::Pixels {
                self.group.evaluate_windows(pass.isa, at, &self.windows);
                PixelKernel::PackedTriangle.note();
                self.pack_group(pass, tile, chunk, group);
                return;
            }
        }
        for (lane, shape) in shapes.enumerate() {
            if self.shader.budget.is_stopped() {
                return;
            }
            let window = if has_windows { self.windows.get(lane) } else { None };
            match window {
                Some(window) if window.is_sparse() => {
                    self.fill_window(pass, tile, job, shape.facing, lane, window);
                }
                Some(_) | None => self.fill(pass, tile, chunk, shape, lane),
            }
        }
    }

    /// Fills the shapes of a group that has windows, pixel by pixel where these are small.
    fn pack_group(&mut self, pass: &PassJob, tile: &mut TileJob, chunk: &Chunk, group: &[u32]) {
        let job = &pass.draws[chunk.draw];
        let shape = |lane: usize| &chunk.lists.shapes[group[lane] as usize];
        let (windows, window_blocks) = (&*self.windows, &mut *self.window_blocks);
        pass.isa.run(DivideWindows { windows, shapes: group.len(), window_blocks });
        loop {
            if self.shader.budget.is_stopped() {
                return;
            }
            let stop = pass.isa.run(Pack {
                shapes: &self.shapes,
                group: &self.group,
                window_blocks: &mut self.window_blocks,
                pixels: &mut self.pending_pixels,
                block_group: &self.pending_blocks,
            });
            match stop {
                Stop::Done => return,
                Stop::Pixels => self.flush_pixels(pass, job, tile),
                Stop::Blocks => self.flush_blocks(pass, job, tile),
                Stop::WholeBlock(WindowBlock { shape: lane, lanes: 0, .. }) => {
                    self.fill(pass, tile, chunk, shape(lane), lane);
                }
                Stop::WholeBlock(WindowBlock { shape: lane, index, block, lanes }) => {
                    for (to, plane) in self.planes.iter_mut().zip(self.group.in_window(lane, index))
                    {
                        *to = plane;
                    }
                    let at = BlockAt::numbered([tile.x, tile.y], block);
                    let mut masks = SampleMasks::one(lanes);
                    let facing = shape(lane).facing;
                    let shape_block = ShapeBlock { at, facing, tests: EarlyTests::Due };
                    self.fill_block(pass, tile, job, shape_block, &mut masks);
                }
            }
        }
    }
}
