//! How depth and varyings run over a shape: plane equations in `f64`.
//!
//! A value at a pixel is `(corner + dx · A) + dy · B` in `f32`, where `corner` is the plane in `f64`
//! at the first pixel of the screen-aligned 8×8 block, and `dx`, `dy` count pixels within it.

use crate::desc::SpriteOrigin;
use crate::ir::Axis;
use crate::plan::PlaneSource;
use crate::primitive::{
    ConstantDirection, DepthSetup, Plane, Shape, ShapeKind, VertexPlanes, line_direction,
    point_coord,
};
use crate::sizes::SUBPIXEL;
use crate::vertex::Geometry;

/// The state of a draw that the planes of its shapes depend on.
#[derive(Clone, Copy, Debug)]
pub struct PlaneSetup<'a> {
    /// Which planes.
    pub sources: &'a [PlaneSource],
    /// How depth is computed.
    pub depth: DepthSetup,
    /// Where t is 0 in a point.
    pub origin: SpriteOrigin,
    /// The direction in which the values of lines are constant.
    pub line_constant: ConstantDirection,
}

/// The planes of a shape.
#[derive(Debug, Default)]
pub struct Planes {
    /// The origin of the planes, in pixels.
    pub origin: [f64; 2],
    /// In the order of [`PlaneSetup::sources`].
    pub planes: Vec<Plane>,
}

impl Planes {
    /// Computes the planes of `shape`.
    #[inline(never)]
    pub fn compute(&mut self, setup: &PlaneSetup<'_>, geometry: &Geometry, shape: &Shape) {
        self.origin = match shape.kind {
            ShapeKind::Triangle | ShapeKind::Line { .. } => {
                shape.corners[0].map(|v| f64::from(v) / f64::from(SUBPIXEL))
            }
            ShapeKind::Point { .. } => shape.centre(geometry, &setup.depth.viewport),
        };
        let rows = VertexPlanes::new(
            shape,
            geometry,
            &setup.depth.viewport,
            self.origin,
            setup.line_constant,
        );
        let varyings = shape.vertices.map(|v| geometry.varyings_of(v));
        let provoking = varyings[usize::from(shape.provoking)];
        let values = |at: usize| [0, 1, 2].map(|i| f64::from(varyings[i][at]));
        self.planes.clear();
        for source in setup.sources {
            let plane = match *source {
                PlaneSource::Depth => rows.depth(&setup.depth, shape, geometry),
                PlaneSource::Denominator => rows.denominator,
                PlaneSource::InverseW => rows.inverse_w,
                PlaneSource::Smooth(at) => Plane::sum(&rows.smooth, values(at)),
                PlaneSource::NoPerspective(at) => Plane::sum(&rows.linear, values(at)),
                PlaneSource::Flat(at) => Plane::constant(f64::from(provoking[at])),
                PlaneSource::SmoothOfSides(sides) => {
                    Plane::sum(&rows.smooth, values(sides[shape.facing as usize]))
                }
                PlaneSource::FlatOfSides(sides) => {
                    Plane::constant(f64::from(provoking[sides[shape.facing as usize]]))
                }
                PlaneSource::PointCoord(axis) => match shape.kind {
                    ShapeKind::Point { size, .. } => point_coord(axis, size, setup.origin),
                    ShapeKind::Triangle | ShapeKind::Line { .. } => Plane::constant(0.0),
                },
                PlaneSource::LineDirection(axis) => {
                    let [x, y] = line_direction(shape, geometry, &setup.depth.viewport);
                    Plane::constant(match axis {
                        Axis::X => x,
                        Axis::Y => y,
                    })
                }
                PlaneSource::Sprite(at, component) => match (shape.kind, component) {
                    (ShapeKind::Point { size, .. }, 0 | 1) => {
                        point_coord(component, size, setup.origin)
                    }
                    (ShapeKind::Point { .. }, _) => Plane::constant(f64::from(component - 2)),
                    (ShapeKind::Triangle | ShapeKind::Line { .. }, _) => {
                        Plane::sum(&rows.smooth, values(at))
                    }
                },
            };
            // A shape so thin that its planes overflow has the value of its provoking vertex.
            self.planes.push(if plane.is_finite() {
                plane
            } else {
                Plane::constant(match *source {
                    PlaneSource::Smooth(at)
                    | PlaneSource::NoPerspective(at)
                    | PlaneSource::Sprite(at, _)
                    | PlaneSource::Flat(at) => f64::from(provoking[at]),
                    PlaneSource::SmoothOfSides(sides) | PlaneSource::FlatOfSides(sides) => {
                        f64::from(provoking[sides[shape.facing as usize]])
                    }
                    PlaneSource::Denominator | PlaneSource::InverseW => 1.0,
                    PlaneSource::Depth
                    | PlaneSource::PointCoord(_)
                    | PlaneSource::LineDirection(_) => 0.0,
                })
            });
        }
    }
}
