//! Sets of pixels that filled polygons are left in, as bitmaps are.

use super::viewport::Rect;
use crate::sizes::TILE;

/// Blocks of 8×8 pixels along a side of a tile.
const BLOCKS: usize = TILE as usize / 8;

/// Pixels of 8×8 that lie together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaskBlock {
    /// Column and row of the block: 0 holds the pixels 0 to 7.
    pub at: [u32; 2],
    /// The pixels, see [`MaskBlock::row`].
    pub pixels: u64,
}

impl MaskBlock {
    /// Pixels of a row from 0 to 7, the leftmost in the lowest bit, which lie as lanes do (`texunit::lanes`).
    #[inline]
    pub fn row(y: u32, bits: u8) -> u64 {
        // The first of each pair.
        let firsts = |bits: u8| {
            let bits = bits & 0x55;
            let bits = (bits | bits >> 1) & 0x33;
            u64::from((bits | bits >> 2) & 0xF)
        };
        (firsts(bits) | firsts(bits >> 1) << 16) << (y / 2 * 4 + y % 2 * 32)
    }
}

/// The blocks of a tile.
type Tile = Box<[u64; BLOCKS * BLOCKS]>;

/// A set of pixels of a framebuffer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PixelMask {
    /// Tiles side by side.
    across: usize,
    /// Those that hold any.
    tiles: Vec<Option<Tile>>,
}

impl PixelMask {
    /// An empty set for a framebuffer of this size.
    pub fn new(width: u32, height: u32) -> Self {
        let [across, up] = [width, height].map(|side| side.div_ceil(TILE) as usize);
        Self { across, tiles: vec![None; across * up] }
    }

    /// The tile of a block, and its number there.
    #[inline]
    fn tile_and_block(&self, [column, row]: [u32; 2]) -> (usize, usize) {
        let [x, y] = [column as usize, row as usize];
        (y / BLOCKS * self.across + x / BLOCKS, y % BLOCKS * BLOCKS + x % BLOCKS)
    }

    /// The pixels of a block that it holds.
    #[inline]
    pub fn block(&self, at: [u32; 2]) -> u64 {
        let (tile, block) = self.tile_and_block(at);
        self.tiles.get(tile).and_then(Option::as_ref).map_or(0, |blocks| blocks[block])
    }

    /// Adds pixels; those outside of the framebuffer are ignored.
    pub fn add(&mut self, MaskBlock { at, pixels }: MaskBlock) {
        let (tile, block) = self.tile_and_block(at);
        if let Some(tile) = self.tiles.get_mut(tile) {
            tile.get_or_insert_with(|| Box::new([0; BLOCKS * BLOCKS]))[block] |= pixels;
        }
    }

    /// Rectangles that hold all of its pixels, none of which is in two; they may reach beyond the framebuffer.
    pub fn areas(&self) -> impl Iterator<Item = Rect> {
        let tiles = self.tiles.iter().enumerate();
        tiles.filter_map(|(index, tile)| {
            let [x, y] = [index % self.across, index / self.across].map(|at| (at * BLOCKS) as u32);
            let used = tile.iter().flat_map(|tile| tile.iter().enumerate()).filter(|of| *of.1 != 0);
            let positions =
                used.map(|(block, _)| [block % BLOCKS, block / BLOCKS].map(|at| at as u32));
            let bounds = |[low, high]: [[u32; 2]; 2], at: [u32; 2]| {
                [[low[0].min(at[0]), low[1].min(at[1])], [high[0].max(at[0]), high[1].max(at[1])]]
            };
            let [low, high] =
                positions.map(|at| [at, at]).reduce(|all, [at, _]| bounds(all, at))?;
            Some(Rect {
                x: ((x + low[0]) * 8) as i32,
                y: ((y + low[1]) * 8) as i32,
                width: (high[0] - low[0] + 1) * 8,
                height: (high[1] - low[1] + 1) * 8,
            })
        })
    }

    /// The bytes of its memory.
    pub fn bytes(&self) -> usize {
        let count = self.tiles.iter().flatten().count();
        size_of_val(&self.tiles[..]) + count * size_of::<[u64; BLOCKS * BLOCKS]>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use texunit::lanes::{LANES, lane_x, lane_y};

    #[test]
    fn the_pixels_of_a_block_lie_as_lanes_do() {
        for lane in 0..LANES {
            assert_eq!(MaskBlock::row(lane_y(lane) as u32, 1 << lane_x(lane)), 1 << lane);
        }
    }

    #[test]
    fn a_mask_holds_what_was_added_and_its_areas_are_of_that() {
        let mut mask = PixelMask::new(130, 70);
        let blocks = [([3, 2], 5), ([4, 1], 1), ([16, 8], 8), ([3, 2], 2), ([0, 16], 1)];
        blocks.into_iter().for_each(|(at, pixels)| mask.add(MaskBlock { at, pixels }));
        assert_eq!((mask.block([3, 2]), mask.block([16, 8])), (7, 8));
        assert_eq!((mask.block([3, 3]), mask.block([0, 16]), mask.block([99, 99])), (0, 0, 0));
        let areas: Vec<_> = mask.areas().map(|r| (r.x, r.y, r.width, r.height)).collect();
        assert_eq!(areas, [(24, 8, 16, 16), (128, 64, 8, 8)]);
        assert_eq!(PixelMask::new(1, 1).areas().count(), 0);
    }
}
