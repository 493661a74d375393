//! Small triangles: what up to 64 of them cover of a tile, computed together.
//!
//! A triangle is small when all that it may cover of the tile lies in a window of 16×16 pixels that
//! begins at a quad (not at a block). Its edge functions fit 32 bits, no block needs a coverage test,
//! and its pixels are packed directly into the pending batch. A window has four
//! parts of 8×8 pixels, in the order of a block's lanes; the loop visits the quads that the largest triangle of the
//! 64 may reach.

use super::batch::is_dense;
use super::shape_lanes::ShapeLanes;
use crate::plan::Packing;
use crate::sizes::{SUBPIXEL, TILE};
use texunit::lanes::{I32s, Isa, Kernel, LANES, QUADS, Simd, U32s};

/// Subpixels that the corners of a small triangle may lie apart along an axis: the product of two
/// such distances, and the sum of two of these, fit an `i32`.
const MAX_EXTENT: i32 = 1 << 14;

/// Quads along a side of a window.
const WINDOW_QUADS: usize = 8;
/// Pixels along it.
const PIXELS: usize = 2 * WINDOW_QUADS;
/// Blocks along a side that a window can overlap.
pub const WINDOW_BLOCKS: usize = 3;

/// The windows of up to 64 shapes.
#[derive(Debug, Default)]
pub struct Windows {
    /// The first quad of each window in the tile, across and up.
    pub first_quads: [I32s; 2],
    /// The largest number of blocks beyond its first that a window reaches, across and up.
    pub extra_blocks: [usize; 2],
    /// How many parts there are.
    parts: usize,
    /// By part, the pixels inside the edges and the spans as the two words of a mask of lanes.
    inside: [[U32s; 2]; 4],
    /// The shapes that have one, bit by lane.
    small_mask: u64,
}

/// The window of a small triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    /// Its first quad in the tile, across and up.
    pub quad: [usize; 2],
    /// By part, the pixels that are covered.
    pub covered: [u64; 4],
}

impl Window {
    /// Whether it is a few quads of its first part.
    pub fn is_sparse(&self) -> bool {
        let [first, others @ ..] = self.covered;
        others == [0; 3] && !is_dense(Packing::Quads, first)
    }
}

impl Windows {
    /// Finds the small triangles of some shapes, and what they cover of the tile whose first pixel
    /// is `tile`.
    pub fn compute(&mut self, isa: Isa, tile: [i32; 2], shapes: &ShapeLanes) {
        isa.run(CoverWindows { windows: self, tile, shapes });
    }

    /// The pixels inside, of each part, as the two words of a mask of lanes.
    #[inline(always)]
    pub fn inside(&self) -> &[[U32s; 2]] {
        &self.inside[..self.parts.min(4)]
    }

    /// The shapes that have one, bit by lane.
    #[inline(always)]
    pub fn small_mask(&self) -> u64 {
        self.small_mask
    }

    /// The window of the shape in a lane; `None` where it is not small.
    #[inline(always)]
    pub fn get(&self, lane: usize) -> Option<Window> {
        let lane = lane % LANES;
        if self.small_mask >> lane & 1 == 0 {
            return None;
        }
        let mut covered = [0; 4];
        for (covered, [even, odd]) in covered.iter_mut().zip(self.inside()) {
            *covered = u64::from(even[lane]) | u64::from(odd[lane]) << 32;
        }
        let [x, y] = &self.first_quads;
        Some(Window { quad: [x[lane] as usize, y[lane] as usize], covered })
    }
}

/// The coverage of windows: the arithmetic of `edge_functions::edges` in 32 bits, over lanes of shapes.
struct CoverWindows<'a> {
    windows: &'a mut Windows,
    tile: [i32; 2],
    shapes: &'a ShapeLanes,
}

impl Kernel for CoverWindows<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { windows, tile, shapes } = self;
        let Windows { first_quads, extra_blocks, parts, inside, small_mask } = windows;
        let ShapeLanes { corners, bounds, .. } = shapes;
        // Loops read and write these locals, so that the compiler sees that no references overlap.
        //
        // The first and the last column, and row, of its window that a shape may cover.
        let mut spans = [[I32s::ZERO; 2]; 2];
        // The edge functions at the first pixel of a row of quads, and per pixel across and up.
        let mut edges = [[I32s::ZERO; 3]; 3];
        // By part, the pixels outside of any edge.
        let mut outside = [[U32s::ZERO; 2]; 4];
        // Not zero where a triangle is not small.
        let mut large = U32s::ZERO;
        let mut origin = [I32s::ZERO; 2];
        // The last quad of the window that the shape covers, counted from the first.
        let mut last_quad = [U32s::ZERO; 2];
        let mut blocks = [U32s::ZERO; 2];
        for axis in 0..2 {
            for lane in 0..LANES {
                let low = (bounds[0][axis][lane] - tile[axis]).max(0);
                let high = (bounds[1][axis][lane] - tile[axis]).min(TILE as i32 - 1);
                let first = low & !1;
                let (a, b) = (corners[0][axis][lane], corners[1][axis][lane]);
                let c = corners[2][axis][lane];
                let extent = a.max(b).max(c).wrapping_sub(a.min(b).min(c));
                let is_large =
                    (high < low) | (high - first >= PIXELS as i32) | (extent > MAX_EXTENT);
                large[lane] |= u32::from(is_large);
                first_quads[axis][lane] = first >> 1;
                spans[axis][0][lane] = low - first;
                spans[axis][1][lane] = high - first;
                last_quad[axis][lane] = if is_large { 0 } else { (high - first) as u32 >> 1 };
                blocks[axis][lane] = (last_quad[axis][lane] + (first as u32 >> 1) % 4) / 4;
                origin[axis][lane] = (tile[axis] + first) * SUBPIXEL + SUBPIXEL / 2;
            }
        }
        let present = !0 >> (LANES - shapes.len.clamp(1, LANES));
        *small_mask = !S::nonzero(&large) & shapes.triangles & present;
        // Lanes without a small triangle hold arbitrary values: hence the wrapping operations.
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
        let largest = |quads: &U32s| (S::largest(quads) as usize).min(WINDOW_QUADS - 1);
        let (across, up) = (largest(&last_quad[0]), largest(&last_quad[1]));
        *extra_blocks = [S::largest(&blocks[0]) as usize, S::largest(&blocks[1]) as usize];
        *parts = if up < WINDOW_QUADS / 2 { 1 + across / (WINDOW_QUADS / 2) } else { 4 };
        for row in 0..=up {
            let (mut a, mut b, mut c) = (*e0, *e1, *e2);
            for column in 0..=across {
                let [even, odd] = &mut outside[row / 4 * 2 + column / 4];
                let quad = (row % 4 * 4 + column % 4) as u32;
                for lane in 0..LANES {
                    // The sign bit is set where any of them is negative; it is shifted to bit `at`.
                    let negative = |dx: i32, dy: i32, at: u32| {
                        let step = |e: i32, x: i32, y: i32| {
                            e.wrapping_add(x.wrapping_mul(dx)).wrapping_add(y.wrapping_mul(dy))
                        };
                        let any = step(a[lane], x0[lane], y0[lane])
                            | step(b[lane], x1[lane], y1[lane])
                            | step(c[lane], x2[lane], y2[lane]);
                        any as u32 >> (31 - at) & 1 << at
                    };
                    even[lane] |= negative(0, 0, quad) | negative(1, 0, quad + QUADS as u32);
                    odd[lane] |= negative(0, 1, quad) | negative(1, 1, quad + QUADS as u32);
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
        let [[left, right], [low, high]] = &spans;
        for (part, (outside, inside)) in outside.iter().zip(&mut inside[..*parts]).enumerate() {
            let [x, y] = [part % 2, part / 2].map(|part| (part * WINDOW_QUADS) as i32);
            for lane in 0..LANES {
                let columns = columns(left[lane] - x, right[lane] - x);
                let rows = rows(low[lane] - y, high[lane] - y);
                for word in 0..2 {
                    inside[word][lane] = !outside[word][lane] & columns & rows[word];
                }
            }
        }
    }
}

/// The bits from `first` to `last` of eight; both may be out of range.
#[inline(always)]
fn span(first: i32, last: i32) -> u32 {
    let first = first.clamp(0, 8);
    let end = last.clamp(-1, 7) + 1;
    0xFF << first & 0xFF >> (8 - end) & 0xFF
}

/// The lanes of a word of a mask in these columns of a block: those of its quads' left pixels, and those of their
/// right ones.
#[inline(always)]
fn columns(first: i32, last: i32) -> u32 {
    let span = span(first, last);
    // Every other bit: the four columns of quads.
    let quads = |bits: u32| (bits & 1) | (bits >> 1 & 2) | (bits >> 2 & 4) | (bits >> 3 & 8);
    (quads(span) | quads(span >> 1) << QUADS) * 0x1111
}

/// The lanes of both words in these rows: the even rows of quads and the odd ones.
#[inline(always)]
fn rows(first: i32, last: i32) -> [u32; 2] {
    let span = span(first, last);
    // Four lanes a row of quads, in both halves.
    let quads = |bits: u32| {
        let rows = (bits & 1) | (bits << 2 & 0x10) | (bits << 4 & 0x100) | (bits << 6 & 0x1000);
        rows * 0xF_000F
    };
    [quads(span), quads(span >> 1)]
}

#[cfg(test)]
mod tests {
    use super::super::edge_functions::{Coverage, block, edges};
    use super::super::window_blocks::{DivideWindows, WindowBlocks};
    use super::*;
    use crate::desc::Facing;
    use crate::primitive::{Clipping, Shape, ShapeKind};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn windows_hold_what_the_blocks_of_the_tile_hold(
            raw in prop::collection::vec((-600..17_000i32, -600..17_000i32, prop::array::uniform4(prop_oneof![0..2000i32, 0..5000i32])), 1..64),
        ) {
            let tile = [64, 128];
            let shapes: Vec<Shape> = raw.iter().filter_map(|&(x, y, d)| {
                let (x, y) = (x + tile[0] * 256, y + tile[1] * 256);
                let corners = [[x, y], [x + d[0], y + d[1]], [x - d[2], y + d[3]]];
                let d = |k: usize, axis: usize| i64::from(corners[k][axis] - corners[0][axis]);
                let doubled_area = d(1, 0) * d(2, 1) - d(2, 0) * d(1, 1);
                if doubled_area <= 0 { return None; }
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
                    clipping: Clipping::Whole,
                    kind: ShapeKind::Triangle,
                    facing: Facing::Front,
                })
            }).collect();
            for isa in Isa::available() {
                let (mut windows, mut lanes) = (Windows::default(), ShapeLanes::default());
                lanes.load(shapes.iter());
                windows.compute(isa, tile, &lanes);
                let mut window_blocks = WindowBlocks::default();
                isa.run(DivideWindows { windows: &windows, shapes: shapes.len(), window_blocks: &mut window_blocks });
                let mut all = vec![[0; 64]; shapes.len()];
                let mut reader = window_blocks.reader;
                while let Some(window_block) = window_blocks.front(&mut reader) {
                    if window_block.lanes != 0 {
                        all[window_block.shape][window_block.block] |= window_block.lanes;
                    }
                    window_blocks.set_remaining(&mut reader, window_block, 0);
                }
                for (lane, shape) in shapes.iter().enumerate() {
                    let got = all[lane];
                    if windows.get(lane).is_none() {
                        prop_assert_eq!(got, [0; 64]);
                        continue;
                    }
                    let edges = edges(&shape.corners, tile[0], tile[1]);
                    for (at, got) in got.into_iter().enumerate() {
                        let want = match block(isa, &edges, at as i32 % 8, at as i32 / 8) {
                            Coverage::None => 0,
                            Coverage::Full => !0,
                            Coverage::Partial(mask) => mask,
                        };
                        prop_assert_eq!(got, want, "{} in block {}", isa.name(), at);
                    }
                }
            }
        }
    }
}
