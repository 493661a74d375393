//! A block group: up to four blocks that are shaded together, each with a register file of its own.
//!
//! Inputs, each straight part of the program, and colours are computed for all blocks of a group, one block after the
//! other. Dispatch of instructions is shared, and the instructions of one block fill the latencies of another.

use super::batch::{BlockOf, EarlyTests};
use super::block::BlockAt;
use crate::desc::Facing;
use crate::plan::SampleMasks;
use crate::shader::MAX_REGISTER_FILES;

/// Blocks of shapes of one draw, whose early tests are done. No sample of a pixel is in two of them.
#[derive(Debug, Default)]
pub struct BlockGroup {
    /// The planes of the first block, then those of the next.
    planes: Vec<[f32; 3]>,
    blocks: [BlockLanes; MAX_REGISTER_FILES],
    len: usize,
    /// See [`Self::uniform_over_shape`].
    uniform: UniformOverShape,
}

/// What is uniform over a shape: the number of the shape if it is, else `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UniformOverShape {
    /// The factors of a product.
    pub factors: Option<u64>,
    /// The levels that its lookups read.
    pub lods: Option<u64>,
}

impl UniformOverShape {
    /// What is uniform over both, if they are parts of one shape.
    fn intersection(self, other: Self) -> Self {
        Self {
            factors: self.factors.filter(|_| self.factors == other.factors),
            lods: self.lods.filter(|_| self.lods == other.lods),
        }
    }
}

/// The lanes of a block that a shape covers.
#[derive(Clone, Copy, Debug, Default)]
struct BlockLanes {
    block: u8,
    facing: Facing,
    masks: SampleMasks,
}

impl BlockGroup {
    /// How many blocks there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether a fragment of any of these samples of a block is pending: later fragments of a sample must follow it.
    #[inline(always)]
    pub fn has_pending(&self, block: usize, masks: &SampleMasks) -> bool {
        let is_pending = |covered: &BlockLanes| {
            usize::from(covered.block) == block && covered.masks.intersects(masks)
        };
        self.blocks.iter().take(self.len).any(is_pending)
    }

    /// What is uniform over the shape that all blocks belong to; nothing if they belong to several.
    pub fn uniform_over_shape(&self) -> UniformOverShape {
        self.uniform
    }

    /// Whether a plane is 1 all over the blocks.
    pub fn is_one(&self, plane: usize) -> bool {
        self.planes().all(|planes| planes[plane] == [1.0, 0.0, 0.0])
    }

    /// Whether these planes are constant over all blocks; appends the bits of their values.
    pub fn are_uniform(&self, planes: &[usize], values: &mut Vec<u32>) -> bool {
        let mut blocks = self.planes();
        let Some(first) = blocks.next() else { return false };
        for &index in planes {
            let [value, a, b] = first[index];
            // The values in between round to the same number.
            if value + 7.0 * a != value || value + 7.0 * b != value {
                return false;
            }
            values.push(value.to_bits());
        }
        let is_first = |block: &[[f32; 3]], index: usize| {
            block[index][0].to_bits() == first[index][0].to_bits()
        };
        blocks.all(|block| planes.iter().all(|&index| is_first(block, index)))
    }

    /// Whether the quotients of these planes by the denominator are 1 over all blocks, as the planes equal it.
    pub fn are_uniform_ones(
        &self,
        planes: &[usize],
        denominator: usize,
        values: &mut Vec<u32>,
    ) -> bool {
        values.extend(planes.iter().map(|_| 1.0_f32.to_bits()));
        self.planes().all(|block| planes.iter().all(|&index| block[index] == block[denominator]))
    }

    /// The planes of each block.
    fn planes(&self) -> impl Iterator<Item = &[[f32; 3]]> {
        self.planes.chunks_exact((self.planes.len() / self.len.max(1)).max(1))
    }

    /// Removes all blocks.
    pub fn clear(&mut self) {
        self.planes.clear();
        self.len = 0;
    }

    /// Adds a block of a shape with the lanes that passed the early tests, by sample, at most [`MAX_REGISTER_FILES`] blocks.
    /// `uniform` says what is uniform over the shape.
    #[inline]
    pub fn push(
        &mut self,
        planes: impl Iterator<Item = [f32; 3]>,
        facing: Facing,
        block: usize,
        masks: &SampleMasks,
        uniform: UniformOverShape,
    ) {
        self.uniform = if self.len == 0 { uniform } else { self.uniform.intersection(uniform) };
        self.planes.extend(planes);
        self.blocks[self.len] = BlockLanes { block: block as u8, facing, masks: *masks };
        self.len += 1;
    }

    /// The blocks, of the tile whose first pixel is `tile`.
    pub fn blocks(&self, tile: [i32; 2]) -> impl Iterator<Item = BlockOf<'_>> {
        let planes = self.planes.len() / self.len.max(1);
        self.blocks[..self.len].iter().enumerate().map(move |(at, covered)| {
            let block = usize::from(covered.block);
            let [x, y] = BlockAt::numbered(tile, block).first();
            BlockOf {
                planes: &self.planes[at * planes..][..planes],
                facing: covered.facing,
                tests: EarlyTests::Done,
                block,
                x,
                y,
                coverage: None,
            }
        })
    }

    /// The block of each register file.
    pub fn numbers(&self) -> impl Iterator<Item = usize> + Clone {
        self.blocks[..self.len].iter().map(|covered| usize::from(covered.block))
    }

    /// The block of a register file and its lanes, by sample.
    #[inline]
    pub fn covered(&self, file: usize) -> (usize, &SampleMasks) {
        let BlockLanes { block, masks, .. } = &self.blocks[file];
        (usize::from(*block), masks)
    }
}
