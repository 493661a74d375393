//! The vertices that a geometry shader gets (GL 3.2, section 2.6.1 and tables 2.3 and 2.4).

use super::painter::Mode;
use crate::mutation::{Mutation, Variant};

/// `gl_in` of each primitive of `count` vertices, for modes whose order the specification fixes.
pub fn inputs(mode: Mode, count: usize, variant: Variant) -> Vec<Vec<usize>> {
    match mode {
        Mode::LinesAdjacency => (0..count / 4).map(|i| (4 * i..4 * i + 4).collect()).collect(),
        Mode::LineStripAdjacency => {
            (0..count.saturating_sub(3)).map(|i| (i..i + 4).collect()).collect()
        }
        Mode::TrianglesAdjacency => (0..count / 6).map(|i| (6 * i..6 * i + 6).collect()).collect(),
        Mode::TriangleStripAdjacency => {
            let number = count.saturating_sub(4) / 2;
            (0..number).map(|i| strip_triangle(i, number, variant)).collect()
        }
        Mode::Points
        | Mode::Lines
        | Mode::LineStrip
        | Mode::LineLoop
        | Mode::Triangles
        | Mode::TriangleStrip
        | Mode::TriangleFan
        | Mode::Quads
        | Mode::QuadStrip
        | Mode::Polygon => {
            let all = super::painter::primitives(mode, count, super::painter::Convention::Last);
            all.into_iter().map(|(vertices, _)| vertices).collect()
        }
    }
}

/// Table 2.4, in the order of `gl_in`: first vertex, the one adjacent to the edge 1/2, second, 2/3, third, 3/1.
fn strip_triangle(i: usize, number: usize, variant: Variant) -> Vec<usize> {
    let last = i + 1 == number && !variant.has(Mutation::LastAdjacencyIgnored);
    let odd = i % 2 == 1 && !variant.has(Mutation::OddTriangleUnturned);
    // The table counts vertices from 1.
    let row: [usize; 6] = match (i, odd, last) {
        (0, _, true) => [1, 2, 3, 6, 5, 4],
        (0, _, false) => [1, 2, 3, 7, 5, 4],
        (_, true, false) => [2 * i + 3, 2 * i - 1, 2 * i + 1, 2 * i + 4, 2 * i + 5, 2 * i + 7],
        (_, false, false) => [2 * i + 1, 2 * i - 1, 2 * i + 3, 2 * i + 7, 2 * i + 5, 2 * i + 4],
        (_, true, true) => [2 * i + 3, 2 * i - 1, 2 * i + 1, 2 * i + 4, 2 * i + 5, 2 * i + 6],
        (_, false, true) => [2 * i + 1, 2 * i - 1, 2 * i + 3, 2 * i + 6, 2 * i + 5, 2 * i + 4],
    };
    row.map(|vertex| vertex - 1).to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_strip_of_two_triangles() {
        let strip = inputs(Mode::TriangleStripAdjacency, 8, Variant::CORRECT);
        assert_eq!(strip, [[0, 1, 2, 6, 4, 3], [4, 0, 2, 5, 6, 7]]);
        let single = inputs(Mode::TriangleStripAdjacency, 7, Variant::CORRECT);
        assert_eq!(single, [[0, 1, 2, 5, 4, 3]]);
    }
}
