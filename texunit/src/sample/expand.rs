//! Stored channels to R, G, B, A (GL 2.1, section 3.8.13 and table 3.15; depth: section 3.8.14),
//! and the swizzle (EXT_texture_swizzle).

use crate::format::{BaseFormat, Format};
use crate::lanes::F32s;
use crate::sampler::{DepthMode, Swizzle};

/// The 1 of a format's texels: integers are bits (EXT_texture_integer, section 3.8.X).
#[inline(always)]
fn one(format: Format) -> F32s {
    F32s::splat(if format.is_integer() { f32::from_bits(1) } else { 1.0 })
}

/// Spreads the stored channels, which come first in `c`, over all four.
#[inline(always)]
pub fn expand(format: Format, depth: DepthMode, c: &mut [F32s; 4]) {
    const ZERO: F32s = F32s::ZERO;
    let base = format.base();
    let one = one(format);
    let as_stored = match base {
        BaseFormat::Depth => match depth {
            DepthMode::Luminance => BaseFormat::Luminance,
            DepthMode::Intensity => BaseFormat::Intensity,
            DepthMode::Alpha => BaseFormat::Alpha,
            DepthMode::Red => BaseFormat::Red,
        },
        BaseFormat::Alpha
        | BaseFormat::Luminance
        | BaseFormat::LuminanceAlpha
        | BaseFormat::Intensity
        | BaseFormat::Red
        | BaseFormat::Rg
        | BaseFormat::Rgb
        | BaseFormat::Rgba => base,
    };
    match as_stored {
        BaseFormat::Alpha => *c = [ZERO, ZERO, ZERO, c[0]],
        BaseFormat::Luminance | BaseFormat::Depth => *c = [c[0], c[0], c[0], one],
        BaseFormat::LuminanceAlpha => *c = [c[0], c[0], c[0], c[1]],
        BaseFormat::Intensity => *c = [c[0]; 4],
        BaseFormat::Red => *c = [c[0], ZERO, ZERO, one],
        BaseFormat::Rg => *c = [c[0], c[1], ZERO, one],
        BaseFormat::Rgb => c[3] = one,
        BaseFormat::Rgba => {}
    }
}

/// Applies the swizzle.
#[inline(always)]
pub fn swizzle(format: Format, swizzle: [Swizzle; 4], c: &mut [F32s; 4]) {
    if swizzle == Swizzle::IDENTITY {
        return;
    }
    let from = *c;
    for (to, source) in c.iter_mut().zip(swizzle) {
        *to = match source {
            Swizzle::Red => from[0],
            Swizzle::Green => from[1],
            Swizzle::Blue => from[2],
            Swizzle::Alpha => from[3],
            Swizzle::Zero => F32s::ZERO,
            Swizzle::One => one(format),
        };
    }
}
