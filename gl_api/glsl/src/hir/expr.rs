//! Typed expressions.

use super::VarRef;
use crate::ast::{BinaryOp, IncDec, IncDecResult, UnaryOp};
use crate::builtins::function::FunctionRow;
use crate::text::source::Span;
use crate::types::Type;
use std::collections::BTreeSet;
use std::sync::Arc;

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// Its type.
    pub ty: Type,
    /// Where it stands.
    pub span: Span,
    /// Whether it is a constant expression (GLSL 1.30 section 4.3.3).
    pub constant: bool,
    /// What it is.
    pub kind: ExprKind,
}

/// What an expression is.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A constant, as words.
    Const(Arc<[u32]>),
    /// A variable.
    Var(VarRef),
    /// Each component converted to the scalar type of the expression.
    Convert(Box<Expr>),
    /// An operator with one operand.
    Unary(UnaryOp, Box<Expr>),
    /// An operator with two operands.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// `target = value` or `target op= value`.
    Assign(Option<BinaryOp>, Box<Expr>, Box<Expr>),
    /// `++`, `--`.
    IncDec(IncDec, IncDecResult, Box<Expr>),
    /// `a ? b : c`.
    Conditional(Box<[Expr; 3]>),
    /// All expressions in order; the value of the last.
    Comma(Vec<Expr>),
    /// `a[b]`.
    Index(Box<Expr>, Box<Expr>),
    /// A member of a structure, by index.
    Field(Box<Expr>, u32),
    /// Components of a vector.
    Swizzle(Box<Expr>, Vec<u8>),
    /// A constructor.
    Construct(Vec<Expr>),
    /// A call of a function of the unit, by index.
    Call(u32, Vec<Expr>),
    /// A call of a built-in function.
    Builtin(&'static FunctionRow, Vec<Expr>),
    /// An error that was reported; the shader does not link.
    Error,
}

impl Expr {
    /// The expression that stands for an error.
    pub fn error(span: Span) -> Self {
        Self { ty: Type::Error, span, constant: false, kind: ExprKind::Error }
    }

    /// Whether an error was reported for it.
    pub fn is_error(&self) -> bool {
        self.ty == Type::Error
    }

    /// The variable at the root of an access chain.
    pub fn root(&self) -> Option<VarRef> {
        match &self.kind {
            ExprKind::Var(var) => Some(*var),
            ExprKind::Index(base, _) | ExprKind::Field(base, _) | ExprKind::Swizzle(base, _) => {
                base.root()
            }
            ExprKind::Const(_)
            | ExprKind::Convert(_)
            | ExprKind::Unary(..)
            | ExprKind::Binary(..)
            | ExprKind::Assign(..)
            | ExprKind::IncDec(..)
            | ExprKind::Conditional(_)
            | ExprKind::Comma(_)
            | ExprKind::Construct(_)
            | ExprKind::Call(..)
            | ExprKind::Builtin(..)
            | ExprKind::Error => None,
        }
    }

    /// Adds the globals of its unit that it references.
    pub fn add_globals(&self, found: &mut BTreeSet<u32>) {
        match &self.kind {
            ExprKind::Var(VarRef::Global(index)) => {
                found.insert(*index);
            }
            ExprKind::Const(_) | ExprKind::Var(VarRef::Local(_)) | ExprKind::Error => {}
            ExprKind::Convert(a)
            | ExprKind::Unary(_, a)
            | ExprKind::IncDec(_, _, a)
            | ExprKind::Field(a, _)
            | ExprKind::Swizzle(a, _) => a.add_globals(found),
            ExprKind::Binary(_, a, b) | ExprKind::Index(a, b) | ExprKind::Assign(_, a, b) => {
                a.add_globals(found);
                b.add_globals(found);
            }
            ExprKind::Conditional(all) => all.iter().for_each(|part| part.add_globals(found)),
            ExprKind::Comma(all)
            | ExprKind::Construct(all)
            | ExprKind::Call(_, all)
            | ExprKind::Builtin(_, all) => all.iter().for_each(|part| part.add_globals(found)),
        }
    }

    /// Whether it must be evaluated exactly once where it stands: it writes something or calls a
    /// function.
    pub fn has_effects(&self) -> bool {
        match &self.kind {
            ExprKind::Assign(..) | ExprKind::IncDec(..) | ExprKind::Call(..) => true,
            ExprKind::Const(_) | ExprKind::Var(_) | ExprKind::Error => false,
            ExprKind::Convert(a)
            | ExprKind::Unary(_, a)
            | ExprKind::Field(a, _)
            | ExprKind::Swizzle(a, _) => a.has_effects(),
            ExprKind::Binary(_, a, b) | ExprKind::Index(a, b) => a.has_effects() || b.has_effects(),
            ExprKind::Conditional(all) => all.iter().any(Self::has_effects),
            ExprKind::Comma(all) | ExprKind::Construct(all) => all.iter().any(Self::has_effects),
            ExprKind::Builtin(row, all) => row.has_effects() || all.iter().any(Self::has_effects),
        }
    }
}
