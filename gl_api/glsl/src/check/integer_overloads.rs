//! Integer overloads of `abs`, `sign`, `min`, `max` and `clamp` before GLSL 1.30, which added them.
//! Other compilers always have them, and programs rely on it. Here they are used only if a call or
//! its result would be an error without them, so the meaning of valid shaders does not change.

use super::Checker;
use super::call::Candidate;
use crate::ast;
use crate::builtins::function::{self, FunctionRow, Pattern};
use crate::hir::{Expr, ExprKind};
use crate::language::Availability;
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::types::{Scalar, Type};

/// Whether all types of a function are signed integers.
fn is_integer_overload(row: &FunctionRow) -> bool {
    let integer =
        |p: &Pattern| matches!(p, Pattern::Gen(Scalar::Int) | Pattern::Fixed(Scalar::Int, 1));
    row.result == Pattern::Gen(Scalar::Int) && row.parameters.iter().all(integer)
}

impl Checker<'_> {
    /// The integer overload for a call that no function here takes.
    pub(super) fn integer_candidate(
        &mut self,
        name: &ast::Name,
        arguments: &[Expr],
    ) -> Option<Candidate> {
        let types = arguments.iter().map(|argument| &argument.ty);
        let (row, parameters, result) = self.integer_overload(&name.text, types)?;
        self.warn_integer_overload(row, name.span);
        Some(Candidate::builtin(row, parameters, result))
    }

    /// Replaces a call with implicitly converted arguments by the integer overload, if its result
    /// must be an integer of this type.
    pub(super) fn as_integer_call(&mut self, value: &Expr, wanted: &Type) -> Option<Expr> {
        let ExprKind::Builtin(row, arguments) = &value.kind else { return None };
        if value.ty.with_scalar(Scalar::Int) != *wanted || value.ty == *wanted {
            return None;
        }
        let mut integers = Vec::new();
        for argument in arguments {
            integers.push(match &argument.kind {
                ExprKind::Convert(integer) => (**integer).clone(),
                _ => self.as_integer_call(argument, &argument.ty.with_scalar(Scalar::Int))?,
            });
        }
        let (row, _, ty) =
            self.integer_overload(&row.name, integers.iter().map(|expr| &expr.ty))?;
        self.warn_integer_overload(row, value.span);
        let kind = ExprKind::Builtin(row, integers);
        Some(Expr { ty, span: value.span, constant: value.constant, kind })
    }

    /// The integer overload of a name that takes these types and is not available.
    fn integer_overload<'a>(
        &self,
        name: &str,
        types: impl Iterator<Item = &'a Type> + Clone,
    ) -> Option<(&'static FunctionRow, Vec<Type>, Type)> {
        // Compilers of OpenGL ES follow the specification.
        if !self.language.has(Availability::DESKTOP) {
            return None;
        }
        let rows = function::named(name).filter(|row| {
            is_integer_overload(row)
                && row.stages.has(self.stage)
                && !self.language.has(row.availability)
        });
        let signatures = rows.flat_map(|row| {
            row.signatures().into_iter().map(move |(parameters, result)| (row, parameters, result))
        });
        signatures.into_iter().find(|(_, parameters, _)| types.clone().eq(parameters))
    }

    fn warn_integer_overload(&mut self, row: &FunctionRow, span: Span) {
        let message = format!("`{}` of integers is not in {}", row.name, self.version.title());
        let mut problem = Diagnostic::deviation(self.log.strictness, span, message);
        if let Some(advice) = self.language.advice(row.availability) {
            problem = problem.help(advice);
        }
        self.log.push(problem);
    }
}
