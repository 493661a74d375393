//! Triangles that cover many blocks of a tile: coverage, planes and depth tests of all blocks come from a few kernels.

use super::super::batch::{EarlyTests, is_dense};
use super::super::block::BlockAt;
use super::super::block_group::UniformOverShape;
use super::super::edge_functions;
use super::super::job::{DrawJob, PassJob, TileJob};
use super::super::large_triangles::bits;
use super::super::pack_pixels::PackLargeTriangle;
use super::super::tile_planes::ComputePlanes;
use super::TileRenderer;
use super::block_tests::BlockTests;
use super::fill::{ShapeBlock, is_shaded_as_block};
use crate::desc::Facing;
use crate::kernels::PixelKernel;
use crate::plan::{DrawPlan, Packing, SampleMasks, Shading, TestTiming};
use crate::primitive::Shape;
use crate::sizes::TILE;

impl TileRenderer {
    /// Fills a triangle that may cover many blocks, of the only sample.
    pub(super) fn fill_large_triangle(
        &mut self,
        pass: &PassJob,
        tile: &mut TileJob,
        job: &DrawJob,
        shape: &Shape,
        (lane, range): (usize, [[i32; 2]; 2]),
    ) {
        PixelKernel::LargeTriangle.note();
        let (plan, first) = (&job.plan, [tile.x, tile.y]);
        let rows = range[0][1] as usize..range[1][1] as usize + 1;
        let Self { group, tile_planes: out, .. } = self;
        let planes = ComputePlanes { tile: first, rows, group, lane, out };
        self.large_triangle.compute(pass.isa, &shape.corners, plan.packing, planes);
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
            && self.large_triangle.overlaps_pending(|of, lanes| {
                self.pending_blocks.has_pending(of, &SampleMasks::one(lanes))
            })
        {
            self.flush_blocks(pass, job, tile);
        }
        let tested = self.test_large_triangle(pass, job, tile, shape.facing);
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
        self.tile_planes.write_steps(&mut self.planes);
        for block in bits(left) {
            let mut masks = SampleMasks::one(self.large_triangle.covered[block]);
            let shape_block = block_of(first, block, shape.facing, ready);
            self.fill_large_block(pass, tile, job, shape_block, &mut masks);
        }
        self.uniform = UniformOverShape::default();
    }

    /// Shades what a large triangle covers of a block, whose planes are those of the tile.
    fn fill_large_block(
        &mut self,
        pass: &PassJob,
        tile: &mut TileJob,
        job: &DrawJob,
        shape_block: ShapeBlock,
        masks: &mut SampleMasks,
    ) {
        let plan = &job.plan;
        let (block, lanes) = (shape_block.at.number(), masks.any());
        let is_grouped = shape_block.tests == EarlyTests::Done
            && plan.blocks_per_group > 1
            && is_shaded_as_block(plan.packing, lanes);
        if is_grouped {
            let planes = self.tile_planes.at(block);
            self.pending_blocks.push(planes, shape_block.facing, block, masks, self.uniform);
            if self.pending_blocks.len() == plan.blocks_per_group {
                self.flush_blocks(pass, job, tile);
            }
        } else if lanes != 0 {
            self.tile_planes.write_first_values(block, &mut self.planes);
            self.fill_block(pass, tile, job, shape_block, masks);
        }
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
            let Self { large_triangle, tile_planes, pending_pixels: pixels, .. } = self;
            left = pass.isa.run(PackLargeTriangle {
                triangle: large_triangle,
                planes: tile_planes,
                facing,
                blocks: left,
                pixels,
            });
        }
    }

    /// Runs the early tests of the blocks of a large triangle that are shaded as blocks, where they need no single
    /// fragments. Returns these blocks.
    fn test_large_triangle(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        tile: &mut TileJob,
        facing: Facing,
    ) -> u64 {
        let plan = &job.plan;
        let (Some(tests), Some(target)) =
            (BlockTests::new(pass.isa, plan, facing), tile.depth.as_mut())
        else {
            return 0;
        };
        let blocks = tested_blocks(plan, self.large_triangle.touched, self.large_triangle.dense);
        let blocks = tests.testable(blocks, target.sample(0));
        if blocks != 0 {
            let depth = tests.depth_plane().map(|plane| self.tile_planes.plane(plane));
            if depth.is_some() {
                PixelKernel::LargeDepthTest.note();
            }
            let covered = &mut self.large_triangle.covered;
            tests.run(blocks, target.sample(0), depth, covered);
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

    /// Fills a triangle that may cover many blocks, of several samples.
    pub(super) fn fill_large_sampled_triangle(
        &mut self,
        pass: &PassJob,
        tile: &mut TileJob,
        job: &DrawJob,
        shape: &Shape,
        (lane, range): (usize, [[i32; 2]; 2]),
    ) {
        PixelKernel::LargeSampledTriangle.note();
        let (plan, first) = (&job.plan, [tile.x, tile.y]);
        let positions = plan.samples.positions();
        self.sampled_triangle.compute(pass.isa, &shape.corners, first, range, positions);
        let touched = self.sampled_triangle.touched();
        if touched == 0 {
            return;
        }
        let rows = range[0][1] as usize..range[1][1] as usize + 1;
        self.tile_planes.compute(pass.isa, first, rows, (&self.group, lane));
        let is_whole = edge_functions::is_inside_area(&job.area, tile.x, tile.y, TILE as i32)
            && plan.samples.keeps_all();
        let mut masks = SampleMasks::none(plan.samples.count);
        let mut dense = 0;
        for block in bits(touched) {
            if !is_whole {
                let inside =
                    edge_functions::inside_area(&job.area, BlockAt::numbered(first, block));
                let kept = |sample| if plan.samples.keeps(sample) { inside } else { 0 };
                self.sampled_triangle.keep(block, kept);
            }
            self.sampled_triangle.write_masks(block, &mut masks);
            dense |= u64::from(is_dense(plan.packing, masks.any())) << block;
            // Pending fragments of other shapes are shaded first. Blocks of one shape do not overlap.
            self.flush_overlapping(pass, job, tile, block, &masks);
        }
        let of = [touched, dense];
        let tested = self.test_large_sampled_triangle(pass, job, tile, shape.facing, of);
        let ready = if plan.timing == TestTiming::Never { dense } else { tested };
        self.uniform = self.uniform_over_shape(plan, lane);
        self.tile_planes.write_steps(&mut self.planes);
        for block in bits(touched) {
            self.sampled_triangle.write_masks(block, &mut masks);
            let shape_block = block_of(first, block, shape.facing, ready);
            if shape_block.tests == EarlyTests::Done && plan.shading == Shading::Off {
                job.count(&masks);
            } else {
                self.fill_large_block(pass, tile, job, shape_block, &mut masks);
            }
        }
        self.uniform = UniformOverShape::default();
    }

    /// As [`Self::test_large_triangle`], of each sample, for the blocks that are touched and dense.
    fn test_large_sampled_triangle(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        tile: &mut TileJob,
        facing: Facing,
        [touched, dense]: [u64; 2],
    ) -> u64 {
        let plan = &job.plan;
        let (Some(tests), Some(target)) =
            (BlockTests::new(pass.isa, plan, facing), tile.depth.as_mut())
        else {
            return 0;
        };
        let samples = 0..plan.samples.count;
        let blocks = samples.clone().fold(tested_blocks(plan, touched, dense), |blocks, sample| {
            tests.testable(blocks, target.sample(sample))
        });
        let depth = tests.depth_plane().map(|plane| self.tile_planes.plane(plane));
        if depth.is_some() {
            PixelKernel::LargeSampleDepthTest.note();
        }
        for sample in samples {
            let (of_sample, covered) = self.sampled_triangle.sample_mut(sample);
            let depth = depth.as_ref().map(|plane| plane.at_sample(plan.samples.offset(sample)));
            if blocks & of_sample != 0 {
                tests.run(blocks & of_sample, target.sample(sample), depth.as_ref(), covered);
            }
        }
        blocks
    }
}

/// A block of a large triangle in the tile whose first pixel is `first`; the early tests of the blocks in `ready`, bit by
/// block, are done.
fn block_of(first: [i32; 2], block: usize, facing: Facing, ready: u64) -> ShapeBlock {
    let tests = if ready >> block & 1 == 1 { EarlyTests::Done } else { EarlyTests::Due };
    ShapeBlock { at: BlockAt::numbered(first, block), facing, tests }
}

/// The blocks of a large triangle that are tested together, of those that are touched and dense, bit by block.
fn tested_blocks(plan: &DrawPlan, touched: u64, dense: u64) -> u64 {
    match plan.shading {
        Shading::On => dense,
        Shading::Off => touched,
    }
}
