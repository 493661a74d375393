//! The faces of a cube in `f64` (GL 2.1, section 3.8.6).

use crate::oracle::Position;
use texunit::image::Shape;

pub fn is_cube(shape: Shape) -> bool {
    matches!(shape, Shape::Cube | Shape::CubeArray)
}

/// A point beyond the edge of a cube's face is where its direction meets the cube; and its distance
/// to where this matters.
pub fn over_edges(shape: Shape, place: Position) -> (Position, f64) {
    let [s, t, _] = place.at;
    let (sc, tc) = (2.0 * s - 1.0, 2.0 * t - 1.0);
    let beyond = sc.abs().max(tc.abs()) - 1.0;
    if !is_cube(shape) || beyond <= 0.0 {
        return (place, if is_cube(shape) { -beyond } else { f64::INFINITY });
    }
    let direction = match place.face {
        0 => [1.0, -tc, -sc],
        1 => [-1.0, -tc, sc],
        2 => [sc, 1.0, tc],
        3 => [sc, -1.0, -tc],
        4 => [sc, -tc, 1.0],
        _ => [-sc, -tc, -1.0],
    };
    let (face, near) = select_face(direction);
    let [s, t] = project(face, direction);
    (Position { face, at: [s, t, 0.0], ..place }, near.min(beyond))
}

/// The face of the largest component, and by how much it is the largest.
pub fn select_face(r: [f64; 3]) -> (usize, f64) {
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| r[b].abs().total_cmp(&r[a].abs()));
    let largest = order[0];
    let face = 2 * largest + usize::from(r[largest] < 0.0);
    (face, r[largest].abs() - r[order[1]].abs())
}

/// Table 3.19.
pub fn project(face: usize, [x, y, z]: [f64; 3]) -> [f64; 2] {
    let (sc, tc, ma) = match face {
        0 => (-z, -y, x),
        1 => (z, -y, x),
        2 => (x, z, y),
        3 => (x, -z, y),
        4 => (x, -y, z),
        _ => (-x, -y, z),
    };
    [0.5 * (sc / ma.abs() + 1.0), 0.5 * (tc / ma.abs() + 1.0)]
}
