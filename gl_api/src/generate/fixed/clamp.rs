//! Clamping of the colours that programs write: those of vertices (GL 2.1, section 2.14.6), those of
//! fragments (section 3.11.2; `ARB_color_buffer_float`).

use crate::interface::{VARYING_BACK_COLOR, VARYING_COLOR, VARYING_TEX_COORD};
use rasterizer::ir::{Block, Expr, Module, Op, Output, Stmt, Ty, Value};

/// Appends the clamp to [0, 1] of every colour that a vertex stage writes, front or back. Says whether
/// there are any.
pub(crate) fn clamp_vertex_colors(module: &mut Module) -> bool {
    clamp_outputs(module, is_vertex_color)
}

/// Clamps every colour that a geometry stage emits, front or back, to [0, 1] (GL 3.2, compatibility, section 2.20: the
/// last stage before the rasterizer). Says whether there are any.
pub(crate) fn clamp_emitted_colors(module: &mut Module) -> bool {
    let Some(interface) = &module.geometry else { return false };
    let outputs = interface.outputs.iter().enumerate();
    let colors: Vec<usize> =
        outputs.filter(|(_, output)| is_vertex_color(**output)).map(|(at, _)| at).collect();
    if colors.is_empty() {
        return false;
    }
    let mut body = std::mem::take(&mut module.body);
    let mut clamp = ClampValues::new(&mut module.values);
    clamp_emits(&mut body, &colors, &mut clamp);
    module.body = body;
    true
}

/// Puts the clamp of values in front of each statement that emits them.
fn clamp_emits(block: &mut Block, colors: &[usize], clamp: &mut ClampValues<'_>) {
    for mut stmt in std::mem::take(block) {
        match &mut stmt {
            Stmt::EmitVertex(values) => {
                for &at in colors {
                    let (evaluated, clamped) = clamp.append(values[at]);
                    block.extend(evaluated.map(Stmt::Eval));
                    values[at] = clamped;
                }
            }
            Stmt::If { accept, reject, .. } => {
                clamp_emits(accept, colors, clamp);
                clamp_emits(reject, colors, clamp);
            }
            Stmt::Loop { body, continuing } => {
                clamp_emits(body, colors, clamp);
                clamp_emits(continuing, colors, clamp);
            }
            Stmt::Scope(body) => clamp_emits(body, colors, clamp),
            Stmt::Eval(_)
            | Stmt::Store { .. }
            | Stmt::StoreAt { .. }
            | Stmt::Break
            | Stmt::Continue
            | Stmt::Leave
            | Stmt::Discard
            | Stmt::EndPrimitive => {}
        }
        block.push(stmt);
    }
}

/// Appends clamps to the values of a module.
struct ClampValues<'a> {
    values: &'a mut Vec<Expr>,
    zero: Value,
    one: Value,
}

impl<'a> ClampValues<'a> {
    fn new(values: &'a mut Vec<Expr>) -> Self {
        let [zero, one] = [0.0_f32, 1.0].map(|number| {
            values.push(Expr::Const { bits: number.to_bits(), ty: Ty::F32 });
            Value(values.len() as u32 - 1)
        });
        Self { values, zero, one }
    }

    fn push(&mut self, expr: Expr) -> Value {
        self.values.push(expr);
        Value(self.values.len() as u32 - 1)
    }

    /// What must be evaluated, in order, and the clamped value, the last of these.
    fn append(&mut self, color: Value) -> ([Value; 2], Value) {
        let above = self.push(Expr::Op { op: Op::Max, args: [color, self.zero, Value(0)] });
        let clamped = self.push(Expr::Op { op: Op::Min, args: [above, self.one, Value(0)] });
        ([above, clamped], clamped)
    }
}

fn is_vertex_color(output: Output) -> bool {
    match output {
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
    }
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
    let mut clamp = ClampValues::new(values);
    for &var in &colors {
        let color = clamp.push(Expr::Load(var));
        let ([above, _], clamped) = clamp.append(color);
        body.extend([color, above, clamped].map(Stmt::Eval));
        body.push(Stmt::Store { var, value: clamped });
    }
    !colors.is_empty()
}
