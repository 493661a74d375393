//! The fixed-function fragment stage: texturing (GL 2.1, section 3.8) and the alpha test (section
//! 4.1.4).

use super::environment::apply;
pub(crate) use super::environment::environment_base;
use super::{clamp, word};
use crate::env::Mode;
use crate::interface::*;
use rasterizer::ir::{
    Builder, Expr, Input, Interpolation, Lod, Module, Op, Output, Stage, Stmt, TextureDecl, Ty,
    Value,
};
use texunit::format::BaseFormat;
use texunit::image::Shape;
use texunit::sampler::Compare;

/// A texture unit that is enabled and has a complete texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct UnitKey {
    pub unit: u8,
    pub mode: Mode,
    /// As [`environment_base`] gives it.
    pub base: BaseFormat,
    pub shape: Shape,
    pub compare: bool,
    /// Whether q may be other than 1, so that s, t and r are divided by it.
    pub projective: bool,
}

/// The state that changes the code.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct FragmentKey {
    /// First uniform word of the fixed function.
    pub base: u32,
    /// In order; the texture slots are numbered the same way.
    pub units: Vec<UnitKey>,
    pub shade_model: Interpolation,
    /// The alpha test, unless it lets everything through.
    pub alpha: Option<Compare>,
}

/// Generates the stage.
pub(super) fn module(key: &FragmentKey) -> Module {
    let mut b = Builder::new(Stage::Fragment);
    // A program's vertex stage may have written any colour (GL 2.1, section 2.14.6).
    let mut color = [0, 1, 2, 3].map(|i| {
        let value = b.input(Input::Varying(VARYING_COLOR + i));
        clamp(&mut b, value)
    });
    for unit in &key.units {
        let texel = sample(&mut b, unit);
        let first = key.base + word::ENV_COLOR + 4 * u32::from(unit.unit);
        let constant = [0, 1, 2, 3].map(|i| b.uniform(first + i, Ty::F32));
        color = apply(&mut b, unit.mode, unit.base, color, texel, constant);
    }
    for (component, value) in (0..).zip(color) {
        let var = b.output(Output::Color { target: 0, component });
        b.store(var, value);
    }
    let mut module = b.finish();
    module.varyings = vec![
        Interpolation::Smooth;
        usize::from(VARYING_TEX_COORD) + 4 * MAX_TEXTURE_UNITS as usize
    ];
    set_shade_model(&mut module, key.shade_model, [None; 2]);
    match key.alpha {
        Some(compare) => add_alpha_test(&mut module, compare, key.base + word::ALPHA_REF),
        None => module.notes.push("left out: the alpha test (off, or lets everything pass)".into()),
    }
    let off: Vec<String> = (0..MAX_TEXTURE_UNITS)
        .filter(|unit| key.units.iter().all(|key| key.unit != *unit))
        .map(|unit| unit.to_string())
        .collect();
    if !off.is_empty() {
        let why = "(disabled, or without a complete texture)";
        module.notes.push(format!("left out: texture units {} {why}", off.join(", ")));
    }
    module
}

/// The texel of a unit: at `s/q, t/q`, compared with `r/q` where it is a shadow map.
fn sample(b: &mut Builder, unit: &UnitKey) -> [Value; 4] {
    let texture =
        b.texture(TextureDecl { compare: unit.compare, ..TextureDecl::color(unit.shape) });
    let first = VARYING_TEX_COORD + 4 * u16::from(unit.unit);
    let [mut s, mut t, mut r, q] = [0, 1, 2, 3].map(|i| b.input(Input::Varying(first + i)));
    // A cube map's coordinates are a direction, which q does not change.
    if unit.projective && unit.shape != Shape::Cube {
        [s, t, r] = [s, t, r].map(|coord| b.op(Op::Div, &[coord, q]));
    }
    let zero = b.float(0.0);
    let coords = match unit.shape {
        Shape::D1 => [s, zero, zero],
        Shape::D2 | Shape::Rect | Shape::D1Array => [s, t, zero],
        Shape::D3 | Shape::Cube | Shape::D2Array => [s, t, r],
    };
    let reference = unit.compare.then_some(r);
    b.sample(texture, coords, reference, Lod::Implicit { bias: None })
}

/// Makes the colours of a fragment stage flat, or smooth (GL 2.1, section 2.14.7), but for those
/// whose interpolation the shaders say: the colour, the secondary colour.
pub(crate) fn set_shade_model(
    module: &mut Module,
    shade_model: Interpolation,
    said: [Option<Interpolation>; 2],
) {
    for (first, said) in [0, 4].into_iter().zip(said) {
        let front = VARYING_COLOR + first;
        let back = VARYING_BACK_COLOR + first;
        for slot in (front..front + 4).chain(back..back + 4) {
            if let Some(interpolation) = module.varyings.get_mut(usize::from(slot)) {
                *interpolation = said.unwrap_or(shade_model);
            }
        }
    }
}

/// Appends the alpha test to a fragment stage: `alpha OP reference` must hold (section 4.1.4).
pub(crate) fn add_alpha_test(module: &mut Module, compare: Compare, reference: u32) {
    let alpha = Output::Color { target: 0, component: 3 };
    let Some(&(_, var)) = module.outputs.iter().find(|(output, _)| *output == alpha) else {
        return;
    };
    let mut value = |expr| {
        module.values.push(expr);
        Value(module.values.len() as u32 - 1)
    };
    let load = value(Expr::Load(var));
    let reference_value = value(Expr::Uniform { word: reference, ty: Ty::F32 });
    let mut evaluated = vec![load];
    let mut op = |op, args: &[Value]| {
        let mut all = [Value(0); 3];
        all[..args.len()].copy_from_slice(args);
        let result = value(Expr::Op { op, args: all });
        evaluated.push(result);
        result
    };
    let (a, r) = (load, reference_value);
    let passes = match compare {
        Compare::Never => op(Op::NotEqual, &[r, r]),
        Compare::Less => op(Op::Less, &[a, r]),
        Compare::Equal => op(Op::Equal, &[a, r]),
        Compare::LessEqual => op(Op::LessEqual, &[a, r]),
        Compare::Greater => op(Op::Less, &[r, a]),
        Compare::NotEqual => op(Op::NotEqual, &[a, r]),
        Compare::GreaterEqual => op(Op::LessEqual, &[r, a]),
        Compare::Always => op(Op::Equal, &[r, r]),
    };
    module.body.extend(evaluated.into_iter().map(Stmt::Eval));
    module.body.push(Stmt::If {
        condition: passes,
        accept: Vec::new(),
        reject: vec![Stmt::Discard],
    });
    module.uniform_words = module.uniform_words.max(reference + 1);
}
