//! Listings of modules, for traces and tests.
//!
//! Values are `%n`, variables `vn`; constants, inputs and uniform words are printed inline.

use super::{
    Access, Axis, Block, Expr, FunctionTable, GeometryInterface, Lod, Module, Sample, Stmt, Ty,
    Value, Var,
};
use std::fmt::{Display, Formatter, Result};

impl Display for Module {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        writeln!(f, "{:?}", self.stage)?;
        if let Some(GeometryInterface { input, output, max_vertices, outputs }) = &self.geometry {
            writeln!(
                f,
                "  {input:?} to {output:?}, at most {max_vertices} vertices of {outputs:?}"
            )?;
        }
        for (slot, decl) in self.textures.iter().enumerate() {
            writeln!(f, "  texture {slot}: {decl:?}")?;
        }
        for (at, variable) in self.variables.iter().enumerate() {
            let (ty, name) = (variable.ty, &variable.name);
            match variable.len {
                1 => writeln!(f, "  v{at}: {ty:?} // {name}")?,
                len => writeln!(f, "  v{at}: {ty:?}[{len}] // {name}")?,
            }
        }
        block(f, self, &self.body, 1)?;
        for (output, var) in &self.outputs {
            writeln!(f, "  {output:?} = v{}", var.0)?;
        }
        Ok(())
    }
}

/// A value as an operand.
struct Operand<'a>(&'a Module, Value);

impl Display for Operand<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let Self(module, value) = *self;
        match module.values.get(value.0 as usize) {
            Some(Expr::Const { bits, ty }) => match ty {
                Ty::F32 => write!(f, "{:?}", f32::from_bits(*bits)),
                Ty::I32 => write!(f, "{}", *bits as i32),
                Ty::U32 => write!(f, "{bits}u"),
                Ty::Bool => write!(f, "{}", *bits != 0),
            },
            Some(Expr::Input(input)) => write!(f, "{input:?}"),
            Some(Expr::Uniform { word, .. }) => write!(f, "uniform[{word}]"),
            _ => write!(f, "%{}", value.0),
        }
    }
}

/// Several values as operands.
struct Operands<'a>(&'a Module, &'a [Value]);

impl Display for Operands<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        for (at, value) in self.1.iter().enumerate() {
            write!(f, "{}{}", if at == 0 { "" } else { ", " }, Operand(self.0, *value))?;
        }
        Ok(())
    }
}

/// A whole variable, or the element at an index.
fn place(f: &mut Formatter<'_>, module: &Module, var: Var, index: Option<Value>) -> Result {
    match index {
        None => write!(f, "v{}", var.0),
        Some(index) => write!(f, "v{}[{}]", var.0, Operand(module, index)),
    }
}

fn expr(f: &mut Formatter<'_>, module: &Module, value: Value) -> Result {
    match module.values.get(value.0 as usize) {
        None | Some(Expr::Const { .. } | Expr::Input(_) | Expr::Uniform { .. }) => {
            write!(f, "{}", Operand(module, value))
        }
        Some(Expr::UniformAt { base, len, index, .. }) => {
            write!(f, "uniform[{base}..{}][{}]", base.saturating_add(*len), Operand(module, *index))
        }
        Some(Expr::Load(var)) => place(f, module, *var, None),
        Some(Expr::LoadAt { var, index }) => place(f, module, *var, Some(*index)),
        Some(Expr::Op { op, args }) => {
            write!(f, "{} {}", op.name(), Operands(module, &args[..op.args().len()]))
        }
        Some(Expr::Derivative { axis: Axis::X, value }) => {
            write!(f, "d/dx {}", Operand(module, *value))
        }
        Some(Expr::Derivative { axis: Axis::Y, value }) => {
            write!(f, "d/dy {}", Operand(module, *value))
        }
        Some(Expr::Tabulated { value, table }) => match table {
            FunctionTable::OfByte(_) => write!(f, "table of byte {}", Operand(module, *value)),
            FunctionTable::Power(power) => {
                write!(f, "power {:?} {}", power.exponent(), Operand(module, *value))
            }
        },
        Some(Expr::Sample(sample)) => self::sample(f, module, sample),
        Some(Expr::Component { sample, component }) => write!(f, "%{}.{component}", sample.0),
    }
}

fn sample(f: &mut Formatter<'_>, module: &Module, sample: &Sample) -> Result {
    let (name, offset) = match sample.access {
        Access::Filter { offset } => ("sample", offset),
        Access::Gather { offset: [s, t] } => ("gather", [s, t, 0]),
        Access::Fetch { offset } => ("fetch", offset),
        Access::Size => ("size", [0; 3]),
        Access::Lod => ("lod of", [0; 3]),
    };
    write!(f, "{name} {}, ({})", sample.texture.0, Operands(module, &sample.coords))?;
    if offset != [0; 3] {
        write!(f, ", offset {offset:?}")?;
    }
    if let Some(layer) = sample.layer {
        write!(f, ", layer {}", Operand(module, layer))?;
    }
    if let Some(reference) = sample.reference {
        write!(f, ", compare {}", Operand(module, reference))?;
    }
    match sample.lod {
        Lod::Implicit { bias: None } => Ok(()),
        Lod::Implicit { bias: Some(bias) } => write!(f, ", bias {}", Operand(module, bias)),
        Lod::Explicit(lod) => write!(f, ", lod {}", Operand(module, lod)),
        Lod::Gradient { dx, dy, bias } => {
            write!(f, ", dx ({}), dy ({})", Operands(module, &dx), Operands(module, &dy))?;
            bias.map_or(Ok(()), |bias| write!(f, ", bias {}", Operand(module, bias)))
        }
    }
}

fn block(f: &mut Formatter<'_>, module: &Module, stmts: &Block, depth: usize) -> Result {
    let indent = "  ".repeat(depth);
    for stmt in stmts {
        write!(f, "{indent}")?;
        match stmt {
            Stmt::Eval(value) => {
                write!(f, "%{} = ", value.0)?;
                expr(f, module, *value)?;
                writeln!(f)?;
            }
            Stmt::Store { var, value } => {
                place(f, module, *var, None)?;
                writeln!(f, " = {}", Operand(module, *value))?;
            }
            Stmt::StoreAt { var, index, value } => {
                place(f, module, *var, Some(*index))?;
                writeln!(f, " = {}", Operand(module, *value))?;
            }
            Stmt::If { condition, accept, reject } => {
                writeln!(f, "if {} {{", Operand(module, *condition))?;
                block(f, module, accept, depth + 1)?;
                if !reject.is_empty() {
                    writeln!(f, "{indent}}} else {{")?;
                    block(f, module, reject, depth + 1)?;
                }
                writeln!(f, "{indent}}}")?;
            }
            Stmt::Loop { body, continuing } => {
                writeln!(f, "loop {{")?;
                block(f, module, body, depth + 1)?;
                if !continuing.is_empty() {
                    writeln!(f, "{indent}}} continuing {{")?;
                    block(f, module, continuing, depth + 1)?;
                }
                writeln!(f, "{indent}}}")?;
            }
            Stmt::Scope(body) => {
                writeln!(f, "scope {{")?;
                block(f, module, body, depth + 1)?;
                writeln!(f, "{indent}}}")?;
            }
            Stmt::Break => writeln!(f, "break")?,
            Stmt::Continue => writeln!(f, "continue")?,
            Stmt::Leave => writeln!(f, "leave")?,
            Stmt::Discard => writeln!(f, "discard")?,
            Stmt::EmitVertex(values) => writeln!(f, "emit {}", Operands(module, values))?,
            Stmt::EndPrimitive => writeln!(f, "end primitive")?,
        }
    }
    Ok(())
}
