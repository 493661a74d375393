//! Which pixels a triangle covers, in exact integers (section 3.5.1).
//!
//! The specification asks for pixel centres inside the polygon, and that of two polygons which
//! share an edge exactly one gets a centre on it. The rule that decides is DetGL's own: left and
//! top edges own their pixels, as seen in the window with y up.

use crate::mutation::{Mutation, Variant};

/// Units in a pixel. Vertices on this grid are exact in every rasterizer with at least 4 bits of
/// subpixel precision, so that rounding of positions does not enter.
pub const UNITS: i64 = 16;

/// Window coordinates in units.
pub type Point = [i64; 2];

/// Whether the triangle, of either winding, covers the pixel.
pub fn covers(triangle: [Point; 3], pixel: [usize; 2], variant: Variant) -> bool {
    let half = if variant.has(Mutation::CoveredAtCorner) { 0 } else { UNITS / 2 };
    let p = pixel.map(|c| c as i64 * UNITS + half);
    let [a, b, c] = triangle;
    let area = edge(a, b, c);
    if area == 0 {
        return false;
    }
    let [a, b, c] = if area > 0 { [a, b, c] } else { [a, c, b] };
    [(a, b), (b, c), (c, a)].iter().all(|&(from, to)| match edge(from, to, p) {
        0 => owns(from, to, variant),
        side => side > 0,
    })
}

/// Twice the signed area of (from, to, p): positive where `p` lies to the left.
fn edge(from: Point, to: Point, p: Point) -> i64 {
    (to[0] - from[0]) * (p[1] - from[1]) - (to[1] - from[1]) * (p[0] - from[0])
}

/// Whether an edge of a counter-clockwise triangle owns the centres on it: one that goes down is a
/// left edge, a level one that goes left is a top edge.
fn owns(from: Point, to: Point, variant: Variant) -> bool {
    let left = to[1] < from[1];
    let top = to[1] == from[1] && to[0] < from[0];
    if variant.has(Mutation::EdgesInclusive) {
        true
    } else if variant.has(Mutation::EdgesExclusive) {
        false
    } else {
        (left || top) != variant.has(Mutation::BottomRightRule)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn covered(triangle: [Point; 3]) -> Vec<[usize; 2]> {
        let all = (0..4).flat_map(|y| (0..4).map(move |x| [x, y]));
        all.filter(|&pixel| covers(triangle, pixel, Variant::CORRECT)).collect()
    }

    #[test]
    fn two_halves_of_a_square_cover_each_pixel_once() {
        // Corners on pixel centres, so that all edges and the diagonal go through centres.
        let corner = |x: i64, y: i64| [x * UNITS + UNITS / 2, y * UNITS + UNITS / 2];
        let (a, b, c, d) = (corner(0, 0), corner(2, 0), corner(2, 2), corner(0, 2));
        let mut both = covered([a, b, c]);
        both.extend(covered([c, d, a]));
        both.sort_unstable();
        // The left column and the top row belong to it, the right column and the bottom row not.
        assert_eq!(both, [[0, 1], [0, 2], [1, 1], [1, 2]]);
    }

    #[test]
    fn winding_does_not_matter_and_no_area_covers_nothing() {
        let t = [[0, 0], [64, 0], [0, 64]];
        assert_eq!(covered(t), covered([t[0], t[2], t[1]]));
        assert!(covered([t[0], t[1], t[1]]).is_empty());
    }
}
