//! The stencil test and the operations that follow it (GL 2.1, section 4.1.5), on the words that
//! the attachment holds.

use super::depth::DepthPlan;
use crate::attachment::expand_mask;
use crate::desc::{Facing, StencilFace, StencilOp, StencilState};
use texunit::lanes::{Kernel, LANES, Simd, U32s};
use texunit::sampler::Compare;

/// What a draw does with the stencil.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StencilPlan {
    /// Of front faces, points, lines and pixel rectangles.
    pub front: StencilFace,
    /// Of back faces.
    pub back: StencilFace,
}

impl StencilPlan {
    /// What has to be done, if anything is: a test that all pass and nothing follows is left out.
    pub fn new(state: &StencilState) -> Option<Self> {
        let plan = Self { front: state.front, back: state.back };
        let idle = |face: &StencilFace| face.test == Compare::Always && !writes(face);
        (!idle(&plan.front) || !idle(&plan.back)).then_some(plan)
    }

    /// What is done with blocks whose stencils are all the same, of fragments of one facing; `None` where that depends on
    /// single fragments.
    pub fn of_blocks(&self, facing: Facing, depth: Option<DepthPlan>) -> Option<BlockStencil> {
        let face = match facing {
            Facing::Front => self.front,
            Facing::Back => self.back,
        };
        if !writes(&face) {
            return Some(BlockStencil::Compares(face));
        }
        let word = match face.pass {
            StencilOp::Replace => face.reference,
            StencilOp::Zero => 0,
            StencilOp::Keep
            | StencilOp::Increment
            | StencilOp::Decrement
            | StencilOp::IncrementWrap
            | StencilOp::DecrementWrap
            | StencilOp::Invert => return None,
        };
        let stores = face.test == Compare::Always
            && face.write_mask == u8::MAX
            && (depth.is_none() || face.depth_fail == StencilOp::Keep);
        stores.then_some(BlockStencil::Stores(face, word.into()))
    }

    /// Whether any fragment changes the stencil.
    pub fn writes(&self) -> bool {
        writes(&self.front) || writes(&self.back)
    }
}

/// What the stencil test of a face and its operations do with a block.
#[derive(Clone, Copy, Debug)]
pub enum BlockStencil {
    /// Fragments pass or fail by the comparison, and nothing is stored.
    Compares(StencilFace),
    /// All pass, and those that pass the depth test store the word, by the operation of the face.
    Stores(StencilFace, u32),
}

/// Whether any fragment of a face changes the stencil.
fn writes(face: &StencilFace) -> bool {
    let ops = [face.fail, face.depth_fail, face.pass];
    face.write_mask != 0 && ops.iter().any(|&op| op != StencilOp::Keep)
}

/// What stencils are compared with, and what takes their place.
#[derive(Clone, Copy)]
pub enum Reference<'a> {
    /// That of the face.
    OfFace,
    /// Of each fragment its own, of which 8 bits count.
    Each(&'a U32s),
}

/// Tests fragments of one face; returns the mask of those that passed.
pub struct StencilTest<'a> {
    /// What is done.
    pub face: &'a StencilFace,
    /// What is compared with.
    pub reference: Reference<'a>,
    /// The attachment's words.
    pub stored: &'a U32s,
    /// Which fragments there are.
    pub mask: u64,
}

impl Kernel for StencilTest<'_> {
    type Output = u64;
    #[inline(always)]
    fn run<S: Simd>(self) -> u64 {
        let Self { face, mask, .. } = self;
        let mut pass = U32s::ZERO;
        match face.test {
            Compare::Never => return 0,
            Compare::Less => self.compare(&mut pass, |r, s| r < s),
            Compare::Equal => self.compare(&mut pass, |r, s| r == s),
            Compare::LessEqual => self.compare(&mut pass, |r, s| r <= s),
            Compare::Greater => self.compare(&mut pass, |r, s| r > s),
            Compare::NotEqual => self.compare(&mut pass, |r, s| r != s),
            Compare::GreaterEqual => self.compare(&mut pass, |r, s| r >= s),
            Compare::Always => return mask,
        }
        S::nonzero(&pass) & mask
    }
}

impl StencilTest<'_> {
    /// All ones in the lanes where `holds` of the masked reference and the masked stencil.
    #[inline(always)]
    fn compare(&self, pass: &mut U32s, holds: impl Fn(u32, u32) -> bool) {
        let Self { face, stored, .. } = self;
        let read = u32::from(face.read_mask);
        match self.reference {
            Reference::OfFace => {
                let reference = u32::from(face.reference) & read;
                for lane in 0..LANES {
                    pass[lane] = if holds(reference, stored[lane] & read) { !0 } else { 0 };
                }
            }
            Reference::Each(reference) => {
                for lane in 0..LANES {
                    let holds = holds(reference[lane] & read, stored[lane] & read);
                    pass[lane] = if holds { !0 } else { 0 };
                }
            }
        }
    }
}

/// Applies one operation of a face to the fragments of a mask.
pub struct StencilUpdate<'a> {
    /// The operation.
    pub op: StencilOp,
    /// Whose write mask counts.
    pub face: &'a StencilFace,
    /// What [`StencilOp::Replace`] writes.
    pub reference: Reference<'a>,
    /// The attachment's words.
    pub stored: &'a mut U32s,
    /// Which fragments it is for.
    pub mask: u64,
}

impl Kernel for StencilUpdate<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { op, face, reference, stored, mask } = self;
        let covered = expand_mask(mask);
        let write = u32::from(face.write_mask);
        match op {
            StencilOp::Keep => {}
            StencilOp::Zero => update(stored, &covered, write, |_| 0),
            StencilOp::Replace => match reference {
                Reference::OfFace => {
                    let reference = u32::from(face.reference);
                    update(stored, &covered, write, |_| reference);
                }
                Reference::Each(reference) => {
                    for lane in 0..LANES {
                        let write = covered[lane] & write;
                        stored[lane] = (reference[lane] & write) | (stored[lane] & !write);
                    }
                }
            },
            StencilOp::Increment => {
                update(stored, &covered, write, |s| if s < 255 { s + 1 } else { 255 });
            }
            StencilOp::Decrement => {
                update(stored, &covered, write, |s| if s > 0 { s - 1 } else { 0 });
            }
            StencilOp::IncrementWrap => update(stored, &covered, write, |s| s.wrapping_add(1)),
            StencilOp::DecrementWrap => update(stored, &covered, write, |s| s.wrapping_sub(1)),
            StencilOp::Invert => update(stored, &covered, write, |s| !s),
        }
    }
}

#[inline(always)]
fn update(stored: &mut U32s, covered: &U32s, write: u32, f: impl Fn(u32) -> u32) {
    for lane in 0..LANES {
        // The write mask has eight bits, so only those of the result are stored.
        let write = covered[lane] & write;
        stored[lane] = (f(stored[lane]) & write) | (stored[lane] & !write);
    }
}
