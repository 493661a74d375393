//! Dead store elimination: liveness of variables, backwards.
//!
//! Each lane follows its own control flow, so liveness is that of a single lane and does not depend on masks.

use crate::ir::{Block, Expr, Module, Stmt, Var};

/// Runs the pass.
pub(super) fn run(module: &mut Module) {
    let mut body = std::mem::take(&mut module.body);
    let mut live = LiveVariables(vec![0; module.variables.len().div_ceil(64)]);
    for (_, var) in &module.outputs {
        live.insert(*var);
    }
    let mut walk = Walk { module, loops: Vec::new(), scopes: Vec::new() };
    walk.block(&mut body, live);
    module.body = body;
}

/// A set of variables.
#[derive(Clone)]
struct LiveVariables(Vec<u64>);

impl LiveVariables {
    fn contains(&self, var: Var) -> bool {
        self.0[var.0 as usize / 64] >> (var.0 % 64) & 1 != 0
    }
    fn insert(&mut self, var: Var) {
        self.0[var.0 as usize / 64] |= 1 << (var.0 % 64);
    }
    fn remove(&mut self, var: Var) {
        self.0[var.0 as usize / 64] &= !(1 << (var.0 % 64));
    }
    fn extend(&mut self, other: &Self) {
        for (mine, other) in self.0.iter_mut().zip(&other.0) {
            *mine |= other;
        }
    }
}

/// What is live where a loop's jumps go.
struct LoopLiveness {
    at_break: LiveVariables,
    at_continue: LiveVariables,
}

struct Walk<'a> {
    module: &'a Module,
    loops: Vec<LoopLiveness>,
    /// What is live at the end of each open scope.
    scopes: Vec<LiveVariables>,
}

impl Walk<'_> {
    /// Takes what is live at the end of a block, gives what is live at its start.
    fn block(&mut self, block: &mut Block, mut live: LiveVariables) -> LiveVariables {
        let mut live_stmts = Vec::with_capacity(block.len());
        for mut stmt in block.drain(..).rev() {
            match &mut stmt {
                Stmt::Eval(value) => match self.module.expr(*value) {
                    Expr::Load(var) | Expr::LoadAt { var, .. } => live.insert(*var),
                    _ => {}
                },
                Stmt::Store { var, .. } => {
                    if !live.contains(*var) {
                        continue;
                    }
                    live.remove(*var);
                }
                Stmt::StoreAt { .. } | Stmt::EmitVertex(_) | Stmt::EndPrimitive => {}
                Stmt::If { accept, reject, .. } => {
                    let other = self.block(accept, live.clone());
                    live = self.block(reject, live);
                    live.extend(&other);
                }
                Stmt::Loop { body, continuing } => live = self.repeat(body, continuing, live),
                Stmt::Scope(body) => {
                    self.scopes.push(live.clone());
                    live = self.block(body, live);
                    self.scopes.pop();
                }
                Stmt::Break => self.jump(&mut live, |walk| walk.loops.last().map(|t| &t.at_break)),
                Stmt::Continue => {
                    self.jump(&mut live, |walk| walk.loops.last().map(|t| &t.at_continue));
                }
                Stmt::Leave => self.jump(&mut live, |walk| walk.scopes.last()),
                // A fragment that is thrown away has no outputs.
                Stmt::Discard => live.0.fill(0),
            }
            live_stmts.push(stmt);
        }
        live_stmts.reverse();
        *block = live_stmts;
        live
    }

    fn jump(&self, live: &mut LiveVariables, to: impl Fn(&Self) -> Option<&LiveVariables>) {
        if let Some(target) = to(self) {
            live.clone_from(target);
        }
    }

    fn repeat(
        &mut self,
        body: &mut Block,
        continuing: &mut Block,
        after: LiveVariables,
    ) -> LiveVariables {
        // More than is live when the loop comes round: all it reads, and all that is live wherever
        // it is left.
        let mut live_in_loop = after.clone();
        if let Some(scope) = self.scopes.last() {
            live_in_loop.extend(scope);
        }
        for stmt in body.iter().chain(continuing.iter()) {
            stmt.walk(&mut |stmt| {
                if let Stmt::Eval(value) = stmt
                    && let Expr::Load(var) | Expr::LoadAt { var, .. } = self.module.expr(*value)
                {
                    live_in_loop.insert(*var);
                }
            });
        }
        self.loops.push(LoopLiveness { at_break: after, at_continue: live_in_loop.clone() });
        let at_continue = self.block(continuing, live_in_loop);
        if let Some(liveness) = self.loops.last_mut() {
            liveness.at_continue.clone_from(&at_continue);
        }
        let live = self.block(body, at_continue);
        self.loops.pop();
        live
    }
}
