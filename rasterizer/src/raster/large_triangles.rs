//! A triangle that covers many blocks of a tile: its coverage of each block, computed with one lane per block. The numbers
//! are those of [`super::edge_functions::block`].

use super::batch::is_dense;
use super::edge_functions::{Edge, TileEdges, edges};
use super::tile_planes::ComputePlanes;
use crate::attachment::BLOCKS;
use crate::plan::Packing;
use crate::sizes::TILE;
use std::ops::Range;
use texunit::lanes::{Isa, Kernel, LANES, Simd, U32s};

/// The least number of blocks in the bounds of a triangle for which they are computed together.
pub const MIN_BLOCKS: i32 = 3;

/// Blocks along a side of a tile.
pub const TILE_BLOCKS: usize = TILE as usize / 8;
const _: () = assert!(
    BLOCKS == LANES && TILE_BLOCKS * TILE_BLOCKS == LANES,
    "lanes are the blocks of a tile"
);

/// The coverage of each block of a tile by a large triangle.
#[derive(Debug)]
pub struct LargeTriangle {
    /// The blocks of which it covers any pixel, bit by block.
    pub touched: u64,
    /// The blocks that it covers so densely that they are shaded as blocks.
    pub dense: u64,
    /// The covered lanes of each touched block.
    pub covered: [u64; BLOCKS],
}

impl Default for LargeTriangle {
    fn default() -> Self {
        Self { touched: 0, dense: 0, covered: [0; BLOCKS] }
    }
}

/// The blocks of a set.
#[inline(always)]
pub fn bits(mut set: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let bit = (set != 0).then(|| set.trailing_zeros() as usize % BLOCKS);
        set &= set.wrapping_sub(1);
        bit
    })
}

impl LargeTriangle {
    /// Computes what the triangle of these `corners` covers of the rows of blocks for which `planes` are computed, and these.
    pub fn compute(
        &mut self,
        isa: Isa,
        corners: &[[i32; 2]; 3],
        packing: Packing,
        planes: ComputePlanes<'_>,
    ) {
        isa.run(ComputeBlocks { corners, packing, planes, out: self });
    }

    /// Removes the lanes outside an area; `inside` gives the lanes of a block inside it.
    pub fn clip_to_area(&mut self, packing: Packing, inside: impl Fn(usize) -> u64) {
        let touched = std::mem::take(&mut self.touched);
        self.dense = 0;
        for block in bits(touched) {
            self.covered[block] &= inside(block);
            self.set_bits(packing, block);
        }
    }

    /// Whether a pending batch holds a fragment in any of the covered lanes.
    #[inline]
    pub fn overlaps_pending(&self, has_pending: impl Fn(usize, u64) -> bool) -> bool {
        bits(self.touched).any(|block| has_pending(block, self.covered[block]))
    }

    /// Sets the bits of a block in `touched` and `dense` from its covered lanes.
    #[inline(always)]
    fn set_bits(&mut self, packing: Packing, block: usize) {
        let lanes = self.covered[block];
        self.touched |= u64::from(lanes != 0) << block;
        self.dense |= u64::from(is_dense(packing, lanes)) << block;
    }
}

struct ComputeBlocks<'a> {
    corners: &'a [[i32; 2]; 3],
    packing: Packing,
    planes: ComputePlanes<'a>,
    out: &'a mut LargeTriangle,
}

impl Kernel for ComputeBlocks<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { corners, packing, planes, out } = self;
        let (tile, rows) = (planes.tile, planes.rows.clone());
        out.cover::<S>(&edges(corners, tile[0], tile[1]), rows, packing);
        planes.run::<S>();
    }
}

impl LargeTriangle {
    /// Computes the lanes of each block that are inside all edges.
    #[inline(always)]
    fn cover<S: Simd>(&mut self, edges: &[Edge; 3], rows: Range<usize>, packing: Packing) {
        let [touched, full] = blocks::<S>(edges, rows);
        (self.touched, self.dense) = (full, full);
        self.covered = [!0; BLOCKS];
        let tile_edges = TileEdges::of(edges);
        for block in bits(touched & !full) {
            let at = [block % TILE_BLOCKS, block / TILE_BLOCKS].map(|at| at as i32);
            self.covered[block] = tile_edges.lanes::<S>(edges, at);
            self.set_bits(packing, block);
        }
    }
}

/// The blocks that are not outside of any edge, and the blocks that are entirely inside all edges.
#[inline(always)]
pub fn blocks<S: Simd>(edges: &[Edge; 3], rows: Range<usize>) -> [u64; 2] {
    let (mut outside, mut crossed) = (U32s::ZERO, U32s::ZERO);
    let within = !0 << (TILE_BLOCKS * rows.start)
        & !0 >> (LANES - TILE_BLOCKS * rows.end.clamp(1, TILE_BLOCKS));
    for edge in edges {
        let (x, y) = (i64::from(edge.x), i64::from(edge.y));
        let most = 7 * (x.max(0) + y.max(0));
        let least = 7 * (x.min(0) + y.min(0));
        let mut across = [0; TILE_BLOCKS];
        for (number, across) in across.iter_mut().enumerate() {
            *across = edge.value + 8 * x * number as i64;
        }
        for row in rows.clone() {
            let up = 8 * y * row as i64;
            for column in 0..TILE_BLOCKS {
                let first = across[column] + up;
                // The sign is in the upper word.
                outside[row * TILE_BLOCKS + column] |= ((first + most) >> 32) as u32 & 1 << 31;
                crossed[row * TILE_BLOCKS + column] |= ((first + least) >> 32) as u32 & 1 << 31;
            }
        }
    }
    [within & !S::nonzero(&outside), within & !S::nonzero(&crossed)]
}

#[cfg(test)]
mod tests {
    use super::super::edge_functions::{block, edges};
    use super::*;
    use proptest::prelude::*;

    struct CoverOf<'a>(&'a [Edge; 3], Packing);

    impl Kernel for CoverOf<'_> {
        type Output = LargeTriangle;
        #[inline(always)]
        fn run<S: Simd>(self) -> LargeTriangle {
            let mut triangle = LargeTriangle::default();
            triangle.cover::<S>(self.0, 0..TILE_BLOCKS, self.1);
            triangle
        }
    }

    proptest! {
        #[test]
        fn blocks_are_covered_as_each_by_itself_is(
            corners in prop::array::uniform3(prop::array::uniform2(
                prop_oneof![-8_000..24_000i32, -8_388_608..=8_388_608i32])),
        ) {
            let edges = edges(&corners, 0, 0);
            let packings = [Packing::Pixels, Packing::Quads, Packing::SampledQuads];
            for (isa, packing) in Isa::available().into_iter().flat_map(|isa| packings.map(|by| (isa, by))) {
                let triangle = isa.run(CoverOf(&edges, packing));
                for at in 0..LANES {
                    let want = block(isa, &edges, at as i32 % 8, at as i32 / 8).lanes();
                    let is_in = |blocks: u64| blocks >> at & 1 == 1;
                    let lanes = if is_in(triangle.touched) { triangle.covered[at] } else { 0 };
                    prop_assert_eq!(lanes, want, "{} block {}", isa.name(), at);
                    prop_assert_eq!(is_in(triangle.touched), want != 0, "{} block {}", isa.name(), at);
                    prop_assert_eq!(is_in(triangle.dense), is_dense(packing, want), "{} block {}", isa.name(), at);
                }
            }
        }
    }
}
