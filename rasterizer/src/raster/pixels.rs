//! A batch of fragments that have nothing to do with their neighbours: up to 64 pixels of anywhere in
//! a tile.
//!
//! Where nothing that a draw computes depends on the other pixels of a quad, there is no reason to
//! shade those that are not covered: a triangle of five pixels is five lanes, not four quads.

mod shade;

use super::batch::clamp_depth;
use crate::ir::Axis;
use crate::plan::{DrawPlan, FragmentInput};
use crate::primitive::Facing;
use crate::shader::Machine;
use crate::target::{BLOCKS, Place};
use texunit::lanes::{F32s, Kernel, LANES, QUADS, Simd, U32s};

/// Lanes whose plane is written at once: those after the last pixel are written over by the next.
const AT_ONCE: usize = 4;
/// Room for that.
const ROOM: usize = LANES + AT_ONCE;

/// The three numbers of a plane for each pixel: at the first pixel of its block, per pixel across, per
/// pixel up.
#[derive(Clone, Debug)]
struct PixelPlane {
    corner: [f32; ROOM],
    a: [f32; ROOM],
    b: [f32; ROOM],
}

/// The pixels that are to be shaded together.
#[derive(Debug)]
pub struct Pixels {
    /// How many.
    len: usize,
    /// Where each is: its block of the tile times 64, and its lane there.
    at: [u16; LANES],
    /// Those of back faces, bit by lane.
    back: u64,
    planes: Vec<PixelPlane>,
    /// By block: the lanes that wait in this batch.
    waiting: [u64; BLOCKS],
    /// The blocks of which any wait.
    blocks: u64,
}

impl Default for Pixels {
    fn default() -> Self {
        Self {
            len: 0,
            at: [0; LANES],
            back: 0,
            planes: Vec::new(),
            waiting: [0; BLOCKS],
            blocks: 0,
        }
    }
}

impl Pixels {
    /// Whether nothing waits.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Whether no pixel fits any more.
    pub fn is_full(&self) -> bool {
        self.len == LANES
    }

    /// Whether any of the lanes of a block waits here: what comes after must not overtake it.
    #[inline]
    pub fn holds(&self, block: usize, lanes: u64) -> bool {
        self.waiting[block % BLOCKS] & lanes != 0
    }

    /// The lanes that there are.
    fn mask(&self) -> u64 {
        !0 >> (LANES - self.len.clamp(1, LANES))
    }

    /// Where they are.
    fn place(&self) -> Place<'_> {
        Place::Pixels(&self.at[..self.len])
    }

    /// Forgets its pixels and makes room for a draw with `planes` planes.
    pub fn clear(&mut self, planes: usize) {
        while self.blocks != 0 {
            self.waiting[self.blocks.trailing_zeros() as usize % BLOCKS] = 0;
            self.blocks &= self.blocks - 1;
        }
        (self.len, self.back) = (0, 0);
        if self.planes.len() != planes {
            let none = PixelPlane { corner: [0.0; ROOM], a: [0.0; ROOM], b: [0.0; ROOM] };
            self.planes.resize(planes, none);
        }
    }

    /// Adds lanes of a block of one shape, as many as fit; gives those that do not. `planes` are, of
    /// each plane, its value at the first pixel of the block and its steps across and up.
    #[inline]
    pub fn push(
        &mut self,
        block: usize,
        lanes: u64,
        facing: Facing,
        planes: impl Iterator<Item = [f32; 3]>,
    ) -> u64 {
        let first = self.len % LANES;
        let mut left = lanes;
        let mut len = first;
        while left != 0 && len < LANES {
            self.at[len] = (block * LANES) as u16 | left.trailing_zeros() as u16;
            left &= left - 1;
            len += 1;
        }
        self.len = len;
        for (plane, [corner, a, b]) in self.planes.iter_mut().zip(planes) {
            for at in (first..len).step_by(AT_ONCE) {
                plane.corner[at..at + AT_ONCE].fill(corner);
                plane.a[at..at + AT_ONCE].fill(a);
                plane.b[at..at + AT_ONCE].fill(b);
            }
        }
        self.waiting[block % BLOCKS] |= lanes & !left;
        self.blocks |= 1 << (block % BLOCKS);
        if facing == Facing::Back {
            self.back |= self.mask() & !0 << first;
        }
        left
    }

    /// Column and row of each lane in its block.
    #[inline(always)]
    fn coordinates(&self) -> [F32s; 2] {
        let [mut x, mut y] = [F32s::ZERO; 2];
        for lane in 0..LANES {
            let at = u32::from(self.at[lane]) % LANES as u32;
            let (pixel, quad) = (at / QUADS as u32, at % QUADS as u32);
            x[lane] = (quad % 4 * 2 + pixel % 2) as i32 as f32;
            y[lane] = (quad / 4 * 2 + pixel / 2) as i32 as f32;
        }
        [x, y]
    }

    /// A plane at every lane.
    #[inline(always)]
    fn evaluate(&self, plane: usize, [dx, dy]: &[F32s; 2]) -> F32s {
        let p = &self.planes[plane];
        let mut out = F32s::ZERO;
        for lane in 0..LANES {
            out[lane] = (p.corner[lane] + dx[lane] * p.a[lane]) + dy[lane] * p.b[lane];
        }
        out
    }

    /// How a plane changes from pixel to pixel.
    #[inline(always)]
    fn slope(&self, plane: usize, axis: Axis) -> &[f32; ROOM] {
        match axis {
            Axis::X => &self.planes[plane].a,
            Axis::Y => &self.planes[plane].b,
        }
    }
}

/// The depth of each pixel.
struct PixelDepth<'a> {
    pixels: &'a Pixels,
    plane: usize,
    depth: &'a mut F32s,
}

impl Kernel for PixelDepth<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { pixels, plane, depth } = self;
        *depth = pixels.evaluate(plane, &pixels.coordinates());
        clamp_depth(depth);
    }
}

/// Fills the input registers of a program, and the depth of each lane if a plane holds it: the
/// arithmetic of `batch::Interpolate`.
struct InterpolatePixels<'a> {
    plan: &'a DrawPlan,
    pixels: &'a Pixels,
    /// The first pixel of the tile.
    tile: [i32; 2],
    machine: &'a mut Machine,
    depth: &'a mut F32s,
}

impl Kernel for InterpolatePixels<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, pixels, tile, machine, depth } = self;
        let by = pixels.coordinates();
        if let Some(index) = plan.depth_plane {
            *depth = pixels.evaluate(index, &by);
            clamp_depth(depth);
        }
        let mut w = F32s::ZERO;
        let mut denominator = 0;
        if let Some(index) = plan.denominator_plane {
            denominator = index;
            let over = pixels.evaluate(index, &by);
            for lane in 0..LANES {
                w[lane] = 1.0 / over[lane];
            }
        }
        for (index, input) in plan.inputs.iter().enumerate() {
            let out = machine.input_mut(index);
            match *input {
                // With one sample, centroids are centres.
                FragmentInput::Smooth(index) | FragmentInput::SmoothWithin(index) => {
                    let mut value = pixels.evaluate(index, &by);
                    for lane in 0..LANES {
                        value[lane] *= w[lane];
                    }
                    *out.as_f32_mut() = value;
                }
                FragmentInput::Linear(index) | FragmentInput::LinearWithin(index) => {
                    *out.as_f32_mut() = pixels.evaluate(index, &by);
                }
                FragmentInput::SmoothSlope(index, axis) => {
                    let mut slope = pixels.evaluate(index, &by);
                    let (of, over) = (pixels.slope(index, axis), pixels.slope(denominator, axis));
                    for lane in 0..LANES {
                        let value = slope[lane] * w[lane];
                        slope[lane] = (of[lane] - value * over[lane]) * w[lane];
                    }
                    *out.as_f32_mut() = slope;
                }
                FragmentInput::LinearSlope(index, axis) => {
                    let slope = pixels.slope(index, axis);
                    for lane in 0..LANES {
                        out[lane] = slope[lane].to_bits();
                    }
                }
                FragmentInput::Depth => *out.as_f32_mut() = *depth,
                FragmentInput::Flat(index) => {
                    let corner = &pixels.planes[index].corner;
                    for lane in 0..LANES {
                        out[lane] = corner[lane].to_bits();
                    }
                }
                FragmentInput::X => {
                    for lane in 0..LANES {
                        let column = i32::from(pixels.at[lane]) / LANES as i32 % 8;
                        let first = (tile[0] + 8 * column) as f32;
                        out[lane] = (first + (by[0][lane] + 0.5)).to_bits();
                    }
                }
                FragmentInput::Y => {
                    for lane in 0..LANES {
                        let row = i32::from(pixels.at[lane]) / LANES as i32 / 8;
                        let first = (tile[1] + 8 * row) as f32;
                        out[lane] = (first + (by[1][lane] + 0.5)).to_bits();
                    }
                }
                FragmentInput::Front => {
                    for lane in 0..LANES {
                        let is_back = pixels.back >> lane & 1 == 1;
                        out[lane] = if is_back { 0 } else { crate::ir::TRUE };
                    }
                }
                FragmentInput::Coverage => *out.as_f32_mut() = F32s::splat(1.0),
                FragmentInput::Zero => *out = U32s::ZERO,
            }
        }
    }
}
