//! The inputs of a fragment program: planes at the pixels of a batch.

use super::batch::{Batch, BlockOf, Packed, QUAD_X, QUAD_Y, Quads, front_word};
use super::depths::clamp_depth;
use super::pixels::Pixels;
use super::run::BlockRun;
use super::samples::SampleMasks;
use crate::ir::Axis;
use crate::plan::{DrawPlan, FilledInput, FragmentInput};
use crate::primitive::Facing;
use crate::shader::Machine;
use texunit::lanes::{F32s, Kernel, LANES, QUADS, Simd, U32s};

/// What a batch has for pixel `e` of its quad `q`.
pub(super) trait Places {
    /// A plane: at the first pixel of the block, per pixel across, per pixel up.
    fn plane(&self, plane: usize) -> impl Fn(usize, usize) -> [f32; 3];
    /// Whether a plane is known to be 1 at every lane.
    fn is_one(&self, plane: usize) -> bool;
    /// Its column and row in its block.
    fn within(&self, e: usize, q: usize) -> [f32; 2];
    /// The first pixel of its block.
    fn block(&self, e: usize, q: usize) -> [f32; 2];
    fn front(&self, e: usize, q: usize) -> u32;
    fn coverage(&self) -> Option<&F32s>;
}

impl Places for BlockOf<'_> {
    #[inline(always)]
    fn plane(&self, plane: usize) -> impl Fn(usize, usize) -> [f32; 3] {
        let plane = self.planes[plane];
        move |_, _| plane
    }
    #[inline(always)]
    fn is_one(&self, plane: usize) -> bool {
        self.planes[plane] == [1.0, 0.0, 0.0]
    }
    #[inline(always)]
    fn within(&self, e: usize, q: usize) -> [f32; 2] {
        [QUAD_X[q] + X[e], QUAD_Y[q] + Y[e]]
    }
    #[inline(always)]
    fn block(&self, _e: usize, _q: usize) -> [f32; 2] {
        [self.x as f32, self.y as f32]
    }
    #[inline(always)]
    fn front(&self, _e: usize, _q: usize) -> u32 {
        front_word(self.facing)
    }
    #[inline(always)]
    fn coverage(&self) -> Option<&F32s> {
        self.coverage
    }
}

impl Places for Packed {
    #[inline(always)]
    fn plane(&self, plane: usize) -> impl Fn(usize, usize) -> [f32; 3] {
        let plane = &self.planes[plane];
        move |_, q| [plane.corner[q], plane.a[q], plane.b[q]]
    }
    #[inline(always)]
    fn is_one(&self, _plane: usize) -> bool {
        false
    }
    #[inline(always)]
    fn within(&self, e: usize, q: usize) -> [f32; 2] {
        [self.dx[q] + X[e], self.dy[q] + Y[e]]
    }
    #[inline(always)]
    fn block(&self, _e: usize, q: usize) -> [f32; 2] {
        [self.x[q], self.y[q]]
    }
    #[inline(always)]
    fn front(&self, _e: usize, q: usize) -> u32 {
        self.front[q]
    }
    #[inline(always)]
    fn coverage(&self) -> Option<&F32s> {
        Some(&self.coverage)
    }
}

impl Places for Pixels {
    #[inline(always)]
    fn plane(&self, plane: usize) -> impl Fn(usize, usize) -> [f32; 3] {
        let plane = &self.planes[plane];
        move |e, q| {
            let lane = e * QUADS + q;
            [plane.corner[lane], plane.a[lane], plane.b[lane]]
        }
    }
    #[inline(always)]
    fn is_one(&self, plane: usize) -> bool {
        let plane = &self.planes[plane];
        let mut other = 0;
        for lane in 0..LANES {
            // A zero of any sign is none.
            let steps = (plane.a[lane].to_bits() | plane.b[lane].to_bits()) << 1;
            other |= plane.corner[lane].to_bits() ^ 1.0_f32.to_bits() | steps;
        }
        other == 0
    }
    #[inline(always)]
    fn within(&self, e: usize, q: usize) -> [f32; 2] {
        [self.within[0][e * QUADS + q], self.within[1][e * QUADS + q]]
    }
    #[inline(always)]
    fn block(&self, e: usize, q: usize) -> [f32; 2] {
        [self.block[0][e * QUADS + q], self.block[1][e * QUADS + q]]
    }
    #[inline(always)]
    fn front(&self, e: usize, q: usize) -> u32 {
        let is_back = self.back >> (e * QUADS + q) & 1 == 1;
        front_word(if is_back { Facing::Back } else { Facing::Front })
    }
    #[inline(always)]
    fn coverage(&self) -> Option<&F32s> {
        None
    }
}

/// Fills the input registers of a program from a batch, and the depth of each lane if shading needs it.
pub struct Interpolate<'a> {
    /// The draw.
    pub plan: &'a DrawPlan,
    /// The quads.
    pub batch: &'a Batch<'a>,
    /// Takes the inputs.
    pub machine: &'a mut Machine,
    /// Takes the depth, where the plan has a plane for it.
    pub depth: &'a mut F32s,
}

impl Kernel for Interpolate<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, batch, machine, depth } = self;
        let inputs = &plan.filled[..];
        let mut fill = Fill { plan, inputs, masks: batch.masks, machine, bank: 0, depth };
        match batch.quads {
            Quads::Block(block) => fill.fill::<S>(block),
            Quads::Packed(packed) => fill.fill::<S>(packed),
            Quads::Pixels(pixels) => fill.fill::<S>(pixels),
        }
    }
}

/// Fills the input registers of a program from a run, bank by bank.
pub struct InterpolateRun<'a> {
    /// The draw.
    pub plan: &'a DrawPlan,
    /// What is filled of the first bank, and of the others.
    pub inputs: [&'a [FilledInput]; 2],
    /// The blocks.
    pub run: &'a BlockRun,
    /// The first pixel of their tile.
    pub tile: [i32; 2],
    /// Takes the inputs.
    pub machine: &'a mut Machine,
}

impl Kernel for InterpolateRun<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, inputs: [first, others], run, tile, machine } = self;
        let (masks, mut depth) = (&SampleMasks::default(), F32s::ZERO);
        let depth = &mut depth;
        for (bank, block) in run.blocks(tile).enumerate() {
            let inputs = if bank == 0 { first } else { others };
            Fill { plan, inputs, masks, machine, bank, depth }.fill::<S>(&block);
        }
    }
}

/// Fills the input registers of a bank.
struct Fill<'a> {
    plan: &'a DrawPlan,
    inputs: &'a [FilledInput],
    masks: &'a SampleMasks,
    machine: &'a mut Machine,
    bank: usize,
    depth: &'a mut F32s,
}

impl Fill<'_> {
    #[inline(always)]
    fn fill<S: Simd>(&mut self, places: &impl Places) {
        let Self { plan, inputs, masks, machine, bank, depth } = self;
        // Planes and registers may overlap as far as the compiler knows: what is computed here is
        // computed on the stack and stored whole.
        if let Some(index) = plan.depth_plane.filter(|_| plan.shades_depth) {
            **depth = evaluate::<S>(places, index);
            clamp_depth(depth, plan.viewport.depths());
        }
        let mut w = F32s::splat(1.0);
        let denominator = plan.denominator_plane.unwrap_or(0);
        // Of shapes that do not lie in perspective nothing is divided.
        let is_divided = plan.denominator_plane.is_some_and(|index| !places.is_one(index));
        if is_divided {
            w = evaluate::<S>(places, denominator);
            invert::<S>(&mut w);
        }
        let mut centroids = [F32s::ZERO; 2];
        if plan.centroids {
            centroids = plan.samples.centroids(masks);
        }
        let registers = machine.inputs_of(*bank);
        for &FilledInput { number, from } in *inputs {
            let Some(out) = registers.get_mut(number) else { continue };
            match from {
                FragmentInput::Smooth(index) if is_divided => {
                    *out.as_f32_mut() = divided::<S>(places, [index, denominator], &w);
                }
                FragmentInput::Smooth(index) => *out.as_f32_mut() = evaluate::<S>(places, index),
                FragmentInput::Linear(index) => *out.as_f32_mut() = evaluate::<S>(places, index),
                FragmentInput::SmoothWithin(index) => {
                    let mut value = within::<S>(places, index, &centroids);
                    let over = within::<S>(places, denominator, &centroids);
                    for lane in 0..LANES {
                        value[lane] *= 1.0 / over[lane];
                    }
                    *out.as_f32_mut() = value;
                }
                FragmentInput::LinearWithin(index) => {
                    *out.as_f32_mut() = within::<S>(places, index, &centroids);
                }
                FragmentInput::SmoothSlope(index, axis) => {
                    let mut slope = evaluate::<S>(places, index);
                    let (of, by) = (places.plane(index), places.plane(denominator));
                    let steps = |e, q| [along(axis, of(e, q)), along(axis, by(e, q))];
                    let [a, b, c, d] = pixels(&mut slope);
                    let [ia, ib, ic, id] = pixels(&mut w);
                    slope_pixel(steps, 0, ia, a);
                    slope_pixel(steps, 1, ib, b);
                    slope_pixel(steps, 2, ic, c);
                    slope_pixel(steps, 3, id, d);
                    *out.as_f32_mut() = slope;
                }
                FragmentInput::LinearSlope(index, axis) => {
                    let plane = places.plane(index);
                    by_quad(out, |e, q| along(axis, plane(e, q)).to_bits());
                }
                FragmentInput::Depth => *out.as_f32_mut() = **depth,
                FragmentInput::Flat(index) => {
                    let plane = places.plane(index);
                    by_quad(out, |e, q| plane(e, q)[0].to_bits());
                }
                FragmentInput::X => by_quad(out, |e, q| {
                    (places.block(e, q)[0] + (places.within(e, q)[0] + 0.5)).to_bits()
                }),
                FragmentInput::Y => by_quad(out, |e, q| {
                    (places.block(e, q)[1] + (places.within(e, q)[1] + 0.5)).to_bits()
                }),
                FragmentInput::Front => by_quad(out, |e, q| places.front(e, q)),
                FragmentInput::Coverage => {
                    if let Some(coverage) = places.coverage() {
                        *out.as_f32_mut() = *coverage;
                    }
                }
                // Was set when the draw began, and is not filled.
                FragmentInput::Zero => {}
            }
        }
    }
}

/// Column of each pixel of a quad.
const X: [f32; 4] = [0.0, 1.0, 0.0, 1.0];
/// Row of each pixel of a quad.
const Y: [f32; 4] = [0.0, 0.0, 1.0, 1.0];

/// A plane over the denominator's, given its inverse. Where both are the same plane that is 1: what is 1 at all
/// vertices is so in between.
#[inline(always)]
fn divided<S: Simd>(
    places: &impl Places,
    [plane, denominator]: [usize; 2],
    inverse: &F32s,
) -> F32s {
    let mut out = evaluate::<S>(places, plane);
    let (of, by) = (places.plane(plane), places.plane(denominator));
    let is_one = |e, q| of(e, q) == by(e, q);
    let [a, b, c, d] = pixels(&mut out);
    divide_pixel(is_one, 0, inverse, a);
    divide_pixel(is_one, 1, inverse, b);
    divide_pixel(is_one, 2, inverse, c);
    divide_pixel(is_one, 3, inverse, d);
    out
}

/// One pixel of each quad times the inverse, or 1.
#[inline(always)]
fn divide_pixel(
    is_one: impl Fn(usize, usize) -> bool,
    e: usize,
    inverse: &F32s,
    out: &mut [f32; QUADS],
) {
    for (q, out) in out.iter_mut().enumerate() {
        let quotient = *out * inverse[e * QUADS + q];
        *out = if is_one(e, q) { 1.0 } else { quotient };
    }
}

/// How a plane changes along an axis.
#[inline(always)]
fn along(axis: Axis, [_, a, b]: [f32; 3]) -> f32 {
    match axis {
        Axis::X => a,
        Axis::Y => b,
    }
}

/// The inverse of each lane. Where nothing is in perspective they are alike, and one division does.
#[inline(always)]
fn invert<S: Simd>(lanes: &mut F32s) {
    let first = lanes[0].to_bits();
    let mut different = U32s::ZERO;
    for lane in 0..LANES {
        different[lane] = lanes[lane].to_bits() ^ first;
    }
    if !S::any(&different) {
        *lanes = F32s::splat(1.0 / lanes[0]);
        return;
    }
    for lane in 0..LANES {
        lanes[lane] = 1.0 / lanes[lane];
    }
}

/// Fills lanes from the pixel of the quad and the quad.
#[inline(always)]
fn by_quad(out: &mut U32s, word: impl Fn(usize, usize) -> u32) {
    for lane in 0..LANES {
        out[lane] = word(lane / QUADS, lane % QUADS);
    }
}

/// A plane at every lane.
#[inline(always)]
fn evaluate<S: Simd>(places: &impl Places, plane: usize) -> F32s {
    S::apart_unless_wide(Evaluate { places, plane })
}

struct Evaluate<'a, P> {
    places: &'a P,
    plane: usize,
}

impl<P: Places> Kernel for Evaluate<'_, P> {
    type Output = F32s;
    #[inline(always)]
    fn run<S: Simd>(self) -> F32s {
        evaluate_plane(self.places, self.places.plane(self.plane))
    }
}

#[inline(always)]
pub(super) fn evaluate_plane(
    places: &impl Places,
    plane: impl Fn(usize, usize) -> [f32; 3],
) -> F32s {
    let mut out = F32s::ZERO;
    let [first, second, third, fourth] = pixels(&mut out);
    evaluate_pixel(places, &plane, 0, first);
    evaluate_pixel(places, &plane, 1, second);
    evaluate_pixel(places, &plane, 2, third);
    evaluate_pixel(places, &plane, 3, fourth);
    out
}

/// A plane at one pixel of each quad.
#[inline(always)]
fn evaluate_pixel(
    places: &impl Places,
    plane: &impl Fn(usize, usize) -> [f32; 3],
    e: usize,
    out: &mut [f32; QUADS],
) {
    for (q, out) in out.iter_mut().enumerate() {
        *out = value(plane(e, q), places.within(e, q));
    }
}

/// A plane at a place in its block.
#[inline(always)]
pub(super) fn value([corner, a, b]: [f32; 3], [dx, dy]: [f32; 2]) -> f32 {
    (corner + dx * a) + dy * b
}

/// The derivative of the quotient of two planes at one pixel of each quad, given the steps of both:
/// `(n / d)' = (n' - n / d · d') / d`, of `1 / d` and, in `out`, `n`.
#[inline(always)]
fn slope_pixel(
    steps: impl Fn(usize, usize) -> [f32; 2],
    e: usize,
    inverse: &[f32; QUADS],
    out: &mut [f32; QUADS],
) {
    for q in 0..QUADS {
        let [of, by] = steps(e, q);
        let value = out[q] * inverse[q];
        out[q] = (of - value * by) * inverse[q];
    }
}

/// A plane at every lane, moved so far across and up from the pixel's centre.
#[inline(always)]
fn within<S: Simd>(places: &impl Places, plane: usize, [x, y]: &[F32s; 2]) -> F32s {
    let mut out = evaluate::<S>(places, plane);
    let plane = places.plane(plane);
    for lane in 0..LANES {
        let [_, a, b] = plane(lane / QUADS, lane % QUADS);
        out[lane] += x[lane] * a + y[lane] * b;
    }
    out
}

/// The lanes by pixel of the quad. A loop over pixels around a loop over quads would be vectorized
/// the wrong way round, with scattered stores.
#[inline(always)]
fn pixels(lanes: &mut F32s) -> &mut [[f32; QUADS]; 4] {
    bytemuck::cast_mut(&mut lanes.0)
}

impl Batch<'_> {
    /// A plane at one lane.
    pub fn at(&self, plane: usize, lane: usize) -> f32 {
        let (plane, within) = self.place_of(plane, lane);
        value(plane, within)
    }

    /// A plane at one lane, moved so far across and up from the pixel's centre.
    pub fn at_moved(&self, plane: usize, lane: usize, [x, y]: &[F32s; 2]) -> f32 {
        let (plane, within) = self.place_of(plane, lane);
        let [_, a, b] = plane;
        value(plane, within) + (x[lane] * a + y[lane] * b)
    }

    /// A plane, and the column and row of a lane in its block.
    fn place_of(&self, plane: usize, lane: usize) -> ([f32; 3], [f32; 2]) {
        let (e, q) = (lane / QUADS, lane % QUADS);
        match self.quads {
            Quads::Block(block) => (block.plane(plane)(e, q), block.within(e, q)),
            Quads::Packed(packed) => (packed.plane(plane)(e, q), packed.within(e, q)),
            Quads::Pixels(pixels) => (pixels.plane(plane)(e, q), pixels.within(e, q)),
        }
    }
}
