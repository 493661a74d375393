//! Small branches become selects: computing both sides is cheaper than splitting the lanes.

use crate::ir::{Block, Expr, Module, Op, Stmt, Ty, Value, Var};

/// What splitting and joining the lanes costs, in simple operations.
const BRANCH: u32 = 10;

/// Runs the pass; returns whether it changed the module.
pub(super) fn run(module: &mut Module) -> bool {
    let body = std::mem::take(&mut module.body);
    let mut flatten = Flatten { module, changed: false };
    let body = flatten.block(body);
    let changed = flatten.changed;
    module.body = body;
    changed
}

struct Flatten<'a> {
    module: &'a mut Module,
    changed: bool,
}

impl Flatten<'_> {
    fn block(&mut self, block: Block) -> Block {
        let mut out = Vec::with_capacity(block.len());
        for stmt in block {
            match stmt {
                Stmt::If { condition, accept, reject } => {
                    let (accept, reject) = (self.block(accept), self.block(reject));
                    let cost = self.cost(&accept).zip(self.cost(&reject));
                    if cost.is_some_and(|(accept, reject)| accept + reject <= BRANCH) {
                        self.changed = true;
                        self.select(condition, BranchSide::Accept, accept, &mut out);
                        self.select(condition, BranchSide::Reject, reject, &mut out);
                    } else {
                        out.push(Stmt::If { condition, accept, reject });
                    }
                }
                Stmt::Loop { body, continuing } => out.push(Stmt::Loop {
                    body: self.block(body),
                    continuing: self.block(continuing),
                }),
                Stmt::Scope(body) => out.push(Stmt::Scope(self.block(body))),
                Stmt::Eval(_)
                | Stmt::Store { .. }
                | Stmt::StoreAt { .. }
                | Stmt::Break
                | Stmt::Continue
                | Stmt::Leave
                | Stmt::Discard
                | Stmt::EmitVertex(_)
                | Stmt::EndPrimitive => out.push(stmt),
            }
        }
        out
    }

    /// The cost of a block, if it can be computed in all lanes.
    fn cost(&self, block: &Block) -> Option<u32> {
        let costs = block.iter().map(|stmt| match stmt {
            Stmt::Eval(value) => match self.module.expr(*value) {
                Expr::Op { op, .. } => Some(op.cost()),
                Expr::Tabulated { table, .. } => Some(table.cost()),
                Expr::Load(_) => Some(0),
                Expr::Const { .. } | Expr::Input(_) | Expr::Uniform { .. } => Some(0),
                Expr::UniformAt { .. }
                | Expr::LoadAt { .. }
                | Expr::Derivative { .. }
                | Expr::Sample(_)
                | Expr::Component { .. } => None,
            },
            Stmt::Store { .. } => Some(1),
            Stmt::StoreAt { .. }
            | Stmt::If { .. }
            | Stmt::Loop { .. }
            | Stmt::Scope(_)
            | Stmt::Break
            | Stmt::Continue
            | Stmt::Leave
            | Stmt::Discard
            | Stmt::EmitVertex(_)
            | Stmt::EndPrimitive => None,
        });
        costs.sum()
    }

    fn select(&mut self, condition: Value, side: BranchSide, block: Block, out: &mut Block) {
        for stmt in block {
            let Stmt::Store { var, value } = stmt else {
                out.push(stmt);
                continue;
            };
            let old = self.eval(Expr::Load(var), out);
            let args = match side {
                BranchSide::Accept => [condition, value, old],
                BranchSide::Reject => [condition, old, value],
            };
            let value = self.eval(Expr::Op { op: self.select_of(var), args }, out);
            out.push(Stmt::Store { var, value });
        }
    }

    fn eval(&mut self, expr: Expr, out: &mut Block) -> Value {
        let value = Value(self.module.values.len() as u32);
        self.module.values.push(expr);
        out.push(Stmt::Eval(value));
        value
    }

    fn select_of(&self, var: Var) -> Op {
        match self.module.variable(var).ty {
            Ty::F32 => Op::SelectF,
            Ty::I32 => Op::SelectI,
            Ty::U32 => Op::SelectU,
            Ty::Bool => Op::SelectB,
        }
    }
}

#[derive(Clone, Copy)]
enum BranchSide {
    Accept,
    Reject,
}
