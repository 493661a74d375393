//! Texels beyond the edges of a cube's faces, of lanes on different faces.
//!
//! The table says the same as [`crate::sample::cube::across_edge`] computes (a test holds this).

use super::lane_level::LaneLevel;
use crate::image::FACES;
use crate::lanes::{I32s, LANES, U32s};
use crate::sample::cube::EdgeTexels;

/// A coordinate of a texel beyond an edge, on the face that touches the edge.
#[derive(Clone, Copy)]
enum Coordinate {
    /// The index along the edge.
    Along = 0,
    /// The index along the edge, counted from the other end.
    Back = 1,
    /// The first.
    First = 2,
    /// The last.
    Last = 3,
}

/// The face that touches an edge from the other side, and the column and row of its texels there.
type Neighbour = (u32, Coordinate, Coordinate);

/// Beyond the first column, the last column, the first row and the last row of each face.
const NEIGHBOURS: [[Neighbour; 4]; FACES] = {
    use Coordinate::{Along, Back, First, Last};
    [
        [(4, Last, Along), (5, First, Along), (2, Last, Back), (3, Last, Along)],
        [(5, Last, Along), (4, First, Along), (2, First, Along), (3, First, Back)],
        [(1, Along, First), (0, Back, First), (5, Back, First), (4, Along, First)],
        [(1, Back, Last), (0, Along, Last), (4, Along, Last), (5, Back, Last)],
        [(1, Last, Along), (0, First, Along), (2, Along, Last), (3, Along, First)],
        [(0, Last, Along), (1, First, Along), (2, Back, First), (3, Back, Last)],
    ]
};

/// Bits of a neighbour in a code: two for each coordinate, then the face.
const BITS: u32 = 7;

/// The four neighbours of each face as one word.
const CODES: [u32; FACES] = {
    let mut codes = [0; FACES];
    let mut face = 0;
    while face < FACES {
        let mut edge = 0;
        while edge < 4 {
            let (other, x, y) = NEIGHBOURS[face][edge];
            codes[face] |= (other << 4 | (y as u32) << 2 | x as u32) << (BITS * edge as u32);
            edge += 1;
        }
        face += 1;
    }
    codes
};

/// The texels at `(i, j) + step` of each lane's face and level, of which each index is -1 to the size.
#[inline(always)]
pub fn across_edge(level: &LaneLevel<'_>, i: &I32s, j: &I32s, step: [i32; 2]) -> EdgeTexels {
    let mut out =
        EdgeTexels { face: U32s::ZERO, x: U32s::ZERO, y: U32s::ZERO, missing: U32s::ZERO };
    for lane in 0..LANES {
        let last = level.size[0][lane] as i32 - 1;
        let (x, y) = (i[lane] + step[0], j[lane] + step[1]);
        let (before_s, after_s) = (x < 0, x > last);
        let (before_t, after_t) = (y < 0, y > last);
        let (off_s, off_t) = (before_s | after_s, before_t | after_t);
        let on_s = if before_s { 0 } else { BITS };
        let on_t = if before_t { 2 * BITS } else { 3 * BITS };
        let face = level.face[lane];
        let code = code(face) >> (if off_s { on_s } else { on_t });
        let along = inside(if off_s { y } else { x }, last);
        let crosses = off_s | off_t;
        let column = coordinate(code & 3, along, last);
        let row = coordinate(code >> 2 & 3, along, last);
        out.face[lane] = if crosses { code >> 4 & 7 } else { face };
        out.x[lane] = if crosses { column } else { x } as u32;
        out.y[lane] = if crosses { row } else { y } as u32;
        out.missing[lane] = if off_s & off_t { !0 } else { 0 };
    }
    out
}

/// The code of a face. (An index would be a gather.)
#[inline(always)]
fn code(face: u32) -> u32 {
    let x = if face == 0 { CODES[0] } else { CODES[1] };
    let y = if face == 2 { CODES[2] } else { CODES[3] };
    let z = if face == 4 { CODES[4] } else { CODES[5] };
    let yz = if face < 4 { y } else { z };
    if face < 2 { x } else { yz }
}

/// The coordinate of this number.
#[inline(always)]
fn coordinate(which: u32, along: i32, last: i32) -> i32 {
    let from_start = if which & 2 == 0 { along } else { 0 };
    if which & 1 == 0 { from_start } else { last - from_start }
}

#[inline(always)]
fn inside(index: i32, last: i32) -> i32 {
    let low = if index < 0 { 0 } else { index };
    if low > last { last } else { low }
}
