//! Code of texture combiners: GL 2.1, section 3.8.13, tables 3.24 and 3.25; `NV_texture_env_combine4`.

use crate::base::clamp::Clamp;
use crate::base::vector::clamped;
use crate::state::texture_units::combine::{
    Argument, Arguments, Combiner, Function, Operand, Scale, Source,
};
use rasterizer::ir::{Builder, Op, Value};

/// The sources of combiner arguments.
pub(crate) struct Sources<'a> {
    /// Texels by unit.
    pub texels: &'a [Option<[Value; 4]>],
    /// The unit that combines.
    pub unit: u8,
    pub constant: [Value; 4],
    pub primary: [Value; 4],
    pub previous: [Value; 4],
    /// Whether a unit's result is clamped.
    pub clamp: Clamp,
}

impl Sources<'_> {
    /// The texel of a unit's texture, if it has one.
    pub fn texel(&self, unit: u8) -> Option<[Value; 4]> {
        self.texels.get(usize::from(unit)).copied().flatten()
    }
}

/// The combiners of a unit, without fields that have no effect: part of a module's key.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct CombineKey {
    /// Of red, green and blue.
    pub(crate) color: Combiner,
    /// Of alpha; where a dot product goes there, the colours' with alpha's own scale.
    pub(crate) alpha: Combiner,
    pub(crate) arguments: Arguments,
}

/// How many arguments a function reads.
fn count(function: Function, arguments: Arguments) -> usize {
    match (function, arguments) {
        (Function::Add | Function::AddSigned, Arguments::Four) => 4,
        (Function::Replace, Arguments::Two | Arguments::Four) => 1,
        (Function::Interpolate, Arguments::Two | Arguments::Four) => 3,
        (Function::Add | Function::AddSigned, Arguments::Two)
        | (
            Function::Modulate
            | Function::Subtract
            | Function::Dot3Rgb
            | Function::Dot3Rgba
            | Function::Dot3RgbUnscaled
            | Function::Dot3RgbaUnscaled,
            Arguments::Two | Arguments::Four,
        ) => 2,
    }
}

impl CombineKey {
    /// The key of a unit's combiners.
    pub fn new(arguments: Arguments, combiners: &[Combiner; 2]) -> Self {
        let [color, alpha] = combiners.map(|mut combiner| {
            let unread = &mut combiner.arguments[count(combiner.function, arguments)..];
            unread.fill(Argument { source: Source::Zero, operand: Operand::Alpha });
            if let Function::Dot3RgbUnscaled | Function::Dot3RgbaUnscaled = combiner.function {
                combiner.scale = Scale::One;
            }
            combiner
        });
        let alpha = match color.function {
            Function::Dot3Rgba => Combiner { scale: alpha.scale, ..color },
            Function::Dot3RgbaUnscaled => color,
            Function::Replace
            | Function::Modulate
            | Function::Add
            | Function::AddSigned
            | Function::Interpolate
            | Function::Subtract
            | Function::Dot3Rgb
            | Function::Dot3RgbUnscaled => alpha,
        };
        Self { color, alpha, arguments }
    }

    /// The units whose textures it reads besides its own.
    pub fn crossbar(&self) -> impl Iterator<Item = u8> + '_ {
        let arguments = self.color.arguments.iter().chain(&self.alpha.arguments);
        arguments.filter_map(|argument| match argument.source {
            Source::Unit(unit) => Some(unit),
            Source::Texture
            | Source::Constant
            | Source::PrimaryColor
            | Source::Previous
            | Source::Zero => None,
        })
    }
}

/// A component of an argument.
fn argument(b: &mut Builder, from: &Sources<'_>, argument: Argument, component: usize) -> Value {
    let zero = b.float(0.0);
    let source = match argument.source {
        Source::Texture => from.texel(from.unit).unwrap_or([zero; 4]),
        Source::Unit(unit) => from.texel(unit).unwrap_or([zero; 4]),
        Source::Constant => from.constant,
        Source::PrimaryColor => from.primary,
        Source::Previous => from.previous,
        Source::Zero => [zero; 4],
    };
    let value = match argument.operand {
        Operand::Color | Operand::OneMinusColor => source[component],
        Operand::Alpha | Operand::OneMinusAlpha => source[3],
    };
    match argument.operand {
        Operand::Color | Operand::Alpha => value,
        Operand::OneMinusColor | Operand::OneMinusAlpha => {
            let one = b.float(1.0);
            b.op(Op::Sub, &[one, value])
        }
    }
}

/// Multiplied by the combiner's scale, and clamped where colours are.
fn scaled(b: &mut Builder, clamp: Clamp, value: Value, scale: Scale) -> Value {
    let value = match scale {
        Scale::One => value,
        Scale::Two | Scale::Four => {
            let factor = b.float(scale.factor());
            b.op(Op::Mul, &[value, factor])
        }
    };
    clamped(b, clamp, value)
}

/// A component of a combiner's result; a dot product is the same for all three.
fn component(
    b: &mut Builder,
    arguments: Arguments,
    combiner: &Combiner,
    from: &Sources<'_>,
    component: usize,
) -> Value {
    let of = |b: &mut Builder, at: usize, component: usize| {
        argument(b, from, combiner.arguments[at], component)
    };
    let half = b.float(0.5);
    let value = match combiner.function {
        Function::Replace => of(b, 0, component),
        Function::Modulate => {
            let (left, right) = (of(b, 0, component), of(b, 1, component));
            b.op(Op::Mul, &[left, right])
        }
        Function::Add | Function::AddSigned => {
            let mut terms = [0, 1].map(|at| of(b, at, component));
            if arguments == Arguments::Four {
                let [c, d] = [2, 3].map(|at| of(b, at, component));
                terms = [b.op(Op::Mul, &terms), b.op(Op::Mul, &[c, d])];
            }
            let sum = b.op(Op::Add, &terms);
            if combiner.function == Function::Add { sum } else { b.op(Op::Sub, &[sum, half]) }
        }
        Function::Interpolate => {
            let [left, right, weight] = [0, 1, 2].map(|at| of(b, at, component));
            let one = b.float(1.0);
            let rest = b.op(Op::Sub, &[one, weight]);
            let left = b.op(Op::Mul, &[left, weight]);
            let right = b.op(Op::Mul, &[right, rest]);
            b.op(Op::Add, &[left, right])
        }
        Function::Subtract => {
            let (left, right) = (of(b, 0, component), of(b, 1, component));
            b.op(Op::Sub, &[left, right])
        }
        Function::Dot3Rgb
        | Function::Dot3Rgba
        | Function::Dot3RgbUnscaled
        | Function::Dot3RgbaUnscaled => {
            let products = [0, 1, 2].map(|i| {
                let factors = [0, 1].map(|at| {
                    let value = of(b, at, i);
                    b.op(Op::Sub, &[value, half])
                });
                b.op(Op::Mul, &factors)
            });
            let sum = b.op(Op::Add, &[products[0], products[1]]);
            let sum = b.op(Op::Add, &[sum, products[2]]);
            let four = b.float(4.0);
            b.op(Op::Mul, &[sum, four])
        }
    };
    scaled(b, from.clamp, value, combiner.scale)
}

/// The result of the combiners.
pub(crate) fn combine(b: &mut Builder, key: &CombineKey, from: &Sources<'_>) -> [Value; 4] {
    let CombineKey { color, alpha, arguments } = key;
    let dot = color.function.is_dot_product();
    let red = component(b, *arguments, color, from, 0);
    let [green, blue] =
        if dot { [red; 2] } else { [1, 2].map(|i| component(b, *arguments, color, from, i)) };
    [red, green, blue, component(b, *arguments, alpha, from, 3)]
}
