//! Linear interpolation: between two texels, of a 2×2 footprint, between two levels.

use crate::format::Format;
use crate::format::convert::over_255;
use crate::lanes::{F32s, LANES};

/// The weighted mean of a channel of four texels, in the order (0, 0), (1, 0), (0, 1), (1, 1). Byte channels are
/// scaled to 0 to 255.
#[inline(always)]
pub fn mean(
    format: Format,
    corners: &[[F32s; 4]; 4],
    channel: usize,
    [alpha, beta]: [&F32s; 2],
) -> F32s {
    let scale = if format.is_byte_channel(channel) { 255.0 } else { 1.0 };
    let mut out = F32s::ZERO;
    for lane in 0..LANES {
        let texel = |corner: usize| corners[corner][channel][lane] * scale;
        let lower = lerp(texel(0), texel(1), alpha[lane]);
        let upper = lerp(texel(2), texel(3), alpha[lane]);
        out[lane] = lerp(lower, upper, beta[lane]);
    }
    out
}

/// Divides the means of byte channels by 255.
#[inline(always)]
pub fn divide(format: Format, means: &mut [F32s; 4]) {
    for (channel, mean) in means.iter_mut().enumerate().take(format.channels()) {
        if format.is_byte_channel(channel) {
            for lane in 0..LANES {
                mean[lane] = over_255(mean[lane]);
            }
        }
    }
}

/// Mixes two levels. Inf and NaN of a second level without weight have no effect.
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
