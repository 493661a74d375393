//! The depth of fragments before shading: the same numbers as those of [`super::inputs`].

use super::batch::{Batch, BatchPixels};
use super::inputs::InterpolationSource;
use super::large_triangles::bits;
use super::perspective::evaluate_plane;
use crate::attachment::{BLOCKS, BlockDepth, clamp_depth};
use crate::output::{DepthPlan, DepthTest};
use crate::plan::moved;
use texunit::lanes::{F32s, Kernel, Simd, U32s};

/// The depth test of blocks of one shape, one after the other: leaves the lanes that pass.
pub struct TestBlocks<'a> {
    /// What is tested.
    pub plan: DepthPlan,
    /// The least and the largest depth.
    pub depths: [f32; 2],
    /// The depth at the first pixel of each block.
    pub corners: &'a F32s,
    /// Per pixel across, per pixel up.
    pub steps: [f32; 2],
    /// The attachment's words, block by block.
    pub words: &'a mut [U32s],
    /// Which blocks, bit by block.
    pub blocks: u64,
    /// The lanes of each.
    pub lanes: &'a mut [u64; BLOCKS],
}

impl Kernel for TestBlocks<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { plan, depths, corners, steps: [a, b], words, blocks, lanes } = self;
        for block in bits(blocks) {
            let Some(stored) = words.get_mut(block) else { return };
            let depth = &BlockDepth { plane: [corners[block], a, b], depths }.run::<S>();
            lanes[block] = DepthTest { plan, depth, stored, mask: lanes[block] }.run::<S>();
        }
    }
}

/// The depth of a batch at a sample: the same numbers as those of [`BlockDepth`] for a plane that was
/// moved there.
pub struct BatchDepth<'a> {
    /// The quads.
    pub batch: &'a Batch<'a>,
    /// The plane of depth.
    pub plane: usize,
    /// From the pixel's centre to the sample, in pixels; `None` for the centre itself.
    pub offset: Option<[f32; 2]>,
    /// The least and the largest depth.
    pub depths: [f32; 2],
    /// Receives the depth.
    pub depth: &'a mut F32s,
}

impl Kernel for BatchDepth<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        match self.batch.pixels {
            BatchPixels::Block(block) => self.fill(block),
            BatchPixels::Packed(packed) => self.fill(packed),
            BatchPixels::Pixels(pixels) => self.fill(pixels),
        }
    }
}

impl BatchDepth<'_> {
    #[inline(always)]
    fn fill(self, source: &impl InterpolationSource) {
        let Self { plane, offset, depths, depth, .. } = self;
        let plane = source.plane(plane);
        let mut out = match offset {
            None => evaluate_plane(source, plane),
            Some(by) => evaluate_plane(source, |e, q| moved(plane(e, q), Some(by))),
        };
        clamp_depth(&mut out, depths);
        *depth = out;
    }
}
