//! What primitives change in a fragment stage, whoever wrote it: coverage becomes alpha, and the
//! back of a polygon has colours of its own.

use crate::interface::*;
use rasterizer::ir::{Expr, Input, Module, Op, Output, Stmt, Value};

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

/// Lets the colours of a back face be those that the vertex stage wrote for it (GL 2.1, section
/// 2.14.1): `gl_Color` is `gl_FrontColor` or `gl_BackColor`.
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
    let needed = usize::from(VARYING_BACK_COLOR) + 8;
    if module.varyings.len() < needed {
        module.varyings.resize(needed, rasterizer::ir::Interpolation::Smooth);
    }
    module.body.splice(0..0, evaluated);
}
