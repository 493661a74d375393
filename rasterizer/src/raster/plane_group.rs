//! The planes of up to 64 shapes of a chunk, computed together: the arithmetic of
//! [`super::interpolate`], in the same order, over lanes of triangles.

use super::interpolate::{PlaneSetup, Planes};
use super::plane_weights::{PlaneLanes, Weights, sum, to_depth};
use super::shape_lanes::ShapeLanes;
use super::small_triangles::{WINDOW_BLOCKS, Windows};
use crate::desc::DepthTransform;
use crate::plan::{FactorPlanes, PlaneSource};
use crate::primitive::Shape;
use crate::sizes::SUBPIXEL;
use crate::vertex::{Geometry, VARYINGS};
use texunit::lanes::{F32s, F64s, Isa, Kernel, LANES, Simd, U32s};

/// Fewer shapes than this are computed one by one.
const MIN_SHAPES: usize = 6;

/// The planes of up to 64 shapes.
#[derive(Debug, Default)]
pub struct PlaneGroup {
    /// In the order of [`PlaneSetup::sources`].
    planes: Vec<PlaneLanes>,
    /// The same planes in the blocks of the shapes' windows.
    windows: Vec<WindowPlane>,
    single: Planes,
    lanes: Box<KernelBuffers>,
}

/// A plane of each shape in the blocks that its window overlaps.
#[derive(Clone, Debug)]
struct WindowPlane {
    /// At the first pixel of each of the blocks, row by row.
    corners: [F32s; WINDOW_BLOCKS * WINDOW_BLOCKS],
    /// Per pixel across.
    a: F32s,
    /// Per pixel up.
    b: F32s,
}

/// The buffers that the kernels read and write.
#[derive(Debug)]
struct KernelBuffers {
    origin: [F64s; 2],
    /// Four values that planes interpolate, by vertex.
    values: [[F32s; 4]; 3],
    weights: Weights,
    /// Not zero in the lanes whose planes only the scalar path ([`PlaneGroup::single`]) computes exactly.
    needs_scalar_path: [u64; LANES],
}

impl Default for KernelBuffers {
    fn default() -> Self {
        Self {
            origin: [F64s::ZERO; 2],
            values: [[F32s::ZERO; 4]; 3],
            weights: Weights::default(),
            needs_scalar_path: [0; LANES],
        }
    }
}

impl PlaneGroup {
    /// The origin of the planes of the shape `lane`, in pixels.
    #[inline(always)]
    pub fn origin(&self, lane: usize) -> [f64; 2] {
        let [x, y] = &self.lanes.origin;
        [x[lane % LANES], y[lane % LANES]]
    }

    /// How many planes there are.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.planes.len()
    }

    /// The planes of the shape `lane`: per pixel across, per pixel up, at the origin.
    #[inline(always)]
    pub fn of(&self, lane: usize) -> impl Iterator<Item = [f64; 3]> {
        let lane = lane % LANES;
        self.planes.iter().map(move |[a, b, c]| [a[lane], b[lane], c[lane]])
    }

    /// Whether the inputs of the factors are uniform over the shape `lane`: their planes are constant, or equal the
    /// denominator plane.
    pub fn has_uniform_factors(
        &self,
        lane: usize,
        of: &FactorPlanes,
        denominator: Option<usize>,
    ) -> bool {
        let plane = |index: usize| self.plane(lane, index);
        // The sign of a zero may change between the origin and a block.
        let is_constant = |index: &usize| {
            let [a, b, c] = plane(*index);
            a == 0.0 && b == 0.0 && !is_minus_zero(c)
        };
        let by = denominator.map(plane);
        let is_one = by.is_none_or(|by| by == [0.0, 0.0, 1.0]);
        of.linear.iter().all(is_constant)
            && of
                .smooth
                .iter()
                .all(|index| by == Some(plane(*index)) || is_one && is_constant(index))
    }

    /// Whether the quotients of these planes have constant derivatives over the shape `lane`: the denominator plane is
    /// 1.
    pub fn has_uniform_slopes(
        &self,
        lane: usize,
        of: &[usize],
        denominator: Option<usize>,
    ) -> bool {
        let plane = |index: usize| self.plane(lane, index);
        // Subtracting 0 · d may change the sign of a zero, and is NaN where an operand is infinite.
        let has_exact_slopes = |index: &usize| {
            let [a, b, c] = plane(*index);
            let is_far_from_infinite = [a, b, c].iter().all(|number| number.abs() < 1e30);
            !is_minus_zero(a) && !is_minus_zero(b) && is_far_from_infinite
        };
        of.is_empty()
            || denominator.is_some_and(|by| plane(by) == [0.0, 0.0, 1.0])
                && of.iter().all(has_exact_slopes)
    }

    /// `a`, `b` and `c` of a plane of the shape `lane`.
    fn plane(&self, lane: usize, index: usize) -> [f64; 3] {
        self.planes[index].each_ref().map(|numbers| numbers[lane % LANES])
    }

    /// The value of each plane at the centre of pixel `(x, y)` and its steps, of the shape `lane`.
    #[inline]
    pub fn at(&self, lane: usize, x: i32, y: i32, out: &mut [[f32; 3]]) {
        let origin = self.origin(lane);
        let dx = f64::from(x) + 0.5 - origin[0];
        let dy = f64::from(y) + 0.5 - origin[1];
        for (out, [a, b, c]) in out.iter_mut().zip(self.of(lane)) {
            *out = [((dx * a + dy * b) + c) as f32, a as f32, b as f32];
        }
    }

    /// As [`Self::at`], of the first pixel of one of the blocks that the window of the shape `lane`
    /// may reach into.
    #[inline(always)]
    pub fn in_window(&self, lane: usize, block: usize) -> impl Iterator<Item = [f32; 3]> + Clone {
        let (lane, block) = (lane % LANES, block.min(WINDOW_BLOCKS * WINDOW_BLOCKS - 1));
        self.windows
            .iter()
            .map(move |plane| [plane.corners[block][lane], plane.a[lane], plane.b[lane]])
    }

    /// Computes the planes of `shapes`, which `lanes` holds.
    pub fn compute<'a>(
        &mut self,
        isa: Isa,
        setup: &PlaneSetup<'_>,
        geometry: &Geometry,
        lanes: &ShapeLanes,
        shapes: impl Iterator<Item = &'a Shape>,
    ) {
        self.planes.resize(setup.sources.len(), [F64s::ZERO; 3]);
        let plain = setup.depth.offset.is_none()
            && setup.sources.iter().all(|source| match source {
                PlaneSource::Depth
                | PlaneSource::Denominator
                | PlaneSource::Smooth(_)
                | PlaneSource::Flat(_)
                | PlaneSource::SmoothOfSides(_)
                | PlaneSource::FlatOfSides(_) => true,
                PlaneSource::InverseW
                | PlaneSource::NoPerspective(_)
                | PlaneSource::PointCoord(_)
                | PlaneSource::LineDirection(_)
                | PlaneSource::Sprite(..) => false,
            });
        let mut scalar_lanes = !0;
        if plain && lanes.len >= MIN_SHAPES {
            let (planes, out) = (&mut self.planes, &mut *self.lanes);
            scalar_lanes =
                isa.run(ComputePlanes { setup, geometry, shapes: lanes, lanes: out, planes });
            // A clipped triangle has the planes of a thick one even if it is thin; only the scalar path handles this.
            scalar_lanes |= !lanes.whole;
        }
        if scalar_lanes & !0 >> (LANES - lanes.len.clamp(1, LANES)) == 0 {
            return;
        }
        for (lane, shape) in shapes.enumerate().take(LANES) {
            if scalar_lanes >> lane & 1 == 0 {
                continue;
            }
            self.single.compute(setup, geometry, shape);
            for axis in 0..2 {
                self.lanes.origin[axis][lane] = self.single.origin[axis];
            }
            for (lanes, plane) in self.planes.iter_mut().zip(&self.single.planes) {
                (lanes[0][lane], lanes[1][lane], lanes[2][lane]) = (plane.a, plane.b, plane.c);
            }
        }
    }

    /// Evaluates the planes in the blocks of windows of the tile whose first pixel is `tile`.
    pub fn evaluate_windows(&mut self, isa: Isa, tile: [i32; 2], windows: &Windows) {
        const NONE: WindowPlane = WindowPlane {
            corners: [F32s::ZERO; WINDOW_BLOCKS * WINDOW_BLOCKS],
            a: F32s::ZERO,
            b: F32s::ZERO,
        };
        self.windows.resize(self.planes.len(), NONE);
        let Self { planes, windows: out, lanes, .. } = self;
        isa.run(EvaluateWindows { tile, windows, origin: &lanes.origin, planes, out });
    }
}

/// Whether a number becomes -0 as an `f32`.
fn is_minus_zero(number: f64) -> bool {
    (number as f32).to_bits() == (-0.0_f32).to_bits()
}

/// The planes of 64 shapes; returns the lanes that need the scalar path.
struct ComputePlanes<'a> {
    setup: &'a PlaneSetup<'a>,
    geometry: &'a Geometry,
    shapes: &'a ShapeLanes,
    lanes: &'a mut KernelBuffers,
    planes: &'a mut [PlaneLanes],
}

impl Kernel for ComputePlanes<'_> {
    type Output = u64;
    #[inline(always)]
    fn run<S: Simd>(self) -> u64 {
        let Self { setup, geometry, shapes, lanes, planes } = self;
        for axis in 0..2 {
            for lane in 0..LANES {
                let origin = f64::from(shapes.corners[0][axis][lane]) / f64::from(SUBPIXEL);
                lanes.origin[axis][lane] = origin;
            }
        }
        lanes.needs_scalar_path = [0; LANES];
        let mut gathered = GatheredFour::of([0; 2], geometry.stride);
        gathered.gather::<S>(geometry, shapes, &mut lanes.values);
        let KernelBuffers { values, origin, weights, needs_scalar_path } = lanes;
        weights.compute::<S>(values, origin, &setup.depth.viewport, needs_scalar_path);
        for (source, out) in setup.sources.iter().zip(planes) {
            let (weights, at) = match *source {
                PlaneSource::Depth => (weights.projective(), [2; 2]),
                PlaneSource::Smooth(at) => (weights.smooth(), [VARYINGS + at; 2]),
                PlaneSource::SmoothOfSides(sides) => {
                    (weights.smooth(), sides.map(|at| VARYINGS + at))
                }
                PlaneSource::Denominator => {
                    *out = weights.denominator();
                    continue;
                }
                PlaneSource::Flat(at) => {
                    provoking(geometry, shapes, [at; 2], out);
                    continue;
                }
                PlaneSource::FlatOfSides(sides) => {
                    provoking(geometry, shapes, sides, out);
                    continue;
                }
                PlaneSource::NoPerspective(_)
                | PlaneSource::Sprite(..)
                | PlaneSource::InverseW
                | PlaneSource::LineDirection(_)
                | PlaneSource::PointCoord(_) => continue,
            };
            let component = gathered.component(at).unwrap_or_else(|| {
                gathered = GatheredFour::of(at, geometry.stride);
                gathered.gather::<S>(geometry, shapes, values);
                at[0] - gathered.first[0]
            });
            sum(weights, values, component, out, needs_scalar_path);
            if *source == PlaneSource::Depth {
                let DepthTransform { scale, bias } = setup.depth.viewport.depth_transform();
                to_depth(out, scale, bias);
            }
        }
        let mut marked = U32s::ZERO;
        for lane in 0..LANES {
            marked[lane] = u32::from(needs_scalar_path[lane] != 0);
        }
        S::nonzero(&marked)
    }
}

/// The planes of a varying that is flat: `sides` has its index for front and for back faces.
#[inline(always)]
fn provoking(geometry: &Geometry, shapes: &ShapeLanes, sides: [usize; 2], out: &mut PlaneLanes) {
    let [a, b, c] = out;
    (*a, *b) = (F64s::ZERO, F64s::ZERO);
    for (lane, c) in c.0.iter_mut().enumerate() {
        let values = &geometry.values[shapes.provoking[lane] as usize * geometry.stride..];
        *c = values[VARYINGS + sides[shapes.facing(lane) as usize]].into();
    }
}

/// Four consecutive values of a vertex: the number of the first, for front and for back faces.
#[derive(Clone, Copy)]
struct GatheredFour {
    first: [usize; 2],
}

impl GatheredFour {
    /// Those from the values `at` on, or before them so that all four lie within the values of a vertex.
    #[inline(always)]
    fn of(at: [usize; 2], stride: usize) -> Self {
        // Aligned, so that the next component is among them.
        let before =
            if at[0] == at[1] { at[0] % 4 } else { (at[0].max(at[1]) + 4).saturating_sub(stride) };
        Self { first: at.map(|at| at - before) }
    }

    /// Which of the four holds the values `at`, if one does.
    #[inline(always)]
    fn component(&self, at: [usize; 2]) -> Option<usize> {
        let [front, back] = [0, 1].map(|side| at[side].wrapping_sub(self.first[side]));
        (front == back && front < 4).then_some(front)
    }

    /// Gathers them from the three vertices of each shape.
    #[inline(always)]
    fn gather<S: Simd>(&self, geometry: &Geometry, shapes: &ShapeLanes, out: &mut [[F32s; 4]; 3]) {
        let values: &[u8] = bytemuck::cast_slice(&geometry.values);
        let [stride, front, back] =
            [geometry.stride, self.first[0], self.first[1]].map(|values| 4 * values as u32);
        let mut first = U32s::splat(front);
        if front != back {
            for lane in 0..LANES {
                first[lane] = if shapes.back >> lane & 1 == 1 { back } else { front };
            }
        }
        for (vertices, out) in shapes.vertices.iter().zip(out) {
            let mut offsets = U32s::ZERO;
            for lane in 0..LANES {
                offsets[lane] = vertices[lane] * stride + first[lane];
            }
            let [a, b, c, d] = S::gather_fours(values, &offsets);
            *out = [*a.as_f32(), *b.as_f32(), *c.as_f32(), *d.as_f32()];
        }
    }
}

/// [`PlaneGroup::at`] of the blocks of all windows.
struct EvaluateWindows<'a> {
    tile: [i32; 2],
    windows: &'a Windows,
    origin: &'a [F64s; 2],
    planes: &'a [PlaneLanes],
    out: &'a mut [WindowPlane],
}

impl Kernel for EvaluateWindows<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { tile, windows, origin, planes, out } = self;
        let extra_blocks = windows.extra_blocks.map(|blocks| blocks.min(WINDOW_BLOCKS - 1));
        // Here and below on the stack, where the compiler sees that no references overlap: from the origin to the first
        // pixel of each column of blocks that a window reaches into, and of each row.
        let mut to_block = [[F64s::ZERO; WINDOW_BLOCKS]; 2];
        for axis in 0..2 {
            for (block, to) in to_block[axis].iter_mut().enumerate().take(extra_blocks[axis] + 1) {
                for lane in 0..LANES {
                    let first = 2 * (windows.first_quads[axis][lane] & !3) + 8 * block as i32;
                    to[lane] = f64::from(tile[axis] + first) + 0.5 - origin[axis][lane];
                }
            }
        }
        let [x, y] = &to_block;
        let [across, up] = extra_blocks;
        for (&[a, b, c], out) in planes.iter().zip(out) {
            for lane in 0..LANES {
                out.a[lane] = a[lane] as f32;
                out.b[lane] = b[lane] as f32;
            }
            for (row, y) in y.iter().enumerate().take(up + 1) {
                for (column, x) in x.iter().enumerate().take(across + 1) {
                    let to = &mut out.corners[row * WINDOW_BLOCKS + column];
                    for lane in 0..LANES {
                        to[lane] = ((x[lane] * a[lane] + y[lane] * b[lane]) + c[lane]) as f32;
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
