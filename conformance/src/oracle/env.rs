//! Texture environments (section 3.8.13).

use crate::mutation::{Mutation, Variant};

/// `GL_TEXTURE_ENV_MODE`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// `GL_REPLACE`.
    Replace,
    /// `GL_MODULATE`.
    Modulate,
    /// `GL_DECAL`.
    Decal,
    /// `GL_BLEND`.
    Blend,
    /// `GL_ADD`.
    Add,
}

impl Mode {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Replace, Self::Modulate, Self::Decal, Self::Blend, Self::Add];

    /// Whether the specification says what this mode does with this format.
    pub fn defined_for(self, base: Base) -> bool {
        match self {
            Self::Decal => matches!(base, Base::Red | Base::Rg | Base::Rgb | Base::Rgba),
            Self::Replace | Self::Modulate | Self::Blend | Self::Add => true,
        }
    }
}

/// Base internal format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Base {
    /// `GL_ALPHA`.
    Alpha,
    /// `GL_LUMINANCE`.
    Luminance,
    /// `GL_LUMINANCE_ALPHA`.
    LuminanceAlpha,
    /// `GL_INTENSITY`.
    Intensity,
    /// `GL_RED`.
    Red,
    /// `GL_RG`.
    Rg,
    /// `GL_RGB`.
    Rgb,
    /// `GL_RGBA`.
    Rgba,
}

impl Base {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Alpha,
        Self::Luminance,
        Self::LuminanceAlpha,
        Self::Intensity,
        Self::Red,
        Self::Rg,
        Self::Rgb,
        Self::Rgba,
    ];
}

/// The source colour `Cs` and alpha `As` that an RGBA texel becomes in a format, `None` where the
/// format has none (section 3.6.4 takes luminance and intensity from red; section 3.8.13 says what they become).
pub fn source(base: Base, texel: [f64; 4]) -> (Option<[f64; 3]>, Option<f64>) {
    let [r, g, b, a] = texel;
    match base {
        Base::Alpha => (None, Some(a)),
        Base::Luminance => (Some([r; 3]), None),
        Base::LuminanceAlpha => (Some([r; 3]), Some(a)),
        Base::Intensity => (Some([r; 3]), Some(r)),
        Base::Red => (Some([r, 0.0, 0.0]), None),
        Base::Rg => (Some([r, g, 0.0]), None),
        Base::Rgb => (Some([r, g, b]), None),
        Base::Rgba => (Some([r, g, b]), Some(a)),
    }
}

/// The inputs of a texture environment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inputs {
    /// The incoming colour: `Cp`, `Ap`.
    pub previous: [f64; 4],
    /// The texel as RGBA, before the format drops what it does not have.
    pub texel: [f64; 4],
    /// `GL_TEXTURE_ENV_COLOR`: `Cc`, `Ac`.
    pub constant: [f64; 4],
}

/// `Cv`, `Av`, clamped to [0, 1].
pub fn apply(mode: Mode, base: Base, inputs: &Inputs, variant: Variant) -> [f64; 4] {
    let Inputs { previous, texel, constant } = *inputs;
    let (color, mut alpha) = source(base, texel);
    if variant.has(Mutation::IntensityAsLuminance) && base == Base::Intensity {
        alpha = None;
    }
    let rgb = |f: &dyn Fn(f64, f64, f64) -> f64| -> [f64; 3] {
        std::array::from_fn(|c| color.map_or(previous[c], |cs| f(previous[c], cs[c], constant[c])))
    };
    let [ap, ac] = [previous[3], constant[3]];
    let modulated = alpha.map_or(ap, |a| ap * a);
    let (cv, av) = match mode {
        Mode::Replace => {
            let without = if variant.has(Mutation::ReplaceOverwritesAlpha) { 1.0 } else { ap };
            (rgb(&|_, cs, _| cs), alpha.unwrap_or(without))
        }
        Mode::Modulate if variant.has(Mutation::ModulateReplaces) => {
            (rgb(&|_, cs, _| cs), alpha.unwrap_or(ap))
        }
        Mode::Modulate => (rgb(&|cp, cs, _| cp * cs), modulated),
        Mode::Decal => {
            let a = alpha.unwrap_or(1.0);
            let av = if variant.has(Mutation::DecalBlendsAlpha) { ap * a } else { ap };
            (rgb(&|cp, cs, _| cp * (1.0 - a) + cs * a), av)
        }
        Mode::Blend => {
            let blend = |p: f64, s: f64, c: f64| {
                if variant.has(Mutation::BlendReversed) {
                    p * s + c * (1.0 - s)
                } else if variant.has(Mutation::BlendWithoutConstant) {
                    p * (1.0 - s) + s
                } else {
                    p * (1.0 - s) + c * s
                }
            };
            let av = if base == Base::Intensity {
                alpha.map_or(ap, |a| blend(ap, a, ac))
            } else {
                modulated
            };
            (rgb(&blend), av)
        }
        Mode::Add => {
            let added = alpha.map_or(ap, |a| ap + a);
            let adds_alpha = base == Base::Intensity || variant.has(Mutation::AddAddsAlpha);
            let av = if adds_alpha { added } else { modulated };
            (rgb(&|cp, cs, _| cp + cs), av)
        }
    };
    let limit = |c: f64| {
        if variant.has(Mutation::AddUnclamped) && c > 1.0 { c - 1.0 } else { c.clamp(0.0, 1.0) }
    };
    [cv[0], cv[1], cv[2], av].map(limit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn by_hand() {
        let inputs = Inputs {
            previous: [0.5, 0.25, 1.0, 0.5],
            texel: [0.5, 1.0, 0.0, 0.25],
            constant: [1.0, 0.0, 0.5, 0.0],
        };
        let table = [
            (Mode::Replace, Base::Rgb, [0.5, 1.0, 0.0, 0.5]),
            (Mode::Replace, Base::Alpha, [0.5, 0.25, 1.0, 0.25]),
            (Mode::Modulate, Base::Rgba, [0.25, 0.25, 0.0, 0.125]),
            (Mode::Modulate, Base::Luminance, [0.25, 0.125, 0.5, 0.5]),
            (Mode::Decal, Base::Rgba, [0.5, 0.4375, 0.75, 0.5]),
            (Mode::Blend, Base::Intensity, [0.75, 0.125, 0.75, 0.25]),
            (Mode::Blend, Base::Rgba, [0.75, 0.0, 1.0, 0.125]),
            (Mode::Add, Base::LuminanceAlpha, [1.0, 0.75, 1.0, 0.125]),
            (Mode::Add, Base::Intensity, [1.0, 0.75, 1.0, 1.0]),
        ];
        for (mode, base, expected) in table {
            assert_eq!(apply(mode, base, &inputs, Variant::CORRECT), expected, "{mode:?} {base:?}");
        }
    }
}
