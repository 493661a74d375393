//! Blending by two colours of a fragment (GL 3.3, section 4.1.7; ARB_blend_func_extended, table 4.2).

use super::blend::Equation;
use crate::mutation::{Mutation, Variant};

/// A factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GL's names")]
pub enum Factor {
    Zero,
    One,
    SrcColor,
    OneMinusDstColor,
    SrcAlphaSaturate,
    Src1Color,
    OneMinusSrc1Color,
    Src1Alpha,
    OneMinusSrc1Alpha,
}

impl Factor {
    /// All, those of the second colour last.
    pub const ALL: [Self; 9] = [
        Self::Zero,
        Self::One,
        Self::SrcColor,
        Self::OneMinusDstColor,
        Self::SrcAlphaSaturate,
        Self::Src1Color,
        Self::OneMinusSrc1Color,
        Self::Src1Alpha,
        Self::OneMinusSrc1Alpha,
    ];
}

/// The fragment's two colours, and the framebuffer's.
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "the words say it")]
pub struct Colors {
    pub source: [f64; 4],
    pub second: [f64; 4],
    pub destination: [f64; 4],
}

/// Factors of source and destination.
pub type Pair = [Factor; 2];

/// Blend state: for red, green and blue, and for alpha.
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "the words say it")]
pub struct State {
    pub equations: [Equation; 2],
    pub rgb: Pair,
    pub alpha: Pair,
}

/// The weight of channel `i`.
fn weight(factor: Factor, colors: &Colors, i: usize, variant: Variant) -> f64 {
    let second =
        if variant.has(Mutation::SecondColorIsFirst) { colors.source } else { colors.second };
    let second_alpha =
        if variant.has(Mutation::SecondAlphaIsColor) { second[i] } else { second[3] };
    match factor {
        Factor::Zero => 0.0,
        Factor::One => 1.0,
        Factor::SrcColor => colors.source[i],
        Factor::OneMinusDstColor => 1.0 - colors.destination[i],
        Factor::SrcAlphaSaturate if i == 3 => 1.0,
        Factor::SrcAlphaSaturate => colors.source[3].min(1.0 - colors.destination[3]),
        Factor::Src1Color => second[i],
        Factor::OneMinusSrc1Color => 1.0 - second[i],
        Factor::Src1Alpha => second_alpha,
        Factor::OneMinusSrc1Alpha => 1.0 - second_alpha,
    }
}

/// The framebuffer's colour after the fragment.
pub fn blend(state: &State, colors: &Colors, variant: Variant) -> [f64; 4] {
    std::array::from_fn(|i| {
        let as_rgb = i < 3 || variant.has(Mutation::AlphaFactorsIgnored);
        let ([source, destination], equation) = if as_rgb {
            (state.rgb, state.equations[0])
        } else {
            (state.alpha, state.equations[1])
        };
        let (s, d) = (colors.source[i], colors.destination[i]);
        let weighted_s = s * weight(source, colors, i, variant);
        let weighted_d = d * weight(destination, colors, i, variant);
        match equation {
            Equation::Add => weighted_s + weighted_d,
            Equation::Subtract => weighted_s - weighted_d,
            Equation::ReverseSubtract => weighted_d - weighted_s,
            Equation::Min => s.min(d),
            Equation::Max => s.max(d),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subpixel_text_by_hand() {
        let colors = Colors {
            source: [1.0, 0.5, 0.25, 1.0],
            second: [0.25, 0.5, 1.0, 0.75],
            destination: [0.5, 0.25, 0.125, 0.75],
        };
        let rgb = [Factor::Src1Color, Factor::OneMinusSrc1Color];
        let alpha = [Factor::Src1Alpha, Factor::OneMinusSrc1Alpha];
        let state = State { equations: [Equation::Add; 2], rgb, alpha };
        let expected = [0.625, 0.375, 0.25, 0.9375];
        assert_eq!(blend(&state, &colors, Variant::CORRECT), expected);
    }
}
