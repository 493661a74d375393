//! Linear interpolation: between two texels, of a 2×2 footprint, between two levels.

use crate::format::Format;
use crate::format::convert::over_255;
use crate::lanes::math::max;
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
    let is_byte = format.is_byte_channel(channel);
    let scale = if is_byte { 255.0 } else { 1.0 };
    let mut out = F32s::ZERO;
    for lane in 0..LANES {
        let texel = |corner: usize| corners[corner][channel][lane] * scale;
        let lower = lerp(texel(0), texel(1), alpha[lane]);
        let upper = lerp(texel(2), texel(3), alpha[lane]);
        out[lane] = lerp(lower, upper, beta[lane]);
    }
    if !is_byte && has_nan(&out) {
        for lane in 0..LANES {
            let texels = [0, 1, 2, 3].map(|corner: usize| corners[corner][channel][lane]);
            out[lane] = bilinear_of_any(texels, alpha[lane], beta[lane]);
        }
    }
    out
}

/// Whether a lane is NaN: then [`lerp`] may have multiplied an infinite number by 0, or subtracted
/// it from itself, and the lanes are computed again by [`lerp_of_any`].
#[inline(always)]
pub fn has_nan(values: &F32s) -> bool {
    let mut any = false;
    for lane in 0..LANES {
        any |= values[lane].is_nan();
    }
    any
}

/// The weighted mean of four texels that may be infinite or NaN.
#[inline(always)]
pub fn bilinear_of_any([a, b, c, d]: [f32; 4], alpha: f32, beta: f32) -> f32 {
    lerp_of_any(lerp_of_any(a, b, alpha), lerp_of_any(c, d, alpha), beta)
}

/// [`lerp`] where that is a number. Else what has no weight takes no part, and an infinite number
/// with a finite one is infinite.
#[inline(always)]
pub fn lerp_of_any(a: f32, b: f32, t: f32) -> f32 {
    let mean = lerp(a, b, t);
    match t {
        _ if !mean.is_nan() => mean,
        0.0 => a,
        1.0 => b,
        t => a * (1.0 - t) + b * t,
    }
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

/// Mixes two levels. Inf and NaN of a second level without weight have no effect. Without any weight, as of integer texels,
/// which are never mixed, bits stay: a compiler may make a sum of a selection, and a sum makes a signalling NaN quiet.
#[inline(always)]
pub fn mix(first: &F32s, second: &F32s, weight: &F32s, out: &mut F32s) {
    if !has_weight(weight) {
        *out = *first;
        return;
    }
    for lane in 0..LANES {
        let mean = lerp(first[lane], second[lane], weight[lane]);
        out[lane] = if weight[lane] > 0.0 { mean } else { first[lane] };
    }
    if has_nan(out) {
        for lane in 0..LANES {
            out[lane] = lerp_of_any(first[lane], second[lane], max(weight[lane], 0.0));
        }
    }
}

#[inline(always)]
fn has_weight(weight: &F32s) -> bool {
    let mut any = false;
    for lane in 0..LANES {
        any |= weight[lane] > 0.0;
    }
    any
}

/// `a` to `b`, exact where they are equal and where `t` is 0.
#[inline(always)]
pub fn lerp(a: f32, b: f32, t: f32) -> f32 {
    a + (b - a) * t
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_no_weight_takes_no_part() {
        const INF: f32 = f32::INFINITY;
        let table = [
            ([0.5, INF], 0.0, 0.5),
            ([INF, 0.5], 1.0, 0.5),
            ([0.5, f32::NAN], 0.0, 0.5),
            ([INF, 0.5], 0.25, INF),
            ([0.5, -INF], 0.25, -INF),
            ([INF, INF], 0.25, INF),
            ([1.0, 3.0], 0.25, 1.5),
        ];
        for ([a, b], t, expected) in table {
            assert_eq!(lerp_of_any(a, b, t), expected, "{a}, {b}, {t}");
        }
        assert!(lerp_of_any(INF, -INF, 0.5).is_nan());
        assert!(lerp_of_any(0.5, f32::NAN, 0.5).is_nan());
    }

    #[test]
    fn bits_that_are_not_mixed_stay() {
        // A signalling NaN, -0 and infinity: as integers, numbers like others.
        let bits = [0x7F80_0001, 0xFFB8_1234, 0x8000_0000, 0x7F80_0000, 1];
        let mut first = F32s::ZERO;
        for lane in 0..LANES {
            first[lane] = f32::from_bits(bits[lane % bits.len()]);
        }
        let mut out = F32s::ZERO;
        mix(&first, &first, &F32s::ZERO, &mut out);
        for lane in 0..LANES {
            assert_eq!(out[lane].to_bits(), first[lane].to_bits(), "lane {lane}");
        }
    }
}
