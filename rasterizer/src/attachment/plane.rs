//! A plane: one word of every pixel of a tile.
//!
//! A clear stores one word and a bit for each cleared block; a block gets memory of its own when something is drawn
//! to it.

use super::batch_layout::LoadOp;
use texunit::lanes::{U32s, prefetch};

/// Blocks of 8×8 pixels in a tile.
pub const BLOCKS: usize = 64;

/// One word of every pixel of a tile.
#[derive(Clone, Debug)]
pub struct WordPlane {
    /// [`BLOCKS`] blocks, row by row, each in lane order; none where nothing was ever drawn.
    words: Vec<U32s>,
    /// The word of the last clear.
    word: u32,
    /// The blocks that have the word of the clear and no words of their own, bit by block.
    cleared: u64,
}

impl WordPlane {
    /// The same word everywhere.
    pub fn cleared(word: u32) -> Self {
        Self { words: Vec::new(), word, cleared: !0 }
    }

    /// [`BLOCKS`] blocks, row by row, each in lane order.
    pub fn of(words: Vec<U32s>) -> Self {
        debug_assert_eq!(words.len(), BLOCKS);
        Self { words, word: 0, cleared: 0 }
    }

    /// Becomes the same word everywhere. The memory stays, for what is drawn next.
    pub fn clear(&mut self, word: u32) {
        (self.word, self.cleared) = (word, !0);
    }

    /// The word of the clear, if all blocks still hold it.
    pub fn cleared_word(&self) -> Option<u32> {
        (self.cleared == !0).then_some(self.word)
    }

    /// Whether a block holds the word of the clear.
    #[inline]
    fn is_cleared(&self, block: usize) -> bool {
        self.cleared >> block & 1 == 1
    }

    /// The words of a block, or the one that it is cleared to.
    #[inline(always)]
    pub fn block_or_clear(&self, block: usize) -> Result<&U32s, u32> {
        if self.is_cleared(block) { Err(self.word) } else { Ok(&self.words[block]) }
    }

    /// The words of a block.
    #[inline]
    pub fn block(&self, block: usize) -> U32s {
        self.block_or_clear(block).copied().unwrap_or_else(U32s::splat)
    }

    /// A block, for writing.
    #[inline]
    pub fn block_mut(&mut self, block: usize) -> &mut U32s {
        self.materialize(block, LoadOp::Load);
        &mut self.words[block]
    }

    /// Gives a cleared block words of its own: the word of the clear, or any words with [`LoadOp::DontCare`].
    #[inline]
    pub fn materialize(&mut self, block: usize, old: LoadOp) {
        if self.is_cleared(block) {
            self.fill(block, old);
        }
    }

    #[cold]
    fn fill(&mut self, block: usize, old: LoadOp) {
        if self.words.is_empty() {
            self.words = vec![U32s::ZERO; BLOCKS];
        }
        if old == LoadOp::Load {
            self.words[block] = U32s::splat(self.word);
        }
        self.cleared &= !(1 << block);
    }

    /// The words of all blocks. Those of cleared blocks are undefined before [`Self::materialize`].
    #[inline]
    pub fn materialized_blocks(&mut self) -> &mut [U32s] {
        &mut self.words
    }

    /// All blocks, for writing to those of `blocks`, bit by block.
    #[inline]
    pub fn blocks_mut(&mut self, blocks: u64) -> &mut [U32s] {
        let cleared = self.cleared & blocks;
        if cleared != 0 {
            self.fill_all(cleared);
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
