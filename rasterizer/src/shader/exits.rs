//! The ways in which lanes leave a statement before its end.

use crate::ir::{Block, Stmt};

/// Whether lanes can leave the block through a statement, so that none may be left after it.
pub(super) fn may_empty(stmt: &Stmt) -> bool {
    let exits = Exits::of(stmt);
    exits.iteration || exits.scope || exits.discard
}

/// Whether lanes can skip the rest of an iteration.
pub(super) fn continues(block: &Block) -> bool {
    block.iter().any(|stmt| match stmt {
        Stmt::Continue => true,
        Stmt::If { .. } | Stmt::Scope(_) => stmt.blocks().any(continues),
        Stmt::Eval(_)
        | Stmt::Store { .. }
        | Stmt::StoreAt { .. }
        | Stmt::Loop { .. }
        | Stmt::Break
        | Stmt::Leave
        | Stmt::Discard
        | Stmt::EmitVertex(_)
        | Stmt::EndPrimitive => false,
    })
}

/// The ways out of a statement.
#[derive(Clone, Copy, Default)]
struct Exits {
    /// `Break` or `Continue`.
    iteration: bool,
    scope: bool,
    discard: bool,
}

impl Exits {
    fn of(stmt: &Stmt) -> Self {
        match stmt {
            Stmt::Eval(_)
            | Stmt::Store { .. }
            | Stmt::StoreAt { .. }
            | Stmt::EmitVertex(_)
            | Stmt::EndPrimitive => Self::default(),
            Stmt::If { accept, reject, .. } => Self::any(accept).or(Self::any(reject)),
            Stmt::Loop { body, continuing } => {
                Self { iteration: false, ..Self::any(body).or(Self::any(continuing)) }
            }
            Stmt::Scope(body) => Self { scope: false, ..Self::any(body) },
            Stmt::Break | Stmt::Continue => Self { iteration: true, ..Self::default() },
            Stmt::Leave => Self { scope: true, ..Self::default() },
            Stmt::Discard => Self { discard: true, ..Self::default() },
        }
    }

    fn any(block: &Block) -> Self {
        block.iter().map(Self::of).fold(Self::default(), Self::or)
    }

    fn or(self, other: Self) -> Self {
        Self {
            iteration: self.iteration || other.iteration,
            scope: self.scope || other.scope,
            discard: self.discard || other.discard,
        }
    }
}
