//! One level: the nearest texel, or the weighted mean of 2, 2×2 or 2×2×2 (GL 2.1, section 3.8.8).
//!
//! The mean is linear interpolations, first along s, then along t, then along r, each
//! `a + (b - a) · α` in this order: two equal texels give exactly themselves. Channels of bytes are
//! weighed as 0 to 255 and divided at last, which is one division for all texels.

use super::interpolate::{divide, lerp, mean};
use super::level_view::Place;
use super::recorder::Recorder;
use super::wrap::{Enclosing, Indices};
use super::{fast, fetch, seamless};
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s};
use crate::plan::Way;
use crate::sampler::{Filter, Seamless};
use crate::trace::SampleStep;

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
            (Way::Plain(class), Filter::Nearest) => fast::nearest::<S>(place, class, at, out),
            (Way::Plain(class), Filter::Linear) => fast::linear::<S>(place, class, at, out),
            (Way::Blocks(block), Filter::Linear) => {
                fast::blocks::linear::<S>(place, block, at, out)
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
            let mean = mean(place.texture.format, &corners, channel, [&alpha, &beta]);
            if slice == 0 {
                *out = mean;
            } else {
                for lane in 0..LANES {
                    out[lane] = lerp(out[lane], mean[lane], gamma[lane]);
                }
            }
        }
    }
    divide(place.texture.format, out);
}
