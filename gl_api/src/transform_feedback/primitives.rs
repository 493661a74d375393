//! From the vertices of a draw to points, lines and triangles of their own (GL 3.0, section 2.6.1):
//! strips, loops, fans, quads and polygons fall apart, each part in the order that keeps which way it
//! faces and, but for fans of polygons, which vertex provokes last.

use super::Kind;
use rasterizer::driver::Topology;

/// What the primitives of a topology are captured as.
pub(super) fn kind(topology: Topology) -> Kind {
    match topology {
        Topology::Points => Kind::Points,
        Topology::Lines | Topology::LineStrip | Topology::LineLoop => Kind::Lines,
        Topology::Triangles
        | Topology::TriangleStrip
        | Topology::TriangleFan
        | Topology::Quads
        | Topology::QuadStrip
        | Topology::Polygon => Kind::Triangles,
    }
}

/// How many vertices a primitive has.
pub(super) fn corners(kind: Kind) -> usize {
    match kind {
        Kind::Points => 1,
        Kind::Lines => 2,
        Kind::Triangles => 3,
    }
}

/// How many primitives so many vertices make.
pub(super) fn count(topology: Topology, vertices: u64) -> u64 {
    match topology {
        Topology::Points => vertices,
        Topology::Lines => vertices / 2,
        Topology::LineStrip => vertices.saturating_sub(1),
        Topology::LineLoop if vertices < 2 => 0,
        Topology::LineLoop => vertices,
        Topology::Triangles => vertices / 3,
        Topology::TriangleStrip | Topology::TriangleFan | Topology::Polygon => {
            vertices.saturating_sub(2)
        }
        Topology::Quads => vertices / 4 * 2,
        Topology::QuadStrip => vertices.saturating_sub(2) / 2 * 2,
    }
}

/// The vertices of primitive `at` of the [`count`] that `vertices` make; as many as its kind has.
pub(super) fn primitive(topology: Topology, vertices: u32, at: u32) -> [u32; 3] {
    match topology {
        Topology::Points => [at; 3],
        Topology::Lines => [2 * at, 2 * at + 1, 0],
        Topology::LineStrip => [at, at + 1, 0],
        Topology::LineLoop => [at, (at + 1) % vertices.max(1), 0],
        Topology::Triangles => [3 * at, 3 * at + 1, 3 * at + 2],
        Topology::TriangleStrip if at % 2 == 1 => [at + 1, at, at + 2],
        Topology::TriangleStrip => [at, at + 1, at + 2],
        Topology::TriangleFan | Topology::Polygon => [0, at + 1, at + 2],
        Topology::Quads => {
            let first = at / 2 * 4;
            if at.is_multiple_of(2) {
                [first, first + 1, first + 3]
            } else {
                [first + 1, first + 2, first + 3]
            }
        }
        Topology::QuadStrip => {
            let first = at / 2 * 2;
            if at.is_multiple_of(2) {
                [first, first + 1, first + 3]
            } else {
                [first + 2, first, first + 3]
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By the order of table 2.14 and section 2.6.1, written out.
    #[test]
    fn primitives_fall_apart_in_order() {
        let cases: [(Topology, u32, &[&[u32]]); 12] = [
            (Topology::Points, 2, &[&[0], &[1]]),
            (Topology::Lines, 5, &[&[0, 1], &[2, 3]]),
            (Topology::LineStrip, 3, &[&[0, 1], &[1, 2]]),
            (Topology::LineLoop, 3, &[&[0, 1], &[1, 2], &[2, 0]]),
            (Topology::LineLoop, 1, &[]),
            (Topology::Triangles, 7, &[&[0, 1, 2], &[3, 4, 5]]),
            (Topology::TriangleStrip, 5, &[&[0, 1, 2], &[2, 1, 3], &[2, 3, 4]]),
            (Topology::TriangleFan, 4, &[&[0, 1, 2], &[0, 2, 3]]),
            (Topology::Polygon, 5, &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 4]]),
            (Topology::Quads, 7, &[&[0, 1, 3], &[1, 2, 3]]),
            (Topology::QuadStrip, 5, &[&[0, 1, 3], &[2, 0, 3]]),
            (Topology::QuadStrip, 1, &[]),
        ];
        for (topology, vertices, expected) in cases {
            assert_eq!(count(topology, vertices.into()), expected.len() as u64, "{topology:?}");
            for (at, expected) in expected.iter().enumerate() {
                let found = primitive(topology, vertices, at as u32);
                assert_eq!(&found[..corners(kind(topology))], *expected, "{topology:?} {at}");
            }
        }
    }
}
