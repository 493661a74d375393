//! From a coordinate to texel indices along one axis (GL 2.1, section 3.8.7, and the addressing of
//! section 3.8.8).
//!
//! Every result is a legal index: what lies on the border has the nearest index and a mask.
//! Defined beyond the specification: NaN counts as 0, and so does ±inf where coordinates repeat;
//! elsewhere ±inf is the end of the range.

use crate::lanes::math::{clamp, floor, fract, max, to_i32};
use crate::lanes::{F32s, LANES, U32s};
use crate::sampler::Wrap;

/// Indices along one axis and whether they lie outside, on the border (a mask).
pub struct Indices {
    /// 0 to size - 1.
    pub index: U32s,
    /// `!0` on the border, else 0.
    pub border: U32s,
}

/// `u`, the wrapped coordinate in texels: within [0, size], half a texel more for the border.
#[inline(always)]
pub fn texel_coordinate(wrap: Wrap, s: &F32s, size: u32) -> F32s {
    let n = size as f32;
    let mut u = F32s::ZERO;
    match wrap {
        Wrap::Repeat => {
            for lane in 0..LANES {
                u[lane] = max(fract(s[lane]), 0.0) * n;
            }
        }
        Wrap::Clamp => {
            for lane in 0..LANES {
                u[lane] = clamp(s[lane] * n, 0.0, n);
            }
        }
        Wrap::ClampToEdge => {
            for lane in 0..LANES {
                u[lane] = clamp(s[lane] * n, 0.5, n - 0.5);
            }
        }
        Wrap::ClampToBorder => {
            for lane in 0..LANES {
                let x = s[lane] * n;
                let number = if x.is_nan() { 0.0 } else { x };
                u[lane] = clamp(number, -0.5, n + 0.5);
            }
        }
        Wrap::MirroredRepeat => {
            for lane in 0..LANES {
                let whole = floor(s[lane]);
                let part = max(s[lane] - whole, 0.0);
                let half = whole * 0.5;
                let odd = floor(half) < half;
                let mirrored = if odd { 1.0 - part } else { part };
                u[lane] = clamp(mirrored * n, 0.5, n - 0.5);
            }
        }
    }
    u
}

/// The texel that `u` lies in; `u = size` lies in the last.
#[inline(always)]
pub fn nearest(wrap: Wrap, u: &F32s, size: u32) -> Indices {
    let last = size as i32 - 1;
    let mut out = Indices { index: U32s::ZERO, border: U32s::ZERO };
    for lane in 0..LANES {
        let i = floor_i32(u[lane]);
        let low = if i < 0 { 0 } else { i };
        out.index[lane] = if low > last { last } else { low } as u32;
    }
    if wrap == Wrap::ClampToBorder {
        for lane in 0..LANES {
            let i = floor_i32(u[lane]);
            out.border[lane] = mask((i < 0) | (i > last));
        }
    }
    out
}

/// The two texels whose centres enclose `u`, and the weight of the second in [0, 1).
#[inline(always)]
pub fn linear(wrap: Wrap, u: &F32s, size: u32) -> ([Indices; 2], F32s) {
    let last = size as i32 - 1;
    let mut lower = Indices { index: U32s::ZERO, border: U32s::ZERO };
    let mut upper = Indices { index: U32s::ZERO, border: U32s::ZERO };
    let mut alpha = F32s::ZERO;
    match wrap {
        Wrap::Repeat => {
            for lane in 0..LANES {
                let x = u[lane] - 0.5;
                let i = floor_i32(x);
                alpha[lane] = x - i as f32;
                lower.index[lane] = if i < 0 { last } else { i } as u32;
                upper.index[lane] = if i < last { i + 1 } else { 0 } as u32;
            }
        }
        Wrap::Clamp | Wrap::ClampToEdge | Wrap::ClampToBorder | Wrap::MirroredRepeat => {
            for lane in 0..LANES {
                let x = u[lane] - 0.5;
                let i = floor_i32(x);
                alpha[lane] = x - i as f32;
                let low = if i < 0 { 0 } else { i };
                lower.index[lane] = if low > last { last } else { low } as u32;
                upper.index[lane] = if i < last { i + 1 } else { last } as u32;
                lower.border[lane] = mask((i < 0) | (i > last));
                upper.border[lane] = mask(i >= last);
            }
        }
    }
    ([lower, upper], alpha)
}

/// The largest integer not above `x`, which is far inside the range of `i32`.
#[inline(always)]
fn floor_i32(x: f32) -> i32 {
    let whole = to_i32(x);
    if whole as f32 > x { whole - 1 } else { whole }
}

#[inline(always)]
fn mask(on: bool) -> u32 {
    if on { !0 } else { 0 }
}
