//! The planes of a triangle over a tile, computed with one lane per block, and the depth test of many of its blocks. The
//! numbers are those of [`PlaneGroup::at`].

use super::fragment_depth::TestBlocks;
use super::large_triangles::{TILE_BLOCKS, bits};
use super::plane_group::PlaneGroup;
use crate::attachment::{BLOCKS, DepthPlanes, WordPlane};
use crate::desc::DepthWrite;
use crate::output::DepthPlan;
use crate::plan::moved;
use std::ops::Range;
use texunit::lanes::{F32s, Isa, Kernel, LANES, Simd};

/// The planes of a triangle over a tile.
#[derive(Debug, Default)]
pub struct TilePlanes {
    planes: Vec<TilePlane>,
}

/// A plane over the tile.
#[derive(Clone, Debug)]
pub struct TilePlane {
    /// At the first pixel of each block.
    pub corners: F32s,
    /// Per pixel across, per pixel up.
    pub steps: [f32; 2],
}

/// When blocks that are covered whole store the plane of their depths in place of words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneStorage {
    /// Always: of a draw of depths alone, a shadow map, few texels are read again.
    Block,
    /// Where all blocks of the tile are covered whole: to a target with colours others are soon drawn in part, for which a
    /// block needs words.
    Tile,
}

impl TilePlane {
    /// Tests the depth of some blocks, bit by block, by this plane of depth; lanes that fail are removed from `covered`.
    pub fn test(
        &self,
        isa: Isa,
        plan: DepthPlan,
        (storage, depths): (PlaneStorage, [f32; 2]),
        stored: &mut WordPlane,
        blocks: u64,
        covered: &mut [u64; BLOCKS],
    ) {
        let &Self { ref corners, steps } = self;
        let mut left = blocks;
        let stores_planes = match storage {
            PlaneStorage::Block => stored.without_words() & blocks != 0,
            PlaneStorage::Tile => {
                let covers_tile = blocks == !0 && covered.iter().all(|lanes| *lanes == !0);
                covers_tile && stored.without_words() != 0
            }
        };
        if stores_planes {
            let planes = [*corners, F32s::splat(steps[0]), F32s::splat(steps[1])];
            let new = DepthPlanes { isa, format: plan.format, depths, planes };
            // Blocks that are covered whole store the plane in place of its words.
            let whole = |set: u64, block: usize| set | u64::from(covered[block] == !0) << block;
            let (replaced, is_done) = match plan.write {
                DepthWrite::On => {
                    let whole = bits(blocks).fold(0, whole);
                    (whole, whole)
                }
                DepthWrite::Off => (0, !0),
            };
            let outcomes = stored.test_blocks(plan.test, &new, blocks, replaced);
            bits(outcomes.fail).for_each(|block| covered[block] = 0);
            left &= !outcomes.fail & !(outcomes.pass & is_done);
        }
        if left != 0 {
            let (words, lanes) = (stored.blocks_mut(left), covered);
            isa.run(TestBlocks { plan, depths, corners, steps, words, blocks: left, lanes });
        }
    }

    /// The plane at a sample, which lies at `offset` from the pixel's centre.
    #[must_use]
    pub fn at_sample(&self, offset: Option<[f32; 2]>) -> Self {
        let &Self { ref corners, steps: [a, b] } = self;
        let corners = F32s::from_fn(|block| moved([corners[block], a, b], offset)[0]);
        Self { corners, steps: [a, b] }
    }
}

impl TilePlanes {
    /// A plane.
    pub fn plane(&self, index: usize) -> &TilePlane {
        &self.planes[index]
    }

    /// Computes the planes of the shape in a lane of the group, in these `rows` of blocks of the tile whose first pixel is
    /// `tile`.
    pub fn compute(
        &mut self,
        isa: Isa,
        tile: [i32; 2],
        rows: Range<usize>,
        (group, lane): (&PlaneGroup, usize),
    ) {
        isa.run(ComputePlanes { tile, rows, group, lane, out: self });
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

/// [`TilePlanes::compute`].
pub struct ComputePlanes<'a> {
    /// The first pixel of the tile.
    pub tile: [i32; 2],
    /// The rows of blocks that are computed.
    pub rows: Range<usize>,
    /// The planes of a group of shapes.
    pub group: &'a PlaneGroup,
    /// Which of these shapes.
    pub lane: usize,
    /// Receives the planes.
    pub out: &'a mut TilePlanes,
}

impl Kernel for ComputePlanes<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { tile, rows, group, lane, out } = self;
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

const _: () = assert!(BLOCKS == LANES, "lanes are the blocks of a tile");

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attachment::DepthFormat;
    use proptest::prelude::*;
    use texunit::lanes::U32s;
    use texunit::sampler::Compare;

    /// A triangle over a tile.
    #[derive(Clone, Debug)]
    struct Drawn {
        plane: TilePlane,
        blocks: u64,
        /// The blocks that are covered whole, of the others some lanes.
        whole: u64,
        test: Compare,
        write: DepthWrite,
    }

    fn drawn() -> impl Strategy<Value = Drawn> {
        let corner = prop_oneof![4 => -0.5..1.5f32, 1 => Just(f32::NAN), 1 => Just(f32::INFINITY)];
        let step = prop_oneof![4 => -0.02..0.02f32, 2 => Just(0.0), 1 => -1e38..1e38f32];
        let set = prop_oneof![Just(!0u64), any::<u64>()];
        let test = prop::sample::select(vec![
            Compare::Never,
            Compare::Less,
            Compare::Equal,
            Compare::LessEqual,
            Compare::Greater,
            Compare::NotEqual,
            Compare::GreaterEqual,
            Compare::Always,
        ]);
        let write = prop::sample::select(vec![DepthWrite::On, DepthWrite::Off]);
        let of = (corner, prop::array::uniform2(step), prop::array::uniform2(set), test, write);
        of.prop_map(|(corner, [a, b], [blocks, whole], test, write)| {
            let corners = F32s::from_fn(|block| {
                let [x, y] = [block % TILE_BLOCKS * 8, block / TILE_BLOCKS * 8].map(|at| at as f32);
                (corner + x * a) + y * b
            });
            Drawn { plane: TilePlane { corners, steps: [a, b] }, blocks, whole, test, write }
        })
    }

    proptest! {
        /// A tile that stores planes of depths has the words of one that is tested block by block, block by block and row by
        /// row.
        #[test]
        fn a_tile_of_planes_has_the_words_of_tested_blocks(
            triangles in prop::collection::vec(drawn(), 1..5),
            again in any::<bool>(),
            stored in prop_oneof![0.0..=1.0f32, Just(1.0)],
            words in prop_oneof![Just(0u64), any::<u64>()],
            format in prop::sample::select(vec![DepthFormat::D16, DepthFormat::D24, DepthFormat::D32F]),
            storage in prop::sample::select(vec![PlaneStorage::Block, PlaneStorage::Tile]),
        ) {
            let mut triangles = triangles;
            if again {
                // A second pass over the same triangle.
                triangles.insert(1, triangles[0].clone());
            }
            let word = format.word(stored);
            for isa in Isa::available() {
                let mut planes = WordPlane::cleared(word);
                let mut tested = WordPlane::of(vec![U32s::splat(word); BLOCKS]);
                for block in bits(words) {
                    let words = U32s::from_fn(|lane| format.word((lane * block % 97) as f32 / 97.0));
                    *planes.block_mut(block) = words;
                    *tested.block_mut(block) = words;
                }
                for Drawn { plane, blocks, whole, test, write } in &triangles {
                    let plan = DepthPlan { format, test: *test, write: *write };
                    let of_block = |block| if whole >> block & 1 == 1 { !0 } else { whole.rotate_left(block as u32) };
                    let run = |stored: &mut WordPlane| {
                        let mut covered: [u64; BLOCKS] = std::array::from_fn(of_block);
                        plane.test(isa, plan, (storage, [0.0, 1.0]), stored, *blocks, &mut covered);
                        covered
                    };
                    prop_assert_eq!(run(&mut planes), run(&mut tested));
                    for block in 0..BLOCKS {
                        let want = tested.block(block);
                        prop_assert_eq!(planes.block(block), want);
                        prop_assert_eq!(*planes.clone().block_mut(block), want);
                    }
                }
            }
        }
    }

    #[test]
    fn a_block_that_is_covered_whole_stores_a_plane_and_rejects_what_is_behind() {
        let plan =
            DepthPlan { format: DepthFormat::D24, test: Compare::Less, write: DepthWrite::On };
        let plane = |depth| TilePlane { corners: F32s::splat(depth), steps: [0.001, -0.002] };
        let by = (PlaneStorage::Block, [0.0, 1.0]);
        let mut stored = WordPlane::cleared(DepthFormat::D24.word(1.0));
        let run = |depth: f32, lanes: u64, stored: &mut WordPlane| {
            let mut covered = [lanes; BLOCKS];
            plane(depth).test(Isa::best(), plan, by, stored, 0b110, &mut covered);
            covered
        };
        assert_eq!(run(0.5, !0, &mut stored)[1], !0);
        assert_eq!(run(0.7, 0xFFFF, &mut stored)[1], 0);
        assert_eq!(run(0.3, !0, &mut stored)[1], !0);
        assert_eq!(stored.without_words(), !0);
        assert_eq!(run(0.1, 0xFFFF, &mut stored)[1], 0xFFFF);
        assert_eq!(stored.without_words(), !0b110);
    }

    #[test]
    fn a_triangle_before_a_clear_fills_the_tile_without_words() {
        let plan =
            DepthPlan { format: DepthFormat::D24, test: Compare::Less, write: DepthWrite::On };
        let (corners, steps) = (F32s::splat(0.5), [0.001, -0.002]);
        for (cleared, is_filled) in [(1.0, true), (0.5, false)] {
            let plane = TilePlane { corners, steps };
            let mut stored = WordPlane::cleared(DepthFormat::D24.word(cleared));
            plane.test(
                Isa::best(),
                plan,
                (PlaneStorage::Tile, [0.0, 1.0]),
                &mut stored,
                !0,
                &mut [!0; BLOCKS],
            );
            assert_eq!(stored.materialized_blocks().is_empty(), is_filled);
        }
    }
}
