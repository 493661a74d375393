//! Early returns become `else`: `{ if c { A; leave } B }` is `{ if c { A } else { B } }` where the
//! block ends with the scope. What follows a branch that leaves needs no mask of its own then, and
//! a scope without a `leave` is no scope.

use crate::ir::{Block, MAX_NESTING, Module, Stmt};

/// Each early return nests the rest of the scope one deeper; not beyond this.
const DEEPEST: usize = MAX_NESTING / 2;

/// Runs the pass.
pub(super) fn run(module: &mut Module) {
    let body = std::mem::take(&mut module.body);
    module.body = block(body, 0);
}

fn block(block: Block, depth: usize) -> Block {
    let mut out = Vec::with_capacity(block.len());
    for stmt in block {
        match stmt {
            Stmt::Scope(body) => {
                let body = tail(self::block(body, depth + 1), depth + 1);
                if body.iter().any(leaves) { out.push(Stmt::Scope(body)) } else { out.extend(body) }
            }
            Stmt::If { condition, accept, reject } => out.push(Stmt::If {
                condition,
                accept: self::block(accept, depth + 1),
                reject: self::block(reject, depth + 1),
            }),
            Stmt::Loop { body, continuing } => out.push(Stmt::Loop {
                body: self::block(body, depth + 1),
                continuing: self::block(continuing, depth + 1),
            }),
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
        if out.last().is_some_and(Stmt::is_jump) {
            break;
        }
    }
    out
}

/// Rewrites a block at whose end the scope ends.
fn tail(block: Block, depth: usize) -> Block {
    let mut out = Vec::with_capacity(block.len());
    let mut rest = block.into_iter();
    while let Some(stmt) = rest.next() {
        let jump = stmt.is_jump();
        let Stmt::If { condition, mut accept, mut reject } = stmt else {
            out.push(stmt);
            if jump {
                break;
            }
            continue;
        };
        if depth < DEEPEST && ends_scope(&accept) {
            reject.extend(&mut rest);
        } else if depth < DEEPEST && ends_scope(&reject) {
            accept.extend(&mut rest);
        }
        if rest.as_slice().is_empty() {
            (accept, reject) = (tail(accept, depth + 1), tail(reject, depth + 1));
        }
        out.push(Stmt::If { condition, accept, reject });
    }
    if out.last() == Some(&Stmt::Leave) {
        out.pop();
    }
    out
}

fn ends_scope(block: &Block) -> bool {
    block.last() == Some(&Stmt::Leave)
}

/// Whether a statement leaves the scope around it.
fn leaves(stmt: &Stmt) -> bool {
    match stmt {
        Stmt::Leave => true,
        Stmt::Scope(_) => false,
        Stmt::Eval(_)
        | Stmt::Store { .. }
        | Stmt::StoreAt { .. }
        | Stmt::If { .. }
        | Stmt::Loop { .. }
        | Stmt::Break
        | Stmt::Continue
        | Stmt::Discard
        | Stmt::EmitVertex(_)
        | Stmt::EndPrimitive => stmt.blocks().flatten().any(leaves),
    }
}
