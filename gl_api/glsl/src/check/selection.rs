//! Elements, members and components of values (GLSL 1.30 sections 5.5 to 5.7).

use super::Checker;
use super::expr::word;
use crate::ast;
use crate::builtins::variable::Builtin;
use crate::hir::{Expr, ExprKind, Storage};
use crate::language::{Availability, Extension, Version};
use crate::limits::{MAX_CLIP_DISTANCES, MAX_IMPLICIT_SIZE, MAX_SCALARS};
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::text::spelling::closest;
use crate::types::{INT, Scalar, Type};

/// The three sets of component names (GLSL 1.30 section 5.5).
const SWIZZLES: [&str; 3] = ["xyzw", "rgba", "stpq"];

impl Checker<'_> {
    pub(super) fn index(&mut self, base: &ast::Expr, index: &ast::Expr, span: Span) -> Expr {
        let base = self.expr(base);
        let index = self.expr(index);
        self.indexed(base, index, span)
    }

    /// An element of a checked value.
    pub(super) fn indexed(&mut self, base: Expr, mut index: Expr, span: Span) -> Expr {
        if let Some(integer) = self.as_integer_call(&index, &INT) {
            index = integer;
        }
        if base.is_error() || index.is_error() {
            return Expr::error(span);
        }
        let Some((element, len)) = base.ty.element() else {
            let message = format!("{} has no elements to index", base.ty);
            self.log.push(
                Diagnostic::error(base.span, message)
                    .rule(format!("{} section 5.7", self.version.title())),
            );
            return Expr::error(span);
        };
        if !matches!(index.ty, Type::Vector(Scalar::Int | Scalar::Uint, 1)) {
            let message = format!("an index is an int, not {}", index.ty);
            self.error(index.span, "5.7", message);
            return Expr::error(span);
        }
        let value = self.evaluate(&index).map(|words| words[0]);
        let constant = base.constant && value.is_some();
        let index = match value {
            Some(value) => {
                self.check_bounds(&base, value, len, index.span);
                word(index.span, index.ty, value)
            }
            None => {
                if len.is_none() {
                    let message = "an array without a size is indexed by what is not constant";
                    self.log.push(
                        Diagnostic::error(index.span, message)
                            .rule(format!("{} section 4.1.9", self.version.title())),
                    );
                }
                if base.ty.has_sampler() && self.version >= Version::V130 {
                    self.dynamic_samplers(&element, index.span);
                }
                if let Some(root) = base.root() {
                    self.variable_mut(root).dynamically_indexed = true;
                }
                index
            }
        };
        let kind = ExprKind::Index(Box::new(base), Box::new(index));
        Expr { ty: element, span, constant, kind }
    }

    /// Samplers are indexed by constant expressions; drivers accept others of structures that hold
    /// samplers, and programs rely on that.
    fn dynamic_samplers(&mut self, element: &Type, span: Span) {
        let message = "samplers are indexed by constant expressions only";
        let problem = match element.base() {
            Type::Struct(_) => Diagnostic::deviation(self.log.strictness, span, message)
                .help("the texture is looked up in all of them, and one result is taken"),
            Type::Void
            | Type::Vector(..)
            | Type::Matrix(..)
            | Type::Sampler(_)
            | Type::Array(..)
            | Type::Error => Diagnostic::error(span, message),
        };
        self.log.push(problem.rule(self.rule("4.1.7")));
    }

    /// Checks a constant index; an unsized array grows with it.
    fn check_bounds(&mut self, base: &Expr, value: u32, len: Option<u32>, span: Span) {
        let builtin = base.root().map(|root| self.variable(root).storage);
        let implicit = match builtin {
            Some(Storage::Builtin(_)) => MAX_CLIP_DISTANCES.into(),
            _ => match base.ty.element() {
                Some((element, _)) => MAX_IMPLICIT_SIZE.min(MAX_SCALARS / element.scalars().max(1)),
                None => MAX_IMPLICIT_SIZE,
            },
        };
        let limit = len.unwrap_or(implicit);
        // Drivers accept what gl_MaxDrawBuffers allows, with or without the extension.
        if builtin == Some(Storage::Builtin(Builtin::FragData))
            && (1..limit).contains(&value)
            && self.version == Version::Es100
            && !self.language.enabled(Extension::EsDrawBuffers)
        {
            let message = format!("`gl_FragData[{value}]` is of `GL_EXT_draw_buffers`");
            let problem = Diagnostic::deviation(self.log.strictness, span, message)
                .rule("EXT_draw_buffers, section 7.2: without it there is one colour")
                .help("write `#extension GL_EXT_draw_buffers : require` at the beginning");
            self.log.push(problem);
        }
        if value >= limit {
            let message =
                format!("index {} is out of range: {} has {limit} elements", value as i32, base.ty);
            let rule = format!("{} section 5.7", self.version.title());
            self.log.push(Diagnostic::error(span, message).rule(rule));
        } else if let (ExprKind::Var(var), Type::Array(..)) = (&base.kind, &base.ty) {
            self.note_constant_index(*var, value + 1);
        } else if let (ExprKind::Index(..), Some(var), None) = (&base.kind, base.root(), len) {
            let variable = self.variable_mut(var);
            variable.inner_min_len = variable.inner_min_len.max(value + 1);
        }
    }

    pub(super) fn field(&mut self, base: &ast::Expr, name: &ast::Name, span: Span) -> Expr {
        if let Some(member) = self.instance_member(base, name, span) {
            return member;
        }
        let base = self.expr(base);
        self.member_of(base, name, span)
    }

    /// A member of a checked structure, or components of a vector.
    pub(super) fn member_of(&mut self, base: Expr, name: &ast::Name, span: Span) -> Expr {
        match &base.ty {
            Type::Error => Expr::error(span),
            Type::Struct(structure) => {
                let found = structure.fields.iter().position(|(field, _)| *field == name.text);
                let Some(index) = found else {
                    let message = format!("{} has no member `{}`", base.ty, name.text);
                    let mut problem = Diagnostic::error(name.span, message);
                    let fields = structure.fields.iter().map(|(field, _)| &**field);
                    if let Some(near) = closest(&name.text, fields) {
                        let text = format!("did you mean `{near}`?");
                        problem = problem.fix(text, name.span, near.to_owned());
                    }
                    self.log.push(problem);
                    return Expr::error(span);
                };
                let (ty, constant) = (structure.fields[index].1.clone(), base.constant);
                Expr { ty, span, constant, kind: ExprKind::Field(Box::new(base), index as u32) }
            }
            Type::Vector(scalar, size) if *size > 1 || self.language.has(Availability::RELAXED) => {
                match swizzle(&name.text, *size) {
                    Ok(components) => {
                        let ty = Type::Vector(*scalar, components.len() as u8);
                        let constant = base.constant;
                        let kind = ExprKind::Swizzle(Box::new(base), components);
                        Expr { ty, span, constant, kind }
                    }
                    Err(problem) => {
                        let message = format!("`.{}` on {}: {problem}", name.text, base.ty);
                        let rule = format!("{} section 5.5", self.version.title());
                        self.log.push(Diagnostic::error(name.span, message).rule(rule));
                        Expr::error(span)
                    }
                }
            }
            ty => {
                let message = format!("{ty} has no members or components");
                self.error(name.span, "4.1.8", message);
                Expr::error(span)
            }
        }
    }

    pub(super) fn method(&mut self, base: &ast::Expr, name: &ast::Name, span: Span) -> Expr {
        if &*name.text == "length"
            && let Some(count) = self.instance_count(base, span)
        {
            return count;
        }
        let base = self.expr(base);
        if base.is_error() {
            return base;
        }
        match &base.ty {
            Type::Array(_, Some(len)) if &*name.text == "length" => {
                if self.version < Version::V120 {
                    let message = format!("`.length()` is not in {}", self.version.title());
                    self.error(name.span, "5.7", message);
                }
                word(span, INT, *len)
            }
            Type::Vector(_, size @ 2..)
                if &*name.text == "length" && self.language.has(Availability::RELAXED) =>
            {
                word(span, INT, (*size).into())
            }
            Type::Matrix(columns, _)
                if &*name.text == "length" && self.language.has(Availability::RELAXED) =>
            {
                word(span, INT, (*columns).into())
            }
            ty => {
                let message = format!("{ty} has no function `{}`", name.text);
                self.error(name.span, "5.1", message);
                Expr::error(span)
            }
        }
    }
}

/// The components that a swizzle selects.
fn swizzle(text: &str, size: u8) -> Result<Vec<u8>, String> {
    let Some(set) = SWIZZLES.iter().find(|set| text.chars().all(|c| set.contains(c))) else {
        return Err(match text.chars().find(|c| !SWIZZLES.concat().contains(*c)) {
            Some(c) => format!("`{c}` is no component"),
            None => "the components come from one of the sets xyzw, rgba and stpq".to_owned(),
        });
    };
    if text.len() > 4 {
        return Err("a swizzle has at most four components".to_owned());
    }
    let components: Vec<u8> =
        text.chars().filter_map(|c| set.find(c)).map(|index| index as u8).collect();
    match components.iter().position(|&component| component >= size) {
        Some(at) => Err(format!("there is no component `{}`", &text[at..=at])),
        None => Ok(components),
    }
}
