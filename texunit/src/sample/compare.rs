//! Depth comparison (GL 2.1, section 3.8.14). Each texel is compared before the filter, so that a
//! linear filter returns the weighted share of texels that pass.

use crate::lanes::math::clamp;
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

/// The reference of a comparison is clamped to [0, 1] (GL 2.1, section 3.8.14).
#[inline(always)]
pub fn unit_range(reference: &F32s) -> F32s {
    let mut out = F32s::ZERO;
    for lane in 0..LANES {
        out[lane] = clamp(reference[lane], 0.0, 1.0);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_operator_passes_what_it_names() {
        // Whether a reference below, at and above the texel passes.
        let cases = [
            (Compare::Never, [0.0, 0.0, 0.0]),
            (Compare::Less, [1.0, 0.0, 0.0]),
            (Compare::Equal, [0.0, 1.0, 0.0]),
            (Compare::LessEqual, [1.0, 1.0, 0.0]),
            (Compare::Greater, [0.0, 0.0, 1.0]),
            (Compare::NotEqual, [1.0, 0.0, 1.0]),
            (Compare::GreaterEqual, [0.0, 1.0, 1.0]),
            (Compare::Always, [1.0, 1.0, 1.0]),
        ];
        let reference = F32s::from_fn(|lane| [0.25, 0.5, 0.75][lane % 3]);
        for (op, want) in cases {
            let mut texels = F32s::splat(0.5);
            compare(op, &reference, &mut texels);
            assert_eq!(texels.0[..3], want, "{op:?}");
        }
    }
}
