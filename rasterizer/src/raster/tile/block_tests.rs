//! The early tests of the blocks of a large triangle: depth by one kernel, the stencil by the one word that blocks hold.

use super::super::large_triangles::bits;
use super::super::tile_planes::{PlaneStorage, TilePlane};
use crate::attachment::{BLOCKS, WordPlane};
use crate::desc::Facing;
use crate::kernels::PixelKernel;
use crate::output::{BlockStencil, DepthPlan, Reference, StencilUpdate};
use crate::plan::{DrawPlan, Shading, TestTiming};
use texunit::lanes::Isa;

/// What is tested.
#[derive(Clone, Copy)]
pub(super) struct BlockTests {
    isa: Isa,
    stencil: Option<BlockStencil>,
    /// The depth test, and which plane is the depth.
    depth: Option<(DepthPlan, usize)>,
    storage: PlaneStorage,
    depths: [f32; 2],
}

impl BlockTests {
    /// The tests of a draw; `None` where they are not early, or depend on single fragments.
    pub fn new(isa: Isa, plan: &DrawPlan, facing: Facing) -> Option<Self> {
        if plan.timing != TestTiming::Early {
            return None;
        }
        let depth = plan.tests.depth;
        let stencil = match plan.tests.stencil {
            Some(stencil) => Some(stencil.of_blocks(facing, depth)?),
            None => None,
        };
        let depth = match depth {
            Some(test) => Some((test, plan.depth_plane?)),
            None => None,
        };
        let storage = match plan.shading {
            Shading::Off => PlaneStorage::Block,
            Shading::On => PlaneStorage::Tile,
        };
        Some(Self { isa, stencil, depth, storage, depths: plan.viewport.depths() })
    }

    /// Which plane is the depth, where that is tested.
    pub fn depth_plane(&self) -> Option<usize> {
        self.depth.map(|(_, plane)| plane)
    }

    /// Those of `blocks`, bit by block, that [`Self::run`] can test with these planes of a sample.
    pub fn testable(&self, blocks: u64, planes: &[WordPlane]) -> u64 {
        match (self.stencil, planes) {
            (None, [_, ..]) | (Some(BlockStencil::Stores(..)), [_, _]) => blocks,
            (Some(BlockStencil::Compares(_)), [_, stencils]) => {
                let is_uniform = |block: &usize| stencils.uniform_word(*block).is_some();
                bits(blocks).filter(is_uniform).fold(0, |set, block| set | 1 << block)
            }
            (_, _) => 0,
        }
    }

    /// Tests `blocks`, bit by block, with the planes of a sample and the plane of its depth. Lanes that fail are removed
    /// from `covered`.
    pub fn run(
        &self,
        blocks: u64,
        planes: &mut [WordPlane],
        depth: Option<&TilePlane>,
        covered: &mut [u64; BLOCKS],
    ) {
        if let (Some(BlockStencil::Compares(face)), [_, stencils]) = (self.stencil, &*planes) {
            let fails = |block: &usize| {
                stencils.uniform_word(*block).is_some_and(|word| !face.passes(word as u8))
            };
            bits(blocks).filter(fails).for_each(|block| covered[block] = 0);
        }
        if let (Some((test, _)), Some(plane), [stored, ..]) = (self.depth, depth, &mut *planes) {
            plane.test(self.isa, test, (self.storage, self.depths), stored, blocks, covered);
        }
        if let (Some(BlockStencil::Stores(face, word)), [_, stencils]) = (self.stencil, planes) {
            PixelKernel::LargeStencil.note();
            for block in bits(blocks) {
                match covered[block] {
                    0 => {}
                    u64::MAX => stencils.replace_block(block, word),
                    mask => self.isa.run(StencilUpdate {
                        op: face.pass,
                        face: &face,
                        reference: Reference::OfFace,
                        stored: stencils.block_mut(block),
                        mask,
                    }),
                }
            }
        }
    }
}
