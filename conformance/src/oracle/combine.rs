//! `GL_COMBINE` (section 3.8.13, tables 3.24 and 3.25), and fog (section 3.10).

use crate::mutation::{Mutation, Variant};

/// The function of a combiner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GL's names")]
pub enum Function {
    Replace,
    Modulate,
    Add,
    AddSigned,
    Interpolate,
    Subtract,
    Dot3Rgb,
    Dot3Rgba,
}

impl Function {
    /// All; the last two are of colours only.
    pub const ALL: [Self; 8] = [
        Self::Replace,
        Self::Modulate,
        Self::Add,
        Self::AddSigned,
        Self::Interpolate,
        Self::Subtract,
        Self::Dot3Rgb,
        Self::Dot3Rgba,
    ];

    /// The functions that work component by component.
    fn of_component(self, [a, b, c]: [f64; 3], variant: Variant) -> f64 {
        match self {
            Self::Replace => a,
            Self::Modulate => a * b,
            Self::Add => a + b,
            Self::AddSigned if variant.has(Mutation::AddSignedWithoutHalf) => a + b,
            Self::AddSigned => a + b - 0.5,
            Self::Interpolate if variant.has(Mutation::InterpolateReversed) => {
                a * (1.0 - c) + b * c
            }
            Self::Interpolate => a * c + b * (1.0 - c),
            Self::Subtract if variant.has(Mutation::SubtractReversed) => b - a,
            Self::Subtract => a - b,
            Self::Dot3Rgb | Self::Dot3Rgba => 0.0,
        }
    }
}

/// Where an argument comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The unit's own texture.
    Texture,
    /// The texture of a unit (crossbar).
    TextureOf(usize),
    /// The environment colour.
    Constant,
    /// The interpolated colour.
    Primary,
    /// The result of the unit before.
    Previous,
}

/// The operand of an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "GL's names")]
pub enum Operand {
    Color,
    OneMinusColor,
    Alpha,
    OneMinusAlpha,
}

/// One combiner of a unit, of colour or of alpha.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Combiner {
    /// The function.
    pub function: Function,
    /// The arguments.
    pub arguments: [(Source, Operand); 3],
    /// 1, 2 or 4.
    pub scale: f64,
}

/// A unit: colour, alpha and the environment colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// The combiner of red, green, blue.
    pub color: Combiner,
    /// The combiner of alpha.
    pub alpha: Combiner,
    /// `GL_TEXTURE_ENV_COLOR`.
    pub constant: [f64; 4],
}

/// The colour after all units: `texels` are those of each, `primary` is the interpolated colour.
pub fn combine(
    units: &[Unit],
    texels: &[[f64; 4]],
    primary: [f64; 4],
    variant: Variant,
) -> [f64; 4] {
    let mut previous = primary;
    for (number, unit) in units.iter().enumerate() {
        let argument = |combiner: &Combiner, at: usize| -> [f64; 4] {
            let (source, operand) = combiner.arguments[at];
            let color = match source {
                Source::Texture => texels[number],
                Source::TextureOf(_) if variant.has(Mutation::CrossbarIgnored) => texels[number],
                Source::TextureOf(other) => texels[other],
                Source::Constant => unit.constant,
                Source::Primary if variant.has(Mutation::PrimaryIsPrevious) => previous,
                Source::Primary => primary,
                Source::Previous => previous,
            };
            match operand {
                Operand::Color => color,
                Operand::OneMinusColor | Operand::OneMinusAlpha
                    if variant.has(Mutation::OperandNotInverted) =>
                {
                    if operand == Operand::OneMinusColor { color } else { [color[3]; 4] }
                }
                Operand::OneMinusColor => color.map(|c| 1.0 - c),
                Operand::Alpha => [color[3]; 4],
                Operand::OneMinusAlpha => [1.0 - color[3]; 4],
            }
        };
        let all = |combiner: &Combiner| [0, 1, 2].map(|at| argument(combiner, at));
        let scale = |combiner: &Combiner, value: f64| {
            let scale =
                if variant.has(Mutation::CombineScaleIgnored) { 1.0 } else { combiner.scale };
            (value * scale).clamp(0.0, 1.0)
        };
        let (colors, alphas) = (all(&unit.color), all(&unit.alpha));
        let part = |c: usize| unit.color.function.of_component(colors.map(|a| a[c]), variant);
        let alpha =
            || scale(&unit.alpha, unit.alpha.function.of_component(alphas.map(|a| a[3]), variant));
        let dot = || {
            let four = if variant.has(Mutation::Dot3WithoutFour) { 1.0 } else { 4.0 };
            let sum: f64 = (0..3).map(|c| (colors[0][c] - 0.5) * (colors[1][c] - 0.5)).sum();
            four * sum
        };
        previous = match unit.color.function {
            Function::Dot3Rgba | Function::Dot3Rgb => {
                let rgb = scale(&unit.color, dot());
                let is_alpha = unit.color.function == Function::Dot3Rgba;
                [rgb, rgb, rgb, if is_alpha { scale(&unit.alpha, dot()) } else { alpha() }]
            }
            Function::Replace
            | Function::Modulate
            | Function::Add
            | Function::AddSigned
            | Function::Interpolate
            | Function::Subtract => {
                let [r, g, b] = [0, 1, 2].map(|c| scale(&unit.color, part(c)));
                [r, g, b, alpha()]
            }
        };
    }
    previous
}

/// `GL_FOG_MODE` and its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fog {
    /// `f = (end - c)/(end - start)`.
    Linear([f64; 2]),
    /// `f = e^(-d·c)`.
    Exp(f64),
    /// `f = e^(-(d·c)²)`.
    Exp2(f64),
}

impl Fog {
    /// `f·C + (1 - f)·Cf` of red, green, blue at the coordinate `c`.
    pub fn apply(self, c: f64, color: [f64; 4], fog: [f64; 4], variant: Variant) -> [f64; 4] {
        let f = match self {
            Self::Linear([start, end]) => (end - c) / (end - start),
            Self::Exp(d) if variant.has(Mutation::FogBase2) => (-d * c).exp2(),
            Self::Exp(d) => (-d * c).exp(),
            Self::Exp2(d) if variant.has(Mutation::FogNotSquared) => (-d * c).exp(),
            Self::Exp2(d) => (-(d * c).powi(2)).exp(),
        };
        let f = f.clamp(0.0, 1.0);
        let f = if variant.has(Mutation::FogReversed) { 1.0 - f } else { f };
        let mix = |i: usize| f * color[i] + (1.0 - f) * fog[i];
        [mix(0), mix(1), mix(2), color[3]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dot_product_of_a_direction_with_itself_is_one() {
        let argument = (Source::Texture, Operand::Color);
        let combiner = |function| Combiner { function, arguments: [argument; 3], scale: 1.0 };
        let unit = Unit {
            color: combiner(Function::Dot3Rgba),
            alpha: combiner(Function::Replace),
            constant: [0.0; 4],
        };
        let got = combine(&[unit], &[[1.0, 0.5, 0.5, 0.3]], [0.0; 4], Variant::CORRECT);
        assert_eq!(got, [1.0; 4]);
    }

    /// "The RGB and alpha results are multiplied by RGB_SCALE and ALPHA_SCALE".
    #[test]
    fn a_dot_product_in_alpha_has_the_scale_of_alpha() {
        let arguments = [(Source::Primary, Operand::Color); 3];
        let combiner = |function, scale| Combiner { function, arguments, scale };
        let unit = Unit {
            color: combiner(Function::Dot3Rgba, 1.0),
            alpha: combiner(Function::Replace, 4.0),
            constant: [0.0; 4],
        };
        let got = combine(&[unit], &[[0.0; 4]], [0.75, 0.5, 0.5, 0.3], Variant::CORRECT);
        assert_eq!(got, [0.25, 0.25, 0.25, 1.0]);
    }

    #[test]
    fn linear_fog_by_hand() {
        let fog = Fog::Linear([2.0, 6.0]);
        let got = fog.apply(3.0, [1.0; 4], [0.0; 4], Variant::CORRECT);
        assert_eq!(got, [0.75, 0.75, 0.75, 1.0]);
    }
}
