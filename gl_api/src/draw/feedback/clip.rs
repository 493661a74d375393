//! Clipping of primitives in homogeneous coordinates (GL 2.1, section 2.12), in `f64`. Values between two vertices are
//! interpolated linearly there (section 2.14.8).

use rasterizer::driver::{ClipDepth, DepthClip};
use std::borrow::Cow;

/// The number of user clip planes.
const USER_PLANES: usize = 8;
/// The planes of the view volume, then the user clip planes.
const PLANES: usize = 6 + USER_PLANES;

/// A vertex before the division by w.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Vertex {
    pub clip: [f64; 4],
    /// The distances from the user clip planes; 1 for those that are off.
    pub distances: [f64; USER_PLANES],
    /// Its negative cull distances, bit by number.
    pub culled: u8,
    /// Colour of the front, of the back, texture coordinates of unit 0.
    pub values: [[f64; 4]; 3],
    /// Whether the edge that begins here is one of the polygon's.
    pub edge: bool,
    pub depth_planes: DepthPlanes,
}

/// The near and the far plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum DepthPlanes {
    /// They clip nothing.
    Clamp,
    /// z from -w to w.
    NegativeOneToOne,
    /// z from 0 to w.
    ZeroToOne,
}

impl DepthPlanes {
    pub fn of(clip: DepthClip, depth: ClipDepth) -> Self {
        match (clip, depth) {
            (DepthClip::Clamp, _) => Self::Clamp,
            (DepthClip::Cut, ClipDepth::NegativeOneToOne) => Self::NegativeOneToOne,
            (DepthClip::Cut, ClipDepth::ZeroToOne) => Self::ZeroToOne,
        }
    }
}

impl Vertex {
    /// The distance from a plane, positive inside.
    fn inside(&self, plane: usize) -> f64 {
        let [x, y, z, w] = self.clip;
        match plane {
            0 => w + x,
            1 => w - x,
            2 => w + y,
            3 => w - y,
            4 => match self.depth_planes {
                DepthPlanes::Clamp => 1.0,
                DepthPlanes::NegativeOneToOne => w + z,
                DepthPlanes::ZeroToOne => z,
            },
            5 => match self.depth_planes {
                DepthPlanes::Clamp => 1.0,
                DepthPlanes::NegativeOneToOne | DepthPlanes::ZeroToOne => w - z,
            },
            _ => self.distances[plane - 6],
        }
    }

    /// The intersection of the line to another vertex with a plane.
    fn intersect(&self, to: &Self, plane: usize) -> Self {
        let (here, there) = (self.inside(plane), to.inside(plane));
        let part = here / (here - there);
        let mix = |a: f64, b: f64| a + (b - a) * part;
        let four = |a: [f64; 4], b: [f64; 4]| std::array::from_fn(|i| mix(a[i], b[i]));
        Self {
            clip: four(self.clip, to.clip),
            distances: std::array::from_fn(|i| mix(self.distances[i], to.distances[i])),
            values: std::array::from_fn(|i| four(self.values[i], to.values[i])),
            culled: 0,
            edge: self.edge,
            depth_planes: self.depth_planes,
        }
    }
}

/// Whether a cull distance is negative at all vertices of a primitive (ARB_cull_distance).
pub(crate) fn is_culled(vertices: &[Vertex]) -> bool {
    vertices.iter().fold(!0, |all, vertex| all & vertex.culled) != 0
}

/// Whether a point is inside of all planes; one with a coordinate that is NaN is not.
pub(crate) fn is_inside(point: &Vertex) -> bool {
    (0..PLANES).all(|plane| point.inside(plane) >= 0.0)
}

/// The part of a line that is inside, if any.
pub(crate) fn line([mut a, mut b]: [Vertex; 2]) -> Option<[Vertex; 2]> {
    for plane in 0..PLANES {
        match (a.inside(plane) >= 0.0, b.inside(plane) >= 0.0) {
            (true, true) => {}
            (true, false) => b = a.intersect(&b, plane),
            (false, true) => a = a.intersect(&b, plane),
            (false, false) => return None,
        }
    }
    Some([a, b])
}

/// The part of a polygon that is inside; no corners where there is none. The edges that clipping
/// makes are edges of the polygon.
pub(crate) fn polygon(corners: Cow<'_, [Vertex]>) -> Cow<'_, [Vertex]> {
    match corners.iter().all(is_inside) {
        true => corners,
        false => Cow::Owned(cut(corners.into_owned())),
    }
}

/// As [`polygon`], plane by plane.
fn cut(corners: Vec<Vertex>) -> Vec<Vertex> {
    (0..PLANES).fold(corners, |corners, plane| {
        let mut inside = Vec::with_capacity(corners.len() + 1);
        for (at, corner) in corners.iter().enumerate() {
            let next = &corners[(at + 1) % corners.len()];
            let is_in = corner.inside(plane) >= 0.0;
            if is_in {
                inside.push(*corner);
            }
            match (is_in, next.inside(plane) >= 0.0) {
                (true, false) => {
                    inside.push(Vertex { edge: true, ..corner.intersect(next, plane) })
                }
                (false, true) => inside.push(corner.intersect(next, plane)),
                (true, true) | (false, false) => {}
            }
        }
        inside
    })
}

#[cfg(test)]
mod tests {
    use crate::draw::feedback::clip::*;

    fn at(x: f64, y: f64) -> Vertex {
        let values = [[x, y, 0.0, 1.0]; 3];
        let depth_planes = DepthPlanes::NegativeOneToOne;
        let (clip, distances) = ([x, y, 0.0, 1.0], [1.0; 8]);
        Vertex { clip, distances, culled: 0, values, edge: true, depth_planes }
    }

    #[test]
    fn a_triangle_through_a_side_loses_a_corner_and_gains_an_edge() {
        let clipped = polygon(vec![at(0.0, 0.0), at(2.0, 0.0), at(0.0, 0.5)].into());
        let corners: Vec<_> = clipped.iter().map(|v| [v.clip[0], v.clip[1]]).collect();
        assert_eq!(corners, [[0.0, 0.0], [1.0, 0.0], [1.0, 0.25], [0.0, 0.5]]);
        assert!(clipped.iter().all(|v| v.values[0] == v.clip), "values move with the corners");
        assert!(polygon(vec![at(2.0, 0.0), at(3.0, 0.0), at(2.0, 1.0)].into()).is_empty());
    }

    #[test]
    fn what_is_inside_of_every_plane_is_what_cutting_leaves() {
        let at = |x, y| Vertex { edge: x == 0.0, ..at(x, y) };
        for corners in [vec![at(0.0, 0.0), at(1.0, 0.25), at(-1.0, 1.0), at(0.0, -0.5)], vec![]] {
            assert_eq!(cut(corners.clone()), corners);
            assert_eq!(polygon(corners.clone().into()).into_owned(), corners);
        }
    }

    #[test]
    fn lines_and_points_are_cut_at_every_plane() {
        let cut = line([at(-3.0, 0.0), at(3.0, 0.0)]).expect("it crosses the volume");
        assert_eq!(cut.map(|v| v.clip[0]), [-1.0, 1.0]);
        assert_eq!(line([at(-3.0, 2.0), at(3.0, 2.0)]), None);
        assert!(is_inside(&at(1.0, 1.0)));
        assert!(!is_inside(&at(1.5, 0.0)));
        assert!(!is_inside(&at(f64::NAN, 0.0)));
        let mut behind = at(0.0, 0.0);
        behind.distances[3] = -1.0;
        assert!(!is_inside(&behind), "planes of the user count");
    }
}
