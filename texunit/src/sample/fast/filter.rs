//! The texel that a point lies in, and the mean of the 2×2 about it.

use super::channels::{of_square, of_texel};
use super::offsets::moved;
use super::quad::{Places, Search, Square, one_by_one, square};
use super::reach::reach;
use crate::lanes::math::index;
use crate::lanes::{F32s, LANES, Simd, U32s};
use crate::plan::{Alpha, Class};
use crate::sample::level_view::Place;
use crate::sampler::Filter;

/// The texel that each point lies in; or `false`, where this way does not lead.
#[inline(always)]
pub fn nearest<S: Simd>(
    place: &Place<'_>,
    class: Class,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
) -> bool {
    let Some(offsets) = texel_offsets::<S>(place, at) else { return false };
    let (texels, format) = (&place.level.texels, place.level.format);
    let mut second = U32s::ZERO;
    for word in 0..format.words() {
        let words = match word % 2 {
            0 if word + 1 < format.words() => {
                let pair = S::gather_pairs(texels, &moved(&offsets, word));
                second = pair[1];
                pair[0]
            }
            0 => S::gather(texels, &moved(&offsets, word)),
            _ => second,
        };
        of_texel::<S>(class, format.channels(), word, &words, out);
    }
    true
}

/// Where the texels begin that the points lie in; `None`, where this way does not lead.
#[inline(always)]
fn texel_offsets<S: Simd>(place: &Place<'_>, at: [&F32s; 3]) -> Option<U32s> {
    if place.texture.reaches_border(Filter::Nearest) {
        return None;
    }
    let (s, t) = (place.axis(0), place.axis(1));
    let (u, v) = (s.texel_coordinate::<S>(at[0]), t.texel_coordinate::<S>(at[1]));
    let level = place.level;
    let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
    let origin = level.origin() as u32;
    let (last_s, last_t) = ((s.size - 1) as f32, (t.size - 1) as f32);
    let mut offsets = U32s::ZERO;
    for lane in 0..LANES {
        // A coordinate may be rounded up to the size.
        let (x, y) = (index(u[lane], last_s), index(v[lane], last_t));
        offsets[lane] = y.wrapping_mul(row).wrapping_add(x.wrapping_mul(bytes)) + origin;
    }
    Some(offsets)
}

/// The texels that the points lie in, of one word each; `None`, where this way does not lead.
#[inline(always)]
pub fn texels<S: Simd>(place: &Place<'_>, at: [&F32s; 3]) -> Option<U32s> {
    let offsets = texel_offsets::<S>(place, at)?;
    Some(S::gather_here(&place.level.texels, &offsets))
}

/// The mean of 2×2 texels; or `false`, where this way does not lead.
#[inline(always)]
pub fn linear<S: Simd>(
    place: &Place<'_>,
    class: Class,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
) -> bool {
    let (words, channels) = (place.level.format.words(), place.level.format.channels());
    if words == 1 {
        let mut found = Square::default();
        if square::<S>(place, at, Places::Own, &mut found) == Search::Nowhere {
            return false;
        }
        let Square { words, weights, .. } = &found;
        let alpha = place.texture.alpha;
        of_square::<S>(class, (channels, alpha), 0, words.each_ref(), weights.each_ref(), out);
        return true;
    }
    let Some(reach) = reach::<S>(place, at) else { return false };
    let corners = reach.corners(place);
    let level = place.level;
    let weights = reach.weights.each_ref();
    let mut word = 0;
    while word + 1 < words {
        let a = S::gather_pairs(&level.texels, &moved(&corners[0], word));
        let b = S::gather_pairs(&level.texels, &moved(&corners[1], word));
        let c = S::gather_pairs(&level.texels, &moved(&corners[2], word));
        let d = S::gather_pairs(&level.texels, &moved(&corners[3], word));
        for half in 0..2 {
            let corners = [&a[half], &b[half], &c[half], &d[half]];
            of_square::<S>(class, (channels, Alpha::Read), word + half, corners, weights, out);
        }
        word += 2;
    }
    if word < words {
        let words = one_by_one::<S>(place, &corners, word);
        of_square::<S>(class, (channels, Alpha::Read), word, words.each_ref(), weights, out);
    }
    true
}
