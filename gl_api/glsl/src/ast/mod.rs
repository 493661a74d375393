//! The syntax tree, as written; nothing in it is checked yet.

mod decl;
mod expr;
mod operator;
mod stmt;

use crate::text::source::Span;
pub use crate::types::Precision;
pub use decl::*;
pub use expr::{Expr, ExprKind};
pub use operator::{BINARY, BinaryOp, IncDec, IncDecResult, UnaryOp};
use std::sync::Arc;
pub use stmt::{Condition, Stmt, StmtKind};

/// A name and where it stands.
#[derive(Clone, Debug)]
pub struct Name {
    /// The name.
    pub text: Arc<str>,
    /// Where.
    pub span: Span,
}
