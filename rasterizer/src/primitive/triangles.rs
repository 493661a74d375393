//! Filled triangles, 64 at a time: the arithmetic of [`super::setup`] over lanes. Triangles that must be clipped take
//! the general path.

use super::outline::PolygonTriangle;
use super::setup::{Clipping, Scratch, Setup, Shape, ShapeKind};
use crate::desc::{Antialiasing, Cull, Facing, FrontFace};
use crate::sizes::SUBPIXEL;
use crate::vertex::{Geometry, Outcode, Primitive, Primitives, VertexList};
use std::ops::Range;
use texunit::lanes::{I32s, Kernel, LANES, Simd, U32s};

/// Up to 64 triangles, and what becomes of them.
pub(super) struct Triangles {
    vertices: [U32s; 3],
    provoking: [u8; LANES],
    /// In subpixels, counter-clockwise: x and y of each corner.
    corners: [[I32s; 2]; 3],
    /// First and last pixel that each may cover: x and y.
    bounds: [[I32s; 2]; 2],
}

impl Default for Triangles {
    fn default() -> Self {
        Self {
            vertices: [U32s::ZERO; 3],
            provoking: [0; LANES],
            corners: [[I32s::ZERO; 2]; 3],
            bounds: [[I32s::ZERO; 2]; 2],
        }
    }
}

/// Which of them there are, bit by lane.
struct TriangleMasks {
    /// Those that are drawn as they are.
    whole: u64,
    /// Those of them of which the back is seen.
    back: u64,
    /// Those that have to be cut.
    cut: u64,
}

impl Triangles {
    /// Takes a range of at most 64 primitives, all of them triangles.
    pub fn load(&mut self, primitives: &Primitives, range: Range<u32>, vertex_list: &VertexList) {
        if let Some(provoking) = primitives.triples() {
            vertex_list.triples(3 * range.start, &mut self.vertices, range.len());
            self.provoking = [provoking; LANES];
            return;
        }
        for (lane, i) in range.enumerate().take(LANES) {
            if let Primitive::Triangle(ordinals, provoking, _) = primitives.get(i) {
                for (vertices, ordinal) in self.vertices.iter_mut().zip(ordinals) {
                    vertices[lane] = vertex_list.local(ordinal);
                }
                self.provoking[lane] = provoking;
            }
        }
    }

    /// Puts the shapes of the first `len` behind `out`.
    pub fn setup(
        &mut self,
        setup: &Setup<'_>,
        geometry: &Geometry,
        len: usize,
        scratch: &mut Scratch,
        out: &mut Vec<Shape>,
    ) {
        // Every lane gathers: unused lanes have vertex 0.
        for vertices in &mut self.vertices {
            vertices.0[len..].fill(0);
        }
        let fates = setup.isa.run(Project { triangles: self, setup, geometry });
        let mut left = (fates.whole | fates.cut) & !0 >> (LANES - len);
        out.reserve(left.count_ones() as usize);
        while left != 0 {
            let lane = left.trailing_zeros() as usize % LANES;
            left &= left - 1;
            let [a, b, c] = &self.vertices;
            let vertices = [a[lane], b[lane], c[lane]];
            let provoking = self.provoking[lane];
            if fates.cut >> lane & 1 == 1 {
                let triangle = PolygonTriangle { vertices, provoking, edges: 0 };
                setup.triangle(geometry, &triangle, scratch, out);
                continue;
            }
            let back = fates.back >> lane & 1 == 1;
            let [[ax, ay], [bx, by], [cx, cy]] = &self.corners;
            let [[left, low], [right, high]] = &self.bounds;
            out.push(Shape {
                corners: [[ax[lane], ay[lane]], [bx[lane], by[lane]], [cx[lane], cy[lane]]],
                bounds: [
                    [left[lane] as u16, low[lane] as u16],
                    [right[lane] as u16, high[lane] as u16],
                ],
                vertices,
                provoking,
                clipping: Clipping::Whole,
                kind: ShapeKind::Triangle,
                facing: if back { Facing::Back } else { Facing::Front },
            });
        }
    }
}

struct Project<'a> {
    triangles: &'a mut Triangles,
    setup: &'a Setup<'a>,
    geometry: &'a Geometry,
}

impl Kernel for Project<'_> {
    type Output = TriangleMasks;
    #[inline(always)]
    fn run<S: Simd>(self) -> TriangleMasks {
        let Self { triangles: Triangles { vertices, corners, bounds, .. }, setup, geometry } = self;
        let places: &[u8] = bytemuck::cast_slice(&geometry.snapped);
        let outcodes: &[u8] = bytemuck::cast_slice(&geometry.outcodes);
        let (mut any, mut every) = (U32s::ZERO, U32s::splat(!0));
        for (vertices, corner) in vertices.iter().zip(corners.iter_mut()) {
            let mut offsets = U32s::ZERO;
            for lane in 0..LANES {
                offsets[lane] = vertices[lane] * 4;
            }
            let codes = S::gather(outcodes, &offsets);
            for lane in 0..LANES {
                any[lane] |= codes[lane];
                every[lane] &= codes[lane];
                offsets[lane] *= 2;
            }
            let [x, y] = S::gather_pairs(places, &offsets);
            *corner = [*x.as_i32(), *y.as_i32()];
        }
        let (mut whole, mut back, mut cut) = (U32s::ZERO, U32s::ZERO, U32s::ZERO);
        // Drawn, by side: front, back.
        let drawn = match setup.cull {
            Cull::None => [1, 1],
            Cull::Front => [0, 1],
            Cull::Back => [1, 0],
            Cull::Both => [0, 0],
        };
        let front_sign = match setup.front_face {
            FrontFace::Ccw => 1.0,
            FrontFace::Cw => -1.0,
        };
        let [[ax, ay], [bx, by], [cx, cy]] = corners;
        for lane in 0..LANES {
            let dropped =
                (every[lane] & Outcode::REJECT != 0) | (any[lane] & Outcode::INVALID != 0);
            let is_cut = any[lane] & Outcode::CUT != 0;
            // Exact: the differences have 25 bits.
            let d = |to: i32, from: i32| f64::from(to.wrapping_sub(from));
            let (x, y) = (ax[lane], ay[lane]);
            let area = d(bx[lane], x) * d(cy[lane], y) - d(cx[lane], x) * d(by[lane], y);
            let front = area * front_sign > 0.0;
            let is_drawn = if front { drawn[0] } else { drawn[1] };
            let is_there = (area != 0.0) & !is_cut & !dropped;
            whole[lane] = if is_there { is_drawn } else { 0 };
            cut[lane] = u32::from(is_cut & !dropped);
            back[lane] = u32::from(!front);
            // Counter-clockwise.
            let is_clockwise = area < 0.0;
            let (b, c) = ([bx[lane], by[lane]], [cx[lane], cy[lane]]);
            bx[lane] = if is_clockwise { c[0] } else { b[0] };
            by[lane] = if is_clockwise { c[1] } else { b[1] };
            cx[lane] = if is_clockwise { b[0] } else { c[0] };
            cy[lane] = if is_clockwise { b[1] } else { c[1] };
        }
        // As `setup::bounds` has it.
        let (first, last) = match setup.raster.polygon.antialiasing {
            Antialiasing::Aliased => (SUBPIXEL / 2 - 1, SUBPIXEL / 2),
            Antialiasing::Smooth => (0, 1),
        };
        let [low, high] = bounds;
        let [area_low, area_high] = setup.area_in_viewport;
        for axis in 0..2 {
            let (from, to) = (area_low[axis], area_high[axis] - 1);
            for lane in 0..LANES {
                let (a, b) = (corners[0][axis][lane], corners[1][axis][lane]);
                let c = corners[2][axis][lane];
                let least = a.min(b).min(c);
                let most = a.max(b).max(c);
                let least = (least + first) >> SUBPIXEL.trailing_zeros();
                let most = (most - last) >> SUBPIXEL.trailing_zeros();
                low[axis][lane] = if least > from { least } else { from };
                high[axis][lane] = if most < to { most } else { to };
                let is_seen = low[axis][lane] <= high[axis][lane];
                whole[lane] = if is_seen { whole[lane] } else { 0 };
            }
        }
        TriangleMasks { whole: S::nonzero(&whole), back: S::nonzero(&back), cut: S::nonzero(&cut) }
    }
}
