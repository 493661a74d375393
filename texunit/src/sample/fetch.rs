//! Texels of a level as words, and the border colour in their place.

use super::wrap::Indices;
use crate::image::Level;
use crate::lanes::{F32s, I32s, LANES, Simd, U32s};

/// The byte offset of each stored texel (x, y) of slice z.
#[inline(always)]
pub fn offsets(level: &Level, x: &U32s, y: &U32s, z: &U32s) -> U32s {
    let [width, height, depth] = level.stored_size();
    let bytes = level.format.bytes() as u32;
    let mut out = U32s::ZERO;
    // Below 2^30 + 4: `MAX_LEVEL_BYTES` bounds the level.
    if depth == 1 {
        for lane in 0..LANES {
            out[lane] = (y[lane].wrapping_mul(width).wrapping_add(x[lane])).wrapping_mul(bytes);
        }
    } else {
        for lane in 0..LANES {
            let row = z[lane].wrapping_mul(height).wrapping_add(y[lane]);
            out[lane] = (row.wrapping_mul(width).wrapping_add(x[lane])).wrapping_mul(bytes);
        }
    }
    out
}

/// Whether texel `i` and the next lie side by side in the row in every lane.
#[inline(always)]
pub fn side_by_side(i: &I32s, size: u32) -> bool {
    let mut largest = 0;
    for lane in 0..LANES {
        // -1 is the largest of all.
        let at = i[lane] as u32;
        largest = if at > largest { at } else { largest };
    }
    largest < size - 1
}

/// The texels at the offsets and those right after, in one gather; of up to four bytes each.
#[inline(always)]
pub fn neighbours<S: Simd>(level: &Level, offsets: &U32s) -> [U32s; 2] {
    let bytes = level.format.bytes();
    if bytes == 4 {
        return S::gather_pairs(&level.texels, offsets);
    }
    if bytes == 3 {
        let [low, mut high] = S::gather_pairs(&level.texels, offsets);
        for lane in 0..LANES {
            high[lane] = low[lane] >> 24 | high[lane] << 8;
        }
        return [low, high];
    }
    let low = S::gather(&level.texels, offsets);
    let mut high = U32s::ZERO;
    let shift = 8 * bytes as u32;
    for lane in 0..LANES {
        high[lane] = low[lane] >> shift;
    }
    [low, high]
}

/// Puts `border` where the mask is set.
#[inline(always)]
pub fn mix_border(outside: &U32s, border: f32, texels: &mut F32s) {
    for lane in 0..LANES {
        texels[lane] = if outside[lane] != 0 { border } else { texels[lane] };
    }
}

/// Where any of the indices lies outside.
#[inline(always)]
pub fn outside(x: &Indices, y: &Indices, z: &Indices) -> U32s {
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        out[lane] = x.outside[lane] | y.outside[lane] | z.outside[lane];
    }
    out
}
