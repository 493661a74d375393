//! Which levels and faces the lanes of a batch read, and with which filter.

use super::coordinates::Coordinates;
use super::derivatives::{Derivatives, quad_derivatives};
use super::footprint::{self, Footprint, FootprintSet};
use super::lookup::Lod;
use super::recorder::Recorder;
use super::{cube, row_scan};
use crate::lanes::{F32s, LANES, Simd, U32s};
use crate::plan::{Anisotropy, LevelSelection, Texture};
use crate::sampler::Filter;
use crate::trace::SampleStep;

/// The (filter, face, level) that each lane of a batch reads, as keys.
#[derive(Clone, Copy)]
#[expect(clippy::large_enum_variant, reason = "lives on one call's stack, where a box costs more")]
pub enum LevelTaps {
    /// All lanes read this key.
    Uniform(u32),
    /// All lanes read these two keys, with the weight of the second; 0 where it is not read.
    UniformPair { keys: [u32; 2], weight: F32s },
    /// Two keys per lane, and the weight of the second. A lane that reads one level has twice the same
    /// key, and weight 0.
    PerLane { keys: [U32s; 2], weight: F32s },
}

impl LevelTaps {
    /// The least key above `floor` that any lane reads, or [`NO_KEY`].
    #[inline(always)]
    pub fn next<S: Simd>(&self, floor: u32) -> u32 {
        match self {
            Self::Uniform(key) => {
                if *key > floor {
                    *key
                } else {
                    NO_KEY
                }
            }
            Self::UniformPair { keys: [first, second], .. } => {
                let second = if *second > floor { *second } else { NO_KEY };
                if *first > floor { *first } else { second }
            }
            Self::PerLane { keys, .. } => next_key::<S>(keys, floor),
        }
    }

    /// The keys that a lane reads; twice the same where it reads one.
    #[inline(always)]
    pub fn of_lane(&self, lane: usize) -> [u32; 2] {
        match self {
            Self::Uniform(key) => [*key; 2],
            Self::UniformPair { keys, weight } => {
                [keys[0], if weight[lane] > 0.0 { keys[1] } else { keys[0] }]
            }
            Self::PerLane { keys, .. } => [keys[0][lane], keys[1][lane]],
        }
    }

    /// The lanes that read this key, as a mask.
    #[inline(always)]
    pub fn lane_mask(&self, key: u32) -> U32s {
        let mut mask = U32s::splat(!0);
        match self {
            Self::Uniform(_) => {}
            Self::UniformPair { keys, weight } => {
                if key == keys[1] {
                    for lane in 0..LANES {
                        mask[lane] = if weight[lane] > 0.0 { !0 } else { 0 };
                    }
                }
            }
            Self::PerLane { keys: [first, second], .. } => {
                for lane in 0..LANES {
                    let reads_key = (first[lane] == key) | (second[lane] == key);
                    mask[lane] = if reads_key { !0 } else { 0 };
                }
            }
        }
        mask
    }

    /// The same levels on other faces.
    #[inline(always)]
    pub fn on_faces(&self, face: &U32s) -> Self {
        let mut keys = [U32s::ZERO; 2];
        let mut weight = F32s::ZERO;
        for lane in 0..LANES {
            let [first, second] = self.of_lane(lane);
            keys[0][lane] = first & NON_FACE_BITS | face[lane] << FACE_SHIFT;
            keys[1][lane] = second & NON_FACE_BITS | face[lane] << FACE_SHIFT;
            weight[lane] = match self {
                Self::Uniform(_) => 0.0,
                Self::UniformPair { weight, .. } | Self::PerLane { weight, .. } => weight[lane],
            };
        }
        Self::PerLane { keys, weight }
    }
}

/// First bits of the face and the filter in a key; the level is in the bits below.
const FACE_SHIFT: u32 = 5;
const FILTER_SHIFT: u32 = 8;
/// All bits of a key except the face.
const NON_FACE_BITS: u32 = !(7 << FACE_SHIFT);

/// A (filter, face, level) as a number above 0. Levels count from the base level.
#[inline(always)]
fn key(filter: Filter, face: u32, level: u32) -> u32 {
    let filter = match filter {
        Filter::Nearest => 1,
        Filter::Linear => 2,
    };
    filter << FILTER_SHIFT | face << FACE_SHIFT | level
}

/// The filter, face and level of a key.
#[inline(always)]
pub fn split_key(key: u32) -> (Filter, usize, usize) {
    let filter = if key >> FILTER_SHIFT == 1 { Filter::Nearest } else { Filter::Linear };
    (filter, (key >> FACE_SHIFT & 7) as usize, (key & 31) as usize)
}

/// The keys of each lane, and the footprints.
#[inline(always)]
pub fn taps<S: Simd, F: FootprintSet>(
    texture: &Texture,
    at: &Coordinates,
    lod: Lod<'_>,
    recorder: &mut impl Recorder,
) -> (LevelTaps, Footprint) {
    let (min, mag, range, anisotropy) = match &texture.level_selection {
        LevelSelection::PerLane { min, mag, range, anisotropy } => (min, mag, range, anisotropy),
        LevelSelection::Fixed { filter, level, why, .. } => {
            recorder.record(|_| SampleStep::Fixed { filter: *filter, level: *level, why });
            return (fixed_taps::<S>(texture, at), Footprint::Isotropic);
        }
    };
    let (base, footprint, bias) = base_lambda::<S, F>(texture, at, lod, *anisotropy, recorder);
    let lambda = range.lambda(&base, bias);
    let (levels, weight) = range.levels(&lambda);
    recorder.record(|lane| SampleStep::Lambda {
        base: base[lane],
        bias: range.bias,
        shader_bias: bias.map_or(0.0, |bias| bias[lane]),
        range: [range.min, range.max],
        lambda: lambda[lane],
    });
    recorder.record(|lane| {
        let minified = range.is_minified(lambda[lane]);
        let (first, weight) = (levels[0][lane], weight[lane]);
        SampleStep::Levels {
            magnified_to: range.magnified_to,
            filter: if minified { *min } else { *mag },
            levels: match minified {
                true => [first, if weight > 0.0 { levels[1][lane] } else { first }],
                false => [0; 2],
            },
            weight: if minified { weight } else { 0.0 },
        }
    });
    if !texture.shape.is_cube() && min == mag {
        // Up to λ = 0 the level is 0 in any case.
        if let Some(taps) = uniform_taps::<S>(key(*min, 0, 0), &levels, &weight) {
            return (taps, footprint);
        }
    }
    let mut keys = [U32s::ZERO; 2];
    let mut weights = F32s::ZERO;
    let (min, mag) = (key(*min, 0, 0), key(*mag, 0, 0));
    let faces = at.face();
    for lane in 0..LANES {
        let minified = range.is_minified(lambda[lane]);
        let face = faces[lane] << FACE_SHIFT;
        let first = min | face | levels[0][lane];
        let second = min | face | levels[1][lane];
        let second = if weight[lane] > 0.0 { second } else { first };
        keys[0][lane] = if minified { first } else { mag | face };
        keys[1][lane] = if minified { second } else { mag | face };
        weights[lane] = if minified { weight[lane] } else { 0.0 };
    }
    (per_lane_taps::<S>(keys, weights), footprint)
}

/// λ of the base level before any bias, the footprints, and the bias of the lookup.
#[inline(always)]
pub fn base_lambda<'a, S: Simd, F: FootprintSet>(
    texture: &Texture,
    at: &Coordinates<'_>,
    lod: Lod<'a>,
    anisotropy: Anisotropy,
    recorder: &mut impl Recorder,
) -> (F32s, Footprint, Option<&'a F32s>) {
    match lod {
        Lod::Explicit(lambda) => {
            recorder.record(|lane| SampleStep::Explicit(lambda[lane]));
            (*lambda, Footprint::Isotropic, None)
        }
        Lod::Implicit { bias } | Lod::Gradient { bias, .. } => {
            let axes = texture.shape.axes();
            let differences;
            let mut d = match &lod {
                Lod::Gradient { dx, dy, .. } => Derivatives { dx: *dx, dy: *dy },
                Lod::Implicit { .. } | Lod::Explicit(_) => {
                    let read = if texture.shape.is_cube() { 3 } else { axes };
                    differences = quad_derivatives(at.given, read);
                    let [dx, dy] = &differences;
                    Derivatives { dx: dx.each_ref(), dy: dy.each_ref() }
                }
            };
            let mut face_derivatives;
            if let Some(projected) = &at.projected {
                face_derivatives = [[F32s::ZERO; 2]; 2];
                cube::derivatives(projected, d.dx, d.dy, &mut face_derivatives);
                let [[dsdx, dtdx], [dsdy, dtdy]] = &face_derivatives;
                d = Derivatives { dx: [dsdx, dtdx, dtdx], dy: [dsdy, dtdy, dtdy] };
            }
            recorder.record(|lane| {
                let of = |d: [&F32s; 3]| {
                    std::array::from_fn(|axis| if axis < axes { d[axis][lane] } else { 0.0 })
                };
                SampleStep::Derivatives { dx: of(d.dx), dy: of(d.dy), scale: texture.scale }
            });
            let (base, footprint) = match anisotropy {
                Anisotropy::Probes(max_probes) if F::PROBES => {
                    let max_probes = max_probes as f32;
                    let (base, probes) =
                        footprint::anisotropic::<S>(&d, axes, texture.scale, max_probes, recorder);
                    (base, probes.map_or(Footprint::Isotropic, Footprint::Probes))
                }
                Anisotropy::Scan(most) if F::SCANS => {
                    let (base, scan) =
                        row_scan::footprint(&d, texture.scale, most as f32, recorder);
                    (base, Footprint::Scan(scan))
                }
                Anisotropy::Off | Anisotropy::Probes(_) | Anisotropy::Scan(_) => {
                    (footprint::isotropic(&d, axes, texture.scale, recorder), Footprint::Isotropic)
                }
            };
            (base, footprint, bias)
        }
    }
}

/// Where λ has no effect.
#[inline(always)]
fn fixed_taps<S: Simd>(texture: &Texture, at: &Coordinates) -> LevelTaps {
    let LevelSelection::Fixed { filter, level, .. } = &texture.level_selection else {
        return LevelTaps::Uniform(NO_KEY);
    };
    let every = key(*filter, 0, *level);
    if !texture.shape.is_cube() {
        return LevelTaps::Uniform(every);
    }
    let (faces, mut keys) = (at.face(), U32s::ZERO);
    for lane in 0..LANES {
        keys[lane] = every | faces[lane] << FACE_SHIFT;
    }
    per_lane_taps::<S>([keys, keys], F32s::ZERO)
}

/// Taps where all lanes read the same level or levels.
#[inline(always)]
fn uniform_taps<S: Simd>(filter: u32, levels: &[U32s; 2], weight: &F32s) -> Option<LevelTaps> {
    let [first, second] = common_levels::<S>(levels, weight)?;
    let keys = [filter | first, filter | second];
    Some(if first == second {
        LevelTaps::Uniform(keys[0])
    } else {
        LevelTaps::UniformPair { keys, weight: *weight }
    })
}

/// The level that all lanes read, and the next one, or the same where that has no weight.
#[inline(always)]
pub fn common_levels<S: Simd>(levels: &[U32s; 2], weight: &F32s) -> Option<[u32; 2]> {
    let first = levels[0][0];
    let mut different = U32s::ZERO;
    for lane in 0..LANES {
        different[lane] = levels[0][lane] ^ first;
    }
    if S::any(&different) {
        return None;
    }
    // Weights are not negative, and not -0.
    Some([first, if S::any(weight.as_u32()) { first + 1 } else { first }])
}

#[inline(always)]
fn per_lane_taps<S: Simd>(keys: [U32s; 2], weight: F32s) -> LevelTaps {
    let least = next_key::<S>(&keys, 0);
    if next_key::<S>(&keys, least) == NO_KEY {
        return LevelTaps::Uniform(least);
    }
    LevelTaps::PerLane { keys, weight }
}

/// No key is as large.
pub const NO_KEY: u32 = u32::MAX;

/// The least key of the batch above `floor`.
#[inline(always)]
fn next_key<S: Simd>(keys: &[U32s; 2], floor: u32) -> u32 {
    let [first, second] = keys;
    let mut above = U32s::ZERO;
    for lane in 0..LANES {
        let a = if first[lane] > floor { first[lane] } else { NO_KEY };
        let b = if second[lane] > floor { second[lane] } else { NO_KEY };
        above[lane] = if a < b { a } else { b };
    }
    S::smallest(&above)
}
