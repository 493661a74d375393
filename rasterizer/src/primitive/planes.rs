//! The planes that weight the vertices of a shape, in `f64`.
//!
//! For a triangle with clip vertices `p_i`, let `l_i(x, y)` be the plane that is `1 / w_i` at the
//! window position of `p_i` and zero at the other two. Then, everywhere on the triangle,
//!
//! ```text
//! 1 / w = Σ l_i      v / w = Σ v_i l_i      z / w = Σ z_i l_i
//! ```
//!
//! (GL 2.1, equations 3.6 and 3.8, without barycentric coordinates). The coefficients of the `l_i`
//! are the rows of the inverse of the matrix whose columns are the homogeneous window positions, so
//! they hold whether or not a vertex is in front of the eye: a clipped triangle is interpolated by
//! the planes of the whole one.

use super::setup::{Clipping, Shape, ShapeKind};
use crate::desc::{
    Antialiasing, DepthTransform, Facing, LineState, PolygonOffset, SpriteOrigin, Viewport,
};
use crate::sizes::SUBPIXEL;
use crate::vertex::{Geometry, Outcode};

/// `a · (x - origin.x) + b · (y - origin.y) + c`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane {
    /// Per pixel across.
    pub a: f64,
    /// Per pixel up.
    pub b: f64,
    /// At the origin.
    pub c: f64,
}

impl Plane {
    pub fn constant(c: f64) -> Self {
        Self { a: 0.0, b: 0.0, c }
    }

    /// `Σ value_i · row_i`.
    pub fn sum(rows: &[Self; 3], values: [f64; 3]) -> Self {
        let dot = |part: fn(&Self) -> f64| {
            part(&rows[0]) * values[0] + part(&rows[1]) * values[1] + part(&rows[2]) * values[2]
        };
        Self { a: dot(|p| p.a), b: dot(|p| p.b), c: dot(|p| p.c) }
    }

    fn scaled(self, factor: f64) -> Self {
        Self { a: self.a * factor, b: self.b * factor, c: self.c * factor }
    }

    /// The same along a line from the origin, which is its first end, and constant across it.
    fn along(self, corners: &[[i32; 2]; 3], constant: ConstantDirection) -> Self {
        let [from, to, _] = corners;
        let direction = [0, 1].map(|axis| f64::from(to[axis]) - f64::from(from[axis]));
        let [x, y] = constant.vector(direction, corners);
        let square = x * x + y * y;
        let slope = if square > 0.0 {
            (self.a * direction[0] + self.b * direction[1]) / square
        } else {
            0.0
        };
        Self { a: slope * y, b: slope * -x, c: self.c }
    }

    pub fn is_finite(self) -> bool {
        self.a.is_finite() && self.b.is_finite() && self.c.is_finite()
    }
}

/// The direction in which the interpolated values of a line are constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConstantDirection {
    /// At right angles to it (GL 2.1, equation 3.5).
    Perpendicular,
    /// Along its minor axis, as a wide line's columns are one fragment, replicated (section 3.4.2).
    MinorAxis,
}

impl ConstantDirection {
    /// For lines of a state.
    pub fn of(line: &LineState) -> Self {
        match line.antialiasing {
            Antialiasing::Aliased if line.drawn_width() > 1.0 => Self::MinorAxis,
            Antialiasing::Aliased | Antialiasing::Smooth => Self::Perpendicular,
        }
    }

    /// The direction without change, of a line between `corners` that runs `along`.
    fn vector(self, along: [f64; 2], corners: &[[i32; 2]; 3]) -> [f64; 2] {
        let mut vector = [-along[1], along[0]];
        let direction = [0, 1].map(|axis| corners[1][axis].abs_diff(corners[0][axis]));
        match self {
            Self::Perpendicular => {}
            Self::MinorAxis => vector[usize::from(direction[1] > direction[0])] = 0.0,
        }
        vector
    }
}

/// What the depth of the shapes of a draw depends on.
#[derive(Clone, Copy, Debug)]
pub struct DepthSetup {
    /// The viewport.
    pub viewport: Viewport,
    /// Moves the depth of filled polygons.
    pub offset: Option<PolygonOffset>,
    /// The smallest resolvable difference of depth; `None` for floating-point depth.
    pub resolution: Option<f64>,
}

/// The planes that weight the three vertices.
pub struct VertexPlanes {
    /// `l_i`: sums to `1/w`.
    projective: [Plane; 3],
    /// Weights of a smooth varying, before it is divided by `denominator`.
    pub smooth: [Plane; 3],
    /// Weights that sum to 1: linear in the window.
    pub linear: [Plane; 3],
    pub denominator: Plane,
    pub inverse_w: Plane,
}

impl VertexPlanes {
    pub fn new(
        shape: &Shape,
        geometry: &Geometry,
        viewport: &Viewport,
        origin: [f64; 2],
        constant: ConstantDirection,
    ) -> Self {
        let mut w = shape.vertices.map(|v| f64::from(geometry.clip(v)[3]));
        if let (ShapeKind::Line { .. }, Clipping::Whole) = (shape.kind, shape.clipping) {
            // Its third vertex has no weight.
            w[2] = w[1];
        }
        let projective = match (shape.kind, shape.clipping) {
            (ShapeKind::Triangle, _) => triangle(shape, geometry, viewport, origin),
            (ShapeKind::Line { .. }, Clipping::Whole) => {
                line(shape, geometry, viewport, origin, constant)
            }
            (ShapeKind::Line { .. }, Clipping::Cut) => {
                let along = |row: Plane| row.along(&shape.corners, constant);
                triangle(shape, geometry, viewport, origin).map(along)
            }
            (ShapeKind::Point { .. }, Clipping::Whole) => {
                [Plane::constant(1.0 / w[0]), Plane::default(), Plane::default()]
            }
            // What the triangle has there, all over the point.
            (ShapeKind::Point { .. }, Clipping::Cut) => {
                triangle(shape, geometry, viewport, origin).map(|row| Plane::constant(row.c))
            }
        };
        let inverse_w = Plane::sum(&projective, [1.0; 3]);
        let in_front = w.iter().all(|&w| w > 0.0);
        let linear = [0, 1, 2].map(|i| projective[i].scaled(w[i]));
        // The same `w` everywhere: nothing to divide by. (Its plane is constant up to noise.)
        if w[0] == w[1] && w[0] == w[2] {
            return Self {
                projective,
                smooth: linear,
                linear,
                denominator: Plane::constant(1.0),
                inverse_w: Plane::constant(1.0 / w[0]),
            };
        }
        Self {
            projective,
            smooth: projective,
            // Linear in the window means nothing for a triangle that reaches behind the eye.
            linear: if in_front { linear } else { projective },
            denominator: inverse_w,
            inverse_w,
        }
    }

    /// Window depth (GL 2.1, section 2.11.1), moved by the polygon offset (section 3.5.5).
    pub fn depth(&self, setup: &DepthSetup, shape: &Shape, geometry: &Geometry) -> Plane {
        let z = shape.vertices.map(|v| f64::from(geometry.clip(v)[2]));
        let DepthTransform { scale, bias } = setup.viewport.depth_transform();
        let mut plane = Plane::sum(&self.projective, z).scaled(scale);
        plane.c += bias;
        plane.c += match (shape.kind, setup.offset) {
            (ShapeKind::Triangle, Some(by)) => offset(&plane, &shape.corners, by, setup.resolution),
            (ShapeKind::Triangle, None) => 0.0,
            (ShapeKind::Line { bias, .. } | ShapeKind::Point { bias, .. }, _) => bias.into(),
        };
        plane
    }
}

/// `gl_PointCoord` over a point whose centre is the origin (GL 2.1, equations 3.3 and 3.4).
pub fn point_coord(axis: u8, size: f32, origin: SpriteOrigin) -> Plane {
    let per = 1.0 / f64::from(size);
    match (axis, origin) {
        (0, _) => Plane { a: per, b: 0.0, c: 0.5 },
        (_, SpriteOrigin::UpperLeft) => Plane { a: 0.0, b: -per, c: 0.5 },
        (_, SpriteOrigin::LowerLeft) => Plane { a: 0.0, b: per, c: 0.5 },
    }
}

/// What moves the depth of a triangle (GL 2.1, section 3.5.5).
fn offset(
    plane: &Plane,
    corners: &[[i32; 2]; 3],
    by: PolygonOffset,
    resolution: Option<f64>,
) -> f64 {
    let slope = plane.a.abs().max(plane.b.abs());
    let r = resolution.unwrap_or_else(|| {
        // The exponent of the largest depth of the triangle.
        let largest = corners.iter().fold(0.0_f64, |largest, corner| {
            let dx = f64::from(corner[0] - corners[0][0]) / f64::from(SUBPIXEL);
            let dy = f64::from(corner[1] - corners[0][1]) / f64::from(SUBPIXEL);
            largest.max((dx * plane.a + dy * plane.b + plane.c).abs())
        });
        let exponent = (largest as f32).to_bits() & 0x7F80_0000;
        f64::from(f32::from_bits(exponent)) / 8_388_608.0
    });
    let sum = f64::from(by.factor) * slope + f64::from(by.units) * r;
    let clamp = f64::from(by.clamp);
    if clamp > 0.0 && sum > clamp || clamp < 0.0 && sum < clamp { clamp } else { sum }
}

/// What the polygon offset adds to the depth of a triangle that is drawn as lines or points.
pub fn depth_offset(
    viewport: &Viewport,
    by: PolygonOffset,
    resolution: Option<f64>,
    geometry: &Geometry,
    vertices: [u32; 3],
) -> f32 {
    let corners = vertices.map(|v| geometry.snapped[v as usize]);
    let is_cut = vertices.iter().any(|&v| geometry.outcode(v).0 & Outcode::CUT != 0);
    let shape = Shape {
        corners,
        bounds: [[0; 2]; 2],
        vertices,
        provoking: 0,
        clipping: if is_cut { Clipping::Cut } else { Clipping::Whole },
        kind: ShapeKind::Triangle,
        facing: Facing::Front,
    };
    let origin = corners[0].map(|v| f64::from(v) / f64::from(SUBPIXEL));
    let rows =
        VertexPlanes::new(&shape, geometry, viewport, origin, ConstantDirection::Perpendicular);
    let setup = DepthSetup { viewport: *viewport, offset: None, resolution };
    let plane = rows.depth(&setup, &shape, geometry);
    let offset = offset(&plane, &corners, by, resolution);
    if offset.is_finite() { offset as f32 } else { 0.0 }
}

/// The homogeneous window position of a vertex, relative to the origin.
fn homogeneous(clip: [f32; 4], viewport: &Viewport, origin: [f64; 2]) -> [f64; 3] {
    let [x, y, _, w] = clip.map(f64::from);
    let (half, center) = (viewport.half(), viewport.center());
    [x * half[0] + w * (center[0] - origin[0]), y * half[1] + w * (center[1] - origin[1]), w]
}

/// The `l_i` of a triangle. A triangle thinner than the subpixel grid can show is interpolated over
/// the corners it was snapped to, so that no pixel it covers lies far outside its values.
fn triangle(
    shape: &Shape,
    geometry: &Geometry,
    viewport: &Viewport,
    origin: [f64; 2],
) -> [Plane; 3] {
    let clip = shape.vertices.map(|v| geometry.clip(v));
    let inverse = InverseMatrix::of(clip.map(|clip| homogeneous(clip, viewport, origin)));
    if shape.clipping == Clipping::Cut || inverse.is_thick() {
        return inverse.rows();
    }
    let w = clip.map(|clip| f64::from(clip[3]));
    let snapped = shape.vertices.map(|v| geometry.snapped[v as usize]);
    let snapped = snapped.map(|v| v.map(|v| f64::from(v) / f64::from(SUBPIXEL)));
    let q = [0, 1, 2].map(|i| [(snapped[i][0] - origin[0]), (snapped[i][1] - origin[1]), 1.0]);
    let rows = InverseMatrix::of(q).rows();
    [0, 1, 2].map(|i| rows[i].scaled(1.0 / w[i]))
}

/// The inverse of the matrix whose columns are homogeneous positions.
pub struct InverseMatrix {
    positions: [[f64; 3]; 3],
    /// Row `i` is 0 at the other two positions,
    pub adjugate: [[f64; 3]; 3],
    /// and this at position `i`.
    determinant: f64,
}

impl InverseMatrix {
    #[inline(always)]
    pub fn of(positions: [[f64; 3]; 3]) -> Self {
        let [p, q, r] = positions;
        let adjugate = [cross(q, r), cross(r, p), cross(p, q)];
        let determinant = p[0] * adjugate[0][0] + p[1] * adjugate[0][1] + p[2] * adjugate[0][2];
        Self { positions, adjugate, determinant }
    }

    /// What the adjugate is multiplied by. (Of numbers that were `f32` it does not overflow.)
    #[inline(always)]
    pub fn scale(&self) -> f64 {
        1.0 / self.determinant
    }

    /// Whether the altitude over the longest side is an eighth of a pixel at least. Of the triangle in the window,
    /// the doubled area is `determinant / (w_0 w_1 w_2)`, the side from i to j `(p_i w_j - p_j w_i) / (w_i w_j)`:
    /// all are compared times `w_0 w_1 w_2`, so that nothing is divided.
    #[inline(always)]
    pub fn is_thick(&self) -> bool {
        let [p, q, r] = self.positions;
        let area = 64.0 * (self.determinant * self.determinant);
        (area >= squared_side(p, q, r[2]))
            & (area >= squared_side(p, r, q[2]))
            & (area >= squared_side(q, r, p[2]))
    }

    fn rows(&self) -> [Plane; 3] {
        let scale = self.scale();
        self.adjugate.map(|[a, b, c]| Plane { a: a * scale, b: b * scale, c: c * scale })
    }
}

#[inline(always)]
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The square of the side between two homogeneous positions, times those of their `w` and of the third's.
#[inline(always)]
fn squared_side(from: [f64; 3], to: [f64; 3], third: f64) -> f64 {
    let (x, y) = (from[0] * to[2] - to[0] * from[2], from[1] * to[2] - to[1] * from[2]);
    (x * x + y * y) * (third * third)
}

/// The direction of a line in the window, of length 1, either way; 0 of other shapes, and of a line without one.
pub fn line_direction(shape: &Shape, geometry: &Geometry, viewport: &Viewport) -> [f64; 2] {
    let [x, y] = match (shape.kind, shape.clipping) {
        (ShapeKind::Triangle | ShapeKind::Point { .. }, _) => return [0.0; 2],
        (ShapeKind::Line { .. }, Clipping::Whole) => {
            let [from, to] = [0, 1].map(|end| geometry.clip(shape.vertices[end]));
            along(homogeneous(from, viewport, [0.0; 2]), homogeneous(to, viewport, [0.0; 2]))
        }
        (ShapeKind::Line { .. }, Clipping::Cut) => {
            let [from, to, _] = shape.corners;
            [0, 1].map(|axis| f64::from(to[axis]) - f64::from(from[axis]))
        }
    };
    let length = (x * x + y * y).sqrt();
    if length > 0.0 && length.is_finite() { [x / length, y / length] } else { [0.0; 2] }
}

/// From one homogeneous position to another in the window, times the product of their `w`.
fn along(from: [f64; 3], to: [f64; 3]) -> [f64; 2] {
    [to[0] * from[2] - from[0] * to[2], to[1] * from[2] - from[1] * to[2]]
}

/// The weights of a line: constant across it, so that `l_0 + l_1 = 1/w` along it (GL 2.1, equations
/// 3.5 and 3.6).
fn line(
    shape: &Shape,
    geometry: &Geometry,
    viewport: &Viewport,
    origin: [f64; 2],
    constant: ConstantDirection,
) -> [Plane; 3] {
    let ends = [0, 1].map(|i| homogeneous(geometry.clip(shape.vertices[i]), viewport, origin));
    // A third point off the line, whose own weight is left out: at infinity, across it.
    let [x, y] = constant.vector(along(ends[0], ends[1]), &shape.corners);
    let rows = InverseMatrix::of([ends[0], ends[1], [x, y, 0.0]]).rows();
    [rows[0], rows[1], Plane::default()]
}
