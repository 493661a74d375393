//! Texels asked for before they are sampled. A texture is often larger than what a processor keeps near, and its
//! rows lie too far apart for it to guess which one comes next. Whatever is asked for, no result depends on it.

use super::derivatives::{Derivatives, rho_squared};
use super::level_view::LevelView;
use super::lookup::Lod;
use super::uniform_levels::{Read, plane_view};
use crate::lanes::math::index;
use crate::lanes::{F32s, LANES, QUADS, Simd, U32s, prefetch_at};
use crate::plan::{LevelSelection, Texture};

/// Levels of fewer bytes stay near by themselves.
const FAR: usize = 1 << 20;

/// Of each 16 points, four by four, those on the diagonals: of any two sides of a block they reach both, whichever
/// way the texture is turned.
const ASKED: [usize; 8] = [0, 5, 10, 15, 3, 6, 9, 12];

/// What a batch reads, or about that.
#[derive(Clone, Copy)]
pub enum Like<'a> {
    /// This.
    Read(Read),
    /// About what the first lane of a batch reads that has these coordinates and this level of detail.
    First([&'a F32s; 3], Lod<'a>),
}

/// Asks for the rows around points of a plane: of every 16 lanes, every other pixel of a block.
#[inline(always)]
pub(crate) fn ask<S: Simd>(texture: &Texture, points: [&F32s; 2], like: Like<'_>) {
    let levels = &texture.levels[0];
    if levels[0].texels.len() < FAR {
        return;
    }
    let (filter, first, last) = match (&texture.level_selection, like) {
        (LevelSelection::Fixed { filter, level, .. }, _) => (*filter, *level, *level),
        (_, Like::Read(Read { filter, levels: [first, last] })) => (filter, first, last),
        (LevelSelection::PerLane { min, range, .. }, Like::First(like, lod)) => {
            let first = guess(texture, like, &lod).min(range.last);
            (*min, first, (first + 1).min(range.last))
        }
    };
    for number in first..=last {
        let view = plane_view(texture, filter, number);
        if view.level.texels.len() >= FAR {
            // Texels of the second level are twice as large.
            let asked = if number == first { &ASKED[..] } else { &ASKED[..4] };
            ask_level::<S>(&view, points, asked);
        }
    }
}

/// The whole levels of λ in the first lane, by its exponent alone.
#[inline(always)]
fn guess(texture: &Texture, like: [&F32s; 3], lod: &Lod<'_>) -> u32 {
    let differences;
    let derivatives = match lod {
        Lod::Gradient { dx, dy, .. } => Derivatives { dx: *dx, dy: *dy },
        Lod::Implicit { .. } => {
            let to = |lane: usize| like.map(|v| F32s::splat(v[lane] - v[0]));
            differences = [to(QUADS), to(2 * QUADS)];
            let [dx, dy] = &differences;
            Derivatives { dx: dx.each_ref(), dy: dy.each_ref() }
        }
        Lod::Explicit(lambda) => return lambda[0] as u32,
    };
    let exponent = (rho_squared(&derivatives, texture.scale, 0).to_bits() >> 23) as i32 - 127;
    (exponent >> 1).max(0) as u32
}

/// Beyond any texel.
const MAX: f32 = 65_536.0;

#[inline(always)]
fn ask_level<S: Simd>(view: &LevelView<'_>, points: [&F32s; 2], asked: &[usize]) {
    let (s, t) = (view.axis(0), view.axis(1));
    let (u, v) = (s.texel_coordinate::<S>(points[0]), t.texel_coordinate::<S>(points[1]));
    let level = view.level;
    let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
    let mut offsets = U32s::ZERO;
    for lane in 0..LANES {
        let (i, j) = (index(u[lane], MAX), index(v[lane], MAX));
        offsets[lane] = j.wrapping_mul(row).wrapping_add(i.wrapping_mul(bytes));
    }
    for block in offsets.0.chunks_exact(QUADS) {
        for &point in asked {
            let at = block[point % QUADS] as usize;
            prefetch_at(&level.texels, at);
            prefetch_at(&level.texels, at.wrapping_add(row as usize));
        }
    }
}
