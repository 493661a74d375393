//! Sums of byte offsets.

use crate::lanes::{LANES, U32s};

#[inline(always)]
pub fn add_offsets(a: &U32s, b: &U32s) -> U32s {
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        out[lane] = a[lane].wrapping_add(b[lane]);
    }
    out
}

/// The offsets of a later word of the same texels.
#[inline(always)]
pub fn word_offsets(offsets: &U32s, word: usize) -> U32s {
    add_offsets(offsets, &U32s::splat(4 * word as u32))
}
