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
    /// These words.
    Const(Arc<[u32]>),
    /// A variable.
    Var(VarRef),
    /// Each component as the scalar of the expression's type.
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
    /// All, one after the other; the value of the last.
    Comma(Vec<Expr>),
    /// `a[b]`.
    Index(Box<Expr>, Box<Expr>),
    /// The member of this index of a structure.
    Field(Box<Expr>, u32),
    /// Components of a vector.
    Swizzle(Box<Expr>, Vec<u8>),
    /// A constructor.
    Construct(Vec<Expr>),
    /// A function of the unit.
    Call(u32, Vec<Expr>),
    /// A function of the language.
    Builtin(&'static FunctionRow, Vec<Expr>),
    /// What was wrong; the shader does not link.
    Error,
}

impl Expr {
    /// What stands for something wrong.
    pub fn error(span: Span) -> Self {
        Self { ty: Type::Error, span, constant: false, kind: ExprKind::Error }
    }

    /// Whether this was wrong already.
    pub fn is_error(&self) -> bool {
        self.ty == Type::Error
    }

    /// The variable that this is a part of.
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

    /// Adds the globals of its unit that it names.
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

    /// Whether evaluating it can be seen otherwise than by its value, or takes long: a call of a
    /// function, or a write.
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
            ExprKind::Builtin(row, all) => row.writes() || all.iter().any(Self::has_effects),
        }
    }
}
