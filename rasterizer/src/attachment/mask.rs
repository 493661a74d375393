//! Masks of one bit a lane, and of one word.

use texunit::lanes::{LANES, Simd, U32s};

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

/// Whether the words of all lanes are equal.
#[inline(always)]
pub fn are_equal<S: Simd>(a: &U32s, b: &U32s) -> bool {
    let mut differ = U32s::ZERO;
    for lane in 0..LANES {
        differ[lane] = a[lane] ^ b[lane];
    }
    !S::any(&differ)
}
