//! Clamping of the colours that a program's vertex stage writes: GL 2.1, section 2.14.6.

use crate::interface::{VARYING_BACK_COLOR, VARYING_COLOR, VARYING_TEX_COORD};
use rasterizer::ir::{Expr, Module, Op, Output, Stmt, Ty, Value};

/// Appends the clamp to [0, 1] of every colour that a vertex stage writes, front or back.
pub(crate) fn clamp_colors(module: &mut Module) {
    let is_color = |output: &Output| match output {
        Output::Varying(slot) => {
            (VARYING_COLOR..VARYING_TEX_COORD).contains(slot)
                || (VARYING_BACK_COLOR..VARYING_BACK_COLOR + 8).contains(slot)
        }
        Output::Position(_)
        | Output::PointSize
        | Output::ClipDistance(_)
        | Output::Color { .. }
        | Output::Depth => false,
    };
    let colors: Vec<_> =
        module.outputs.iter().filter(|(output, _)| is_color(output)).map(|(_, var)| *var).collect();
    let Module { values, body, .. } = module;
    let mut value = |expr| {
        values.push(expr);
        Value(values.len() as u32 - 1)
    };
    let [zero, one] =
        [0.0_f32, 1.0].map(|number| value(Expr::Const { bits: number.to_bits(), ty: Ty::F32 }));
    for var in colors {
        let color = value(Expr::Load(var));
        let above = value(Expr::Op { op: Op::Max, args: [color, zero, Value(0)] });
        let clamped = value(Expr::Op { op: Op::Min, args: [above, one, Value(0)] });
        body.extend([color, above, clamped].map(Stmt::Eval));
        body.push(Stmt::Store { var, value: clamped });
    }
}
