//! Selects between two varyings by the facing of the polygon, as two-sided light does, become one varying: the planes
//! of a polygon are those of the side that it shows, so that the other side is not interpolated.

use crate::ir::{Block, Expr, Input, Interpolation, Module, Op, Stmt, Value};

/// A varying of front faces whose planes are those of another varying at back faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SideVaryings {
    /// The slot that the fragment program reads.
    pub front: u16,
    /// The slot whose planes it has at back faces.
    pub back: u16,
}

/// Runs the pass on a finished fragment module. A varying that anything else reads, or whose gradient is read, keeps its
/// planes, and so does one that is not interpolated as its partner is.
pub(super) fn run(module: &mut Module) -> Vec<SideVaryings> {
    let mut reads = Reads { module, selects: Vec::new(), others: Vec::new() };
    reads.block(&module.body);
    let Reads { selects, others, .. } = reads;
    let is_merged = |select: &Select| {
        let SideVaryings { front, back } = select.sides;
        let has_one_back = |other: &Select| {
            other.sides.back != front && (other.sides.front != front || other.sides.back == back)
        };
        !others.contains(&front)
            && selects.iter().all(has_one_back)
            && interpolation(module, front) == interpolation(module, back)
            && interpolation(module, front).0 != Interpolation::NoPerspective
    };
    let merged: Vec<Select> = selects.iter().filter(|select| is_merged(select)).copied().collect();
    for select in &merged {
        module.values[select.value.0 as usize] = Expr::Input(Input::Varying(select.sides.front));
    }
    remove_evaluations(&mut module.body, &merged);
    let mut sides: Vec<SideVaryings> = merged.iter().map(|select| select.sides).collect();
    sides.sort_unstable_by_key(|sides| sides.front);
    sides.dedup();
    sides
}

/// How a varying is interpolated: its mode, and whether at the centroid.
fn interpolation(module: &Module, slot: u16) -> (Interpolation, bool) {
    let mode = module.varyings.get(usize::from(slot)).copied();
    (mode.unwrap_or(Interpolation::Smooth), module.centroids.contains(&slot))
}

/// A value that selects between two varyings by facing.
#[derive(Clone, Copy)]
struct Select {
    value: Value,
    sides: SideVaryings,
}

/// Who reads varyings.
struct Reads<'a> {
    module: &'a Module,
    selects: Vec<Select>,
    /// The slots that are read otherwise.
    others: Vec<u16>,
}

impl Reads<'_> {
    fn block(&mut self, block: &Block) {
        for stmt in block {
            match stmt {
                Stmt::Eval(value) => self.evaluated(*value),
                Stmt::Store { value, .. } => self.read(*value),
                Stmt::StoreAt { index, value, .. } => {
                    self.read(*index);
                    self.read(*value);
                }
                Stmt::If { condition, .. } => self.read(*condition),
                Stmt::EmitVertex(values) => values.iter().for_each(|value| self.read(*value)),
                Stmt::Loop { .. }
                | Stmt::Scope(_)
                | Stmt::Break
                | Stmt::Continue
                | Stmt::Leave
                | Stmt::Discard
                | Stmt::EndPrimitive => {}
            }
            for inside in stmt.blocks() {
                self.block(inside);
            }
        }
    }

    fn evaluated(&mut self, value: Value) {
        let expr = self.module.expr(value);
        match self.sides(expr) {
            Some(sides) => self.selects.push(Select { value, sides }),
            None => expr.operands(|operand| self.read(operand)),
        }
    }

    /// The varyings that an expression selects from.
    fn sides(&self, expr: &Expr) -> Option<SideVaryings> {
        let Expr::Op { op: Op::SelectF, args } = expr else { return None };
        match args.map(|arg| self.module.expr(arg)) {
            [
                Expr::Input(Input::FrontFacing),
                Expr::Input(Input::Varying(front)),
                Expr::Input(Input::Varying(back)),
            ] => Some(SideVaryings { front: *front, back: *back }),
            _ => None,
        }
    }

    fn read(&mut self, value: Value) {
        if let Expr::Input(Input::Varying(slot) | Input::Gradient { slot, .. }) =
            self.module.expr(value)
        {
            self.others.push(*slot);
        }
    }
}

/// Removes the evaluations of values that are inputs now, which need none.
fn remove_evaluations(block: &mut Block, merged: &[Select]) {
    block.retain_mut(|stmt| match stmt {
        Stmt::Eval(value) => merged.iter().all(|select| select.value != *value),
        Stmt::If { accept: a, reject: b, .. } | Stmt::Loop { body: a, continuing: b } => {
            remove_evaluations(a, merged);
            remove_evaluations(b, merged);
            true
        }
        Stmt::Scope(body) => {
            remove_evaluations(body, merged);
            true
        }
        Stmt::Store { .. }
        | Stmt::StoreAt { .. }
        | Stmt::Break
        | Stmt::Continue
        | Stmt::Leave
        | Stmt::Discard
        | Stmt::EmitVertex(_)
        | Stmt::EndPrimitive => true,
    });
}
