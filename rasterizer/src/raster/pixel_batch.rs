//! A batch of fragments without helper lanes: up to 64 pixels of any blocks of
//! the tile.
//!
//! If no computation of a draw depends on the other pixels of a quad, helper lanes are not needed: a triangle of five
//! pixels is five lanes, not four quads.

use super::batch::{Batch, BatchPixels, EachPlane};
use crate::attachment::{BLOCKS, BatchLayout};
use crate::desc::Facing;
use crate::plan::SampleMasks;
use texunit::lanes::{F32s, Isa, Kernel, LANES, Simd};

/// Lanes that are stored at once; those after the last pixel are overwritten by the next push.
const STORED_LANES: usize = 8;
/// Lanes of an array that may be written beyond the last pixel.
const PADDED_LANES: usize = LANES + STORED_LANES;
/// Multiplied by a `u16`, has it in each of the four `u16` of the word.
const EACH_U16: u64 = 0x0001_0001_0001_0001;

/// The pixels of a pending batch.
#[derive(Debug)]
pub struct Pixels {
    /// How many.
    len: usize,
    /// The position of each: the number of its block in the tile times 64, plus its lane.
    at: [u16; PADDED_LANES],
    /// The occupied lanes, once it is a batch.
    masks: SampleMasks,
    /// The lanes of back faces, bit by lane.
    pub back: u64,
    pub planes: Vec<EachPlane<PADDED_LANES>>,
    /// Column and row of each in its block.
    pub position: [F32s; 2],
    /// The first pixel of that block.
    pub block: [F32s; 2],
    /// By block: the lanes that are pending in this batch.
    pending: [u64; BLOCKS],
    /// The blocks of which any lane is pending.
    blocks: u64,
}

impl Default for Pixels {
    fn default() -> Self {
        Self {
            len: 0,
            at: [0; PADDED_LANES],
            masks: SampleMasks::none(1),
            back: 0,
            planes: Vec::new(),
            position: [F32s::ZERO; 2],
            block: [F32s::ZERO; 2],
            pending: [0; BLOCKS],
            blocks: 0,
        }
    }
}

impl Pixels {
    /// Whether nothing is pending.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Whether no pixel fits any more.
    #[inline(always)]
    pub fn is_full(&self) -> bool {
        self.len == LANES
    }

    /// Whether a fragment in these lanes of a block is pending: later fragments of its pixel must follow it.
    #[inline(always)]
    pub fn has_pending(&self, block: usize, lanes: u64) -> bool {
        self.pending[block % BLOCKS] & lanes != 0
    }

    /// The occupied lanes.
    #[inline(always)]
    fn mask(&self) -> u64 {
        !0 >> (LANES - self.len.clamp(1, LANES))
    }

    /// The pending pixels as a batch, in the tile whose first pixel is `tile`.
    pub fn batch(&mut self, isa: Isa, tile: [i32; 2]) -> Batch<'_> {
        isa.run(LocatePixels { pixels: self, tile });
        self.masks = SampleMasks::one(self.mask());
        Batch { pixels: BatchPixels::Pixels(self), masks: &self.masks, tested: 0 }
    }

    /// Where the pixels are in the tile.
    pub fn layout(&self) -> BatchLayout<'_> {
        BatchLayout::Pixels(self.at.first_chunk().unwrap_or(&[0; LANES]), self.blocks)
    }

    /// Removes all pixels, and prepares for a draw with `planes` planes.
    pub fn clear(&mut self, planes: usize) {
        while self.blocks != 0 {
            self.pending[self.blocks.trailing_zeros() as usize % BLOCKS] = 0;
            self.blocks &= self.blocks - 1;
        }
        (self.len, self.back) = (0, 0);
        if self.planes.len() != planes {
            self.planes.resize(planes, EachPlane::NONE);
        }
    }

    /// Adds lanes of a block of one shape, as many as fit; returns the rest. `planes` are, of each plane,
    /// its value at the first pixel of the block and its steps across and up.
    #[inline(always)]
    pub fn push(
        &mut self,
        block: usize,
        lanes: u64,
        facing: Facing,
        planes: impl Iterator<Item = [f32; 3]> + Clone,
    ) -> u64 {
        let first = self.len % LANES;
        let capacity = LANES - first;
        let (mut count, mut rest) = (lanes.count_ones() as usize, 0);
        if count > capacity {
            (count, rest) = (capacity, lanes);
            for _ in 0..capacity {
                rest &= rest - 1;
            }
        }
        let mut left = lanes & !rest;
        self.len = first + count;
        self.pending[block % BLOCKS] |= left;
        self.blocks |= 1 << (block % BLOCKS);
        let block = (block * LANES) as u64 * EACH_U16;
        for at in (first..self.len).step_by(STORED_LANES) {
            // Always true; the compiler then omits the bounds checks.
            let at = at % LANES;
            for to in self.at[at..at + STORED_LANES].as_chunks_mut::<4>().0 {
                let mut next = || {
                    let lane = u64::from(left.trailing_zeros());
                    left &= left.wrapping_sub(1);
                    lane
                };
                // One after the other into one word: as a loop over lanes this becomes a detour.
                let four = block | next() | next() << 16 | next() << 32 | next() << 48;
                *to = [four as u16, (four >> 16) as u16, (four >> 32) as u16, (four >> 48) as u16];
            }
            for (plane, [corner, a, b]) in self.planes.iter_mut().zip(planes.clone()) {
                plane.corner[at..at + STORED_LANES].fill(corner);
                plane.a[at..at + STORED_LANES].fill(a);
                plane.b[at..at + STORED_LANES].fill(b);
            }
        }
        if facing == Facing::Back {
            self.back |= self.mask() & !0 << first;
        }
        rest
    }
}

/// Computes the position of each pixel in its block, and the first pixel of that block.
struct LocatePixels<'a> {
    pixels: &'a mut Pixels,
    /// The first pixel of the tile.
    tile: [i32; 2],
}

impl Kernel for LocatePixels<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { pixels: Pixels { at, position, block, .. }, tile } = self;
        let ([x, y], [left, low]) = (position, block);
        for lane in 0..LANES {
            let (block, lane_there) = (i32::from(at[lane]) / 64, i32::from(at[lane]) % 64);
            let (pixel, quad) = (lane_there / 16, lane_there % 16);
            x[lane] = (quad % 4 * 2 + pixel % 2) as f32;
            y[lane] = (quad / 4 * 2 + pixel / 2) as f32;
            left[lane] = (tile[0] + block % 8 * 8) as f32;
            low[lane] = (tile[1] + block / 8 * 8) as f32;
        }
    }
}
