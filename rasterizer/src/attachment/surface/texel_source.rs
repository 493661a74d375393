//! Texels of a surface as a source for lookups: a shadow map is sampled from its tiles, as most of its texels are never
//! read, and tiles that one triangle covers, or that were cleared only, have no words.

use super::{Slices, StoreContext, Surface, WordPlane};
use crate::sizes::TILE;
use crate::threads::ThreadPool;
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Level, TexelSource};
use texunit::lanes::{Isa, Kernel, LANES, Simd, U32s};

/// The fewest pixels for which a surface is sampled from its tiles: of a smaller one most texels are read, and lookups in
/// tiles take longer than lookups in rows.
const WORTH_TILES: u64 = 1 << 22;

/// At most this many tiles of a gather are gathered from over lanes; the lanes in other tiles read one by one.
const GATHERED_TILES: usize = 8;

/// The tiles of a surface of one sample.
#[derive(Debug)]
struct TileTexels {
    isa: Isa,
    surface: Surface,
}

impl Surface {
    /// A level whose texels are gathered from these tiles; `None` where it has to be stored in rows to be sampled.
    pub fn level_of_tiles(&self, isa: Isa) -> Option<Level> {
        let has_source = matches!(self.format, Format::D24 | Format::D32F | Format::D24S8);
        let pixels = u64::from(self.width) * u64::from(self.height);
        if !has_source || self.samples != 1 || pixels < WORTH_TILES {
            return None;
        }
        let source = Arc::new(TileTexels { isa, surface: self.clone() });
        Level::stored_elsewhere(self.format, [self.width, self.height], source).ok()
    }
}

impl Surface {
    /// Whether a level reads these tiles.
    pub fn has_readers(&self) -> bool {
        Arc::strong_count(&self.tiles) > 1
    }
}

impl TexelSource for TileTexels {
    fn gather(&self, offsets: &U32s) -> U32s {
        self.isa.run(Gather { surface: &self.surface, offsets })
    }

    fn rows(&self) -> Vec<u8> {
        let Surface { format, width, height, .. } = self.surface;
        // Without memory there are no texels, and a lookup in them fails.
        let Ok(mut level) = Level::new(format, width, height) else { return Vec::new() };
        let context = StoreContext { isa: self.isa, thread_pool: &ThreadPool::CALLER_ONLY };
        self.surface.store(&mut level, Slices::One(0), context);
        level.texels.to_vec()
    }
}

struct Gather<'a> {
    surface: &'a Surface,
    offsets: &'a U32s,
}

impl Kernel for Gather<'_> {
    type Output = U32s;
    #[inline(always)]
    fn run<S: Simd>(self) -> U32s {
        let Self { surface, offsets } = self;
        let (width, across) = (surface.width, surface.tiles_across());
        let (last_x, last_y) = (width - 1, surface.height - 1);
        // The quotient of a whole number and a half is at least 1 / (2 width) away from whole numbers, and rounded by less.
        let inverse = 1.0 / f64::from(width);
        let (mut tiles, mut places) = (U32s::ZERO, U32s::ZERO);
        for lane in 0..LANES {
            let texel = offsets[lane] >> 2;
            let y = ((f64::from(texel) + 0.5) * inverse) as u32;
            // Behind the last texel is the padding of the rows, which no filter weighs.
            let y = if y < last_y { y } else { last_y };
            let x = texel.wrapping_sub(y.wrapping_mul(width));
            let x = if x < last_x { x } else { last_x };
            tiles[lane] = (y / TILE) * across + x / TILE;
            let block = (y / 8 % 8) * 8 + x / 8 % 8;
            let quad = (y / 2 % 4) * 4 + x / 2 % 4;
            places[lane] = block << 6 | (y & 1) << 5 | (x & 1) << 4 | quad;
        }
        let mut words = U32s::ZERO;
        let mut left = !0_u64;
        for _ in 0..GATHERED_TILES {
            if left == 0 {
                return words;
            }
            let tile = tiles[left.trailing_zeros() as usize % LANES];
            let mut other = U32s::ZERO;
            for lane in 0..LANES {
                other[lane] = tiles[lane] ^ tile;
            }
            let others = S::nonzero(&other);
            let found = gather_from::<S>(&surface.tiles[tile as usize], &places);
            for lane in 0..LANES {
                words[lane] = if other[lane] == 0 { found[lane] } else { words[lane] };
            }
            left &= others;
        }
        while left != 0 {
            let lane = left.trailing_zeros() as usize % LANES;
            left &= left - 1;
            let planes = &surface.tiles[tiles[lane] as usize];
            let word = |plane: &WordPlane| plane.word(places[lane]);
            words[lane] =
                word_of_planes([word(&planes[0]), planes.get(1).map_or(0, word)], planes.len());
        }
        words
    }
}

/// A texel's word in rows from its words in tiles: depth, and depth with stencil.
#[inline(always)]
fn word_of_planes([depth, stencil]: [u32; 2], planes: usize) -> u32 {
    if planes == 1 { depth } else { depth << 8 | stencil & 0xFF }
}

/// The words of texels of one tile.
#[inline(always)]
fn gather_from<S: Simd>(planes: &[WordPlane], places: &U32s) -> U32s {
    let depths = planes[0].gather::<S>(places);
    let Some(stencils) = planes.get(1) else { return depths };
    let stencils = stencils.gather::<S>(places);
    U32s::from_fn(|lane| word_of_planes([depths[lane], stencils[lane]], 2))
}
