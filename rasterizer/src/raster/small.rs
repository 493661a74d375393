//! Small triangles: what up to 64 of them cover of a tile, computed together.
//!
//! A triangle is small when all that it may cover of the tile lies in a window of 8×8 pixels that
//! begins at a quad (not at a block). Its edge functions then fit 32 bits from the start, nothing
//! has to be asked of blocks, and its quads go straight into the batch that waits.

use super::coverage::{inside, lane_at};
use crate::primitive::{Kind, SUBPIXEL, Shape};
use crate::target::TILE;
use texunit::lanes::{Isa, Kernel, LANES, Simd};

/// Subpixels that the corners of a small triangle may lie apart along an axis: the product of two
/// such distances, and the sum of two of these, fit an `i32`.
const REACH: i32 = 1 << 14;

/// Lanes of the pixels from a window's column (axis 0) or row (axis 1) 0 or 1 to another.
const fn spans(axis: usize) -> [[u64; 8]; 2] {
    let mut table = [[0; 8]; 2];
    let mut first = 0;
    while first < 2 {
        let mut last = first;
        while last < 8 {
            let mut at = 0;
            while at < 64 {
                let pixel = [at % 8, at / 8];
                if pixel[axis] >= first && pixel[axis] <= last {
                    table[first][last] |= 1 << lane_at(pixel[0], pixel[1]);
                }
                at += 1;
            }
            last += 1;
        }
        first += 1;
    }
    table
}

const COLUMNS: [[u64; 8]; 2] = spans(0);
const ROWS: [[u64; 8]; 2] = spans(1);

type I32Lanes = [i32; LANES];

/// The windows of up to 64 shapes.
#[derive(Debug)]
pub struct Windows {
    corners: [[I32Lanes; 2]; 3],
    /// The centre of the window's first pixel, in subpixels.
    origin: [I32Lanes; 2],
    /// The first quad of the window in the tile, across and up.
    quad: [[u8; 2]; LANES],
    /// The pixels of the window within the shape's bounds and the tile; none of what is not small.
    bounds: [u64; LANES],
    /// The pixels that are covered.
    covered: [u64; LANES],
}

impl Default for Windows {
    fn default() -> Self {
        Self {
            corners: [[[0; LANES]; 2]; 3],
            origin: [[0; LANES]; 2],
            quad: [[0; 2]; LANES],
            bounds: [0; LANES],
            covered: [0; LANES],
        }
    }
}

/// The window of a small triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    /// Its first quad in the tile, across and up.
    pub quad: [usize; 2],
    /// Its pixels that are covered, in the order of a block's lanes.
    pub covered: u64,
}

impl Windows {
    /// Finds the small triangles of `shapes`, at most 64, and what they cover of the tile whose
    /// first pixel is `tile`.
    pub fn compute<'a>(
        &mut self,
        isa: Isa,
        tile: [i32; 2],
        shapes: impl ExactSizeIterator<Item = &'a Shape>,
    ) {
        let len = shapes.len().min(LANES);
        for (lane, shape) in shapes.enumerate().take(LANES) {
            self.bounds[lane] = match shape.kind {
                Kind::Triangle => self.place(lane, shape, tile),
                Kind::Line { .. } | Kind::Point { .. } => 0,
            };
        }
        isa.run(Cover { windows: self, len });
    }

    /// The window of the shape in a lane; `None` where it is not small.
    #[inline]
    pub fn get(&self, lane: usize) -> Option<Window> {
        let lane = lane % LANES;
        let covered = self.covered[lane];
        (self.bounds[lane] != 0).then(|| Window { quad: self.quad[lane].map(usize::from), covered })
    }

    /// Puts a triangle into a lane; gives the pixels of its window that it may cover.
    #[inline]
    fn place(&mut self, lane: usize, shape: &Shape, tile: [i32; 2]) -> u64 {
        let mut spans = [0; 2];
        for (axis, table) in [COLUMNS, ROWS].iter().enumerate() {
            let low = (i32::from(shape.bounds[0][axis]) - tile[axis]).max(0);
            let high = (i32::from(shape.bounds[1][axis]) - tile[axis]).min(TILE as i32 - 1);
            let first = low & !1;
            if high < low || high - first > 7 {
                return 0;
            }
            spans[axis] = table[(low - first) as usize][(high - first) as usize];
            self.quad[lane][axis] = (first / 2) as u8;
            self.origin[axis][lane] = (tile[axis] + first) * SUBPIXEL + SUBPIXEL / 2;
            let corners = shape.corners.map(|corner| corner[axis]);
            let [a, b, c] = corners;
            if a.max(b).max(c) - a.min(b).min(c) > REACH {
                return 0;
            }
            for (to, from) in self.corners.iter_mut().zip(corners) {
                to[axis][lane] = from;
            }
        }
        spans[0] & spans[1]
    }
}

/// The coverage of the first `len` windows: the arithmetic of `coverage::edges` in 32 bits.
struct Cover<'a> {
    windows: &'a mut Windows,
    len: usize,
}

impl Kernel for Cover<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { windows: Windows { corners, origin, bounds, covered, .. }, len } = self;
        // Lanes without a small triangle hold anything: hence the wrapping operations.
        let mut edges = [[[0; LANES]; 3]; 3];
        for (i, [value, x, y]) in edges.iter_mut().enumerate() {
            let (a, b) = (&corners[i], &corners[(i + 1) % 3]);
            for lane in 0..LANES {
                let dx = b[0][lane].wrapping_sub(a[0][lane]);
                let dy = b[1][lane].wrapping_sub(a[1][lane]);
                let px = origin[0][lane].wrapping_sub(a[0][lane]);
                let py = origin[1][lane].wrapping_sub(a[1][lane]);
                let top_left = (dy < 0) | ((dy == 0) & (dx < 0));
                let e = dx.wrapping_mul(py).wrapping_sub(dy.wrapping_mul(px));
                value[lane] = e.wrapping_sub(i32::from(!top_left)) >> SUBPIXEL.trailing_zeros();
                x[lane] = dy.wrapping_neg();
                y[lane] = dx;
            }
        }
        for lane in 0..len {
            let [a, b, c] = &edges;
            let of_lane = [
                (a[0][lane], a[1][lane], a[2][lane]),
                (b[0][lane], b[1][lane], b[2][lane]),
                (c[0][lane], c[1][lane], c[2][lane]),
            ];
            covered[lane] = bounds[lane] & inside::<S>(of_lane);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::coverage::{Coverage, block, edges};
    use super::*;
    use crate::primitive::Facing;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn windows_hold_what_the_blocks_of_the_tile_hold(
            raw in prop::collection::vec((-600..17_000i32, -600..17_000i32, prop::array::uniform4(0..2000i32)), 1..64),
        ) {
            let tile = [64, 128];
            let shapes: Vec<Shape> = raw.iter().filter_map(|&(x, y, d)| {
                let (x, y) = (x + tile[0] * 256, y + tile[1] * 256);
                let corners = [[x, y], [x + d[0], y + d[1]], [x - d[2], y + d[3]]];
                let d = |k: usize, axis: usize| i64::from(corners[k][axis] - corners[0][axis]);
                let turn = d(1, 0) * d(2, 1) - d(2, 0) * d(1, 1);
                if turn <= 0 { return None; }
                let edge = |last: bool, axis: usize| {
                    let all = corners.map(|c| (c[axis] - 128).div_euclid(256));
                    let value = if last { all.iter().max() } else { all.iter().min() };
                    *value.unwrap() as u16
                };
                Some(Shape {
                    corners,
                    bounds: [[edge(false, 0), edge(false, 1)], [edge(true, 0), edge(true, 1)]],
                    vertices: [0; 3],
                    provoking: 0,
                    kind: Kind::Triangle,
                    facing: Facing::Front,
                })
            }).collect();
            for isa in Isa::available() {
                let mut windows = Windows::default();
                windows.compute(isa, tile, shapes.iter());
                for (lane, shape) in shapes.iter().enumerate() {
                    let Some(window) = windows.get(lane) else { continue };
                    let edges = edges(&shape.corners, tile[0], tile[1]);
                    for at in 0..4096 {
                        let (x, y) = (at % 64, at / 64);
                        let want = match block(isa, &edges, (x / 8) as i32, (y / 8) as i32) {
                            Coverage::None => false,
                            Coverage::Full => true,
                            Coverage::Partial(mask) => mask >> lane_at(x % 8, y % 8) & 1 == 1,
                        };
                        let within = |v: usize, axis: usize| v.checked_sub(2 * window.quad[axis]).filter(|v| *v < 8);
                        let got = match (within(x, 0), within(y, 1)) {
                            (Some(x), Some(y)) => window.covered >> lane_at(x, y) & 1 == 1,
                            _ => false,
                        };
                        prop_assert_eq!(got, want, "{} at {} {}", isa.name(), x, y);
                    }
                }
            }
        }
    }
}
