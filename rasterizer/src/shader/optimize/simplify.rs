//! One walk in program order that simplifies each value with all that is known where it stands.

use super::super::Facts;
use super::common::Common;
use super::fold::{Folded, fold};
use super::forward::Memory;
use super::unroll;
use crate::ir::{Block, Expr, Module, Stmt, Ty, Value};

/// How many statements the copies of all loops may have.
const UNROLLED: usize = 4096;

/// Runs the pass.
pub(super) fn run(module: &mut Module, facts: &Facts) {
    let body = std::mem::take(&mut module.body);
    let mut walk = Walk {
        replacement: (0..module.values.len() as u32).map(Value).collect(),
        common: Common::default(),
        memory: Memory::new(Vec::new()),
        statement_budget: UNROLLED,
        facts,
        module,
    };
    for at in 0..walk.module.values.len() {
        if walk.module.values[at].is_everywhere() {
            walk.share(Value(at as u32));
        }
    }
    // Variables start as zero.
    let zero = [Ty::F32, Ty::I32, Ty::U32, Ty::Bool].map(|ty| (ty, walk.constant(0, ty)));
    let known = walk.module.variables.iter().map(|variable| {
        zero.iter().find(|(ty, _)| variable.len == 1 && *ty == variable.ty).map(|(_, zero)| *zero)
    });
    walk.memory = Memory::new(known.collect());
    let mut out = Vec::with_capacity(body.len());
    walk.block(body, &mut out);
    walk.module.body = out;
}

struct Walk<'a> {
    module: &'a mut Module,
    /// By value: the one to use in its place.
    replacement: Vec<Value>,
    memory: Memory,
    common: Common,
    /// How many statements unrolled loops may still add.
    statement_budget: usize,
    /// What is known of the draw.
    facts: &'a Facts,
}

impl Walk<'_> {
    fn constant(&mut self, bits: u32, ty: Ty) -> Value {
        let value = Value(self.module.values.len() as u32);
        self.module.values.push(Expr::Const { bits, ty });
        self.replacement.push(value);
        self.share(value);
        self.replacement[value.0 as usize]
    }

    /// Replaces a value by an equal earlier one; returns whether there is one.
    fn share(&mut self, value: Value) -> bool {
        let found = self.common.find(self.module.expr(value), value);
        if let Some(found) = found {
            self.replacement[value.0 as usize] = found;
        }
        found.is_some()
    }

    fn replacement(&self, value: Value) -> Value {
        self.replacement[value.0 as usize]
    }

    /// Appends what is left of a block to `out`.
    fn block(&mut self, block: Block, out: &mut Block) {
        for stmt in block {
            match stmt {
                Stmt::Eval(value) => {
                    if self.eval(value) {
                        out.push(stmt);
                    }
                }
                Stmt::Store { var, value } => {
                    let value = self.replacement(value);
                    if self.memory.get(var) != Some(value) {
                        self.memory.stored(var, value);
                        out.push(Stmt::Store { var, value });
                    }
                }
                Stmt::StoreAt { var, index, value } => {
                    let (index, value) = (self.replacement(index), self.replacement(value));
                    out.push(Stmt::StoreAt { var, index, value });
                }
                Stmt::If { condition, accept, reject } => {
                    self.branch(condition, accept, reject, out);
                }
                Stmt::Loop { body, continuing } => {
                    if let Some(copies) = self.unroll([&body, &continuing]) {
                        self.block(copies, out);
                        if out.last().is_some_and(Stmt::is_jump) {
                            return;
                        }
                        continue;
                    }
                    self.memory.forget_stores([&body, &continuing]);
                    let body = self.nested(body);
                    let continuing = self.nested(continuing);
                    out.push(Stmt::Loop { body, continuing });
                }
                Stmt::Scope(body) => {
                    let start = self.memory.mark();
                    let body = self.nested(body);
                    self.memory.forget(start, self.memory.mark());
                    out.push(Stmt::Scope(body));
                }
                Stmt::EmitVertex(values) => {
                    let values = values.into_iter().map(|value| self.replacement(value)).collect();
                    out.push(Stmt::EmitVertex(values));
                }
                Stmt::Break | Stmt::Continue | Stmt::Leave | Stmt::Discard | Stmt::EndPrimitive => {
                    out.push(stmt)
                }
            }
            if out.last().is_some_and(Stmt::is_jump) {
                return;
            }
        }
    }

    /// The iterations of a loop one after the other, if they can be counted.
    fn unroll(&mut self, blocks: [&Block; 2]) -> Option<Block> {
        let (replacement, memory) = (&self.replacement, &self.memory);
        let constant =
            |module: &Module, value: Value| module.constant(replacement[value.0 as usize]);
        let variable =
            |module: &Module, var| memory.get(var).and_then(|value| constant(module, value));
        let copies = unroll::run(self.module, blocks, self.statement_budget, constant, variable)?;
        self.statement_budget -= copies.len().min(self.statement_budget);
        let old = self.replacement.len() as u32;
        self.replacement.extend((old..self.module.values.len() as u32).map(Value));
        Some(copies)
    }

    /// A block of its own: what becomes known in it is forgotten at its end.
    fn nested(&mut self, block: Block) -> Block {
        let (memory, common) = (self.memory.mark(), self.common.mark());
        let mut out = Vec::with_capacity(block.len());
        self.block(block, &mut out);
        self.memory.undo(memory);
        self.common.undo(common);
        out
    }

    fn branch(&mut self, condition: Value, accept: Block, reject: Block, out: &mut Block) {
        let condition = self.replacement(condition);
        if let Some(bits) = self.module.constant(condition) {
            return self.block(if bits == 0 { reject } else { accept }, out);
        }
        let start = self.memory.mark();
        let accept = self.nested(accept);
        let middle = self.memory.mark();
        let reject = self.nested(reject);
        let end = self.memory.mark();
        // Lanes that jumped away do not come back with what they stored.
        if !accept.last().is_some_and(Stmt::is_jump) {
            self.memory.forget(start, middle);
        }
        if !reject.last().is_some_and(Stmt::is_jump) {
            self.memory.forget(middle, end);
        }
        if !accept.is_empty() || !reject.is_empty() {
            out.push(Stmt::If { condition, accept, reject });
        }
    }

    /// Simplifies a value; says whether it must still be evaluated.
    fn eval(&mut self, value: Value) -> bool {
        let at = value.0 as usize;
        let expr = self.module.values[at].map(&mut |operand| self.replacement(operand));
        let expr = match expr {
            Expr::Load(var) => {
                if let Some(known) = self.memory.get(var) {
                    self.replacement[at] = known;
                    return false;
                }
                self.memory.loaded(var, value);
                return true;
            }
            Expr::Op { op, args } => match fold(self.module, self.facts, op, args) {
                Folded::Const(bits) => Expr::Const { bits, ty: op.result() },
                Folded::Value(value) => {
                    self.replacement[at] = value;
                    return false;
                }
                Folded::Op(op) => Expr::Op { op, args },
                Folded::Unchanged => expr,
            },
            Expr::UniformAt { base, len, index, ty } => match self.module.constant(index) {
                Some(bits) => Expr::Uniform { word: base + bits.min(len - 1), ty },
                None => expr,
            },
            Expr::LoadAt { .. } => {
                self.module.values[at] = expr;
                return true;
            }
            Expr::Component { sample, component }
                if self.facts.is_opaque_alpha(self.module, sample, component) =>
            {
                Expr::Const { bits: 1.0_f32.to_bits(), ty: Ty::F32 }
            }
            Expr::Tabulated { value, ref table } => match self.module.constant(value) {
                Some(bits) => Expr::Const { bits: table.word(f32::from_bits(bits)), ty: Ty::F32 },
                None => expr,
            },
            Expr::Const { .. }
            | Expr::Input(_)
            | Expr::Uniform { .. }
            | Expr::Derivative { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => expr,
        };
        let everywhere = expr.is_everywhere();
        self.module.values[at] = expr;
        !self.share(value) && !everywhere
    }
}
