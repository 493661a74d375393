//! Clipping in homogeneous coordinates (GL 2.1, section 2.12), in `f64`.
//!
//! Only geometry is clipped. Depth and varyings are interpolated by the plane equations of the
//! whole primitive ([`crate::raster`]), which hold on every part of it, so that a cut costs no
//! precision and leaves no seam. The sides of the view volume cut nothing: a guard band far outside
//! the window does, and the scissor does the rest.

use crate::driver::Viewport;
use crate::vertex::GUARD_BAND;

/// A vertex in clip coordinates.
pub type Clip = [f64; 4];

/// The smallest `w` that is left: whatever is closer to the eye's plane is outside every guard band.
const W_MIN: f64 = 1e-30;

/// A half space: what has `p · plane >= 0` is inside.
type Plane = [f64; 4];

/// The half spaces that a primitive is cut by: w > 0, near, far, and the guard band of a viewport.
pub fn planes(viewport: &Viewport) -> [Plane; 7] {
    let (half, center) = (viewport.half(), viewport.center());
    // -G w <= x half + center w <= G w
    let low = |axis: usize| center[axis] + GUARD_BAND;
    let high = |axis: usize| GUARD_BAND - center[axis];
    [
        [0.0, 0.0, 0.0, 1.0],
        [0.0, 0.0, 1.0, 1.0],
        [0.0, 0.0, -1.0, 1.0],
        [half[0], 0.0, 0.0, low(0)],
        [-half[0], 0.0, 0.0, high(0)],
        [0.0, half[1], 0.0, low(1)],
        [0.0, -half[1], 0.0, high(1)],
    ]
}

/// Cuts a convex polygon (or, with two vertices, a line) by every plane, in place. Leaves nothing
/// or a convex polygon whose `w` are all positive.
pub fn clip(polygon: &mut Vec<Clip>, scratch: &mut Vec<Clip>, planes: &[Plane; 7]) {
    for (index, plane) in planes.iter().enumerate() {
        let offset = if index == 0 { -W_MIN } else { 0.0 };
        let distance = |p: &Clip| {
            p[0] * plane[0] + p[1] * plane[1] + p[2] * plane[2] + p[3] * plane[3] + offset
        };
        scratch.clear();
        let n = polygon.len();
        // A line has one edge, a polygon as many as vertices.
        for i in 0..n {
            let a = polygon[i];
            let da = distance(&a);
            if da >= 0.0 {
                scratch.push(a);
            }
            if n == 2 && i == 1 {
                break;
            }
            let b = polygon[(i + 1) % n];
            let db = distance(&b);
            if (da >= 0.0) != (db >= 0.0) {
                // From the inside to the outside, whichever way the edge runs, so that two
                // primitives that share it are cut at the same point to the bit.
                let (inside, di, outside, d_o) =
                    if da >= 0.0 { (a, da, b, db) } else { (b, db, a, da) };
                let t = di / (di - d_o);
                scratch.push([0, 1, 2, 3].map(|k| inside[k] + (outside[k] - inside[k]) * t));
            }
        }
        std::mem::swap(polygon, scratch);
        if polygon.is_empty() {
            return;
        }
    }
}
