//! Which levels and faces the lanes of a batch read, and with which filter.

use super::footprint::{self, Derivatives, Probes};
use super::{Coordinates, cube};
use crate::image::Shape;
use crate::lanes::{F32s, LANES, U32s};
use crate::plan::{Detail, Lod, Texture};
use crate::sampler::Filter;

/// What the lanes of a batch read.
#[expect(clippy::large_enum_variant, reason = "lives on one call's stack, where a box costs more")]
pub enum Taps {
    /// All of them this key.
    Same(u32),
    /// Per lane two (filter, face, level), as keys, and the weight of the second. A lane that reads
    /// one level has twice the same key and no weight.
    Mixed { keys: [U32s; 2], weight: F32s },
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

/// The inverse of the function above: filter, face and level.
#[inline(always)]
pub fn parts(key: u32) -> (Filter, usize, usize) {
    let filter = if key >> FILTER == 1 { Filter::Nearest } else { Filter::Linear };
    (filter, (key >> FACE & 7) as usize, (key & 31) as usize)
}

/// What each lane reads, and its probes.
#[inline(always)]
pub fn taps(texture: &Texture, at: &Coordinates, lod: Lod<'_>) -> (Taps, Option<Probes>) {
    let mut probes = None;
    let mut keys = [U32s::ZERO; 2];
    let mut weights = F32s::ZERO;
    match &texture.detail {
        Detail::Fixed { filter, level, .. } => {
            if texture.shape != Shape::Cube {
                return (Taps::Same(key(*filter, 0, *level)), None);
            }
            let [first, second] = &mut keys;
            for lane in 0..LANES {
                first[lane] = key(*filter, at.face[lane], *level);
            }
            *second = *first;
        }
        Detail::PerLane { min, mag, range, probes: most } => {
            let base;
            let (lambda, bias) = match lod {
                Lod::Explicit(lambda) => (lambda, None),
                Lod::Implicit { .. } | Lod::Gradient { .. } => {
                    let d = derivatives(texture, at, &lod);
                    let axes = texture.shape.axes();
                    if *most > 1 {
                        let most = *most as f32;
                        (base, probes) = footprint::anisotropic(&d, axes, texture.scale, most);
                    } else {
                        base = footprint::isotropic(&d, axes, texture.scale);
                    }
                    let bias = match lod {
                        Lod::Implicit { bias } => bias,
                        Lod::Explicit(_) | Lod::Gradient { .. } => None,
                    };
                    (&base, bias)
                }
            };
            let lambda = range.lambda(lambda, bias);
            let (levels, weight) = range.levels(&lambda);
            let (min, mag) = (key(*min, 0, 0), key(*mag, 0, 0));
            for lane in 0..LANES {
                let minified = lambda[lane] > range.magnified_to;
                let face = at.face[lane] << FACE;
                let first = min | face | levels[0][lane];
                let second = min | face | levels[1][lane];
                let second = if weight[lane] > 0.0 { second } else { first };
                keys[0][lane] = if minified { first } else { mag | face };
                keys[1][lane] = if minified { second } else { mag | face };
                weights[lane] = if minified { weight[lane] } else { 0.0 };
            }
        }
    }
    let least = next_key(&keys, 0);
    if next_key(&keys, least) == NONE {
        return (Taps::Same(least), probes);
    }
    (Taps::Mixed { keys, weight: weights }, probes)
}

/// The derivatives of the coordinates that are filtered along; of a cube's, on the face.
#[inline(always)]
fn derivatives(texture: &Texture, at: &Coordinates, lod: &Lod<'_>) -> Derivatives {
    let axes = if texture.shape == Shape::Cube { 3 } else { texture.shape.axes() };
    let given = match lod {
        Lod::Gradient { dx, dy } => Derivatives { dx: dx.map(|d| *d), dy: dy.map(|d| *d) },
        Lod::Implicit { .. } | Lod::Explicit(_) => Derivatives::of_quads(at.given, axes),
    };
    if texture.shape != Shape::Cube {
        return given;
    }
    let [dsdx, dtdx] = cube::derivatives(&at.face, at.given, &given.dx);
    let [dsdy, dtdy] = cube::derivatives(&at.face, at.given, &given.dy);
    Derivatives { dx: [dsdx, dtdx, F32s::ZERO], dy: [dsdy, dtdy, F32s::ZERO] }
}

/// What [`next_key`] gives when there is none.
pub const NONE: u32 = u32::MAX;

/// The least key of the batch above `floor`.
#[inline(always)]
pub fn next_key(keys: &[U32s; 2], floor: u32) -> u32 {
    let [first, second] = keys;
    let mut least = NONE;
    for lane in 0..LANES {
        let a = if first[lane] > floor { first[lane] } else { NONE };
        let b = if second[lane] > floor { second[lane] } else { NONE };
        let lower = if a < b { a } else { b };
        least = if lower < least { lower } else { least };
    }
    least
}
