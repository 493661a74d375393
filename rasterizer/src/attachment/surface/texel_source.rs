//! Texels of a surface as a source for lookups: a shadow map is sampled from its tiles, as most of its texels are never
//! read, and blocks that one triangle covers, or that were cleared only, have no words.

use super::{BLOCKS, BlockTexels, Slices, StoreContext, Surface};
use crate::attachment::{DepthPlanes, expand_mask};
use crate::sizes::TILE;
use crate::threads::ThreadPool;
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Level, TexelSource};
use texunit::lanes::{F32s, Isa, Kernel, LANES, Simd, U32s};

/// The fewest pixels for which a surface is sampled from its tiles: of a smaller one most texels are read, and lookups in
/// tiles take longer than lookups in rows.
const WORTH_TILES: u64 = 1 << 22;

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
        let mut planes = PlanesOfLanes::default();
        for lane in 0..LANES {
            let plane = &surface.tiles[tiles[lane] as usize][0];
            let (block, at) =
                (places[lane] as usize / LANES % BLOCKS, places[lane] as usize % LANES);
            match plane.texels(block) {
                BlockTexels::Words(of) => words[lane] = of[at],
                BlockTexels::Uniform(word) => words[lane] = word,
                BlockTexels::Depth(depths) if planes.is_stored_alike(depths) => {
                    planes.set(lane, depths, block);
                }
                BlockTexels::Depth(depths) => words[lane] = depths.word(block, at),
            }
        }
        if planes.lanes != 0 {
            planes.evaluate(&places, &mut words);
        }
        if surface.tiles[0].len() > 1 {
            for lane in 0..LANES {
                words[lane] <<= 8;
            }
        }
        words
    }
}

/// The planes of depths at lanes whose blocks have no words.
struct PlanesOfLanes<'a> {
    /// Those of the first of these lanes, for how depths are stored.
    first: Option<&'a DepthPlanes>,
    /// The lanes, bit by lane.
    lanes: u64,
    /// Of each: the depth at the first pixel of its block, per pixel across, per pixel up.
    planes: [F32s; 3],
}

impl Default for PlanesOfLanes<'_> {
    fn default() -> Self {
        Self { first: None, lanes: 0, planes: [F32s::ZERO; 3] }
    }
}

impl<'a> PlanesOfLanes<'a> {
    /// Whether planes store depths as the first ones do.
    #[inline(always)]
    fn is_stored_alike(&mut self, depths: &'a DepthPlanes) -> bool {
        let first = *self.first.get_or_insert(depths);
        std::ptr::eq(first, depths) || first.are_stored_as(depths)
    }

    /// Sets the plane of a lane to that of a block.
    #[inline(always)]
    fn set(&mut self, lane: usize, depths: &DepthPlanes, block: usize) {
        self.lanes |= 1 << lane;
        for (to, from) in self.planes.iter_mut().zip(&depths.planes) {
            to[lane] = from[block];
        }
    }

    /// The words of the lanes at their places.
    #[inline(always)]
    fn evaluate(&self, places: &U32s, words: &mut U32s) {
        let Some(first) = self.first else { return };
        let of_planes = first.words_at(&self.planes, places);
        let has_plane = expand_mask(self.lanes);
        for lane in 0..LANES {
            words[lane] = of_planes[lane] & has_plane[lane] | words[lane] & !has_plane[lane];
        }
    }
}
