//! Statements.

use super::{Declaration, Expr, Function, Precision, TypeName};
use crate::text::source::Span;

/// A statement.
#[derive(Clone, Debug)]
pub struct Stmt {
    /// Where.
    pub span: Span,
    /// What.
    pub kind: StmtKind,
}

/// What a statement is.
#[derive(Clone, Debug)]
pub enum StmtKind {
    /// `;`.
    Empty,
    /// `precision highp float;`, with the type.
    Precision(Precision, TypeName),
    /// Variables.
    Declaration(Declaration),
    /// A prototype.
    Prototype(Function),
    /// An expression.
    Expr(Expr),
    /// `{ ... }`.
    Block(Vec<Stmt>),
    /// `if`.
    If(Expr, Box<Stmt>, Option<Box<Stmt>>),
    /// `for`: start, condition, step, body.
    For(Option<Box<Stmt>>, Option<Condition>, Option<Expr>, Box<Stmt>),
    /// `while`.
    While(Condition, Box<Stmt>),
    /// `do ... while`.
    DoWhile(Box<Stmt>, Expr),
    /// `switch`.
    Switch(Expr, Vec<Stmt>),
    /// `case value:`.
    Case(Expr),
    /// `default:`.
    Default,
    /// `return`.
    Return(Option<Expr>),
    /// `break`.
    Break,
    /// `continue`.
    Continue,
    /// `discard`.
    Discard,
}

/// The condition of a loop.
#[derive(Clone, Debug)]
pub enum Condition {
    /// An expression.
    Expr(Expr),
    /// `bool name = value`.
    Declaration(Box<Declaration>),
}
