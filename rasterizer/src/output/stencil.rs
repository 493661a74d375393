//! The stencil test and the operations that follow it (GL 2.1, section 4.1.5), on the words that
//! the attachment holds.

use super::mask::expand_mask;
use crate::driver::{StencilFace, StencilOp, StencilState};
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

    /// Whether any fragment changes the stencil.
    pub fn writes(&self) -> bool {
        writes(&self.front) || writes(&self.back)
    }
}

/// Whether any fragment of a face changes the stencil.
fn writes(face: &StencilFace) -> bool {
    let ops = [face.fail, face.depth_fail, face.pass];
    face.write_mask != 0 && ops.iter().any(|&op| op != StencilOp::Keep)
}

/// Tests fragments of one face; gives those that passed.
pub struct StencilTest<'a> {
    /// What is done.
    pub face: &'a StencilFace,
    /// The attachment's words.
    pub stored: &'a U32s,
    /// Which fragments there are.
    pub mask: u64,
}

impl Kernel for StencilTest<'_> {
    type Output = u64;
    #[inline(always)]
    fn run<S: Simd>(self) -> u64 {
        let Self { face, stored, mask } = self;
        let read = u32::from(face.read_mask);
        let reference = u32::from(face.reference) & read;
        let mut pass = U32s::ZERO;
        match face.test {
            Compare::Never => return 0,
            Compare::Less => compare(&mut pass, stored, read, |s| reference < s),
            Compare::Equal => compare(&mut pass, stored, read, |s| reference == s),
            Compare::LessEqual => compare(&mut pass, stored, read, |s| reference <= s),
            Compare::Greater => compare(&mut pass, stored, read, |s| reference > s),
            Compare::NotEqual => compare(&mut pass, stored, read, |s| reference != s),
            Compare::GreaterEqual => compare(&mut pass, stored, read, |s| reference >= s),
            Compare::Always => return mask,
        }
        S::nonzero(&pass) & mask
    }
}

/// All ones in the lanes where `holds` of the masked stencil.
#[inline(always)]
fn compare(pass: &mut U32s, stored: &U32s, read: u32, holds: impl Fn(u32) -> bool) {
    for lane in 0..LANES {
        pass[lane] = if holds(stored[lane] & read) { !0 } else { 0 };
    }
}

/// Applies one operation of a face to the fragments of a mask.
pub struct StencilUpdate<'a> {
    /// The operation.
    pub op: StencilOp,
    /// Whose reference and write mask count.
    pub face: &'a StencilFace,
    /// The attachment's words.
    pub stored: &'a mut U32s,
    /// Which fragments it is for.
    pub mask: u64,
}

impl Kernel for StencilUpdate<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { op, face, stored, mask } = self;
        let covered = expand_mask(mask);
        let write = u32::from(face.write_mask);
        let reference = u32::from(face.reference);
        match op {
            StencilOp::Keep => {}
            StencilOp::Zero => update(stored, &covered, write, |_| 0),
            StencilOp::Replace => update(stored, &covered, write, |_| reference),
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
        // The write mask has eight bits, and so what is kept of the result.
        let write = covered[lane] & write;
        stored[lane] = (f(stored[lane]) & write) | (stored[lane] & !write);
    }
}
