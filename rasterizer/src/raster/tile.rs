//! A tile: everything of a pass that touches its 64×64 pixels, in order.

mod fill;

use super::batch::{EarlyTests, Packed};
use super::block::BlockAt;
use super::block_run::{BlockRun, Level};
use super::clear::clear;
use super::interpolate::PlaneSetup;
use super::job::{Chunk, DrawJob, Entry, PassJob, TileJob};
use super::large_triangles::LargeTriangle;
use super::pack_pixels::{Pack, Stop};
use super::pixel_batch::Pixels;
use super::plane_group::PlaneGroup;
use super::shading::Shader;
use super::shape_cover::Cover;
use super::shape_lanes::ShapeLanes;
use super::small_triangles::Windows;
use super::window_blocks::{Divide, Share, Shares};
use crate::plan::{FragmentInput, Packing, SampleMasks};
use crate::primitive::{Across, DepthSetup};
use fill::Part;
use std::sync::atomic::Ordering;
use texunit::lanes::{F32s, LANES, U32s, prefetch};

/// Shapes of a group from which on their windows are computed together.
const WINDOWS_FROM: usize = 4;

/// Scratch of a thread that runs tiles, kept from tile to tile.
#[derive(Debug, Default)]
pub struct Worker {
    shader: Shader,
    /// Quads that wait for others, of the current draw.
    waiting: Packed,
    /// Pixels that wait for others, of the current draw.
    pixels: Pixels,
    /// Blocks that wait for others, of the current draw.
    run: BlockRun,
    /// The shapes that are filled.
    shapes: Box<ShapeLanes>,
    group: PlaneGroup,
    windows: Box<Windows>,
    shares: Box<Shares>,
    broad: LargeTriangle,
    /// Of the block that is filled: each plane's value at its first pixel and steps.
    planes: Vec<[f32; 3]>,
    /// The fraction of each lane's pixel that the shape covers.
    parts: F32s,
    /// The outline of the shape that is filled, as each sample sees it; one if all see the same.
    covers: Vec<Cover>,
    /// The current draw.
    draw: Option<usize>,
    /// What is constant over the current shape.
    level: Level,
    /// The number of shapes numbered so far.
    levels: u64,
}

impl Worker {
    /// Runs all entries of a tile.
    pub fn run(&mut self, pass: &PassJob, tile: &mut TileJob) {
        let entries = std::mem::take(&mut tile.entries);
        for entry in entries {
            match entry {
                Entry::Clear(index) => {
                    self.flush(pass, tile);
                    clear(pass, &pass.clears[index as usize], tile);
                    tile.note_clear(&pass.clears[index as usize]);
                }
                Entry::Shapes { chunk, first, end } => {
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
        self.draw = None;
        if let Some(spot) = tile.watched.take() {
            spot.finish();
        }
    }

    /// Makes `draw` the current draw.
    fn select(&mut self, pass: &PassJob, tile: &mut TileJob, draw: usize) {
        if self.draw == Some(draw) {
            return;
        }
        let last = self.draw.map(|last| &pass.draws[last]);
        if last.is_some_and(|last| last.goes_on(&pass.draws[draw])) && tile.watched.is_none() {
            self.draw = Some(draw);
            return;
        }
        self.flush(pass, tile);
        self.draw = Some(draw);
        let plan = &pass.draws[draw].plan;
        let machine = &mut self.shader.machine;
        machine.begin(&plan.pipeline.compiled().fragment);
        for (index, &input) in plan.inputs.iter().enumerate() {
            if input == FragmentInput::Zero {
                (0..plan.blocks_per_run)
                    .for_each(|file| machine.inputs_of(file)[index] = U32s::ZERO);
            }
        }
        self.waiting.clear(plan.planes.len(), plan.samples.count);
        self.pixels.clear(plan.planes.len());
        self.planes.resize(plan.planes.len(), [0.0; 3]);
    }

    /// Shades what waits.
    fn flush(&mut self, pass: &PassJob, tile: &mut TileJob) {
        let Some(draw) = self.draw else { return };
        let job = &pass.draws[draw];
        self.flush_quads(pass, job, tile);
        self.flush_pixels(pass, job, tile);
        self.flush_run(pass, job, tile);
    }

    /// Shades waiting fragments in these lanes of a block, which later ones must not overtake. No pixel waits twice,
    /// so
    /// that nothing else has to go first.
    #[inline]
    fn make_way(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        tile: &mut TileJob,
        block: usize,
        lanes: u64,
    ) {
        if self.waiting.holds(block, lanes) {
            self.flush_quads(pass, job, tile);
        }
        if self.pixels.holds(block, lanes) {
            self.flush_pixels(pass, job, tile);
        }
        if self.run.holds(block, lanes) {
            self.flush_run(pass, job, tile);
        }
    }

    /// Shades the quads that wait.
    fn flush_quads(&mut self, pass: &PassJob, job: &DrawJob, tile: &mut TileJob) {
        if !self.waiting.is_empty() {
            self.shader.shade(pass, job, &self.waiting.batch(), tile);
            self.waiting.clear(job.plan.planes.len(), job.plan.samples.count);
        }
    }

    /// Shades the blocks that wait.
    fn flush_run(&mut self, pass: &PassJob, job: &DrawJob, tile: &mut TileJob) {
        if self.run.len() > 0 {
            self.shader.shade_run(pass, job, &mut self.run, tile);
        }
    }

    /// Shades the pixels that wait.
    fn flush_pixels(&mut self, pass: &PassJob, job: &DrawJob, tile: &mut TileJob) {
        if !self.pixels.is_empty() {
            let batch = self.pixels.batch(pass.isa, [tile.x, tile.y]);
            self.shader.shade(pass, job, &batch, tile);
            self.pixels.clear(job.plan.planes.len());
        }
    }

    /// Fills shapes of one chunk, at most 64.
    fn fill_group(&mut self, pass: &PassJob, tile: &mut TileJob, chunk: &Chunk, group: &[u32]) {
        self.select(pass, tile, chunk.draw);
        let job = &pass.draws[chunk.draw];
        if job.stopped.load(Ordering::Relaxed) {
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
            across: Across::of(&plan.raster.line),
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
                self.group.enter(pass.isa, at, &self.windows);
                self.pack_group(pass, tile, chunk, group);
                return;
            }
        }
        for (lane, shape) in shapes.enumerate() {
            if job.stopped.load(Ordering::Relaxed) {
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
        let (windows, shares) = (&*self.windows, &mut *self.shares);
        pass.isa.run(Divide { windows, shapes: group.len(), shares });
        loop {
            if job.stopped.load(Ordering::Relaxed) {
                return;
            }
            let stop = pass.isa.run(Pack {
                shapes: &self.shapes,
                group: &self.group,
                shares: &mut self.shares,
                pixels: &mut self.pixels,
                run: &self.run,
            });
            match stop {
                Stop::Done => return,
                Stop::Pixels => self.flush_pixels(pass, job, tile),
                Stop::Blocks => self.flush_run(pass, job, tile),
                Stop::Share(Share { shape: lane, lanes: 0, .. }) => {
                    self.fill(pass, tile, chunk, shape(lane), lane);
                }
                Stop::Share(Share { shape: lane, part, block, lanes }) => {
                    for (to, plane) in self.planes.iter_mut().zip(self.group.in_window(lane, part))
                    {
                        *to = plane;
                    }
                    let at = BlockAt::numbered([tile.x, tile.y], block);
                    let mut masks = SampleMasks::one(lanes);
                    let facing = shape(lane).facing;
                    let part = Part { at, facing, tests: EarlyTests::Due };
                    self.fill_block(pass, tile, job, part, &mut masks);
                }
            }
        }
    }
}
