//! Packs small triangles, and blocks that a large triangle covers sparsely, into the pending batch of pixels: the
//! innermost loop of fine meshes. These are kernels, so that bits are counted and planes copied by instructions of the
//! selected instruction set.

use super::batch::is_dense;
use super::block_group::BlockGroup;
use super::large_triangles::LargeTriangle;
use super::pixel_batch::Pixels;
use super::plane_group::PlaneGroup;
use super::shape_lanes::ShapeLanes;
use super::tile_planes::TilePlanes;
use super::window_blocks::{WindowBlock, WindowBlocks};
use crate::attachment::BLOCKS;
use crate::desc::Facing;
use crate::plan::{Packing, SampleMasks};
use texunit::lanes::{Kernel, Simd};

/// Why packing stopped.
#[derive(Clone, Copy, Debug)]
pub enum Stop {
    /// All shapes are packed.
    Done,
    /// The pending pixels must be shaded first: the batch is full, or one of them is covered again.
    Pixels,
    /// The pending blocks must be shaded first: one of their pixels is covered again.
    Blocks,
    /// The caller shades this block, which is not returned again: it is dense, or has no lanes as its shape has no
    /// window.
    WholeBlock(WindowBlock),
}

/// Packs the shapes of a group that have windows, in order, until the caller is needed.
pub struct Pack<'a> {
    pub shapes: &'a ShapeLanes,
    pub group: &'a PlaneGroup,
    pub window_blocks: &'a mut WindowBlocks,
    pub pixels: &'a mut Pixels,
    /// The pending blocks.
    pub block_group: &'a BlockGroup,
}

impl Kernel for Pack<'_> {
    type Output = Stop;

    #[inline(always)]
    fn run<S: Simd>(self) -> Stop {
        let mut reader = self.window_blocks.reader;
        let Self { shapes, group, window_blocks, pixels, block_group } = self;
        let stop = loop {
            let Some(window_block) = window_blocks.front(&mut reader) else { break Stop::Done };
            let WindowBlock { shape, index, block, lanes } = window_block;
            if lanes == 0 || is_dense(Packing::Pixels, lanes) {
                window_blocks.set_remaining(&mut reader, window_block, 0);
                break Stop::WholeBlock(window_block);
            }
            if pixels.is_full() || pixels.has_pending(block, lanes) {
                break Stop::Pixels;
            }
            if block_group.has_pending(block, &SampleMasks::one(lanes)) {
                break Stop::Blocks;
            }
            let planes = group.in_window(shape, index);
            let rest = pixels.push(block, lanes, shapes.facing(shape), planes);
            window_blocks.set_remaining(&mut reader, window_block, rest);
        };
        window_blocks.reader = reader;
        stop
    }
}

/// Packs blocks of a large triangle, bit by block, until the pending batch is full; returns the blocks
/// that have unpacked pixels.
pub struct PackLargeTriangle<'a> {
    pub triangle: &'a mut LargeTriangle,
    pub planes: &'a TilePlanes,
    pub facing: Facing,
    pub blocks: u64,
    pub pixels: &'a mut Pixels,
}

impl Kernel for PackLargeTriangle<'_> {
    type Output = u64;

    #[inline(always)]
    fn run<S: Simd>(self) -> u64 {
        let Self { triangle, planes, facing, blocks, pixels } = self;
        let mut left = blocks;
        while left != 0 && !pixels.is_full() {
            let block = left.trailing_zeros() as usize % BLOCKS;
            let rest = pixels.push(block, triangle.covered[block], facing, planes.at(block));
            triangle.covered[block] = rest;
            left &= !(u64::from(rest == 0) << block);
        }
        left
    }
}
