//! The attachment layout of a level: tiles, planes, blocks, lanes.
//!
//! While an image is drawn to, its texels are words in tiles of 64×64 pixels, each of 64 blocks of
//! 8×8 pixels, each in lane order. A batch then reads and writes whole vectors, a tile's words stay
//! in the cache of the thread that owns it, and tiles can be handed to threads as values. Going
//! back to rows (to sample or to read back) is a transition of layout, as in Vulkan, and exact.
//!
//! A texel of several words has a plane for each, and so has every sample of a multisample image.
//! Which words a format has is in [`super::words`].

mod changed;
mod store;
mod texel_source;

use super::plane::{BLOCKS, BlockTexels, WordPlane};
use super::words::{attachment_words, is_attachable, words_of};
use crate::sizes::TILE;
use crate::threads::ThreadPool;
use bytemuck::Pod;
use changed::RowsOfTile;
use std::sync::Arc;
pub use store::{RowSpan, RowWriter};
use texunit::format::Format;
use texunit::image::Level;
use texunit::lanes::{Isa, LANES, QUADS, U32s, lane_x, lane_y};

/// At least this many tiles are stored by several threads; fewer are stored before another thread wakes.
const WORTH_THREADS: usize = 32;
/// The fewest tiles that a thread loads.
const WORTH_A_THREAD: usize = 8;

/// A level in the attachment layout.
#[derive(Clone, Debug)]
pub struct Surface {
    /// The format of the level.
    pub format: Format,
    /// Pixels across.
    pub width: u32,
    /// Pixels up.
    pub height: u32,
    /// Samples of a pixel.
    pub samples: u8,
    /// The planes of each tile, row by row of tiles: word `w` of sample `s` is plane
    /// `s · words + w`.
    tiles: Arc<Vec<Vec<WordPlane>>>,
    /// By tile: what the rows of the level hold of it.
    rows: Vec<RowsOfTile>,
}

/// Which slices of a level hold the samples of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slices {
    /// This one: its texels in every sample, and what the samples are resolved to.
    One(usize),
    /// One for each sample, from this one on.
    Each(usize),
}

/// The instruction set and the threads that store a surface.
#[derive(Clone, Copy, Debug)]
pub struct StoreContext<'a> {
    /// The instruction set of the device, which resolves samples.
    pub isa: Isa,
    /// The threads that store the tiles of a large surface.
    pub thread_pool: &'a ThreadPool,
}

/// One attachment's part of a tile.
#[derive(Debug)]
pub struct TileTarget {
    /// Number of planes of one sample: the words of a texel.
    pub planes_per_sample: usize,
    /// As in [`Surface::tiles`].
    pub planes: Vec<WordPlane>,
}

impl TileTarget {
    /// The planes of one sample.
    pub fn sample(&mut self, sample: usize) -> &mut [WordPlane] {
        &mut self.planes[sample * self.planes_per_sample..][..self.planes_per_sample]
    }

    /// Prefetches the words of blocks that are written soon.
    #[inline]
    pub fn prefetch(&self, blocks: impl Iterator<Item = usize> + Clone) {
        for plane in &self.planes {
            blocks.clone().for_each(|block| plane.prefetch(block));
        }
    }
}

/// Lane of each pixel of a block's row.
const LANE_AT: [[u8; 8]; 8] = {
    let mut table = [[0; 8]; 8];
    let mut lane = 0;
    while lane < LANES {
        table[lane_y(lane)][lane_x(lane)] = lane as u8;
        lane += 1;
    }
    table
};

/// Row `y` of a block.
#[inline(always)]
fn row_of(block: &U32s, y: usize) -> [u32; 8] {
    let first = usize::from(LANE_AT[y][0]);
    let (even, odd) = (&block.0[first..first + 4], &block.0[first + QUADS..first + QUADS + 4]);
    [even[0], odd[0], even[1], odd[1], even[2], odd[2], even[3], odd[3]]
}

/// Sets row `y` of a block.
#[inline]
fn set_row(block: &mut U32s, y: usize, row: [u32; 8]) {
    let first = usize::from(LANE_AT[y][0]);
    block.0[first..first + 4].copy_from_slice(&[row[0], row[2], row[4], row[6]]);
    block.0[first + QUADS..first + QUADS + 4].copy_from_slice(&[row[1], row[3], row[5], row[7]]);
}

impl Surface {
    /// Whether it has the format, the size and the samples of another.
    pub fn is_like(&self, other: &Self) -> bool {
        let of = |own: &Self| (own.format, own.width, own.height, own.samples);
        of(self) == of(other)
    }

    /// Tiles across.
    pub fn tiles_across(&self) -> u32 {
        self.width.div_ceil(TILE)
    }

    /// The texels of slices of a level without border, in tiles; zeros where the format has no
    /// attachment layout, which a command buffer with such an attachment is refused for.
    pub fn from_level(
        level: &Level,
        slices: Slices,
        samples: u8,
        thread_pool: &ThreadPool,
    ) -> Self {
        Self::from_level_as(level.format, level, slices, samples, thread_pool)
    }

    /// The same, of texels that are taken for ones of another format of their size.
    pub fn from_level_as(
        format: Format,
        level: &Level,
        slices: Slices,
        samples: u8,
        thread_pool: &ThreadPool,
    ) -> Self {
        let &Level { width, height, .. } = level;
        let tiles = 0..width.div_ceil(TILE) * height.div_ceil(TILE);
        let load = |tile: u32| load_samples((format, level), slices, samples, tile);
        let tiles = thread_pool.map(tiles, WORTH_A_THREAD, load);
        let rows = tiles.iter().map(|tile| RowsOfTile::after_storing(format, tile)).collect();
        Self { format, width, height, samples, tiles: Arc::new(tiles), rows }
    }

    /// A surface of zeros.
    pub fn zeros(format: Format, width: u32, height: u32, samples: u8) -> Self {
        let planes = usize::from(samples) * attachment_words(format);
        let tiles = width.div_ceil(TILE) * height.div_ceil(TILE);
        let tiles = vec![vec![WordPlane::cleared(0); planes]; tiles as usize];
        let rows = vec![RowsOfTile::Uniform([0; 4]); tiles.len()];
        Self { format, width, height, samples, tiles: Arc::new(tiles), rows }
    }

    /// Moves a tile's planes out of the surface, to be drawn to.
    pub fn take(&mut self, tile: usize) -> TileTarget {
        self.rows[tile].change();
        let planes = std::mem::take(&mut Arc::make_mut(&mut self.tiles)[tile]);
        TileTarget { planes_per_sample: attachment_words(self.format), planes }
    }

    /// Puts back the planes of a tile that [`Surface::take`] moved out.
    pub fn put_back(&mut self, tile: usize, planes: Vec<WordPlane>) {
        Arc::make_mut(&mut self.tiles)[tile] = planes;
    }
}

/// All samples of a tile.
fn load_samples(
    (format, level): (Format, &Level),
    slices: Slices,
    samples: u8,
    tile: u32,
) -> Vec<WordPlane> {
    let (across, words) = (level.width.div_ceil(TILE), attachment_words(format));
    let corner = [tile % across * TILE, tile / across * TILE];
    let of_slice = |slice: usize| {
        if is_attachable(format) && !level.texels.is_blank() {
            load_tile((format, level), slice, corner, words)
        } else {
            vec![WordPlane::cleared(0); words]
        }
    };
    match slices {
        Slices::One(slice) => {
            let one = of_slice(slice);
            (0..samples).flat_map(|_| one.clone()).collect()
        }
        Slices::Each(first) => (first..).take(samples.into()).flat_map(of_slice).collect(),
    }
}

/// One sample of the tile whose first pixel is `(x0, y0)`.
fn load_tile(
    (format, level): (Format, &Level),
    slice: usize,
    [x0, y0]: [u32; 2],
    words: usize,
) -> Vec<WordPlane> {
    let size = level.format.bytes();
    let (row_bytes, first) = (level.row_bytes(), level.origin() + slice * level.slice_bytes());
    let (width, height) = (TILE.min(level.width - x0) as usize, TILE.min(level.height - y0));
    let row = |y: u32| {
        &level.texels[first + (y0 + y) as usize * row_bytes + x0 as usize * size..][..width * size]
    };
    // One texel everywhere, as where nothing has been drawn yet, takes no memory.
    let all = row(0);
    if all[size..] == all[..(width - 1) * size] && (1..height).all(|y| row(y) == all) {
        let texel = words_of(format, &all[..size]);
        return texel[..words].iter().copied().map(WordPlane::cleared).collect();
    }
    let mut planes = vec![vec![U32s::ZERO; BLOCKS]; words];
    for y in 0..height {
        load_row(format, &mut planes, y as usize, row(y));
    }
    planes.into_iter().map(WordPlane::of).collect()
}

/// Row `y` of a tile from the texels of one row.
fn load_row(format: Format, planes: &mut [Vec<U32s>], y: usize, row: &[u8]) {
    let put = |plane: &mut Vec<U32s>, column: usize, words: [u32; 8]| {
        set_row(&mut plane[y / 8 * 8 + column], y % 8, words);
    };
    // Texels whose bytes are those of their words.
    match (&mut *planes, format.bytes()) {
        ([a], 1) => columns(row, |column, texels: [u8; 8]| put(a, column, texels.map(u32::from))),
        ([a], 2) => columns(row, |column, texels: [u16; 8]| {
            put(a, column, texels.map(|texel| u16::from_le(texel).into()));
        }),
        ([a], 3) => columns(row, |column, texels: [[u8; 3]; 8]| {
            put(a, column, texels.map(|[r, g, b]| u32::from_le_bytes([r, g, b, 0])));
        }),
        ([a], 4) => {
            columns(row, |column, texels: [u32; 8]| put(a, column, texels.map(u32::from_le)))
        }
        ([a, b], 8) => columns(row, |column, texels: [[u32; 2]; 8]| {
            put(a, column, texels.map(|[word, _]| u32::from_le(word)));
            put(b, column, texels.map(|[_, word]| u32::from_le(word)));
        }),
        ([a, b, c, d], 16) => columns(row, |column, texels: [[u32; 4]; 8]| {
            put(a, column, texels.map(|[word, _, _, _]| u32::from_le(word)));
            put(b, column, texels.map(|[_, word, _, _]| u32::from_le(word)));
            put(c, column, texels.map(|[_, _, word, _]| u32::from_le(word)));
            put(d, column, texels.map(|[_, _, _, word]| u32::from_le(word)));
        }),
        (_, size) => {
            for (column, texels) in row.chunks(8 * size).enumerate() {
                let lanes = LANE_AT[y % 8].map(usize::from);
                for (lane, texel) in lanes.into_iter().zip(texels.chunks_exact(size)) {
                    for (plane, word) in planes.iter_mut().zip(words_of(format, texel)) {
                        plane[y / 8 * 8 + column][lane] = word;
                    }
                }
            }
        }
    }
}

/// Hands out a row in columns of eight texels, those that the last one lacks as zeros.
#[inline(always)]
fn columns<T: Pod>(row: &[u8], mut column: impl FnMut(usize, [T; 8])) {
    for (count, bytes) in row.chunks(size_of::<[T; 8]>()).enumerate() {
        let mut texels = [T::zeroed(); 8];
        bytemuck::bytes_of_mut(&mut texels)[..bytes.len()].copy_from_slice(bytes);
        column(count, texels);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_of_a_block_is_its_lanes_in_order() {
        let mut block = U32s::ZERO;
        for lane in 0..LANES {
            block[lane] = lane as u32;
        }
        for (y, lanes) in LANE_AT.iter().enumerate() {
            assert_eq!(row_of(&block, y), lanes.map(u32::from));
        }
    }

    /// Tiles of one texel are attached without words, others with them; all come back as they
    /// were, edges included.
    #[test]
    fn what_is_loaded_is_what_is_stored() {
        use Format::{D24S8, R8, R16F, Rgb8, Rgb32F, Rgba8, Rgba16F, Rgba32F};
        for format in [R8, R16F, Rgb8, Rgba8, D24S8, Rgba16F, Rgb32F, Rgba32F] {
            let mut level = Level::new(format, 150, 70).expect("small");
            let middle = level.row_bytes() * 30;
            for (index, byte) in
                level.texels[middle..][..64 * format.bytes()].iter_mut().enumerate()
            {
                *byte = (index * 7 % 251) as u8;
            }
            let surface = Surface::from_level(&level, Slices::One(0), 1, &ThreadPool::CALLER_ONLY);
            let cleared = |tile: &Vec<WordPlane>| tile[0].cleared_word().is_some();
            assert_eq!(surface.tiles.iter().filter(|tile| cleared(tile)).count(), 5);
            let mut back = Level::new(format, 150, 70).expect("small");
            let context = StoreContext { isa: Isa::best(), thread_pool: &ThreadPool::CALLER_ONLY };
            surface.store(&mut back, Slices::One(0), context);
            assert_eq!(back.texels, level.texels, "{format:?}");
        }
    }

    /// A slice for each sample holds them as they are, whichever slice is the first.
    #[test]
    fn samples_keep_to_slices_of_their_own() {
        for format in [Format::Rgba8, Format::D24S8, Format::Rgba32F, Format::R16F] {
            let mut level = Level::with_size(format, [70, 3, 7], [0; 3]).expect("small");
            let used = 7 * level.slice_bytes();
            for (index, byte) in level.texels[..used].iter_mut().enumerate() {
                *byte = (index * 31 % 241) as u8;
            }
            let surface = Surface::from_level(&level, Slices::Each(2), 4, &ThreadPool::CALLER_ONLY);
            let mut back = Level::with_size(format, [70, 3, 7], [0; 3]).expect("small");
            let context = StoreContext { isa: Isa::best(), thread_pool: &ThreadPool::CALLER_ONLY };
            surface.store(&mut back, Slices::Each(2), context);
            let slice = level.slice_bytes();
            let (stored, left) = (2 * slice..6 * slice, &back.texels[6 * slice..]);
            assert_eq!(back.texels[stored.clone()], level.texels[stored], "{format:?}");
            assert!(left.iter().chain(&back.texels[..2 * slice]).all(|byte| *byte == 0));
        }
    }

    #[test]
    #[cfg_attr(target_family = "wasm", ignore = "there are no threads there")]
    fn what_is_stored_does_not_depend_on_the_number_of_threads() {
        let mut level = Level::new(Format::Rgba8, 641, 530).expect("small");
        let used = level.row_bytes() * 530;
        for (index, byte) in level.texels[..used].iter_mut().enumerate() {
            *byte = (index * 37 % 253) as u8;
        }
        let surface = Surface::from_level(&level, Slices::One(0), 1, &ThreadPool::CALLER_ONLY);
        assert!(surface.tiles.len() >= WORTH_THREADS);
        for helpers in [0, 1, 6] {
            let mut back = Level::new(Format::Rgba8, 641, 530).expect("small");
            let thread_pool = &ThreadPool::of_workers(helpers);
            surface.store(
                &mut back,
                Slices::One(0),
                StoreContext { isa: Isa::best(), thread_pool },
            );
            assert!(back.texels == level.texels, "{helpers} helpers");
        }
    }
}
