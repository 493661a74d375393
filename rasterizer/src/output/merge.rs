//! Fragments into the attachments of a tile: the tests, then the colours.

use super::color::{
    BlockColors, BlockOfPlanes, ColorClass, ColorPlan, StoreSamples, WriteBytes, WriteSampledBytes,
    WriteTexels,
};
use super::depth::{DepthPlan, DepthTest};
use super::stencil::{Reference, StencilPlan, StencilTest, StencilUpdate};
use crate::attachment::{
    BatchLayout, LoadOp, TileTarget, WordPlane, load, store, with_texels, with_words,
};
use crate::desc::{DepthWrite, StencilOp};
use crate::sizes::MAX_SAMPLES;
use texunit::lanes::{F32s, Isa, Kernel, Simd, U32s};

/// The tests of a draw.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tests {
    /// The stencil test, if any.
    pub stencil: Option<StencilPlan>,
    /// The depth test, if any.
    pub depth: Option<DepthPlan>,
}

impl Tests {
    /// Whether a fragment that is tested may leave something behind.
    pub fn write(&self) -> bool {
        self.stencil.is_some_and(|stencil| stencil.writes())
            || self.depth.is_some_and(|depth| depth.write == DepthWrite::On)
    }
}

/// 64 fragments of one sample before the tests.
pub struct Fragments<'a> {
    /// Where they are.
    pub layout: &'a BatchLayout<'a>,
    /// Their depth, in [0, 1].
    pub depth: &'a F32s,
    /// What their stencils are compared with.
    pub reference: Reference<'a>,
    /// The lanes of back faces.
    pub back: u64,
    /// The lanes that are covered.
    pub mask: u64,
}

/// Tests fragments against the planes of a sample and updates them; returns the mask of those that passed.
pub fn test(
    isa: Isa,
    tests: &Tests,
    target: &mut TileTarget,
    sample: usize,
    of: &Fragments<'_>,
) -> u64 {
    let Fragments { layout, mask, .. } = *of;
    if mask == 0 {
        return 0;
    }
    match (tests.stencil, target.sample(sample)) {
        (Some(plan), [depths, stencils]) => {
            let writes = plan.writes();
            with_words(isa, stencils, layout, LoadOp::Load, |stencils| {
                let mut test = |depth: Option<(DepthPlan, &mut U32s)>| {
                    isa.run(StencilDepthTest { plan: &plan, depth, fragments: of, stencils })
                };
                let passed = match tests.depth {
                    Some(depth) => with_words(isa, depths, layout, LoadOp::Load, |depths| {
                        let passed = test(Some((depth, depths)));
                        (passed, depth.changed(passed))
                    }),
                    None => test(None),
                };
                (passed, if writes { mask } else { 0 })
            })
        }
        (_, [depths, ..]) => match tests.depth {
            Some(plan) => with_words(isa, depths, layout, LoadOp::Load, |stored| {
                let passed = isa.run(DepthTest { plan, depth: of.depth, stored, mask });
                (passed, plan.changed(passed))
            }),
            None => mask,
        },
        (_, []) => mask,
    }
}

/// The stencil test, the depth test of what passes it, and the operations that follow.
struct StencilDepthTest<'a> {
    plan: &'a StencilPlan,
    /// The depth test and the words that it compares with, if there is one.
    depth: Option<(DepthPlan, &'a mut U32s)>,
    fragments: &'a Fragments<'a>,
    stencils: &'a mut U32s,
}

impl Kernel for StencilDepthTest<'_> {
    type Output = u64;
    #[inline(always)]
    fn run<S: Simd>(self) -> u64 {
        let Self { plan, depth, fragments, stencils: stored } = self;
        let &Fragments { depth: new, reference, back, mask, .. } = fragments;
        let faces = [(&plan.front, mask & !back), (&plan.back, mask & back)];
        let mut passed = 0;
        for (face, mask) in faces {
            if mask != 0 {
                passed |= StencilTest { face, reference, stored, mask }.run::<S>();
            }
        }
        let left = match depth {
            Some((plan, stored)) if passed != 0 => {
                DepthTest { plan, depth: new, stored, mask: passed }.run::<S>()
            }
            Some(_) | None => passed,
        };
        for (face, mask) in faces {
            let outcomes = [
                (face.fail, mask & !passed),
                (face.depth_fail, mask & passed & !left),
                (face.pass, mask & left),
            ];
            for (op, mask) in outcomes {
                if mask != 0 && op != StencilOp::Keep {
                    StencilUpdate { op, face, reference, stored, mask }.run::<S>();
                }
            }
        }
        left
    }
}

/// Writes the colours of fragments into the planes of their samples: the lanes of `masks`, by sample. The block of the
/// colours, and their mask, are not read.
pub fn write_samples(
    isa: Isa,
    plan: &ColorPlan,
    target: &mut TileTarget,
    layout: &BatchLayout<'_>,
    colors: BlockColors<'_>,
    masks: &[u64],
) {
    if let (ColorClass::Bytes, [_, _, ..]) = (plan.class, masks) {
        write_sampled_bytes(isa, plan, &mut target.planes, layout, colors, masks);
        return;
    }
    for (sample, &mask) in masks.iter().enumerate() {
        if mask != 0 {
            write(isa, plan, target, sample, layout, BlockColors { mask, ..colors });
        }
    }
}

/// Writes the colours of fragments of several samples, of which each has a plane.
fn write_sampled_bytes(
    isa: Isa,
    plan: &ColorPlan,
    planes: &mut [WordPlane],
    layout: &BatchLayout<'_>,
    colors: BlockColors<'_>,
    masks: &[u64],
) {
    if let BatchLayout::Block(block) = *layout {
        materialize_samples(plan, planes, block, masks);
        let words = BlockOfPlanes { planes, block };
        isa.run(WriteSampledBytes { plan, colors, masks, words });
        return;
    }
    let mut words = [U32s::ZERO; MAX_SAMPLES];
    if plan.load_op() == LoadOp::Load {
        for ((plane, &mask), words) in planes.iter_mut().zip(masks).zip(&mut words) {
            if mask != 0 {
                *words = load(isa, plane, layout);
            }
        }
    }
    isa.run(WriteSampledBytes { plan, colors, masks, words: &mut words });
    for ((plane, &mask), words) in planes.iter_mut().zip(masks).zip(&words) {
        if mask != 0 {
            store(plane, layout, mask, words);
        }
    }
}

/// Stores words, which several samples share, in a block of the plane of each sample.
pub fn store_samples(
    isa: Isa,
    plan: &ColorPlan,
    target: &mut TileTarget,
    (block, word): (usize, &U32s),
    masks: &[u64],
) {
    materialize_samples(plan, &mut target.planes, block, masks);
    let words = BlockOfPlanes { planes: &mut target.planes, block };
    isa.run(StoreSamples { plan, word, masks, words });
}

fn materialize_samples(plan: &ColorPlan, planes: &mut [WordPlane], block: usize, masks: &[u64]) {
    for (plane, &mask) in planes.iter_mut().zip(masks) {
        if mask != 0 {
            plane.materialize(block, plan.load_op_for_mask(mask));
        }
    }
}

/// Writes the colours of fragments into the planes of a sample; their block is that of the layout.
fn write(
    isa: Isa,
    plan: &ColorPlan,
    target: &mut TileTarget,
    sample: usize,
    layout: &BatchLayout<'_>,
    colors: BlockColors<'_>,
) {
    let mask = colors.mask;
    let planes = target.sample(sample);
    match (plan.class, planes, layout) {
        (_, planes, &BatchLayout::Block(block)) => {
            write_planes(isa, plan, planes, &[BlockColors { block, ..colors }]);
        }
        (ColorClass::Bytes, [plane], _) => {
            with_words(isa, plane, layout, plan.load_op(), |stored| {
                let colors = &[BlockColors { block: 0, ..colors }];
                isa.run(WriteBytes { plan, colors, blocks: std::slice::from_mut(stored) });
                ((), mask)
            });
        }
        (_, planes, _) => with_texels(isa, planes, layout, mask, plan.load_op(), |words| {
            let colors = &[BlockColors { block: 0, ..colors }];
            isa.run(WriteTexels { plan, colors, words });
        }),
    }
}

/// Writes the colours of whole blocks, of an attachment of one sample.
pub fn write_blocks(
    isa: Isa,
    plan: &ColorPlan,
    target: &mut TileTarget,
    colors: &[BlockColors<'_>],
) {
    write_planes(isa, plan, target.sample(0), colors);
}

fn write_planes(isa: Isa, plan: &ColorPlan, planes: &mut [WordPlane], colors: &[BlockColors<'_>]) {
    for plane in &mut *planes {
        for color in colors {
            plane.materialize(color.block, plan.load_op_for_mask(color.mask));
        }
    }
    match (plan.class, planes) {
        (ColorClass::Bytes, [plane]) => {
            isa.run(WriteBytes { plan, colors, blocks: plane.materialized_blocks() });
        }
        (_, planes) => {
            let mut words = <[&mut [U32s]; 4]>::default();
            for (words, plane) in words.iter_mut().zip(planes) {
                *words = plane.materialized_blocks();
            }
            isa.run(WriteTexels { plan, colors, words });
        }
    }
}
