//! The depth test (GL 2.1, section 4.1.6), on the words that the attachment holds.

use crate::attachment::{DepthFormat, depth_words, expand_mask};
use crate::desc::DepthWrite;
use texunit::lanes::{F32s, Kernel, LANES, Simd, U32s};
use texunit::sampler::Compare;

/// What a draw does with depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DepthPlan {
    /// How it is stored.
    pub format: DepthFormat,
    /// `new OP stored` must hold.
    pub test: Compare,
    /// Whether passing fragments write.
    pub write: DepthWrite,
}

impl DepthPlan {
    /// The words that change, of those that pass.
    pub fn changed(&self, passed: u64) -> u64 {
        match self.write {
            DepthWrite::On => passed,
            DepthWrite::Off => 0,
        }
    }
}

/// Tests and writes 64 fragments; returns the mask of those that passed.
pub struct DepthTest<'a> {
    /// What is done.
    pub plan: DepthPlan,
    /// The depth of each, in [0, 1].
    pub depth: &'a F32s,
    /// The attachment's words.
    pub stored: &'a mut U32s,
    /// Which fragments there are.
    pub mask: u64,
}

impl Kernel for DepthTest<'_> {
    type Output = u64;
    #[inline(always)]
    fn run<S: Simd>(self) -> u64 {
        let Self { plan, depth, stored, mask } = self;
        let mut new = U32s::ZERO;
        depth_words(plan.format, depth, &mut new);
        let covered = expand_mask(mask);
        let mut pass = U32s::ZERO;
        match plan.test {
            Compare::Never => {}
            Compare::Less => compare(&mut pass, &new, stored, |a, b| a < b),
            Compare::Equal => compare(&mut pass, &new, stored, |a, b| a == b),
            Compare::LessEqual => compare(&mut pass, &new, stored, |a, b| a <= b),
            Compare::Greater => compare(&mut pass, &new, stored, |a, b| a > b),
            Compare::NotEqual => compare(&mut pass, &new, stored, |a, b| a != b),
            Compare::GreaterEqual => compare(&mut pass, &new, stored, |a, b| a >= b),
            Compare::Always => pass = U32s::splat(!0),
        }
        for lane in 0..LANES {
            pass[lane] &= covered[lane];
        }
        if plan.write == DepthWrite::On {
            for lane in 0..LANES {
                stored[lane] = (new[lane] & pass[lane]) | (stored[lane] & !pass[lane]);
            }
        }
        S::nonzero(&pass)
    }
}

/// All ones in the lanes where `holds`.
#[inline(always)]
fn compare(pass: &mut U32s, new: &U32s, stored: &U32s, holds: impl Fn(u32, u32) -> bool) {
    for lane in 0..LANES {
        pass[lane] = if holds(new[lane], stored[lane]) { !0 } else { 0 };
    }
}
