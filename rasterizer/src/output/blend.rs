//! Blending (GL 3.3, section 4.1.7), in `f32`. Where the attachment is fixed-point, colours are
//! clamped to what it can hold; the constant colour here, source and destination by the caller.

use crate::desc::{Blend, BlendEquation, BlendFactor};
use texunit::lanes::{F32s, LANES, math};

/// The least and largest number that an attachment can hold, where it is fixed-point
/// ([`texunit::format::Encoding::range`]).
type Range = Option<[f32; 2]>;

/// The second colour of fragments that have none.
pub const NO_SECOND: &[F32s; 4] = &[F32s::ZERO; 4];

/// The blended colour of 64 fragments, unclamped, of their first and second colour and the stored one. The usual ways
/// in one loop, the others factor by factor.
#[inline(always)]
pub fn blend(
    state: &Blend,
    [source, second]: [&[F32s; 4]; 2],
    destination: &[F32s; 4],
    range: Range,
) -> [F32s; 4] {
    use BlendFactor::{One, OneMinusSrcAlpha, SrcAlpha};
    let alike = state.src[0] == state.src[1] && state.dst[0] == state.dst[1];
    if alike && state.equation == [BlendEquation::Add; 2] {
        let colors = [source, destination];
        match (state.src[0], state.dst[0]) {
            (SrcAlpha, OneMinusSrcAlpha) => return each(colors, |s, d, a| s * a + d * (1.0 - a)),
            (One, OneMinusSrcAlpha) => return each(colors, |s, d, a| s + d * (1.0 - a)),
            (SrcAlpha, One) => return each(colors, |s, d, a| s * a + d),
            (One, One) => return each(colors, |s, d, _| s + d),
            (_, _) => {}
        }
    }
    by_factors(state, [source, second], destination, range)
}

/// `f` of source, destination and source alpha.
#[inline(always)]
fn each([source, destination]: [&[F32s; 4]; 2], f: impl Fn(f32, f32, f32) -> f32) -> [F32s; 4] {
    let mut out = [F32s::ZERO; 4];
    for (channel, out) in out.iter_mut().enumerate() {
        let (s, d, a) = (&source[channel], &destination[channel], &source[3]);
        for lane in 0..LANES {
            out[lane] = f(s[lane], d[lane], a[lane]);
        }
    }
    out
}

/// [`blend`], to which every special case is bit-equal.
#[inline(always)]
fn by_factors(
    state: &Blend,
    [source, second]: [&[F32s; 4]; 2],
    destination: &[F32s; 4],
    range: Range,
) -> [F32s; 4] {
    let mut constant = state.constant;
    if let Some([low, high]) = range {
        for c in &mut constant {
            *c = math::clamp(*c, low, high);
        }
    }
    let mut out = [F32s::ZERO; 4];
    for (channel, out) in out.iter_mut().enumerate() {
        let part = usize::from(channel == 3);
        let (s, d) = (&source[channel], &destination[channel]);
        let colors = Colors { source, second, destination, constant, channel };
        match state.equation[part] {
            BlendEquation::Min => {
                for lane in 0..LANES {
                    out[lane] = math::min(s[lane], d[lane]);
                }
            }
            BlendEquation::Max => {
                for lane in 0..LANES {
                    out[lane] = math::max(s[lane], d[lane]);
                }
            }
            equation @ (BlendEquation::Add
            | BlendEquation::Subtract
            | BlendEquation::ReverseSubtract) => {
                let mut sf = F32s::ZERO;
                let mut df = F32s::ZERO;
                colors.factor(state.src[part], &mut sf);
                colors.factor(state.dst[part], &mut df);
                for lane in 0..LANES {
                    let (a, b) = (s[lane] * sf[lane], d[lane] * df[lane]);
                    out[lane] = match equation {
                        BlendEquation::Add | BlendEquation::Min | BlendEquation::Max => a + b,
                        BlendEquation::Subtract => a - b,
                        BlendEquation::ReverseSubtract => b - a,
                    };
                }
            }
        }
    }
    out
}

/// What source and destination are multiplied by, and the blended colour, of one fragment: by the
/// same functions, for a trace.
pub fn factors(
    state: &Blend,
    sources: [[f32; 4]; 2],
    destination: [f32; 4],
    range: Range,
) -> [[f32; 4]; 3] {
    let [source, second] = &sources.map(|color| color.map(F32s::splat));
    let destination = &destination.map(F32s::splat);
    let constant = state.constant.map(|c| range.map_or(c, |[low, high]| math::clamp(c, low, high)));
    let by = |factors: [BlendFactor; 2]| {
        std::array::from_fn(|channel| {
            let mut out = F32s::ZERO;
            let colors = Colors { source, second, destination, constant, channel };
            colors.factor(factors[usize::from(channel == 3)], &mut out);
            out[0]
        })
    };
    let blended = blend(state, [source, second], destination, range);
    [by(state.src), by(state.dst), blended.map(|channel| channel[0])]
}

/// What the factors of a channel are made of.
struct Colors<'a> {
    source: &'a [F32s; 4],
    second: &'a [F32s; 4],
    destination: &'a [F32s; 4],
    constant: [f32; 4],
    channel: usize,
}

impl Colors<'_> {
    #[inline(always)]
    fn factor(&self, factor: BlendFactor, out: &mut F32s) {
        let Colors { source, second, destination, constant, channel } = self;
        match factor {
            BlendFactor::Zero => *out = F32s::ZERO,
            BlendFactor::One => *out = F32s::splat(1.0),
            BlendFactor::SrcColor => *out = source[*channel],
            BlendFactor::OneMinusSrcColor => one_minus(&source[*channel], out),
            BlendFactor::DstColor => *out = destination[*channel],
            BlendFactor::OneMinusDstColor => one_minus(&destination[*channel], out),
            BlendFactor::SrcAlpha => *out = source[3],
            BlendFactor::OneMinusSrcAlpha => one_minus(&source[3], out),
            BlendFactor::DstAlpha => *out = destination[3],
            BlendFactor::OneMinusDstAlpha => one_minus(&destination[3], out),
            BlendFactor::ConstantColor => *out = F32s::splat(constant[*channel]),
            BlendFactor::OneMinusConstantColor => *out = F32s::splat(1.0 - constant[*channel]),
            BlendFactor::ConstantAlpha => *out = F32s::splat(constant[3]),
            BlendFactor::OneMinusConstantAlpha => *out = F32s::splat(1.0 - constant[3]),
            BlendFactor::SrcAlphaSaturate => {
                if *channel == 3 {
                    *out = F32s::splat(1.0);
                } else {
                    for lane in 0..LANES {
                        out[lane] = math::min(source[3][lane], 1.0 - destination[3][lane]);
                    }
                }
            }
            BlendFactor::Src1Color => *out = second[*channel],
            BlendFactor::OneMinusSrc1Color => one_minus(&second[*channel], out),
            BlendFactor::Src1Alpha => *out = second[3],
            BlendFactor::OneMinusSrc1Alpha => one_minus(&second[3], out),
        }
    }
}

#[inline(always)]
fn one_minus(of: &F32s, out: &mut F32s) {
    for lane in 0..LANES {
        out[lane] = 1.0 - of[lane];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blending_in_one_loop_is_blending_factor_by_factor() {
        use BlendFactor::{One, OneMinusSrcAlpha, SrcAlpha};
        let numbers = |seed: u32| {
            F32s::from_fn(|lane| match lane {
                0 => f32::INFINITY,
                1 => -0.0,
                _ => ((lane as u32 + seed).wrapping_mul(2_654_435_761) >> 8) as f32 / 4e6 - 2.0,
            })
        };
        for round in 0..100 {
            let source = [0, 1, 2, 3].map(|channel| numbers(round * 64 + channel));
            let destination = [4, 5, 6, 7].map(|channel| numbers(round * 192 + channel));
            for src in [One, SrcAlpha] {
                for dst in [One, OneMinusSrcAlpha] {
                    let equation = [BlendEquation::Add; 2];
                    let state =
                        Blend { equation, src: [src; 2], dst: [dst; 2], constant: [0.0; 4] };
                    let got = blend(&state, [&source, NO_SECOND], &destination, None);
                    let want = by_factors(&state, [&source, NO_SECOND], &destination, None);
                    for (got, want) in got.iter().zip(&want) {
                        for lane in 0..LANES {
                            let [got, want] = [got[lane], want[lane]];
                            let same = got.to_bits() == want.to_bits();
                            assert!(same || got.is_nan() && want.is_nan(), "{src:?} {dst:?}");
                        }
                    }
                }
            }
        }
    }
}
