//! Control flow: blocks, branches, loops and scopes, with masks where lanes diverge.

use super::Lowering;
use crate::ir::{Block, Stmt, Value};
use crate::shader::exits::{continues, may_empty};
use crate::shader::inst::{Inst, Slot, Target, Test, When};

/// A loop that is open.
pub(super) enum OpenLoop {
    /// Lanes that left the loop or the iteration are in these slots.
    Masked { exit: Slot, next: Slot },
    /// All lanes leave at once: the jumps to the end of the loop, and to the end of its body.
    Uniform { breaks: Vec<usize>, continues: Vec<usize> },
}

/// A scope that is open.
pub(super) enum OpenScope {
    Masked(Slot),
    /// The jumps to its end.
    Uniform(Vec<usize>),
}

/// An exit of the innermost loop, its body, or the innermost scope.
#[derive(Clone, Copy)]
enum ExitKind {
    Break,
    Continue,
    Leave,
}

impl ExitKind {
    fn of(stmt: &Stmt) -> Option<Self> {
        match stmt {
            Stmt::Break => Some(Self::Break),
            Stmt::Continue => Some(Self::Continue),
            Stmt::Leave => Some(Self::Leave),
            Stmt::Eval(_)
            | Stmt::Store { .. }
            | Stmt::StoreAt { .. }
            | Stmt::If { .. }
            | Stmt::Loop { .. }
            | Stmt::Scope(_)
            | Stmt::Discard
            | Stmt::EmitVertex(_)
            | Stmt::EndPrimitive => None,
        }
    }
}

/// How lanes take an exit.
enum Exit<'a> {
    /// The lanes move to this slot.
    Slot(Slot),
    /// All lanes by a jump, which is recorded here.
    Jump(&'a mut Vec<usize>),
}

/// Where every lane that still belongs to the innermost loop executes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct LoopPosition {
    nesting: u32,
    scopes: usize,
}

impl Lowering<'_> {
    /// Lowers a block whose lanes join at the next [`Self::join`].
    fn nested(&mut self, block: &Block) {
        self.joins.push(Vec::new());
        self.nesting += 1;
        self.block(block);
        self.nesting -= 1;
    }

    pub(super) fn block(&mut self, block: &Block) {
        for (i, stmt) in block.iter().enumerate() {
            let start = self.out.code.len();
            match stmt {
                Stmt::Eval(value) => self.eval(*value),
                Stmt::Store { var, value } => {
                    let (from, out) = (self.value(*value), self.variable(*var));
                    let outermost = self.outermost.wrapping_sub(1);
                    let is_maskless = self.loop_position == Some(self.position())
                        && self.maskless_stores.by_loop(*var, outermost);
                    if is_maskless || self.uniformity.variable(*var) {
                        // Other lanes do not read the variable again.
                        self.emit(Inst::Move { out, from });
                    } else {
                        self.store(out, from);
                    }
                }
                Stmt::StoreAt { var, index, value } => self.store_at(*var, *index, *value),
                Stmt::If { condition, accept, reject } => self.branch(*condition, accept, reject),
                Stmt::Loop { body, continuing } => self.repeat(body, continuing),
                Stmt::Scope(body) => self.scope(body),
                Stmt::EmitVertex(values) => {
                    let values = values.iter().map(|value| self.value(*value)).collect();
                    self.emit(Inst::EmitVertex(values));
                }
                Stmt::EndPrimitive => {
                    self.emit(Inst::EndPrimitive);
                }
                Stmt::Break => return self.leave(ExitKind::Break),
                Stmt::Continue => return self.leave(ExitKind::Continue),
                Stmt::Leave => return self.leave(ExitKind::Leave),
                Stmt::Discard => {
                    self.straight = false;
                    self.out.discards = true;
                    self.emit(Inst::Discard);
                    return;
                }
            }
            let removes_lanes = self.out.code[start..].iter().any(Inst::removes_lanes);
            if i + 1 < block.len() && removes_lanes && may_empty(stmt) {
                let jump = self.emit(Inst::SkipEmpty { to: Target(0) });
                if let Some(join) = self.joins.last_mut() {
                    join.push(jump);
                }
            }
        }
    }

    fn position(&self) -> LoopPosition {
        LoopPosition { nesting: self.nesting, scopes: self.scopes.len() }
    }

    fn exit(&mut self, kind: ExitKind) -> Option<Exit<'_>> {
        Some(match kind {
            ExitKind::Break => match self.loops.last_mut()? {
                OpenLoop::Masked { exit, .. } => Exit::Slot(*exit),
                OpenLoop::Uniform { breaks, .. } => Exit::Jump(breaks),
            },
            ExitKind::Continue => match self.loops.last_mut()? {
                OpenLoop::Masked { next, .. } => Exit::Slot(*next),
                OpenLoop::Uniform { continues, .. } => Exit::Jump(continues),
            },
            ExitKind::Leave => match self.scopes.last_mut()? {
                OpenScope::Masked(slot) => {
                    self.straight = false;
                    Exit::Slot(*slot)
                }
                OpenScope::Uniform(leaves) => Exit::Jump(leaves),
            },
        })
    }

    fn leave(&mut self, kind: ExitKind) {
        let here = self.out.code.len();
        let inst = match self.exit(kind) {
            Some(Exit::Slot(slot)) => Inst::Leave { slot },
            Some(Exit::Jump(jumps)) => {
                jumps.push(here);
                Inst::Jump { to: Target(0) }
            }
            None => return,
        };
        self.emit(inst);
    }

    fn scope(&mut self, body: &Block) {
        let number = self.next_scope;
        self.next_scope += 1;
        self.joins.push(Vec::new());
        let straight = self.straight;
        if self.uniformity.is_uniform_scope(number) {
            self.scopes.push(OpenScope::Uniform(Vec::new()));
            self.block(body);
            self.join();
            if let Some(OpenScope::Uniform(leaves)) = self.scopes.pop() {
                leaves.into_iter().for_each(|jump| self.land(jump));
            }
            return;
        }
        let slot = self.slot();
        self.emit(Inst::Open { slot });
        self.scopes.push(OpenScope::Masked(slot));
        self.block(body);
        self.straight = straight && !self.out.discards;
        self.scopes.pop();
        self.join();
        self.emit(Inst::Join { slot });
        self.slots -= 1;
    }

    fn branch(&mut self, condition: Value, accept: &Block, reject: &Block) {
        if let Some(word) = self.out.preamble.word(self.module, condition) {
            return self.uniform_branch(Test::Word(word), accept, reject);
        }
        let is_uniform = self.uniformity.value(self.module, condition);
        let condition = self.value(condition);
        if is_uniform {
            return self.uniform_branch(Test::Lanes(condition), accept, reject);
        }
        if let Some((when, slot)) = self.exit_branch(accept, reject) {
            self.emit(Inst::LeaveIf { condition, when, slot });
            return;
        }
        let slot = self.slot();
        let branch = self.emit(Inst::If { condition, slot, reject: Target(0) });
        self.nested(accept);
        self.join();
        if reject.is_empty() {
            self.land(branch);
        } else {
            let skip = self.emit(Inst::Else { slot, end: Target(0) });
            self.land(branch);
            self.nested(reject);
            self.join();
            self.land(skip);
        }
        self.emit(Inst::Join { slot });
        self.slots -= 1;
    }

    /// A uniform branch: no mask is read.
    fn uniform_branch(&mut self, test: Test, accept: &Block, reject: &Block) {
        let branch = self.emit(Inst::Unless { test, to: Target(0) });
        if let ([], [jump]) = (&accept[..], &reject[..])
            && let Some(kind) = ExitKind::of(jump)
            && let Some(Exit::Jump(jumps)) = self.exit(kind)
        {
            jumps.push(branch);
            return;
        }
        self.uniform_block(accept);
        if reject.is_empty() {
            self.land(branch);
        } else {
            let skip = self.emit(Inst::Jump { to: Target(0) });
            self.land(branch);
            self.uniform_block(reject);
            self.land(skip);
        }
    }

    /// A block that all lanes execute or none.
    fn uniform_block(&mut self, block: &Block) {
        self.joins.push(Vec::new());
        self.block(block);
        self.join();
    }

    /// The condition and the slot of a branch that does nothing but exit.
    fn exit_branch(&mut self, accept: &Block, reject: &Block) -> Option<(When, Slot)> {
        let (when, jump) = match (&accept[..], &reject[..]) {
            ([jump], []) => (When::Holds, jump),
            ([], [jump]) => (When::Fails, jump),
            _ => return None,
        };
        match self.exit(ExitKind::of(jump)?)? {
            Exit::Slot(slot) => Some((when, slot)),
            Exit::Jump(_) => None,
        }
    }

    fn repeat(&mut self, body: &Block, continuing: &Block) {
        let number = self.next_loop;
        self.next_loop += 1;
        let is_outermost = self.loops.is_empty();
        self.outermost += u32::from(is_outermost);
        if self.uniformity.is_uniform_loop(number) {
            return self.uniform_loop(body, continuing);
        }
        let (exit, next) = (self.slot(), self.slot());
        self.emit(Inst::Open { slot: exit });
        self.emit(Inst::Open { slot: next });
        let head = self.here();
        self.loops.push(OpenLoop::Masked { exit, next });
        let inside = LoopPosition { nesting: self.nesting + 1, ..self.position() };
        let position = (is_outermost && !continues(body)).then_some(inside);
        let outside = std::mem::replace(&mut self.loop_position, position);
        self.nested(body);
        self.join();
        self.emit(Inst::Join { slot: next });
        self.joins.push(Vec::new());
        if !continuing.is_empty() {
            let skip = self.emit(Inst::SkipEmpty { to: Target(0) });
            if let Some(join) = self.joins.last_mut() {
                join.push(skip);
            }
        }
        self.nesting += 1;
        self.block(continuing);
        self.nesting -= 1;
        self.join();
        self.loop_position = outside;
        self.loops.pop();
        self.emit(Inst::EndIteration { head, exit });
        self.slots -= 2;
    }

    /// A loop that all lanes iterate equally often.
    fn uniform_loop(&mut self, body: &Block, continuing: &Block) {
        let head = self.here();
        self.loops.push(OpenLoop::Uniform { breaks: Vec::new(), continues: Vec::new() });
        self.uniform_block(body);
        if let Some(OpenLoop::Uniform { continues, .. }) = self.loops.last_mut() {
            let jumps = std::mem::take(continues);
            jumps.into_iter().for_each(|jump| self.land(jump));
        }
        self.uniform_block(continuing);
        self.emit(Inst::Repeat { head });
        if let Some(OpenLoop::Uniform { breaks, .. }) = self.loops.pop() {
            breaks.into_iter().for_each(|jump| self.land(jump));
        }
    }
}
