//! A triangle that covers many blocks of a tile: its coverage and its planes in each block, computed with one lane per
//! block. The numbers are those of [`super::edge_functions::block`] and [`PlaneGroup::at`].

use super::batch::is_dense;
use super::edge_functions::{Edge, TileEdges, edges};
use super::fragment_depth::TestBlocks;
use super::plane_group::PlaneGroup;
use crate::attachment::{BLOCKS, DepthPlane, WordPlane};
use crate::desc::DepthWrite;
use crate::output::DepthPlan;
use crate::plan::Packing;
use crate::sizes::TILE;
use std::ops::Range;
use texunit::lanes::{F32s, Isa, Kernel, LANES, Simd, U32s};

/// The least number of blocks in the bounds of a triangle for which they are computed together.
pub const MIN_BLOCKS: i32 = 3;

/// Blocks along a side of a tile.
pub const TILE_BLOCKS: usize = TILE as usize / 8;
const _: () = assert!(
    BLOCKS == LANES && TILE_BLOCKS * TILE_BLOCKS == LANES,
    "lanes are the blocks of a tile"
);

/// The coverage and the planes of a large triangle in each block of a tile.
#[derive(Debug)]
pub struct LargeTriangle {
    /// The blocks of which it covers any pixel, bit by block.
    pub touched: u64,
    /// The blocks that it covers so densely that they are shaded as blocks.
    pub dense: u64,
    /// The covered lanes of each touched block.
    pub covered: [u64; BLOCKS],
    planes: Vec<TilePlane>,
}

impl Default for LargeTriangle {
    fn default() -> Self {
        Self { touched: 0, dense: 0, covered: [0; BLOCKS], planes: Vec::new() }
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

/// A plane over the tile.
#[derive(Clone, Debug)]
struct TilePlane {
    /// At the first pixel of each block.
    corners: F32s,
    /// Per pixel across, per pixel up.
    steps: [f32; 2],
}

impl LargeTriangle {
    /// Computes those `rows` of blocks that the triangle's bounds reach of the tile whose first pixel is `tile`,
    /// given its corners and the lane of the group that holds its planes.
    pub fn compute(
        &mut self,
        isa: Isa,
        tile: [i32; 2],
        (corners, rows): (&[[i32; 2]; 3], Range<usize>),
        packing: Packing,
        (group, lane): (&PlaneGroup, usize),
    ) {
        isa.run(ComputeBlocks { tile, corners, rows, packing, group, lane, out: self });
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

    /// Tests the depth of some blocks, bit by block, by the plane `of`; lanes that fail are removed.
    pub fn test(
        &mut self,
        isa: Isa,
        plan: DepthPlan,
        (of, depths): (usize, [f32; 2]),
        stored: &mut WordPlane,
        blocks: u64,
    ) {
        let &TilePlane { ref corners, steps } = &self.planes[of];
        let mut left = blocks;
        let covers_tile = blocks == !0 && self.covered.iter().all(|lanes| *lanes == !0);
        if covers_tile
            && plan.write == DepthWrite::On
            && let Some(word) = stored.fill_word()
        {
            // Blocks that were only cleared store the plane instead of its words.
            let plane = DepthPlane { isa, format: plan.format, corners: *corners, steps, depths };
            if plane.passes_everywhere(plan.test, word) {
                left = !stored.fill_with(plane);
            }
        }
        if left != 0 {
            let (words, lanes) = (stored.blocks_mut(left), &mut self.covered);
            isa.run(TestBlocks { plan, depths, corners, steps, words, blocks: left, lanes });
        }
    }

    /// Writes the steps of the planes, equal in all blocks, to `out`; the first values there are kept.
    pub fn write_steps(&self, out: &mut [[f32; 3]]) {
        for ([_, a, b], plane) in out.iter_mut().zip(&self.planes) {
            [*a, *b] = plane.steps;
        }
    }

    /// The planes of a block.
    #[inline(always)]
    pub fn at(&self, block: usize) -> impl Iterator<Item = [f32; 3]> + Clone {
        let block = block % BLOCKS;
        self.planes.iter().map(move |plane| {
            let [a, b] = plane.steps;
            [plane.corners[block], a, b]
        })
    }

    /// Writes the values of the planes at the first pixel of a block to `out`; the steps there are kept.
    #[inline]
    pub fn write_first_values(&self, block: usize, out: &mut [[f32; 3]]) {
        let block = block % BLOCKS;
        for ([corner, ..], plane) in out.iter_mut().zip(&self.planes) {
            *corner = plane.corners[block];
        }
    }
}

struct ComputeBlocks<'a> {
    tile: [i32; 2],
    corners: &'a [[i32; 2]; 3],
    rows: Range<usize>,
    packing: Packing,
    group: &'a PlaneGroup,
    lane: usize,
    out: &'a mut LargeTriangle,
}

impl Kernel for ComputeBlocks<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { tile, corners, rows, packing, group, lane, out } = self;
        out.cover::<S>(&edges(corners, tile[0], tile[1]), rows.clone(), packing);
        let origin = group.origin(lane);
        // From the planes' origin to the first pixel of each column and row of blocks.
        let along = |axis: usize| {
            let mut along = [0.0; TILE_BLOCKS];
            for (number, along) in along.iter_mut().enumerate() {
                *along = f64::from(tile[axis] + 8 * number as i32) + 0.5 - origin[axis];
            }
            along
        };
        let (dx, dy) = (along(0), along(1));
        const NONE: TilePlane = TilePlane { corners: F32s::ZERO, steps: [0.0; 2] };
        out.planes.resize(group.len(), NONE);
        for ([a, b, c], out) in group.of(lane).zip(&mut out.planes) {
            out.steps = [a as f32, b as f32];
            for row in rows.clone() {
                let up = dy[row] * b;
                for (column, dx) in dx.iter().enumerate() {
                    out.corners[row * TILE_BLOCKS + column] = ((dx * a + up) + c) as f32;
                }
            }
        }
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
    use crate::attachment::DepthFormat;
    use proptest::prelude::*;
    use texunit::sampler::Compare;

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
            let packings = [Packing::Pixels, Packing::Quads];
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

    proptest! {
        /// A tile that is filled by a plane of depths has the words of one that is tested block by block, block by block and
        /// row by row.
        #[test]
        fn a_tile_filled_by_a_plane_has_the_words_of_tested_blocks(
            corner in prop_oneof![-0.5..1.5f32, Just(f32::NAN), Just(f32::INFINITY)],
            steps in prop::array::uniform2(prop_oneof![-0.02..0.02f32, Just(0.0), -1e38..1e38f32]),
            stored in prop_oneof![0.0..=1.0f32, Just(1.0)],
            drawn in prop_oneof![Just(0u64), any::<u64>()],
            format in prop::sample::select(vec![DepthFormat::D16, DepthFormat::D24, DepthFormat::D32F]),
            test in prop::sample::select(vec![
                Compare::Never, Compare::Less, Compare::Equal, Compare::LessEqual,
                Compare::Greater, Compare::NotEqual, Compare::GreaterEqual, Compare::Always,
            ]),
        ) {
            let [a, b] = steps;
            let corners = F32s::from_fn(|block| {
                let [x, y] = [block % TILE_BLOCKS * 8, block / TILE_BLOCKS * 8].map(|at| at as f32);
                (corner + x * a) + y * b
            });
            let plan = DepthPlan { format, test, write: DepthWrite::On };
            let word = format.word(stored);
            for isa in Isa::available() {
                let run = |stored: &mut WordPlane| {
                    let mut triangle = LargeTriangle {
                        touched: !0,
                        dense: !0,
                        covered: [!0; BLOCKS],
                        planes: vec![TilePlane { corners, steps }],
                    };
                    triangle.test(isa, plan, (0, [0.0, 1.0]), stored, !0);
                    triangle.covered
                };
                let mut filled = WordPlane::cleared(word);
                let mut tested = WordPlane::of(vec![U32s::splat(word); BLOCKS]);
                for block in bits(drawn) {
                    let words = U32s::from_fn(|lane| format.word((lane * block % 97) as f32 / 97.0));
                    *filled.block_mut(block) = words;
                    *tested.block_mut(block) = words;
                }
                prop_assert_eq!(run(&mut filled), run(&mut tested));
                for block in 0..BLOCKS {
                    let want = tested.block(block);
                    prop_assert_eq!(filled.block(block), want);
                    prop_assert_eq!(*filled.clone().block_mut(block), want);
                }
            }
        }
    }

    #[test]
    fn a_triangle_before_a_clear_fills_the_tile_without_words() {
        let plan =
            DepthPlan { format: DepthFormat::D24, test: Compare::Less, write: DepthWrite::On };
        let (corners, steps) = (F32s::splat(0.5), [0.001, -0.002]);
        for (cleared, is_filled) in [(1.0, true), (0.5, false)] {
            let mut triangle = LargeTriangle {
                touched: !0,
                dense: !0,
                covered: [!0; BLOCKS],
                planes: vec![TilePlane { corners, steps }],
            };
            let mut stored = WordPlane::cleared(DepthFormat::D24.word(cleared));
            triangle.test(Isa::best(), plan, (0, [0.0, 1.0]), &mut stored, !0);
            assert_eq!(stored.materialized_blocks().is_empty(), is_filled);
        }
    }
}
