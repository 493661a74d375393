//! A tile: everything of a pass that touches its 64×64 pixels, in order.

use super::batch::{Batch, BlockOf, EarlyTests, Packed, moved_quad, quads_of};
use super::broad::{self, Broad};
use super::clear::clear;
use super::cover::Cover;
use super::coverage;
use super::group::PlaneGroup;
use super::interpolate::PlaneSetup;
use super::job::{Chunk, DrawJob, Entry, PassJob, TileJob};
use super::lanes::ShapeLanes;
use super::pack::{DENSE_PIXELS, Pack, Progress, Stop};
use super::pixels::Pixels;
use super::run::BlockRun;
use super::samples::SampleMasks;
use super::shading::{Shader, early_tests};
use super::small::{Share, Window, Windows};
use crate::plan::{DrawPlan, FragmentInput, Packing, Shading, Timing};
use crate::primitive::{Facing, Kind, Shape};
use crate::target::TILE;
use std::sync::atomic::Ordering;
use texunit::lanes::{F32s, Isa, LANES, U32s, prefetch};

/// Quads of a block from which on it is shaded by itself rather than packed with others.
pub const DENSE: u32 = 12;
/// Shapes of a group from which on their windows are computed together.
const WINDOWS_FROM: usize = 4;

/// What a thread keeps from tile to tile.
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
    broad: Broad,
    /// Of the block that is filled: each plane's value at its first pixel and steps.
    planes: Vec<[f32; 3]>,
    /// How much of each lane's pixel the shape covers.
    parts: F32s,
    /// The outline of the shape that is filled, as each sample sees it; one if all see the same.
    covers: Vec<Cover>,
    /// The draw whose shapes come now.
    draw: Option<usize>,
    /// How many shapes had a number, see [`BlockRun::level`].
    levels: u64,
}

impl Worker {
    /// Does everything that happens in `tile`.
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

    /// Makes `draw` the one whose shapes come next.
    fn select(&mut self, pass: &PassJob, tile: &mut TileJob, draw: usize) {
        if self.draw == Some(draw) {
            return;
        }
        self.flush(pass, tile);
        self.draw = Some(draw);
        let plan = &pass.draws[draw].plan;
        let machine = &mut self.shader.machine;
        machine.begin(&plan.pipeline.compiled().fragment);
        for (index, &input) in plan.inputs.iter().enumerate() {
            if input == FragmentInput::Zero {
                (0..plan.together).for_each(|bank| machine.inputs_of(bank)[index] = U32s::ZERO);
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

    /// Shades what of these lanes of a block waits: what comes must not overtake it. No pixel waits twice, so
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
            viewport: plan.viewport,
            offset: plan.offset,
            resolution: plan.resolution,
            origin: plan.raster.point.origin,
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
        let mut progress = Progress::default();
        loop {
            if job.stopped.load(Ordering::Relaxed) {
                return;
            }
            let stop = pass.isa.run(Pack {
                shapes: &self.shapes,
                windows: &self.windows,
                group: &self.group,
                progress: &mut progress,
                pixels: &mut self.pixels,
                run: &self.run,
            });
            match stop {
                Stop::Done => return,
                Stop::Pixels => self.flush_pixels(pass, job, tile),
                Stop::Blocks => self.flush_run(pass, job, tile),
                Stop::Shape(lane) => self.fill(pass, tile, chunk, shape(lane), lane),
                Stop::Dense(lane, Share { part, block, lanes }) => {
                    for (to, plane) in self.planes.iter_mut().zip(self.group.in_window(lane, part))
                    {
                        *to = plane;
                    }
                    let at = [block as i32 % 8, block as i32 / 8];
                    let mut masks = SampleMasks::one(lanes);
                    self.fill_block(pass, tile, job, shape(lane).facing, at, &mut masks);
                }
            }
        }
    }

    /// Fills a small triangle, quad by quad.
    fn fill_window(
        &mut self,
        pass: &PassJob,
        tile: &mut TileJob,
        job: &DrawJob,
        facing: Facing,
        lane: usize,
        window: Window,
    ) {
        let [covered, ..] = window.covered;
        let mut left = quads_of(covered);
        let mut planes_of = None;
        while left != 0 {
            let from = left.trailing_zeros() as usize;
            left &= left - 1;
            let (x, y) = (window.quad[0] + from % 4, window.quad[1] + from / 4);
            let (block, quad) = (y / 4 * 8 + x / 4, y % 4 * 4 + x % 4);
            let [px, py] = [tile.x + (x / 4 * 8) as i32, tile.y + (y / 4 * 8) as i32];
            if planes_of != Some(block) {
                self.group.at(lane, px, py, &mut self.planes);
                planes_of = Some(block);
            }
            let lanes = moved_quad(covered, from, quad);
            if self.waiting.is_full() {
                self.flush_quads(pass, job, tile);
            }
            self.make_way(pass, job, tile, block, lanes);
            let of = BlockOf {
                planes: &self.planes,
                facing,
                tests: EarlyTests::Due,
                block,
                x: px,
                y: py,
                coverage: None,
            };
            self.waiting.push(&of, quad, from, &SampleMasks::one(covered));
        }
    }

    /// Fills one shape, whose planes are in a lane of the group.
    fn fill(
        &mut self,
        pass: &PassJob,
        tile: &mut TileJob,
        chunk: &Chunk,
        shape: &Shape,
        lane: usize,
    ) {
        let job = &pass.draws[chunk.draw];
        let plan = &job.plan;
        let Some(range) = block_range(shape, tile.x, tile.y) else { return };
        let at = [tile.x, tile.y];
        let blocks = (range[1][0] - range[0][0] + 1) * (range[1][1] - range[0][1] + 1);
        let is_broad = blocks >= broad::WORTH_IT
            && shape.kind == Kind::Triangle
            && plan.covers_by_outline()
            && tile.watched.is_none();
        if is_broad {
            self.fill_broad(pass, tile, job, shape, lane);
            return;
        }
        self.covers.clear();
        let places = plan.samples.places().iter();
        self.covers.extend(places.map(|&by| Cover::new(plan, &chunk.geometry, shape, at, by)));
        let (area, stipple) = match shape.kind {
            Kind::Triangle => (job.area, plan.stipple.as_ref()),
            // Their outlines do not know where the view volume ends.
            Kind::Line { .. } | Kind::Point { .. } => (pixels(&shape.bounds), None),
        };
        if plan.reads_coverage {
            self.parts = F32s::splat(1.0);
        }
        let mut masks = SampleMasks::none(plan.samples.count);
        for by in range[0][1]..=range[1][1] {
            for bx in range[0][0]..=range[1][0] {
                let mut inside = coverage::inside_area(&area, tile.x, tile.y, bx, by);
                if let Some(stipple) = stipple {
                    let [column, row] = [at[0] / 8 + bx, at[1] / 8 + by];
                    inside &= stipple[(row % 4 * 4 + column % 4) as usize];
                }
                self.covered(pass.isa, plan, shape, at, [bx, by], inside, &mut masks);
                if masks.any() != 0 {
                    if let Some(spot) = &mut tile.watched
                        && spot.is_in((by * 8 + bx) as usize, masks.any())
                    {
                        spot.covered(pass, chunk, shape, &masks);
                    }
                    let (x, y) = (at[0] + 8 * bx, at[1] + 8 * by);
                    self.group.at(lane, x, y, &mut self.planes);
                    self.fill_block(pass, tile, job, shape.facing, [bx, by], &mut masks);
                }
            }
        }
    }

    /// Fills a triangle that may cover many blocks, of the only sample.
    fn fill_broad(
        &mut self,
        pass: &PassJob,
        tile: &mut TileJob,
        job: &DrawJob,
        shape: &Shape,
        lane: usize,
    ) {
        let edges = coverage::edges(&shape.corners, tile.x, tile.y);
        self.broad.compute(pass.isa, [tile.x, tile.y], &edges, &self.group, lane);
        self.broad.steps(&mut self.planes);
        // Whole blocks have nothing to decide then.
        let is_plain = job.plan.together > 1 && job.plan.timing == Timing::Never;
        let is_inside = coverage::is_inside_area(&job.area, tile.x, tile.y, TILE as i32);
        // No block of a shape is in another's way.
        let is_free = self.waiting.is_empty() && self.pixels.is_empty() && self.run.len() == 0;
        let level = self.level(&job.plan, lane);
        let mut left = self.broad.touched;
        while left != 0 {
            let block = left.trailing_zeros() as usize;
            left &= left - 1;
            if let (Timing::Early, Some(depth)) = (job.plan.timing, &tile.depth)
                && left != 0
            {
                depth.prefetch(std::iter::once(left.trailing_zeros() as usize));
            }
            let [bx, by] = [block as i32 % 8, block as i32 / 8];
            let mut covered = !0;
            if !is_inside {
                covered &= coverage::inside_area(&job.area, tile.x, tile.y, bx, by);
            }
            if self.broad.full >> block & 1 == 0 {
                covered &= coverage::block(pass.isa, &edges, bx, by).lanes();
            }
            if covered == !0 && is_plain {
                if !is_free {
                    self.make_way(pass, job, tile, block, covered);
                }
                self.run.push(self.broad.at(block), shape.facing, block, covered, level);
                if self.run.len() == job.plan.together {
                    self.flush_run(pass, job, tile);
                }
            } else if covered != 0 {
                self.broad.corners(block, &mut self.planes);
                let mut masks = SampleMasks::one(covered);
                self.fill_block(pass, tile, job, shape.facing, [bx, by], &mut masks);
            }
        }
    }

    /// A number of the shape in this lane of the group, where the factors of a product are the same all over it: then
    /// no run of its blocks has to look. No other shape has it.
    fn level(&mut self, plan: &DrawPlan, lane: usize) -> Option<u64> {
        let factors = plan.product.as_ref()?.factor_planes.as_ref()?;
        self.levels += 1;
        let is_level = self.group.is_level(lane, factors, plan.denominator_plane);
        is_level.then_some(self.levels)
    }

    /// What `self.covers` cover of those lanes of a block that are `inside`.
    #[inline]
    #[expect(clippy::too_many_arguments, reason = "a shape, a block, and what becomes of it")]
    fn covered(
        &mut self,
        isa: Isa,
        plan: &DrawPlan,
        shape: &Shape,
        tile: [i32; 2],
        block: [i32; 2],
        inside: u64,
        masks: &mut SampleMasks,
    ) {
        let mut covered = 0;
        for (sample, mask) in masks.iter_mut().enumerate() {
            // Samples without an outline of their own are covered as the first is.
            if let Some(cover) = self.covers.get(sample) {
                covered = cover.block(isa, plan, shape, tile, block, &mut self.parts);
            }
            *mask = if plan.samples.leaves(sample) { covered & inside } else { 0 };
        }
    }

    /// Puts the covered lanes of a block into a batch.
    fn fill_block(
        &mut self,
        pass: &PassJob,
        tile: &mut TileJob,
        job: &DrawJob,
        facing: Facing,
        [bx, by]: [i32; 2],
        masks: &mut SampleMasks,
    ) {
        let plan = &job.plan;
        let covered = masks.any();
        let block = (by * 8 + bx) as usize;
        self.make_way(pass, job, tile, block, covered);
        let packs = plan.packing == Packing::Pixels && tile.watched.is_none();
        // To test a block costs less than to pack its pixels, where nothing is shaded.
        if packs && covered.count_ones() < DENSE_PIXELS && plan.shading == Shading::On {
            let mut left = covered;
            while left != 0 {
                if self.pixels.is_full() {
                    self.flush_pixels(pass, job, tile);
                }
                left = self.pixels.push(block, left, facing, self.planes.iter().copied());
            }
            return;
        }
        let mut of = BlockOf {
            planes: &self.planes,
            facing,
            tests: EarlyTests::Due,
            block,
            x: tile.x + 8 * bx,
            y: tile.y + 8 * by,
            coverage: plan.reads_coverage.then_some(&self.parts),
        };
        let is_dense = |lanes: u64| packs || lanes == !0 || quads_of(lanes).count_ones() >= DENSE;
        let is_eager = is_dense(covered) || tile.watched.is_some();
        let is_alone = plan.together == 1 || tile.watched.is_some();
        if is_eager && is_alone {
            tile.prefetch(plan, std::iter::once(block));
        }
        if is_eager && plan.timing == Timing::Early {
            let watched = tile.watched.as_ref();
            let watched = watched.filter(|spot| spot.is_in(block, covered));
            let before = watched.map(|_| tile.watched_depth());
            early_tests(pass.isa, plan, &of, masks, tile);
            if let Some(before) = before {
                tile.note_early(pass.isa, plan, &of, masks, &before);
            }
            of.tests = EarlyTests::Done;
        }
        if is_dense(masks.any()) {
            if is_alone {
                self.shader.shade(pass, job, &Batch::of_block(&of, masks), tile);
            } else if masks.any() != 0 {
                self.run.push(self.planes.iter().copied(), facing, block, masks.any(), None);
                if self.run.len() == plan.together {
                    self.flush_run(pass, job, tile);
                }
            }
            return;
        }
        let mut left = quads_of(masks.any());
        while left != 0 {
            let quad = left.trailing_zeros() as usize;
            left &= left - 1;
            if self.waiting.is_full() {
                self.shader.shade(pass, job, &self.waiting.batch(), tile);
                self.waiting.clear(plan.planes.len(), plan.samples.count);
            }
            self.waiting.push(&of, quad, quad, masks);
        }
    }
}

/// A shape's bounds as first and one past the last pixel.
fn pixels(bounds: &[[u16; 2]; 2]) -> [[i32; 2]; 2] {
    [bounds[0].map(i32::from), bounds[1].map(|last| i32::from(last) + 1)]
}

/// The blocks of the tile that a shape may cover: first and last, x then y.
fn block_range(shape: &Shape, x: i32, y: i32) -> Option<[[i32; 2]; 2]> {
    let mut range = [[0; 2]; 2];
    for (axis, start) in [x, y].into_iter().enumerate() {
        let first = i32::from(shape.bounds[0][axis]).max(start) - start;
        let last = i32::from(shape.bounds[1][axis]).min(start + TILE as i32 - 1) - start;
        if first > last {
            return None;
        }
        range[0][axis] = first / 8;
        range[1][axis] = last / 8;
    }
    Some(range)
}
