//! A plane: one word of every pixel of a tile.
//!
//! A clear stores one word, and a triangle that covers a block whole may store its plane of depths there, or one stencil; a
//! block gets words of its own when something else is drawn to it.

use super::batch_layout::LoadOp;
use super::depth_plane::{BlockOutcomes, CompareBlocks, DepthPlanes};
use texunit::lanes::{U32s, prefetch};
use texunit::sampler::Compare;

/// Blocks of 8×8 pixels in a tile.
pub const BLOCKS: usize = 64;

/// One word of every pixel of a tile.
#[derive(Clone, Debug)]
pub struct WordPlane {
    /// [`BLOCKS`] blocks, row by row, each in lane order; none where nothing was ever drawn.
    words: Vec<U32s>,
    /// What the blocks hold that have neither words nor a plane of their own.
    word: u32,
    /// The blocks that hold `word`, bit by block.
    filled: u64,
    /// What the blocks in `replaced` hold.
    replaced_word: u32,
    /// The blocks that hold `replaced_word`, bit by block; none of `filled`.
    replaced: u64,
    /// The planes of depths of the blocks in `with_depths`.
    depths: Option<Box<DepthPlanes>>,
    /// The blocks that hold a plane of depths, bit by block; none of `filled` or `replaced`.
    with_depths: u64,
}

/// What a block holds.
#[derive(Clone, Copy, Debug)]
pub enum BlockTexels<'a> {
    /// These words.
    Words(&'a U32s),
    /// This word in every pixel.
    Uniform(u32),
    /// The depths of its plane of these.
    Depth(&'a DepthPlanes),
}

impl WordPlane {
    /// The same word everywhere.
    pub fn cleared(word: u32) -> Self {
        Self { words: Vec::new(), word, filled: !0, ..Self::of_words(Vec::new()) }
    }

    /// [`BLOCKS`] blocks, row by row, each in lane order.
    pub fn of(words: Vec<U32s>) -> Self {
        debug_assert_eq!(words.len(), BLOCKS);
        Self::of_words(words)
    }

    fn of_words(words: Vec<U32s>) -> Self {
        Self {
            words,
            word: 0,
            filled: 0,
            replaced_word: 0,
            replaced: 0,
            depths: None,
            with_depths: 0,
        }
    }

    /// Becomes the same word everywhere. The memory stays, for what is drawn next.
    pub fn clear(&mut self, word: u32) {
        (self.word, self.filled, self.replaced, self.with_depths) = (word, !0, 0, 0);
    }

    /// Stores one word in all pixels of a block. A plane keeps blocks of two words without words of their own.
    pub fn replace_block(&mut self, block: usize, word: u32) {
        let bit = 1 << block;
        self.with_depths &= !bit;
        if word == self.word {
            self.filled |= bit;
            self.replaced &= !bit;
        } else if word == self.replaced_word || self.replaced & !bit == 0 {
            self.replaced_word = word;
            self.replaced |= bit;
            self.filled &= !bit;
        } else {
            *self.block_mut(block) = U32s::splat(word);
        }
    }

    /// Tests the depths of planes against `blocks`, bit by block, as far as their outcome is the same for all pixels of a
    /// block and follows without its words. Blocks of `replaced` where all pass store the plane.
    pub fn test_blocks(
        &mut self,
        test: Compare,
        new: &DepthPlanes,
        blocks: u64,
        replaced: u64,
    ) -> BlockOutcomes {
        let old = self.depths.as_deref().filter(|_| self.with_depths != 0);
        let is_alike = old.is_none_or(|old| old.are_stored_as(new));
        let planes = old.filter(|_| is_alike).map(|old| (self.with_depths, old));
        let known = blocks & (self.filled | planes.map_or(0, |(of, _)| of));
        if known == 0 {
            return BlockOutcomes::default();
        }
        let outcomes = new.isa.run(CompareBlocks { test, new, planes, word: self.word });
        let BlockOutcomes { pass, fail } =
            BlockOutcomes { pass: outcomes.pass & known, fail: outcomes.fail & known };
        let stored = pass & replaced;
        if stored == 0 {
            return BlockOutcomes { pass, fail };
        }
        if !is_alike {
            return BlockOutcomes { pass: pass & !replaced, fail };
        }
        match &mut self.depths {
            Some(old) if self.with_depths != 0 => old.replace(stored, new),
            Some(old) => old.as_mut().clone_from(new),
            None => self.depths = Some(Box::new(new.clone())),
        }
        self.with_depths |= stored;
        self.filled &= !stored;
        BlockOutcomes { pass, fail }
    }

    /// The word that all blocks hold, as after a clear.
    pub fn cleared_word(&self) -> Option<u32> {
        match (self.filled, self.replaced) {
            (u64::MAX, _) => Some(self.word),
            (_, u64::MAX) => Some(self.replaced_word),
            _ => None,
        }
    }

    /// The word that all pixels of a block hold, if it is known without looking at them.
    pub fn uniform_word(&self, block: usize) -> Option<u32> {
        match self.texels(block) {
            BlockTexels::Uniform(word) => Some(word),
            BlockTexels::Words(_) | BlockTexels::Depth(_) => None,
        }
    }

    /// The blocks without words of their own, bit by block.
    #[inline]
    pub fn without_words(&self) -> u64 {
        self.filled | self.replaced | self.with_depths
    }

    /// What a block holds.
    #[inline(always)]
    pub fn texels(&self, block: usize) -> BlockTexels<'_> {
        let is_in = |blocks: u64| blocks >> block & 1 == 1;
        match &self.depths {
            Some(depths) if is_in(self.with_depths) => BlockTexels::Depth(depths),
            Some(_) | None if is_in(self.filled) => BlockTexels::Uniform(self.word),
            Some(_) | None if is_in(self.replaced) => BlockTexels::Uniform(self.replaced_word),
            Some(_) | None => BlockTexels::Words(&self.words[block]),
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

    /// A block, for writing.
    #[inline]
    pub fn block_mut(&mut self, block: usize) -> &mut U32s {
        self.materialize(block, LoadOp::Load);
        &mut self.words[block]
    }

    /// Gives a block words of its own: what it holds, or any words with [`LoadOp::DontCare`].
    #[inline]
    pub fn materialize(&mut self, block: usize, old: LoadOp) {
        if self.without_words() >> block & 1 == 1 {
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
        self.replaced &= !(1 << block);
        self.with_depths &= !(1 << block);
    }

    /// The words of all blocks. Those of blocks without words of their own are undefined before [`Self::materialize`].
    #[inline]
    pub fn materialized_blocks(&mut self) -> &mut [U32s] {
        &mut self.words
    }

    /// All blocks, for writing to those of `blocks`, bit by block.
    #[inline]
    pub fn blocks_mut(&mut self, blocks: u64) -> &mut [U32s] {
        let without_words = self.without_words() & blocks;
        if without_words != 0 {
            self.fill_all(without_words);
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
