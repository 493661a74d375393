//! Shapes into batches: what a shape covers of each block of the tile. A covered block is packed into a pending batch,
//! tested at once, or shaded by itself.

use super::super::batch::{Batch, BlockOf, EarlyTests, is_dense, moved_quad, quads_of};
use super::super::block::BlockAt;
use super::super::edge_functions;
use super::super::job::{Chunk, DrawJob, PassJob, TileJob};
use super::super::large_triangles;
use super::super::shading::early_tests;
use super::super::shape_cover::Cover;
use super::super::small_triangles::Window;
use super::TileRenderer;
use crate::desc::Facing;
use crate::kernels::PixelKernel;
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
        PixelKernel::WindowTriangle.note();
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
        let is_sampled = shape.kind == ShapeKind::Triangle && plan.samples.is_each();
        let is_large = blocks >= large_triangles::MIN_BLOCKS
            && shape.kind == ShapeKind::Triangle
            && tile.watched.is_none();
        if is_large && plan.covers_by_outline() {
            self.fill_large_triangle(pass, tile, job, shape, (lane, range));
            return;
        }
        if is_large && is_sampled && plan.stipple.is_none() && !plan.reads_coverage {
            self.fill_large_sampled_triangle(pass, tile, job, shape, (lane, range));
            return;
        }
        let touched = if is_sampled {
            PixelKernel::SampledTriangle.note();
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
                    PixelKernel::Stipple.note();
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
                self.pending_blocks.push(planes, facing, block, masks, self.uniform);
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
pub(super) fn is_shaded_as_block(packing: Packing, lanes: u64) -> bool {
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
