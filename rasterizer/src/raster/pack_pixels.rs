//! Small triangles, and what broad ones cover sparsely, into the batch of pixels that waits: the innermost loop of
//! fine meshes. Kernels, so that bits are counted and planes copied by what the instruction set has for it.

use super::batch::is_dense;
use super::block_run::BlockRun;
use super::large_triangles::LargeTriangle;
use super::pixel_batch::Pixels;
use super::plane_group::PlaneGroup;
use super::shape_lanes::ShapeLanes;
use super::window_blocks::{Share, Shares};
use crate::attachment::BLOCKS;
use crate::desc::Facing;
use crate::plan::Packing;
use texunit::lanes::{Kernel, Simd};

/// Why packing stopped.
#[derive(Clone, Copy, Debug)]
pub enum Stop {
    /// All shapes are packed.
    Done,
    /// The waiting pixels must be shaded first: the batch is full, or one of them is covered again.
    Pixels,
    /// So must the blocks.
    Blocks,
    /// This share is for the caller, and is not returned again: it is dense, or has no lanes as its shape has no
    /// window.
    Share(Share),
}

/// Packs the shapes of a group that have windows, in order, until the caller is needed.
pub struct Pack<'a> {
    pub shapes: &'a ShapeLanes,
    pub group: &'a PlaneGroup,
    pub shares: &'a mut Shares,
    pub pixels: &'a mut Pixels,
    /// The blocks that wait.
    pub run: &'a BlockRun,
}

impl Kernel for Pack<'_> {
    type Output = Stop;

    #[inline(always)]
    fn run<S: Simd>(self) -> Stop {
        let mut reader = self.shares.reader;
        let Self { shapes, group, shares, pixels, run } = self;
        let stop = loop {
            let Some(share) = shares.first(&mut reader) else { break Stop::Done };
            let Share { shape, part, block, lanes } = share;
            if lanes == 0 || is_dense(Packing::Pixels, lanes) {
                shares.leave(&mut reader, share, 0);
                break Stop::Share(share);
            }
            if pixels.is_full() || pixels.holds(block, lanes) {
                break Stop::Pixels;
            }
            if run.holds(block, lanes) {
                break Stop::Blocks;
            }
            let planes = group.in_window(shape, part);
            let rest = pixels.push(block, lanes, shapes.facing(shape), planes);
            shares.leave(&mut reader, share, rest);
        };
        shares.reader = reader;
        stop
    }
}

/// Packs blocks of a broad triangle, bit by block, until the pixels that wait are a whole batch; gives the blocks of
/// which any pixel is left.
pub struct PackBroad<'a> {
    pub broad: &'a mut LargeTriangle,
    pub facing: Facing,
    pub blocks: u64,
    pub pixels: &'a mut Pixels,
}

impl Kernel for PackBroad<'_> {
    type Output = u64;

    #[inline(always)]
    fn run<S: Simd>(self) -> u64 {
        let Self { broad, facing, blocks, pixels } = self;
        let mut left = blocks;
        while left != 0 && !pixels.is_full() {
            let block = left.trailing_zeros() as usize % BLOCKS;
            let rest = pixels.push(block, broad.covered[block], facing, broad.at(block));
            broad.covered[block] = rest;
            left &= !(u64::from(rest == 0) << block);
        }
        left
    }
}
