//! The positions of a batch's pixels in a tile, and loads and stores of their words.

use super::{BLOCKS, WordPlane};
use texunit::lanes::{Isa, Kernel, LANES, QUADS, Simd, U32s};

/// The positions of a batch's pixels in a tile.
#[derive(Clone, Copy)]
pub enum BatchLayout<'a> {
    /// All of one block.
    Block(usize),
    /// Of each quad: its block times 64 and its quad there; and these blocks, bit by block. Unused quads hold any valid
    /// index. A quad may occur twice, with other pixels each time.
    Quads(&'a [u16; QUADS], u64),
    /// Each pixel by itself: its block times 64 and its lane there; and these blocks, bit by block. No pixel occurs
    /// twice; unused lanes hold any valid index.
    Pixels(&'a [u16; LANES], u64),
}

/// Pixels of a tile.
const PIXELS: usize = BLOCKS * LANES;

/// Whether words are loaded before they are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadOp {
    /// They are loaded.
    Load,
    /// They are not: all bits of each word are written.
    DontCare,
}

/// Lets `change` see the words of a batch's pixels as lanes. It returns a result and the lanes that it has changed,
/// which are put back.
pub fn with_words<R>(
    isa: Isa,
    plane: &mut WordPlane,
    layout: &BatchLayout<'_>,
    load_op: LoadOp,
    change: impl FnOnce(&mut U32s) -> (R, u64),
) -> R {
    if let BatchLayout::Block(block) = *layout {
        return change(plane.block_mut(block)).0;
    }
    let mut words = match load_op {
        LoadOp::Load => load(isa, plane, layout),
        LoadOp::DontCare => U32s::ZERO,
    };
    let (result, changed) = change(&mut words);
    if changed != 0 {
        store(plane, layout, changed, &words);
    }
    result
}

/// [`with_words`] for texels of up to four words, each in a plane of its own: of words that there are
/// `change` sees one batch.
pub fn with_texels(
    isa: Isa,
    planes: &mut [WordPlane],
    layout: &BatchLayout<'_>,
    mask: u64,
    load_op: LoadOp,
    change: impl FnOnce([&mut [U32s]; 4]),
) {
    let mut texels = [U32s::ZERO; 4];
    let is_read = match layout {
        // Put back whole.
        BatchLayout::Block(_) => true,
        BatchLayout::Quads(..) | BatchLayout::Pixels(..) => load_op == LoadOp::Load,
    };
    if is_read {
        for (words, plane) in texels.iter_mut().zip(&mut *planes) {
            *words = load(isa, plane, layout);
        }
    }
    let mut words = <[&mut [U32s]; 4]>::default();
    for (words, batch) in words.iter_mut().zip(texels.chunks_mut(1)).take(planes.len()) {
        *words = batch;
    }
    change(words);
    for (words, plane) in texels.iter().zip(planes) {
        store(plane, layout, mask, words);
    }
}

/// The words of a batch's pixels.
pub fn load(isa: Isa, plane: &mut WordPlane, layout: &BatchLayout<'_>) -> U32s {
    match *layout {
        BatchLayout::Block(block) => plane.block(block),
        BatchLayout::Quads(at, of) => isa.run(GatherQuads { blocks: plane.blocks_mut(of), at }),
        BatchLayout::Pixels(at, of) => isa.run(Gather { blocks: plane.blocks_mut(of), at }),
    }
}

/// Puts back the words of the lanes of a mask; those of a block whole.
pub fn store(plane: &mut WordPlane, layout: &BatchLayout<'_>, mask: u64, words: &U32s) {
    match *layout {
        BatchLayout::Block(block) => *plane.block_mut(block) = *words,
        BatchLayout::Quads(at, of) => scatter_quads(plane.blocks_mut(of), at, mask, words),
        BatchLayout::Pixels(at, of) => scatter_pixels(plane.blocks_mut(of), at, mask, words),
    }
}

/// The words of quads.
struct GatherQuads<'a> {
    blocks: &'a [U32s],
    at: &'a [u16; QUADS],
}

impl Kernel for GatherQuads<'_> {
    type Output = U32s;
    #[inline(always)]
    fn run<S: Simd>(self) -> U32s {
        let mut offsets = U32s::ZERO;
        for e in 0..4 {
            for at in 0..QUADS {
                let first = u32::from(self.at[at]) % PIXELS as u32;
                offsets[e * QUADS + at] = (first + (e * QUADS) as u32) * 4;
            }
        }
        S::gather(bytemuck::cast_slice(self.blocks), &offsets)
    }
}

fn scatter_quads(blocks: &mut [U32s], at: &[u16; QUADS], mask: u64, words: &U32s) {
    /// The lanes of the first quad: one bit of each quarter of the mask.
    const QUAD: u64 = 0x0001_0001_0001_0001;
    for (quad, &at) in at.iter().enumerate() {
        let lanes = mask >> quad & QUAD;
        if lanes == 0 {
            continue;
        }
        let (block, first) = (usize::from(at) / LANES, usize::from(at) % QUADS);
        let Some(to) = blocks.get_mut(block) else { continue };
        if lanes == QUAD {
            for e in 0..4 {
                to[e * QUADS + first] = words[e * QUADS + quad];
            }
        } else {
            for e in 0..4 {
                let to = &mut to[e * QUADS + first];
                let is_stored = lanes >> (e * QUADS) & 1 == 1;
                *to = if is_stored { words[e * QUADS + quad] } else { *to };
            }
        }
    }
}

/// The words of single pixels.
struct Gather<'a> {
    blocks: &'a [U32s],
    at: &'a [u16; LANES],
}

impl Kernel for Gather<'_> {
    type Output = U32s;
    #[inline(always)]
    fn run<S: Simd>(self) -> U32s {
        let mut offsets = U32s::ZERO;
        for lane in 0..LANES {
            offsets[lane] = u32::from(self.at[lane]) % PIXELS as u32 * 4;
        }
        S::gather(bytemuck::cast_slice(self.blocks), &offsets)
    }
}

fn scatter_pixels(blocks: &mut [U32s], at: &[u16; LANES], mask: u64, words: &U32s) {
    let pixels = bytemuck::cast_slice_mut::<_, u32>(blocks);
    let Ok(pixels) = <&mut [u32; PIXELS]>::try_from(pixels) else { return };
    if mask == !0 {
        for lane in 0..LANES {
            pixels[usize::from(at[lane]) % PIXELS] = words[lane];
        }
        return;
    }
    let mut left = mask;
    while left != 0 {
        let lane = left.trailing_zeros() as usize;
        left &= left - 1;
        pixels[usize::from(at[lane]) % PIXELS] = words[lane];
    }
}
