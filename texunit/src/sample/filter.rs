//! One level: the nearest texel, or the weighted mean of 2×2 (GL 2.1, section 3.8.8).
//!
//! The mean is three linear interpolations, first along s, then along t, each `a + (b - a) · α` in
//! this order: two equal texels give exactly themselves.

use super::wrap::Indices;
use super::{compare, fetch, wrap};
use crate::format::convert::decode_channel;
use crate::image::Level;
use crate::lanes::{F32s, LANES, Simd, U32s};
use crate::plan::Texture;
use crate::sampler::Filter;

/// Samples one level in all 64 lanes. Only the stored channels of `out` are written.
#[inline(always)]
pub fn sample_level<S: Simd>(
    texture: &Texture,
    level: &Level,
    filter: Filter,
    st: [&F32s; 2],
    reference: &F32s,
    out: &mut [F32s; 4],
) {
    let [wrap_s, wrap_t] = texture.wrap;
    let u = wrap::texel_coordinate(wrap_s, st[0], level.width);
    let v = wrap::texel_coordinate(wrap_t, st[1], level.height);
    match filter {
        Filter::Nearest => {
            let x = wrap::nearest(wrap_s, &u, level.width);
            let y = wrap::nearest(wrap_t, &v, level.height);
            let words = fetch::words::<S>(level, &x.index, &y.index);
            for (channel, out) in out.iter_mut().enumerate().take(texture.format.channels()) {
                *out = texel::<S>(texture, filter, channel, &words, &x, &y, reference);
            }
        }
        Filter::Linear => {
            let ([x0, x1], alpha) = wrap::linear(wrap_s, &u, level.width);
            let ([y0, y1], beta) = wrap::linear(wrap_t, &v, level.height);
            let corners = [(&x0, &y0), (&x1, &y0), (&x0, &y1), (&x1, &y1)];
            let words = corners.map(|(x, y)| fetch::words::<S>(level, &x.index, &y.index));
            for (channel, out) in out.iter_mut().enumerate().take(texture.format.channels()) {
                let mut texels = [F32s::ZERO; 4];
                for corner in 0..4 {
                    let (x, y) = corners[corner];
                    texels[corner] =
                        texel::<S>(texture, filter, channel, &words[corner], x, y, reference);
                }
                for lane in 0..LANES {
                    let lower = lerp(texels[0][lane], texels[1][lane], alpha[lane]);
                    let upper = lerp(texels[2][lane], texels[3][lane], alpha[lane]);
                    out[lane] = lerp(lower, upper, beta[lane]);
                }
            }
        }
    }
}

/// `a` to `b`, exact where they are equal and where `t` is 0.
#[inline(always)]
pub fn lerp(a: f32, b: f32, t: f32) -> f32 {
    a + (b - a) * t
}

/// One channel of 64 texels: converted, the border mixed in, compared.
#[inline(always)]
fn texel<S: Simd>(
    texture: &Texture,
    filter: Filter,
    channel: usize,
    words: &U32s,
    x: &Indices,
    y: &Indices,
    reference: &F32s,
) -> F32s {
    let mut texels = decode_channel::<S>(texture.format, channel, words);
    if texture.reaches_border(filter) {
        fetch::mix_border(x, y, texture.border[channel], &mut texels);
    }
    if let Some(op) = texture.compare {
        compare::compare(op, reference, &mut texels);
    }
    texels
}
