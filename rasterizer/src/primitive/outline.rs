//! Lines and points (GL 2.1, sections 3.3 and 3.4), and polygons that are drawn as such (section
//! 3.5.4).

use super::clip::{Corner, Edge};
use super::line::LineFragments;
use super::planes::depth_offset;
use super::setup::{Clipping, EMPTY_BOUNDS, Scratch, Setup, Shape, ShapeKind, bounds, snap};
use crate::desc::{
    Antialiasing, Facing, LineState, MAX_POINT_SIZE, PointState, PolygonMode, ViewSides,
};
use crate::sizes::SUBPIXEL;
use crate::vertex::{EdgeFlags, Geometry, Outcode};

/// A triangle that may be drawn as lines or points.
pub(super) struct PolygonTriangle {
    pub vertices: [u32; 3],
    pub provoking: u8,
    /// Which edges are edges of its polygon, bit by their first vertex.
    pub edges: u8,
}

/// A line of a primitive.
pub(super) struct Line {
    /// Its ends, and another that may provoke.
    pub vertices: [u32; 3],
    pub provoking: u8,
    pub facing: Facing,
    /// Added to depth.
    pub bias: f32,
}

impl Setup<'_> {
    /// The boundary edges of a triangle as lines, or the vertices where they begin as points; where user clip planes
    /// cut it, the edges that the cuts make too (section 2.12).
    pub(super) fn outline(
        &self,
        geometry: &Geometry,
        outline: &PolygonTriangle,
        facing: Facing,
        scratch: &mut Scratch,
        out: &mut Vec<Shape>,
    ) {
        let &PolygonTriangle { vertices, provoking, edges } = outline;
        let polygon = &self.raster.polygon;
        let mode = polygon.mode[facing as usize];
        let bias = polygon.offset[mode as usize].map_or(0.0, |offset| {
            depth_offset(&self.viewport, offset, self.resolution, geometry, vertices)
        });
        let is_boundary_edge = |i: usize| match self.edge_flags {
            EdgeFlags::AllSet => true,
            EdgeFlags::ByVertex => geometry.begins_boundary(vertices[i]),
        };
        for i in 0..3 {
            let from = vertices[i];
            if edges >> i & 1 == 0 || !is_boundary_edge(i) {
                continue;
            }
            match mode {
                PolygonMode::Point => self.point(geometry, from, facing, bias, out),
                PolygonMode::Line | PolygonMode::Fill => {
                    let vertices = [from, vertices[(i + 1) % 3], vertices[usize::from(provoking)]];
                    self.line(
                        geometry,
                        &Line { vertices, provoking: 2, facing, bias },
                        scratch,
                        out,
                    );
                }
            }
        }
        let any = vertices.iter().fold(0, |any, &v| any | geometry.outcode(v).0);
        if any & Outcode::USER == 0 {
            return;
        }
        self.cut(geometry, &vertices, Outcode(any), scratch);
        let corners = scratch.polygon.iter().zip(&scratch.snapped);
        for (at, (corner, &from)) in corners.enumerate() {
            let (bounds, clipping) = (EMPTY_BOUNDS, Clipping::Cut);
            match mode {
                PolygonMode::Line if corner.edge == Edge::Made => {
                    let to = scratch.snapped[(at + 1) % scratch.snapped.len()];
                    let kind = ShapeKind::Line { stipple: 0, bias };
                    let corners = [from, to, to];
                    let edge =
                        Shape { corners, bounds, vertices, provoking, clipping, kind, facing };
                    self.segment(edge, out);
                }
                PolygonMode::Point if is_vertex(corner, edges, is_boundary_edge) => {
                    let derived = self.size_at(geometry, vertices, corner.weights);
                    let (size, fade) = drawn_size(&self.raster.point, derived);
                    let (kind, corners) = (ShapeKind::Point { size, bias, fade }, [from; 3]);
                    let point =
                        Shape { corners, bounds, vertices, provoking, clipping, kind, facing };
                    let [x, y, _, w] = corner.clip;
                    if x.abs() <= w && y.abs() <= w {
                        self.disc(point, self.viewport.window(&corner.clip), size, out);
                    }
                }
                PolygonMode::Line | PolygonMode::Point | PolygonMode::Fill => {}
            }
        }
    }

    /// The size of a point that is so much of each of three vertices.
    fn size_at(&self, geometry: &Geometry, vertices: [u32; 3], weights: [f64; 3]) -> f32 {
        let state = &self.raster.point;
        let mut sum = 0.0;
        for (vertex, weight) in vertices.into_iter().zip(weights) {
            sum += weight * f64::from(geometry.point_size(vertex).unwrap_or(state.size));
        }
        sum as f32
    }

    /// The sides of the view volume beyond which nothing is seen of lines and points.
    pub(super) fn outside_for_outlines(&self) -> u32 {
        match self.raster.sides {
            ViewSides::Clip => Outcode::OUTSIDE,
            ViewSides::Bound => Outcode::NEAR | Outcode::FAR | Outcode::BEHIND,
        }
    }

    /// A line.
    pub(super) fn line(
        &self,
        geometry: &Geometry,
        line: &Line,
        scratch: &mut Scratch,
        out: &mut Vec<Shape>,
    ) {
        let ends = [line.vertices[0], line.vertices[1]];
        let [a, b] = ends.map(|v| geometry.outcode(v).0);
        let (any, every) = (a | b, a & b);
        if every & self.outside_for_outlines() != 0 || any & Outcode::INVALID != 0 {
            return;
        }
        let mut corners = ends.map(|v| geometry.snapped[v as usize]);
        if any & Outcode::CUT != 0 {
            self.cut(geometry, &ends, Outcode(any), scratch);
            let &[a, b] = scratch.snapped.as_slice() else { return };
            corners = [a, b];
        }
        let shape = Shape {
            corners: [corners[0], corners[1], corners[1]],
            bounds: EMPTY_BOUNDS,
            vertices: line.vertices,
            provoking: line.provoking,
            clipping: Clipping::Whole,
            kind: ShapeKind::Line { stipple: 0, bias: line.bias },
            facing: line.facing,
        };
        self.segment(shape, out);
    }

    /// A line between the corners of a shape.
    fn segment(&self, shape: Shape, out: &mut Vec<Shape>) {
        let [a, b, _] = shape.corners;
        let mut ends = [a, b];
        if self.raster.line.antialiasing == Antialiasing::Smooth
            && self.raster.sides == ViewSides::Clip
        {
            let Some(cut) = self.cut_to_view(ends) else { return };
            ends = cut;
        }
        let bounds = match self.line_bounds(ends) {
            Some(bounds) => bounds,
            // The stipple advances across the edges of the scissor and of the image.
            None if self.raster.line.stipple.is_some() => {
                let drawable_area = [[i32::MIN / 2; 2], [i32::MAX / 2; 2]];
                let unbounded =
                    Setup { drawable_area, area_in_viewport: self.viewport.pixels(), ..*self };
                if unbounded.line_bounds(ends).is_none() {
                    return;
                }
                EMPTY_BOUNDS
            }
            None => return,
        };
        out.push(Shape { corners: [ends[0], ends[1], ends[1]], bounds, ..shape });
    }

    /// The part of a smooth line in the view volume, where its ends leave that at a side: what is cut off is no part
    /// of the rectangle that it becomes (section 2.12). Aliased lines keep their ends, which say what their columns
    /// hold: [`Self::line_bounds`] leaves columns out.
    fn cut_to_view(&self, ends: [[i32; 2]; 2]) -> Option<[[i32; 2]; 2]> {
        let viewport = &self.viewport;
        let sides = [(viewport.x, viewport.width), (viewport.y, viewport.height)];
        let [from, to] = ends.map(|end| end.map(f64::from));
        // The parameters between the ends at which it enters and leaves.
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        for (axis, (start, size)) in sides.into_iter().enumerate() {
            let low = f64::from(start) * f64::from(SUBPIXEL);
            let high = low + f64::from(size) * f64::from(SUBPIXEL);
            let direction = to[axis] - from[axis];
            if direction == 0.0 {
                if from[axis] < low || from[axis] > high {
                    return None;
                }
                continue;
            }
            let [a, b] = [low, high].map(|side| (side - from[axis]) / direction);
            enters = enters.max(a.min(b));
            leaves = leaves.min(a.max(b));
        }
        if enters == 0.0 && leaves == 1.0 {
            return Some(ends);
        }
        let at = |part: f64| [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part);
        (enters < leaves).then(|| [enters, leaves].map(|part| at(part).map(|v| v.round() as i32)))
    }

    /// The pixels that a line may cover. A line that ends at a side of the view volume which clips is as wide
    /// outside it as inside (section 2.12), so along its minor axis more than the viewport counts; but
    /// of the columns only those whose middle is inside.
    fn line_bounds(&self, [a, b]: [[i32; 2]; 2]) -> Option<[[u16; 2]; 2]> {
        let state = &self.raster.line;
        let width = state.drawn_width();
        let sides = self.raster.sides;
        let extend = |mut area: [[i32; 2]; 2], axis: usize| {
            let margin = match sides {
                ViewSides::Clip => (width * 0.5).ceil() as i32,
                ViewSides::Bound => 0,
            };
            area[0][axis] = (area[0][axis] - margin).max(self.drawable_area[0][axis]);
            area[1][axis] = (area[1][axis] + margin).min(self.drawable_area[1][axis]);
            area
        };
        match state.antialiasing {
            Antialiasing::Aliased => {
                let run = LineFragments::new(a, b, width as i32);
                if run.first > run.last {
                    return None;
                }
                let (major, minor) = (run.major, 1 - run.major);
                let area = extend(self.area_in_viewport, minor);
                let [view, end] = self.viewport.pixels().map(|pixel| pixel[minor]);
                let is_inside = |p: [i32; 2]| (view..end).contains(&p[minor].div_euclid(SUBPIXEL));
                let mut columns = [run.first, run.last];
                if sides == ViewSides::Clip && !(is_inside(a) && is_inside(b)) {
                    columns = LineFragments::new(a, b, 1).columns_within(columns, view..end)?;
                }
                let [first, last] = columns;
                let rows = [run.row(first), run.row(last)];
                let low = [first, rows[0].min(rows[1])];
                let high = [last, rows[0].max(rows[1]) + width as i32 - 1];
                let mut out = [[0; 2]; 2];
                for (from, axis) in [major, minor].into_iter().enumerate() {
                    let first = low[from].max(area[0][axis]);
                    let last = high[from].min(area[1][axis] - 1);
                    if first > last {
                        return None;
                    }
                    (out[0][axis], out[1][axis]) = (first as u16, last as u16);
                }
                Some(out)
            }
            Antialiasing::Smooth => {
                if a == b {
                    return None;
                }
                let reach = (width * 0.5 * SUBPIXEL as f32).ceil() as i32;
                let around = |p: [i32; 2], by: i32| [p[0] + by, p[1] + by];
                let corners =
                    [around(a, reach), around(a, -reach), around(b, reach), around(b, -reach)];
                bounds(&corners, Antialiasing::Smooth, &extend(extend(self.area_in_viewport, 0), 1))
            }
        }
    }

    /// A point. Where the sides of the view volume clip, it is drawn whole if its centre is inside (section 2.12).
    pub(super) fn point(
        &self,
        geometry: &Geometry,
        vertex: u32,
        facing: Facing,
        bias: f32,
        out: &mut Vec<Shape>,
    ) {
        let dropped =
            self.outside_for_outlines() | Outcode::INVALID | Outcode::GUARD | Outcode::USER;
        if geometry.outcode(vertex).0 & dropped != 0 {
            return;
        }
        let state = &self.raster.point;
        let derived = geometry.point_size(vertex).unwrap_or(state.size);
        let (size, fade) = drawn_size(state, derived);
        let point = Shape {
            corners: [geometry.snapped[vertex as usize]; 3],
            bounds: EMPTY_BOUNDS,
            vertices: [vertex; 3],
            provoking: 0,
            clipping: Clipping::Whole,
            kind: ShapeKind::Point { size, bias, fade },
            facing,
        };
        self.disc(point, geometry.window(&self.viewport, vertex), size, out);
    }

    /// A point of this size about a place in the window.
    fn disc(&self, point: Shape, centre: [f64; 2], size: f32, out: &mut Vec<Shape>) {
        let state = &self.raster.point;
        let low = point_corner(state, centre, size);
        let high = low.map(|v| v + f64::from(size));
        // A smooth disc touches pixels beyond the subpixel that its square ends in.
        let antialiasing =
            if state.sprite.is_some() { Antialiasing::Aliased } else { state.antialiasing };
        let reach = i32::from(antialiasing == Antialiasing::Smooth);
        let (low, high) = (snap(low).map(|v| v - reach), snap(high).map(|v| v + reach));
        // The upper edge and the left one are inside, as of polygons.
        let corners = match antialiasing {
            Antialiasing::Aliased => [[low[0], low[1] + 1], [high[0] - 1, high[1]]],
            Antialiasing::Smooth => [low, high],
        };
        let area = match self.raster.sides {
            ViewSides::Clip => &self.drawable_area,
            ViewSides::Bound => &self.area_in_viewport,
        };
        let Some(bounds) = bounds(&corners, antialiasing, area) else { return };
        out.push(Shape { bounds, ..point });
    }
}

/// Whether a corner that a user clip plane makes is a vertex of the polygon, and not only of one of its triangles.
/// A corner where a cut edge begins is one; a corner on an edge of the triangle is one if that edge is a boundary edge.
/// A vertex on the plane is a vertex already.
fn is_vertex(corner: &Corner, edges: u8, is_boundary_edge: impl Fn(usize) -> bool) -> bool {
    match corner.cut {
        Some(_) if corner.weights.contains(&1.0) => false,
        None | Some(Edge::View) => false,
        Some(Edge::Made) => true,
        Some(Edge::Own(edge)) => {
            edges >> edge & 1 == 1 && (corner.edge == Edge::Made || is_boundary_edge(edge.into()))
        }
    }
}

/// The size that a point of a derived size is drawn with, and by how much it fades (GL 2.1, section 3.3, equation 3.2).
/// A size below one, or none at all, is drawn as one; only aliased points have whole sizes.
fn drawn_size(state: &PointState, derived: f32) -> (f32, f32) {
    let (wanted, fade) = match state.fade {
        Some(threshold) if derived < threshold => {
            let part = texunit::lanes::math::max(derived, 0.0) / threshold;
            (threshold, part * part)
        }
        Some(_) | None => (derived, 1.0),
    };
    let size = texunit::lanes::math::clamp(wanted, 1.0, MAX_POINT_SIZE);
    let size = match (state.antialiasing, &state.sprite) {
        (Antialiasing::Aliased, None) => size.round(),
        (Antialiasing::Smooth, None) | (_, Some(_)) => size,
    };
    (size, fade)
}

/// The lower left corner of a point's square (GL 2.1, section 3.3.1): of aliased points with an odd
/// size around a pixel's centre, with an even one around a corner of pixels.
fn point_corner(state: &PointState, window: [f64; 2], size: f32) -> [f64; 2] {
    let size = f64::from(size);
    window.map(|v| match (state.antialiasing, &state.sprite) {
        (Antialiasing::Aliased, None) if size % 2.0 == 1.0 => v.floor() + 0.5 - size * 0.5,
        (Antialiasing::Aliased, None) => (v + 0.5).floor() - size * 0.5,
        (Antialiasing::Smooth, None) | (_, Some(_)) => v - size * 0.5,
    })
}

/// The corners of the part of a smooth line between two distances from its first end, in pixels,
/// counter-clockwise. The last part ends where the line does.
pub fn rectangle(ends: [[f64; 2]; 2], width: f64, part: [f64; 2]) -> [[f64; 2]; 4] {
    let [a, b] = ends;
    let direction = [b[0] - a[0], b[1] - a[1]];
    let length = (direction[0] * direction[0] + direction[1] * direction[1]).sqrt();
    let along = direction.map(|v| v / length);
    let across = [-along[1] * width * 0.5, along[0] * width * 0.5];
    let corner = |at: f64, side: f64| {
        let at = at.min(length);
        [a[0] + along[0] * at + side * across[0], a[1] + along[1] * at + side * across[1]]
    };
    [corner(part[0], -1.0), corner(part[1], -1.0), corner(part[1], 1.0), corner(part[0], 1.0)]
}

/// The stipple of the lines around a polygon, which begins anew at its first edge alone (section 3.5.4). `closing` is
/// the edge that ends where that begins.
pub(super) fn stipple_around(state: &LineState, shapes: &mut [Shape], closing: [u32; 2]) {
    if state.stipple.is_none() {
        return;
    }
    let closes =
        |shape: &Shape| shape.clipping == Clipping::Whole && shape.vertices[..2] == closing;
    if let Some(at) = shapes.iter().position(closes) {
        shapes[at..].rotate_left(1);
    }
    stipple_lines(state, shapes, 0);
}

/// Where the stipple of each line of a strip begins: where that of the line before ends (section
/// 3.4.2). `before` is the phase before `shapes`; returns the phase after them.
pub fn stipple_lines(state: &LineState, shapes: &mut [Shape], before: u32) -> u32 {
    let Some(stipple) = state.stipple else { return before };
    let period = 16 * u32::from(stipple.factor) * SUBPIXEL as u32;
    let width = state.drawn_width();
    let mut stipple_phase = before;
    for shape in shapes {
        let [a, b, _] = shape.corners;
        if let ShapeKind::Line { stipple, .. } = &mut shape.kind {
            *stipple = stipple_phase;
            let length = match state.antialiasing {
                Antialiasing::Aliased => {
                    LineFragments::new(a, b, width as i32).columns() * SUBPIXEL as u32
                }
                Antialiasing::Smooth => {
                    let d = [0, 1].map(|axis| f64::from(b[axis]) - f64::from(a[axis]));
                    (d[0] * d[0] + d[1] * d[1]).sqrt() as u32
                }
            };
            stipple_phase = (stipple_phase + length % period) % period;
        }
    }
    stipple_phase
}
