//! The inputs of a fragment program: planes at the pixels of a batch.

use super::batch::{Batch, BatchPixels, BlockOf, Packed, QUAD_X, QUAD_Y, front_word};
use super::block_group::BlockGroup;
use super::perspective::{X, Y, along, divided, evaluate, evaluate_moved, invert, with_slopes};
use super::pixel_batch::Pixels;
use crate::attachment::{clamp_depth, value_at};
use crate::desc::Facing;
use crate::ir::Axis;
use crate::plan::{DrawPlan, FilledInput, FragmentInput, SampleMasks};
use crate::shader::Machine;
use std::iter::once;
use texunit::lanes::{F32s, Kernel, LANES, QUADS, Simd, U32s};

/// What interpolation reads of a batch. `quad` is a quad of the batch, `pixel` one of its four pixels.
pub(super) trait InterpolationSource {
    /// A plane: at the first pixel of the block, per pixel across, per pixel up.
    fn plane(&self, plane: usize) -> impl Fn(usize, usize) -> [f32; 3];
    /// Whether a plane is known to be 1 at every lane.
    fn is_one(&self, plane: usize) -> bool;
    /// Whether two planes may be the same at any lane: whether they are at the first pixel of any block.
    fn may_be_equal<S: Simd>(&self, planes: [usize; 2]) -> bool;
    /// The column and row of a pixel in its block.
    fn position_in_block(&self, pixel: usize, quad: usize) -> [f32; 2];
    /// The first pixel of the block of a pixel.
    fn block_origin(&self, pixel: usize, quad: usize) -> [f32; 2];
    fn front(&self, pixel: usize, quad: usize) -> u32;
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
    fn may_be_equal<S: Simd>(&self, [numerator, denominator]: [usize; 2]) -> bool {
        self.planes[numerator][0] == self.planes[denominator][0]
    }
    #[inline(always)]
    fn position_in_block(&self, pixel: usize, quad: usize) -> [f32; 2] {
        [QUAD_X[quad] + X[pixel], QUAD_Y[quad] + Y[pixel]]
    }
    #[inline(always)]
    fn block_origin(&self, _pixel: usize, _quad: usize) -> [f32; 2] {
        [self.x as f32, self.y as f32]
    }
    #[inline(always)]
    fn front(&self, _pixel: usize, _quad: usize) -> u32 {
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
        move |_, quad| [plane.corner[quad], plane.a[quad], plane.b[quad]]
    }
    #[inline(always)]
    fn is_one(&self, _plane: usize) -> bool {
        false
    }
    #[inline(always)]
    fn may_be_equal<S: Simd>(&self, planes: [usize; 2]) -> bool {
        let [numerator, denominator] = planes.map(|plane| &self.planes[plane].corner);
        numerator.iter().zip(denominator).any(|(numerator, denominator)| numerator == denominator)
    }
    #[inline(always)]
    fn position_in_block(&self, pixel: usize, quad: usize) -> [f32; 2] {
        [self.dx[quad] + X[pixel], self.dy[quad] + Y[pixel]]
    }
    #[inline(always)]
    fn block_origin(&self, _pixel: usize, quad: usize) -> [f32; 2] {
        [self.x[quad], self.y[quad]]
    }
    #[inline(always)]
    fn front(&self, _pixel: usize, quad: usize) -> u32 {
        self.front[quad]
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
        move |pixel, quad| {
            let lane = pixel * QUADS + quad;
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
        let [numerator, denominator] = planes.map(|plane| &self.planes[plane].corner);
        let mut same = U32s::ZERO;
        for lane in 0..LANES {
            same[lane] = u32::from(numerator[lane] == denominator[lane]);
        }
        S::any(&same)
    }
    #[inline(always)]
    fn position_in_block(&self, pixel: usize, quad: usize) -> [f32; 2] {
        [self.position[0][pixel * QUADS + quad], self.position[1][pixel * QUADS + quad]]
    }
    #[inline(always)]
    fn block_origin(&self, pixel: usize, quad: usize) -> [f32; 2] {
        [self.block[0][pixel * QUADS + quad], self.block[1][pixel * QUADS + quad]]
    }
    #[inline(always)]
    fn front(&self, pixel: usize, quad: usize) -> u32 {
        let is_back = self.back >> (pixel * QUADS + quad) & 1 == 1;
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
    /// The sample that is shaded; 0 where fragments are shaded once.
    pub sample: usize,
}

impl Kernel for Interpolate<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, batch, machine, depth, sample } = self;
        let inputs = &plan.interpolated_inputs[..];
        let mut fill = Fill { plan, inputs, masks: batch.masks, machine, file: 0, depth, sample };
        match batch.pixels {
            BatchPixels::Block(block) => fill.fill::<S>(block),
            BatchPixels::Packed(packed) => fill.fill::<S>(packed),
            BatchPixels::Pixels(pixels) => fill.fill::<S>(pixels),
        }
    }
}

/// Fills the input registers of a program from a block group, register file by register file.
pub struct InterpolateGroup<'a> {
    /// The draw.
    pub plan: &'a DrawPlan,
    /// The inputs that are filled in the first register file, and in the others.
    pub inputs: [&'a [FilledInput]; 2],
    /// The blocks.
    pub block_group: &'a BlockGroup,
    /// The first pixel of their tile.
    pub tile: [i32; 2],
    /// Receives the inputs.
    pub machine: &'a mut Machine,
}

impl Kernel for InterpolateGroup<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, inputs: [first, others], block_group, tile, machine } = self;
        let (masks, mut depth) = (&SampleMasks::default(), F32s::ZERO);
        let depth = &mut depth;
        for (file, block) in block_group.blocks(tile).enumerate() {
            let inputs = if file == 0 { first } else { others };
            Fill { plan, inputs, masks, machine, file, depth, sample: 0 }.fill::<S>(&block);
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
    sample: usize,
}

impl Fill<'_> {
    #[inline(always)]
    fn fill<S: Simd>(&mut self, source: &impl InterpolationSource) {
        let Self { plan, inputs, masks, machine, file, depth, sample } = self;
        // Planes and registers may overlap as far as the compiler knows: what is computed here is
        // computed on the stack and stored whole.
        if let Some(index) = plan.depth_plane.filter(|_| plan.shades_depth) {
            **depth = evaluate::<S>(source, index);
            clamp_depth(depth, plan.viewport.depths());
        }
        let mut w = F32s::splat(1.0);
        let denominator = plan.denominator_plane.unwrap_or(0);
        // Shapes without perspective need no division.
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
                for (number, value) in once(number).chain(slopes).zip(all) {
                    if let Some(out) = registers.get_mut(number) {
                        *out.as_f32_mut() = value;
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
                FragmentInput::SmoothGradient(index, axis) => {
                    let [_, across, up] = with_slopes::<S>(source, [index, denominator], &w);
                    *out.as_f32_mut() = match axis {
                        Axis::X => across,
                        Axis::Y => up,
                    };
                }
                FragmentInput::LinearGradient(index, axis) => {
                    let plane = source.plane(index);
                    by_quad(out, |pixel, quad| along(axis, plane(pixel, quad)).to_bits());
                }
                FragmentInput::Depth => *out.as_f32_mut() = **depth,
                FragmentInput::Flat(index) => {
                    let plane = source.plane(index);
                    by_quad(out, |pixel, quad| plane(pixel, quad)[0].to_bits());
                }
                FragmentInput::X => by_quad(out, |pixel, quad| {
                    (source.block_origin(pixel, quad)[0]
                        + (source.position_in_block(pixel, quad)[0] + 0.5))
                        .to_bits()
                }),
                FragmentInput::Y => by_quad(out, |pixel, quad| {
                    (source.block_origin(pixel, quad)[1]
                        + (source.position_in_block(pixel, quad)[1] + 0.5))
                        .to_bits()
                }),
                FragmentInput::Front => by_quad(out, |pixel, quad| source.front(pixel, quad)),
                FragmentInput::PlaceOfSample(axis) => {
                    let (axis, position) = (axis as usize, plan.samples.position(*sample));
                    by_quad(out, |pixel, quad| {
                        let start = source.block_origin(pixel, quad)[axis];
                        let pixel = source.position_in_block(pixel, quad)[axis];
                        (start + (pixel + position[axis])).to_bits()
                    });
                }
                FragmentInput::SampleId => *out = U32s::splat(*sample as u32),
                FragmentInput::SamplePosition(axis) => {
                    *out.as_f32_mut() = F32s::splat(plan.samples.position(*sample)[axis as usize]);
                }
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
        let (pixel, quad) = (lane / QUADS, lane % QUADS);
        match self.pixels {
            BatchPixels::Block(block) => {
                (block.plane(plane)(pixel, quad), block.position_in_block(pixel, quad))
            }
            BatchPixels::Packed(packed) => {
                (packed.plane(plane)(pixel, quad), packed.position_in_block(pixel, quad))
            }
            BatchPixels::Pixels(pixels) => {
                (pixels.plane(plane)(pixel, quad), pixels.position_in_block(pixel, quad))
            }
        }
    }
}
