//! The fragment stage: texture accesses, and the arithmetic around them.

use crate::context::watched_pixel::DrawNote;
use crate::explain::page::{Page, number};
use crate::explain::texture_access;
use rasterizer::ir::{Axis, Op, Output, Ty};
use rasterizer::trace::{Expression, Fragment, Name, Operand, Step};

/// The steps of the stage.
pub fn steps(page: &mut Page, fragment: &Fragment, note: &DrawNote) {
    for (formula, section) in &note.formulas {
        page.line(1, formula, section);
    }
    if fragment.steps.is_empty() && fragment.outputs.is_empty() {
        return;
    }
    page.line(1, "fragment shading, as it ran:", "GL 2.1, section 3.8 to 3.11");
    let mut rows = Vec::new();
    for step in &fragment.steps {
        match step {
            Step::Value { number, expression, ty, bits } => rows.push(vec![
                format!("t{number}"),
                format!("= {}", text(expression, note)),
                format!("= {}", value(*ty, *bits)),
            ]),
            Step::Lookup(lookup) => {
                page.table(2, &std::mem::take(&mut rows));
                texture_access::lookup(page, lookup, note);
            }
            Step::Discard => rows.push(vec!["discard".into()]),
        }
    }
    page.table(2, &rows);
    if fragment.more_steps > 0 {
        page.line(2, &format!("and {} more steps", fragment.more_steps), "");
    }
    let colors: Vec<Vec<String>> = fragment
        .outputs
        .iter()
        .filter_map(|(output, of)| {
            let name = match output {
                Output::Color { target: 0, component } => {
                    format!("colour.{}", ["r", "g", "b", "a"][usize::from(*component % 4)])
                }
                Output::SecondColor(component) => {
                    format!("second colour.{}", ["r", "g", "b", "a"][usize::from(*component % 4)])
                }
                Output::Depth => "depth".into(),
                Output::StencilReference => "stencil reference".into(),
                Output::SampleMask => "sample mask".into(),
                Output::Color { .. }
                | Output::Position(_)
                | Output::PointSize
                | Output::ClipDistance(_)
                | Output::CullDistance(_)
                | Output::Varying(_)
                | Output::Layer
                | Output::PrimitiveId
                | Output::ViewportIndex => return None,
            };
            Some(vec![name, format!("= {}", operand(of, note))])
        })
        .collect();
    page.table(2, &colors);
}

/// A word as its type prints it.
pub fn value(ty: Ty, bits: u32) -> String {
    match ty {
        Ty::F32 => number(f32::from_bits(bits)),
        Ty::I32 => (bits as i32).to_string(),
        Ty::U32 => format!("{bits}u"),
        Ty::Bool => (bits != 0).to_string(),
    }
}

/// The name of a value; none where it is the same for the whole draw.
pub fn name(name: Name, note: &DrawNote) -> Option<String> {
    match name {
        Name::Draw => None,
        Name::Input(input) => Some(note.input(input)),
        Name::Texel(number, component) => {
            let letter = ["r", "g", "b", "a"][usize::from(component % 4)];
            Some(format!("lookup{number}.{letter}"))
        }
        Name::Step(number) => Some(format!("t{number}")),
    }
}

/// A value: its name, and what it is.
pub fn operand(of: &Operand, note: &DrawNote) -> String {
    let value = value(of.ty, of.bits);
    match name(of.name, note) {
        Some(name) => format!("{name} [{value}]"),
        None => value,
    }
}

fn text(expression: &Expression, note: &DrawNote) -> String {
    match expression {
        Expression::Operand(of) => operand(of, note),
        Expression::Derivative(Axis::X, of) => format!("dFdx({})", operand(of, note)),
        Expression::Derivative(Axis::Y, of) => format!("dFdy({})", operand(of, note)),
        Expression::OfByte(of) => format!("table({})", operand(of, note)),
        Expression::Power(of, exponent) => format!("pow({}, {exponent:?})", operand(of, note)),
        Expression::Apply(op, args) => {
            let inner: Vec<String> = args.iter().map(|arg| text(arg, note)).collect();
            match (infix(*op), &inner[..]) {
                (Some(sign), [left, right]) => {
                    let side = |of: &Expression, text: &str| {
                        if let Expression::Apply(inner, _) = of
                            && infix(*inner).is_some()
                        {
                            return format!("({text})");
                        }
                        text.to_owned()
                    };
                    format!("{} {sign} {}", side(&args[0], left), side(&args[1], right))
                }
                _ => format!("{}({})", called(*op), inner.join(", ")),
            }
        }
    }
}

/// The name of an operation in the source.
fn called(op: Op) -> &'static str {
    match op {
        Op::AtMost => Op::Min.name(),
        Op::AtLeast => Op::Max.name(),
        op => op.name(),
    }
}

/// The signs that stand between two operands.
const SIGNS: [(&str, &[Op]); 8] = [
    ("+", &[Op::Add, Op::IAdd, Op::UAdd]),
    ("-", &[Op::Sub, Op::ISub, Op::USub]),
    ("·", &[Op::Mul, Op::IMul, Op::UMul]),
    ("/", &[Op::Div, Op::IDiv, Op::UDiv]),
    ("<", &[Op::Less, Op::ILess, Op::ULess]),
    ("<=", &[Op::LessEqual, Op::ILessEqual, Op::ULessEqual]),
    ("==", &[Op::Equal, Op::IEqual]),
    ("!=", &[Op::NotEqual, Op::INotEqual]),
];

/// The sign of an operation that has one.
fn infix(op: Op) -> Option<&'static str> {
    SIGNS.iter().find(|(_, ops)| ops.contains(&op)).map(|(sign, _)| *sign)
}
