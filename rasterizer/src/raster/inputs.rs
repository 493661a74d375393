//! The inputs of a fragment program: planes at the pixels of a batch.

use super::batch::{Batch, BatchPixels, BlockOf, Packed, QUAD_X, QUAD_Y, front_word};
use super::block_run::BlockRun;
use super::fragment_depth::clamp_depth;
use super::perspective::{
    X, Y, along, divided, evaluate, evaluate_moved, invert, value_at, with_slopes,
};
use super::pixel_batch::Pixels;
use crate::desc::Facing;
use crate::ir::Axis;
use crate::plan::{DrawPlan, FilledInput, FragmentInput, SampleMasks};
use crate::shader::Machine;
use std::iter::once;
use texunit::lanes::{F32s, Kernel, LANES, QUADS, Simd, U32s};

/// What interpolation reads of a batch, for pixel `e` of its quad `q`.
pub(super) trait InterpolationSource {
    /// A plane: at the first pixel of the block, per pixel across, per pixel up.
    fn plane(&self, plane: usize) -> impl Fn(usize, usize) -> [f32; 3];
    /// Whether a plane is known to be 1 at every lane.
    fn is_one(&self, plane: usize) -> bool;
    /// Whether two planes may be the same at any lane: whether they are at the first pixel of any block.
    fn may_be_equal<S: Simd>(&self, planes: [usize; 2]) -> bool;
    /// Its column and row in its block.
    fn position_in_block(&self, e: usize, q: usize) -> [f32; 2];
    /// The first pixel of its block.
    fn block_origin(&self, e: usize, q: usize) -> [f32; 2];
    fn front(&self, e: usize, q: usize) -> u32;
    fn coverage(&self) -> Option<&F32s>;
}

impl InterpolationSource for BlockOf<'_> {
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
    fn may_be_equal<S: Simd>(&self, [of, by]: [usize; 2]) -> bool {
        self.planes[of][0] == self.planes[by][0]
    }
    #[inline(always)]
    fn position_in_block(&self, e: usize, q: usize) -> [f32; 2] {
        [QUAD_X[q] + X[e], QUAD_Y[q] + Y[e]]
    }
    #[inline(always)]
    fn block_origin(&self, _e: usize, _q: usize) -> [f32; 2] {
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

impl InterpolationSource for Packed {
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
    fn may_be_equal<S: Simd>(&self, planes: [usize; 2]) -> bool {
        let [of, by] = planes.map(|plane| &self.planes[plane].corner);
        of.iter().zip(by).any(|(of, by)| of == by)
    }
    #[inline(always)]
    fn position_in_block(&self, e: usize, q: usize) -> [f32; 2] {
        [self.dx[q] + X[e], self.dy[q] + Y[e]]
    }
    #[inline(always)]
    fn block_origin(&self, _e: usize, q: usize) -> [f32; 2] {
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

impl InterpolationSource for Pixels {
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
    fn may_be_equal<S: Simd>(&self, planes: [usize; 2]) -> bool {
        let [of, by] = planes.map(|plane| &self.planes[plane].corner);
        let mut same = U32s::ZERO;
        for lane in 0..LANES {
            same[lane] = u32::from(of[lane] == by[lane]);
        }
        S::any(&same)
    }
    #[inline(always)]
    fn position_in_block(&self, e: usize, q: usize) -> [f32; 2] {
        [self.position[0][e * QUADS + q], self.position[1][e * QUADS + q]]
    }
    #[inline(always)]
    fn block_origin(&self, e: usize, q: usize) -> [f32; 2] {
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
    /// Receives the inputs.
    pub machine: &'a mut Machine,
    /// Receives the depth, where the plan has a plane for it.
    pub depth: &'a mut F32s,
}

impl Kernel for Interpolate<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, batch, machine, depth } = self;
        let inputs = &plan.filled[..];
        let mut fill = Fill { plan, inputs, masks: batch.masks, machine, file: 0, depth };
        match batch.quads {
            BatchPixels::Block(block) => fill.fill::<S>(block),
            BatchPixels::Packed(packed) => fill.fill::<S>(packed),
            BatchPixels::Pixels(pixels) => fill.fill::<S>(pixels),
        }
    }
}

/// Fills the input registers of a program from a run, register file by register file.
pub struct InterpolateRun<'a> {
    /// The draw.
    pub plan: &'a DrawPlan,
    /// What is filled of the first register file, and of the others.
    pub inputs: [&'a [FilledInput]; 2],
    /// The blocks.
    pub run: &'a BlockRun,
    /// The first pixel of their tile.
    pub tile: [i32; 2],
    /// Receives the inputs.
    pub machine: &'a mut Machine,
}

impl Kernel for InterpolateRun<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, inputs: [first, others], run, tile, machine } = self;
        let (masks, mut depth) = (&SampleMasks::default(), F32s::ZERO);
        let depth = &mut depth;
        for (file, block) in run.blocks(tile).enumerate() {
            let inputs = if file == 0 { first } else { others };
            Fill { plan, inputs, masks, machine, file, depth }.fill::<S>(&block);
        }
    }
}

/// Fills the input registers of a register file.
struct Fill<'a> {
    plan: &'a DrawPlan,
    inputs: &'a [FilledInput],
    masks: &'a SampleMasks,
    machine: &'a mut Machine,
    file: usize,
    depth: &'a mut F32s,
}

impl Fill<'_> {
    #[inline(always)]
    fn fill<S: Simd>(&mut self, source: &impl InterpolationSource) {
        let Self { plan, inputs, masks, machine, file, depth } = self;
        // Planes and registers may overlap as far as the compiler knows: what is computed here is
        // computed on the stack and stored whole.
        if let Some(index) = plan.depth_plane.filter(|_| plan.shades_depth) {
            **depth = evaluate::<S>(source, index);
            clamp_depth(depth, plan.viewport.depths());
        }
        let mut w = F32s::splat(1.0);
        let denominator = plan.denominator_plane.unwrap_or(0);
        // Of shapes that do not lie in perspective nothing is divided.
        let is_divided = plan.denominator_plane.is_some_and(|index| !source.is_one(index));
        if is_divided {
            w = evaluate::<S>(source, denominator);
            invert::<S>(&mut w);
        }
        let mut centroids = [F32s::ZERO; 2];
        if plan.centroids {
            centroids = plan.samples.centroids(masks);
        }
        let registers = machine.inputs_of(*file);
        for &FilledInput { number, from, slopes } in *inputs {
            if let (FragmentInput::Smooth(index), Some(slopes)) = (from, slopes) {
                let all = with_slopes::<S>(source, [index, denominator], &w);
                for (number, filled) in once(number).chain(slopes).zip(all) {
                    if let Some(out) = registers.get_mut(number) {
                        *out.as_f32_mut() = filled;
                    }
                }
                continue;
            }
            let Some(out) = registers.get_mut(number) else { continue };
            match from {
                FragmentInput::Smooth(index) if is_divided => {
                    *out.as_f32_mut() = divided::<S>(source, [index, denominator], &w);
                }
                FragmentInput::Smooth(index) => *out.as_f32_mut() = evaluate::<S>(source, index),
                FragmentInput::Linear(index) => *out.as_f32_mut() = evaluate::<S>(source, index),
                FragmentInput::SmoothAtCentroid(index) => {
                    let mut value = evaluate_moved::<S>(source, index, &centroids);
                    let over = evaluate_moved::<S>(source, denominator, &centroids);
                    for lane in 0..LANES {
                        value[lane] *= 1.0 / over[lane];
                    }
                    *out.as_f32_mut() = value;
                }
                FragmentInput::LinearAtCentroid(index) => {
                    *out.as_f32_mut() = evaluate_moved::<S>(source, index, &centroids);
                }
                FragmentInput::SmoothSlope(index, axis) => {
                    let [_, across, up] = with_slopes::<S>(source, [index, denominator], &w);
                    *out.as_f32_mut() = match axis {
                        Axis::X => across,
                        Axis::Y => up,
                    };
                }
                FragmentInput::LinearSlope(index, axis) => {
                    let plane = source.plane(index);
                    by_quad(out, |e, q| along(axis, plane(e, q)).to_bits());
                }
                FragmentInput::Depth => *out.as_f32_mut() = **depth,
                FragmentInput::Flat(index) => {
                    let plane = source.plane(index);
                    by_quad(out, |e, q| plane(e, q)[0].to_bits());
                }
                FragmentInput::X => by_quad(out, |e, q| {
                    (source.block_origin(e, q)[0] + (source.position_in_block(e, q)[0] + 0.5))
                        .to_bits()
                }),
                FragmentInput::Y => by_quad(out, |e, q| {
                    (source.block_origin(e, q)[1] + (source.position_in_block(e, q)[1] + 0.5))
                        .to_bits()
                }),
                FragmentInput::Front => by_quad(out, |e, q| source.front(e, q)),
                FragmentInput::Coverage => {
                    if let Some(coverage) = source.coverage() {
                        *out.as_f32_mut() = *coverage;
                    }
                }
                // Was set when the draw began, and is not filled.
                FragmentInput::Zero => {}
            }
        }
    }
}

/// Fills lanes from the pixel of the quad and the quad.
#[inline(always)]
fn by_quad(out: &mut U32s, word: impl Fn(usize, usize) -> u32) {
    for lane in 0..LANES {
        out[lane] = word(lane / QUADS, lane % QUADS);
    }
}

impl Batch<'_> {
    /// A plane at one lane.
    pub fn plane_at(&self, plane: usize, lane: usize) -> f32 {
        let (plane, position) = self.plane_and_position(plane, lane);
        value_at(plane, position)
    }

    /// A plane at one lane, moved so far across and up from the pixel's centre.
    pub fn plane_at_moved(&self, plane: usize, lane: usize, [x, y]: &[F32s; 2]) -> f32 {
        let (plane, position) = self.plane_and_position(plane, lane);
        let [_, a, b] = plane;
        value_at(plane, position) + (x[lane] * a + y[lane] * b)
    }

    /// A plane, and the column and row of a lane in its block.
    fn plane_and_position(&self, plane: usize, lane: usize) -> ([f32; 3], [f32; 2]) {
        let (e, q) = (lane / QUADS, lane % QUADS);
        match self.quads {
            BatchPixels::Block(block) => (block.plane(plane)(e, q), block.position_in_block(e, q)),
            BatchPixels::Packed(packed) => {
                (packed.plane(plane)(e, q), packed.position_in_block(e, q))
            }
            BatchPixels::Pixels(pixels) => {
                (pixels.plane(plane)(e, q), pixels.position_in_block(e, q))
            }
        }
    }
}
