//! Expressions.

use super::{BinaryOp, IncDec, IncDecResult, Name, TypeName, UnaryOp};
use crate::text::source::Span;
use std::sync::Arc;

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// Where.
    pub span: Span,
    /// The depth of its tree.
    pub depth: u32,
    /// What.
    pub kind: ExprKind,
}

/// What an expression is.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A number without point.
    Int(i32),
    /// A number with the suffix `u`.
    Uint(u32),
    /// A number with point, exponent or suffix `f`.
    Float(f32),
    /// `true` or `false`.
    Bool(bool),
    /// A name.
    Name(Arc<str>),
    /// An operator with one operand.
    Unary(UnaryOp, Box<Expr>),
    /// An operator with two operands.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// `target = value` or, with an operator, `target op= value`.
    Assign(Option<BinaryOp>, Box<Expr>, Box<Expr>),
    /// `++`, `--`.
    IncDec(IncDec, IncDecResult, Box<Expr>),
    /// `a ? b : c`.
    Conditional(Box<[Expr; 3]>),
    /// `a, b, c`.
    Comma(Vec<Expr>),
    /// `a[b]`.
    Index(Box<Expr>, Box<Expr>),
    /// `a.b`: a member or a swizzle.
    Field(Box<Expr>, Name),
    /// `a.length()`.
    Method(Box<Expr>, Name),
    /// `name(arguments)`: a function or a structure.
    Call(Name, Vec<Expr>),
    /// `type(arguments)`.
    Construct(TypeName, Vec<Expr>),
    /// `{a, b}`: the list of an initializer.
    List(Vec<Expr>),
    /// A syntax error, reported already.
    Error,
}
