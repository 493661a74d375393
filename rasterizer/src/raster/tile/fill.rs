//! Shapes into batches: what a shape covers of each block of the tile. A covered block is packed into a pending batch,
//! tested at once, or shaded by itself.

use super::super::batch::{Batch, BlockOf, EarlyTests, is_dense, moved_quad, quads_of};
use super::super::block::BlockAt;
use super::super::block_group::UniformOverShape;
use super::super::edge_functions;
use super::super::job::{Chunk, DrawJob, PassJob, TileJob};
use super::super::large_triangles::{self, bits};
use super::super::pack_pixels::PackLargeTriangle;
use super::super::shading::early_tests;
use super::super::shape_cover::Cover;
use super::super::small_triangles::Window;
use super::TileRenderer;
use crate::desc::Facing;
use crate::output::Tests;
use crate::plan::{DrawPlan, Packing, SampleMasks, Shading, TestTiming};
use crate::primitive::{Shape, ShapeKind};
use crate::sizes::TILE;
use texunit::lanes::{F32s, Isa};

/// A block that a shape covers.
pub(super) struct ShapeBlock {
    /// The position of the block.
    pub at: BlockAt,
    /// The facing of the shape.
    pub facing: Facing,
    /// Whether the early tests are done.
    pub tests: EarlyTests,
}

impl TileRenderer {
    /// Fills a small triangle, quad by quad.
    pub(super) fn fill_window(
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
            if self.pending_quads.is_full() {
                self.flush_quads(pass, job, tile);
            }
            let masks = SampleMasks::one(lanes);
            self.flush_overlapping(pass, job, tile, block, &masks);
            let of = BlockOf {
                planes: &self.planes,
                facing,
                tests: EarlyTests::Due,
                block,
                x: px,
                y: py,
                coverage: None,
            };
            self.pending_quads.push(&of, quad, from, &SampleMasks::one(covered));
        }
    }

    /// Fills one shape, whose planes are in a lane of the group.
    pub(super) fn fill(
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
        let first = [tile.x, tile.y];
        let blocks = (range[1][0] - range[0][0] + 1) * (range[1][1] - range[0][1] + 1);
        let is_large = blocks >= large_triangles::MIN_BLOCKS
            && shape.kind == ShapeKind::Triangle
            && plan.covers_by_outline()
            && tile.watched.is_none();
        if is_large {
            self.fill_large_triangle(pass, tile, job, shape, (lane, range));
            return;
        }
        let is_sampled = shape.kind == ShapeKind::Triangle && plan.samples.is_each();
        let touched = if is_sampled {
            let positions = plan.samples.positions();
            self.sampled_triangle.compute(pass.isa, &shape.corners, first, range, positions);
            self.sampled_triangle.touched()
        } else {
            self.outlines.clear();
            let outline = |&by: &[i32; 2]| Cover::new(plan, &chunk.geometry, shape, first, by);
            self.outlines.extend(plan.samples.positions().iter().map(outline));
            self.outlines.iter().fold(0, |blocks, cover| blocks | cover.touched(first))
        };
        if touched == 0 {
            return;
        }
        let (area, stipple) = match shape.kind {
            ShapeKind::Triangle => (job.area, plan.stipple.as_ref()),
            // The view volume does not clip their outlines.
            ShapeKind::Line { .. } | ShapeKind::Point { .. } => (pixels(&shape.bounds), None),
        };
        if plan.reads_coverage {
            self.coverage = F32s::splat(match shape.kind {
                ShapeKind::Point { fade, .. } => fade,
                ShapeKind::Triangle | ShapeKind::Line { .. } => 1.0,
            });
        }
        let mut masks = SampleMasks::none(plan.samples.count);
        for by in range[0][1]..=range[1][1] {
            for bx in range[0][0]..=range[1][0] {
                let at = BlockAt { tile: first, block: [bx, by] };
                if touched >> at.number() & 1 == 0 {
                    continue;
                }
                let mut inside = edge_functions::inside_area(&area, at);
                if let Some(stipple) = stipple {
                    inside &=
                        stipple.block([first[0] / 8 + bx, first[1] / 8 + by].map(|at| at as u32));
                    if inside == 0 {
                        continue;
                    }
                }
                if is_sampled {
                    self.sampled_triangle.write_masks(at.number(), &mut masks);
                    plan.samples.keep(&mut masks, inside);
                } else {
                    self.covered(pass.isa, plan, shape, at, inside, &mut masks);
                }
                if masks.any() != 0 {
                    if let Some(pixel) = &mut tile.watched
                        && pixel.is_in(at.number(), masks.any())
                    {
                        pixel.covered(pass, chunk, shape, &masks);
                    }
                    let [x, y] = at.first();
                    self.group.at(lane, x, y, &mut self.planes);
                    let shape_block =
                        ShapeBlock { at, facing: shape.facing, tests: EarlyTests::Due };
                    self.fill_block(pass, tile, job, shape_block, &mut masks);
                }
            }
        }
    }

    /// Fills a triangle that may cover many blocks, of the only sample.
    fn fill_large_triangle(
        &mut self,
        pass: &PassJob,
        tile: &mut TileJob,
        job: &DrawJob,
        shape: &Shape,
        (lane, range): (usize, [[i32; 2]; 2]),
    ) {
        let (plan, first) = (&job.plan, [tile.x, tile.y]);
        let rows = range[0][1] as usize..range[1][1] as usize + 1;
        self.large_triangle.compute(
            pass.isa,
            first,
            (&shape.corners, rows),
            plan.packing,
            (&self.group, lane),
        );
        if !edge_functions::is_inside_area(&job.area, tile.x, tile.y, TILE as i32) {
            let inside =
                |block| edge_functions::inside_area(&job.area, BlockAt::numbered(first, block));
            self.large_triangle.clip_to_area(plan.packing, inside);
        }
        // Pending fragments of other shapes are shaded first, as in `flush_overlapping`. Blocks of one shape do not overlap.
        if !self.pending_quads.is_empty()
            && self.large_triangle.overlaps_pending(|of, lanes| {
                self.pending_quads.has_pending(of, &SampleMasks::one(lanes))
            })
        {
            self.flush_quads(pass, job, tile);
        }
        if !self.pending_pixels.is_empty()
            && self
                .large_triangle
                .overlaps_pending(|of, lanes| self.pending_pixels.has_pending(of, lanes))
        {
            self.flush_pixels(pass, job, tile);
        }
        if self.pending_blocks.len() > 0
            && self
                .large_triangle
                .overlaps_pending(|of, lanes| self.pending_blocks.has_pending(of, lanes))
        {
            self.flush_blocks(pass, job, tile);
        }
        let tested = self.test_large_triangle(pass, job, tile);
        if plan.shading == Shading::Off && tested == self.large_triangle.touched {
            bits(tested).for_each(|block| job.count(&[self.large_triangle.covered[block]]));
            return;
        }
        let mut left = self.large_triangle.touched;
        if plan.packing == Packing::Pixels && plan.shading == Shading::On {
            left = self.large_triangle.dense;
            self.pack_large_triangle(pass, job, tile, shape.facing);
        }
        let ready =
            if plan.timing == TestTiming::Never { self.large_triangle.dense } else { tested };
        self.uniform = self.uniform_over_shape(plan, lane);
        self.large_triangle.write_steps(&mut self.planes);
        for block in bits(left) {
            let lanes = self.large_triangle.covered[block];
            let is_ready = ready >> block & 1 == 1;
            if is_ready && plan.blocks_per_group > 1 && is_shaded_as_block(plan.packing, lanes) {
                self.pending_blocks.push(
                    self.large_triangle.at(block),
                    shape.facing,
                    block,
                    lanes,
                    self.uniform,
                );
                if self.pending_blocks.len() == plan.blocks_per_group {
                    self.flush_blocks(pass, job, tile);
                }
            } else if lanes != 0 {
                let at = BlockAt::numbered(first, block);
                let tests = if is_ready { EarlyTests::Done } else { EarlyTests::Due };
                let shape_block = ShapeBlock { at, facing: shape.facing, tests };
                self.large_triangle.write_first_values(block, &mut self.planes);
                self.fill_block(pass, tile, job, shape_block, &mut SampleMasks::one(lanes));
            }
        }
        self.uniform = UniformOverShape::default();
    }

    /// Packs the pixels of the blocks that a large triangle covers sparsely into the pending batch.
    fn pack_large_triangle(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        tile: &mut TileJob,
        facing: Facing,
    ) {
        let mut left = self.large_triangle.touched & !self.large_triangle.dense;
        while left != 0 {
            if self.pending_pixels.is_full() {
                self.flush_pixels(pass, job, tile);
            }
            let Self { large_triangle, pending_pixels: pixels, .. } = self;
            left = pass.isa.run(PackLargeTriangle {
                triangle: large_triangle,
                facing,
                blocks: left,
                pixels,
            });
        }
    }

    /// Runs the early depth test of the blocks of a large triangle that are shaded as blocks, in one kernel if depth is
    /// the only test. Returns these blocks.
    fn test_large_triangle(&mut self, pass: &PassJob, job: &DrawJob, tile: &mut TileJob) -> u64 {
        let plan = &job.plan;
        let Tests { stencil: None, depth: Some(test) } = plan.tests else { return 0 };
        let (TestTiming::Early, Some(plane), None) =
            (plan.timing, plan.depth_plane, plan.samples.offset(0))
        else {
            return 0;
        };
        let Some([stored, ..]) = tile.depth.as_mut().map(|target| target.sample(0)) else {
            return 0;
        };
        let blocks = match plan.shading {
            Shading::On => self.large_triangle.dense,
            Shading::Off => self.large_triangle.touched,
        };
        if blocks != 0 {
            self.large_triangle.test(
                pass.isa,
                test,
                (plane, plan.viewport.depths()),
                stored,
                blocks,
            );
        }
        blocks
    }

    /// What is uniform over the shape in this lane of the group, under a number that no other shape has. Runs of its
    /// blocks then need no comparison of planes.
    fn uniform_over_shape(&mut self, plan: &DrawPlan, lane: usize) -> UniformOverShape {
        let Some(product) = &plan.product else { return UniformOverShape::default() };
        self.shape_count += 1;
        let (number, group, by) = (Some(self.shape_count), &self.group, plan.denominator_plane);
        let factors = product.factor_planes.as_ref();
        let lods = product.lod_planes.as_ref();
        UniformOverShape {
            factors: number
                .filter(|_| factors.is_some_and(|of| group.has_uniform_factors(lane, of, by))),
            lods: number.filter(|_| lods.is_some_and(|of| group.has_uniform_slopes(lane, of, by))),
        }
    }

    /// The coverage by `self.outlines` of the lanes of a block that are `inside`.
    #[inline]
    fn covered(
        &mut self,
        isa: Isa,
        plan: &DrawPlan,
        shape: &Shape,
        at: BlockAt,
        inside: u64,
        masks: &mut SampleMasks,
    ) {
        let mut covered = 0;
        for (sample, mask) in masks.iter_mut().enumerate() {
            // Samples without an outline of their own are covered as the first is.
            if let Some(cover) = self.outlines.get(sample) {
                covered = cover.block(isa, plan, shape, at, &mut self.coverage);
            }
            *mask = if plan.samples.keeps(sample) { covered & inside } else { 0 };
        }
    }

    /// Adds the covered lanes of a block to a batch.
    pub(super) fn fill_block(
        &mut self,
        pass: &PassJob,
        tile: &mut TileJob,
        job: &DrawJob,
        shape_block: ShapeBlock,
        masks: &mut SampleMasks,
    ) {
        if self.shader.budget.is_stopped() {
            return;
        }
        let plan = &job.plan;
        let covered = masks.any();
        let ShapeBlock { at, facing, tests } = shape_block;
        let block = at.number();
        self.flush_overlapping(pass, job, tile, block, masks);
        let packing = if tile.watched.is_some() { Packing::Quads } else { plan.packing };
        let is_due = tests == EarlyTests::Due;
        // Without shading, testing a block costs less than packing its pixels.
        let packs = is_due && packing == Packing::Pixels && plan.shading == Shading::On;
        if packs && !is_dense(packing, covered) {
            let mut left = covered;
            while left != 0 {
                if self.pending_pixels.is_full() {
                    self.flush_pixels(pass, job, tile);
                }
                left = self.pending_pixels.push(block, left, facing, self.planes.iter().copied());
            }
            return;
        }
        let [x, y] = at.first();
        let coverage = plan.reads_coverage.then_some(&self.coverage);
        let mut of = BlockOf { planes: &self.planes, facing, tests, block, x, y, coverage };
        let is_eager = is_shaded_as_block(packing, covered) || tile.watched.is_some();
        let shades_one = plan.blocks_per_group == 1 || tile.watched.is_some();
        if is_eager && shades_one {
            tile.prefetch(plan, std::iter::once(block));
        }
        if is_eager && is_due && plan.timing == TestTiming::Early {
            let watched = tile.watched.as_ref();
            let watched = watched.filter(|pixel| pixel.is_in(block, covered));
            let before = watched.map(|_| tile.watched_depth());
            early_tests(pass.isa, plan, &of, masks, tile);
            if let Some(before) = before {
                tile.record_early_tests(pass.isa, plan, &of, masks, &before);
            }
            of.tests = EarlyTests::Done;
        }
        if is_shaded_as_block(packing, masks.any()) {
            if shades_one {
                self.shader.shade(pass, job, &Batch::of_block(&of, masks), tile);
            } else {
                let planes = self.planes.iter().copied();
                self.pending_blocks.push(planes, facing, block, masks.any(), self.uniform);
                if self.pending_blocks.len() == plan.blocks_per_group {
                    self.flush_blocks(pass, job, tile);
                }
            }
            return;
        }
        let mut left = quads_of(masks.any());
        while left != 0 {
            let quad = left.trailing_zeros() as usize;
            left &= left - 1;
            if self.pending_quads.is_full() {
                self.shader.shade(pass, job, &self.pending_quads.batch(), tile);
                self.pending_quads.clear(plan.planes.len(), plan.samples.count);
            }
            self.pending_quads.push(&of, quad, quad, masks);
        }
    }
}

/// Whether lanes that are not packed as pixels are shaded as a block, rather than quad by quad with others.
fn is_shaded_as_block(packing: Packing, lanes: u64) -> bool {
    lanes != 0 && (packing == Packing::Pixels || is_dense(packing, lanes))
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
