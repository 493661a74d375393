//! The fixed-function fragment stage: texturing (GL 2.1, section 3.8), colour sum (3.9), fog (3.10)
//! and the alpha test (4.1.4).

use crate::base::clamp::Clamp;
use crate::base::limits::MAX_COLOR_ATTACHMENTS;
use crate::base::vector::{clamped, words};
use crate::generate::fixed::combine::Sources;
use crate::generate::fixed::environment::{Environment, apply};
use crate::generate::fixed::fog::{FogKey, fog};
use crate::generate::fixed::word;
use crate::interface::*;
use rasterizer::driver::Antialiasing;
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
    pub environment: Environment,
    /// As [`super::environment_base`] gives it.
    pub base: BaseFormat,
    pub shape: Shape,
    pub compare: bool,
    /// Whether texels may be outside of [0, 1], so that the unit's result is clamped.
    pub clamp: Clamp,
    pub coordinates: Coordinates,
}

/// How a unit's coordinates are read from the vertex stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Coordinates {
    /// From the vertex stage; q is 1.
    Plain,
    /// From the vertex stage; s, t and r are divided by q.
    Projective,
}

/// The state that the code depends on.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct FragmentKey {
    /// First uniform word of the fixed function.
    pub base: u32,
    /// In order; the texture slots are numbered the same way.
    pub units: Vec<UnitKey>,
    pub shade_model: Interpolation,
    /// Whether back faces have colours of their own.
    pub two_sided: bool,
    /// Whether the secondary colour is added.
    pub color_sum: bool,
    pub fog: Option<FogKey>,
    /// The alpha test, unless it always passes.
    pub alpha: Option<Compare>,
    /// Whether coverage changes alpha.
    pub antialiasing: Antialiasing,
    /// Whether colours are clamped, from the first to what is written.
    pub clamp: Clamp,
}

/// Generates the stage.
pub(crate) fn module(key: &FragmentKey) -> Module {
    let mut b = Builder::new(Stage::Fragment);
    let primary = color(&mut b, key, VARYING_COLOR, VARYING_BACK_COLOR);
    let mut color = texture(&mut b, key, primary);
    if key.color_sum {
        color = color_sum(&mut b, key, color);
    }
    if let Some(fog_key) = key.fog {
        let distance = b.input(Input::Varying(VARYING_FOG));
        color = fog(&mut b, fog_key, key.base, color, distance);
    }
    // Section 4.2.1: every draw buffer takes the colour; the driver leaves out those that are none.
    for target in 0..MAX_COLOR_ATTACHMENTS as u8 {
        for (component, value) in (0..).zip(color) {
            let var = b.output(Output::Color { target, component });
            b.store(var, value);
        }
    }
    let mut module = b.finish();
    module.varyings = vec![Interpolation::Smooth; usize::from(VARYING_USER)];
    set_shade_model(&mut module, key.shade_model, [None; 2]);
    if key.antialiasing == Antialiasing::Smooth {
        crate::generate::fixed::rewrite::add_coverage(&mut module);
    }
    if let Some(compare) = key.alpha {
        add_alpha_test(&mut module, compare, key.base + word::ALPHA_REF);
    }
    module.notes = left_out(key);
    module
}

/// Notes of a module: what was left out, and why.
fn left_out(key: &FragmentKey) -> Vec<String> {
    let mut notes = Vec::new();
    if key.alpha.is_none() {
        notes.push("left out: the alpha test (off, or lets everything pass)".into());
    }
    if !key.color_sum {
        notes.push("left out: colour sum".into());
    }
    if key.fog.is_none() {
        notes.push("left out: fog".into());
    }
    let off: Vec<String> = (0..MAX_TEXTURE_UNITS)
        .filter(|unit| key.units.iter().all(|key| key.unit != *unit))
        .map(|unit| unit.to_string())
        .collect();
    if !off.is_empty() {
        let why = "(disabled, or without a complete texture)";
        notes.push(format!("left out: texture units {} {why}", off.join(", ")));
    }
    notes
}

/// A colour of the side that is seen. A program's vertex stage may have written any (GL 2.1,
/// section 2.14.6).
fn color(b: &mut Builder, key: &FragmentKey, front: u16, back: u16) -> [Value; 4] {
    let [front, back] = [front, back].map(|first| [0, 1, 2, 3].map(|i| Input::Varying(first + i)));
    let mut color = front.map(|input| b.input(input));
    if key.two_sided {
        let faces = b.input(Input::FrontFacing);
        let back = back.map(|input| b.input(input));
        color = std::array::from_fn(|i| b.op(Op::SelectF, &[faces, color[i], back[i]]));
    }
    color.map(|value| clamped(b, key.clamp, value))
}

/// The primary colour through the environments of all units.
fn texture(b: &mut Builder, key: &FragmentKey, primary: [Value; 4]) -> [Value; 4] {
    let mut texels = [None; MAX_TEXTURE_UNITS as usize];
    for unit in &key.units {
        texels[usize::from(unit.unit)] = Some(sample(b, unit));
    }
    let mut previous = primary;
    for unit in &key.units {
        // ARB_texture_env_crossbar: a unit that reads a texture which is not there does nothing.
        if let Environment::Combine(combine) = &unit.environment
            && combine.crossbar().any(|other| texels[usize::from(other)].is_none())
        {
            continue;
        }
        let constant = words(b, key.base + word::ENV_COLOR + 4 * u32::from(unit.unit));
        let clamp = key.clamp;
        let from = Sources { texels: &texels, unit: unit.unit, constant, primary, previous, clamp };
        let output = apply(b, &unit.environment, unit.base, &from);
        previous = output.map(|value| clamped(b, unit.clamp, value));
    }
    previous
}

/// The texel of a unit: at `s/q, t/q`, compared with `r/q` where it is a shadow map.
fn sample(b: &mut Builder, unit: &UnitKey) -> [Value; 4] {
    let texture =
        b.texture(TextureDecl { compare: unit.compare, ..TextureDecl::color(unit.shape) });
    let first = VARYING_TEX_COORD + 4 * u16::from(unit.unit);
    let zero = b.float(0.0);
    let [s, t, r] = match unit.coordinates {
        Coordinates::Plain => [0, 1, 2].map(|i| b.input(Input::Varying(first + i))),
        Coordinates::Projective => {
            let [s, t, r, q] = [0, 1, 2, 3].map(|i| b.input(Input::Varying(first + i)));
            // A cube map's coordinates are a direction, which q does not change.
            if unit.shape.is_cube() {
                [s, t, r]
            } else {
                [s, t, r].map(|coord| b.op(Op::Div, &[coord, q]))
            }
        }
    };
    let coords = match unit.shape {
        Shape::D1 => [s, zero, zero],
        Shape::D2 | Shape::Rect | Shape::D1Array => [s, t, zero],
        Shape::D3 | Shape::Cube | Shape::D2Array | Shape::CubeArray => [s, t, r],
    };
    let reference = unit.compare.then_some(r);
    b.sample(texture, coords, reference, Lod::Implicit { bias: None })
}

/// The secondary colour added (section 3.9).
fn color_sum(b: &mut Builder, key: &FragmentKey, primary: [Value; 4]) -> [Value; 4] {
    let secondary = color(b, key, VARYING_SECONDARY_COLOR, VARYING_BACK_COLOR + 4);
    let [red, green, blue] = [0, 1, 2].map(|i| {
        let sum = b.op(Op::Add, &[primary[i], secondary[i]]);
        clamped(b, key.clamp, sum)
    });
    [red, green, blue, primary[3]]
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
