//! From a primitive to triangles on the subpixel grid, culled.

use super::assemble::Primitive;
use super::clip::{Clip, clip, planes};
use crate::driver::{Cull, FrontFace, Viewport};
use crate::vertex::{GUARD_BAND, Geometry, Outcode, ShadedVertex};

/// Subpixels of a pixel along an axis (`GL_SUBPIXEL_BITS` = 8).
pub const SUBPIXEL: i32 = 256;

/// The largest size of a point in pixels.
const MAX_POINT_SIZE: f64 = 2048.0;

/// Which side of a polygon is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facing {
    /// Points and lines too.
    Front,
    /// The other.
    Back,
}

/// How depth and varyings run over a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// By the plane through three vertices.
    Triangle,
    /// Along the line from the first to the second vertex.
    Line,
    /// Constant; window x and y of the point's lower left corner, and its size.
    Point([f32; 2], f32),
}

/// A triangle to be filled, counter-clockwise on the grid, and where its values come from.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// Corners in subpixels.
    pub corners: [[i32; 2]; 3],
    /// Vertices of the primitive in the draw's geometry (a line repeats its second, a point its
    /// only one).
    pub vertices: [u32; 3],
    /// Which of `vertices` gives flat varyings.
    pub provoking: u8,
    /// How values run.
    pub kind: Kind,
    /// Which side is seen.
    pub facing: Facing,
}

/// What is fixed for the primitives of a draw.
#[derive(Clone, Copy, Debug)]
pub struct Setup {
    /// Where the window is.
    pub viewport: Viewport,
    /// Which faces are not drawn.
    pub cull: Cull,
    /// Which winding is the front.
    pub front_face: FrontFace,
    /// Width of lines in pixels.
    pub line_width: f32,
    /// First and one past the last pixel that can be drawn to, x then y; what lies outside is
    /// dropped here.
    pub area: [[i32; 2]; 2],
}

/// Buffers of a run of [`setup`] calls.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    polygon: Vec<Clip>,
    other: Vec<Clip>,
    snapped: Vec<[i32; 2]>,
}

/// Puts the shapes of `primitives` behind `out`. `local` gives the vertex of the geometry for an
/// ordinal of the draw.
pub fn setup(
    setup: &Setup,
    geometry: &Geometry,
    primitives: impl Iterator<Item = Primitive>,
    local: impl Fn(u32) -> u32,
    out: &mut Vec<Shape>,
) {
    let planes = planes(&setup.viewport);
    let mut scratch = Scratch::default();
    for primitive in primitives {
        match primitive {
            Primitive::Triangle(v, provoking) => {
                let vertices = v.map(&local);
                let shaded = vertices.map(|v| &geometry.vertices[v as usize]);
                let all = shaded.map(|v| v.outcode.0);
                let (any, every) = (all[0] | all[1] | all[2], all[0] & all[1] & all[2]);
                if every & Outcode::REJECT != 0 || any & Outcode::INVALID != 0 {
                    continue;
                }
                let shape = |corners, facing| Shape {
                    corners,
                    vertices,
                    provoking,
                    kind: Kind::Triangle,
                    facing,
                };
                if any & Outcode::CUT == 0 {
                    let corners = shaded.map(|v| snap(v.window));
                    setup.emit(&corners, shape, out);
                } else {
                    scratch.polygon.clear();
                    scratch.polygon.extend(shaded.map(|v| v.clip.map(f64::from)));
                    clip(&mut scratch.polygon, &mut scratch.other, &planes);
                    scratch.snapped.clear();
                    scratch
                        .snapped
                        .extend(scratch.polygon.iter().map(|p| snap(setup.viewport.window(p))));
                    setup.emit(&scratch.snapped, shape, out);
                }
            }
            Primitive::Line(v, provoking) => {
                let [a, b] = v.map(&local);
                let ends = [a, b].map(|v| &geometry.vertices[v as usize]);
                setup.line(ends, [a, b, b], provoking, &planes, &mut scratch, out);
            }
            Primitive::Point(v) => {
                let vertex = local(v);
                setup.point(&geometry.vertices[vertex as usize], vertex, out);
            }
        }
    }
}

impl Setup {
    /// A convex polygon as triangles.
    fn emit(
        &self,
        corners: &[[i32; 2]],
        shape: impl Fn([[i32; 2]; 3], Facing) -> Shape,
        out: &mut Vec<Shape>,
    ) {
        if corners.len() < 3 || self.misses(corners) {
            return;
        }
        let area: i64 = (1..corners.len() - 1)
            .map(|i| doubled_area([corners[0], corners[i], corners[i + 1]]))
            .sum();
        if area == 0 {
            return;
        }
        let front = (area > 0) == (self.front_face == FrontFace::Ccw);
        let culled = match self.cull {
            Cull::None => false,
            Cull::Front => front,
            Cull::Back => !front,
            Cull::Both => true,
        };
        if culled {
            return;
        }
        let facing = if front { Facing::Front } else { Facing::Back };
        for i in 1..corners.len() - 1 {
            let fan = if area > 0 {
                [corners[0], corners[i], corners[i + 1]]
            } else {
                [corners[0], corners[i + 1], corners[i]]
            };
            // Snapping can fold a sliver of a cut polygon over; what is folded covers nothing.
            if doubled_area(fan) > 0 {
                out.push(shape(fan, facing));
            }
        }
    }

    /// Whether a polygon's bounding box has no pixel centre in the area.
    fn misses(&self, corners: &[[i32; 2]]) -> bool {
        (0..2).any(|axis| {
            let (mut low, mut high) = (i32::MAX, i32::MIN);
            for corner in corners {
                low = low.min(corner[axis]);
                high = high.max(corner[axis]);
            }
            // The first and last pixel whose centre lies in [low, high].
            let first = (low - SUBPIXEL / 2).div_euclid(SUBPIXEL)
                + i32::from((low - SUBPIXEL / 2).rem_euclid(SUBPIXEL) != 0);
            let last = (high - SUBPIXEL / 2).div_euclid(SUBPIXEL);
            first > last || last < self.area[0][axis] || first >= self.area[1][axis]
        })
    }

    /// A line as the parallelogram that Vulkan calls its non-strict form: as wide along the minor
    /// axis as the line, ends cut along the minor axis. At width 1 every column (or row) gets one
    /// pixel, and lines that follow each other share none.
    fn line(
        &self,
        ends: [&ShadedVertex; 2],
        vertices: [u32; 3],
        provoking: u8,
        planes: &[[f64; 4]; 7],
        scratch: &mut Scratch,
        out: &mut Vec<Shape>,
    ) {
        let (any, every) =
            (ends[0].outcode.0 | ends[1].outcode.0, ends[0].outcode.0 & ends[1].outcode.0);
        if every & Outcode::REJECT != 0 || any & Outcode::INVALID != 0 {
            return;
        }
        scratch.polygon.clear();
        scratch.polygon.extend(ends.map(|v| v.clip.map(f64::from)));
        if any & Outcode::CUT != 0 {
            clip(&mut scratch.polygon, &mut scratch.other, planes);
        }
        let &[a, b] = scratch.polygon.as_slice() else { return };
        let (a, b) = (self.viewport.window(&a), self.viewport.window(&b));
        let half = f64::from(self.line_width.round().max(1.0)) * 0.5;
        let offset =
            if (b[0] - a[0]).abs() >= (b[1] - a[1]).abs() { [0.0, half] } else { [half, 0.0] };
        let corner =
            |p: [f64; 2], side: f64| snap([p[0] + side * offset[0], p[1] + side * offset[1]]);
        let corners = [corner(a, -1.0), corner(b, -1.0), corner(b, 1.0), corner(a, 1.0)];
        self.unfaced(&corners, vertices, provoking, Kind::Line, out);
    }

    /// A point as a square around its place (GL 2.1, section 3.3.1).
    fn point(&self, vertex: &ShadedVertex, index: u32, out: &mut Vec<Shape>) {
        if vertex.outcode.0 & (Outcode::REJECT | Outcode::INVALID | Outcode::GUARD) != 0 {
            return;
        }
        // A size below one, or none at all, is drawn as one.
        let size = f64::from(vertex.point_size).clamp(1.0, MAX_POINT_SIZE).round();
        // Odd sizes are centred on a pixel's centre, even ones on a corner.
        let low = vertex.window.map(|v| {
            if size % 2.0 == 1.0 {
                v.floor() + 0.5 - size * 0.5
            } else {
                (v + 0.5).floor() - size * 0.5
            }
        });
        let high = low.map(|v| v + size);
        let corners = [low, [high[0], low[1]], high, [low[0], high[1]]].map(snap);
        let kind = Kind::Point(low.map(|v| v as f32), size as f32);
        self.unfaced(&corners, [index; 3], 0, kind, out);
    }

    /// A quadrilateral that has no back.
    fn unfaced(
        &self,
        corners: &[[i32; 2]; 4],
        vertices: [u32; 3],
        provoking: u8,
        kind: Kind,
        out: &mut Vec<Shape>,
    ) {
        let facing = Facing::Front;
        let both = Self { cull: Cull::None, ..*self };
        both.emit(corners, |corners, _| Shape { corners, vertices, provoking, kind, facing }, out);
    }
}

/// To the nearest subpixel, within 24 bits. The clamp acts only where a cut between coordinates of
/// 1e30 and of 1 has rounded to a point outside the guard band.
pub fn snap(window: [f64; 2]) -> [i32; 2] {
    window.map(|v| {
        let v = v.clamp(-GUARD_BAND, GUARD_BAND);
        (v * f64::from(SUBPIXEL) + 0.5).floor() as i32
    })
}

/// Twice the area of a triangle, positive counter-clockwise.
fn doubled_area([a, b, c]: [[i32; 2]; 3]) -> i64 {
    let d = |p: [i32; 2], axis: usize| i64::from(p[axis]) - i64::from(a[axis]);
    d(b, 0) * d(c, 1) - d(c, 0) * d(b, 1)
}
