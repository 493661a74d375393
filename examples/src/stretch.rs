//! How a texture is stretched on a surface: of each triangle, the map from texture coordinates to space.

use crate::matrix::DVec3;
use crate::mesh::Mesh;

/// What becomes of a small circle of the texture.
#[derive(Clone, Copy, Debug)]
pub struct Stretch {
    /// Its area on the surface, for one of area 1.
    pub area: f64,
    /// The longer axis of the ellipse by the shorter one: 1 where angles are kept.
    pub axes: f64,
}

/// Of a triangle by its corners in space and their texture coordinates; none where either has no area.
fn of_triangle([a, b, c]: [DVec3; 3], [s, t, u]: [[f64; 2]; 3]) -> Option<Stretch> {
    let ([x1, y1], [x2, y2]) = ([t[0] - s[0], t[1] - s[1]], [u[0] - s[0], u[1] - s[1]]);
    let (along, across) = (b - a, c - a);
    let det = x1 * y2 - x2 * y1;
    if det.abs() < 1e-12 || along.cross(across).length() < 1e-12 {
        return None;
    }
    // The derivatives of the position by s and by t.
    let by_s = (along * y2 - across * y1) / det;
    let by_t = (across * x1 - along * x2) / det;
    // The squares of the singular values are the roots of λ² - (E + G) λ + (EG - F²).
    let (e, f, g) = (by_s.dot(by_s), by_s.dot(by_t), by_t.dot(by_t));
    let root = ((e - g) * (e - g) + 4.0 * f * f).sqrt();
    let (large, small) = ((e + g + root) / 2.0, ((e + g - root) / 2.0).max(1e-12));
    Some(Stretch { area: (large * small).sqrt(), axes: (large / small).sqrt() })
}

/// The stretch of a mesh's triangles, areas by their mean.
pub fn stretches(mesh: &Mesh) -> Vec<Stretch> {
    let corner = |index: u32| mesh.vertices[index as usize];
    let mut all: Vec<Stretch> = mesh
        .indices
        .chunks_exact(3)
        .filter_map(|triangle| {
            let vertices = [0, 1, 2].map(|at| corner(triangle[at]));
            let positions = vertices.map(|v| DVec3::from_array(v.position.map(f64::from)));
            of_triangle(positions, vertices.map(|v| v.tex_coord.map(f64::from)))
        })
        .collect();
    let mean = all.iter().map(|stretch| stretch.area).sum::<f64>() / all.len().max(1) as f64;
    all.iter_mut().for_each(|stretch| stretch.area /= mean);
    all
}

/// The least and the largest area, and the longest ellipse.
pub fn extremes(mesh: &Mesh) -> [f64; 3] {
    stretches(mesh).iter().fold([f64::MAX, 0.0, 1.0], |[least, most, axes], of| {
        [least.min(of.area), most.max(of.area), axes.max(of.axes)]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_pulled_to_twice_its_width_has_ellipses_of_two_by_one() {
        let corners = [DVec3::ZERO, 2.0 * DVec3::X, DVec3::Y];
        let got = of_triangle(corners, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
        assert!(
            got.is_some_and(|of| (of.area - 2.0).abs() < 1e-12 && (of.axes - 2.0).abs() < 1e-12)
        );
    }

    #[test]
    fn a_plane_keeps_angles_and_areas() {
        let [least, most, axes] = extremes(&Mesh::plane());
        assert!(
            (least - 1.0).abs() < 1e-6 && (most - 1.0).abs() < 1e-6 && (axes - 1.0).abs() < 1e-5
        );
    }
}
