//! Up to 64 shapes of a chunk, over lanes: what the kernels of [`super::plane_group`] and [`super::small_triangles`]
//! read.

use crate::desc::Facing;
use crate::primitive::{Clipping, Shape, ShapeKind};
use texunit::lanes::{I32s, LANES, U32s};

/// The shapes, a lane each.
#[derive(Debug)]
pub struct ShapeLanes {
    /// How many.
    pub len: usize,
    /// Corners in subpixels: x and y of each.
    pub corners: [[I32s; 2]; 3],
    /// First and last pixel that each may cover: x and y.
    pub bounds: [[I32s; 2]; 2],
    /// Vertices in the draw's geometry; also of lanes without a shape there are such.
    pub vertices: [U32s; 3],
    /// The provoking vertex.
    pub provoking: U32s,
    /// The lanes of triangles, bit by lane.
    pub triangles: u64,
    /// The lanes of triangles that clipping has not cut.
    pub whole: u64,
    /// The lanes of back faces.
    pub back: u64,
}

impl Default for ShapeLanes {
    fn default() -> Self {
        Self {
            len: 0,
            corners: [[I32s::ZERO; 2]; 3],
            bounds: [[I32s::ZERO; 2]; 2],
            vertices: [U32s::ZERO; 3],
            provoking: U32s::ZERO,
            triangles: 0,
            whole: 0,
            back: 0,
        }
    }
}

impl ShapeLanes {
    /// Holds these shapes, at most 64.
    pub fn load<'a>(&mut self, shapes: impl Iterator<Item = &'a Shape>) {
        let (mut len, mut triangles, mut whole, mut back) = (0, 0, 0, 0);
        for (lane, shape) in shapes.enumerate().take(LANES) {
            for k in 0..3 {
                self.corners[k][0][lane] = shape.corners[k][0];
                self.corners[k][1][lane] = shape.corners[k][1];
                self.vertices[k][lane] = shape.vertices[k];
            }
            for end in 0..2 {
                self.bounds[end][0][lane] = shape.bounds[end][0].into();
                self.bounds[end][1][lane] = shape.bounds[end][1].into();
            }
            let [first, second, third] = shape.vertices;
            self.provoking[lane] = match shape.provoking {
                0 => first,
                1 => second,
                2.. => third,
            };
            let is_triangle = match shape.kind {
                ShapeKind::Triangle => 1,
                ShapeKind::Line { .. } | ShapeKind::Point { .. } => 0,
            };
            triangles |= is_triangle << lane;
            whole |= (is_triangle & u64::from(shape.clipping == Clipping::Whole)) << lane;
            back |= u64::from(shape.facing == Facing::Back) << lane;
            len = lane + 1;
        }
        (self.len, self.triangles, self.whole, self.back) = (len, triangles, whole, back);
        for vertices in self.vertices.iter_mut().chain([&mut self.provoking]) {
            vertices.0[self.len..].fill(0);
        }
    }

    /// Which side a shape shows.
    #[inline(always)]
    pub fn facing(&self, lane: usize) -> Facing {
        match self.back >> (lane % LANES) & 1 {
            0 => Facing::Front,
            _ => Facing::Back,
        }
    }
}
