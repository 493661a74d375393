//! Stored channels to R, G, B, A (GL 2.1, section 3.8.13 and table 3.15; depth: section 3.8.14),
//! and the swizzle (EXT_texture_swizzle).

use crate::format::BaseFormat;
use crate::lanes::F32s;
use crate::sampler::{DepthMode, Swizzle};

/// Spreads the stored channels, which come first in `c`, over all four.
#[inline(always)]
pub fn expand(base: BaseFormat, depth: DepthMode, c: &mut [F32s; 4]) {
    const ZERO: F32s = F32s::ZERO;
    const ONE: F32s = F32s::splat(1.0);
    let as_stored = match base {
        BaseFormat::Depth => match depth {
            DepthMode::Luminance => BaseFormat::Luminance,
            DepthMode::Intensity => BaseFormat::Intensity,
            DepthMode::Alpha => BaseFormat::Alpha,
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
        BaseFormat::Luminance | BaseFormat::Depth => *c = [c[0], c[0], c[0], ONE],
        BaseFormat::LuminanceAlpha => *c = [c[0], c[0], c[0], c[1]],
        BaseFormat::Intensity => *c = [c[0]; 4],
        BaseFormat::Red => *c = [c[0], ZERO, ZERO, ONE],
        BaseFormat::Rg => *c = [c[0], c[1], ZERO, ONE],
        BaseFormat::Rgb => c[3] = ONE,
        BaseFormat::Rgba => {}
    }
}

/// Takes each component from where the swizzle says.
#[inline(always)]
pub fn swizzle(swizzle: [Swizzle; 4], c: &mut [F32s; 4]) {
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
            Swizzle::One => F32s::splat(1.0),
        };
    }
}
