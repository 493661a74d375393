//! A tile: everything of a pass that touches its 64×64 pixels, in order.

use super::batch::{Batch, BlockDepth, BlockOf, quads_of};
use super::clear::{ClearJob, clear};
use super::cover::Cover;
use super::coverage;
use super::group::PlaneGroup;
use super::interpolate::PlaneSetup;
use super::samples::{SampleMasks, moved};
use super::shading::Shader;
use super::watched::Spot;
use crate::driver::{Counter, Watch};
use crate::output::{Fragments, test};
use crate::plan::{DrawPlan, Shading, Timing};
use crate::primitive::{Facing, Kind, Shape};
use crate::target::{MAX_SAMPLES, Place, TILE, TileTarget};
use crate::vertex::Geometry;
use std::sync::atomic::{AtomicBool, Ordering};
use texunit::lanes::{F32s, Isa, LANES};

/// Quads of a block from which on it is shaded by itself rather than packed with others.
const DENSE: u32 = 12;

/// A draw of a pass.
#[derive(Debug)]
pub struct DrawJob {
    /// Its decisions.
    pub plan: DrawPlan,
    /// First and one past the last pixel its triangles may touch, x then y.
    pub area: [[i32; 2]; 2],
    /// What counts the samples that pass its tests.
    pub counter: Option<Counter>,
    /// Set when its shader ran over the budget: nothing more of it is drawn.
    pub stopped: AtomicBool,
    /// What a watch calls it.
    pub label: u32,
}

impl DrawJob {
    /// Counts the samples of masks, if somebody does.
    pub fn count(&self, masks: &[u64]) {
        if let Some(counter) = &self.counter {
            for &mask in masks {
                counter.add(mask);
            }
        }
    }
}

/// The shapes of a run of primitives and the vertices they stand on.
#[derive(Debug)]
pub struct Chunk {
    /// Which draw.
    pub draw: usize,
    /// The vertices.
    pub geometry: Geometry,
    /// The shapes.
    pub shapes: Vec<Shape>,
}

/// Something that happens in a tile.
#[derive(Clone, Copy, Debug)]
pub enum Entry {
    /// A clear, by index.
    Clear(u32),
    /// A shape, by chunk and index.
    Shape(u32, u32),
}

/// Everything that tiles read.
#[derive(Debug)]
pub struct PassJob {
    /// The instruction set.
    pub isa: Isa,
    /// Instructions a batch may run.
    pub budget: u64,
    /// Pixels across.
    pub width: u32,
    /// Pixels up.
    pub height: u32,
    /// The draws.
    pub draws: Vec<DrawJob>,
    /// The chunks of all draws, in order.
    pub chunks: Vec<Chunk>,
    /// The clears.
    pub clears: Vec<ClearJob>,
    /// The pixel whose story is recorded.
    pub watch: Option<Watch>,
}

/// One tile, and what happens in it.
#[derive(Debug)]
pub struct TileJob {
    /// Its first pixel.
    pub x: i32,
    /// Its first row.
    pub y: i32,
    /// Its part of each colour attachment.
    pub colors: Vec<Option<TileTarget>>,
    /// Its part of the depth attachment.
    pub depth: Option<TileTarget>,
    /// What happens, in order.
    pub entries: Vec<Entry>,
    /// The watched pixel, if it is in this tile.
    pub watched: Option<Box<Spot>>,
}

/// What a thread keeps from tile to tile.
#[derive(Debug, Default)]
pub struct Worker {
    shader: Shader,
    /// Quads that wait for others, of the current draw.
    waiting: Batch,
    /// A block that runs at once.
    block: Batch,
    group: PlaneGroup,
    /// Of the block that is filled: each plane's value at its first pixel and steps.
    planes: Vec<[f32; 3]>,
    /// How much of each lane's pixel the shape covers.
    parts: F32s,
    /// The outline of the shape that is filled, as each sample sees it; one if all see the same.
    covers: Vec<Cover>,
    /// The draw whose shapes come now.
    draw: Option<usize>,
}

impl Worker {
    /// Does everything that happens in `tile`.
    pub fn run(&mut self, pass: &PassJob, tile: &mut TileJob) {
        let entries = std::mem::take(&mut tile.entries);
        let mut rest = entries.as_slice();
        while let Some(first) = rest.first() {
            match *first {
                Entry::Clear(index) => {
                    self.flush(pass, tile);
                    clear(pass, &pass.clears[index as usize], tile);
                    tile.note_clear(&pass.clears[index as usize]);
                    rest = &rest[1..];
                }
                Entry::Shape(chunk, _) => {
                    let of_chunk =
                        |entry: &&Entry| matches!(entry, Entry::Shape(other, _) if *other == chunk);
                    let len = rest.iter().take(LANES).take_while(of_chunk).count();
                    let (group, after) = rest.split_at(len);
                    rest = after;
                    self.fill_group(pass, tile, &pass.chunks[chunk as usize], group);
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
        self.shader.machine.begin(&plan.pipeline.compiled().fragment);
        self.waiting.clear(plan.planes.len());
    }

    /// Shades what waits.
    fn flush(&mut self, pass: &PassJob, tile: &mut TileJob) {
        if let Some(draw) = self.draw.filter(|_| !self.waiting.is_empty()) {
            let job = &pass.draws[draw];
            self.shader.shade(pass, job, &self.waiting, self.waiting.place(), tile);
            self.waiting.clear(job.plan.planes.len());
        }
    }

    /// Fills shapes of one chunk, at most 64.
    fn fill_group(&mut self, pass: &PassJob, tile: &mut TileJob, chunk: &Chunk, group: &[Entry]) {
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
        let shapes = group.iter().map(|entry| match *entry {
            Entry::Shape(_, index) | Entry::Clear(index) => &chunk.shapes[index as usize],
        });
        self.group.compute(pass.isa, &setup, &chunk.geometry, shapes.clone());
        for (lane, shape) in shapes.enumerate() {
            if !job.stopped.load(Ordering::Relaxed) {
                self.fill(pass, tile, chunk, shape, lane);
            }
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
        self.covers.clear();
        let places = plan.samples.places().iter();
        self.covers.extend(places.map(|&by| Cover::new(plan, &chunk.geometry, shape, at, by)));
        let (area, stipple) = match shape.kind {
            Kind::Triangle => (job.area, plan.stipple.as_ref()),
            // Their outlines do not know where the view volume ends.
            Kind::Line { .. } | Kind::Point { .. } => (pixels(&shape.bounds), None),
        };
        if plan.reads_coverage() {
            self.parts = F32s::splat(1.0);
        }
        for by in range[0][1]..=range[1][1] {
            for bx in range[0][0]..=range[1][0] {
                let mut masks = self.covered(pass.isa, plan, shape, at, [bx, by]);
                if any(&masks) == 0 {
                    continue;
                }
                let mut inside = coverage::inside_area(&area, tile.x, tile.y, bx, by);
                if let Some(stipple) = stipple {
                    let [column, row] = [at[0] / 8 + bx, at[1] / 8 + by];
                    inside &= stipple[(row % 4 * 4 + column % 4) as usize];
                }
                masks = masks.map(|mask| mask & inside);
                if any(&masks) != 0 {
                    if let Some(spot) = &mut tile.watched
                        && spot.is_in((by * 8 + bx) as usize, any(&masks))
                    {
                        spot.covered(pass, chunk, shape, &masks);
                    }
                    let (x, y) = (at[0] + 8 * bx, at[1] + 8 * by);
                    self.group.at(lane, x, y, &mut self.planes);
                    self.fill_block(pass, tile, job, shape.facing, [bx, by], masks);
                }
            }
        }
    }

    /// What `self.covers` cover of a block.
    #[inline]
    fn covered(
        &mut self,
        isa: Isa,
        plan: &DrawPlan,
        shape: &Shape,
        tile: [i32; 2],
        block: [i32; 2],
    ) -> SampleMasks {
        let mut masks = [0; MAX_SAMPLES];
        let mut covered = 0;
        for (sample, mask) in masks.iter_mut().enumerate().take(plan.samples.count) {
            // Samples without an outline of their own are covered as the first is.
            if let Some(cover) = self.covers.get(sample) {
                covered = cover.block(isa, plan, shape, tile, block, &mut self.parts);
            }
            if plan.samples.leaves(sample) {
                *mask = covered;
            }
        }
        masks
    }

    /// Tests the depth of a block's covered lanes and puts what is left into a batch.
    fn fill_block(
        &mut self,
        pass: &PassJob,
        tile: &mut TileJob,
        job: &DrawJob,
        facing: Facing,
        [bx, by]: [i32; 2],
        mut masks: SampleMasks,
    ) {
        let plan = &job.plan;
        let (x, y) = (tile.x + 8 * bx, tile.y + 8 * by);
        let of = BlockOf {
            planes: &self.planes,
            facing,
            block: (by * 8 + bx) as usize,
            x,
            y,
            coverage: plan.reads_coverage().then_some(&self.parts),
        };
        if plan.timing == Timing::Early {
            // What waits has passed its own test already, so the order holds.
            let watched = tile.watched.as_ref();
            let watched = watched.filter(|spot| spot.is_in(of.block, any(&masks)));
            let before = watched.map(|_| tile.watched_depth());
            early_tests(pass.isa, plan, &of, &mut masks, tile);
            if let Some(before) = before {
                tile.note_early(pass.isa, plan, &of, &masks, &before);
            }
        }
        let masks = &masks[..plan.samples.count];
        if plan.shading == Shading::Off {
            job.count(masks);
            return;
        }
        let quads = quads_of(any(masks));
        if quads == 0 {
            return;
        }
        let run_waiting = |waiting: &mut Batch, shader: &mut Shader, tile: &mut TileJob| {
            shader.shade(pass, job, waiting, waiting.place(), tile);
            waiting.clear(plan.planes.len());
        };
        if self.waiting.holds(of.block, quads) {
            run_waiting(&mut self.waiting, &mut self.shader, tile);
        }
        if quads.count_ones() >= DENSE {
            self.block.set_block(&of, masks, plan.planes.len());
            self.shader.shade(pass, job, &self.block, Place::Block(of.block), tile);
            return;
        }
        let mut left = quads;
        while left != 0 {
            let quad = left.trailing_zeros() as usize;
            left &= left - 1;
            if self.waiting.is_full() {
                run_waiting(&mut self.waiting, &mut self.shader, tile);
            }
            self.waiting.push(&of, quad, masks);
        }
    }
}

/// The lanes of which any sample is covered.
#[inline]
pub fn any(masks: &[u64]) -> u64 {
    masks.iter().fold(0, |all, mask| all | mask)
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

fn early_tests(
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
