//! Batches of fragments: the block of one shape, or up to 16 quads, of many blocks or of many shapes.

use super::pixel_batch::Pixels;
use crate::attachment::{BLOCKS, BatchLayout};
use crate::desc::Facing;
use crate::plan::{Packing, SampleMasks};
use crate::sizes::MAX_SAMPLES;
use texunit::lanes::{F32s, LANES, QUADS};

/// Fragments that are shaded together.
#[derive(Clone, Copy)]
pub struct Batch<'a> {
    /// Their pixels, and the planes that are interpolated there.
    pub pixels: BatchPixels<'a>,
    /// Which lanes are covered, by sample.
    pub masks: &'a SampleMasks,
    /// Lanes of quads whose early tests are done.
    pub tested: u64,
}

/// The pixels of a batch.
#[derive(Clone, Copy)]
pub enum BatchPixels<'a> {
    /// All of a block.
    Block(&'a BlockOf<'a>),
    /// Quads from anywhere in the tile.
    Packed(&'a Packed),
    /// No quads: each lane is a pixel by itself.
    Pixels(&'a Pixels),
}

/// A block of a shape.
pub struct BlockOf<'a> {
    /// Of each plane: at its first pixel, per pixel across, per pixel up.
    pub planes: &'a [[f32; 3]],
    /// The facing of the primitive.
    pub facing: Facing,
    /// Whether the early tests of its lanes are done.
    pub tests: EarlyTests,
    /// Which block of the tile.
    pub block: usize,
    /// Its first pixel.
    pub x: i32,
    /// Its first row.
    pub y: i32,
    /// The covered fraction of each lane's pixel, where the draw reads it.
    pub coverage: Option<&'a F32s>,
}

/// Whether the early tests of fragments are done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EarlyTests {
    /// Done: the remaining lanes passed.
    Done,
    /// Due: the batch runs them, if the draw has any.
    Due,
}

impl<'a> Batch<'a> {
    /// All of a block.
    pub fn of_block(of: &'a BlockOf<'a>, masks: &'a SampleMasks) -> Self {
        let tested = match of.tests {
            EarlyTests::Done => !0,
            EarlyTests::Due => 0,
        };
        Self { pixels: BatchPixels::Block(of), masks, tested }
    }

    /// Lanes that run: of quads the whole, so that derivatives have their neighbours.
    pub fn active(&self) -> u64 {
        let any = self.masks.any();
        match self.pixels {
            BatchPixels::Block(_) | BatchPixels::Packed(_) if any != !0 => lanes_of(quads_of(any)),
            BatchPixels::Block(_) | BatchPixels::Packed(_) | BatchPixels::Pixels(_) => any,
        }
    }

    /// Lanes of back faces.
    pub fn back(&self) -> u64 {
        match self.pixels {
            BatchPixels::Block(of) => match of.facing {
                Facing::Front => 0,
                Facing::Back => !0,
            },
            BatchPixels::Packed(packed) => {
                let mut quads = 0;
                for (quad, &front) in packed.front.iter().enumerate().take(packed.len) {
                    quads |= u16::from(front == 0) << quad;
                }
                lanes_of(quads)
            }
            BatchPixels::Pixels(pixels) => pixels.back,
        }
    }

    /// Where its pixels are.
    pub fn layout(&self) -> BatchLayout<'a> {
        match self.pixels {
            BatchPixels::Block(of) => BatchLayout::Block(of.block),
            BatchPixels::Packed(packed) => BatchLayout::Quads(&packed.positions, packed.blocks),
            BatchPixels::Pixels(pixels) => pixels.layout(),
        }
    }
}

/// The three numbers of a plane for each of some quads or pixels: at the first pixel of its block, per
/// pixel across, per pixel up.
#[derive(Clone, Debug)]
pub struct EachPlane<const N: usize> {
    pub corner: [f32; N],
    pub a: [f32; N],
    pub b: [f32; N],
}

impl<const N: usize> EachPlane<N> {
    /// Zero everywhere.
    pub const NONE: Self = Self { corner: [0.0; N], a: [0.0; N], b: [0.0; N] };
}

/// Quads collected from several blocks or shapes until they fill a batch.
#[derive(Clone, Debug)]
pub struct Packed {
    /// How many quads.
    len: usize,
    masks: SampleMasks,
    tested: u64,
    /// Of each quad: its block times 64 and its quad there.
    positions: [u16; QUADS],
    /// These blocks, bit by block.
    blocks: u64,
    /// Its first pixel within the block.
    pub dx: [f32; QUADS],
    pub dy: [f32; QUADS],
    /// The first pixel of the block.
    pub x: [f32; QUADS],
    pub y: [f32; QUADS],
    /// The word of each quad's [`front_word`].
    pub front: [u32; QUADS],
    /// The covered fraction of each lane's pixel, where the draw reads it.
    pub coverage: F32s,
    pub planes: Vec<EachPlane<QUADS>>,
    /// By sample and block: the lanes that are pending in this batch.
    pending: [[u64; BLOCKS]; MAX_SAMPLES],
}

impl Default for Packed {
    fn default() -> Self {
        Self {
            len: 0,
            masks: SampleMasks::none(1),
            tested: 0,
            positions: [0; QUADS],
            blocks: 0,
            dx: [0.0; QUADS],
            dy: [0.0; QUADS],
            x: [0.0; QUADS],
            y: [0.0; QUADS],
            front: [0; QUADS],
            coverage: F32s::ZERO,
            planes: Vec::new(),
            pending: [[0; BLOCKS]; MAX_SAMPLES],
        }
    }
}

impl Packed {
    /// Whether nothing is pending.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Whether no quad fits any more.
    pub fn is_full(&self) -> bool {
        self.len == QUADS
    }

    /// Whether a fragment of any of these samples of a block is pending: later fragments of a sample must follow it.
    /// Fragments of other samples of the same pixel, as along an edge that triangles share, may be in one batch.
    #[inline]
    pub fn has_pending(&self, block: usize, masks: &SampleMasks) -> bool {
        let mut pairs = masks.iter().zip(&self.pending);
        pairs.any(|(lanes, pending)| pending[block] & lanes != 0)
    }

    /// The same quads with other planes.
    pub fn with_planes(&self, change: impl Fn([f32; 3]) -> [f32; 3]) -> Self {
        let mut changed = self.clone();
        for plane in &mut changed.planes {
            for quad in 0..QUADS {
                [plane.corner[quad], plane.a[quad], plane.b[quad]] =
                    change([plane.corner[quad], plane.a[quad], plane.b[quad]]);
            }
        }
        changed
    }

    /// The pending quads as a batch.
    pub fn batch(&self) -> Batch<'_> {
        Batch { pixels: BatchPixels::Packed(self), masks: &self.masks, tested: self.tested }
    }

    /// Removes all quads, and prepares for a draw with these numbers of planes and samples.
    pub fn clear(&mut self, planes: usize, samples: usize) {
        for pending in self.pending.iter_mut().take(self.masks.iter().len()) {
            let mut left = self.blocks;
            while left != 0 {
                pending[left.trailing_zeros() as usize % BLOCKS] = 0;
                left &= left - 1;
            }
        }
        (self.len, self.blocks) = (0, 0);
        self.masks = SampleMasks::none(samples);
        self.tested = 0;
        if self.planes.len() != planes {
            self.planes.resize(planes, EachPlane::NONE);
        }
    }

    /// Adds one quad of a block; `from` is its quad in `masks`, the covered lanes by sample.
    #[inline]
    pub fn push(&mut self, of: &BlockOf<'_>, quad: usize, from: usize, masks: &SampleMasks) {
        let at = self.len % QUADS;
        self.len += 1;
        self.positions[at] = (of.block * LANES + quad) as u16;
        self.blocks |= 1 << of.block;
        self.dx[at] = QUAD_X[quad % QUADS];
        self.dy[at] = QUAD_Y[quad % QUADS];
        self.x[at] = of.x as f32;
        self.y[at] = of.y as f32;
        self.front[at] = front_word(of.facing);
        let samples = self.masks.iter_mut().zip(&mut self.pending).zip(masks.iter());
        for ((mask, pending), &lanes) in samples {
            *mask |= moved_quad(lanes, from, at);
            pending[of.block] |= moved_quad(lanes, from, quad);
        }
        if of.tests == EarlyTests::Done {
            self.tested |= lanes_of(1 << at);
        }
        if let Some(coverage) = of.coverage {
            for e in 0..4 {
                self.coverage[e * QUADS + at] = coverage[e * QUADS + from];
            }
        }
        for (plane, &[corner, a, b]) in self.planes.iter_mut().zip(of.planes) {
            plane.corner[at] = corner;
            plane.a[at] = a;
            plane.b[at] = b;
        }
    }
}

/// All lanes of quads.
#[inline]
fn lanes_of(quads: u16) -> u64 {
    let quads = u64::from(quads);
    quads | quads << QUADS | quads << (2 * QUADS) | quads << (3 * QUADS)
}

/// The lanes of quad `from`, as those of quad `to`.
#[inline]
pub fn moved_quad(lanes: u64, from: usize, to: usize) -> u64 {
    (lanes >> from & lanes_of(1)) << to
}

/// Quads of a block from which on it is shaded by itself rather than packed with others.
const DENSE_QUADS: u32 = 12;
/// The same of several samples, of which every word is gathered and scattered for a quad in a packed batch.
const DENSE_SAMPLED_QUADS: u32 = 5;
/// Pixels of one, where these need not be quads.
const DENSE_PIXELS: u32 = 30;

/// Whether a block is covered densely enough to be shaded by itself.
#[inline(always)]
pub fn is_dense(packing: Packing, lanes: u64) -> bool {
    match packing {
        Packing::Quads => quads_of(lanes).count_ones() >= DENSE_QUADS,
        Packing::SampledQuads => quads_of(lanes).count_ones() >= DENSE_SAMPLED_QUADS,
        Packing::Pixels => lanes.count_ones() >= DENSE_PIXELS,
    }
}

/// The quads of a mask of lanes, bit by quad.
#[inline(always)]
pub fn quads_of(mask: u64) -> u16 {
    (mask | mask >> QUADS | mask >> (2 * QUADS) | mask >> (3 * QUADS)) as u16
}

/// Column of each quad's first pixel in its block.
pub const QUAD_X: [f32; QUADS] =
    [0.0, 2.0, 4.0, 6.0, 0.0, 2.0, 4.0, 6.0, 0.0, 2.0, 4.0, 6.0, 0.0, 2.0, 4.0, 6.0];
/// Row of each quad's first pixel in its block.
pub const QUAD_Y: [f32; QUADS] =
    [0.0, 0.0, 0.0, 0.0, 2.0, 2.0, 2.0, 2.0, 4.0, 4.0, 4.0, 4.0, 6.0, 6.0, 6.0, 6.0];

/// The boolean that says which side is seen.
pub fn front_word(facing: Facing) -> u32 {
    match facing {
        Facing::Front => crate::ir::TRUE,
        Facing::Back => 0,
    }
}
