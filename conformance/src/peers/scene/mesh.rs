//! The meshes of the scenes.

use crate::oracle::matrix::Matrix;
use crate::peers::client::{Mesh, Vertex};
use crate::reference::map::Homography;

/// How far meshes extend beyond the picture, so that no rounding uncovers a pixel.
const MARGIN: f64 = 1.05;

/// A square in clip coordinates that covers the picture, white. `map` takes clip x and y to
/// (s, t).
pub fn square(map: &Homography) -> Mesh {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let vertices = corners.map(|corner| {
        let [x, y] = corner.map(|c: f64| c * MARGIN);
        Vertex { position: [x as f32, y as f32, 0.0], st: single(map.apply([x, y])), ..WHITE }
    });
    Mesh { vertices: vertices.to_vec(), indices: vec![0, 1, 2, 0, 2, 3] }
}

/// A plane whose points' object coordinates x and y are its (s, t), and the projection that shows
/// it as `map` says, which takes the picture to (s, t).
pub fn plane(map: &Homography) -> (Mesh, Matrix) {
    let mut mesh = square(map);
    for vertex in &mut mesh.vertices {
        let [s, t] = vertex.st;
        vertex.position = [s, t, 0.0];
    }
    let back = map.inverse().0;
    // Clip w is positive where the picture is, whatever the sign of the adjugate.
    let middle = map.apply([0.0, 0.0]);
    let sign = (back[2][0] * middle[0] + back[2][1] * middle[1] + back[2][2]).signum();
    let row = |r: usize| [sign * back[r][0], sign * back[r][1], 0.0, sign * back[r][2]];
    (mesh, [row(0), row(1), [0.0; 4], row(2)])
}

/// A grid of `columns` × `rows` quadrilaterals; `vertex` takes points of [0, 1]².
pub fn grid(columns: usize, rows: usize, mut vertex: impl FnMut([f64; 2]) -> Vertex) -> Mesh {
    let mut mesh = Mesh::default();
    for j in 0..=rows {
        for i in 0..=columns {
            mesh.vertices.push(vertex([i as f64 / columns as f64, j as f64 / rows as f64]));
        }
    }
    let stride = columns as u32 + 1;
    for j in 0..rows as u32 {
        for i in 0..columns as u32 {
            let k = j * stride + i;
            mesh.indices.extend([k, k + 1, k + stride + 1, k, k + stride + 1, k + stride]);
        }
    }
    mesh
}

/// The colour white.
pub const WHITE: Vertex =
    Vertex { position: [0.0; 3], normal: [0.0, 0.0, 1.0], st: [0.0; 2], color: [1.0; 4] };

/// From the picture, face on, to (s, t) of a texture of `texels` texels: turned by 20°, `stretch`
/// texels a pixel across and `scale` up.
pub fn face_on(side: usize, texels: usize, [scale, stretch]: [f64; 2]) -> Homography {
    let half = side as f64 / texels as f64 / 2.0;
    turned(Homography([[half * stretch, 0.0, 0.0], [0.0, half * scale, 0.0], [0.0, 0.0, 1.0]]))
}

/// From the picture to (s, t) of a floor that is turned away by `tilt` degrees, `scale` texels a
/// pixel across at the middle; its far end is three times as far as its near end.
pub fn floor(side: usize, texels: usize, scale: f64, tilt: f64) -> Homography {
    let cos = tilt.to_radians().cos();
    let half = scale * side as f64 / texels as f64 / 2.0;
    turned(Homography([[half * cos, 0.0, 0.0], [0.0, half, 0.0], [0.0, -0.5 * cos, cos]]))
}

fn turned(map: Homography) -> Homography {
    let (s, c) = 20f64.to_radians().sin_cos();
    Homography([[c, -s, 0.307], [s, c, 0.409], [0.0, 0.0, 1.0]]).after(&map)
}

/// Rounded to `f32`.
pub fn single<const N: usize>(v: [f64; N]) -> [f32; N] {
    v.map(|c| c as f32)
}
