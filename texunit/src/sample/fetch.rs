//! Texels of a level as words, their channels as `f32`, and the border colour in their place.

use super::wrap::Indices;
use crate::image::Level;
use crate::lanes::{F32s, LANES, Simd, U32s};

/// The four bytes from each texel on; the texel's own are the lowest.
#[inline(always)]
pub fn words<S: Simd>(level: &Level, x: &U32s, y: &U32s) -> U32s {
    let (width, bytes) = (level.width, level.format.bytes() as u32);
    let mut offsets = U32s::ZERO;
    // Below 2^30 + 4: `MAX_SIZE` bounds the level.
    for lane in 0..LANES {
        offsets[lane] = (y[lane].wrapping_mul(width).wrapping_add(x[lane])).wrapping_mul(bytes);
    }
    S::gather(&level.texels, &offsets)
}

/// Puts `border` where either index lies on the border.
#[inline(always)]
pub fn mix_border(x: &Indices, y: &Indices, border: f32, texels: &mut F32s) {
    for lane in 0..LANES {
        let outside = x.border[lane] | y.border[lane] != 0;
        texels[lane] = if outside { border } else { texels[lane] };
    }
}
