//! Where a block of 8×8 pixels is.

use crate::sizes::TILE;

/// The blocks along a side of a tile.
const SIDE: i32 = TILE as i32 / 8;

/// A block of a tile.
#[derive(Clone, Copy, Debug)]
pub struct BlockAt {
    /// The tile's first pixel.
    pub tile: [i32; 2],
    /// The block's column and row within the tile.
    pub block: [i32; 2],
}

impl BlockAt {
    /// The block of this number.
    #[inline(always)]
    pub const fn numbered(tile: [i32; 2], number: usize) -> Self {
        Self { tile, block: [number as i32 % SIDE, number as i32 / SIDE] }
    }

    /// Its first pixel.
    #[inline(always)]
    pub const fn first(self) -> [i32; 2] {
        let Self { tile: [x, y], block: [bx, by] } = self;
        [x + 8 * bx, y + 8 * by]
    }

    /// Its number in the tile, row by row.
    #[inline(always)]
    pub const fn number(self) -> usize {
        (self.block[1] * SIDE + self.block[0]) as usize
    }
}
