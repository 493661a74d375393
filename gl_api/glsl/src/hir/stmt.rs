//! Checked statements.

use super::Expr;

/// A statement.
#[derive(Clone, Debug)]
pub enum Stmt {
    /// A local variable comes into being.
    Declare(u32, Option<Expr>),
    /// An expression.
    Expr(Expr),
    /// A block.
    Block(Vec<Stmt>),
    /// `if`.
    If(Expr, Vec<Stmt>, Vec<Stmt>),
    /// Any loop.
    Loop(Box<Loop>),
    /// `switch`: the selector and its groups of statements.
    Switch(Expr, Vec<Case>),
    /// `return`.
    Return(Option<Expr>),
    /// `break`.
    Break,
    /// `continue`.
    Continue,
    /// `discard`.
    Discard,
}

/// A loop.
#[derive(Clone, Debug)]
pub struct Loop {
    /// The variable that the condition declares.
    pub declare: Option<u32>,
    /// Tested before each turn.
    pub before: Option<Expr>,
    /// The body.
    pub body: Vec<Stmt>,
    /// Runs after each turn.
    pub step: Option<Expr>,
    /// Tested after each turn.
    pub after: Option<Expr>,
}

/// A label's statements, up to the next label.
#[derive(Clone, Debug)]
pub struct Case {
    /// The values that lead here.
    pub labels: Vec<u32>,
    /// Whether `default` leads here.
    pub default: bool,
    /// The statements.
    pub body: Vec<Stmt>,
}
