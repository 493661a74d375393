//! Interpolation: w ratios, planes seen edge on, the near plane, vertices far away.

use super::definition::Sweep;
use super::series::{Compared, Series, decades, octaves};
use crate::check::Unit;
use crate::mutation::Variant;
use crate::oracle::interpolation::{Vertex, barycentric, datum};
use crate::probe::{self, Precision, ProbeError, SIZE, Session, shader};

/// Ratios of w within a triangle.
pub const W_RATIO: Sweep = Sweep {
    name: "w-ratio",
    what: "a varying at every pixel of a triangle whose corners have w = 1, √r and r, each error \
           in units of the value itself",
    parameter: "r, largest w over smallest",
    unit: "ULP",
    bound: 16.0,
    why: "f/w and 1/w are stepped over a block of pixels in f32, from corners in f64: where they are a small part of the block's largest, its rounding counts; the ratio itself costs nothing",
    breaks: "from 1e12 on the sum of f/w at the near corner and the far ones is that of the near \
             corner alone, in f64 too: exactly where the value is that corner's",
    kept: 0.4,
    distinct: 0.5,
    before: &[],
    run: w_ratio,
};

/// A plane seen edge on.
pub const TILT: Sweep = Sweep {
    name: "edge-on-plane",
    what: "the distance on a floor that is seen from 45° below the horizon up to this little below \
           it, each error in units of the value itself",
    parameter: "degrees between the picture's upper edge and the horizon",
    unit: "ULP",
    bound: 6.0,
    why: "as for w ratios: the planes are exact to f64, whatever the tilt",
    breaks: "the upper edge is at 1/angle: from 1e-9 degrees on a row of pixels spans more than \
             all of f32's precision, and is still each pixel's own value",
    kept: 0.3,
    distinct: 0.5,
    before: &[],
    run: tilt,
};

/// Triangles cut by the near plane.
pub const NEAR_PLANE: Sweep = Sweep {
    name: "near-plane",
    what: "a varying on a floor half as far below the eye as the near plane is before it, which \
           cuts it in the middle of the picture; pixels drawn before the cut, or missing behind \
           it, count 2^24",
    parameter: "distance of the near plane (far is 100)",
    unit: "of 2^-24",
    bound: 20.0,
    why: "clipping cuts no values: planes come from the uncut corners, and are stepped over blocks as for w ratios",
    breaks: "below 1e-7 the corners' clip z is -w when it is rounded to f32: what is given then has no near plane left, and the whole floor is drawn",
    kept: 0.15,
    distinct: 0.5,
    before: &[],
    run: near_plane,
};

/// Vertices far outside of the view volume.
pub const FAR_VERTICES: Sweep = Sweep {
    name: "far-vertices",
    what: "x and y of a triangle whose corners lie this many pictures away, and whose coordinates \
           are the values, so that the picture's are always 0 to 1; missing pixels count 1",
    parameter: "pictures to the corners",
    unit: "of range, over max(2^-24, r·2^-53)",
    bound: 2.0,
    why: "cut at the guard band, with the planes of the uncut triangle in f64: a rounding of values \
          r times as large as the picture's (before cut points were put on the plane that cuts, \
          nothing was drawn from 1e19 on)",
    breaks: "from 2^29 on the corners' values have fewer bits in f64 than the picture needs: errors are r·2^-53, and from 2^53 on the values are those of rounding; every pixel is still drawn once",
    kept: 0.9,
    distinct: 0.1,
    before: &[],
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

/// What is expected of a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Expected {
    /// It is drawn, with the datum.
    Drawn,
    /// It is not drawn.
    Empty,
    /// It is not compared.
    Unsure,
}

/// The errors of the datum over a picture.
fn compared(
    triangle: &[Vertex; 3],
    expected: impl Fn(&[Vertex; 3], [f64; 2]) -> Expected,
    error: impl Fn(f64, f64) -> f64,
    missing: f64,
) -> Result<Compared, ProbeError> {
    let session = Session::open()?;
    let program = session.program(shader::INPUT, Precision::Exact { components: 2 })?;
    let vertices = triangle.each_ref().map(clip);
    let picture = session.triangles(&program, &vertices)?;
    let exact = triangle.each_ref().map(rounded);
    let mut compared = Compared::new();
    for (p, value) in picture.iter().enumerate() {
        let pixel = [p % SIZE, p / SIZE];
        let drawn = value[1] > 0.5;
        match (expected(&exact, pixel.map(|c| c as f64 + 0.5)), drawn) {
            (Expected::Unsure, _) => compared.leave_out(),
            (Expected::Drawn, true) => {
                let exact = datum(&exact, pixel, Variant::CORRECT);
                compared.add(error(exact, value[0]), &value[..1]);
            }
            // Neither adds anything to the share that must be kept.
            (Expected::Empty, false) => compared.leave_out(),
            (Expected::Drawn, false) | (Expected::Empty, true) => {
                compared.add(missing, &value[..2])
            }
        }
    }
    Ok(compared)
}

fn inside(triangle: &[Vertex; 3], p: [f64; 2]) -> Expected {
    if barycentric(triangle, p).iter().all(|&b| b > 1e-3) {
        Expected::Drawn
    } else {
        Expected::Unsure
    }
}

fn w_ratio() -> Result<Vec<Series>, ProbeError> {
    let side = SIZE as f64;
    let line = Series::measured("largest error", decades(0..=24), |ratio| {
        let vertex = |xy, w, datum| Vertex { xy, z: 0.0, w, datum };
        let triangle = [
            vertex([0.0, 0.0], 1.0, 0.3),
            vertex([side, 0.0], ratio.sqrt(), 0.5),
            vertex([0.0, side], ratio, 1.0),
        ];
        compared(&triangle, inside, |exact, value| Unit::Ulp.error(exact, value), 1e9)
    })?;
    Ok(vec![line])
}

fn tilt() -> Result<Vec<Series>, ProbeError> {
    let side = SIZE as f64;
    let line = Series::measured("largest error", decades(-16..=1), |degrees| {
        // Half the field of view is f; the middle of the picture lies f and the angle below the horizon.
        let field = 22.5f64.to_radians();
        let below = field + degrees.to_radians();
        let vertex = |x: f64, y: f64| {
            // How far the ray falls for each unit ahead; exact at the upper edge, where terms cancel.
            let fall = if y == 1.0 {
                degrees.to_radians().sin() / field.cos()
            } else {
                below.sin() - y * field.tan() * below.cos()
            };
            let w = 1.0 / fall;
            let datum = w * (below.cos() + y * field.tan() * below.sin());
            Vertex { xy: [x, y].map(|c| (c + 1.0) * side / 2.0), z: 0.0, w, datum }
        };
        let triangle = [vertex(-1.0, -1.0), vertex(1.0, -1.0), vertex(-1.0, 1.0)];
        compared(&triangle, inside, |exact, value| Unit::Ulp.error(exact, value), 1e9)
    })?;
    Ok(vec![line])
}

fn near_plane() -> Result<Vec<Series>, ProbeError> {
    let line = Series::measured("largest error", decades(-14..=1), |near| {
        let far = 100.0;
        // Of eye coordinates: the floor y = -near/2, from 50 ahead to 50 behind.
        let vertex = |x: f64, z: f64, datum: f64| {
            let depth = -(far + near) / (far - near) * z - 2.0 * far * near / (far - near);
            let w = -z;
            let xy = [x / w, -0.5 * near / w].map(|c| (c + 1.0) * SIZE as f64 / 2.0);
            Vertex { xy, z: depth / w, w, datum }
        };
        let triangle =
            [vertex(-40.0, -50.0, 0.0), vertex(40.0, -50.0, 0.25), vertex(0.0, 50.0, 1.0)];
        let expected = |triangle: &[Vertex; 3], p: [f64; 2]| {
            let weights = barycentric(triangle, p);
            let over_w: Vec<f64> = weights.iter().zip(triangle).map(|(b, v)| b / v.w).collect();
            let one: f64 = over_w.iter().sum();
            let w = 1.0 / one;
            // z + w of the clip coordinates as the driver has them: 0 on the plane.
            let z: f64 = over_w.iter().zip(triangle).map(|(b, v)| b * w * v.z * v.w).sum();
            let inside = over_w.iter().all(|b| b / one > 1e-3);
            let unsure = 0.02 * near;
            match z + w {
                _ if w < 0.0 => Expected::Empty,
                distance if inside && distance > unsure && w < 0.99 * far => Expected::Drawn,
                distance if distance < -unsure => Expected::Empty,
                _ => Expected::Unsure,
            }
        };
        let step = 2f64.powi(-24);
        compared(&triangle, expected, |exact, value| (exact - value).abs() / step, 1.0 / step)
    })?;
    Ok(vec![line])
}

fn far_vertices() -> Result<Vec<Series>, ProbeError> {
    let line = Series::measured("largest error", octaves(0..=60, 2), |reach| {
        let session = Session::open()?;
        let program = session.program(shader::INPUT, Precision::Exact { components: 3 })?;
        let corner = |x: f64, y: f64| {
            let [x, y] = [x * reach, y * reach].map(|c| c as f32);
            let inputs = [[x, y, 1.0, 0.0], [0.0; 4], [0.0; 4]];
            probe::Vertex { position: [x, y, 0.0, 1.0], inputs }
        };
        // Powers of two: every corner, and the value in each pixel, is exact.
        let picture = session
            .triangles(&program, &[corner(-4.0, -2.0), corner(4.0, -2.0), corner(0.0, 4.0)])?;
        let mut compared = Compared::new();
        let unit = 2f64.powi(-24).max(reach * 2f64.powi(-53));
        for (p, value) in picture.iter().enumerate() {
            let centre = [p % SIZE, p / SIZE].map(|c| (2 * c + 1) as f64 / SIZE as f64 - 1.0);
            let error = (value[0] - centre[0]).abs().max((value[1] - centre[1]).abs());
            compared.add(if value[2] > 0.5 { error / unit } else { 1.0 / unit }, &value[..3]);
        }
        Ok(compared)
    })?;
    Ok(vec![line])
}
