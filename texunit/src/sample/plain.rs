//! The short way for most textures: two-dimensional, of bytes, sRGB bytes, halves, floats or blocks,
//! where neither the border nor another face is reached and nothing is compared.
//!
//! Gives the bits of the general way in `filter` (a test holds this), in fewer passes: whole
//! offsets in one loop, the two texels of a row in one gather, channels from words in registers.

pub mod blocks;
mod channels;
#[cfg(test)]
mod tests;

use channels::of_square;
pub use channels::{Class, of_texel};

use super::fetch::{neighbours, side_by_side};
use super::filter::Place;
use super::wrap::{Axis, enclosing};
use crate::lanes::{F32s, I32s, LANES, Simd, U32s};
use crate::sampler::{Filter, Seamless, Wrap};

/// The texel that each point lies in; or `false`, where this way does not lead.
#[inline(always)]
pub fn nearest<S: Simd>(
    place: &Place<'_>,
    class: Class,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
) -> bool {
    if place.texture.reaches_border(Filter::Nearest) {
        return false;
    }
    let (s, t) = (place.axis(0), place.axis(1));
    let (u, v) = (s.texel_coordinate::<S>(at[0]), t.texel_coordinate::<S>(at[1]));
    let level = place.level;
    let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
    let origin = level.origin() as u32;
    let (last_s, last_t) = (s.size as i32 - 1, t.size as i32 - 1);
    let mut offsets = U32s::ZERO;
    for lane in 0..LANES {
        // Neither is below 0; the coordinate may be rounded up to the size.
        let (i, j) = (S::floor_small(u[lane]).0, S::floor_small(v[lane]).0);
        let x = if i > last_s { last_s } else { i } as u32;
        let y = if j > last_t { last_t } else { j } as u32;
        offsets[lane] = y.wrapping_mul(row).wrapping_add(x.wrapping_mul(bytes)) + origin;
    }
    for word in 0..level.format.words() {
        let words = S::gather(&level.texels, &moved(&offsets, word));
        of_texel::<S>(class, level.format.channels(), word, &words, out);
    }
    true
}

/// The mean of 2×2 texels; or `false`, where this way does not lead.
#[inline(always)]
pub fn linear<S: Simd>(
    place: &Place<'_>,
    class: Class,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
) -> bool {
    let Some(reach) = reach::<S>(place, at) else { return false };
    let Reach { axes: [s, t], first: [i, j], weights: [alpha, beta], inside } = &reach;
    let level = place.level;
    let xs = ends(s, i, inside[0], level.format.bytes() as u32, level.origin() as u32);
    let ys = ends(t, j, inside[1], level.row_bytes() as u32, 0);
    let offsets = [sum(&xs[0], &ys[0]), sum(&xs[0], &ys[1])];
    let weights = [alpha, beta];
    let (words, channels) = (level.format.words(), level.format.channels());
    if words == 1 && inside[0] {
        let [a, b] = neighbours::<S>(level, &offsets[0]);
        let [c, d] = neighbours::<S>(level, &offsets[1]);
        of_square::<S>(class, channels, 0, [&a, &b, &c, &d], weights, out);
        return true;
    }
    let corners = [offsets[0], sum(&xs[1], &ys[0]), offsets[1], sum(&xs[1], &ys[1])];
    let mut word = 0;
    while word + 1 < words {
        let a = S::gather_pairs(&level.texels, &moved(&corners[0], word));
        let b = S::gather_pairs(&level.texels, &moved(&corners[1], word));
        let c = S::gather_pairs(&level.texels, &moved(&corners[2], word));
        let d = S::gather_pairs(&level.texels, &moved(&corners[3], word));
        for half in 0..2 {
            let corners = [&a[half], &b[half], &c[half], &d[half]];
            of_square::<S>(class, channels, word + half, corners, weights, out);
        }
        word += 2;
    }
    if word < words {
        let a = S::gather(&level.texels, &moved(&corners[0], word));
        let b = S::gather(&level.texels, &moved(&corners[1], word));
        let c = S::gather(&level.texels, &moved(&corners[2], word));
        let d = S::gather(&level.texels, &moved(&corners[3], word));
        of_square::<S>(class, channels, word, [&a, &b, &c, &d], weights, out);
    }
    true
}

/// The squares of texels that lanes take means of.
struct Reach {
    /// Of s and t.
    axes: [Axis; 2],
    /// Column and row of the lower left texel; -1 is beyond the edge.
    first: [I32s; 2],
    /// Of the right and of the upper texels.
    weights: [F32s; 2],
    /// Whether both columns, both rows, are the level's in every lane.
    inside: [bool; 2],
}

/// Finds the squares; `None` where the border or another face is reached.
#[inline(always)]
fn reach<S: Simd>(place: &Place<'_>, at: [&F32s; 3]) -> Option<Reach> {
    let axes = [place.axis(0), place.axis(1)];
    let (i, alpha) = enclosing::<S>(&axes[0].texel_coordinate::<S>(at[0]));
    let (j, beta) = enclosing::<S>(&axes[1].texel_coordinate::<S>(at[1]));
    let inside = [side_by_side::<S>(&i, axes[0].size), side_by_side::<S>(&j, axes[1].size)];
    let seamless = place.texture.seamless == Seamless::On;
    for (axis, inside) in axes.iter().zip(inside) {
        if !inside && (seamless || axis.wrap.reaches_border(Filter::Linear)) {
            return None;
        }
    }
    Some(Reach { axes, first: [i, j], weights: [alpha, beta], inside })
}

/// The byte offsets of the lower and the upper texel along one axis, `stride` bytes apart.
#[inline(always)]
fn ends(axis: &Axis, i: &I32s, inside: bool, stride: u32, origin: u32) -> [U32s; 2] {
    let mut low = U32s::ZERO;
    let mut high = U32s::ZERO;
    if inside {
        for lane in 0..LANES {
            let at = (i[lane] as u32).wrapping_mul(stride).wrapping_add(origin);
            low[lane] = at;
            high[lane] = at.wrapping_add(stride);
        }
        return [low, high];
    }
    let last = axis.size as i32 - 1;
    let (below, above) = if axis.wrap == Wrap::Repeat { (last, 0) } else { (0, last) };
    for lane in 0..LANES {
        let lower = if i[lane] < 0 { below } else { i[lane] } as u32;
        let upper = if i[lane] < last { i[lane] + 1 } else { above } as u32;
        low[lane] = lower.wrapping_mul(stride).wrapping_add(origin);
        high[lane] = upper.wrapping_mul(stride).wrapping_add(origin);
    }
    [low, high]
}

#[inline(always)]
fn sum(a: &U32s, b: &U32s) -> U32s {
    let mut out = U32s::ZERO;
    for lane in 0..LANES {
        out[lane] = a[lane].wrapping_add(b[lane]);
    }
    out
}

/// The offsets of a later word of the same texels.
#[inline(always)]
pub fn moved(offsets: &U32s, word: usize) -> U32s {
    sum(offsets, &U32s::splat(4 * word as u32))
}
