//! Changes to a stage, generated or a program's, for the state of a draw: coverage as alpha, two-sided colours, and
//! user clip planes.

use crate::base::vector::{dot, words};
use crate::interface::*;
use rasterizer::ir::{Builder, Expr, Input, Interpolation, Module, Op, Output, Stmt, Value};

fn push(module: &mut Module, expr: Expr) -> Value {
    module.values.push(expr);
    Value(module.values.len() as u32 - 1)
}

/// Multiplies alpha by the part of the pixel that the primitive covers (GL 2.1, section 3.12). The
/// alpha test comes after it.
pub(crate) fn add_coverage(module: &mut Module) {
    let alphas = module.outputs.iter().filter_map(|&(output, var)| {
        matches!(output, Output::Color { component: 3, .. }).then_some(var)
    });
    let mut alphas: Vec<_> = alphas.collect();
    // One variable may be the alpha of several targets.
    alphas.sort_unstable();
    alphas.dedup();
    for var in alphas {
        let coverage = push(module, Expr::Input(Input::Coverage));
        let alpha = push(module, Expr::Load(var));
        let args = [alpha, coverage, Value(0)];
        let value = push(module, Expr::Op { op: Op::Mul, args });
        module.body.extend([Stmt::Eval(alpha), Stmt::Eval(value), Stmt::Store { var, value }]);
    }
}

/// Selects the back colours of the vertex stage for back faces (GL 2.1, section 2.14.1): `gl_Color` is `gl_FrontColor`
/// or `gl_BackColor`.
pub(crate) fn add_two_sides(module: &mut Module) {
    let mut evaluated = Vec::new();
    for at in 0..module.values.len() {
        let Expr::Input(Input::Varying(slot)) = module.values[at] else { continue };
        if !(VARYING_COLOR..VARYING_TEX_COORD).contains(&slot) {
            continue;
        }
        let other = VARYING_BACK_COLOR + (slot - VARYING_COLOR);
        let facing = push(module, Expr::Input(Input::FrontFacing));
        let front = push(module, Expr::Input(Input::Varying(slot)));
        let back = push(module, Expr::Input(Input::Varying(other)));
        module.values[at] = Expr::Op { op: Op::SelectF, args: [facing, front, back] };
        evaluated.push(Stmt::Eval(Value(at as u32)));
    }
    if evaluated.is_empty() {
        return;
    }
    // The back is interpolated as the shader says of the front.
    let [front, back] = [VARYING_COLOR, VARYING_BACK_COLOR].map(usize::from);
    module.varyings.resize(module.varyings.len().max(back + 8), Interpolation::Smooth);
    module.varyings.copy_within(front..front + 8, back);
    let centroids = module.centroids.iter().filter(|slot| **slot < VARYING_TEX_COORD);
    let centroids: Vec<u16> =
        centroids.map(|slot| slot - VARYING_COLOR + VARYING_BACK_COLOR).collect();
    module.centroids.extend(centroids);
    module.body.splice(0..0, evaluated);
}

/// Lets user clip planes cut by the position that a program's vertex stage writes (GLSL 1.30,
/// section 7.1). `planes` has a bit for each that is enabled; those of plane 0 are the words from
/// `first` on.
pub(crate) fn add_clip_planes(module: Module, planes: u8, first: u32) -> Module {
    let position = [0, 1, 2, 3].map(|component| {
        let output = Output::Position(component);
        module.outputs.iter().find(|(other, _)| *other == output).map(|(_, var)| *var)
    });
    // What writes no position draws nothing.
    let [Some(x), Some(y), Some(z), Some(w)] = position else { return module };
    let mut b = Builder::resume(module);
    let position = [x, y, z, w].map(|var| b.load(var));
    for plane in (0..MAX_CLIP_PLANES).filter(|plane| planes >> plane & 1 == 1) {
        let equation = words(&mut b, first + 4 * u32::from(plane));
        let distance = dot(&mut b, equation, position);
        let var = b.output(Output::ClipDistance(plane));
        b.store(var, distance);
    }
    b.finish()
}
