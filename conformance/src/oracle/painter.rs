//! Pictures of primitives that are drawn one over the other: which one a pixel shows, and which of its vertices has the
//! flat values (GL 3.2, table 2.12).

/// Whether a point is inside a triangle, in either order; `None` on an edge.
pub fn inside(corners: [[f64; 2]; 3], [x, y]: [f64; 2]) -> Option<bool> {
    let side = |a: [f64; 2], b: [f64; 2]| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    let [a, b, c] = corners;
    let sides = [side(a, b), side(b, c), side(c, a)];
    if sides.contains(&0.0) {
        return None;
    }
    Some(sides.iter().all(|s| *s > 0.0) || sides.iter().all(|s| *s < 0.0))
}

/// A rectangle of whole pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the words say it")]
pub struct Rect {
    pub low: [usize; 2],
    pub size: [usize; 2],
}

impl Rect {
    /// Whether a pixel is in it.
    pub fn has(&self, pixel: [usize; 2]) -> bool {
        (0..2).all(|i| (self.low[i]..self.low[i] + self.size[i]).contains(&pixel[i]))
    }
}

/// A mode of primitives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GL's names")]
pub enum Mode {
    Points,
    Lines,
    LineStrip,
    LineLoop,
    Triangles,
    TriangleStrip,
    TriangleFan,
    LinesAdjacency,
    LineStripAdjacency,
    TrianglesAdjacency,
    TriangleStripAdjacency,
    Quads,
    QuadStrip,
    Polygon,
}

/// Which vertex provokes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GL's names")]
pub enum Convention {
    First,
    Last,
}

/// The primitives of `count` vertices: the vertices of each, without adjacent ones, and the one that
/// provokes. Numbers count from 0.
pub fn primitives(mode: Mode, count: usize, convention: Convention) -> Vec<(Vec<usize>, usize)> {
    let first = convention == Convention::First;
    let by = |a: usize, b: usize| if first { a } else { b };
    let every =
        |number: usize, f: &dyn Fn(usize) -> (Vec<usize>, usize)| (0..number).map(f).collect();
    match mode {
        Mode::Points => every(count, &|i| (vec![i], i)),
        Mode::Lines => every(count / 2, &|i| (vec![2 * i, 2 * i + 1], by(2 * i, 2 * i + 1))),
        Mode::LineStrip => every(count.saturating_sub(1), &|i| (vec![i, i + 1], by(i, i + 1))),
        Mode::LineLoop => every(if count > 1 { count } else { 0 }, &|i| {
            let next = (i + 1) % count;
            (vec![i, next], by(i, next))
        }),
        Mode::Triangles => {
            every(count / 3, &|i| (vec![3 * i, 3 * i + 1, 3 * i + 2], by(3 * i, 3 * i + 2)))
        }
        Mode::TriangleStrip => {
            every(count.saturating_sub(2), &|i| (vec![i, i + 1, i + 2], by(i, i + 2)))
        }
        Mode::TriangleFan => {
            every(count.saturating_sub(2), &|i| (vec![0, i + 1, i + 2], by(i + 1, i + 2)))
        }
        Mode::LinesAdjacency => {
            every(count / 4, &|i| (vec![4 * i + 1, 4 * i + 2], by(4 * i + 1, 4 * i + 2)))
        }
        Mode::LineStripAdjacency => {
            every(count.saturating_sub(3), &|i| (vec![i + 1, i + 2], by(i + 1, i + 2)))
        }
        Mode::TrianglesAdjacency => {
            every(count / 6, &|i| (vec![6 * i, 6 * i + 2, 6 * i + 4], by(6 * i, 6 * i + 4)))
        }
        Mode::TriangleStripAdjacency => every(count.saturating_sub(4) / 2, &|i| {
            (vec![2 * i, 2 * i + 2, 2 * i + 4], by(2 * i, 2 * i + 4))
        }),
        Mode::Quads => every(count / 4, &|i| {
            (vec![4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3], by(4 * i, 4 * i + 3))
        }),
        Mode::QuadStrip => every(count.saturating_sub(2) / 2, &|i| {
            (vec![2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2], by(2 * i, 2 * i + 3))
        }),
        Mode::Polygon => every(usize::from(count > 2), &|_| ((0..count).collect(), 0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_in_triangles_by_hand() {
        let corners = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
        assert_eq!(inside(corners, [1.0, 1.0]), Some(true));
        assert_eq!(inside(corners, [3.0, 3.0]), Some(false));
        assert_eq!(inside(corners, [2.0, 2.0]), None);
    }

    #[test]
    fn the_table_by_hand() {
        let last = |mode, count| {
            let all = primitives(mode, count, Convention::Last);
            all.into_iter().map(|(_, provokes)| provokes).collect::<Vec<_>>()
        };
        let first = |mode, count| {
            let all = primitives(mode, count, Convention::First);
            all.into_iter().map(|(_, provokes)| provokes).collect::<Vec<_>>()
        };
        assert_eq!(last(Mode::LineLoop, 3), [1, 2, 0]);
        assert_eq!(first(Mode::TriangleFan, 5), [1, 2, 3]);
        assert_eq!(last(Mode::QuadStrip, 6), [3, 5]);
        assert_eq!(last(Mode::TriangleStripAdjacency, 8), [4, 6]);
        assert_eq!(first(Mode::LinesAdjacency, 8), [1, 5]);
    }
}
