//! One level: the nearest texel, or the weighted mean of 2, 2×2 or 2×2×2 (GL 2.1, section 3.8.8).
//!
//! The mean is linear interpolations, first along s, then along t, then along r, each
//! `a + (b - a) · α` in this order: two equal texels give exactly themselves.

use super::wrap::{Axis, Indices, enclosing};
use super::{compare, fetch, plain, seamless};
use crate::format::convert::decode_channel;
use crate::image::{Level, Shape};
use crate::lanes::{F32s, LANES, Simd, U32s};
use crate::plan::{Texture, Way};
use crate::sampler::{Filter, Seamless};

/// A level, and all that is the same for each of its texels.
pub struct Place<'a> {
    pub texture: &'a Texture,
    pub filter: Filter,
    pub face: usize,
    /// The level's number, from the base level.
    pub number: usize,
    pub level: &'a Level,
    /// The layer of each lane; 0 where there are none.
    pub layer: &'a U32s,
    /// What texels are compared with.
    pub reference: &'a F32s,
}

impl Place<'_> {
    #[inline(always)]
    pub fn axis(&self, axis: usize) -> Axis {
        let size = self.level.size()[axis];
        let scale = if self.texture.shape == Shape::Rect { 1.0 } else { size as f32 };
        Axis { wrap: self.texture.wrap[axis], size, border: self.level.border[axis], scale }
    }

    /// The slice that each lane reads where r is not filtered along.
    #[inline(always)]
    fn slice(&self) -> Indices {
        Indices { index: *self.layer, outside: U32s::ZERO }
    }
}

/// Samples one level in all 64 lanes. Only the stored channels of `out` are written.
#[inline(always)]
pub fn sample_level<S: Simd>(place: &Place<'_>, at: [&F32s; 3], out: &mut [F32s; 4]) {
    match (place.texture.way, place.filter) {
        (Way::Plain, Filter::Nearest) if !place.texture.reaches_border(Filter::Nearest) => {
            return plain::nearest::<S>(place, at, out);
        }
        (Way::Plain, Filter::Linear) if !place.texture.reaches_border(Filter::Linear) => {
            if plain::linear::<S>(place, at, out) {
                return;
            }
        }
        (Way::Plain | Way::General, Filter::Nearest | Filter::Linear) => {}
    }
    match place.filter {
        Filter::Nearest => nearest::<S>(place, at, out),
        Filter::Linear => linear::<S>(place, at, out),
    }
}

#[inline(always)]
fn nearest<S: Simd>(place: &Place<'_>, at: [&F32s; 3], out: &mut [F32s; 4]) {
    let axes = place.texture.shape.axes();
    let axis = place.axis(0);
    let x = axis.nearest(&axis.texel_coordinate(at[0]));
    let mut y = Indices { index: U32s::ZERO, outside: U32s::ZERO };
    let mut z = place.slice();
    if axes > 1 {
        let axis = place.axis(1);
        y = axis.nearest(&axis.texel_coordinate(at[1]));
    }
    if axes > 2 {
        let axis = place.axis(2);
        z = axis.nearest(&axis.texel_coordinate(at[2]));
    }
    let offsets = fetch::offsets(place.level, &x.index, &y.index, &z.index);
    let words = S::gather(&place.level.texels, &offsets);
    let outside = fetch::outside(&x, &y, &z);
    for (channel, out) in out.iter_mut().enumerate().take(place.texture.format.channels()) {
        *out = texel::<S>(place, channel, &words, &outside);
    }
}

#[inline(always)]
fn linear<S: Simd>(place: &Place<'_>, at: [&F32s; 3], out: &mut [F32s; 4]) {
    let axes = place.texture.shape.axes();
    let axis = place.axis(0);
    let (i, alpha) = enclosing(&axis.texel_coordinate(at[0]));
    let close = fetch::side_by_side(&i, axis.size);
    let xs = axis.pair(&i);
    let none = || Indices { index: U32s::ZERO, outside: U32s::ZERO };
    let (mut ys, mut beta) = ([none(), none()], F32s::ZERO);
    let (mut zs, mut gamma) = ([place.slice(), none()], F32s::ZERO);
    if axes > 1 {
        let axis = place.axis(1);
        let j;
        (j, beta) = enclosing(&axis.texel_coordinate(at[1]));
        let crosses = place.texture.seamless == Seamless::On
            && !(close && fetch::side_by_side(&j, axis.size));
        if crosses {
            return seamless::linear::<S>(place, [&i, &j], [&alpha, &beta], out);
        }
        ys = axis.pair(&j);
    }
    if axes > 2 {
        let axis = place.axis(2);
        let k;
        (k, gamma) = enclosing(&axis.texel_coordinate(at[2]));
        zs = axis.pair(&k);
    }
    let slices = if axes > 2 { 2 } else { 1 };
    for slice in 0..slices {
        let z = &zs[slice];
        let lower = row::<S>(place, &xs, close, &ys[0], z);
        let above;
        let upper = if axes > 1 {
            above = row::<S>(place, &xs, close, &ys[1], z);
            &above
        } else {
            &lower
        };
        let words = [&lower[0], &lower[1], &upper[0], &upper[1]];
        for (channel, out) in out.iter_mut().enumerate().take(place.texture.format.channels()) {
            let mut texels = [F32s::ZERO; 4];
            for corner in 0..4 {
                let outside = fetch::outside(&xs[corner % 2], &ys[corner / 2], z);
                texels[corner] = texel::<S>(place, channel, words[corner], &outside);
            }
            let mean = mean(&texels, &alpha, &beta);
            if slice == 0 {
                *out = mean;
            } else {
                for lane in 0..LANES {
                    out[lane] = lerp(out[lane], mean[lane], gamma[lane]);
                }
            }
        }
    }
}

/// The two texels of a row. Where they lie side by side in every lane, one gather takes both.
#[inline(always)]
fn row<S: Simd>(
    place: &Place<'_>,
    xs: &[Indices; 2],
    close: bool,
    y: &Indices,
    z: &Indices,
) -> [U32s; 2] {
    let lower = fetch::offsets(place.level, &xs[0].index, &y.index, &z.index);
    if close {
        return fetch::neighbours::<S>(place.level, &lower);
    }
    let upper = fetch::offsets(place.level, &xs[1].index, &y.index, &z.index);
    [S::gather(&place.level.texels, &lower), S::gather(&place.level.texels, &upper)]
}

/// The mean of four texels, in the order (0, 0), (1, 0), (0, 1), (1, 1).
#[inline(always)]
pub fn mean(texels: &[F32s; 4], alpha: &F32s, beta: &F32s) -> F32s {
    let mut out = F32s::ZERO;
    for lane in 0..LANES {
        let lower = lerp(texels[0][lane], texels[1][lane], alpha[lane]);
        let upper = lerp(texels[2][lane], texels[3][lane], alpha[lane]);
        out[lane] = lerp(lower, upper, beta[lane]);
    }
    out
}

/// `a` to `b`, exact where they are equal and where `t` is 0.
#[inline(always)]
pub fn lerp(a: f32, b: f32, t: f32) -> f32 {
    a + (b - a) * t
}

/// One channel of 64 texels: converted, the border mixed in, compared.
#[inline(always)]
pub fn texel<S: Simd>(place: &Place<'_>, channel: usize, words: &U32s, outside: &U32s) -> F32s {
    let texture = place.texture;
    let mut texels = decode_channel::<S>(texture.format, channel, words);
    if texture.reaches_border(place.filter) {
        fetch::mix_border(outside, texture.border[channel], &mut texels);
    }
    if let Some(op) = texture.compare {
        compare::compare(op, place.reference, &mut texels);
    }
    texels
}
