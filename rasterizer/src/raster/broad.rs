//! A triangle that covers many blocks of a tile: which they are, and its planes there, computed over lanes
//! that are blocks. The numbers are those of [`super::coverage::block`] and [`PlaneGroup::at`].

use super::coverage::Edge;
use super::group::PlaneGroup;
use crate::target::{BLOCKS, TILE};
use texunit::lanes::{F32s, Isa, Kernel, LANES, Simd, U32s};

/// Blocks that a triangle may cover from which on they are looked at together.
pub const WORTH_IT: i32 = 6;

/// Blocks along a side of a tile.
const SIDE: usize = TILE as usize / 8;
const _: () = assert!(BLOCKS == LANES && SIDE * SIDE == LANES, "lanes are the blocks of a tile");

/// The blocks of a tile as a triangle sees them.
#[derive(Debug, Default)]
pub struct Broad {
    /// Those that it may cover, bit by block.
    pub touched: u64,
    /// Those that it covers whole.
    pub full: u64,
    planes: Vec<Over>,
}

/// A plane over the tile.
#[derive(Clone, Debug)]
struct Over {
    /// At the first pixel of each block.
    corners: F32s,
    /// Per pixel across, per pixel up.
    steps: [f32; 2],
}

impl Broad {
    /// Looks at the tile whose first pixel is `tile`, given the triangle's edges from there and the
    /// lane of the group that holds its planes.
    pub fn compute(
        &mut self,
        isa: Isa,
        tile: [i32; 2],
        edges: &[Edge; 3],
        group: &PlaneGroup,
        lane: usize,
    ) {
        isa.run(Blocks { tile, edges, group, lane, out: self });
    }

    /// The planes' steps, which are those of every block; their values are left alone.
    pub fn steps(&self, out: &mut [[f32; 3]]) {
        for ([_, a, b], plane) in out.iter_mut().zip(&self.planes) {
            [*a, *b] = plane.steps;
        }
    }

    /// The planes of a block.
    #[inline]
    pub fn at(&self, block: usize) -> impl Iterator<Item = [f32; 3]> {
        let block = block % BLOCKS;
        self.planes.iter().map(move |plane| {
            let [a, b] = plane.steps;
            [plane.corners[block], a, b]
        })
    }

    /// The planes' values at the first pixel of a block; their steps are left alone.
    #[inline]
    pub fn corners(&self, block: usize, out: &mut [[f32; 3]]) {
        let block = block % BLOCKS;
        for ([corner, ..], plane) in out.iter_mut().zip(&self.planes) {
            *corner = plane.corners[block];
        }
    }
}

struct Blocks<'a> {
    tile: [i32; 2],
    edges: &'a [Edge; 3],
    group: &'a PlaneGroup,
    lane: usize,
    out: &'a mut Broad,
}

impl Kernel for Blocks<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { tile, edges, group, lane, out } = self;
        [out.touched, out.full] = cover::<S>(edges);
        let origin = group.origin(lane);
        // From the planes' origin to the first pixel of each column and row of blocks.
        let along = |axis: usize| {
            let mut along = [0.0; SIDE];
            for (number, along) in along.iter_mut().enumerate() {
                *along = f64::from(tile[axis] + 8 * number as i32) + 0.5 - origin[axis];
            }
            along
        };
        let (dx, dy) = (along(0), along(1));
        out.planes.clear();
        for [a, b, c] in group.of(lane) {
            let mut corners = F32s::ZERO;
            for (row, dy) in corners.0.chunks_exact_mut(SIDE).zip(dy) {
                let up = dy * b;
                for (corner, dx) in row.iter_mut().zip(dx) {
                    *corner = ((dx * a + up) + c) as f32;
                }
            }
            out.planes.push(Over { corners, steps: [a as f32, b as f32] });
        }
    }
}

/// The blocks that no edge leaves out, and those that all edges hold whole.
#[inline(always)]
fn cover<S: Simd>(edges: &[Edge; 3]) -> [u64; 2] {
    let (mut outside, mut crossed) = (U32s::ZERO, U32s::ZERO);
    for edge in edges {
        let (x, y) = (i64::from(edge.x), i64::from(edge.y));
        let most = 7 * (x.max(0) + y.max(0));
        let least = 7 * (x.min(0) + y.min(0));
        let mut across = [0; SIDE];
        for (number, across) in across.iter_mut().enumerate() {
            *across = edge.value + 8 * x * number as i64;
        }
        for row in 0..SIDE {
            let up = 8 * y * row as i64;
            for column in 0..SIDE {
                let first = across[column] + up;
                // The sign is in the upper word.
                outside[row * SIDE + column] |= ((first + most) >> 32) as u32 & 1 << 31;
                crossed[row * SIDE + column] |= ((first + least) >> 32) as u32 & 1 << 31;
            }
        }
    }
    [!S::nonzero(&outside), !S::nonzero(&crossed)]
}

#[cfg(test)]
mod tests {
    use super::super::coverage::{Coverage, block, edges};
    use super::*;
    use proptest::prelude::*;

    struct CoverOf<'a>(&'a [Edge; 3]);

    impl Kernel for CoverOf<'_> {
        type Output = [u64; 2];
        #[inline(always)]
        fn run<S: Simd>(self) -> [u64; 2] {
            cover::<S>(self.0)
        }
    }

    proptest! {
        #[test]
        fn blocks_are_touched_and_full_as_each_by_itself_is(
            corners in prop::array::uniform3(prop::array::uniform2(
                prop_oneof![-8_000..24_000i32, -8_388_608..=8_388_608i32])),
        ) {
            let edges = edges(&corners, 0, 0);
            for isa in Isa::available() {
                let [touched, full] = isa.run(CoverOf(&edges));
                for at in 0..LANES {
                    let want = block(isa, &edges, at as i32 % 8, at as i32 / 8);
                    let is_full = full >> at & 1 == 1;
                    prop_assert_eq!(is_full, want == Coverage::Full, "{} block {}", isa.name(), at);
                    let is_touched = touched >> at & 1 == 1;
                    prop_assert!(is_touched || want == Coverage::None, "{} block {}", isa.name(), at);
                }
            }
        }
    }
}
