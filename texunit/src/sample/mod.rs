//! The steps of a sample, in the order of the specification's chapter:
//! face → LOD → wrap → fetch and border → compare → filter → probes → mip → expand → swizzle.
//!
//! A batch runs level by level: the distinct (filter, face, level) of its 64 lanes are found, each
//! is sampled once in all lanes, and a mask keeps the lanes that asked for it. Most batches touch
//! one to three. What a lane gets does not depend on its neighbours' levels.

mod compare;
mod cube;
mod expand;
mod fetch;
mod filter;
mod footprint;
pub(crate) mod lod;
mod plain;
mod seamless;
mod taps;
pub(crate) mod texel;
mod wrap;

use crate::image::{Level, Shape};
use crate::lanes::math::clamp;
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s};
use crate::plan::{Lod, Texture};
use footprint::Probes;
use taps::Taps;

/// One call: 64 samples of a complete texture.
pub(crate) struct Sample<'a> {
    pub texture: &'a Texture,
    pub coords: [&'a F32s; 3],
    pub reference: Option<&'a F32s>,
    /// Texels added along s, t, r, on each level (GLSL 1.30, section 8.7).
    pub offset: [i32; 3],
    pub lod: Lod<'a>,
    pub out: &'a mut [F32s; 4],
}

impl Kernel for Sample<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { texture, coords, reference, offset, lod, out } = self;
        let reference = match texture.compare {
            Some(_) => unit_range(reference.unwrap_or(coords[2])),
            None => F32s::ZERO,
        };
        let mut at = Coordinates { given: coords, face: U32s::ZERO, layer: U32s::ZERO, st: None };
        match texture.shape {
            Shape::D1 | Shape::D2 | Shape::Rect | Shape::D3 => {}
            Shape::D1Array => at.layer = wrap::layer(coords[1], texture.size[2]),
            Shape::D2Array => at.layer = wrap::layer(coords[2], texture.size[2]),
            Shape::Cube => {
                let projected = cube::project(coords);
                at.face = projected.face;
                at.st = Some(projected.st);
            }
        }
        let (taps, probes) = taps::taps(texture, &at, lod);
        let probes = probes.as_ref();
        let samples = Samples { texture, at: &at, offset, probes, reference: &reference };
        sample_taps::<S>(&samples, &taps, out);
        expand::expand(texture.format, texture.depth_mode, out);
        expand::swizzle(texture.format, texture.swizzle, out);
    }
}

/// Where the lanes sample.
pub(crate) struct Coordinates<'a> {
    /// s, t, r as given; of a cube, the direction.
    given: [&'a F32s; 3],
    /// Of a cube, else 0.
    face: U32s,
    /// Of an array, else 0.
    layer: U32s,
    /// On the face of a cube.
    st: Option<[F32s; 2]>,
}

impl Coordinates<'_> {
    /// The coordinates to filter along.
    #[inline(always)]
    fn filtered(&self) -> [&F32s; 3] {
        match &self.st {
            Some([s, t]) => [s, t, self.given[2]],
            None => self.given,
        }
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

/// What stays the same over the levels of a batch.
struct Samples<'a> {
    texture: &'a Texture,
    at: &'a Coordinates<'a>,
    offset: [i32; 3],
    probes: Option<&'a Probes>,
    reference: &'a F32s,
}

/// Samples every distinct key once and mixes.
#[inline(always)]
fn sample_taps<S: Simd>(samples: &Samples<'_>, taps: &Taps, out: &mut [F32s; 4]) {
    let channels = samples.texture.format.channels();
    let mut kept = None;
    let mut key = match taps {
        Taps::Same(key) => *key,
        Taps::Mixed { keys, .. } => taps::next_key(keys, 0),
    };
    while key != taps::NONE {
        sample_key::<S>(samples, key, out);
        let Taps::Mixed { keys, .. } = taps else { return };
        let [first, second] = kept.get_or_insert([[F32s::ZERO; 4]; 2]);
        keep(&keys[0], key, channels, out, first);
        keep(&keys[1], key, channels, out, second);
        key = taps::next_key(keys, key);
    }
    let (Taps::Mixed { weight, .. }, Some([first, second])) = (taps, &kept) else { return };
    for channel in 0..channels {
        for lane in 0..LANES {
            out[channel][lane] =
                filter::lerp(first[channel][lane], second[channel][lane], weight[lane]);
        }
    }
}

/// Takes the values of the lanes that asked for this key.
#[inline(always)]
fn keep(keys: &U32s, key: u32, channels: usize, values: &[F32s; 4], kept: &mut [F32s; 4]) {
    let mut asked = 0;
    for lane in 0..LANES {
        asked += if keys[lane] == key { 1 } else { 0 };
    }
    if asked == 0 {
        return;
    }
    for channel in 0..channels {
        for lane in 0..LANES {
            let asked = keys[lane] == key;
            kept[channel][lane] = if asked { values[channel][lane] } else { kept[channel][lane] };
        }
    }
}

/// One level of one face: the mean of the probes, whose running form leaves equal ones as they
/// are.
#[inline(always)]
fn sample_key<S: Simd>(samples: &Samples<'_>, key: u32, out: &mut [F32s; 4]) {
    let Samples { texture, at, offset, probes, reference } = *samples;
    let (filter, face, number) = taps::parts(key);
    let level = &*texture.levels[face][number];
    let place = filter::Place { texture, filter, face, number, level, layer: &at.layer, reference };
    let most = match probes {
        Some(probes) => probes.most,
        None => 1,
    };
    let mut one = None;
    for probe in 0..most {
        let moved;
        let st = if probes.is_none() && offset == [0; 3] {
            at.filtered()
        } else {
            moved = moved_to(&place, at, offset, probe, probes);
            [&moved[0], &moved[1], &moved[2]]
        };
        let target = if probe == 0 { &mut *out } else { one.get_or_insert([F32s::ZERO; 4]) };
        filter::sample_level::<S>(&place, st, target);
        let (Some(probes), Some(one)) = (probes, &one) else { continue };
        let share = 1.0 / (probe + 1) as f32;
        for channel in 0..texture.format.channels() {
            for lane in 0..LANES {
                let mean = filter::lerp(out[channel][lane], one[channel][lane], share);
                let counts = (probe as f32) < probes.count[lane];
                out[channel][lane] = if counts { mean } else { out[channel][lane] };
            }
        }
    }
}

/// The coordinates of a probe, and the offset added.
#[inline(always)]
fn moved_to(
    place: &filter::Place<'_>,
    at: &Coordinates<'_>,
    offset: [i32; 3],
    probe: u32,
    probes: Option<&Probes>,
) -> [F32s; 3] {
    let shift = shift(place.texture, place.level, offset);
    let mut moved = [F32s::ZERO; 3];
    for axis in 0..place.texture.shape.axes() {
        let from = at.filtered()[axis];
        match probes {
            Some(Probes { count, step, .. }) => {
                for lane in 0..LANES {
                    let steps = probe as f32 - 0.5 * (count[lane] - 1.0);
                    moved[axis][lane] = from[lane] + (steps * step[axis][lane] + shift[axis]);
                }
            }
            None => {
                for lane in 0..LANES {
                    moved[axis][lane] = from[lane] + shift[axis];
                }
            }
        }
    }
    moved
}

/// An offset in texels of this level, in units of the coordinates.
#[inline(always)]
fn shift(texture: &Texture, level: &Level, offset: [i32; 3]) -> [f32; 3] {
    if offset == [0; 3] {
        return [0.0; 3];
    }
    let size = level.size();
    let mut shift = [0.0; 3];
    for axis in 0..texture.shape.axes() {
        let scale = if texture.shape == Shape::Rect { 1.0 } else { size[axis] as f32 };
        shift[axis] = offset[axis] as f32 / scale;
    }
    shift
}
