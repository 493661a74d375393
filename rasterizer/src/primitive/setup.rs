//! From a primitive to shapes on the subpixel grid, culled.

use super::clip::{Corner, Edge, clip, planes};
use super::outline::{Line, PolygonTriangle, stipple_around};
use super::triangles::Triangles;
use crate::desc::{
    Antialiasing, Cull, Facing, FrontFace, LineState, PolygonMode, RasterState, Viewport,
};
use crate::sizes::SUBPIXEL;
use crate::vertex::{EdgeFlags, Geometry, Outcode, Primitive, Primitives, VertexList};
use std::ops::Range;
use texunit::lanes::{Isa, LANES};

/// What a shape covers, and how depth and varyings run over it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShapeKind {
    /// The triangle of its corners, by the plane through three vertices.
    Triangle,
    /// The line from its first to its second corner, along which values run from the first to the
    /// second vertex.
    Line {
        /// How far the stipple has come before it, in subpixels.
        stipple: u32,
        /// Added to depth.
        bias: f32,
    },
    /// The square or disc around its only vertex; all is constant.
    Point {
        /// In pixels.
        size: f32,
        /// Added to depth.
        bias: f32,
        /// What `Input::Coverage` is.
        fade: f32,
    },
}

/// Whether clipping has cut a primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clipping {
    /// It is as its vertices say.
    Whole,
    /// Its corners are not its vertices. A line is an edge that clipping made of the triangle of its vertices.
    Cut,
}

/// Something to be filled, and where its values come from.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// Corners in subpixels; of a triangle counter-clockwise, of a line its ends.
    pub corners: [[i32; 2]; 3],
    /// First and last pixel that it may cover, x then y.
    pub bounds: [[u16; 2]; 2],
    /// Vertices of the primitive in the draw's geometry. A line repeats its second, or has a third
    /// that provokes; a point repeats its only one.
    pub vertices: [u32; 3],
    /// Which of `vertices` gives flat varyings.
    pub provoking: u8,
    /// Whether it is all of the primitive.
    pub clipping: Clipping,
    /// What it is.
    pub kind: ShapeKind,
    /// The facing of the primitive.
    pub facing: Facing,
}

/// The bounds of a line that covers no pixel here, and only carries a stipple on.
pub const EMPTY_BOUNDS: [[u16; 2]; 2] = [[u16::MAX; 2], [0; 2]];

/// The side of a block of pixels that are one batch.
const BLOCK: u64 = LANES.isqrt() as u64;

impl Shape {
    /// Whether there are pixels that it may cover.
    pub fn has_pixels(&self) -> bool {
        self.bounds != EMPTY_BOUNDS
    }

    /// How many pixels lie within its bounds.
    pub fn pixels(&self) -> u64 {
        let [low, high] = self.bounds;
        let along = |axis: usize| (u64::from(high[axis]) + 1).saturating_sub(low[axis].into());
        along(0) * along(1)
    }

    /// About how many batches of fragments it is: of a point by the area of its bounds, of a polygon by its own and the
    /// blocks of its edges, of a line as long as its bounds are, times its width.
    pub fn batches(&self, line: &LineState) -> u64 {
        /// Blocks that are passed over in the time of one.
        const PASSED_OVER: u64 = 64;
        const PIXEL: u64 = (SUBPIXEL as u64).pow(2);
        let [across, down] = self.blocks();
        match self.kind {
            ShapeKind::Line { .. } => {
                let width = (line.drawn_width() as u64).div_ceil(BLOCK);
                ((across + down) * width).min(across * down)
            }
            ShapeKind::Triangle => {
                let [a, b, c] = self.corners.map(|corner| corner.map(i128::from));
                let twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
                let pixels = twice.unsigned_abs() / u128::from(2 * PIXEL);
                let within = u64::try_from(pixels / LANES as u128).unwrap_or(u64::MAX);
                let of_edges = 2 * (across + down) + across * down / PASSED_OVER;
                within.saturating_add(of_edges).min(self.bounding_batches())
            }
            ShapeKind::Point { .. } => self.bounding_batches(),
        }
    }

    /// The batches of its bounds.
    fn bounding_batches(&self) -> u64 {
        let [across, down] = self.blocks();
        self.pixels().div_ceil(LANES as u64).max(across).max(down)
    }

    /// The blocks of 8×8 pixels that its bounds are long, along both axes.
    fn blocks(&self) -> [u64; 2] {
        let [low, high] = self.bounds;
        let along = |axis: usize| (u64::from(high[axis]) + 1).saturating_sub(low[axis].into());
        [0, 1].map(|axis| along(axis).div_ceil(BLOCK))
    }

    /// Where the centre of a point is in the window.
    pub fn centre(&self, geometry: &Geometry, viewport: &Viewport) -> [f64; 2] {
        match self.clipping {
            Clipping::Whole => geometry.window(viewport, self.vertices[0]),
            Clipping::Cut => self.corners[0].map(|v| f64::from(v) / f64::from(SUBPIXEL)),
        }
    }
}

/// What is fixed for the primitives of a draw.
#[derive(Clone, Copy, Debug)]
pub struct Setup<'a> {
    /// The instruction set.
    pub isa: Isa,
    /// The viewport.
    pub viewport: Viewport,
    /// Which faces are not drawn.
    pub cull: Cull,
    /// Which winding is the front.
    pub front_face: FrontFace,
    /// How primitives become fragments.
    pub raster: &'a RasterState,
    /// Whether edge flags count.
    pub edge_flags: EdgeFlags,
    /// First and one past the last pixel that can be drawn to, x then y; what lies outside is
    /// dropped here.
    pub drawable_area: [[i32; 2]; 2],
    /// The part of `drawable_area` whose pixels have their centre in the viewport. Clipping cuts nothing at
    /// the sides of the view volume; this does.
    pub area_in_viewport: [[i32; 2]; 2],
    /// The smallest resolvable difference of depth; `None` for floating-point depth.
    pub resolution: Option<f64>,
}

/// Buffers of a run of [`setup`] calls.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    pub polygon: Vec<Corner>,
    pub other: Vec<Corner>,
    pub snapped: Vec<[i32; 2]>,
    pub planes: [[f64; 4]; 7],
}

/// Puts the shapes of a range of primitives behind `out`. `vertex_list` says where in the geometry the
/// vertices are.
pub fn setup(
    setup: &Setup<'_>,
    geometry: &Geometry,
    (primitives, range): (&Primitives, Range<u32>),
    vertex_list: &VertexList,
    out: &mut Vec<Shape>,
) {
    let mut scratch = Scratch { planes: planes(&setup.viewport), ..Scratch::default() };
    let filled = setup.raster.polygon.mode == [PolygonMode::Fill; 2];
    if primitives.are_triangles() && filled {
        let mut batch = Triangles::default();
        for first in range.clone().step_by(LANES) {
            let chunk = first..range.end.min(first + LANES as u32);
            batch.load(primitives, chunk.clone(), vertex_list);
            batch.setup(setup, geometry, chunk.len(), &mut scratch, out);
        }
        return;
    }
    let local = |ordinal: u32| vertex_list.local(ordinal);
    // The polygon that is set up: its number, where its shapes begin, and the edge that closes it.
    let mut polygon: Option<(u32, usize, [u32; 2])> = None;
    let end = |polygon, out: &mut Vec<Shape>| {
        if let Some((_, first, closing)) = polygon {
            stipple_around(&setup.raster.line, &mut out[first..], closing);
        }
    };
    for i in range {
        match primitives.get(i) {
            Primitive::Triangle(v, provoking, edges) => {
                let vertices = v.map(local);
                let number = primitives.number(i);
                if polygon.is_none_or(|(last, ..)| last != number) {
                    end(polygon, out);
                    polygon = Some((number, out.len(), [vertices[2], vertices[0]]));
                }
                let triangle = PolygonTriangle { vertices, provoking, edges };
                setup.triangle(geometry, &triangle, &mut scratch, out);
            }
            Primitive::Line(v, provoking) => {
                let [a, b] = v.map(local);
                if geometry.outcode(a).0 & geometry.outcode(b).0 & Outcode::CULLED != 0 {
                    continue;
                }
                let line =
                    Line { vertices: [a, b, b], provoking, facing: Facing::Front, bias: 0.0 };
                setup.line(geometry, &line, &mut scratch, out);
            }
            Primitive::Point(v) => {
                if geometry.outcode(local(v)).0 & Outcode::CULLED == 0 {
                    setup.point(geometry, local(v), Facing::Front, 0.0, out);
                }
            }
        }
    }
    end(polygon, out);
}

impl Setup<'_> {
    /// Sets up a triangle, in any polygon mode.
    pub(super) fn triangle(
        &self,
        geometry: &Geometry,
        triangle: &PolygonTriangle,
        scratch: &mut Scratch,
        out: &mut Vec<Shape>,
    ) {
        let PolygonTriangle { vertices, provoking, .. } = *triangle;
        let all = vertices.map(|v| geometry.outcode(v).0);
        let (any, every) = (all[0] | all[1] | all[2], all[0] & all[1] & all[2]);
        if every & Outcode::REJECT != 0 || any & Outcode::INVALID != 0 {
            return;
        }
        let whole;
        let (corners, clipping) = if any & Outcode::CUT == 0 {
            whole = vertices.map(|v| geometry.snapped[v as usize]);
            (whole.as_slice(), Clipping::Whole)
        } else {
            self.cut(geometry, &vertices, Outcode(any), scratch);
            (scratch.snapped.as_slice(), Clipping::Cut)
        };
        let Some((area, facing)) = self.facing(corners) else { return };
        if self.raster.polygon.mode[facing as usize] == PolygonMode::Fill {
            let shape = Shape {
                corners: [[0; 2]; 3],
                bounds: [[0; 2]; 2],
                vertices,
                provoking,
                clipping,
                kind: ShapeKind::Triangle,
                facing,
            };
            self.fill(corners, area, shape, out);
        } else {
            self.outline(geometry, triangle, facing, scratch, out);
        }
    }

    /// What clipping leaves of a line or a triangle, as a convex polygon in `scratch.snapped`.
    pub(super) fn cut(
        &self,
        geometry: &Geometry,
        vertices: &[u32],
        outcode: Outcode,
        scratch: &mut Scratch,
    ) {
        scratch.polygon.clear();
        scratch.polygon.extend(vertices.iter().enumerate().map(|(at, &vertex)| {
            let mut corner = Corner::of(geometry, vertex);
            corner.weights[at] = 1.0;
            corner.edge = Edge::Own(at as u8);
            corner
        }));
        clip(&mut scratch.polygon, &mut scratch.other, &scratch.planes, outcode.user());
        scratch.snapped.clear();
        let snapped = scratch.polygon.iter().map(|p| snap(self.viewport.window(&p.clip)));
        scratch.snapped.extend(snapped);
    }

    /// Twice the area of a convex polygon, and its facing; `None` if it is culled.
    #[inline]
    pub(super) fn facing(&self, corners: &[[i32; 2]]) -> Option<(i64, Facing)> {
        if corners.len() < 3 {
            return None;
        }
        let area: i64 = (1..corners.len() - 1)
            .map(|i| doubled_area([corners[0], corners[i], corners[i + 1]]))
            .sum();
        let front = match self.front_face {
            FrontFace::Ccw => area > 0,
            FrontFace::Cw => area < 0,
        };
        let culled = match self.cull {
            Cull::None => false,
            Cull::Front => front,
            Cull::Back => !front,
            Cull::Both => true,
        };
        if culled {
            return None;
        }
        Some((area, if front { Facing::Front } else { Facing::Back }))
    }

    /// A convex polygon of this area as triangles, in all else like `shape`.
    fn fill(&self, corners: &[[i32; 2]], area: i64, shape: Shape, out: &mut Vec<Shape>) {
        if area == 0 {
            return;
        }
        for i in 1..corners.len() - 1 {
            let corners = if area > 0 {
                [corners[0], corners[i], corners[i + 1]]
            } else {
                [corners[0], corners[i + 1], corners[i]]
            };
            // Snapping can fold a sliver of a cut polygon over; what is folded covers nothing.
            if doubled_area(corners) <= 0 {
                continue;
            }
            if let Some(bounds) =
                bounds(&corners, self.raster.polygon.antialiasing, &self.area_in_viewport)
            {
                out.push(Shape { corners, bounds, ..shape });
            }
        }
    }
}

/// The first and last pixel of `area` that points in the bounding box of `corners` may cover: those
/// with their centre inside, or, for an antialiased shape, all that it touches.
pub(super) fn bounds(
    corners: &[[i32; 2]],
    antialiasing: Antialiasing,
    area: &[[i32; 2]; 2],
) -> Option<[[u16; 2]; 2]> {
    let mut out = [[0; 2]; 2];
    for axis in 0..2 {
        let (mut low, mut high) = (i32::MAX, i32::MIN);
        for corner in corners {
            low = low.min(corner[axis]);
            high = high.max(corner[axis]);
        }
        let (first, last) = match antialiasing {
            Antialiasing::Aliased => (
                (low + SUBPIXEL / 2 - 1).div_euclid(SUBPIXEL),
                (high - SUBPIXEL / 2).div_euclid(SUBPIXEL),
            ),
            Antialiasing::Smooth => (low.div_euclid(SUBPIXEL), (high - 1).div_euclid(SUBPIXEL)),
        };
        let (first, last) = (first.max(area[0][axis]), last.min(area[1][axis] - 1));
        if first > last {
            return None;
        }
        (out[0][axis], out[1][axis]) = (first as u16, last as u16);
    }
    Some(out)
}

/// Window coordinates on the subpixel grid.
pub(super) fn snap(window: [f64; 2]) -> [i32; 2] {
    window.map(crate::vertex::snap)
}

/// Twice the area of a triangle, positive counter-clockwise.
pub(super) fn doubled_area([a, b, c]: [[i32; 2]; 3]) -> i64 {
    let d = |p: [i32; 2], axis: usize| i64::from(p[axis]) - i64::from(a[axis]);
    d(b, 0) * d(c, 1) - d(c, 0) * d(b, 1)
}
