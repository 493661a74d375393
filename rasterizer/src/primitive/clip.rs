//! Clipping in homogeneous coordinates (GL 2.1, section 2.12), in `f64`.
//!
//! Only geometry is clipped. Depth and varyings are interpolated by the plane equations of the
//! whole primitive ([`crate::raster`]), which hold on every part of it, so that a cut costs no
//! precision and leaves no seam. The sides of the view volume cut nothing: a guard band far outside
//! the window does, and the scissor does the rest.

use crate::desc::{ClipDepth, DepthClip, Viewport};
use crate::sizes::{GUARD_BAND, MAX_DISTANCES};
use crate::vertex::Geometry;

/// What the edge of a polygon that begins at a corner is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Edge {
    /// Along the view volume, where nothing is drawn.
    #[default]
    View,
    /// Part of one of its own, by the vertex where that begins.
    Own(u8),
    /// Along a plane of the user's: an edge like its own (GL 2.1, section 2.12).
    Made,
}

/// A vertex in clip coordinates, and its distances to the user's planes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Corner {
    /// x, y, z, w.
    pub clip: [f64; 4],
    /// By plane.
    pub distances: [f64; MAX_DISTANCES],
    /// How much of each of the polygon's first three vertices it is.
    pub weights: [f64; 3],
    /// To the next corner.
    pub edge: Edge,
    /// The edge that a plane of the user's has cut, if that made this corner.
    pub cut: Option<Edge>,
}

impl Corner {
    /// A vertex of a geometry.
    pub fn of(geometry: &Geometry, vertex: u32) -> Self {
        let mut distances = [0.0; MAX_DISTANCES];
        for (to, &from) in distances.iter_mut().zip(geometry.distances(vertex)) {
            *to = from.into();
        }
        Self { clip: geometry.clip(vertex).map(f64::from), distances, ..Self::default() }
    }
}

/// The smallest `w` that is left: whatever is closer to the eye's plane is outside every guard band.
const W_MIN: f64 = 1e-30;

/// A half space: what has `p · plane >= 0` is inside.
type Plane = [f64; 4];

/// The half spaces that a primitive is cut by: w > 0, near and far (where depth is clamped instead,
/// w > 0 again), and the guard band of a viewport.
pub fn planes(viewport: &Viewport) -> [Plane; 7] {
    let (half, center) = (viewport.half(), viewport.center());
    // -G w <= x half + center w <= G w
    let low = |axis: usize| center[axis] + GUARD_BAND;
    let high = |axis: usize| GUARD_BAND - center[axis];
    let in_front = [0.0, 0.0, 0.0, 1.0];
    let [near, far] = match (viewport.depth_clip, viewport.clip_control.depth) {
        (DepthClip::Cut, ClipDepth::NegativeOneToOne) => {
            [[0.0, 0.0, 1.0, 1.0], [0.0, 0.0, -1.0, 1.0]]
        }
        (DepthClip::Cut, ClipDepth::ZeroToOne) => [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, -1.0, 1.0]],
        (DepthClip::Clamp, _) => [in_front; 2],
    };
    [
        in_front,
        near,
        far,
        [half[0], 0.0, 0.0, low(0)],
        [-half[0], 0.0, 0.0, high(0)],
        [0.0, half[1], 0.0, low(1)],
        [0.0, -half[1], 0.0, high(1)],
    ]
}

/// Cuts a convex polygon (or, with two vertices, a line) by every plane and by the user's planes
/// whose bit is set in `user`, in place. Leaves nothing or a convex polygon whose `w` are all
/// positive.
pub fn clip(polygon: &mut Vec<Corner>, scratch: &mut Vec<Corner>, planes: &[Plane; 7], user: u8) {
    for (index, plane) in planes.iter().enumerate() {
        let offset = if index == 0 { -W_MIN } else { 0.0 };
        let distance = |corner: &Corner| {
            let p = &corner.clip;
            p[0] * plane[0] + p[1] * plane[1] + p[2] * plane[2] + p[3] * plane[3] + offset
        };
        // Between coordinates of 1e30 no weight is exact enough to end up near the plane: the
        // coordinate that the plane bounds is what the plane says.
        let settle = |p: &mut [f64; 4]| match (0..3).find(|&axis| plane[axis] != 0.0) {
            Some(axis) => p[axis] = -(plane[3] * p[3]) / plane[axis],
            None => p[3] = W_MIN,
        };
        cut(polygon, scratch, Edge::View, distance, settle);
    }
    for plane in (0..MAX_DISTANCES).filter(|plane| user >> plane & 1 == 1) {
        cut(polygon, scratch, Edge::Made, |corner| corner.distances[plane], |_| {});
    }
}

/// Cuts away where `distance` is negative, along an edge that is `made`. `settle` puts a point between two ends on
/// the plane.
///
/// Where an edge is cut depends on nothing but its two ends and their distances, and negated
/// distances give the same point to the bit. So two primitives that share an edge are cut at the same
/// point, and the two halves that complementary planes leave of a primitive share their edge: every
/// pixel is in one of them.
fn cut(
    polygon: &mut Vec<Corner>,
    scratch: &mut Vec<Corner>,
    made: Edge,
    distance: impl Fn(&Corner) -> f64,
    settle: impl Fn(&mut [f64; 4]),
) {
    scratch.clear();
    let n = polygon.len();
    // A line has one edge, a polygon one for each vertex.
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
            // In an order that does not depend on the direction of the edge.
            let (from, to, df, dt) = if a.clip < b.clip { (a, b, da, db) } else { (b, a, db, da) };
            let t = df / (df - dt);
            let mix = |from: f64, to: f64| from + (to - from) * t;
            let mut clip = std::array::from_fn(|k| mix(from.clip[k], to.clip[k]));
            settle(&mut clip);
            scratch.push(Corner {
                clip,
                distances: std::array::from_fn(|k| mix(from.distances[k], to.distances[k])),
                weights: std::array::from_fn(|k| mix(from.weights[k], to.weights[k])),
                edge: if da >= 0.0 { made } else { a.edge },
                cut: (made == Edge::Made).then_some(a.edge),
            });
        }
    }
    std::mem::swap(polygon, scratch);
}
