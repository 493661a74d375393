//! One level: the nearest texel, or the weighted mean of 2×2 (GL 2.1, section 3.8.8).
//!
//! The mean is three linear interpolations, first along s, then along t, each `a + (b - a) · α` in
//! this order: two equal texels give exactly themselves.

use super::wrap::Indices;
use super::{compare, fetch, wrap};
use crate::format::convert::{byte_channel, decode_channel};
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
            // No closures here: what is not inlined by force misses the instruction set.
            let corners = [(&x0, &y0), (&x1, &y0), (&x0, &y1), (&x1, &y1)];
            let words = [
                fetch::words::<S>(level, &x0.index, &y0.index),
                fetch::words::<S>(level, &x1.index, &y0.index),
                fetch::words::<S>(level, &x0.index, &y1.index),
                fetch::words::<S>(level, &x1.index, &y1.index),
            ];
            for (channel, out) in out.iter_mut().enumerate().take(texture.format.channels()) {
                if texture.is_plain_byte(filter, channel) {
                    *out = mean_of_bytes(channel, &words, &alpha, &beta);
                    continue;
                }
                let mut texels = [F32s::ZERO; 4];
                for corner in 0..4 {
                    let (x, y) = corners[corner];
                    texels[corner] =
                        texel::<S>(texture, filter, channel, &words[corner], x, y, reference);
                }
                *out = mean(&texels, &alpha, &beta);
            }
        }
    }
}

/// The mean of four texels, in the order (0, 0), (1, 0), (0, 1), (1, 1).
#[inline(always)]
fn mean(texels: &[F32s; 4], alpha: &F32s, beta: &F32s) -> F32s {
    let mut out = F32s::ZERO;
    for lane in 0..LANES {
        let lower = lerp(texels[0][lane], texels[1][lane], alpha[lane]);
        let upper = lerp(texels[2][lane], texels[3][lane], alpha[lane]);
        out[lane] = lerp(lower, upper, beta[lane]);
    }
    out
}

/// [`mean`] of byte channels that need nothing but conversion, which stays in registers.
#[inline(always)]
fn mean_of_bytes(channel: usize, words: &[U32s; 4], alpha: &F32s, beta: &F32s) -> F32s {
    let mut out = F32s::ZERO;
    for lane in 0..LANES {
        let a = byte_channel(words[0][lane], channel);
        let b = byte_channel(words[1][lane], channel);
        let c = byte_channel(words[2][lane], channel);
        let d = byte_channel(words[3][lane], channel);
        out[lane] = lerp(lerp(a, b, alpha[lane]), lerp(c, d, alpha[lane]), beta[lane]);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format::Format;
    use crate::lanes::{Isa, Kernel};

    /// Both ways to the mean of a byte channel.
    struct BothMeans(usize, [U32s; 4], F32s, F32s);
    impl Kernel for BothMeans {
        type Output = [F32s; 2];
        #[inline(always)]
        fn run<S: Simd>(self) -> [F32s; 2] {
            let Self(channel, words, alpha, beta) = self;
            let mut texels = [F32s::ZERO; 4];
            for corner in 0..4 {
                texels[corner] = decode_channel::<S>(Format::Rgba8, channel, &words[corner]);
            }
            [mean(&texels, &alpha, &beta), mean_of_bytes(channel, &words, &alpha, &beta)]
        }
    }

    #[test]
    fn the_mean_of_bytes_is_the_mean() {
        for round in 0..200_u32 {
            let noise = |lane: usize, salt: u32| {
                let mixed = (lane as u32 + 64 * round).wrapping_mul(0x9E37_79B9) ^ salt;
                mixed.wrapping_mul(0x85EB_CA6B) ^ mixed >> 15
            };
            let words = [1, 2, 3, 4].map(|salt| U32s::from_fn(|lane| noise(lane, salt)));
            let weight =
                |salt| F32s::from_fn(|lane| (noise(lane, salt) >> 8) as f32 / 16_777_216.0);
            for isa in Isa::available() {
                for channel in 0..4 {
                    let [slow, fast] = isa.run(BothMeans(channel, words, weight(5), weight(6)));
                    assert_eq!(slow.as_u32(), fast.as_u32(), "{}", isa.name());
                }
            }
        }
    }
}
