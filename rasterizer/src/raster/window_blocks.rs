//! The coverage of blocks by the windows of small triangles. A window begins at a quad, so each of its parts may lie in
//! four blocks. Computed over lanes of shapes, and read block by block ([`super::pack_pixels`]).

use super::small_triangles::{WINDOW_BLOCKS, Windows};
use crate::attachment::BLOCKS;
use crate::attachment::expand_mask;
use crate::sizes::TILE;
use texunit::lanes::{Kernel, LANES, Simd, U32s};

/// The most blocks that a window can reach into.
const MAX_BLOCKS: usize = WINDOW_BLOCKS * WINDOW_BLOCKS;
/// Shapes whose blocks are the bits of one word.
const SHAPES_PER_WORD: usize = 4;
/// Bits of a shape.
const BITS_PER_SHAPE: usize = 16;

/// For each block that a window reaches into, the difference of its number in the tile and that of the first.
const BLOCK_OFFSETS: [usize; BITS_PER_SHAPE] = {
    let mut table = [0; BITS_PER_SHAPE];
    let mut block = 0;
    while block < MAX_BLOCKS {
        table[block] = block / WINDOW_BLOCKS * (TILE as usize / 8) + block % WINDOW_BLOCKS;
        block += 1;
    }
    table
};

/// The coverage by up to 64 shapes of the blocks that their windows overlap.
#[derive(Debug)]
pub struct WindowBlocks {
    /// The lanes, by block in rows of [`WINDOW_BLOCKS`]; the rest of the array avoids a bounds check.
    lanes: [[u64; LANES]; BITS_PER_SHAPE],
    /// The first block of each shape.
    first: U32s,
    /// The blocks of which each shape covers any pixel, four shapes a word. A shape without a window has its first
    /// block, with no covered pixel.
    any: [u64; LANES / SHAPES_PER_WORD],
    /// The position up to which the blocks are read.
    pub reader: Reader,
}

/// The position of the reader, a type of its own so that it stays in registers.
#[derive(Clone, Copy, Debug, Default)]
pub struct Reader {
    /// How many words are begun.
    begun: usize,
    /// The lanes of the current block that are not yet packed.
    left: u64,
}

impl Default for WindowBlocks {
    fn default() -> Self {
        Self {
            lanes: [[0; LANES]; BITS_PER_SHAPE],
            first: U32s::ZERO,
            any: [0; LANES / SHAPES_PER_WORD],
            reader: Reader::default(),
        }
    }
}

/// The coverage of one block by a window.
#[derive(Clone, Copy, Debug)]
pub struct WindowBlock {
    /// The shape that the window belongs to, as its lane in the group.
    pub shape: usize,
    /// The index of the block among those that the window overlaps.
    pub index: usize,
    /// The number of the block in the tile.
    pub block: usize,
    /// The lanes; none where the shape has no window.
    pub lanes: u64,
}

impl WindowBlocks {
    /// The first block whose lanes are not all read.
    #[inline(always)]
    pub fn front(&self, reader: &mut Reader) -> Option<WindowBlock> {
        while reader.left == 0 {
            reader.left = *self.any.get(reader.begun)?;
            reader.begun += 1;
        }
        let bit = reader.left.trailing_zeros() as usize;
        let shape = ((reader.begun - 1) * SHAPES_PER_WORD + bit / BITS_PER_SHAPE) % LANES;
        let index = bit % BITS_PER_SHAPE;
        let lanes = self.lanes[index][shape];
        Some(WindowBlock {
            shape,
            index,
            block: self.first[shape] as usize + BLOCK_OFFSETS[index],
            lanes,
        })
    }

    /// Sets the lanes of the front block that are still to be read.
    #[inline(always)]
    pub fn set_remaining(&mut self, reader: &mut Reader, window_block: WindowBlock, lanes: u64) {
        if lanes == 0 {
            reader.left &= reader.left.wrapping_sub(1);
            return;
        }
        self.lanes[window_block.index % BITS_PER_SHAPE][window_block.shape % LANES] = lanes;
    }
}

/// Divides the windows of `shapes` shapes among blocks.
pub struct DivideWindows<'a> {
    pub windows: &'a Windows,
    pub shapes: usize,
    pub window_blocks: &'a mut WindowBlocks,
}

impl Kernel for DivideWindows<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self {
            windows,
            shapes,
            window_blocks: WindowBlocks { lanes: blocks, first, any, reader },
        } = self;
        *reader = Reader::default();
        let [x, y] = &windows.first_quads;
        for lane in 0..LANES {
            first[lane] = (y[lane] / 4 * 8 + x[lane] / 4) as u32 % BLOCKS as u32;
        }
        let [across, up] = windows.extra_blocks.map(|blocks| blocks.min(WINDOW_BLOCKS - 1));
        for row in 0..=up {
            blocks[row * WINDOW_BLOCKS..][..=across].fill([0; LANES]);
        }
        let small = expand_mask(windows.small_mask());
        for (part, words) in windows.inside().iter().enumerate() {
            for (right, above) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                let (column, row) = (part % 2 + right, part / 2 + above);
                if column > across || row > up {
                    continue;
                }
                let ([even, odd], out) = (words, &mut blocks[row * WINDOW_BLOCKS + column]);
                for lane in 0..LANES {
                    let (x, y) = (x[lane] as u32 % 4, y[lane] as u32 % 4);
                    let moved = select_lanes(lanes_in_right_block(x), right)
                        & select_lanes(lanes_in_upper_block(y), above)
                        & small[lane];
                    // The shift in quads within each half of a word; no bit crosses to the other half.
                    let by = (4 * y + x).wrapping_sub((4 * right + 16 * above) as u32) % 32;
                    let (even, odd) = (even[lane] & moved, odd[lane] & moved);
                    let (even, odd) = (even.rotate_left(by), odd.rotate_left(by));
                    out[lane] |= u64::from(even) | u64::from(odd) << 32;
                }
            }
        }
        let mut found = U32s::ZERO;
        for lane in 0..LANES {
            found[lane] = !small[lane] & 1;
        }
        for row in 0..=up {
            for column in 0..=across {
                let block = row * WINDOW_BLOCKS + column;
                for lane in 0..LANES {
                    found[lane] |= u32::from(blocks[block][lane] != 0) << block;
                }
            }
        }
        found.0[shapes.min(LANES)..].fill(0);
        for (any, four) in any.iter_mut().zip(found.0.as_chunks::<SHAPES_PER_WORD>().0) {
            *any = 0;
            for (at, &bits) in four.iter().enumerate() {
                *any |= u64::from(bits) << (at * BITS_PER_SHAPE);
            }
        }
    }
}

/// Of a part that begins at column `x` of a block's quads: the lanes of a word that lie in the block on its right.
#[inline(always)]
fn lanes_in_right_block(x: u32) -> u32 {
    (0xF0 >> x & 0xF) * 0x1111_1111
}

/// Of a part that begins at row `y`: the lanes in the block above.
#[inline(always)]
fn lanes_in_upper_block(y: u32) -> u32 {
    (0xFFFF_0000 >> (4 * y) & 0xFFFF) * 0x1_0001
}

/// The lanes in the next block, or those in the same.
#[inline(always)]
fn select_lanes(next: u32, block: usize) -> u32 {
    if block == 1 { next } else { !next }
}
