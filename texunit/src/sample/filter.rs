//! One level: the nearest texel, or the weighted mean of 2, 2×2 or 2×2×2 (GL 2.1, section 3.8.8).
//!
//! The mean is linear interpolations, first along s, then along t, then along r, each
//! `a + (b - a) · α` in this order: two equal texels give exactly themselves. Channels of bytes are
//! weighed as 0 to 255 and divided at last, which is one division for all texels.

use super::record::Recorder;
use super::wrap::{Axis, Enclosing, Indices};
use super::{fetch, plain, seamless};
use crate::format::convert::over_255;
use crate::image::{FACES, Level, Shape};
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s};
use crate::plan::{Texture, Way};
use crate::sampler::{Filter, Seamless};
use crate::trace::SampleStep;

/// A level, and all that is the same for each of its texels.
#[derive(Clone, Copy)]
pub struct Place<'a> {
    pub texture: &'a Texture,
    pub filter: Filter,
    pub face: usize,
    /// The level's number, from the base level.
    pub number: usize,
    pub level: &'a Level,
    /// The layer of each lane (of an array of cubes: which cube); 0 where there are none.
    pub layer: &'a U32s,
    /// What texels are compared with.
    pub reference: &'a F32s,
}

impl Place<'_> {
    #[inline(always)]
    pub fn axis(&self, axis: usize) -> Axis {
        let size = [self.level.width, self.level.height, self.level.depth][axis];
        let scale = self.texture.shape.scale(size);
        Axis { wrap: self.texture.wrap[axis], size, border: self.level.border[axis], scale }
    }

    /// The slice that each lane reads where r is not filtered along.
    #[inline(always)]
    pub fn slice(&self) -> Indices {
        let mut slice = Indices { index: *self.layer, outside: U32s::ZERO };
        if self.texture.shape == Shape::CubeArray {
            for lane in 0..LANES {
                slice.index[lane] = slice.index[lane] * FACES as u32 + self.face as u32;
            }
        }
        slice
    }
}

/// Samples one level in all 64 lanes. Only the stored channels of `out` are written.
#[inline(always)]
pub fn sample_level<S: Simd>(
    place: &Place<'_>,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let done = match (place.texture.way, place.filter) {
        (Way::Plain(_), Filter::Nearest | Filter::Linear) | (Way::Blocks(_), Filter::Linear) => {
            S::apart(Short { place, at, out: &mut *out })
        }
        // A fetch of one texel is short in any case.
        (Way::Blocks(_), Filter::Nearest) => false,
        (Way::General | Way::Compared(_), Filter::Nearest | Filter::Linear) => false,
    };
    match place.filter {
        _ if done => {}
        Filter::Nearest => nearest::<S>(place, at, out, recorder),
        Filter::Linear => linear::<S>(place, at, out, recorder),
    }
}

/// The short ways, as far as they lead.
struct Short<'a> {
    place: &'a Place<'a>,
    at: [&'a F32s; 3],
    out: &'a mut [F32s; 4],
}

impl Kernel for Short<'_> {
    type Output = bool;
    #[inline(always)]
    fn run<S: Simd>(self) -> bool {
        let Self { place, at, out } = self;
        match (place.texture.way, place.filter) {
            (Way::Plain(class), Filter::Nearest) => plain::nearest::<S>(place, class, at, out),
            (Way::Plain(class), Filter::Linear) => plain::linear::<S>(place, class, at, out),
            (Way::Blocks(block), Filter::Linear) => {
                plain::blocks::linear::<S>(place, block, at, out)
            }
            (Way::Blocks(_), Filter::Nearest) => false,
            (Way::General | Way::Compared(_), Filter::Nearest | Filter::Linear) => false,
        }
    }
}

#[inline(always)]
fn nearest<S: Simd>(
    place: &Place<'_>,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let axes = place.texture.shape.axes();
    recorder.note(|lane| SampleStep::Nearest { u: texel_coordinates::<S>(place, at, lane) });
    let x = place.axis(0).nearest_to::<S>(at[0]);
    let mut y = Indices { index: U32s::ZERO, outside: U32s::ZERO };
    let mut z = place.slice();
    if axes > 1 {
        y = place.axis(1).nearest_to::<S>(at[1]);
    }
    if axes > 2 {
        z = place.axis(2).nearest_to::<S>(at[2]);
    }
    fetch::texels::<S>(place, [&x, &y, &z], out, recorder);
}

/// `u, v, w` of a lane, for a trace.
#[inline(always)]
fn texel_coordinates<S: Simd>(place: &Place<'_>, at: [&F32s; 3], lane: usize) -> [f32; 3] {
    let axes = place.texture.shape.axes();
    let mut u = [0.0; 3];
    for (axis, u) in u.iter_mut().enumerate().take(axes) {
        *u = place.axis(axis).texel_coordinate_apart::<S>(at[axis])[lane];
    }
    u
}

#[inline(always)]
fn linear<S: Simd>(
    place: &Place<'_>,
    at: [&F32s; 3],
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let axes = place.texture.shape.axes();
    let axis = place.axis(0);
    let Enclosing { lower: i, weight: alpha, texels: xs } = axis.enclosing::<S>(at[0]);
    let close = fetch::side_by_side::<S>(&i, axis.size);
    let none = || Indices { index: U32s::ZERO, outside: U32s::ZERO };
    let (mut ys, mut beta) = ([none(), none()], F32s::ZERO);
    let (mut zs, mut gamma) = ([place.slice(), none()], F32s::ZERO);
    if axes > 1 {
        let axis = place.axis(1);
        let Enclosing { lower: j, weight, texels } = axis.enclosing::<S>(at[1]);
        beta = weight;
        let crosses = place.texture.seamless == Seamless::On
            && !(close && fetch::side_by_side::<S>(&j, axis.size));
        if crosses {
            recorder.note(|lane| SampleStep::Linear {
                u: texel_coordinates::<S>(place, at, lane),
                weights: [alpha[lane], beta[lane], 0.0],
                axes,
            });
            return seamless::linear::<S>(place, [&i, &j], [&alpha, &beta], out, recorder);
        }
        ys = texels;
    }
    if axes > 2 {
        Enclosing { weight: gamma, texels: zs, .. } = place.axis(2).enclosing::<S>(at[2]);
    }
    recorder.note(|lane| SampleStep::Linear {
        u: texel_coordinates::<S>(place, at, lane),
        weights: [alpha[lane], beta[lane], gamma[lane]],
        axes,
    });
    let slices = if axes > 2 { 2 } else { 1 };
    let mut corners = [[F32s::ZERO; 4]; 4];
    for (slice, z) in zs.iter().enumerate().take(slices) {
        for row in 0..axes.min(2) {
            let y = &ys[row];
            let [left, right] = &mut corners[2 * row..2 * row + 2] else { continue };
            if close && place.level.format.words() == 1 && place.level.format.block().is_none() {
                fetch::row::<S>(place, &xs, y, z, [left, right], recorder);
            } else {
                fetch::texels::<S>(place, [&xs[0], y, z], left, recorder);
                fetch::texels::<S>(place, [&xs[1], y, z], right, recorder);
            }
        }
        for (channel, out) in out.iter_mut().enumerate().take(place.texture.format.channels()) {
            let mean = mean(place, &corners, channel, [&alpha, &beta]);
            if slice == 0 {
                *out = mean;
            } else {
                for lane in 0..LANES {
                    out[lane] = lerp(out[lane], mean[lane], gamma[lane]);
                }
            }
        }
    }
    divide(place, out);
}

/// The mean of a channel of four texels, in the order (0, 0), (1, 0), (0, 1), (1, 1); of a byte, times
/// 255.
#[inline(always)]
pub fn mean(
    place: &Place<'_>,
    corners: &[[F32s; 4]; 4],
    channel: usize,
    [alpha, beta]: [&F32s; 2],
) -> F32s {
    let scale = if place.texture.format.is_byte_channel(channel) { 255.0 } else { 1.0 };
    let mut out = F32s::ZERO;
    for lane in 0..LANES {
        let texel = |corner: usize| corners[corner][channel][lane] * scale;
        let lower = lerp(texel(0), texel(1), alpha[lane]);
        let upper = lerp(texel(2), texel(3), alpha[lane]);
        out[lane] = lerp(lower, upper, beta[lane]);
    }
    out
}

/// What [`mean`] gave of bytes, over 255.
#[inline(always)]
pub fn divide(place: &Place<'_>, means: &mut [F32s; 4]) {
    let format = place.texture.format;
    for (channel, mean) in means.iter_mut().enumerate().take(format.channels()) {
        if format.is_byte_channel(channel) {
            for lane in 0..LANES {
                mean[lane] = over_255(mean[lane]);
            }
        }
    }
}

/// Two levels in proportion, if the second has any weight at all: its inf and NaN do not matter
/// otherwise.
#[inline(always)]
pub fn mix(first: &F32s, second: &F32s, weight: &F32s, out: &mut F32s) {
    for lane in 0..LANES {
        let mean = lerp(first[lane], second[lane], weight[lane]);
        out[lane] = if weight[lane] > 0.0 { mean } else { first[lane] };
    }
}

/// `a` to `b`, exact where they are equal and where `t` is 0.
#[inline(always)]
pub fn lerp(a: f32, b: f32, t: f32) -> f32 {
    a + (b - a) * t
}
