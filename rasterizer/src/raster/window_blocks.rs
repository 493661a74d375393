//! What the windows of small triangles cover of blocks. A window begins at a quad, so each of its parts may lie in
//! four blocks. Computed over lanes of shapes, and read share by share ([`super::pack_pixels`]).

use super::small_triangles::{REACHED, Windows};
use crate::attachment::BLOCKS;
use crate::output::expand_mask;
use crate::sizes::TILE;
use texunit::lanes::{Kernel, LANES, Simd, U32s};

/// Blocks that a window can reach into.
const MOST: usize = REACHED * REACHED;
/// Shapes whose blocks are the bits of one word.
const AT_ONCE: usize = 4;
/// Bits of a shape.
const BITS: usize = 16;

/// From the first block that a window reaches into to each of them, in the tile.
const FURTHER: [usize; BITS] = {
    let mut table = [0; BITS];
    let mut block = 0;
    while block < MOST {
        table[block] = block / REACHED * (TILE as usize / 8) + block % REACHED;
        block += 1;
    }
    table
};

/// What up to 64 shapes cover of the blocks that their windows reach into.
#[derive(Debug)]
pub struct Shares {
    /// The lanes, by block in rows of [`REACHED`]; the others avoid a bounds check.
    lanes: [[u64; LANES]; BITS],
    /// The first block of each shape.
    first: U32s,
    /// Of each shape the blocks of which it covers anything, four shapes a word. One without a window has its
    /// first, and covers nothing of it.
    any: [u64; LANES / AT_ONCE],
    /// How far it is read.
    pub reader: Reader,
}

/// The position of the reader, a type of its own so that it stays in registers.
#[derive(Clone, Copy, Debug, Default)]
pub struct Reader {
    /// How many words are begun.
    begun: usize,
    /// What is left of the last of them.
    left: u64,
}

impl Default for Shares {
    fn default() -> Self {
        Self {
            lanes: [[0; LANES]; BITS],
            first: U32s::ZERO,
            any: [0; LANES / AT_ONCE],
            reader: Reader::default(),
        }
    }
}

/// What a window covers of one block.
#[derive(Clone, Copy, Debug)]
pub struct Share {
    /// Whose window.
    pub shape: usize,
    /// Which of the blocks that it reaches into.
    pub part: usize,
    /// Which of the tile.
    pub block: usize,
    /// The lanes; none where the shape has no window.
    pub lanes: u64,
}

impl Shares {
    /// The first share that is left.
    #[inline(always)]
    pub fn first(&self, reader: &mut Reader) -> Option<Share> {
        while reader.left == 0 {
            reader.left = *self.any.get(reader.begun)?;
            reader.begun += 1;
        }
        let bit = reader.left.trailing_zeros() as usize;
        let shape = ((reader.begun - 1) * AT_ONCE + bit / BITS) % LANES;
        let part = bit % BITS;
        let lanes = self.lanes[part][shape];
        Some(Share { shape, part, block: self.first[shape] as usize + FURTHER[part], lanes })
    }

    /// Leaves these lanes of the first one.
    #[inline(always)]
    pub fn leave(&mut self, reader: &mut Reader, share: Share, lanes: u64) {
        if lanes == 0 {
            reader.left &= reader.left.wrapping_sub(1);
            return;
        }
        self.lanes[share.part % BITS][share.shape % LANES] = lanes;
    }
}

/// Finds the shares of `shapes` shapes.
pub struct Divide<'a> {
    pub windows: &'a Windows,
    pub shapes: usize,
    pub shares: &'a mut Shares,
}

impl Kernel for Divide<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { windows, shapes, shares: Shares { lanes: blocks, first, any, reader } } = self;
        *reader = Reader::default();
        let [x, y] = &windows.quads;
        for lane in 0..LANES {
            first[lane] = (y[lane] / 4 * 8 + x[lane] / 4) as u32 % BLOCKS as u32;
        }
        let [across, up] = windows.further.map(|blocks| blocks.min(REACHED - 1));
        for row in 0..=up {
            blocks[row * REACHED..][..=across].fill([0; LANES]);
        }
        let small = expand_mask(windows.small());
        for (part, words) in windows.inside().iter().enumerate() {
            for (right, above) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                let (column, row) = (part % 2 + right, part / 2 + above);
                if column > across || row > up {
                    continue;
                }
                let ([even, odd], out) = (words, &mut blocks[row * REACHED + column]);
                for lane in 0..LANES {
                    let (x, y) = (x[lane] as u32 % 4, y[lane] as u32 % 4);
                    let there = side(to_the_right(x), right) & side(on_top(y), above) & small[lane];
                    // By so many quads within each half of a word; none leaves it.
                    let by = (4 * y + x).wrapping_sub((4 * right + 16 * above) as u32) % 32;
                    let (even, odd) = (even[lane] & there, odd[lane] & there);
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
                let block = row * REACHED + column;
                for lane in 0..LANES {
                    found[lane] |= u32::from(blocks[block][lane] != 0) << block;
                }
            }
        }
        found.0[shapes.min(LANES)..].fill(0);
        for (any, four) in any.iter_mut().zip(found.0.as_chunks::<AT_ONCE>().0) {
            *any = 0;
            for (at, &bits) in four.iter().enumerate() {
                *any |= u64::from(bits) << (at * BITS);
            }
        }
    }
}

/// Of a part that begins at column `x` of a block's quads: the lanes of a word that lie in the block on its right.
#[inline(always)]
fn to_the_right(x: u32) -> u32 {
    (0xF0 >> x & 0xF) * 0x1111_1111
}

/// Of one that begins at row `y`: those in the block above.
#[inline(always)]
fn on_top(y: u32) -> u32 {
    (0xFFFF_0000 >> (4 * y) & 0xFFFF) * 0x1_0001
}

/// The lanes in the next block, or those in the same.
#[inline(always)]
fn side(next: u32, block: usize) -> u32 {
    if block == 1 { next } else { !next }
}
