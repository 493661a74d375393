//! The planes of up to 64 shapes of a chunk, computed together: the arithmetic of
//! [`super::interpolate`], in the same order, over lanes of triangles.

use super::interpolate::{PlaneSetup, PlaneSource, Planes};
use crate::primitive::{Kind, SUBPIXEL, Shape};
use crate::vertex::{Geometry, Outcode};
use texunit::lanes::{Isa, Kernel, LANES, Simd};

/// A value of each of 64 shapes.
type F64s = [f64; LANES];
/// `a`, `b` and `c` of a plane of each.
type PlaneLanes = [F64s; 3];

/// Fewer shapes than this are computed one by one.
const WORTH_IT: usize = 6;

const ZERO: F64s = [0.0; LANES];

/// The planes of up to 64 shapes.
#[derive(Debug, Default)]
pub struct PlaneGroup {
    /// In the order of [`PlaneSetup::sources`].
    planes: Vec<PlaneLanes>,
    single: Planes,
    lanes: Box<Lanes>,
}

/// What the kernels read and write.
#[derive(Debug)]
struct Lanes {
    /// x, y and w in clip coordinates of each vertex.
    clip: [[F64s; 3]; 3],
    window: [[F64s; 2]; 3],
    origin: [F64s; 2],
    /// The values that a plane interpolates, by vertex.
    values: [F64s; 3],
    rows: Rows,
    /// Not zero where the general computation must do it.
    general: [u64; LANES],
}

/// The planes that weight the three vertices; see `interpolate::Rows`.
#[derive(Debug)]
struct Rows {
    projective: [PlaneLanes; 3],
    smooth: [PlaneLanes; 3],
    denominator: PlaneLanes,
}

impl Default for Lanes {
    fn default() -> Self {
        const PLANE: PlaneLanes = [ZERO; 3];
        Self {
            clip: [[ZERO; 3]; 3],
            window: [[ZERO; 2]; 3],
            origin: [ZERO; 2],
            values: [ZERO; 3],
            rows: Rows { projective: [PLANE; 3], smooth: [PLANE; 3], denominator: PLANE },
            general: [0; LANES],
        }
    }
}

impl PlaneGroup {
    /// The value of each plane at the centre of pixel `(x, y)` and its steps, of the shape `lane`.
    #[inline]
    pub fn at(&self, lane: usize, x: i32, y: i32, out: &mut [[f32; 3]]) {
        let lane = lane % LANES;
        let dx = f64::from(x) + 0.5 - self.lanes.origin[0][lane];
        let dy = f64::from(y) + 0.5 - self.lanes.origin[1][lane];
        for (out, plane) in out.iter_mut().zip(&self.planes) {
            let (a, b, c) = (plane[0][lane], plane[1][lane], plane[2][lane]);
            *out = [((dx * a + dy * b) + c) as f32, a as f32, b as f32];
        }
    }

    /// Computes the planes of `shapes`, at most 64.
    pub fn compute<'a>(
        &mut self,
        isa: Isa,
        setup: &PlaneSetup<'_>,
        geometry: &Geometry,
        shapes: impl ExactSizeIterator<Item = &'a Shape> + Clone,
    ) {
        self.planes.resize(setup.sources.len(), [ZERO; 3]);
        let plain = setup.offset.is_none()
            && setup.sources.iter().all(|source| match source {
                PlaneSource::Depth
                | PlaneSource::Denominator
                | PlaneSource::Smooth(_)
                | PlaneSource::Flat(_) => true,
                PlaneSource::InverseW
                | PlaneSource::NoPerspective(_)
                | PlaneSource::PointCoord(_)
                | PlaneSource::Sprite(..) => false,
            });
        let together = plain && shapes.len() >= WORTH_IT;
        if together {
            self.together(isa, setup, geometry, shapes.clone());
        }
        for (lane, shape) in shapes.enumerate().take(LANES) {
            if together && self.lanes.general[lane] == 0 {
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

    fn together<'a>(
        &mut self,
        isa: Isa,
        setup: &PlaneSetup<'_>,
        geometry: &Geometry,
        shapes: impl Iterator<Item = &'a Shape> + Clone,
    ) {
        let lanes = &mut *self.lanes;
        for (lane, shape) in shapes.clone().enumerate().take(LANES) {
            for axis in 0..2 {
                let origin = f64::from(shape.corners[0][axis]) / f64::from(SUBPIXEL);
                lanes.origin[axis][lane] = origin;
            }
            let mut any = 0;
            for (k, &v) in shape.vertices.iter().enumerate() {
                let vertex = &geometry.vertices[v as usize];
                any |= vertex.outcode.0;
                for (part, component) in [0, 1, 3].into_iter().enumerate() {
                    lanes.clip[k][part][lane] = vertex.clip[component].into();
                }
                for axis in 0..2 {
                    lanes.window[k][axis][lane] = vertex.window[axis];
                }
            }
            // The planes of a cut triangle are those of thick ones, whatever it looks like.
            let general = shape.kind != Kind::Triangle || any & Outcode::CUT != 0;
            lanes.general[lane] = u64::from(general);
        }
        let (half, center) = (setup.viewport.half(), setup.viewport.center());
        isa.run(ComputeRows { lanes, half, center });
        for (source, out) in setup.sources.iter().zip(&mut self.planes) {
            let Lanes { rows, values, general, .. } = lanes;
            match *source {
                PlaneSource::Denominator => *out = rows.denominator,
                PlaneSource::Flat(at) => {
                    *out = [ZERO; 3];
                    for (lane, shape) in shapes.clone().enumerate().take(LANES) {
                        let vertex = shape.vertices[usize::from(shape.provoking)];
                        out[2][lane] = geometry.varyings_of(vertex)[at].into();
                    }
                }
                PlaneSource::Depth => {
                    gather(values, shapes.clone(), |v| geometry.vertices[v as usize].clip[2]);
                    let (near, far) =
                        (f64::from(setup.viewport.near), f64::from(setup.viewport.far));
                    isa.run(Sum { rows: &rows.projective, values, out, general });
                    isa.run(ToDepth { scale: (far - near) * 0.5, add: (near + far) * 0.5, out });
                }
                PlaneSource::Smooth(at)
                | PlaneSource::NoPerspective(at)
                | PlaneSource::Sprite(at, _) => {
                    let stride = geometry.stride;
                    gather(values, shapes.clone(), |v| geometry.varyings[v as usize * stride + at]);
                    isa.run(Sum { rows: &rows.smooth, values, out, general });
                }
                PlaneSource::InverseW | PlaneSource::PointCoord(_) => {}
            }
        }
    }
}

/// A value of the three vertices of each shape.
#[inline]
fn gather<'a>(
    values: &mut [F64s; 3],
    shapes: impl Iterator<Item = &'a Shape>,
    value: impl Fn(u32) -> f32,
) {
    for (lane, shape) in shapes.enumerate().take(LANES) {
        for (values, &vertex) in values.iter_mut().zip(&shape.vertices) {
            values[lane] = value(vertex).into();
        }
    }
}

/// `interpolate::Rows::new` of triangles. Those that are too thin are left to the general
/// computation.
struct ComputeRows<'a> {
    lanes: &'a mut Lanes,
    half: [f64; 2],
    center: [f64; 2],
}

impl Kernel for ComputeRows<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { lanes: Lanes { clip, window, origin, rows, general, .. }, half, center } = self;
        let Rows { projective, smooth, denominator } = rows;
        for lane in 0..LANES {
            let p = |k: usize| {
                let (x, y, w) = (clip[k][0][lane], clip[k][1][lane], clip[k][2][lane]);
                [
                    x * half[0] + w * (center[0] - origin[0][lane]),
                    y * half[1] + w * (center[1] - origin[1][lane]),
                    w,
                ]
            };
            let (p0, p1, p2) = (p(0), p(1), p(2));
            let (r0, r1, r2) = (cross(p1, p2), cross(p2, p0), cross(p0, p1));
            let determinant = p0[0] * r0[0] + p0[1] * r0[1] + p0[2] * r0[2];
            let same = (p0[2] == p1[2]) & (p0[2] == p2[2]);
            for part in 0..3 {
                let row = [r0[part] / determinant, r1[part] / determinant, r2[part] / determinant];
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
        }
        for lane in 0..LANES {
            let side =
                |a: usize, b: usize, axis: usize| window[b][axis][lane] - window[a][axis][lane];
            let (s, t, u) = (
                [side(0, 1, 0), side(0, 1, 1)],
                [side(0, 2, 0), side(0, 2, 1)],
                [side(1, 2, 0), side(1, 2, 1)],
            );
            let doubled_area = (s[0] * t[1] - t[0] * s[1]).abs();
            let square = |e: [f64; 2]| e[0] * e[0] + e[1] * e[1];
            let (s, t, u) = (square(s), square(t), square(u));
            let longest = if s > t { s } else { t };
            let longest = if longest > u { longest } else { u };
            let thick = doubled_area * doubled_area >= longest / 64.0;
            general[lane] |= u64::from(!thick);
        }
    }
}

#[inline(always)]
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// `Plane::sum`; marks the lanes whose planes are not finite.
struct Sum<'a> {
    rows: &'a [PlaneLanes; 3],
    values: &'a [F64s; 3],
    out: &'a mut PlaneLanes,
    general: &'a mut [u64; LANES],
}

impl Kernel for Sum<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { rows, values, out, general } = self;
        for part in 0..3 {
            for lane in 0..LANES {
                let sum = rows[0][part][lane] * values[0][lane]
                    + rows[1][part][lane] * values[1][lane]
                    + rows[2][part][lane] * values[2][lane];
                out[part][lane] = sum;
                general[lane] |= u64::from(!sum.is_finite());
            }
        }
    }
}

/// From normalized device coordinates to the depth range (GL 2.1, section 2.11.1).
struct ToDepth<'a> {
    scale: f64,
    add: f64,
    out: &'a mut PlaneLanes,
}

impl Kernel for ToDepth<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { scale, add, out } = self;
        for part in out.iter_mut() {
            for value in part {
                *value *= scale;
            }
        }
        for value in &mut out[2] {
            *value += add;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::driver::{SpriteOrigin, Viewport};
    use crate::primitive::Facing;
    use crate::vertex::ShadedVertex;

    /// A number in [-1, 1) from a counter.
    fn random(state: &mut u64) -> f32 {
        *state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 40) as f32 / 8_388_608.0 - 1.0
    }

    #[test]
    fn shapes_together_have_the_planes_they_have_alone() {
        let viewport =
            Viewport { x: 3.0, y: 5.0, width: 640.0, height: 480.0, near: 0.25, far: 1.0 };
        let mut state = 9;
        let mut geometry = Geometry::default();
        geometry.stride = 3;
        let mut shapes = Vec::new();
        for n in 0..64_u32 {
            let w = if n % 3 == 0 { 1.0 } else { 0.0 };
            for k in 0..3 {
                let w = if w > 0.0 { w } else { 1.5 + random(&mut state) };
                // Some thin, some degenerate, some huge.
                let size = [0.01, 1e-7, 1.0, 0.0][n as usize % 4];
                let (x, y) = (random(&mut state) * size + 0.3, random(&mut state) * size - 0.2);
                let clip = [x * w, y * w, random(&mut state) * w, w];
                let window = viewport.window(&clip.map(f64::from));
                geometry.vertices.push(ShadedVertex {
                    clip,
                    window,
                    snapped: window.map(crate::vertex::snap),
                    outcode: Outcode(if n % 11 == 0 && k == 0 { Outcode::NEAR } else { 0 }),
                    ..ShadedVertex::default()
                });
                geometry.varyings.extend([0; 3].map(|_| random(&mut state)));
            }
            let vertices = [3 * n, 3 * n + 1, 3 * n + 2];
            shapes.push(Shape {
                corners: vertices.map(|v| geometry.vertices[v as usize].snapped),
                bounds: [[0; 2]; 2],
                vertices,
                provoking: 2,
                kind: Kind::Triangle,
                facing: Facing::Front,
            });
        }
        let setup = PlaneSetup {
            sources: &[
                PlaneSource::Depth,
                PlaneSource::Denominator,
                PlaneSource::Smooth(0),
                PlaneSource::Smooth(2),
                PlaneSource::Flat(1),
            ],
            viewport,
            offset: None,
            resolution: None,
            origin: SpriteOrigin::UpperLeft,
        };
        let bits = |group: &PlaneGroup, lane: usize| {
            let mut out = [[0.0; 3]; 5];
            group.at(lane, 320, 200, &mut out);
            out.concat().into_iter().map(f32::to_bits).collect::<Vec<_>>()
        };
        let mut alone = PlaneGroup::default();
        for isa in Isa::available() {
            let mut together = PlaneGroup::default();
            together.compute(isa, &setup, &geometry, shapes.iter());
            for (lane, shape) in shapes.iter().enumerate() {
                alone.compute(isa, &setup, &geometry, std::iter::once(shape));
                assert_eq!(bits(&together, lane), bits(&alone, 0), "{} {lane}", isa.name());
            }
        }
    }
}
