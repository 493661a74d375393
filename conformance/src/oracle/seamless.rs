//! Linear filters across the edges of a cube (ARB_seamless_cube_map), from geometry: the texel
//! beyond an edge is the one that a direction just past the edge selects; beyond a corner there is
//! none, and the mean of the other three stands for it.

use super::cube::{self, Face};
use super::texture::Level;
use crate::mutation::{Mutation, Variant};

/// The direction of (s, t) on a face's plane; outside of [0, 1] it leads to another face.
fn direction(face: Face, [s, t]: [f64; 2]) -> [f64; 3] {
    let (sc, tc) = (2.0 * s - 1.0, 2.0 * t - 1.0);
    match face {
        Face::PositiveX => [1.0, -tc, -sc],
        Face::NegativeX => [-1.0, -tc, sc],
        Face::PositiveY => [sc, 1.0, tc],
        Face::NegativeY => [sc, -1.0, -tc],
        Face::PositiveZ => [sc, -tc, 1.0],
        Face::NegativeZ => [-sc, -tc, -1.0],
    }
}

/// The texel (i, j) of a face, of which an index may lie one beyond an edge; none beyond a corner.
fn texel(faces: &[Level], face: Face, [i, j]: [i64; 2], variant: Variant) -> Option<[f64; 4]> {
    let size = faces[0].width as i64;
    let beyond = |n: i64| !(0..size).contains(&n);
    if beyond(i) && beyond(j) && !variant.has(Mutation::CubeCornerClamped) {
        return None;
    }
    if variant.has(Mutation::CubeEdgesClamped) {
        let [i, j] = [i, j].map(|n| n.clamp(0, size - 1) as usize);
        return Some(faces[face as usize].texel(i, j));
    }
    // Past the edge by next to nothing, so that the place along the edge stays.
    let centre = |n: i64| match n {
        n if n < 0 => -1e-9,
        n if n >= size => 1.0 + 1e-9,
        n => (n as f64 + 0.5) / size as f64,
    };
    let (face, st) = cube::select(direction(face, [centre(i), centre(j)]), Variant::CORRECT);
    let [i, j] = st.map(|c| ((c * size as f64).floor().clamp(0.0, (size - 1) as f64)) as usize);
    Some(faces[face as usize].texel(i, j))
}

/// The weighted mean of the four texels about a direction, whichever faces they lie on.
pub fn linear(faces: &[Level], r: [f64; 3], variant: Variant) -> [f64; 4] {
    let (face, st) = cube::select(r, variant);
    let size = faces[0].width as f64;
    let [u, v] = st.map(|c| c * size - 0.5);
    let (i, j) = (u.floor(), v.floor());
    let (alpha, beta) = (u - i, v - j);
    let corner = |a: i64, b: i64| texel(faces, face, [i as i64 + a, j as i64 + b], variant);
    let corners = [corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)];
    let there: Vec<[f64; 4]> = corners.iter().flatten().copied().collect();
    let mean: [f64; 4] = std::array::from_fn(|c| {
        there.iter().map(|texel| texel[c]).sum::<f64>() / there.len() as f64
    });
    let [t00, t10, t01, t11] = corners.map(|corner| corner.unwrap_or(mean));
    std::array::from_fn(|c| {
        (1.0 - beta) * ((1.0 - alpha) * t00[c] + alpha * t10[c])
            + beta * ((1.0 - alpha) * t01[c] + alpha * t11[c])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_direction_comes_back_to_its_face_and_place() {
        for face in Face::ALL {
            let (found, st) = cube::select(direction(face, [0.25, 0.75]), Variant::CORRECT);
            assert_eq!((found, st), (face, [0.25, 0.75]));
        }
    }

    #[test]
    fn halfway_across_an_edge_both_faces_count_the_same() {
        let faces: Vec<Level> =
            (0..6).map(|face| Level::from_fn(4, 4, |_, _| [face * 50; 4])).collect();
        // The edge of +X (0) and +Z (4 · 50), and the corner with +Y (2 · 50).
        let edge = linear(&faces, [1.0, 0.1, 1.0 - 1e-9], Variant::CORRECT)[0] * 255.0;
        assert!((edge - 100.0).abs() < 1e-3, "{edge}");
        let corner = linear(&faces, [1.0, 1.0, 1.0], Variant::CORRECT)[0] * 255.0;
        assert!((corner - 100.0).abs() < 1e-3, "{corner}");
    }
}
