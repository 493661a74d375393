//! From masks of one bit a fragment to those of one lane each.

use texunit::lanes::{LANES, U32s};

/// All ones in the lanes of a mask.
#[inline(always)]
pub fn expand_mask(mask: u64) -> U32s {
    let halves = [mask as u32, (mask >> 32) as u32];
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        out[lane] = if halves[lane / 32] & 1 << (lane % 32) != 0 { !0 } else { 0 };
    }
    out
}
