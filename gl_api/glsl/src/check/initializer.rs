//! Lists as initializers (ARB_shading_language_420pack, section 4.1.11).

use super::Checker;
use crate::ast;
use crate::hir::{Expr, ExprKind};
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::types::{Type, vec};

const RULE: &str = "GLSL 4.20 section 4.1.11";

impl Checker<'_> {
    /// The value of a declaration of this type.
    pub(super) fn initializer(&mut self, init: &ast::Expr, ty: &Type) -> Expr {
        let ast::ExprKind::List(items) = &init.kind else { return self.expr(init) };
        let span = init.span;
        match ty {
            Type::Array(element, len) => self.list_of(items, element, *len, span),
            Type::Struct(structure) => {
                if !self.has_count(items, structure.fields.len(), ty, span) {
                    return Expr::error(span);
                }
                let fields = structure.fields.iter();
                let parts = items.iter().zip(fields).map(|(item, (_, field))| {
                    let part = self.initializer(item, field);
                    self.implicit_conversion(part, field, "initialize with")
                });
                let parts: Vec<Expr> = parts.collect();
                self.construct_struct(structure, parts, span)
            }
            Type::Vector(scalar, size @ 2..) => {
                let element = Type::Vector(*scalar, 1);
                self.numbers(items, (&element, *size), ty, span)
            }
            Type::Matrix(columns, rows) => self.numbers(items, (&vec(*rows), *columns), ty, span),
            Type::Error => Expr::error(span),
            Type::Void | Type::Vector(..) | Type::Sampler(_) => {
                let message = format!("a list gives no {ty}");
                self.log.push(Diagnostic::error(span, message).rule(RULE));
                Expr::error(span)
            }
        }
    }

    /// Whether a list has so many items; reports it if not.
    fn has_count(&mut self, items: &[ast::Expr], count: usize, ty: &Type, span: Span) -> bool {
        if items.len() != count {
            let message = format!("{ty} takes a list of {count}, not of {}", items.len());
            self.log.push(Diagnostic::error(span, message).rule(RULE));
        }
        items.len() == count
    }

    /// A vector of scalars, or a matrix of columns.
    fn numbers(
        &mut self,
        items: &[ast::Expr],
        (element, count): (&Type, u8),
        ty: &Type,
        span: Span,
    ) -> Expr {
        if !self.has_count(items, count.into(), ty, span) {
            return Expr::error(span);
        }
        self.converted(items, element, ty.clone(), span)
    }

    fn list_of(
        &mut self,
        items: &[ast::Expr],
        element: &Type,
        len: Option<u32>,
        span: Span,
    ) -> Expr {
        let count = len.map_or(items.len(), |len| len as usize);
        let ty = Type::Array(Box::new(element.clone()), len);
        if count == 0 || !self.has_count(items, count, &ty, span) {
            if count == 0 {
                let message = "an array has an element at least";
                self.log.push(Diagnostic::error(span, message).rule(RULE));
            }
            return Expr::error(span);
        }
        // `float a[][] = {{1.0, 2.0}}` takes the inner size from its first item.
        let first = self.initializer(&items[0], element);
        let element = element.clone().sized_as(&first.ty);
        let ty = Type::Array(Box::new(element.clone()), Some(items.len() as u32));
        let first = self.implicit_conversion(first, &element, "initialize with");
        let mut rest = self.converted(&items[1..], &element, ty, span);
        if first.is_error() || rest.is_error() {
            return Expr::error(span);
        }
        rest.constant &= first.constant;
        if let ExprKind::Construct(parts) = &mut rest.kind {
            parts.insert(0, first);
        }
        rest
    }

    /// A value of type `ty` made of items of one type.
    fn converted(&mut self, items: &[ast::Expr], element: &Type, ty: Type, span: Span) -> Expr {
        let mut parts = Vec::with_capacity(items.len());
        for item in items {
            let part = self.initializer(item, element);
            parts.push(self.implicit_conversion(part, element, "initialize with"));
        }
        if parts.iter().any(Expr::is_error) {
            return Expr::error(span);
        }
        let constant = parts.iter().all(|part| part.constant);
        Expr { ty, span, constant, kind: ExprKind::Construct(parts) }
    }
}
