//! Expressions that are evaluated already: common subexpressions, by scope.
//!
//! Only pure expressions take part; loads are [`super::forward`]'s.

use crate::ir::{Expr, Value};
use std::collections::HashMap;

/// The value of each expression that is available.
#[derive(Default)]
pub(super) struct Common {
    values: HashMap<Expr, Value>,
    /// What the open blocks have added, outermost first.
    added: Vec<Expr>,
}

impl Common {
    /// The earlier value of the expression; if there is none, `value` becomes it.
    pub fn find(&mut self, expr: &Expr, value: Value) -> Option<Value> {
        if let Some(&found) = self.values.get(expr) {
            return Some(found);
        }
        self.values.insert(expr.clone(), value);
        if !expr.is_everywhere() {
            self.added.push(expr.clone());
        }
        None
    }

    pub fn mark(&self) -> usize {
        self.added.len()
    }

    /// The block that was open since the mark has ended.
    pub fn undo(&mut self, mark: usize) {
        for expr in self.added.drain(mark..) {
            self.values.remove(&expr);
        }
    }
}
