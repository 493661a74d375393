//! State of texture combiners: GL 2.1, section 3.8.13, tables 3.24 and 3.25, with the sources of
//! `ARB_texture_env_crossbar` and the four arguments of `NV_texture_env_combine4`.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_value};
use crate::base::query_value::{QueryValue, float, symbol};
use crate::base::types::*;
use crate::interface::MAX_TEXTURE_UNITS;

const SECTION: &str = "GL 2.1, section 3.8.13";

/// The number of arguments of `GL_ADD` and `GL_ADD_SIGNED`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Arguments {
    /// `a + b`.
    Two,
    /// `a b + c d`.
    Four,
}

/// A combiner function of arguments `a` to `d`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Function {
    /// `a`.
    Replace,
    /// `a b`.
    Modulate,
    /// `a + b`.
    Add,
    /// `a + b - 1/2`.
    AddSigned,
    /// `a c + b (1 - c)`.
    Interpolate,
    /// `a - b`.
    Subtract,
    /// `4 (a - 1/2) · (b - 1/2)`, into red, green and blue.
    Dot3Rgb,
    /// The same, into alpha too.
    Dot3Rgba,
    /// As `Dot3Rgb`, and no scale applies (`EXT_texture_env_dot3`).
    Dot3RgbUnscaled,
    /// As `Dot3Rgba`, and no scale applies.
    Dot3RgbaUnscaled,
}

impl Function {
    /// Whether all components of colour are the same number.
    pub fn is_dot_product(self) -> bool {
        match self {
            Self::Dot3Rgb | Self::Dot3Rgba | Self::Dot3RgbUnscaled | Self::Dot3RgbaUnscaled => true,
            Self::Replace
            | Self::Modulate
            | Self::Add
            | Self::AddSigned
            | Self::Interpolate
            | Self::Subtract => false,
        }
    }
}

const FUNCTIONS: &[(GLenum, Function)] = &[
    (GL_REPLACE, Function::Replace),
    (GL_MODULATE, Function::Modulate),
    (GL_ADD, Function::Add),
    (GL_ADD_SIGNED, Function::AddSigned),
    (GL_INTERPOLATE, Function::Interpolate),
    (GL_SUBTRACT, Function::Subtract),
    (GL_DOT3_RGB, Function::Dot3Rgb),
    (GL_DOT3_RGBA, Function::Dot3Rgba),
    (GL_DOT3_RGB_EXT, Function::Dot3RgbUnscaled),
    (GL_DOT3_RGBA_EXT, Function::Dot3RgbaUnscaled),
];

/// Of colours, and of alpha.
const FUNCTION: [Table<Function>; 2] = [
    Table { section: SECTION, rows: FUNCTIONS },
    Table { section: SECTION, rows: FUNCTIONS.split_at(6).0 },
];

/// The source of an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Source {
    /// The unit's own texture.
    Texture,
    /// Another unit's texture.
    Unit(u8),
    /// The environment's colour.
    Constant,
    /// The colour that comes into the first unit.
    PrimaryColor,
    /// The colour that comes from the unit before.
    Previous,
    /// Zeros.
    Zero,
}

const SOURCE: Table<Source> = Table {
    section: SECTION,
    rows: &[
        (GL_TEXTURE, Source::Texture),
        (GL_CONSTANT, Source::Constant),
        (GL_PRIMARY_COLOR, Source::PrimaryColor),
        (GL_PREVIOUS, Source::Previous),
        (GL_ZERO, Source::Zero),
        (GL_TEXTURE0, Source::Unit(0)),
        (GL_TEXTURE1, Source::Unit(1)),
        (GL_TEXTURE2, Source::Unit(2)),
        (GL_TEXTURE3, Source::Unit(3)),
        (GL_TEXTURE4, Source::Unit(4)),
        (GL_TEXTURE5, Source::Unit(5)),
        (GL_TEXTURE6, Source::Unit(6)),
        (GL_TEXTURE7, Source::Unit(7)),
    ],
};

const _: () = assert!(MAX_TEXTURE_UNITS == 8, "a row for each unit");

/// How an argument is taken from its source.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Operand {
    Color,
    OneMinusColor,
    Alpha,
    OneMinusAlpha,
}

const OPERANDS: &[(GLenum, Operand)] = &[
    (GL_SRC_ALPHA, Operand::Alpha),
    (GL_ONE_MINUS_SRC_ALPHA, Operand::OneMinusAlpha),
    (GL_SRC_COLOR, Operand::Color),
    (GL_ONE_MINUS_SRC_COLOR, Operand::OneMinusColor),
];

/// Of colours, and of alpha.
const OPERAND: [Table<Operand>; 2] = [
    Table { section: SECTION, rows: OPERANDS },
    Table { section: SECTION, rows: OPERANDS.split_at(2).0 },
];

/// A source and its operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Argument {
    pub source: Source,
    pub operand: Operand,
}

/// The scale of a combiner's result.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Scale {
    One,
    Two,
    Four,
}

impl Scale {
    /// The factor.
    pub fn factor(self) -> f32 {
        match self {
            Self::One => 1.0,
            Self::Two => 2.0,
            Self::Four => 4.0,
        }
    }
}

/// The combiner of red, green and blue, or of alpha.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Combiner {
    pub function: Function,
    pub arguments: [Argument; 4],
    pub scale: Scale,
}

impl Combiner {
    /// The initial state of the combiners of colour and alpha.
    pub fn initial() -> [Self; 2] {
        let operands =
            [(Operand::Color, Operand::OneMinusColor), (Operand::Alpha, Operand::OneMinusAlpha)];
        operands.map(|(operand, inverted)| Self {
            function: Function::Modulate,
            arguments: [
                (Source::Texture, operand),
                (Source::Previous, operand),
                (Source::Constant, Operand::Alpha),
                (Source::Zero, inverted),
            ]
            .map(|(source, operand)| Argument { source, operand }),
            scale: Scale::One,
        })
    }
}

/// A field of a combiner that `glTexEnv` sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CombinerField {
    Function,
    Source(u8),
    Operand(u8),
    Scale,
}

/// A field of the combiner of colour (0) or of alpha (1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct CombinerParameter {
    combiner: usize,
    part: CombinerField,
}

/// Shorthand for a row.
const fn of(combiner: usize, part: CombinerField) -> CombinerParameter {
    CombinerParameter { combiner, part }
}

pub(crate) const COMBINER_PARAMETER: Table<CombinerParameter> = Table {
    section: SECTION,
    rows: &[
        (GL_COMBINE_RGB, of(0, CombinerField::Function)),
        (GL_COMBINE_ALPHA, of(1, CombinerField::Function)),
        (GL_SRC0_RGB, of(0, CombinerField::Source(0))),
        (GL_SRC1_RGB, of(0, CombinerField::Source(1))),
        (GL_SRC2_RGB, of(0, CombinerField::Source(2))),
        (GL_SOURCE3_RGB_NV, of(0, CombinerField::Source(3))),
        (GL_SRC0_ALPHA, of(1, CombinerField::Source(0))),
        (GL_SRC1_ALPHA, of(1, CombinerField::Source(1))),
        (GL_SRC2_ALPHA, of(1, CombinerField::Source(2))),
        (GL_SOURCE3_ALPHA_NV, of(1, CombinerField::Source(3))),
        (GL_OPERAND0_RGB, of(0, CombinerField::Operand(0))),
        (GL_OPERAND1_RGB, of(0, CombinerField::Operand(1))),
        (GL_OPERAND2_RGB, of(0, CombinerField::Operand(2))),
        (GL_OPERAND3_RGB_NV, of(0, CombinerField::Operand(3))),
        (GL_OPERAND0_ALPHA, of(1, CombinerField::Operand(0))),
        (GL_OPERAND1_ALPHA, of(1, CombinerField::Operand(1))),
        (GL_OPERAND2_ALPHA, of(1, CombinerField::Operand(2))),
        (GL_OPERAND3_ALPHA_NV, of(1, CombinerField::Operand(3))),
        (GL_RGB_SCALE, of(0, CombinerField::Scale)),
        (GL_ALPHA_SCALE, of(1, CombinerField::Scale)),
    ],
};

/// Sets a field from a number, which is a named constant or a scale.
pub(crate) fn set(
    combiners: &mut [Combiner; 2],
    parameter: CombinerParameter,
    number: f32,
) -> Result<()> {
    let CombinerParameter { combiner: which, part } = parameter;
    let combiner = &mut combiners[which];
    let symbol = crate::base::convert::symbol(number);
    match part {
        CombinerField::Function => combiner.function = FUNCTION[which].decode("param", symbol)?,
        CombinerField::Source(at) => {
            combiner.arguments[usize::from(at)].source = SOURCE.decode("param", symbol)?;
        }
        CombinerField::Operand(at) => {
            combiner.arguments[usize::from(at)].operand = OPERAND[which].decode("param", symbol)?;
        }
        CombinerField::Scale => {
            let scales = [Scale::One, Scale::Two, Scale::Four];
            let Some(scale) = scales.into_iter().find(|scale| scale.factor() == number) else {
                return invalid_value(SECTION, format!("a scale = {number} must be 1, 2 or 4"));
            };
            combiner.scale = scale;
        }
    }
    Ok(())
}

/// Reads a field.
pub(crate) fn get(combiners: &[Combiner; 2], parameter: CombinerParameter) -> Result<QueryValue> {
    let CombinerParameter { combiner: which, part } = parameter;
    let combiner = &combiners[which];
    match part {
        CombinerField::Function => symbol(FUNCTION[which].encode(combiner.function)),
        CombinerField::Source(at) => {
            symbol(SOURCE.encode(combiner.arguments[usize::from(at)].source))
        }
        CombinerField::Operand(at) => {
            symbol(OPERAND[which].encode(combiner.arguments[usize::from(at)].operand))
        }
        CombinerField::Scale => float(combiner.scale.factor()),
    }
}
