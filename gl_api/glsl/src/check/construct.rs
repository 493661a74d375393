//! Constructors (GLSL 1.30 section 5.4).

use super::Checker;
use crate::ast;
use crate::hir::{Expr, ExprKind};
use crate::language::Version;
use crate::limits::MAX_SCALARS;
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::types::{Struct, Type};
use std::sync::Arc;

impl Checker<'_> {
    pub(super) fn construct(
        &mut self,
        name: &ast::TypeName,
        arguments: &[ast::Expr],
        span: Span,
    ) -> Expr {
        let arguments: Vec<Expr> = arguments.iter().map(|a| self.expr(a)).collect();
        let ty = self.type_of(name, &[]);
        if arguments.iter().any(Expr::is_error) {
            return Expr::error(span);
        }
        match ty {
            Type::Error => Expr::error(span),
            Type::Void | Type::Sampler(_) => {
                self.error(span, "4.1.8", format!("{ty} has no constructor"));
                Expr::error(span)
            }
            Type::Struct(structure) => self.construct_struct(&structure, arguments, span),
            Type::Array(element, len) => self.construct_array(*element, len, arguments, span),
            Type::Vector(..) | Type::Matrix(..) => self.construct_numbers(ty, arguments, span),
        }
    }

    fn bad_constructor(&mut self, span: Span, message: String) -> Expr {
        let rule = format!("{} section 5.4", self.version.title());
        self.log.push(Diagnostic::error(span, message).rule(rule));
        Expr::error(span)
    }

    /// A scalar, vector or matrix from the scalars of the arguments.
    fn construct_numbers(&mut self, ty: Type, arguments: Vec<Expr>, span: Span) -> Expr {
        let plain = |argument: &&Expr| argument.ty.scalar().is_none();
        if let Some(bad) = arguments.iter().find(plain) {
            let message = format!("{ty} cannot be made of {}", bad.ty);
            return self.bad_constructor(bad.span, message);
        }
        let needed = ty.scalars();
        let matrix = arguments.iter().find(|a| matches!(a.ty, Type::Matrix(..)));
        if let (Type::Matrix(..), Some(matrix)) = (&ty, matrix) {
            if arguments.len() > 1 {
                let message = "a matrix made of a matrix takes nothing else".to_owned();
                return self.bad_constructor(matrix.span, message);
            }
            if self.version < Version::V120 {
                let message =
                    format!("making matrices of matrices is reserved in {}", self.version.title());
                return self.bad_constructor(span, message);
            }
        } else if !(arguments.len() == 1 && arguments[0].ty.is_scalar()) {
            let mut have = 0;
            for argument in &arguments {
                if have >= needed {
                    let message = format!("too many arguments: {ty} takes {needed} components");
                    return self.bad_constructor(argument.span, message);
                }
                have += argument.ty.scalars();
            }
            if have < needed {
                let message = format!("{ty} takes {needed} components, not {have}");
                return self.bad_constructor(span, message);
            }
        }
        let constant = arguments.iter().all(|argument| argument.constant);
        Expr { ty, span, constant, kind: ExprKind::Construct(arguments) }
    }

    pub(super) fn construct_struct(
        &mut self,
        structure: &Arc<Struct>,
        arguments: Vec<Expr>,
        span: Span,
    ) -> Expr {
        if arguments.iter().any(Expr::is_error) {
            return Expr::error(span);
        }
        let ty = Type::Struct(structure.clone());
        if arguments.len() != structure.fields.len() {
            let (needed, have) = (structure.fields.len(), arguments.len());
            let message = format!("{ty} has {needed} members, not {have}");
            return self.bad_constructor(span, message);
        }
        if ty.has_sampler() {
            return self.bad_constructor(span, format!("{ty} has a sampler in it"));
        }
        let pairs = arguments.into_iter().zip(&structure.fields);
        let parts: Vec<Expr> = pairs
            .map(|(argument, (_, field))| self.implicit_conversion(argument, field, "use"))
            .collect();
        let constant = parts.iter().all(|part| part.constant);
        Expr { ty, span, constant, kind: ExprKind::Construct(parts) }
    }

    fn construct_array(
        &mut self,
        element: Type,
        len: Option<u32>,
        arguments: Vec<Expr>,
        span: Span,
    ) -> Expr {
        if self.version < Version::V120 {
            let message = format!("constructors of arrays are not in {}", self.version.title());
            return self.bad_constructor(span, message);
        }
        let have = arguments.len() as u32;
        let len = len.unwrap_or(have);
        if len != have || len == 0 {
            let message = format!("an array of {len} takes {len} elements, not {have}");
            return self.bad_constructor(span, message);
        }
        // `float[][](...)` takes the inner sizes from its arguments.
        let element = element.sized_as(&arguments[0].ty);
        let convert = |argument| self.implicit_conversion(argument, &element, "use");
        let parts: Vec<Expr> = arguments.into_iter().map(convert).collect();
        if parts.iter().any(Expr::is_error) {
            return Expr::error(span);
        }
        let constant = parts.iter().all(|part| part.constant);
        let ty = Type::Array(Box::new(element), Some(len));
        if ty.scalars() > MAX_SCALARS {
            let message = format!("{ty} has more than {MAX_SCALARS} components");
            return self.bad_constructor(span, message);
        }
        Expr { ty, span, constant, kind: ExprKind::Construct(parts) }
    }
}
