//! What is known of variables at a place of the walk: store-to-load forwarding.
//!
//! Sound with masks: the lanes that reach a load have all passed the last store before it in the
//! same or an enclosing block, as lanes only ever drop out of a block. Whatever a nested block
//! stored is forgotten where the block ends; whatever a loop stores anywhere, where it begins.

use crate::ir::{Block, Stmt, Value, Var};

/// The variables of length 1.
pub(super) struct Memory {
    /// By variable: the value it holds.
    known: Vec<Option<Value>>,
    /// What `known` was before each change, to be undone where a block ends.
    log: Vec<(Var, Option<Value>)>,
    /// Every variable stored so far.
    stored: Vec<Var>,
}

/// A place in the walk.
#[derive(Clone, Copy)]
pub(super) struct Mark {
    log: usize,
    stored: usize,
}

impl Memory {
    pub fn new(known: Vec<Option<Value>>) -> Self {
        Self { known, log: Vec::new(), stored: Vec::new() }
    }

    pub fn get(&self, var: Var) -> Option<Value> {
        self.known[var.0 as usize]
    }

    /// The variable was seen to hold a value.
    pub fn loaded(&mut self, var: Var, value: Value) {
        self.set(var, Some(value));
    }

    pub fn stored(&mut self, var: Var, value: Value) {
        self.set(var, Some(value));
        self.stored.push(var);
    }

    fn set(&mut self, var: Var, value: Option<Value>) {
        let known = &mut self.known[var.0 as usize];
        self.log.push((var, *known));
        *known = value;
    }

    pub fn mark(&self) -> Mark {
        Mark { log: self.log.len(), stored: self.stored.len() }
    }

    /// Back to what was known at the mark.
    pub fn undo(&mut self, mark: Mark) {
        for (var, old) in self.log.drain(mark.log..).rev() {
            self.known[var.0 as usize] = old;
        }
    }

    /// Forgets what was stored between two marks.
    pub fn forget(&mut self, from: Mark, to: Mark) {
        for at in from.stored..to.stored {
            self.set(self.stored[at], None);
        }
    }

    /// Forgets whatever these blocks store.
    pub fn forget_stores(&mut self, blocks: [&Block; 2]) {
        for stmt in blocks.into_iter().flatten() {
            stmt.walk(&mut |stmt| {
                if let Stmt::Store { var, .. } = stmt {
                    self.set(*var, None);
                    self.stored.push(*var);
                }
            });
        }
    }
}
