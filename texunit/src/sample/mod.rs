//! The steps of a sample, in the order of the specification's chapter:
//! face → LOD → wrap → fetch and border → compare → filter → mip → expand.
//!
//! A batch runs level by level: the distinct (filter, face, level) of its 64 lanes are found, each
//! is sampled once in all lanes, and a mask keeps the lanes that asked for it. Most batches touch
//! one to three. What a lane gets does not depend on its neighbours' levels.

mod compare;
mod cube;
mod expand;
mod fetch;
mod filter;
pub(crate) mod lod;
mod wrap;

use crate::image::Shape;
use crate::lanes::math::clamp;
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s};
use crate::plan::{Detail, Lod, Texture};
use crate::sampler::Filter;

/// One call: 64 samples of a complete texture.
pub(crate) struct Sample<'a> {
    pub texture: &'a Texture,
    pub coords: [&'a F32s; 3],
    pub reference: Option<&'a F32s>,
    pub lod: Lod<'a>,
    pub out: &'a mut [F32s; 4],
}

impl Kernel for Sample<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { texture, coords, reference, lod, out } = self;
        let reference = match texture.compare {
            Some(_) => unit_range(reference.unwrap_or(coords[2])),
            None => F32s::ZERO,
        };
        let projected;
        let (face, st) = match texture.shape {
            Shape::D1 | Shape::D2 | Shape::D3 | Shape::Rect | Shape::D1Array | Shape::D2Array => {
                (&U32s::ZERO, [coords[0], coords[1]])
            }
            Shape::Cube => {
                projected = cube::project(coords);
                (&projected.face, [&projected.st[0], &projected.st[1]])
            }
        };
        let taps = taps(texture, face, coords, lod);
        sample_taps::<S>(texture, &taps, st, &reference, out);
        expand::expand(texture.format.base(), texture.depth_mode, out);
    }
}

/// The reference of a comparison is clamped to [0, 1] (GL 2.1, section 3.8.14).
#[inline(always)]
fn unit_range(reference: &F32s) -> F32s {
    let mut out = F32s::ZERO;
    for lane in 0..LANES {
        out[lane] = clamp(reference[lane], 0.0, 1.0);
    }
    out
}

/// What the lanes of a batch read: per lane two (filter, face, level), as keys, and the weight of
/// the second. A lane that reads one level has twice the same key and no weight.
struct Taps {
    /// The one key of the whole batch, where it is one; then the other fields do not matter.
    same: Option<u32>,
    keys: [U32s; 2],
    weight: F32s,
}

/// Where the face and the filter begin in a key; the level is below.
const FACE: u32 = 5;
const FILTER: u32 = 8;

/// A (filter, face, level) as a number above 0. Levels count from the base level.
#[inline(always)]
fn key(filter: Filter, face: u32, level: u32) -> u32 {
    let filter = match filter {
        Filter::Nearest => 1,
        Filter::Linear => 2,
    };
    filter << FILTER | face << FACE | level
}

/// The inverse of [`key`].
#[inline(always)]
fn parts(key: u32) -> (Filter, usize, usize) {
    let filter = if key >> FILTER == 1 { Filter::Nearest } else { Filter::Linear };
    (filter, (key >> FACE & 7) as usize, (key & 31) as usize)
}

/// What each lane reads.
#[inline(always)]
fn taps(texture: &Texture, face: &U32s, coords: [&F32s; 3], lod: Lod<'_>) -> Taps {
    let mut taps = Taps { same: None, keys: [U32s::ZERO; 2], weight: F32s::ZERO };
    match &texture.detail {
        Detail::Fixed { filter, level, .. } => {
            if texture.shape == Shape::D2 {
                taps.same = Some(key(*filter, 0, *level));
                return taps;
            }
            for lane in 0..LANES {
                taps.keys[0][lane] = key(*filter, face[lane], *level);
            }
            taps.keys[1] = taps.keys[0];
        }
        Detail::PerLane { min, mag, range } => {
            let lambda = match lod {
                Lod::Implicit { bias } => {
                    let [s, t, r] = coords;
                    let dx = [&lod::across(s), &lod::across(t), &lod::across(r)];
                    let dy = [&lod::upward(s), &lod::upward(t), &lod::upward(r)];
                    range.lambda(&lambda_base(texture, face, coords, dx, dy), bias)
                }
                Lod::Explicit(base) => range.lambda(base, None),
                Lod::Gradient { dx, dy } => {
                    range.lambda(&lambda_base(texture, face, coords, dx, dy), None)
                }
            };
            let (levels, weight) = range.levels(&lambda);
            let (min, mag) = (key(*min, 0, 0), key(*mag, 0, 0));
            for lane in 0..LANES {
                let minified = lambda[lane] > range.magnified_to;
                let face = face[lane] << FACE;
                let first = min | face | levels[0][lane];
                let second = min | face | levels[1][lane];
                let second = if weight[lane] > 0.0 { second } else { first };
                taps.keys[0][lane] = if minified { first } else { mag | face };
                taps.keys[1][lane] = if minified { second } else { mag | face };
                taps.weight[lane] = if minified { weight[lane] } else { 0.0 };
            }
        }
    }
    let least = least_above(&taps, 0);
    if least_above(&taps, least) == NONE {
        taps.same = Some(least);
    }
    taps
}

/// λ before bias and clamp, from the derivatives of the coordinates.
#[inline(always)]
fn lambda_base(
    texture: &Texture,
    face: &U32s,
    coords: [&F32s; 3],
    dx: [&F32s; 3],
    dy: [&F32s; 3],
) -> F32s {
    match texture.shape {
        Shape::D1 | Shape::D2 | Shape::D3 | Shape::Rect | Shape::D1Array | Shape::D2Array => {
            lod::lambda_base([dx[0], dx[1]], [dy[0], dy[1]], texture.size)
        }
        Shape::Cube => {
            let [dsdx, dtdx] = cube::derivatives(face, coords, dx);
            let [dsdy, dtdy] = cube::derivatives(face, coords, dy);
            lod::lambda_base([&dsdx, &dtdx], [&dsdy, &dtdy], texture.size)
        }
    }
}

/// Samples every distinct key once and mixes.
#[inline(always)]
fn sample_taps<S: Simd>(
    texture: &Texture,
    taps: &Taps,
    st: [&F32s; 2],
    reference: &F32s,
    out: &mut [F32s; 4],
) {
    let channels = texture.format.channels();
    let mut first = [F32s::ZERO; 4];
    let mut second = [F32s::ZERO; 4];
    let mut key = match taps.same {
        Some(key) => key,
        None => least_above(taps, 0),
    };
    while key != NONE {
        let (filter, face, level) = parts(key);
        let level = &texture.levels[face][level];
        filter::sample_level::<S>(texture, level, filter, st, reference, out);
        if taps.same.is_some() {
            return;
        }
        for channel in 0..channels {
            for lane in 0..LANES {
                let value = out[channel][lane];
                let (in_first, in_second) = (taps.keys[0][lane] == key, taps.keys[1][lane] == key);
                first[channel][lane] = if in_first { value } else { first[channel][lane] };
                second[channel][lane] = if in_second { value } else { second[channel][lane] };
            }
        }
        key = least_above(taps, key);
    }
    for channel in 0..channels {
        for lane in 0..LANES {
            out[channel][lane] =
                filter::lerp(first[channel][lane], second[channel][lane], taps.weight[lane]);
        }
    }
}

/// What [`least_above`] gives when there is none.
const NONE: u32 = u32::MAX;

/// The least key of the batch above `floor`.
#[inline(always)]
fn least_above(taps: &Taps, floor: u32) -> u32 {
    let [first, second] = &taps.keys;
    let mut least = NONE;
    for lane in 0..LANES {
        let a = if first[lane] > floor { first[lane] } else { NONE };
        let b = if second[lane] > floor { second[lane] } else { NONE };
        let lower = if a < b { a } else { b };
        least = if lower < least { lower } else { least };
    }
    least
}
