//! Where a batch's pixels lie in a tile, and how their words come and go.

use super::{BLOCKS, Plane};
use texunit::lanes::{Isa, Kernel, LANES, QUADS, Simd, U32s};

/// Where a batch's pixels lie in a tile.
#[derive(Clone, Copy)]
pub enum Place<'a> {
    /// All of one block.
    Block(usize),
    /// The block and quad of each of its quads.
    Quads(&'a [u8], &'a [u8]),
    /// Each pixel by itself: its block times 64 and its lane there; and these blocks, bit by block. No pixel is
    /// there twice; lanes that there are not are anywhere.
    Pixels(&'a [u16; LANES], u64),
}

/// Pixels of a tile.
const PIXELS: usize = BLOCKS * LANES;

/// Whether it matters what words hold before they are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Old {
    /// It does.
    Read,
    /// All of each word is written, whatever it was.
    Ignored,
}

/// Lets `change` see the words of a batch's pixels as lanes, and puts those of `mask` back; it changes
/// no others. (A quad may be in a batch more than once, with other pixels each time.)
pub fn with_words<R>(
    isa: Isa,
    plane: &mut Plane,
    place: &Place<'_>,
    mask: u64,
    old: Old,
    change: impl FnOnce(&mut U32s) -> R,
) -> R {
    match *place {
        Place::Block(block) => change(plane.block_mut(block)),
        Place::Quads(of, quads) => {
            let blocks = plane.blocks_mut(set_of(of));
            let mut words = match old {
                Old::Read => gather(blocks, of, quads),
                Old::Ignored => U32s::ZERO,
            };
            let result = change(&mut words);
            scatter(blocks, of, quads, mask, &words);
            result
        }
        Place::Pixels(at, of) => {
            let blocks = plane.blocks_mut(of);
            let mut words = match old {
                Old::Read => isa.run(Gather { blocks, at }),
                Old::Ignored => U32s::ZERO,
            };
            let result = change(&mut words);
            scatter_pixels(blocks, at, mask, &words);
            result
        }
    }
}

/// [`with_words`] for texels of up to four words, each in a plane of its own.
pub fn with_texels<R>(
    isa: Isa,
    planes: &mut [Plane],
    place: &Place<'_>,
    mask: u64,
    change: impl FnOnce(&mut [U32s; 4]) -> R,
) -> R {
    let mut texels = [U32s::ZERO; 4];
    for (plane, words) in planes.iter_mut().zip(&mut texels) {
        with_words(isa, plane, place, 0, Old::Read, |stored| *words = *stored);
    }
    let result = change(&mut texels);
    for (plane, words) in planes.iter_mut().zip(&texels) {
        match *place {
            Place::Block(block) => *plane.block_mut(block) = *words,
            Place::Quads(of, quads) => {
                scatter(plane.blocks_mut(set_of(of)), of, quads, mask, words)
            }
            Place::Pixels(at, of) => scatter_pixels(plane.blocks_mut(of), at, mask, words),
        }
    }
    result
}

/// Blocks as a set, bit by block.
fn set_of(blocks: &[u8]) -> u64 {
    blocks.iter().fold(0, |set, &block| set | 1 << (usize::from(block) % BLOCKS))
}

fn gather(blocks: &[U32s], of: &[u8], quads: &[u8]) -> U32s {
    let mut words = U32s::ZERO;
    for (at, (&block, &quad)) in of.iter().zip(quads).enumerate() {
        let from = &blocks[usize::from(block)];
        for e in 0..4 {
            words[e * QUADS + at] = from[e * QUADS + usize::from(quad)];
        }
    }
    words
}

fn scatter(blocks: &mut [U32s], of: &[u8], quads: &[u8], mask: u64, words: &U32s) {
    for (at, (&block, &quad)) in of.iter().zip(quads).enumerate() {
        let to = &mut blocks[usize::from(block)];
        for e in 0..4 {
            let to = &mut to[e * QUADS + usize::from(quad)];
            let lane = e * QUADS + at;
            *to = if mask >> lane & 1 == 1 { words[lane] } else { *to };
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
