//! Control flow: blocks, branches, loops and scopes, with masks where lanes go different ways.

use super::Lowering;
use crate::ir::{Block, Stmt, Value};
use crate::shader::exits::{continues, may_empty};
use crate::shader::inst::{Inst, Slot, Target, Test, When};

/// A loop that is open.
pub(super) enum OpenLoop {
    /// Lanes wait in these slots.
    Masked { exit: Slot, again: Slot },
    /// Lanes leave together: the jumps to its end, and to the end of its body.
    Alike { breaks: Vec<usize>, continues: Vec<usize> },
}

/// A scope that is open.
pub(super) enum OpenScope {
    Masked(Slot),
    /// The jumps to its end.
    Alike(Vec<usize>),
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
            | Stmt::Discard => None,
        }
    }
}

/// How lanes take an exit.
enum Exit<'a> {
    /// To this slot, each lane at its own time.
    To(Slot),
    /// All by a jump, of which note is taken here.
    Together(&'a mut Vec<usize>),
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
                    let owned =
                        self.turn == Some(self.place()) && self.owned.by_loop(*var, outermost);
                    if owned || self.alike.variable(*var) {
                        // The other lanes never come back to where the variable is read.
                        self.emit(Inst::Move { out, from });
                    } else {
                        self.store(out, from);
                    }
                }
                Stmt::StoreAt { var, index, value } => self.store_at(*var, *index, *value),
                Stmt::If { condition, accept, reject } => self.branch(*condition, accept, reject),
                Stmt::Loop { body, continuing } => self.repeat(body, continuing),
                Stmt::Scope(body) => self.scope(body),
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
            let empties = self.out.code[start..].iter().any(Inst::empties);
            if i + 1 < block.len() && empties && may_empty(stmt) {
                let jump = self.emit(Inst::SkipEmpty { to: Target(0) });
                if let Some(join) = self.joins.last_mut() {
                    join.push(jump);
                }
            }
        }
    }

    fn place(&self) -> LoopPosition {
        LoopPosition { nesting: self.nesting, scopes: self.scopes.len() }
    }

    fn exit(&mut self, way: ExitKind) -> Option<Exit<'_>> {
        Some(match way {
            ExitKind::Break => match self.loops.last_mut()? {
                OpenLoop::Masked { exit, .. } => Exit::To(*exit),
                OpenLoop::Alike { breaks, .. } => Exit::Together(breaks),
            },
            ExitKind::Continue => match self.loops.last_mut()? {
                OpenLoop::Masked { again, .. } => Exit::To(*again),
                OpenLoop::Alike { continues, .. } => Exit::Together(continues),
            },
            ExitKind::Leave => match self.scopes.last_mut()? {
                OpenScope::Masked(slot) => {
                    self.straight = false;
                    Exit::To(*slot)
                }
                OpenScope::Alike(leaves) => Exit::Together(leaves),
            },
        })
    }

    fn leave(&mut self, way: ExitKind) {
        let here = self.out.code.len();
        let inst = match self.exit(way) {
            Some(Exit::To(slot)) => Inst::Leave { slot },
            Some(Exit::Together(jumps)) => {
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
        if self.alike.scope(number) {
            self.scopes.push(OpenScope::Alike(Vec::new()));
            self.block(body);
            self.join();
            if let Some(OpenScope::Alike(leaves)) = self.scopes.pop() {
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
            return self.branch_together(Test::Word(word), accept, reject);
        }
        let alike = self.alike.value(self.module, condition);
        let condition = self.value(condition);
        if alike {
            return self.branch_together(Test::Lanes(condition), accept, reject);
        }
        if let Some((when, slot)) = self.way_out(accept, reject) {
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
    fn branch_together(&mut self, test: Test, accept: &Block, reject: &Block) {
        let branch = self.emit(Inst::Unless { test, to: Target(0) });
        if let ([], [jump]) = (&accept[..], &reject[..])
            && let Some(way) = ExitKind::of(jump)
            && let Some(Exit::Together(jumps)) = self.exit(way)
        {
            jumps.push(branch);
            return;
        }
        self.side(accept);
        if reject.is_empty() {
            self.land(branch);
        } else {
            let skip = self.emit(Inst::Jump { to: Target(0) });
            self.land(branch);
            self.side(reject);
            self.land(skip);
        }
    }

    /// A side of a uniform branch.
    fn side(&mut self, block: &Block) {
        self.joins.push(Vec::new());
        self.block(block);
        self.join();
    }

    /// Where a branch that does nothing but leave sends its lanes.
    fn way_out(&mut self, accept: &Block, reject: &Block) -> Option<(When, Slot)> {
        let (when, jump) = match (&accept[..], &reject[..]) {
            ([jump], []) => (When::Holds, jump),
            ([], [jump]) => (When::Fails, jump),
            _ => return None,
        };
        match self.exit(ExitKind::of(jump)?)? {
            Exit::To(slot) => Some((when, slot)),
            Exit::Together(_) => None,
        }
    }

    fn repeat(&mut self, body: &Block, continuing: &Block) {
        let number = self.next_loop;
        self.next_loop += 1;
        let lone = self.loops.is_empty();
        self.outermost += u32::from(lone);
        if self.alike.turns(number) {
            return self.repeat_together(body, continuing);
        }
        let (exit, again) = (self.slot(), self.slot());
        self.emit(Inst::Open { slot: exit });
        self.emit(Inst::Open { slot: again });
        let head = self.here();
        self.loops.push(OpenLoop::Masked { exit, again });
        let inside = LoopPosition { nesting: self.nesting + 1, ..self.place() };
        let turn = (lone && !continues(body)).then_some(inside);
        let outside = std::mem::replace(&mut self.turn, turn);
        self.nested(body);
        self.join();
        self.emit(Inst::Join { slot: again });
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
        self.turn = outside;
        self.loops.pop();
        self.emit(Inst::Again { head, exit });
        self.slots -= 2;
    }

    /// A loop that all lanes iterate equally often.
    fn repeat_together(&mut self, body: &Block, continuing: &Block) {
        let head = self.here();
        self.loops.push(OpenLoop::Alike { breaks: Vec::new(), continues: Vec::new() });
        self.side(body);
        if let Some(OpenLoop::Alike { continues, .. }) = self.loops.last_mut() {
            let jumps = std::mem::take(continues);
            jumps.into_iter().for_each(|jump| self.land(jump));
        }
        self.side(continuing);
        self.emit(Inst::Repeat { head });
        if let Some(OpenLoop::Alike { breaks, .. }) = self.loops.pop() {
            breaks.into_iter().for_each(|jump| self.land(jump));
        }
    }
}
