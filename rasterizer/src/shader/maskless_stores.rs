//! The variables that only one loop reads.
//!
//! Lanes that have left an outermost loop do not re-enter it. So a variable that only this loop reads may
//! be written in these lanes too: a counter, or the state of an iteration, is stored without a mask.

use crate::ir::{Block, Expr, Module, Stmt, Var};

/// Where a variable is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ReadBy {
    None,
    /// One outermost loop, by its order in the code.
    Loop(u32),
    Several,
}

/// The variables that are read in one loop only, whose stores need no mask.
#[derive(Debug)]
pub(super) struct MasklessStores {
    /// By variable.
    readers: Vec<ReadBy>,
    /// How many outermost loops were seen.
    loops: u32,
}

impl MasklessStores {
    pub fn of(module: &Module) -> Self {
        let mut stores = Self { readers: vec![ReadBy::None; module.variables.len()], loops: 0 };
        for (_, var) in &module.outputs {
            stores.readers[var.0 as usize] = ReadBy::Several;
        }
        stores.block(module, &module.body, None);
        stores
    }

    /// Whether all that reads the variable stands in this outermost loop.
    pub fn by_loop(&self, var: Var, outermost: u32) -> bool {
        self.readers[var.0 as usize] == ReadBy::Loop(outermost)
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
                    | Expr::Tabulated { .. }
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
                Stmt::Store { .. }
                | Stmt::StoreAt { .. }
                | Stmt::EmitVertex(_)
                | Stmt::EndPrimitive => {}
                // What follows is never reached.
                Stmt::Break | Stmt::Continue | Stmt::Leave | Stmt::Discard => return,
            }
        }
    }

    fn read(&mut self, var: Var, open: Option<u32>) {
        let reader = &mut self.readers[var.0 as usize];
        *reader = match (*reader, open) {
            (ReadBy::None, Some(inside)) => ReadBy::Loop(inside),
            (ReadBy::Loop(owner), Some(inside)) if owner == inside => ReadBy::Loop(owner),
            (ReadBy::None | ReadBy::Loop(_) | ReadBy::Several, _) => ReadBy::Several,
        };
    }
}
