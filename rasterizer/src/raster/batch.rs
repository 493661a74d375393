//! A batch of fragments: up to 16 quads, of one block or of many, of one shape or of many.

use super::samples::{SampleMasks, moved};
use crate::ir::Axis;
use crate::plan::{DrawPlan, FragmentInput};
use crate::primitive::Facing;
use crate::shader::Machine;
use crate::target::{MAX_SAMPLES, Place};
use texunit::lanes::{F32s, Kernel, LANES, QUADS, Simd, U32s};

/// The three numbers of a plane for each quad: at the first pixel of its block, per pixel across,
/// per pixel up.
#[derive(Clone, Debug)]
struct QuadPlane {
    corner: [f32; QUADS],
    a: [f32; QUADS],
    b: [f32; QUADS],
}

/// The quads that are to be shaded together.
#[derive(Debug)]
pub struct Batch {
    /// How many quads.
    len: usize,
    /// The block of the tile that it is, if it is one.
    block: Option<usize>,
    /// Which lanes are covered, by sample.
    pub masks: SampleMasks,
    /// Lanes of quads that went through the early tests before they came here.
    pub tested: u64,
    /// Which block of the tile each quad is in.
    blocks: [u8; QUADS],
    /// Which quad of its block each is.
    quads: [u8; QUADS],
    /// Its first pixel within the block.
    dx: [f32; QUADS],
    dy: [f32; QUADS],
    /// The first pixel of the block.
    x: [f32; QUADS],
    y: [f32; QUADS],
    front: [u32; QUADS],
    /// The part of each lane's pixel that is covered, where the draw asks.
    coverage: F32s,
    planes: Vec<QuadPlane>,
    /// By block: the lanes that wait in this batch.
    waiting: [u64; 64],
}

impl Default for Batch {
    fn default() -> Self {
        Self {
            len: 0,
            block: None,
            masks: [0; MAX_SAMPLES],
            tested: 0,
            blocks: [0; QUADS],
            quads: [0; QUADS],
            dx: [0.0; QUADS],
            dy: [0.0; QUADS],
            x: [0.0; QUADS],
            y: [0.0; QUADS],
            front: [0; QUADS],
            coverage: F32s::ZERO,
            planes: Vec::new(),
            waiting: [0; 64],
        }
    }
}

/// A block of a shape, to be put into a batch.
pub struct BlockOf<'a> {
    /// Of each plane: at its first pixel, per pixel across, per pixel up.
    pub planes: &'a [[f32; 3]],
    /// Which side is seen.
    pub facing: Facing,
    /// Whether its lanes went through the early tests, if there are any.
    pub tests: EarlyTests,
    /// Which block of the tile.
    pub block: usize,
    /// Its first pixel.
    pub x: i32,
    /// Its first row.
    pub y: i32,
    /// The part of each lane's pixel that is covered, where the draw asks.
    pub coverage: Option<&'a F32s>,
}

/// Whether fragments went through the early tests already.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EarlyTests {
    /// They did; what is left of them passed.
    Done,
    /// Their batch has to, if the draw has any.
    Due,
}

/// All lanes of quads.
#[inline]
fn lanes_of(quads: u16) -> u64 {
    let quads = u64::from(quads);
    quads | quads << QUADS | quads << (2 * QUADS) | quads << (3 * QUADS)
}

/// The lanes of quad `from`, as those of quad `to`.
#[inline]
pub fn moved_quad(lanes: u64, from: usize, to: usize) -> u64 {
    (lanes >> from & lanes_of(1)) << to
}

/// The quads of a mask of lanes, bit by quad.
#[inline]
pub fn quads_of(mask: u64) -> u16 {
    (mask | mask >> QUADS | mask >> (2 * QUADS) | mask >> (3 * QUADS)) as u16
}

impl Batch {
    /// Whether nothing waits.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Whether no quad fits any more.
    pub fn is_full(&self) -> bool {
        self.len == QUADS
    }

    /// Whether any of the lanes of a block waits here: what comes after must not overtake it.
    pub fn holds(&self, block: usize, lanes: u64) -> bool {
        self.waiting[block] & lanes != 0
    }

    /// Lanes that run: whole quads, so that derivatives have their neighbours.
    pub fn active(&self) -> u64 {
        lanes_of(quads_of(self.masks.iter().fold(0, |all, mask| all | mask)))
    }

    /// Lanes of back faces.
    pub fn back(&self) -> u64 {
        let mut quads = 0;
        for (quad, &front) in self.front.iter().enumerate().take(self.len) {
            quads |= u16::from(front == 0) << quad;
        }
        lanes_of(quads)
    }

    /// Where its pixels are.
    pub fn place(&self) -> Place<'_> {
        match self.block {
            Some(block) => Place::Block(block),
            None => Place::Quads(&self.blocks[..self.len], &self.quads[..self.len]),
        }
    }

    /// Forgets its quads and makes room for a draw with `planes` planes.
    pub fn clear(&mut self, planes: usize) {
        for &block in &self.blocks[..self.len] {
            self.waiting[usize::from(block)] = 0;
        }
        self.len = 0;
        self.masks = [0; MAX_SAMPLES];
        self.tested = 0;
        self.resize(planes);
    }

    fn resize(&mut self, planes: usize) {
        if self.planes.len() != planes {
            let none = QuadPlane { corner: [0.0; QUADS], a: [0.0; QUADS], b: [0.0; QUADS] };
            self.planes.resize(planes, none);
        }
    }

    /// Adds one quad of a block; `from` is its quad in `masks`, the covered lanes by sample.
    #[inline]
    pub fn push(&mut self, of: &BlockOf<'_>, quad: usize, from: usize, masks: &[u64]) {
        let at = self.len % QUADS;
        self.len += 1;
        self.blocks[at] = of.block as u8;
        self.quads[at] = quad as u8;
        self.dx[at] = QUAD_X[quad % QUADS];
        self.dy[at] = QUAD_Y[quad % QUADS];
        self.x[at] = of.x as f32;
        self.y[at] = of.y as f32;
        self.front[at] = front_word(of.facing);
        for (mask, &lanes) in self.masks.iter_mut().zip(masks) {
            *mask |= moved_quad(lanes, from, at);
            self.waiting[of.block] |= moved_quad(lanes, from, quad);
        }
        if of.tests == EarlyTests::Done {
            self.tested |= lanes_of(1 << at);
        }
        if let Some(coverage) = of.coverage {
            for e in 0..4 {
                self.coverage[e * QUADS + at] = coverage[e * QUADS + from];
            }
        }
        for (plane, &[corner, a, b]) in self.planes.iter_mut().zip(of.planes) {
            plane.corner[at] = corner;
            plane.a[at] = a;
            plane.b[at] = b;
        }
    }

    /// Makes it a whole block. A batch that is one never holds quads of others.
    pub fn set_block(&mut self, of: &BlockOf<'_>, masks: &[u64], planes: usize) {
        self.resize(planes);
        self.len = QUADS;
        self.block = Some(of.block);
        self.masks = [0; MAX_SAMPLES];
        self.masks[..masks.len()].copy_from_slice(masks);
        self.tested = match of.tests {
            EarlyTests::Done => !0,
            EarlyTests::Due => 0,
        };
        (self.dx, self.dy) = (QUAD_X, QUAD_Y);
        self.x = [of.x as f32; QUADS];
        self.y = [of.y as f32; QUADS];
        self.front = [front_word(of.facing); QUADS];
        if let Some(coverage) = of.coverage {
            self.coverage = *coverage;
        }
        for (plane, &[corner, a, b]) in self.planes.iter_mut().zip(of.planes) {
            plane.corner = [corner; QUADS];
            plane.a = [a; QUADS];
            plane.b = [b; QUADS];
        }
    }
}

/// Column of each quad's first pixel in its block.
const QUAD_X: [f32; QUADS] =
    [0.0, 2.0, 4.0, 6.0, 0.0, 2.0, 4.0, 6.0, 0.0, 2.0, 4.0, 6.0, 0.0, 2.0, 4.0, 6.0];
/// Row of each quad's first pixel in its block.
const QUAD_Y: [f32; QUADS] =
    [0.0, 0.0, 0.0, 0.0, 2.0, 2.0, 2.0, 2.0, 4.0, 4.0, 4.0, 4.0, 6.0, 6.0, 6.0, 6.0];

fn front_word(facing: Facing) -> u32 {
    match facing {
        Facing::Front => crate::ir::TRUE,
        Facing::Back => 0,
    }
}

/// Fills the input registers of a program from a batch, and the depth of each lane if a plane
/// holds it.
pub struct Interpolate<'a> {
    /// The draw.
    pub plan: &'a DrawPlan,
    /// The quads.
    pub batch: &'a Batch,
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
        // Planes and registers may overlap as far as the compiler knows: what is computed here is
        // computed on the stack and stored whole.
        if let Some(index) = plan.depth_plane {
            *depth = batch.evaluate(index);
            clamp_depth(depth);
        }
        let mut w = F32s::ZERO;
        let mut denominator = 0;
        if let Some(index) = plan.denominator_plane {
            denominator = index;
            let over = batch.evaluate(index);
            for lane in 0..LANES {
                w[lane] = 1.0 / over[lane];
            }
        }
        let mut centroids = [F32s::ZERO; 2];
        if plan.centroids {
            centroids = plan.samples.centroids(&batch.masks);
        }
        for (index, input) in plan.inputs.iter().enumerate() {
            let out = machine.input_mut(index);
            match *input {
                FragmentInput::Smooth(index) => {
                    let mut value = batch.evaluate(index);
                    for lane in 0..LANES {
                        value[lane] *= w[lane];
                    }
                    *out.as_f32_mut() = value;
                }
                FragmentInput::Linear(index) => *out.as_f32_mut() = batch.evaluate(index),
                FragmentInput::SmoothWithin(index) => {
                    let mut value = batch.within(index, &centroids);
                    let over = batch.within(denominator, &centroids);
                    for lane in 0..LANES {
                        value[lane] *= 1.0 / over[lane];
                    }
                    *out.as_f32_mut() = value;
                }
                FragmentInput::LinearWithin(index) => {
                    *out.as_f32_mut() = batch.within(index, &centroids);
                }
                FragmentInput::SmoothSlope(index, axis) => {
                    let mut slope = batch.evaluate(index);
                    let (of, by) = (*batch.slope(index, axis), *batch.slope(denominator, axis));
                    let [a, b, c, d] = pixels(&mut slope);
                    let [ia, ib, ic, id] = pixels(&mut w);
                    Batch::slope_pixel(&of, &by, ia, a);
                    Batch::slope_pixel(&of, &by, ib, b);
                    Batch::slope_pixel(&of, &by, ic, c);
                    Batch::slope_pixel(&of, &by, id, d);
                    *out.as_f32_mut() = slope;
                }
                FragmentInput::LinearSlope(index, axis) => {
                    by_quad(out, |_, q| batch.slope(index, axis)[q].to_bits());
                }
                FragmentInput::Depth => *out.as_f32_mut() = *depth,
                FragmentInput::Flat(index) => {
                    by_quad(out, |_, q| batch.planes[index].corner[q].to_bits());
                }
                FragmentInput::X => {
                    by_quad(out, |e, q| (batch.x[q] + (batch.dx[q] + X[e] + 0.5)).to_bits());
                }
                FragmentInput::Y => {
                    by_quad(out, |e, q| (batch.y[q] + (batch.dy[q] + Y[e] + 0.5)).to_bits());
                }
                FragmentInput::Front => by_quad(out, |_, q| batch.front[q]),
                FragmentInput::Coverage => *out.as_f32_mut() = batch.coverage,
                FragmentInput::Zero => *out = U32s::ZERO,
            }
        }
    }
}

/// Column of each pixel of a quad.
const X: [f32; 4] = [0.0, 1.0, 0.0, 1.0];
/// Row of each pixel of a quad.
const Y: [f32; 4] = [0.0, 0.0, 1.0, 1.0];

/// Fills lanes from the pixel of the quad and the quad.
#[inline(always)]
fn by_quad(out: &mut U32s, word: impl Fn(usize, usize) -> u32) {
    for lane in 0..LANES {
        out[lane] = word(lane / QUADS, lane % QUADS);
    }
}

impl Batch {
    /// How a plane changes from pixel to pixel, by quad.
    #[inline(always)]
    fn slope(&self, plane: usize, axis: Axis) -> &[f32; QUADS] {
        match axis {
            Axis::X => &self.planes[plane].a,
            Axis::Y => &self.planes[plane].b,
        }
    }

    /// A plane at one lane, as [`Self::evaluate`] has it.
    pub fn at(&self, plane: usize, lane: usize) -> f32 {
        self.evaluate(plane)[lane]
    }

    /// A plane at every lane.
    #[inline(always)]
    fn evaluate(&self, plane: usize) -> F32s {
        let plane = &self.planes[plane];
        let mut out = F32s::ZERO;
        let [first, second, third, fourth] = pixels(&mut out);
        self.evaluate_pixel(plane, 0, first);
        self.evaluate_pixel(plane, 1, second);
        self.evaluate_pixel(plane, 2, third);
        self.evaluate_pixel(plane, 3, fourth);
        out
    }

    /// A plane at every lane, moved so far across and up from the pixel's centre.
    #[inline(always)]
    pub fn within(&self, plane: usize, [x, y]: &[F32s; 2]) -> F32s {
        let mut out = self.evaluate(plane);
        let plane = &self.planes[plane];
        for lane in 0..LANES {
            let quad = lane % QUADS;
            out[lane] += x[lane] * plane.a[quad] + y[lane] * plane.b[quad];
        }
        out
    }

    /// A plane at one pixel of each quad.
    #[inline(always)]
    fn evaluate_pixel(&self, p: &QuadPlane, e: usize, out: &mut [f32; QUADS]) {
        for (q, out) in out.iter_mut().enumerate() {
            let (dx, dy) = (self.dx[q] + X[e], self.dy[q] + Y[e]);
            *out = (p.corner[q] + dx * p.a[q]) + dy * p.b[q];
        }
    }

    /// The derivative of the quotient of two planes at one pixel of each quad:
    /// `(n / d)' = (n' - n / d · d') / d`, given `1 / d` and, in `out`, `n`.
    #[inline(always)]
    fn slope_pixel(
        of: &[f32; QUADS],
        by: &[f32; QUADS],
        inverse: &[f32; QUADS],
        out: &mut [f32; QUADS],
    ) {
        for q in 0..QUADS {
            let value = out[q] * inverse[q];
            out[q] = (of[q] - value * by[q]) * inverse[q];
        }
    }
}

/// The lanes by pixel of the quad. A loop over pixels around a loop over quads would be vectorized
/// the wrong way round, with scattered stores.
#[inline(always)]
fn pixels(lanes: &mut F32s) -> &mut [[f32; QUADS]; 4] {
    bytemuck::cast_mut(&mut lanes.0)
}

/// Window depth lies in [0, 1], whatever the planes and offsets gave (GL 2.1, section 2.11.1).
#[inline(always)]
pub fn clamp_depth(depth: &mut F32s) {
    for lane in 0..LANES {
        depth[lane] = texunit::lanes::math::clamp(depth[lane], 0.0, 1.0);
    }
}

/// The depth of a block of one shape: the same numbers as [`Interpolate`] gives, before anything is
/// shaded.
pub struct BlockDepth {
    /// At the first pixel, per pixel across, per pixel up.
    pub plane: [f32; 3],
}

impl Kernel for BlockDepth {
    type Output = F32s;
    #[inline(always)]
    fn run<S: Simd>(self) -> F32s {
        let [corner, a, b] = self.plane;
        let mut out = F32s::ZERO;
        for lane in 0..LANES {
            let dx = texunit::lanes::lane_x(lane) as f32;
            let dy = texunit::lanes::lane_y(lane) as f32;
            out[lane] = (corner + dx * a) + dy * b;
        }
        clamp_depth(&mut out);
        out
    }
}

/// The depth of a batch at a sample: the same numbers as [`BlockDepth`] gives for a plane that was
/// moved there.
pub struct BatchDepth<'a> {
    /// The quads.
    pub batch: &'a Batch,
    /// The plane of depth.
    pub plane: usize,
    /// From the pixel's centre to the sample, in pixels; `None` for the centre itself.
    pub offset: Option<[f32; 2]>,
    /// Takes the depth.
    pub depth: &'a mut F32s,
}

impl Kernel for BatchDepth<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { batch, plane, offset, depth } = self;
        let mut p = batch.planes[plane].clone();
        if offset.is_some() {
            for q in 0..QUADS {
                [p.corner[q], _, _] = moved([p.corner[q], p.a[q], p.b[q]], offset);
            }
        }
        let mut out = F32s::ZERO;
        let [first, second, third, fourth] = pixels(&mut out);
        batch.evaluate_pixel(&p, 0, first);
        batch.evaluate_pixel(&p, 1, second);
        batch.evaluate_pixel(&p, 2, third);
        batch.evaluate_pixel(&p, 3, fourth);
        clamp_depth(&mut out);
        *depth = out;
    }
}
