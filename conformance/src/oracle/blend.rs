//! Blending of fragments with the framebuffer (section 4.1.8).

use crate::mutation::{Mutation, Variant};

/// `glBlendEquation`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equation {
    /// `GL_FUNC_ADD`.
    Add,
    /// `GL_FUNC_SUBTRACT`.
    Subtract,
    /// `GL_FUNC_REVERSE_SUBTRACT`.
    ReverseSubtract,
    /// `GL_MIN`.
    Min,
    /// `GL_MAX`.
    Max,
}

impl Equation {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::Add, Self::Subtract, Self::ReverseSubtract, Self::Min, Self::Max];
}

/// A weighting factor of `glBlendFunc`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Factor {
    /// `GL_ZERO`.
    Zero,
    /// `GL_ONE`.
    One,
    /// `GL_SRC_COLOR`.
    SrcColor,
    /// `GL_ONE_MINUS_SRC_COLOR`.
    OneMinusSrcColor,
    /// `GL_DST_COLOR`.
    DstColor,
    /// `GL_ONE_MINUS_DST_COLOR`.
    OneMinusDstColor,
    /// `GL_SRC_ALPHA`.
    SrcAlpha,
    /// `GL_ONE_MINUS_SRC_ALPHA`.
    OneMinusSrcAlpha,
    /// `GL_DST_ALPHA`.
    DstAlpha,
    /// `GL_ONE_MINUS_DST_ALPHA`.
    OneMinusDstAlpha,
    /// `GL_CONSTANT_COLOR`.
    ConstantColor,
    /// `GL_ONE_MINUS_CONSTANT_COLOR`.
    OneMinusConstantColor,
    /// `GL_CONSTANT_ALPHA`.
    ConstantAlpha,
    /// `GL_ONE_MINUS_CONSTANT_ALPHA`.
    OneMinusConstantAlpha,
    /// `GL_SRC_ALPHA_SATURATE`: of the source only.
    SrcAlphaSaturate,
}

impl Factor {
    /// All of them; the last may only weigh the source.
    pub const ALL: [Self; 15] = [
        Self::Zero,
        Self::One,
        Self::SrcColor,
        Self::OneMinusSrcColor,
        Self::DstColor,
        Self::OneMinusDstColor,
        Self::SrcAlpha,
        Self::OneMinusSrcAlpha,
        Self::DstAlpha,
        Self::OneMinusDstAlpha,
        Self::ConstantColor,
        Self::OneMinusConstantColor,
        Self::ConstantAlpha,
        Self::OneMinusConstantAlpha,
        Self::SrcAlphaSaturate,
    ];

    /// The weights of red, green, blue, alpha.
    fn weights(self, colors: &Colors, variant: Variant) -> [f64; 4] {
        let Colors { source, destination, constant } = *colors;
        let dst_alpha =
            if variant.has(Mutation::DestinationAlphaIsOne) { 1.0 } else { destination[3] };
        let one_minus = |weights: [f64; 4]| weights.map(|w| 1.0 - w);
        match self {
            Self::Zero => [0.0; 4],
            Self::One => [1.0; 4],
            Self::SrcColor => source,
            Self::OneMinusSrcColor => one_minus(source),
            Self::DstColor => destination,
            Self::OneMinusDstColor => one_minus(destination),
            Self::SrcAlpha => [source[3]; 4],
            Self::OneMinusSrcAlpha => one_minus([source[3]; 4]),
            Self::DstAlpha => [dst_alpha; 4],
            Self::OneMinusDstAlpha => one_minus([dst_alpha; 4]),
            Self::ConstantColor => constant,
            Self::OneMinusConstantColor => one_minus(constant),
            Self::ConstantAlpha => [constant[3]; 4],
            Self::OneMinusConstantAlpha => one_minus([constant[3]; 4]),
            Self::SrcAlphaSaturate => {
                let f = if variant.has(Mutation::SaturateAsSrcAlpha) {
                    source[3]
                } else {
                    source[3].min(1.0 - destination[3])
                };
                [f, f, f, 1.0]
            }
        }
    }
}

/// What is blended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colors {
    /// The fragment's.
    pub source: [f64; 4],
    /// The framebuffer's.
    pub destination: [f64; 4],
    /// `glBlendColor`.
    pub constant: [f64; 4],
}

/// The new colour of the framebuffer, clamped to [0, 1].
pub fn blend(
    equation: Equation,
    factors: [Factor; 2],
    colors: &Colors,
    variant: Variant,
) -> [f64; 4] {
    unclamped(equation, factors, colors, variant).map(|c| c.clamp(0.0, 1.0))
}

/// Red, green and blue by one equation and pair of factors, alpha by another.
pub fn separate(
    equations: [Equation; 2],
    factors: [[Factor; 2]; 2],
    colors: &Colors,
    variant: Variant,
) -> [f64; 4] {
    let [r, g, b, a] = unclamped(equations[0], factors[0], colors, variant);
    if variant.has(Mutation::AlphaFactorsIgnored) {
        return [r, g, b, a];
    }
    [r, g, b, unclamped(equations[1], factors[1], colors, variant)[3]]
}

/// The new colour of a framebuffer of floats: `s·S + d·D` and its relatives. `GL_MIN` and `GL_MAX` take no weights.
pub fn unclamped(
    equation: Equation,
    factors: [Factor; 2],
    colors: &Colors,
    variant: Variant,
) -> [f64; 4] {
    let [mut s, mut d] = factors.map(|factor| factor.weights(colors, variant));
    if variant.has(Mutation::BlendFactorsSwapped) {
        (s, d) = (d, s);
    }
    let reversed = variant.has(Mutation::SubtractReversed);
    std::array::from_fn(|c| {
        let (source, destination) = (colors.source[c], colors.destination[c]);
        let (ws, wd) = (s[c] * source, d[c] * destination);
        match equation {
            Equation::Add => ws + wd,
            Equation::Subtract if reversed => wd - ws,
            Equation::Subtract => ws - wd,
            Equation::ReverseSubtract if reversed => ws - wd,
            Equation::ReverseSubtract => wd - ws,
            Equation::Min if variant.has(Mutation::MinWeighted) => ws.min(wd),
            Equation::Min => source.min(destination),
            Equation::Max => source.max(destination),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn by_hand() {
        let colors = Colors {
            source: [1.0, 0.5, 0.0, 0.75],
            destination: [0.0, 0.5, 1.0, 0.5],
            constant: [0.25, 0.5, 0.75, 1.0],
        };
        let over = [Factor::SrcAlpha, Factor::OneMinusSrcAlpha];
        let table = [
            (Equation::Add, over, [0.75, 0.5, 0.25, 0.6875]),
            (Equation::Add, [Factor::One, Factor::One], [1.0, 1.0, 1.0, 1.0]),
            (Equation::Subtract, [Factor::One, Factor::One], [1.0, 0.0, 0.0, 0.25]),
            (Equation::ReverseSubtract, [Factor::One, Factor::One], [0.0, 0.0, 1.0, 0.0]),
            (Equation::Min, [Factor::Zero, Factor::Zero], [0.0, 0.5, 0.0, 0.5]),
            (Equation::Add, [Factor::SrcAlphaSaturate, Factor::Zero], [0.5, 0.25, 0.0, 0.75]),
            (Equation::Add, [Factor::ConstantColor, Factor::ConstantAlpha], [0.25, 0.75, 1.0, 1.0]),
        ];
        for (equation, factors, expected) in table {
            let got = blend(equation, factors, &colors, Variant::CORRECT);
            assert_eq!(got, expected, "{equation:?} {factors:?}");
        }
        let both = [[Factor::One, Factor::Zero], [Factor::Zero, Factor::One]];
        let got = separate([Equation::Add; 2], both, &colors, Variant::CORRECT);
        assert_eq!(got, [1.0, 0.5, 0.0, 0.5]);
    }
}
