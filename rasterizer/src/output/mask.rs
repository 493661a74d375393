//! Masks of 64 fragments: one bit each, and one lane each.

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

/// The mask of the lanes that are not zero.
#[inline(always)]
pub fn pack_mask(lanes: &U32s) -> u64 {
    let mut bytes = [0_u8; LANES];
    for lane in 0..LANES {
        bytes[lane] = u8::from(lanes[lane] != 0);
    }
    let mut mask = 0;
    for (index, eight) in bytes.as_chunks::<8>().0.iter().enumerate() {
        // Moves bit 0 of byte `i` to bit `56 + i`.
        let gathered = u64::from_le_bytes(*eight).wrapping_mul(0x0102_0408_1020_4080) >> 56;
        mask |= gathered << (8 * index);
    }
    mask
}
