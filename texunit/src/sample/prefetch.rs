//! Prefetches texels of large textures before they are sampled: rows lie too far apart for the hardware prefetcher.
//! No result depends on what is prefetched.

use super::derivatives::{Derivatives, rho_squared};
use super::level_view::LevelView;
use super::lookup::Lod;
use super::uniform_levels::{UniformLevels, plane_view};
use crate::lanes::math::index;
use crate::lanes::{F32s, LANES, QUADS, Simd, U32s, prefetch_at};
use crate::plan::{LevelSelection, Texture};

/// Levels of fewer bytes are not prefetched: they stay in the cache.
const MIN_BYTES: usize = 1 << 20;

/// Of each 16 quads, four by four, those on the diagonals: they touch every row and every column of quads, however the
/// texture is rotated on the screen.
const PREFETCHED_LANES: [usize; 8] = [0, 5, 10, 15, 3, 6, 9, 12];

/// The levels that a batch will read, exactly or estimated.
#[derive(Clone, Copy)]
pub enum LevelHint<'a> {
    /// Exactly these.
    Uniform(UniformLevels),
    /// Estimated from the first lane of a batch with these coordinates and this level of detail.
    FirstLane([&'a F32s; 3], Lod<'a>),
}

/// Prefetches two rows at the points (s and t) of some lanes.
#[inline(always)]
pub(crate) fn prefetch<S: Simd>(texture: &Texture, points: [&F32s; 2], hint: LevelHint<'_>) {
    let levels = &texture.levels[0];
    if levels[0].texels.len() < MIN_BYTES {
        return;
    }
    let (filter, first, last) = match (&texture.level_selection, hint) {
        (LevelSelection::Fixed { filter, level, .. }, _) => (*filter, *level, *level),
        (_, LevelHint::Uniform(UniformLevels { filter, levels: [first, last], .. })) => {
            (filter, first, last)
        }
        (LevelSelection::PerLane { min, range, .. }, LevelHint::FirstLane(coords, lod)) => {
            let first = estimate_level(texture, coords, &lod).min(range.last);
            (*min, first, (first + 1).min(range.last))
        }
    };
    for number in first..=last {
        let view = plane_view(texture, filter, number);
        if view.level.texels.len() >= MIN_BYTES {
            // Points are half as far apart on the second level.
            let lanes =
                if number == first { &PREFETCHED_LANES[..] } else { &PREFETCHED_LANES[..4] };
            prefetch_level::<S>(&view, points, lanes);
        }
    }
}

/// `⌊λ⌋` of the first lane, at least 0, from the exponent of ρ² alone.
#[inline(always)]
fn estimate_level(texture: &Texture, coords: [&F32s; 3], lod: &Lod<'_>) -> u32 {
    let differences;
    let derivatives = match lod {
        Lod::Gradient { dx, dy, .. } => Derivatives { dx: *dx, dy: *dy },
        Lod::Implicit { .. } => {
            let to = |lane: usize| coords.map(|v| F32s::splat(v[lane] - v[0]));
            differences = [to(QUADS), to(2 * QUADS)];
            let [dx, dy] = &differences;
            Derivatives { dx: dx.each_ref(), dy: dy.each_ref() }
        }
        Lod::Explicit(lambda) => return lambda[0] as u32,
    };
    let exponent = (rho_squared(&derivatives, texture.scale, 0).to_bits() >> 23) as i32 - 127;
    (exponent >> 1).max(0) as u32
}

/// Larger than any texel index.
const MAX_INDEX: f32 = 65_536.0;

#[inline(always)]
fn prefetch_level<S: Simd>(view: &LevelView<'_>, points: [&F32s; 2], lanes: &[usize]) {
    let (s, t) = (view.axis(0), view.axis(1));
    let (u, v) = (s.texel_coordinate::<S>(points[0]), t.texel_coordinate::<S>(points[1]));
    let level = view.level;
    let (bytes, row) = (level.format.bytes() as u32, level.row_bytes() as u32);
    let mut offsets = U32s::ZERO;
    for lane in 0..LANES {
        let (i, j) = (index(u[lane], MAX_INDEX), index(v[lane], MAX_INDEX));
        offsets[lane] = j.wrapping_mul(row).wrapping_add(i.wrapping_mul(bytes));
    }
    for pixel in offsets.0.chunks_exact(QUADS) {
        for &lane in lanes {
            let at = pixel[lane % QUADS] as usize;
            prefetch_at(&level.texels, at);
            prefetch_at(&level.texels, at.wrapping_add(row as usize));
        }
    }
}
