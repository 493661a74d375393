//! Depth comparison (GL 2.1, section 3.8.14). Each texel is compared before the filter, so that a
//! linear filter gives the weighted share of texels that pass.

use crate::lanes::{F32s, LANES};
use crate::sampler::Compare;

/// Replaces each texel by 1 where `reference OP texel` holds, else by 0.
#[inline(always)]
pub fn compare(op: Compare, reference: &F32s, texels: &mut F32s) {
    match op {
        Compare::Never => each(reference, texels, |_, _| false),
        Compare::Less => each(reference, texels, |r, d| r < d),
        Compare::Equal => each(reference, texels, |r, d| r == d),
        Compare::LessEqual => each(reference, texels, |r, d| r <= d),
        Compare::Greater => each(reference, texels, |r, d| r > d),
        Compare::NotEqual => each(reference, texels, |r, d| r != d),
        Compare::GreaterEqual => each(reference, texels, |r, d| r >= d),
        Compare::Always => each(reference, texels, |_, _| true),
    }
}

#[inline(always)]
fn each(reference: &F32s, texels: &mut F32s, passes: impl Fn(f32, f32) -> bool) {
    for lane in 0..LANES {
        texels[lane] = if passes(reference[lane], texels[lane]) { 1.0 } else { 0.0 };
    }
}
