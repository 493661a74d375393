//! Channels of texels from their words, by texel class.
//!
//! Each channel has its own loop, in which the shift is a constant: in a loop over channels it would be a variable shift
//! in every lane.

use crate::format::Format;
use crate::format::convert::{byte_channel, byte_of, over_255};
use crate::format::small_float::decode_half;
use crate::format::srgb;
use crate::lanes::{F32s, LANES, Simd, U32s};
use crate::plan::{Alpha, TexelClass};
use crate::sample::interpolate::{bilinear_of_any, has_nan, lerp};

/// The channels that lie in word number `word` of 64 texels.
#[inline(always)]
pub fn channels_of_texel<S: Simd>(
    class: TexelClass,
    channels: usize,
    word: usize,
    words: &U32s,
    out: &mut [F32s; 4],
) {
    let [r, g, b, a] = out;
    match class {
        TexelClass::Bytes => {
            map_words(words, r, byte::<0>);
            if channels > 1 {
                map_words(words, g, byte::<1>);
            }
            if channels > 2 {
                map_words(words, b, byte::<2>);
            }
            if channels > 3 {
                map_words(words, a, byte::<3>);
            }
        }
        TexelClass::Srgb => {
            *r = S::lookup(&srgb::DECODE, words, 0);
            if channels == 2 {
                map_words(words, g, byte::<1>);
            }
            if channels > 2 {
                *g = S::lookup(&srgb::DECODE, words, 8);
                *b = S::lookup(&srgb::DECODE, words, 16);
            }
            if channels > 3 {
                map_words(words, a, byte::<3>);
            }
        }
        TexelClass::Halves => {
            let (first, second) = if word == 0 { (r, g) } else { (b, a) };
            map_words(words, first, half::<0>);
            if channels > 2 * word + 1 {
                map_words(words, second, half::<1>);
            }
        }
        TexelClass::Floats => out[word] = *words.as_f32(),
        TexelClass::Depth { shift, largest } => {
            if word == 0 {
                map_words(words, r, |word| depth(word, shift, largest));
            }
        }
    }
}

/// One channel of 64 texels whose channels are bytes over 255.
#[inline(always)]
pub fn bytes_of_texel(channel: usize, words: &U32s, out: &mut F32s) {
    match channel {
        0 => map_words(words, out, byte::<0>),
        1 => map_words(words, out, byte::<1>),
        2 => map_words(words, out, byte::<2>),
        _ => map_words(words, out, byte::<3>),
    }
}

/// One channel of 64 texels of one word, of a class that colours have.
#[inline(always)]
pub fn channel_of_texel<S: Simd>(
    (class, format): (TexelClass, Format),
    channel: usize,
    words: &U32s,
    out: &mut F32s,
) {
    match class {
        TexelClass::Srgb if format.is_srgb_channel(channel) => {
            *out = S::lookup(&srgb::DECODE, words, 8 * channel as u32);
        }
        TexelClass::Bytes | TexelClass::Srgb => bytes_of_texel(channel, words, out),
        TexelClass::Halves => match channel {
            0 => map_words(words, out, half::<0>),
            _ => map_words(words, out, half::<1>),
        },
        TexelClass::Floats | TexelClass::Depth { .. } => *out = *words.as_f32(),
    }
}

/// The depths of 64 texels of one word, of a class that depths have.
#[inline(always)]
pub fn depths_of_texel(class: TexelClass, words: &U32s, out: &mut F32s) {
    match class {
        TexelClass::Depth { shift, largest } => {
            map_words(words, out, |word| depth(word, shift, largest));
        }
        TexelClass::Floats | TexelClass::Bytes | TexelClass::Srgb | TexelClass::Halves => {
            *out = *words.as_f32();
        }
    }
}

/// The means of the channels that lie in word number `word` of 2×2 texels, in the order (0, 0),
/// (1, 0), (0, 1), (1, 1).
#[inline(always)]
pub fn channels_of_quad<S: Simd>(
    class: TexelClass,
    (channels, alpha): (usize, Alpha),
    word: usize,
    words: [&U32s; 4],
    weights: [&F32s; 2],
    out: &mut [F32s; 4],
) {
    let [r, g, b, a] = out;
    match class {
        TexelClass::Bytes => {
            mean_of_bytes::<0>(words, weights, r);
            if channels > 1 {
                mean_of_bytes::<1>(words, weights, g);
            }
            if channels > 2 {
                mean_of_bytes::<2>(words, weights, b);
            }
            if channels > 3 {
                mean_of_alpha(words, weights, alpha, a);
            }
        }
        TexelClass::Srgb => {
            mean_of_srgb::<S>(words, weights, r, 0);
            if channels == 2 {
                mean_of_bytes::<1>(words, weights, g);
            }
            if channels > 2 {
                mean_of_srgb::<S>(words, weights, g, 8);
                mean_of_srgb::<S>(words, weights, b, 16);
            }
            if channels > 3 {
                mean_of_alpha(words, weights, alpha, a);
            }
        }
        TexelClass::Halves => {
            let (first, second) = if word == 0 { (r, g) } else { (b, a) };
            mean_of_any(words, weights, first, half::<0>);
            if channels > 2 * word + 1 {
                mean_of_any(words, weights, second, half::<1>);
            }
        }
        TexelClass::Floats => mean_of_any(words, weights, &mut out[word], f32::from_bits),
        TexelClass::Depth { shift, largest } => {
            if word == 0 {
                mean(words, weights, r, |word| depth(word, shift, largest));
            }
        }
    }
}

/// The mean of alpha, unless it is known.
#[inline(always)]
fn mean_of_alpha(words: [&U32s; 4], weights: [&F32s; 2], alpha: Alpha, out: &mut F32s) {
    match alpha {
        Alpha::Stored => mean_of_bytes::<3>(words, weights, out),
        Alpha::One => *out = F32s::splat(1.0),
    }
}

/// As in the general filter: the mean of 0 to 255, then divided by 255.
#[inline(always)]
fn mean_of_bytes<const CHANNEL: usize>(words: [&U32s; 4], weights: [&F32s; 2], out: &mut F32s) {
    mean(words, weights, out, |word| byte_of(word, CHANNEL));
    for lane in 0..LANES {
        out[lane] = over_255(out[lane]);
    }
}

#[inline(always)]
fn mean_of_srgb<S: Simd>(words: [&U32s; 4], weights: [&F32s; 2], out: &mut F32s, shift: u32) {
    let a = S::lookup(&srgb::DECODE, words[0], shift);
    let b = S::lookup(&srgb::DECODE, words[1], shift);
    let c = S::lookup(&srgb::DECODE, words[2], shift);
    let d = S::lookup(&srgb::DECODE, words[3], shift);
    let texels = [a.as_u32(), b.as_u32(), c.as_u32(), d.as_u32()];
    mean(texels, weights, out, f32::from_bits);
}

// Functions, since a closure that is called more than once may not be inlined into the kernel.

#[inline(always)]
fn byte<const CHANNEL: usize>(word: u32) -> f32 {
    byte_channel(word, CHANNEL)
}

#[inline(always)]
fn depth(word: u32, shift: u32, largest: u32) -> f32 {
    (word >> shift & largest) as i32 as f32 / largest as i32 as f32
}

#[inline(always)]
fn half<const UPPER: u32>(word: u32) -> f32 {
    decode_half(word >> (16 * UPPER) & 0xFFFF)
}

#[inline(always)]
fn map_words(words: &U32s, out: &mut F32s, channel: impl Fn(u32) -> f32) {
    for lane in 0..LANES {
        out[lane] = channel(words[lane]);
    }
}

#[inline(always)]
fn mean(
    words: [&U32s; 4],
    [alpha, beta]: [&F32s; 2],
    out: &mut F32s,
    channel: impl Fn(u32) -> f32,
) {
    for lane in 0..LANES {
        let (a, b) = (channel(words[0][lane]), channel(words[1][lane]));
        let (c, d) = (channel(words[2][lane]), channel(words[3][lane]));
        let (lower, upper) = (lerp(a, b, alpha[lane]), lerp(c, d, alpha[lane]));
        out[lane] = lerp(lower, upper, beta[lane]);
    }
}

/// As [`mean`], of texels that may be infinite or NaN.
#[inline(always)]
fn mean_of_any(
    words: [&U32s; 4],
    [alpha, beta]: [&F32s; 2],
    out: &mut F32s,
    channel: impl Fn(u32) -> f32 + Copy,
) {
    mean(words, [alpha, beta], out, channel);
    if has_nan(out) {
        for lane in 0..LANES {
            let texels = words.map(|words| channel(words[lane]));
            out[lane] = bilinear_of_any(texels, alpha[lane], beta[lane]);
        }
    }
}
