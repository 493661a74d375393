//! The variables that only one loop reads.
//!
//! Lanes that have left an outermost loop never come back to it. So what such a loop alone reads may
//! be written for them too: a counter, or the state of an iteration, is stored without a mask.

use crate::ir::{Block, Expr, Module, Stmt, Var};

/// Who reads a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reader {
    Nobody,
    /// One outermost loop, by its order in the code.
    Loop(u32),
    Others,
}

/// Which variables are a loop's own.
#[derive(Debug)]
pub(super) struct MasklessStores {
    /// By variable.
    readers: Vec<Reader>,
    /// How many outermost loops were seen.
    loops: u32,
}

impl MasklessStores {
    pub fn of(module: &Module) -> Self {
        let mut owned = Self { readers: vec![Reader::Nobody; module.variables.len()], loops: 0 };
        for (_, var) in &module.outputs {
            owned.readers[var.0 as usize] = Reader::Others;
        }
        owned.block(module, &module.body, None);
        owned
    }

    /// Whether all that reads the variable stands in this outermost loop.
    pub fn by_loop(&self, var: Var, outermost: u32) -> bool {
        self.readers[var.0 as usize] == Reader::Loop(outermost)
    }

    fn block(&mut self, module: &Module, block: &Block, open: Option<u32>) {
        for stmt in block {
            match stmt {
                Stmt::Eval(value) => match module.expr(*value) {
                    Expr::Load(var) | Expr::LoadAt { var, .. } => self.read(*var, open),
                    Expr::Const { .. }
                    | Expr::Input(_)
                    | Expr::Uniform { .. }
                    | Expr::UniformAt { .. }
                    | Expr::Op { .. }
                    | Expr::Derivative { .. }
                    | Expr::Sample(_)
                    | Expr::Component { .. } => {}
                },
                Stmt::Loop { .. } => {
                    let inside = open.unwrap_or(self.loops);
                    self.loops += u32::from(open.is_none());
                    stmt.blocks().for_each(|block| self.block(module, block, Some(inside)));
                }
                Stmt::If { .. } | Stmt::Scope(_) => {
                    stmt.blocks().for_each(|block| self.block(module, block, open));
                }
                Stmt::Store { .. } | Stmt::StoreAt { .. } => {}
                // What follows is never reached.
                Stmt::Break | Stmt::Continue | Stmt::Leave | Stmt::Discard => return,
            }
        }
    }

    fn read(&mut self, var: Var, open: Option<u32>) {
        let reader = &mut self.readers[var.0 as usize];
        *reader = match (*reader, open) {
            (Reader::Nobody, Some(inside)) => Reader::Loop(inside),
            (Reader::Loop(owner), Some(inside)) if owner == inside => Reader::Loop(owner),
            (Reader::Nobody | Reader::Loop(_) | Reader::Others, _) => Reader::Others,
        };
    }
}
