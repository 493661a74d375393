//! Which vertices make which primitive (GL 2.1, section 2.6.1), as arithmetic, so that a draw can
//! be cut into chunks anywhere.

use crate::desc::{PrimitiveClass, Provoking, Topology};

/// Whether the edge flags of vertices count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeFlags {
    /// All edges are boundaries.
    AllSet,
    /// An edge is a boundary if the edge flag of its first vertex is set.
    ByVertex,
}

/// One primitive: the ordinals of its vertices within the draw, and which of them provokes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Primitive {
    /// A point.
    Point(u32),
    /// A line; the index of the provoking vertex.
    Line([u32; 2], u8),
    /// A triangle; the index of the provoking vertex; which of its edges are edges of the polygon
    /// that it is a part of, bit `i` for the one from vertex `i` on.
    Triangle([u32; 3], u8, u8),
}

/// All three edges of a triangle.
const ALL_EDGES: u8 = 0b111;

/// The primitives that `count` vertices make.
#[derive(Clone, Copy, Debug)]
pub struct Primitives {
    topology: Topology,
    provoking: Provoking,
    vertices: u32,
    /// How many primitives.
    pub len: u32,
    /// The number of the first.
    first_number: u32,
}

/// The primitives of `vertices` vertices. Incomplete primitives at the end are dropped.
pub fn primitives(topology: Topology, provoking: Provoking, vertices: u32) -> Primitives {
    let n = vertices;
    let len = match topology {
        Topology::Points => n,
        Topology::Lines => n / 2,
        Topology::LineStrip => n.saturating_sub(1),
        Topology::LineLoop => {
            if n < 2 {
                0
            } else {
                n
            }
        }
        Topology::Triangles => n / 3,
        Topology::TriangleStrip | Topology::TriangleFan | Topology::Polygon => n.saturating_sub(2),
        Topology::Quads => n / 4 * 2,
        Topology::QuadStrip => (n / 2).saturating_sub(1) * 2,
        Topology::LinesAdjacency => n / 4,
        Topology::LineStripAdjacency => n.saturating_sub(3),
        Topology::TrianglesAdjacency => n / 6,
        Topology::TriangleStripAdjacency => (n / 2).saturating_sub(2),
    };
    Primitives { topology, provoking, vertices, len, first_number: 0 }
}

impl Primitives {
    /// The same primitives, of which the first has this number.
    pub fn numbered_from(self, first_number: u32) -> Self {
        Self { first_number, ..self }
    }

    /// The number after that of the last; of the first, if there are none.
    pub fn next_number(&self) -> u32 {
        match self.len.checked_sub(1) {
            Some(last) => self.number(last).wrapping_add(1),
            None => self.first_number,
        }
    }

    /// The primitive `i`.
    #[inline]
    pub fn get(&self, i: u32) -> Primitive {
        let line = |a, b| match self.provoking {
            Provoking::Last => Primitive::Line([a, b], 1),
            Provoking::First => Primitive::Line([a, b], 0),
        };
        // Cut so that both halves hold the vertex that provokes: from the second to the fourth, or
        // from the first to the third.
        let quad = |[a, b, c, d]: [u32; 4], half: u32| match (self.provoking, half) {
            (Provoking::Last, 0) => Primitive::Triangle([a, b, d], 2, 0b101),
            (Provoking::Last, _) => Primitive::Triangle([b, c, d], 2, 0b011),
            (Provoking::First, 0) => Primitive::Triangle([a, b, c], 0, 0b011),
            (Provoking::First, _) => Primitive::Triangle([a, c, d], 0, 0b110),
        };
        // The same triangle from whichever vertex: the one that provokes is at its end.
        let triangle = |last: [u32; 3], first: [u32; 3]| match self.provoking {
            Provoking::Last => Primitive::Triangle(last, 2, ALL_EDGES),
            Provoking::First => Primitive::Triangle(first, 0, ALL_EDGES),
        };
        match self.topology {
            Topology::Points => Primitive::Point(i),
            Topology::Lines => line(2 * i, 2 * i + 1),
            Topology::LineStrip => line(i, i + 1),
            Topology::LineLoop => line(i, if i + 1 == self.vertices { 0 } else { i + 1 }),
            Topology::Triangles => {
                let own = [3 * i, 3 * i + 1, 3 * i + 2];
                triangle(own, own)
            }
            Topology::TriangleStrip if i.is_multiple_of(2) => {
                triangle([i, i + 1, i + 2], [i, i + 1, i + 2])
            }
            Topology::TriangleStrip => triangle([i + 1, i, i + 2], [i, i + 2, i + 1]),
            Topology::TriangleFan => triangle([0, i + 1, i + 2], [i + 1, i + 2, 0]),
            Topology::Polygon => {
                let (first, last) = (i == 0, i + 3 == self.vertices);
                let edges = u8::from(first) | 0b010 | u8::from(last) << 2;
                Primitive::Triangle([0, i + 1, i + 2], 0, edges)
            }
            Topology::Quads => {
                let first = i / 2 * 4;
                quad([first, first + 1, first + 2, first + 3], i % 2)
            }
            Topology::QuadStrip => {
                let first = i / 2 * 2;
                // Around the quadrilateral, so that its last vertex (2i + 3) comes last, or its first
                // one (2i) first.
                match self.provoking {
                    Provoking::Last => quad([first + 2, first, first + 1, first + 3], i % 2),
                    Provoking::First => quad([first, first + 1, first + 3, first + 2], i % 2),
                }
            }
            Topology::LinesAdjacency => line(4 * i + 1, 4 * i + 2),
            Topology::LineStripAdjacency => line(i + 1, i + 2),
            Topology::TrianglesAdjacency | Topology::TriangleStripAdjacency => {
                let [a, _, b, _, c, _] = self.with_adjacency(i);
                let own = [a, b, c];
                triangle(own, own)
            }
        }
    }

    /// The vertices of primitive `i` as a geometry program numbers them; others repeat the first. Of triangles with
    /// adjacency those of table 2.4 (GL 3.2), from whichever corner: the one that provokes is at their end.
    pub fn with_adjacency(&self, i: u32) -> [u32; 6] {
        match self.topology {
            Topology::LinesAdjacency => {
                let first = 4 * i;
                [first, first + 1, first + 2, first + 3, first, first]
            }
            Topology::LineStripAdjacency => [i, i + 1, i + 2, i + 3, i, i],
            Topology::TrianglesAdjacency => [0, 1, 2, 3, 4, 5].map(|at| 6 * i + at),
            Topology::TriangleStripAdjacency => {
                let first = 2 * i;
                let before = if i == 0 { 1 } else { first - 2 };
                let behind = if i + 1 == self.len { first + 5 } else { first + 6 };
                match (i % 2, self.provoking) {
                    (0, _) => [first, before, first + 2, behind, first + 4, first + 3],
                    (_, Provoking::Last) => {
                        [first + 2, before, first, first + 3, first + 4, behind]
                    }
                    (_, Provoking::First) => {
                        [first, first + 3, first + 4, behind, first + 2, before]
                    }
                }
            }
            Topology::Points
            | Topology::Lines
            | Topology::LineStrip
            | Topology::LineLoop
            | Topology::Triangles
            | Topology::TriangleStrip
            | Topology::TriangleFan
            | Topology::Quads
            | Topology::QuadStrip
            | Topology::Polygon => match self.get(i) {
                Primitive::Point(a) => [a; 6],
                Primitive::Line([a, b], _) => [a, b, a, a, a, a],
                Primitive::Triangle([a, b, c], ..) => [a, b, c, a, a, a],
            },
        }
    }

    /// `gl_PrimitiveID` of primitive `i`: halves of a quadrilateral have one, and so have
    /// the parts of a polygon (`EXT_gpu_shader4`). No vertex provokes two that differ in it.
    pub fn number(&self, i: u32) -> u32 {
        let number = match self.topology {
            Topology::Points
            | Topology::Lines
            | Topology::LineStrip
            | Topology::LineLoop
            | Topology::Triangles
            | Topology::TriangleStrip
            | Topology::TriangleFan
            | Topology::LinesAdjacency
            | Topology::LineStripAdjacency
            | Topology::TrianglesAdjacency
            | Topology::TriangleStripAdjacency => i,
            Topology::Quads | Topology::QuadStrip => i / 2,
            Topology::Polygon => 0,
        };
        self.first_number.wrapping_add(number)
    }

    /// Which vertex provokes, where primitive `i` is the triangle of ordinals `3 i` to `3 i + 2`.
    pub fn triples(&self) -> Option<u8> {
        (self.topology == Topology::Triangles).then_some(match self.provoking {
            Provoking::Last => 2,
            Provoking::First => 0,
        })
    }

    /// Whether they are triangles.
    pub fn are_triangles(&self) -> bool {
        self.topology.class() == PrimitiveClass::Polygons
    }

    /// Whether the edge flags of vertices count: of strips and fans all edges are boundaries (section
    /// 2.6.2).
    pub fn edge_flags(&self) -> EdgeFlags {
        match self.topology {
            Topology::Triangles | Topology::Quads | Topology::Polygon => EdgeFlags::ByVertex,
            Topology::LinesAdjacency
            | Topology::LineStripAdjacency
            | Topology::TrianglesAdjacency
            | Topology::TriangleStripAdjacency
            | Topology::Points
            | Topology::Lines
            | Topology::LineStrip
            | Topology::LineLoop
            | Topology::TriangleStrip
            | Topology::TriangleFan
            | Topology::QuadStrip => EdgeFlags::AllSet,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangles(topology: Topology, vertices: u32) -> Vec<[u32; 3]> {
        let all = primitives(topology, Provoking::Last, vertices);
        (0..all.len)
            .map(|i| match all.get(i) {
                Primitive::Triangle(v, ..) => v,
                other => panic!("{other:?}"),
            })
            .collect()
    }

    #[test]
    fn each_topology_makes_its_primitives() {
        assert_eq!(triangles(Topology::Triangles, 7), [[0, 1, 2], [3, 4, 5]]);
        assert_eq!(triangles(Topology::TriangleStrip, 5), [[0, 1, 2], [2, 1, 3], [2, 3, 4]]);
        assert_eq!(triangles(Topology::TriangleFan, 5), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
        assert_eq!(triangles(Topology::Quads, 7), [[0, 1, 3], [1, 2, 3]]);
        assert_eq!(triangles(Topology::QuadStrip, 5), [[2, 0, 3], [0, 1, 3]]);
        for (topology, vertices) in [
            (Topology::Points, 0),
            (Topology::Lines, 1),
            (Topology::LineStrip, 1),
            (Topology::LineLoop, 1),
            (Topology::Triangles, 2),
            (Topology::Polygon, 2),
            (Topology::Quads, 3),
            (Topology::QuadStrip, 3),
        ] {
            assert_eq!(primitives(topology, Provoking::Last, vertices).len, 0, "{topology:?}");
        }
        let looped = primitives(Topology::LineLoop, Provoking::Last, 3);
        assert_eq!(looped.get(2), Primitive::Line([2, 0], 1));
    }

    /// GL 3.2, table 2.4, from 0: the only, the first, middle and the last triangle of a strip.
    #[test]
    fn triangles_of_strips_with_adjacency_have_their_neighbours() {
        let of = |convention, count| {
            let all = primitives(Topology::TriangleStripAdjacency, convention, count);
            (0..all.len).map(|i| all.with_adjacency(i)).collect::<Vec<_>>()
        };
        assert_eq!(of(Provoking::Last, 5), [[0; 6]; 0]);
        assert_eq!(of(Provoking::Last, 7), [[0, 1, 2, 5, 4, 3]]);
        let last = of(Provoking::Last, 12);
        let want =
            [[0, 1, 2, 6, 4, 3], [4, 0, 2, 5, 6, 8], [4, 2, 6, 10, 8, 7], [8, 4, 6, 9, 10, 11]];
        assert_eq!(last, want);
        for (first, last) in of(Provoking::First, 12).into_iter().zip(last) {
            let mut rotated = last;
            while rotated[0] != first[0] {
                rotated.rotate_left(2);
            }
            assert_eq!(first, rotated);
        }
        let lines = primitives(Topology::LineStripAdjacency, Provoking::Last, 6);
        assert_eq!((lines.len, lines.with_adjacency(2)[..4].to_vec()), (3, vec![2, 3, 4, 5]));
        assert_eq!(lines.get(2), Primitive::Line([3, 4], 1));
    }

    #[test]
    fn every_edge_of_a_polygon_is_in_one_of_its_triangles() {
        let cases = [
            (Topology::Quads, Provoking::Last, 4),
            (Topology::Quads, Provoking::First, 4),
            (Topology::Polygon, Provoking::Last, 7),
        ];
        for (topology, convention, count) in cases {
            let all = primitives(topology, convention, count);
            let mut edges = Vec::new();
            for i in 0..all.len {
                let Primitive::Triangle(v, _, mask) = all.get(i) else { panic!() };
                let own = (0..3).filter(|k| mask >> k & 1 == 1);
                edges.extend(own.map(|k| (v[k], v[(k + 1) % 3])));
            }
            edges.sort_unstable();
            let want: Vec<_> = (0..count).map(|k| (k, (k + 1) % count)).collect();
            assert_eq!(edges, want, "{topology:?}");
        }
    }

    /// A strip of quadrilaterals winds like the triangles of a strip over the same vertices.
    #[test]
    fn the_provoking_vertex_of_a_quad_is_in_both_halves() {
        for topology in [Topology::Quads, Topology::QuadStrip] {
            for (convention, vertex) in [(Provoking::Last, 3), (Provoking::First, 0)] {
                let all = primitives(topology, convention, 4);
                for i in 0..2 {
                    let Primitive::Triangle(v, provoking, _) = all.get(i) else { panic!() };
                    assert_eq!(v[usize::from(provoking)], vertex, "{topology:?}");
                }
            }
        }
    }

    /// What each convention of `ARB_provoking_vertex` chooses. The triangles are the same
    /// ones, wound the same way.
    #[test]
    fn either_convention_chooses_its_vertex() {
        let cases: [(Topology, u32, &[u32], &[u32]); 9] = [
            (Topology::Lines, 4, &[0, 2], &[1, 3]),
            (Topology::LineStrip, 4, &[0, 1, 2], &[1, 2, 3]),
            (Topology::LineLoop, 3, &[0, 1, 2], &[1, 2, 0]),
            (Topology::Triangles, 6, &[0, 3], &[2, 5]),
            (Topology::TriangleStrip, 6, &[0, 1, 2, 3], &[2, 3, 4, 5]),
            (Topology::TriangleFan, 5, &[1, 2, 3], &[2, 3, 4]),
            (Topology::Quads, 8, &[0, 0, 4, 4], &[3, 3, 7, 7]),
            (Topology::QuadStrip, 6, &[0, 0, 2, 2], &[3, 3, 5, 5]),
            (Topology::Polygon, 5, &[0, 0, 0], &[0, 0, 0]),
        ];
        for (topology, count, first, last) in cases {
            for (convention, want) in [(Provoking::First, first), (Provoking::Last, last)] {
                let all = primitives(topology, convention, count);
                let chosen = (0..all.len).map(|i| match all.get(i) {
                    Primitive::Point(vertex) => vertex,
                    Primitive::Line(vertices, at) => vertices[usize::from(at)],
                    Primitive::Triangle(vertices, at, _) => vertices[usize::from(at)],
                });
                assert_eq!(chosen.collect::<Vec<_>>(), want, "{topology:?} {convention:?}");
            }
        }
        // From its least vertex on, each triangle of a strip or a fan is the same.
        for topology in [Topology::TriangleStrip, Topology::TriangleFan] {
            let rotated = |convention, i| match primitives(topology, convention, 6).get(i) {
                Primitive::Triangle(mut v, ..) => {
                    while v[0] > v[1] || v[0] > v[2] {
                        v.rotate_left(1);
                    }
                    v
                }
                other => panic!("{other:?}"),
            };
            for i in 0..4 {
                assert_eq!(rotated(Provoking::First, i), rotated(Provoking::Last, i));
            }
        }
    }
}
