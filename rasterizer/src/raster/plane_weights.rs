//! The planes that weight the vertices of up to 64 triangles, and the sums of them: the arithmetic of
//! [`super::interpolate`], in the same order, over lanes.

use crate::desc::Viewport;
use crate::primitive::InverseMatrix;
use texunit::lanes::{F32s, F64s, LANES, Simd, U32s};

/// `a`, `b` and `c` of a plane of each.
pub type PlaneLanes = [F64s; 3];

const PLANE: PlaneLanes = [F64s::ZERO; 3];

/// The planes that weight the three vertices; see [`crate::primitive::VertexPlanes`].
#[derive(Debug)]
pub struct Weights {
    view: View,
    /// x, y and w in clip coordinates of each vertex.
    clip: [[F64s; 3]; 3],
    projective: [PlaneLanes; 3],
    /// The weights of smooth values, and of their denominator; a parallel view needs neither.
    smooth: [PlaneLanes; 3],
    denominator: PlaneLanes,
}

/// The projection of the vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum View {
    /// Undivided: w is 1 at all of them.
    Parallel,
    Perspective,
}

impl Default for Weights {
    fn default() -> Self {
        Self {
            view: View::Parallel,
            clip: [PLANE; 3],
            projective: [PLANE; 3],
            smooth: [PLANE; 3],
            denominator: PLANE,
        }
    }
}

impl View {
    /// Of vertices of which this is x, y, z and w.
    #[inline(always)]
    fn of<S: Simd>(vertices: &[[F32s; 4]; 3]) -> Self {
        let [[.., first], [.., second], [.., third]] = vertices;
        let mut other = U32s::ZERO;
        for lane in 0..LANES {
            let bits = |w: f32| w.to_bits() ^ 1.0_f32.to_bits();
            other[lane] = bits(first[lane]) | bits(second[lane]) | bits(third[lane]);
        }
        if S::any(&other) { Self::Perspective } else { Self::Parallel }
    }
}

/// From clip coordinates to the window: half the viewport's sides, and its centre.
#[derive(Clone, Copy, Debug)]
struct ToWindow {
    half: [f64; 2],
    center: [f64; 2],
}

impl ToWindow {
    /// A homogeneous position, from an origin.
    #[inline(always)]
    fn position(self, [x, y, w]: [f64; 3], origin: [f64; 2]) -> [f64; 3] {
        let Self { half, center } = self;
        [x * half[0] + w * (center[0] - origin[0]), y * half[1] + w * (center[1] - origin[1]), w]
    }
}

impl Weights {
    /// Of triangles whose vertices these are (x, y, z and w of each), from an origin of each. Marks the triangles that
    /// are too thin in `needs_scalar_path`.
    #[inline(always)]
    pub fn compute<S: Simd>(
        &mut self,
        vertices: &[[F32s; 4]; 3],
        origin: &[F64s; 2],
        viewport: &Viewport,
        needs_scalar_path: &mut [u64; LANES],
    ) {
        for (clip, [x, y, _, w]) in self.clip.iter_mut().zip(vertices) {
            for (to, from) in clip.iter_mut().zip([x, y, w]) {
                for lane in 0..LANES {
                    to[lane] = from[lane].into();
                }
            }
        }
        let window = ToWindow { half: viewport.half(), center: viewport.center() };
        self.view = View::of::<S>(vertices);
        match self.view {
            View::Parallel => self.parallel(origin, window, needs_scalar_path),
            View::Perspective => self.perspective(origin, window, needs_scalar_path),
        }
    }

    #[inline(always)]
    fn perspective(
        &mut self,
        origin: &[F64s; 2],
        window: ToWindow,
        needs_scalar_path: &mut [u64; LANES],
    ) {
        let Self { clip, projective, smooth, denominator, .. } = self;
        for lane in 0..LANES {
            let from = [origin[0][lane], origin[1][lane]];
            let p = |k: usize| {
                window.position([clip[k][0][lane], clip[k][1][lane], clip[k][2][lane]], from)
            };
            let (p0, p1, p2) = (p(0), p(1), p(2));
            let inverse = InverseMatrix::of([p0, p1, p2]);
            let ([r0, r1, r2], scale) = (inverse.adjugate, inverse.scale());
            let same = (p0[2] == p1[2]) & (p0[2] == p2[2]);
            for part in 0..3 {
                let row = [r0[part] * scale, r1[part] * scale, r2[part] * scale];
                projective[0][part][lane] = row[0];
                projective[1][part][lane] = row[1];
                projective[2][part][lane] = row[2];
                let sum = row[0] * 1.0 + row[1] * 1.0 + row[2] * 1.0;
                let one = if part == 2 { 1.0 } else { 0.0 };
                denominator[part][lane] = if same { one } else { sum };
                smooth[0][part][lane] = if same { row[0] * p0[2] } else { row[0] };
                smooth[1][part][lane] = if same { row[1] * p1[2] } else { row[1] };
                smooth[2][part][lane] = if same { row[2] * p2[2] } else { row[2] };
            }
            needs_scalar_path[lane] |= u64::from(!inverse.is_thick());
        }
    }

    /// The same for a parallel view: no products with w.
    #[inline(always)]
    fn parallel(
        &mut self,
        origin: &[F64s; 2],
        window: ToWindow,
        needs_scalar_path: &mut [u64; LANES],
    ) {
        let Self { clip, projective: [first, second, third], .. } = self;
        for lane in 0..LANES {
            let from = [origin[0][lane], origin[1][lane]];
            let p = |k: usize| window.position([clip[k][0][lane], clip[k][1][lane], 1.0], from);
            let inverse = InverseMatrix::of([p(0), p(1), p(2)]);
            let ([r0, r1, r2], scale) = (inverse.adjugate, inverse.scale());
            for part in 0..3 {
                first[part][lane] = r0[part] * scale;
                second[part][lane] = r1[part] * scale;
                third[part][lane] = r2[part] * scale;
            }
            needs_scalar_path[lane] |= u64::from(!inverse.is_thick());
        }
    }

    /// The weights of depth.
    #[inline(always)]
    pub fn projective(&self) -> &[PlaneLanes; 3] {
        &self.projective
    }

    /// The weights of smooth values.
    #[inline(always)]
    pub fn smooth(&self) -> &[PlaneLanes; 3] {
        match self.view {
            View::Parallel => &self.projective,
            View::Perspective => &self.smooth,
        }
    }

    /// The denominator plane of smooth values.
    #[inline(always)]
    pub fn denominator(&self) -> PlaneLanes {
        match self.view {
            View::Parallel => [F64s::ZERO, F64s::ZERO, F64s::splat(1.0)],
            View::Perspective => self.denominator,
        }
    }
}

/// `Plane::sum` of one of four values; marks the lanes whose planes are not finite.
#[inline(always)]
pub fn sum(
    rows: &[PlaneLanes; 3],
    values: &[[F32s; 4]; 3],
    at: usize,
    out: &mut PlaneLanes,
    needs_scalar_path: &mut [u64; LANES],
) {
    let [first, second, third] = rows;
    let [a, b, c] = out;
    for lane in 0..LANES {
        let (x, y) = (f64::from(values[0][at][lane]), f64::from(values[1][at][lane]));
        let z = f64::from(values[2][at][lane]);
        a[lane] = first[0][lane] * x + second[0][lane] * y + third[0][lane] * z;
        b[lane] = first[1][lane] * x + second[1][lane] * y + third[1][lane] * z;
        c[lane] = first[2][lane] * x + second[2][lane] * y + third[2][lane] * z;
        let finite = a[lane].is_finite() & b[lane].is_finite() & c[lane].is_finite();
        needs_scalar_path[lane] |= u64::from(!finite);
    }
}

/// From normalized device coordinates to the depth range (GL 2.1, section 2.11.1).
#[inline(always)]
pub fn to_depth(plane: &mut PlaneLanes, scale: f64, add: f64) {
    for part in plane.iter_mut() {
        for value in &mut part.0 {
            *value *= scale;
        }
    }
    for value in &mut plane[2].0 {
        *value += add;
    }
}
