//! Clamping of the colours that programs write: those of vertices (GL 2.1, section 2.14.6), those of
//! fragments (section 3.11.2; `ARB_color_buffer_float`).

use crate::interface::{VARYING_BACK_COLOR, VARYING_COLOR, VARYING_TEX_COORD};
use rasterizer::ir::{Expr, Module, Op, Output, Stmt, Ty, Value};

/// Appends the clamp to [0, 1] of every colour that a vertex stage writes, front or back. Says whether
/// there are any.
pub(crate) fn clamp_vertex_colors(module: &mut Module) -> bool {
    clamp_outputs(module, |output| match output {
        Output::Varying(slot) => {
            (VARYING_COLOR..VARYING_TEX_COORD).contains(&slot)
                || (VARYING_BACK_COLOR..VARYING_BACK_COLOR + 8).contains(&slot)
        }
        Output::Position(_)
        | Output::PointSize
        | Output::ClipDistance(_)
        | Output::CullDistance(_)
        | Output::Color { .. }
        | Output::SecondColor(_)
        | Output::Depth
        | Output::StencilReference
        | Output::SampleMask
        | Output::Layer
        | Output::PrimitiveId
        | Output::ViewportIndex => false,
    })
}

/// Appends the clamp to [0, 1] of every colour that a fragment stage writes; integers stay.
pub(crate) fn clamp_fragment_colors(module: &mut Module) {
    clamp_outputs(module, |output| matches!(output, Output::Color { .. } | Output::SecondColor(_)));
}

/// Appends the clamp of outputs that are floats. Says whether there are any.
fn clamp_outputs(module: &mut Module, is_color: impl Fn(Output) -> bool) -> bool {
    let colors = module.outputs.iter().filter(|(output, _)| is_color(*output));
    let mut colors: Vec<_> = colors.map(|(_, var)| *var).collect();
    // One variable may be the colour of several targets.
    colors.sort_unstable();
    colors.dedup();
    let Module { values, variables, body, .. } = module;
    colors.retain(|var| variables[var.0 as usize].ty == Ty::F32);
    let mut value = |expr| {
        values.push(expr);
        Value(values.len() as u32 - 1)
    };
    let [zero, one] =
        [0.0_f32, 1.0].map(|number| value(Expr::Const { bits: number.to_bits(), ty: Ty::F32 }));
    for &var in &colors {
        let color = value(Expr::Load(var));
        let above = value(Expr::Op { op: Op::Max, args: [color, zero, Value(0)] });
        let clamped = value(Expr::Op { op: Op::Min, args: [above, one, Value(0)] });
        body.extend([color, above, clamped].map(Stmt::Eval));
        body.push(Stmt::Store { var, value: clamped });
    }
    !colors.is_empty()
}
