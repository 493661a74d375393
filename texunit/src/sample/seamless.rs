//! Linear filtering across the edges of a cube (ARB_seamless_cube_map).
//!
//! A texel beyond an edge is the one that touches the edge from the other face. Beyond a corner
//! there is none: the mean of the other three stands for it.

use super::cube;
use super::filter::{Place, mean, texel};
use crate::lanes::{F32s, I32s, LANES, Simd, U32s};

/// The mean of 2×2 texels, of which `i` and `j` (-1 to the size - 1) are the lower indices.
#[inline(always)]
pub fn linear<S: Simd>(
    place: &Place<'_>,
    [i, j]: [&I32s; 2],
    [alpha, beta]: [&F32s; 2],
    out: &mut [F32s; 4],
) {
    let mut words = [U32s::ZERO; 4];
    let mut missing = [U32s::ZERO; 4];
    for corner in 0..4 {
        let found = cube::beyond(
            place.face as u32,
            i,
            j,
            [(corner & 1) as i32, (corner >> 1) as i32],
            place.level.width as i32,
        );
        missing[corner] = found.missing;
        words[corner] = gather::<S>(place, &found);
    }
    for (channel, out) in out.iter_mut().enumerate().take(place.texture.format.channels()) {
        let mut texels = [F32s::ZERO; 4];
        for corner in 0..4 {
            texels[corner] = texel::<S>(place, channel, &words[corner], &U32s::ZERO);
        }
        for corner in 0..4 {
            for lane in 0..LANES {
                let [a, b, c] = [1, 2, 3].map(|turn| texels[(corner + turn) % 4][lane]);
                let filled = (a + b + c) / 3.0;
                let here = missing[corner][lane] == 0;
                texels[corner][lane] = if here { texels[corner][lane] } else { filled };
            }
        }
        *out = mean(&texels, alpha, beta);
    }
}

/// One texel of each lane, from whichever faces the lanes ended up on.
#[inline(always)]
fn gather<S: Simd>(place: &Place<'_>, found: &cube::Beyond) -> U32s {
    let mut out = U32s::ZERO;
    for (face, levels) in place.texture.levels.iter().enumerate() {
        let mut asked = 0;
        for lane in 0..LANES {
            asked += if found.face[lane] == face as u32 { 1 } else { 0 };
        }
        if asked == 0 {
            continue;
        }
        let level = &levels[place.number];
        let zero = U32s::ZERO;
        let [border_s, border_t, _] = level.border;
        let mut x = found.x;
        let mut y = found.y;
        for lane in 0..LANES {
            x[lane] += border_s;
            y[lane] += border_t;
        }
        let words = S::gather(&level.texels, &super::fetch::offsets(level, &x, &y, &zero));
        for lane in 0..LANES {
            out[lane] = if found.face[lane] == face as u32 { words[lane] } else { out[lane] };
        }
    }
    out
}
