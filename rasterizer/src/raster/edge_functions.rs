//! Which pixels a triangle covers: exact integer edge functions, top-left rule.
//!
//! An edge function is `E(p) = dx · (p.y - y0) - dy · (p.x - x0)` in subpixels, never negative
//! inside a counter-clockwise triangle. Between pixel centres it moves in steps of 256 `dx` and
//! 256 `dy`, so `E mod 256` is the same at every centre, and `floor(E / 256)` has the same sign as
//! `E` and moves in steps of `dx` and `dy`: exact in 32 bits wherever an edge crosses a block.

use super::block::BlockAt;
use crate::sizes::SUBPIXEL;
use texunit::lanes::{I32s, Isa, Kernel, LANES, QUADS, Simd, U32s, lane_x, lane_y};

/// An edge function, scaled down by 256, relative to the centre of a tile's first pixel.
#[derive(Clone, Copy, Debug, Default)]
pub struct Edge {
    /// Value at the first pixel.
    pub value: i64,
    /// Step to the next pixel across.
    pub x: i32,
    /// Step to the next pixel up.
    pub y: i32,
}

impl Edge {
    /// The value at the first pixel of block column `bx`, row `by` of the tile.
    #[inline(always)]
    fn first(&self, [bx, by]: [i32; 2]) -> i64 {
        self.value + i64::from(self.x) * i64::from(8 * bx) + i64::from(self.y) * i64::from(8 * by)
    }

    /// The same, and the least and the largest value in the block.
    #[inline(always)]
    pub fn over_block(&self, block: [i32; 2]) -> (i64, [i64; 2]) {
        let first = self.first(block);
        let (dx, dy) = (7 * i64::from(self.x), 7 * i64::from(self.y));
        (first, [first + dx.min(0) + dy.min(0), first + dx.max(0) + dy.max(0)])
    }
}

/// The coverage of a block by a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coverage {
    /// No pixel is covered.
    None,
    /// Every pixel is.
    Full,
    /// These are, bit by lane.
    Partial(u64),
}

impl Coverage {
    /// The lanes that are covered.
    #[inline]
    pub fn lanes(self) -> u64 {
        match self {
            Self::None => 0,
            Self::Full => !0,
            Self::Partial(lanes) => lanes,
        }
    }
}

/// The three edges of a counter-clockwise triangle, seen from a tile whose first pixel is
/// `(x, y)`.
#[inline(always)]
pub fn edges(corners: &[[i32; 2]; 3], x: i32, y: i32) -> [Edge; 3] {
    let mut edges = [Edge::default(); 3];
    for (i, edge) in edges.iter_mut().enumerate() {
        let (a, b) = (corners[i], corners[(i + 1) % 3]);
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let px = i64::from(x) * i64::from(SUBPIXEL) + i64::from(SUBPIXEL / 2) - i64::from(a[0]);
        let py = i64::from(y) * i64::from(SUBPIXEL) + i64::from(SUBPIXEL / 2) - i64::from(a[1]);
        // A centre on a left edge (pointing down) or on a top edge (pointing left) is inside.
        let top_left = dy < 0 || (dy == 0 && dx < 0);
        let e = i64::from(dx) * py - i64::from(dy) * px - i64::from(!top_left);
        *edge = Edge { value: e.div_euclid(i64::from(SUBPIXEL)), x: -dy, y: dx };
    }
    edges
}

/// The coverage of block column `bx`, row `by` of the tile.
#[inline]
pub fn block(isa: Isa, edges: &[Edge; 3], bx: i32, by: i32) -> Coverage {
    let mut crossing = [(0, 0, 0); 3];
    let mut partial = false;
    for (edge, out) in edges.iter().zip(&mut crossing) {
        let (first, [least, most]) = edge.over_block([bx, by]);
        if most < 0 {
            return Coverage::None;
        }
        if least < 0 {
            partial = true;
            // It changes sign within the block, so it is no larger than its steps.
            *out = (first as i32, edge.x, edge.y);
        }
    }
    if !partial {
        return Coverage::Full;
    }
    match isa.run(InsideKernel(crossing)) {
        0 => Coverage::None,
        mask => Coverage::Partial(mask),
    }
}

/// The edge functions of a triangle for many blocks of a tile: their increments from the first lane of a block to each
/// lane, which are those of a moved triangle, too.
pub struct TileEdges {
    rise: [I32s; 3],
}

impl TileEdges {
    /// The increments of the edges of a triangle.
    #[inline(always)]
    pub fn of(edges: &[Edge; 3]) -> Self {
        let mut rise = [I32s::ZERO; 3];
        for (rise, edge) in rise.iter_mut().zip(edges) {
            for lane in 0..LANES {
                rise[lane] = edge.x * COLUMN[lane] + edge.y * ROW[lane];
            }
        }
        Self { rise }
    }

    /// The lanes of a block, given by its column and row, where none of the edges, which have these increments, is negative. No
    /// edge may leave the whole of it out.
    #[inline(always)]
    pub fn lanes<S: Simd>(&self, edges: &[Edge; 3], block: [i32; 2]) -> u64 {
        let mut outside = U32s::ZERO;
        for (edge, rise) in edges.iter().zip(&self.rise) {
            // The edge function changes by less than this within a block, so it is negative nowhere.
            let first = edge.first(block).min(MOST_RISE) as i32;
            for lane in 0..LANES {
                outside[lane] |= first.wrapping_add(rise[lane]) as u32 & 1 << 31;
            }
        }
        !S::nonzero(&outside)
    }
}

/// No edge changes by more within a block: corners lie less than 2²⁴ subpixels apart along each axis.
const MOST_RISE: i64 = 1 << 30;

/// Column of each lane.
const COLUMN: [i32; LANES] = coordinates(0);
/// Row of each lane.
const ROW: [i32; LANES] = coordinates(1);

const fn coordinates(axis: usize) -> [i32; LANES] {
    let mut table = [0; LANES];
    let mut lane = 0;
    while lane < LANES {
        table[lane] = [lane_x(lane), lane_y(lane)][axis] as i32;
        lane += 1;
    }
    table
}

/// The lanes of 8×8 pixels where none of three edge functions is negative, given their values at
/// the first pixel and their steps.
struct InsideKernel([(i32, i32, i32); 3]);

impl Kernel for InsideKernel {
    type Output = u64;
    #[inline(always)]
    fn run<S: Simd>(self) -> u64 {
        let [(e0, x0, y0), (e1, x1, y1), (e2, x2, y2)] = self.0;
        let mut outside = U32s::ZERO;
        for lane in 0..LANES {
            let at = |e: i32, x: i32, y: i32| {
                let across = x.wrapping_mul(COLUMN[lane]);
                e.wrapping_add(across).wrapping_add(y.wrapping_mul(ROW[lane]))
            };
            // The sign bit is set if any of the three has it.
            outside[lane] = (at(e0, x0, y0) | at(e1, x1, y1) | at(e2, x2, y2)) as u32 & 1 << 31;
        }
        !S::nonzero(&outside)
    }
}

/// The lane of column `x`, row `y` of a block.
pub const fn lane_at(x: usize, y: usize) -> usize {
    (y % 2 * 2 + x % 2) * QUADS + y / 2 * 4 + x / 2
}

/// Whether the square of `side` pixels whose first is `(x, y)` lies in `area` (first and one past the
/// last pixel, x then y).
#[inline]
pub fn is_inside_area(area: &[[i32; 2]; 2], x: i32, y: i32, side: i32) -> bool {
    let [[left, low], [right, high]] = *area;
    x >= left && y >= low && x + side <= right && y + side <= high
}

/// The lanes of a block that lie in `area`.
pub fn inside_area(area: &[[i32; 2]; 2], at: BlockAt) -> u64 {
    let [left, low] = at.first();
    if is_inside_area(area, left, low, 8) {
        return !0;
    }
    (0..LANES).fold(0, |mask, lane| {
        let p = [left + lane_x(lane) as i32, low + lane_y(lane) as i32];
        let inside = (0..2).all(|axis| p[axis] >= area[0][axis] && p[axis] < area[1][axis]);
        mask | u64::from(inside) << lane
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The lanes whose centre is inside by exact 128-bit arithmetic.
    fn oracle(corners: &[[i32; 2]; 3], x: i32, y: i32) -> u64 {
        (0..LANES).fold(0, |mask, lane| {
            let px = i128::from(x + lane_x(lane) as i32) * 256 + 128;
            let py = i128::from(y + lane_y(lane) as i32) * 256 + 128;
            let inside = (0..3).all(|i| {
                let (a, b) = (corners[i], corners[(i + 1) % 3]);
                let (dx, dy) = (i128::from(b[0] - a[0]), i128::from(b[1] - a[1]));
                let e = dx * (py - i128::from(a[1])) - dy * (px - i128::from(a[0]));
                e > 0 || (e == 0 && (dy < 0 || (dy == 0 && dx < 0)))
            });
            mask | u64::from(inside) << lane
        })
    }

    #[test]
    fn every_lane_is_at_its_place() {
        for lane in 0..LANES {
            assert_eq!(lane_at(lane_x(lane), lane_y(lane)), lane);
        }
    }

    proptest! {
        #[test]
        fn blocks_are_covered_as_exact_arithmetic_says(
            raw in prop::array::uniform6(prop_oneof![-4000..6000i32, -8_388_608..=8_388_608i32, (-4..8i32).prop_map(|v| v * 128)]),
            bx in 0..8i32, by in 0..8i32,
        ) {
            let mut corners = [[raw[0], raw[1]], [raw[2], raw[3]], [raw[4], raw[5]]];
            let d = |p: [i32; 2], k: usize| i64::from(p[k]) - i64::from(corners[0][k]);
            if d(corners[1], 0) * d(corners[2], 1) < d(corners[2], 0) * d(corners[1], 1) {
                corners.swap(1, 2);
            }
            let edges = edges(&corners, 0, 0);
            let want = oracle(&corners, 8 * bx, 8 * by);
            for isa in Isa::available() {
                prop_assert_eq!(block(isa, &edges, bx, by).lanes(), want, "{}", isa.name());
            }
        }
    }
}
