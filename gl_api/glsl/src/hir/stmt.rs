//! Checked statements.

use super::Expr;

/// A statement.
#[derive(Clone, Debug)]
pub enum Stmt {
    /// The declaration of a local variable, with its initializer.
    Declare(u32, Option<Expr>),
    /// An expression.
    Expr(Expr),
    /// A block.
    Block(Vec<Stmt>),
    /// `if`.
    If(Expr, Vec<Stmt>, Vec<Stmt>),
    /// A loop of any kind.
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
    /// Tested before each iteration.
    pub condition_before: Option<Expr>,
    /// The body.
    pub body: Vec<Stmt>,
    /// Runs after each iteration.
    pub step: Option<Expr>,
    /// Tested after each iteration.
    pub condition_after: Option<Expr>,
}

/// The statements of a label, up to the next label.
#[derive(Clone, Debug)]
pub struct Case {
    /// The values of its `case` labels.
    pub labels: Vec<u32>,
    /// Whether it has a `default` label.
    pub default: bool,
    /// The statements.
    pub body: Vec<Stmt>,
}
