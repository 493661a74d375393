//! A plane: one word of every pixel of a tile.
//!
//! A clear stores one word, and a triangle that covers the tile stores its plane of depths; a block gets words of its own
//! when something else is drawn to it.

use super::batch_layout::LoadOp;
use super::depth_plane::DepthPlane;
use texunit::lanes::{LANES, Simd, U32s, prefetch};

/// Blocks of 8×8 pixels in a tile.
pub const BLOCKS: usize = 64;

/// One word of every pixel of a tile.
#[derive(Clone, Debug)]
pub struct WordPlane {
    /// [`BLOCKS`] blocks, row by row, each in lane order; none where nothing was ever drawn.
    words: Vec<U32s>,
    /// What the blocks hold that have no words of their own.
    fill: Fill,
    /// The blocks without words of their own, bit by block.
    filled: u64,
}

/// What blocks without words of their own hold.
#[derive(Clone, Debug)]
enum Fill {
    /// This word: that of a clear.
    Word(u32),
    /// The depths of a triangle that covers the tile.
    Depth(Box<DepthPlane>),
}

/// What a block holds.
#[derive(Clone, Copy, Debug)]
pub enum BlockTexels<'a> {
    /// These words.
    Words(&'a U32s),
    /// This word in every pixel.
    Uniform(u32),
    /// The depths of a plane.
    Depth(&'a DepthPlane),
}

impl WordPlane {
    /// The same word everywhere.
    pub fn cleared(word: u32) -> Self {
        Self { words: Vec::new(), fill: Fill::Word(word), filled: !0 }
    }

    /// [`BLOCKS`] blocks, row by row, each in lane order.
    pub fn of(words: Vec<U32s>) -> Self {
        debug_assert_eq!(words.len(), BLOCKS);
        Self { words, fill: Fill::Word(0), filled: 0 }
    }

    /// Becomes the same word everywhere. The memory stays, for what is drawn next.
    pub fn clear(&mut self, word: u32) {
        (self.fill, self.filled) = (Fill::Word(word), !0);
    }

    /// Puts the depths of a plane into the blocks without words of their own, and returns these blocks.
    pub fn fill_with(&mut self, depths: DepthPlane) -> u64 {
        self.fill = Fill::Depth(Box::new(depths));
        self.filled
    }

    /// The word of the blocks without words of their own, if there are any and it is the same in all of them.
    pub fn fill_word(&self) -> Option<u32> {
        match self.fill {
            Fill::Word(word) if self.filled != 0 => Some(word),
            Fill::Word(_) | Fill::Depth(_) => None,
        }
    }

    /// The word of the clear, if all blocks still hold it.
    pub fn cleared_word(&self) -> Option<u32> {
        match self.fill {
            Fill::Word(word) if self.filled == !0 => Some(word),
            Fill::Word(_) | Fill::Depth(_) => None,
        }
    }

    /// Whether a block has no words of its own.
    #[inline]
    fn is_filled(&self, block: usize) -> bool {
        self.filled >> block & 1 == 1
    }

    /// What a block holds.
    #[inline(always)]
    pub fn texels(&self, block: usize) -> BlockTexels<'_> {
        match &self.fill {
            _ if !self.is_filled(block) => BlockTexels::Words(&self.words[block]),
            Fill::Word(word) => BlockTexels::Uniform(*word),
            Fill::Depth(depths) => BlockTexels::Depth(depths),
        }
    }

    /// The words of a block.
    #[inline]
    pub fn block(&self, block: usize) -> U32s {
        match self.texels(block) {
            BlockTexels::Words(words) => *words,
            BlockTexels::Uniform(word) => U32s::splat(word),
            BlockTexels::Depth(depths) => depths.block(block),
        }
    }

    /// The word of a pixel: its block times 64 and its lane there.
    pub fn word(&self, place: u32) -> u32 {
        let (block, lane) = (place as usize / LANES % BLOCKS, place as usize % LANES);
        match self.texels(block) {
            BlockTexels::Words(words) => words[lane],
            BlockTexels::Uniform(word) => word,
            BlockTexels::Depth(depths) => depths.word(block, lane),
        }
    }

    /// The words of pixels: the block times 64 and the lane there of each.
    #[inline(always)]
    pub fn gather<S: Simd>(&self, places: &U32s) -> U32s {
        let fill = match &self.fill {
            _ if self.filled == 0 => U32s::ZERO,
            Fill::Word(word) => U32s::splat(*word),
            Fill::Depth(depths) => depths.gather::<S>(places),
        };
        if self.filled == !0 {
            return fill;
        }
        let mut offsets = U32s::ZERO;
        for lane in 0..LANES {
            offsets[lane] = places[lane] % (BLOCKS * LANES) as u32 * 4;
        }
        let mut words = S::gather(bytemuck::cast_slice(&self.words), &offsets);
        if self.filled != 0 {
            let [low, high] = [self.filled as u32, (self.filled >> 32) as u32];
            for lane in 0..LANES {
                let block = places[lane] / LANES as u32;
                let half = if block & 32 == 0 { low } else { high };
                words[lane] = if half >> (block & 31) & 1 == 1 { fill[lane] } else { words[lane] };
            }
        }
        words
    }

    /// A block, for writing.
    #[inline]
    pub fn block_mut(&mut self, block: usize) -> &mut U32s {
        self.materialize(block, LoadOp::Load);
        &mut self.words[block]
    }

    /// Gives a block words of its own: what it holds, or any words with [`LoadOp::DontCare`].
    #[inline]
    pub fn materialize(&mut self, block: usize, old: LoadOp) {
        if self.is_filled(block) {
            self.fill(block, old);
        }
    }

    #[cold]
    fn fill(&mut self, block: usize, old: LoadOp) {
        if self.words.is_empty() {
            self.words = vec![U32s::ZERO; BLOCKS];
        }
        if old == LoadOp::Load {
            self.words[block] = self.block(block);
        }
        self.filled &= !(1 << block);
    }

    /// The words of all blocks. Those of blocks without words of their own are undefined before [`Self::materialize`].
    #[inline]
    pub fn materialized_blocks(&mut self) -> &mut [U32s] {
        &mut self.words
    }

    /// All blocks, for writing to those of `blocks`, bit by block.
    #[inline]
    pub fn blocks_mut(&mut self, blocks: u64) -> &mut [U32s] {
        let filled = self.filled & blocks;
        if filled != 0 {
            self.fill_all(filled);
        }
        &mut self.words
    }

    #[cold]
    fn fill_all(&mut self, mut blocks: u64) {
        while blocks != 0 {
            self.fill(blocks.trailing_zeros() as usize, LoadOp::Load);
            blocks &= blocks - 1;
        }
    }

    /// Prefetches the words of a block.
    #[inline]
    pub fn prefetch(&self, block: usize) {
        if let Some(words) = self.words.get(block) {
            prefetch(words);
        }
    }
}
