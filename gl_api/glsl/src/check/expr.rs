//! Expressions (GLSL 1.30 chapter 5).

use super::Checker;
use super::operators::{self, converts};
use super::scope::Symbol;
use crate::ast::{self, BinaryOp, UnaryOp};
use crate::builtins::variable::{self, Builtin};
use crate::hir::{Expr, ExprKind, Storage, VarRef, Variable};
use crate::language::{Availability, Version};
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::types::{BOOL, FLOAT, INT, Scalar, Type, UINT};
use rasterizer::ir::TRUE;
use std::sync::Arc;

/// A constant of one word.
pub(super) fn word(span: Span, ty: Type, word: u32) -> Expr {
    Expr { ty, span, constant: true, kind: ExprKind::Const(Arc::from([word])) }
}

impl Checker<'_> {
    /// Checks an expression.
    pub(super) fn expr(&mut self, expr: &ast::Expr) -> Expr {
        let span = expr.span;
        match &expr.kind {
            ast::ExprKind::Int(value) => word(span, INT, *value as u32),
            ast::ExprKind::Uint(value) => word(span, UINT, *value),
            ast::ExprKind::Float(value) => word(span, FLOAT, value.to_bits()),
            ast::ExprKind::Bool(value) => word(span, BOOL, if *value { TRUE } else { 0 }),
            ast::ExprKind::Name(name) => self.name(name, span),
            ast::ExprKind::Unary(op, operand) => self.unary(*op, operand, span),
            ast::ExprKind::Binary(op, left, right) => {
                let (left, right) = (self.expr(left), self.expr(right));
                self.binary(*op, left, right, span)
            }
            ast::ExprKind::Assign(op, target, value) => self.assign(*op, target, value, span),
            ast::ExprKind::IncDec(step, result, operand) => {
                let operand = self.expr(operand);
                if operand.is_error() {
                    return operand;
                }
                let number = operand.ty.scalar().is_some_and(|scalar| scalar != Scalar::Bool);
                if !number {
                    let message = format!("cannot count a {} up or down", operand.ty);
                    self.error(span, "5.9", message);
                    return Expr::error(span);
                }
                self.check_written(&operand, "change");
                let ty = operand.ty.clone();
                let kind = ExprKind::IncDec(*step, *result, Box::new(operand));
                Expr { ty, span, constant: false, kind }
            }
            ast::ExprKind::Conditional(parts) => self.conditional(parts, span),
            ast::ExprKind::Comma(all) => {
                let all: Vec<Expr> = all.iter().map(|expr| self.expr(expr)).collect();
                let ty = all.last().map_or(Type::Void, |last| last.ty.clone());
                // A constant operator in GLSL 1.10 (section 4.3.3) and GLSL ES 1.00 (section 5.10)
                // only.
                let constant = self.version < Version::V120 && all.iter().all(|part| part.constant);
                Expr { ty, span, constant, kind: ExprKind::Comma(all) }
            }
            ast::ExprKind::Index(base, index) => self.index(base, index, span),
            ast::ExprKind::Field(base, name) => self.field(base, name, span),
            ast::ExprKind::Method(base, name) => self.method(base, name, span),
            ast::ExprKind::Call(name, arguments) => self.call(name, arguments, span),
            ast::ExprKind::Construct(ty, arguments) => self.construct(ty, arguments, span),
            ast::ExprKind::List(_) => {
                self.error(span, "4.1.11", "a list stands only behind the `=` of a declaration");
                Expr::error(span)
            }
            ast::ExprKind::Error => Expr::error(span),
        }
    }

    fn name(&mut self, name: &Arc<str>, span: Span) -> Expr {
        let var = match self.scopes.find(name) {
            Some(Symbol::Variable(var)) => Some(*var),
            Some(&Symbol::Member(block, index)) => return self.member(block, index, span),
            Some(Symbol::Instance(_)) => return self.whole_instance(name, span),
            Some(Symbol::Block | Symbol::Struct(_) | Symbol::Functions) => {
                let message = format!("`{name}` is not a variable");
                self.error(span, "5.1", message);
                return Expr::error(span);
            }
            Some(Symbol::Undeclared(_)) => None,
            None => self.builtin_variable(name),
        };
        let Some(var) = var else {
            if self.leaves_out(name) {
                self.left_out(name, span);
                return Expr::error(span);
            }
            self.undeclared(name, span);
            return Expr::error(span);
        };
        self.note_use(var);
        let variable = self.variable(var);
        let constant = variable.constant.is_some();
        Expr { ty: variable.ty.clone(), span, constant, kind: ExprKind::Var(var) }
    }

    /// Adds a built-in variable to the globals of the unit.
    pub(super) fn builtin_variable(&mut self, name: &str) -> Option<VarRef> {
        if self.leaves_out(name) {
            return None;
        }
        let builtin = variable::find(name, self.stage, self.language)?;
        let (row, mut ty) = (builtin.row, builtin.ty.clone());
        if let (Builtin::Incoming(_), Type::Array(_, len)) = (row.builtin, &mut ty) {
            *len = self.unit.geometry.input.map(|input| input.vertices().into());
        }
        let storage = Storage::Builtin(row.builtin);
        let mut variable = Variable::new(row.name.into(), ty, storage, Span::default());
        if let Builtin::Limit(value) = row.builtin {
            variable.constant = Some([value as u32].into());
        }
        let var = VarRef::Global(self.unit.globals.len() as u32);
        self.scopes.add_global(variable.name.clone(), Symbol::Variable(var));
        self.unit.globals.push(variable);
        Some(var)
    }

    fn unary(&mut self, op: UnaryOp, operand: &ast::Expr, span: Span) -> Expr {
        let operand = self.expr(operand);
        if operand.is_error() {
            return operand;
        }
        let scalar = operand.ty.scalar();
        let fits = match op {
            UnaryOp::Plus | UnaryOp::Negate => scalar.is_some_and(|scalar| scalar != Scalar::Bool),
            UnaryOp::Not => operand.ty == BOOL,
            UnaryOp::BitNot => {
                let integer = matches!(scalar, Some(Scalar::Int | Scalar::Uint));
                integer && self.has_integers(span)
            }
        };
        if !fits {
            let sign = match op {
                UnaryOp::Plus => "+",
                UnaryOp::Negate => "-",
                UnaryOp::Not => "!",
                UnaryOp::BitNot => "~",
            };
            let message = format!("`{sign}` does not apply to {}", operand.ty);
            let rule = format!("{} section 5.9", self.version.title());
            let mut problem = Diagnostic::error(span, message).rule(rule);
            if op == UnaryOp::Not && scalar == Some(Scalar::Bool) {
                problem = problem.help("for vectors, use the function `not`");
            }
            self.log.push(problem);
            return Expr::error(span);
        }
        let (ty, constant) = (operand.ty.clone(), operand.constant);
        Expr { ty, span, constant, kind: ExprKind::Unary(op, Box::new(operand)) }
    }

    /// Whether the version has integer operators; reports it if not.
    fn has_integers(&mut self, span: Span) -> bool {
        if !self.language.has(Availability::INTEGERS) {
            let message = "bits, shifts and remainders of integers are reserved in this version";
            let problem = Diagnostic::error(span, message)
                .rule(format!("{} section 5.1", self.version.title()));
            self.log.push(problem.help("write `#version 130` first"));
        }
        true
    }

    /// A binary operation on checked operands.
    pub(super) fn binary(&mut self, op: BinaryOp, left: Expr, right: Expr, span: Span) -> Expr {
        if left.is_error() || right.is_error() {
            return Expr::error(span);
        }
        if op.is_integer() {
            self.has_integers(span);
        }
        let Some(typed) = operators::binary(op, &left.ty, &right.ty, self.version) else {
            self.mismatch(op, &left, &right, span);
            return Expr::error(span);
        };
        let left = convert(left, &typed.left);
        let right = convert(right, &typed.right);
        let constant = left.constant && right.constant;
        let kind = ExprKind::Binary(op, Box::new(left), Box::new(right));
        Expr { ty: typed.result, span, constant, kind }
    }

    /// Reports why two operands do not go together.
    fn mismatch(&mut self, op: BinaryOp, left: &Expr, right: &Expr, span: Span) {
        let (a, b) = (&left.ty, &right.ty);
        let verb = if op == BinaryOp::Mul {
            format!("cannot multiply {a} by {b}")
        } else {
            format!("`{}` does not take {a} and {b}", op.text())
        };
        let title = self.version.title();
        let mut problem = Diagnostic::error(span, verb);
        let product = op == BinaryOp::Mul;
        if let (true, Type::Matrix(columns, rows), Type::Vector(Scalar::Float, n @ 2..)) =
            (product, a, b)
        {
            problem.span = Some(right.span);
            problem = problem.label(b.to_string()).rule(format!(
                "{title} section 5.9: a matrix of {columns} columns times a vector of \
                     {columns} components gives a vector of {rows}"
            ));
            if (*columns, *n) == (4, 2) || (*columns, *n) == (4, 3) {
                let text = self.source.slice(right.span);
                let rest = if *n == 2 { "0.0, 1.0" } else { "1.0" };
                let wide = format!("vec4({text}, {rest})");
                let help = format!("extend the position: `{wide}`");
                problem = problem.fix(help, right.span, wide);
            }
        } else if product && a.rows().is_some() && b.rows().is_some() {
            problem = problem.rule(format!(
                "{title} section 5.9: the left has as many columns as the right has rows"
            ));
        } else {
            problem = problem.rule(format!("{title} section 5.9"));
            let vectors = !a.is_scalar() && a == b;
            if let (Some(name), true) = (op.vector_function(), vectors) {
                problem = problem.help(format!("for vectors, use the function `{name}`"));
            }
            let numbers = |x: &Type, y: &Type| {
                x.scalar() == Some(Scalar::Int) && y.scalar() == Some(Scalar::Float)
            };
            if numbers(a, b) || numbers(b, a) {
                let integer = if numbers(a, b) { left } else { right };
                problem = self.with_float_fix(problem, integer);
            }
        }
        self.log.push(problem);
    }

    /// A fix-it for an `int` where a `float` is needed.
    pub(super) fn with_float_fix(&self, problem: Diagnostic, integer: &Expr) -> Diagnostic {
        let text = self.source.slice(integer.span);
        let title = self.version.title();
        let literal = !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
        if self.version < Version::V120 && literal {
            return problem.note(format!("{title} does not convert int to float by itself")).fix(
                format!("write `{text}.0`"),
                integer.span,
                format!("{text}.0"),
            );
        }
        if self.version < Version::V120 && integer.ty == INT {
            return problem.note(format!("{title} does not convert int to float by itself")).fix(
                format!("write `float({text})`"),
                integer.span,
                format!("float({text})"),
            );
        }
        problem
    }

    fn assign(
        &mut self,
        op: Option<BinaryOp>,
        target: &ast::Expr,
        value: &ast::Expr,
        span: Span,
    ) -> Expr {
        let target = self.expr(target);
        let value = self.expr(value);
        self.check_written(&target, "assign to");
        if target.is_error() || value.is_error() {
            return Expr::error(span);
        }
        let ty = target.ty.clone();
        let value = match op {
            None => {
                if self.version < Version::V120 && ty.has_array() {
                    let message = format!("arrays cannot be assigned in {}", self.version.title());
                    self.error(span, "5.8", message);
                }
                self.implicit_conversion(value, &ty, "assign")
            }
            Some(op) => {
                let Some(typed) = operators::binary(op, &ty, &value.ty, self.version) else {
                    self.mismatch(op, &target, &value, span);
                    return Expr::error(span);
                };
                if typed.result != ty || typed.left != ty {
                    let message = format!(
                        "`{}=` would give {}, which does not fit into {ty}",
                        op.text(),
                        typed.result
                    );
                    self.error(span, "5.8", message);
                    return Expr::error(span);
                }
                if op.is_integer() {
                    self.has_integers(span);
                }
                convert(value, &typed.right)
            }
        };
        let kind = ExprKind::Assign(op, Box::new(target), Box::new(value));
        Expr { ty, span, constant: false, kind }
    }

    /// The value implicitly converted to `ty`, or an error that begins with `verb`.
    pub(super) fn implicit_conversion(&mut self, value: Expr, ty: &Type, verb: &str) -> Expr {
        if value.ty == *ty || value.is_error() || *ty == Type::Error {
            return value;
        }
        if converts(&value.ty, ty, self.version) {
            return convert(value, ty);
        }
        if let Some(integer) = self.as_integer_call(&value, ty) {
            return integer;
        }
        let message = format!("cannot {verb} {} where {ty} is needed", value.ty);
        let title = self.version.title();
        let mut problem = Diagnostic::error(value.span, message)
            .rule(format!("{title} section 4.1.10 lists the conversions that need no constructor"));
        if *ty == FLOAT && value.ty == INT {
            problem = self.with_float_fix(problem, &value);
        } else if let (Type::Vector(_, n), Type::Vector(_, m)) = (&value.ty, ty)
            && n > m
            && *m > 1
        {
            let swizzle = &"xyzw"[..usize::from(*m)];
            problem = problem.help(format!("take the components needed, such as `.{swizzle}`"));
        } else if ty.scalar().is_some() && value.ty.is_scalar() && ty.is_scalar() {
            problem = problem.help(format!("convert it: `{ty}(...)`"));
        }
        let span = value.span;
        self.log.push(problem);
        Expr::error(span)
    }

    fn conditional(&mut self, parts: &[ast::Expr; 3], span: Span) -> Expr {
        let [condition, accept, reject] = [&parts[0], &parts[1], &parts[2]].map(|e| self.expr(e));
        let condition = self.implicit_conversion(condition, &BOOL, "test");
        if condition.is_error() || accept.is_error() || reject.is_error() {
            return Expr::error(span);
        }
        let ty = if accept.ty == reject.ty || converts(&reject.ty, &accept.ty, self.version) {
            accept.ty.clone()
        } else if converts(&accept.ty, &reject.ty, self.version) {
            reject.ty.clone()
        } else {
            let message = format!("`?:` chooses between {} and {}", accept.ty, reject.ty);
            let rule = format!("{} section 5.9: both have one type", self.version.title());
            self.log.push(Diagnostic::error(span, message).rule(rule));
            return Expr::error(span);
        };
        if ty.has_sampler() || ty.has_array() && self.version < Version::V120 {
            self.error(span, "6.4", format!("`?:` cannot choose between two of {ty}"));
            return Expr::error(span);
        }
        let constant = condition.constant && accept.constant && reject.constant;
        let all = [condition, convert(accept, &ty), convert(reject, &ty)];
        Expr { ty, span, constant, kind: ExprKind::Conditional(Box::new(all)) }
    }

    /// A reference to a built-in variable, which the stage has.
    pub(super) fn builtin_expr(&mut self, name: &str, span: Span) -> Expr {
        self.name(&Arc::from(name), span)
    }
}

/// The value converted to `ty`, which must be an allowed conversion.
pub(super) fn convert(value: Expr, ty: &Type) -> Expr {
    if value.ty == *ty {
        return value;
    }
    let (span, constant) = (value.span, value.constant);
    Expr { ty: ty.clone(), span, constant, kind: ExprKind::Convert(Box::new(value)) }
}
