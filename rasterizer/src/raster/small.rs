//! Small triangles: what up to 64 of them cover of a tile, computed together.
//!
//! A triangle is small when all that it may cover of the tile lies in a window of 8×8 pixels that
//! begins at a quad (not at a block). Its edge functions then fit 32 bits from the start, nothing
//! has to be asked of blocks, and its quads go straight into the batch that waits.

use super::coverage::lane_at;
use super::lanes::ShapeLanes;
use crate::primitive::SUBPIXEL;
use crate::target::TILE;
use texunit::lanes::{I32s, Isa, Kernel, LANES, QUADS, Simd, U32s};

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

/// The windows of up to 64 shapes.
#[derive(Debug, Default)]
pub struct Windows {
    /// The first quad of each window in the tile, across and up.
    pub quads: [I32s; 2],
    /// The first and the last column, and row, of it that the shape may cover.
    spans: [[I32s; 2]; 2],
    /// The pixels inside the edges, as words of a block's mask of lanes.
    inside: [U32s; 2],
    /// The shapes that have one, bit by lane.
    small: u64,
}

/// The window of a small triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    /// Its first quad in the tile, across and up.
    pub quad: [usize; 2],
    /// Its pixels that are covered, in the order of a block's lanes.
    pub covered: u64,
}

/// Of windows that begin at column `q % 4`, row `q / 4` of a block's quads: the lanes in their first
/// block, the one on its right, and those above.
const PARTS: [[u64; 4]; 16] = {
    let mut table = [[0; 4]; 16];
    let mut at = 0;
    while at < 16 * LANES {
        let (first, lane) = (at / LANES, at % LANES);
        let quad = lane % QUADS;
        let right = (first % 4 + quad % 4) / 4;
        let above = (first / 4 + quad / 4) / 4;
        table[first][above * 2 + right] |= 1 << lane;
        at += 1;
    }
    table
};

impl Window {
    /// The blocks of the tile that it covers lanes of: which of the four it may reach into (bit 0 is
    /// set on the right, bit 1 above), which of the tile, and the lanes.
    #[inline]
    pub fn blocks(self) -> impl Iterator<Item = (usize, usize, u64)> {
        let [x, y] = self.quad;
        let first = y % 4 * 4 + x % 4;
        (0..4).filter_map(move |part| {
            let lanes = self.covered & PARTS[first][part];
            if lanes == 0 {
                return None;
            }
            let (right, above) = (part % 2, part / 2);
            // By so many quads within each of the four words of a mask; none leaves its word.
            let by = first as u32 + 64 - (4 * right + 16 * above) as u32;
            let block = (y / 4 + above) * 8 + x / 4 + right;
            Some((part, block, lanes.rotate_left(by % 64)))
        })
    }
}

impl Windows {
    /// Finds the small triangles of some shapes, and what they cover of the tile whose first pixel
    /// is `tile`.
    pub fn compute(&mut self, isa: Isa, tile: [i32; 2], shapes: &ShapeLanes) {
        isa.run(Cover { windows: self, tile, shapes });
    }

    /// The window of the shape in a lane; `None` where it is not small.
    #[inline]
    pub fn get(&self, lane: usize) -> Option<Window> {
        let lane = lane % LANES;
        if self.small >> lane & 1 == 0 {
            return None;
        }
        let [[left, right], [low, high]] = &self.spans;
        let columns = COLUMNS[left[lane] as usize % 2][right[lane] as usize % 8];
        let rows = ROWS[low[lane] as usize % 2][high[lane] as usize % 8];
        let [even, odd] = &self.inside;
        let inside = u64::from(even[lane]) | u64::from(odd[lane]) << 32;
        let [x, y] = &self.quads;
        let quad = [x[lane] as usize, y[lane] as usize];
        Some(Window { quad, covered: inside & columns & rows })
    }
}

/// The coverage of windows: the arithmetic of `coverage::edges` in 32 bits, over lanes of shapes.
struct Cover<'a> {
    windows: &'a mut Windows,
    tile: [i32; 2],
    shapes: &'a ShapeLanes,
}

/// Quads along a side of a window.
const SIDE: i32 = 4;

impl Kernel for Cover<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { windows: Windows { quads, spans, inside, small }, tile, shapes } = self;
        let ShapeLanes { corners, bounds, .. } = shapes;
        // Not zero where a triangle is not small.
        let mut large = U32s::ZERO;
        let mut origin = [I32s::ZERO; 2];
        // How many quads of the window the shape reaches, less one.
        let mut reach = [U32s::ZERO; 2];
        for axis in 0..2 {
            for lane in 0..LANES {
                let low = most(bounds[0][axis][lane] - tile[axis], 0);
                let high = least(bounds[1][axis][lane] - tile[axis], TILE as i32 - 1);
                let first = low & !1;
                let [a, b, c] = [0, 1, 2].map(|k| corners[k][axis][lane]);
                let extent = most(most(a, b), c).wrapping_sub(least(least(a, b), c));
                let is_large = (high < low) | (high - first >= 2 * SIDE) | (extent > REACH);
                large[lane] |= u32::from(is_large);
                quads[axis][lane] = first >> 1;
                spans[axis][0][lane] = low - first;
                spans[axis][1][lane] = high - first;
                reach[axis][lane] = if is_large { 0 } else { (high - first) as u32 >> 1 };
                origin[axis][lane] = (tile[axis] + first) * SUBPIXEL + SUBPIXEL / 2;
            }
        }
        let there = !0 >> (LANES - shapes.len.clamp(1, LANES));
        *small = !S::nonzero(&large) & shapes.triangles & there;
        // Lanes without a small triangle hold anything: hence the wrapping operations.
        let mut edges = [[I32s::ZERO; 3]; 3];
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
        let [[e0, x0, y0], [e1, x1, y1], [e2, x2, y2]] = &mut edges;
        let [even, odd] = inside;
        (*even, *odd) = (U32s::ZERO, U32s::ZERO);
        let [across, up] = [0, 1].map(|axis| S::largest(&reach[axis]).min(SIDE as u32 - 1));
        for row in 0..=up {
            let (mut a, mut b, mut c) = (*e0, *e1, *e2);
            for column in 0..=across {
                let quad = row * SIDE as u32 + column;
                for lane in 0..LANES {
                    // The sign bit is set where any of the three is negative.
                    let at = |dx: i32, dy: i32| {
                        let step = |e: i32, x: i32, y: i32| {
                            e.wrapping_add(x.wrapping_mul(dx)).wrapping_add(y.wrapping_mul(dy))
                        };
                        !(step(a[lane], x0[lane], y0[lane])
                            | step(b[lane], x1[lane], y1[lane])
                            | step(c[lane], x2[lane], y2[lane])) as u32
                            >> 31
                    };
                    even[lane] |= (at(0, 0) | at(1, 0) << QUADS) << quad;
                    odd[lane] |= (at(0, 1) | at(1, 1) << QUADS) << quad;
                }
                for lane in 0..LANES {
                    a[lane] = a[lane].wrapping_add(x0[lane].wrapping_mul(2));
                    b[lane] = b[lane].wrapping_add(x1[lane].wrapping_mul(2));
                    c[lane] = c[lane].wrapping_add(x2[lane].wrapping_mul(2));
                }
            }
            for lane in 0..LANES {
                e0[lane] = e0[lane].wrapping_add(y0[lane].wrapping_mul(2));
                e1[lane] = e1[lane].wrapping_add(y1[lane].wrapping_mul(2));
                e2[lane] = e2[lane].wrapping_add(y2[lane].wrapping_mul(2));
            }
        }
    }
}

#[inline(always)]
fn least(a: i32, b: i32) -> i32 {
    if a < b { a } else { b }
}

#[inline(always)]
fn most(a: i32, b: i32) -> i32 {
    if a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::super::coverage::{Coverage, block, edges};
    use super::*;
    use crate::primitive::{Facing, Kind, Part, Shape};
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
                    part: Part::Whole,
                    kind: Kind::Triangle,
                    facing: Facing::Front,
                })
            }).collect();
            for isa in Isa::available() {
                let (mut windows, mut lanes) = (Windows::default(), ShapeLanes::default());
                lanes.load(shapes.iter());
                windows.compute(isa, tile, &lanes);
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
