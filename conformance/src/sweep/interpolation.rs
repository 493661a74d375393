//! Interpolation: w ratios, planes seen edge on, the near plane, vertices far away.

use super::definition::{Sweep, decades};
use crate::mutation::Variant;
use crate::oracle::interpolation::{Vertex, barycentric, datum};
use crate::plot::Line;
use crate::probe::{self, Precision, ProbeError, SIZE, Session, shader};

/// Ratios of w within a triangle.
pub const W_RATIO: Sweep = Sweep {
    name: "w-ratio",
    what: "a varying at every pixel of a triangle whose corners have w = 1, √r and r",
    parameter: "r, largest w over smallest",
    unit: "of range",
    bound: 1.0 / (1 << 19) as f64,
    why: "f/w and 1/w are planes evaluated in f64 at block corners: the ratio costs nothing",
    before: &[],
    run: w_ratio,
};

/// A plane seen edge on.
pub const TILT: Sweep = Sweep {
    name: "edge-on-plane",
    what: "texture coordinates, as parts of their extent, on a plane seen at 90° less this",
    parameter: "degrees from edge on",
    unit: "of range",
    bound: 1.0 / (1 << 19) as f64,
    why: "as for w ratios: the planes are exact to f64 whatever the tilt",
    before: &[],
    run: tilt,
};

/// Triangles cut by the near plane.
pub const NEAR_PLANE: Sweep = Sweep {
    name: "near-plane",
    what: "a varying on a floor that passes below the eye and through the near plane",
    parameter: "distance of the near plane (far is 100)",
    unit: "of range",
    bound: 1.0 / (1 << 18) as f64,
    why: "clipping cuts no values: planes come from the uncut corners; clip coordinates are f32",
    before: &[],
    run: near_plane,
};

/// Vertices far outside of the view volume.
pub const FAR_VERTICES: Sweep = Sweep {
    name: "far-vertices",
    what: "a varying on a triangle whose corners lie this many pictures away; missing pixels count 1",
    parameter: "pictures to the corners",
    unit: "of range",
    bound: 1.0 / (1 << 19) as f64,
    why: "cut at the guard band, with the planes of the uncut triangle (before cut points were put \
          on the plane that cuts, nothing was drawn from 1e19 on: an error of 1)",
    before: &[(1e19, 1.0), (1e24, 1.0), (1e30, 1.0)],
    run: far_vertices,
};

fn clip(v: &Vertex) -> probe::Vertex {
    let ndc = v.xy.map(|c| 2.0 * c / SIZE as f64 - 1.0);
    let position = [ndc[0] * v.w, ndc[1] * v.w, v.z * v.w, v.w].map(|c| c as f32);
    probe::Vertex { position, inputs: [[v.datum as f32, 1.0, 0.0, 0.0], [0.0; 4], [0.0; 4]] }
}

/// The vertex that the driver is given, rounded as it is.
fn rounded(v: &Vertex) -> Vertex {
    let probe::Vertex { position, inputs } = clip(v);
    let [x, y, z, w] = position.map(f64::from);
    let window = [x / w, y / w].map(|c| (c + 1.0) * SIZE as f64 / 2.0);
    Vertex { xy: window, z: z / w, w, datum: f64::from(inputs[0][0]) }
}

/// The largest error over the pixels that `counts` picks.
fn largest_error(
    triangle: &[Vertex; 3],
    counts: impl Fn(&[Vertex; 3], [f64; 2]) -> bool,
) -> Result<f64, ProbeError> {
    let session = Session::open()?;
    let program = session.program(shader::INPUT, Precision::Exact { components: 2 })?;
    let vertices = triangle.each_ref().map(clip);
    let picture = session.triangles(&program, &vertices)?;
    let exact = triangle.each_ref().map(rounded);
    let mut largest: f64 = 0.0;
    for (p, value) in picture.iter().enumerate() {
        let pixel = [p % SIZE, p / SIZE];
        if counts(&exact, pixel.map(|c| c as f64 + 0.5)) {
            let error = (value[0] - datum(&exact, pixel, Variant::CORRECT)).abs();
            // A pixel that was not drawn has no 1 beside the datum.
            largest = largest.max(if value[1] > 0.5 { error } else { 1.0 });
        }
    }
    Ok(largest)
}

fn inside(triangle: &[Vertex; 3], p: [f64; 2]) -> bool {
    barycentric(triangle, p).iter().all(|&b| b > 1e-3)
}

fn w_ratio() -> Result<Vec<Line>, ProbeError> {
    let side = SIZE as f64;
    let line = decades("largest error", 0..=12, |ratio| {
        let vertex = |xy, w, datum| Vertex { xy, z: 0.0, w, datum };
        let triangle = [
            vertex([0.0, 0.0], 1.0, 0.0),
            vertex([side, 0.0], ratio.sqrt(), 0.5),
            vertex([0.0, side], ratio, 1.0),
        ];
        largest_error(&triangle, inside)
    })?;
    Ok(vec![line])
}

fn tilt() -> Result<Vec<Line>, ProbeError> {
    let side = SIZE as f64;
    let line = decades("largest error", -4..=1, |degrees| {
        let (cos, sin) = degrees.to_radians().sin_cos();
        // As in the scenes: a field of view that sees no horizon, q = cos - k·sin·y.
        let k = 0.3 * cos / sin;
        let vertex = |x: f64, y: f64| {
            let q = cos - k * sin * y;
            // The t coordinate, moved and scaled to [0, 1] over the triangle.
            let t = y / q;
            let (low, high) = (-1.0 / (cos + k * sin), 3.0 / (cos - 3.0 * k * sin));
            let xy = [x, y].map(|c| (c + 1.0) * side / 2.0);
            Vertex { xy, z: 0.0, w: cos / q, datum: (t - low) / (high - low) }
        };
        let triangle = [vertex(-1.0, -1.0), vertex(3.0, -1.0), vertex(-1.0, 3.0)];
        largest_error(&triangle, inside)
    })?;
    Ok(vec![line])
}

fn near_plane() -> Result<Vec<Line>, ProbeError> {
    let line = decades("largest error", -9..=0, |near| {
        let far = 100.0;
        // Of eye coordinates: the floor y = -1, from 50 ahead to 50 behind.
        let vertex = |x: f64, z: f64, datum: f64| {
            let depth = -(far + near) / (far - near) * z - 2.0 * far * near / (far - near);
            let w = -z;
            let xy = [x / w, -1.0 / w].map(|c| (c + 1.0) * SIZE as f64 / 2.0);
            Vertex { xy, z: depth / w, w, datum }
        };
        let triangle =
            [vertex(-40.0, -50.0, 0.0), vertex(40.0, -50.0, 0.25), vertex(0.0, 50.0, 1.0)];
        largest_error(&triangle, |triangle, p| {
            let weights = barycentric(triangle, p);
            let over_w: Vec<f64> = weights.iter().zip(triangle).map(|(b, v)| b / v.w).collect();
            let one: f64 = over_w.iter().sum();
            let w = 1.0 / one;
            // In front of the eye, between the planes, and inside in space.
            w > near * 1.01 && w < far * 0.99 && over_w.iter().all(|b| b / one > 1e-3)
        })
    })?;
    Ok(vec![line])
}

fn far_vertices() -> Result<Vec<Line>, ProbeError> {
    let line = decades("largest error", 0..=30, |reach| {
        let side = SIZE as f64;
        let vertex = |x: f64, y: f64, datum| {
            let xy = [x, y].map(|c| (c * reach + 0.5) * side);
            Vertex { xy, z: 0.0, w: 1.0, datum }
        };
        let triangle = [vertex(-1.0, -1.1, 0.0), vertex(1.2, -0.9, 0.5), vertex(0.1, 1.0, 1.0)];
        largest_error(&triangle, inside)
    })?;
    Ok(vec![line])
}
