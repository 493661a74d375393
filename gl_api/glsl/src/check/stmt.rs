//! Statements (GLSL 1.30 sections 6.2 to 6.4).

use super::Checker;
use super::operators::converts;
use super::scope::Symbol;
use crate::ast::{self, Qualifier, StmtKind};
use crate::hir::{Case, Expr, Loop, Stmt, Storage, VarRef};
use crate::language::Availability;
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::types::{BOOL, Scalar, Type};
use rasterizer::ir::Stage;
use std::collections::BTreeSet;

impl Checker<'_> {
    pub(super) fn statements(&mut self, statements: &[ast::Stmt]) -> Vec<Stmt> {
        let mut all = Vec::new();
        for statement in statements {
            if self.log.is_full() {
                break;
            }
            self.statement(statement, &mut all);
        }
        all
    }

    fn statement(&mut self, statement: &ast::Stmt, all: &mut Vec<Stmt>) {
        match &statement.kind {
            StmtKind::Empty => {}
            StmtKind::Precision(precision, ty) => self.default_precision(*precision, ty),
            StmtKind::Declaration(declaration) => self.local_declaration(declaration, all),
            StmtKind::Prototype(function) => self.function(function),
            StmtKind::Expr(expr) => {
                let expr = self.expr(expr);
                all.push(Stmt::Expr(expr));
            }
            StmtKind::Block(statements) => {
                let block = self.scoped(|checker| checker.statements(statements));
                all.push(Stmt::Block(block));
            }
            StmtKind::If(condition, accept, reject) => {
                let condition = self.condition(condition);
                let accept = self.branch(accept);
                let reject = reject.as_ref().map_or(Vec::new(), |reject| self.branch(reject));
                all.push(Stmt::If(condition, accept, reject));
            }
            StmtKind::For(init, condition, step, body) => {
                let block = self.scoped(|checker| {
                    let mut block = Vec::new();
                    if let Some(init) = init {
                        checker.statement(init, &mut block);
                    }
                    checker.for_loop(condition.as_ref(), step.as_ref(), body, &mut block);
                    block
                });
                all.push(Stmt::Block(block));
            }
            StmtKind::While(condition, body) => {
                let block = self.scoped(|checker| {
                    let mut block = Vec::new();
                    checker.for_loop(Some(condition), None, body, &mut block);
                    block
                });
                all.push(Stmt::Block(block));
            }
            StmtKind::DoWhile(body, condition) => {
                let body = self.loop_body(|checker| checker.branch(body));
                let after = Some(self.condition(condition));
                let looped = Loop {
                    declare: None,
                    condition_before: None,
                    body,
                    step: None,
                    condition_after: after,
                };
                all.push(Stmt::Loop(Box::new(looped)));
            }
            StmtKind::Switch(selector, body) => self.switch(selector, body, all),
            StmtKind::Case(_) | StmtKind::Default => {
                let message = "`case` and `default` stand directly in a `switch`";
                self.error(statement.span, "6.2", message);
            }
            StmtKind::Return(value) => self.return_statement(value.as_ref(), statement.span, all),
            StmtKind::Break => {
                if self.body.as_ref().is_none_or(|body| body.breakable == 0) {
                    self.misplaced(statement.span, "`break` outside of a loop or `switch`");
                }
                all.push(Stmt::Break);
            }
            StmtKind::Continue => {
                if self.body.as_ref().is_none_or(|body| body.loops == 0) {
                    self.misplaced(statement.span, "`continue` outside of a loop");
                }
                all.push(Stmt::Continue);
            }
            StmtKind::Discard => {
                if self.stage != Stage::Fragment {
                    self.misplaced(statement.span, "only the fragment stage can `discard`");
                }
                all.push(Stmt::Discard);
            }
        }
    }

    fn misplaced(&mut self, span: Span, message: &str) {
        let rule = format!("{} section 6.4", self.version.title());
        self.log.push(Diagnostic::error(span, message).rule(rule));
    }

    fn condition(&mut self, condition: &ast::Expr) -> Expr {
        let checked = self.expr(condition);
        self.boolean(checked)
    }

    fn boolean(&mut self, checked: Expr) -> Expr {
        if checked.ty != BOOL && !checked.is_error() {
            let message = format!("a condition is a bool, not {}", checked.ty);
            let rule = format!("{} section 6.2", self.version.title());
            self.log.push(Diagnostic::error(checked.span, message).rule(rule));
            return Expr::error(checked.span);
        }
        checked
    }

    /// A statement in a scope of its own.
    fn branch(&mut self, statement: &ast::Stmt) -> Vec<Stmt> {
        self.scoped(|checker| checker.unscoped(statement))
    }

    /// A statement whose braces, if it has some, open no scope.
    fn unscoped(&mut self, statement: &ast::Stmt) -> Vec<Stmt> {
        if let StmtKind::Block(statements) = &statement.kind {
            return self.statements(statements);
        }
        let mut all = Vec::new();
        self.statement(statement, &mut all);
        all
    }

    /// The body of a loop. In `for` and `while` it shares one scope with the head (section 6.3).
    fn loop_body(&mut self, check: impl FnOnce(&mut Self) -> Vec<Stmt>) -> Vec<Stmt> {
        self.nest(1);
        let body = check(self);
        self.nest(-1);
        body
    }

    fn nest(&mut self, by: i32) {
        if let Some(body) = &mut self.body {
            body.loops = body.loops.saturating_add_signed(by);
            body.breakable = body.breakable.saturating_add_signed(by);
        }
    }

    fn for_loop(
        &mut self,
        condition: Option<&ast::Condition>,
        step: Option<&ast::Expr>,
        body: &ast::Stmt,
        all: &mut Vec<Stmt>,
    ) {
        let (declare, before) = match condition {
            None => (None, None),
            Some(ast::Condition::Expr(expr)) => (None, Some(self.condition(expr))),
            Some(ast::Condition::Declaration(declaration)) => self.declared_condition(declaration),
        };
        let step = step.map(|step| self.expr(step));
        let body = self.loop_body(|checker| checker.unscoped(body));
        all.push(Stmt::Loop(Box::new(Loop {
            declare,
            condition_before: before,
            body,
            step,
            condition_after: None,
        })));
    }

    /// `bool name = value` as the condition of a loop.
    fn declared_condition(
        &mut self,
        declaration: &ast::Declaration,
    ) -> (Option<u32>, Option<Expr>) {
        let mut declared = Vec::new();
        self.local_declaration(declaration, &mut declared);
        if let Some(Stmt::Declare(local, Some(value))) = declared.pop() {
            let value = self.boolean(value);
            // Each iteration writes it.
            self.variable_mut(VarRef::Local(local)).written = true;
            return (Some(local), Some(value));
        }
        self.error(declaration.ty.ty.span, "6.2", "the condition declares no value");
        (None, None)
    }

    fn local_declaration(&mut self, declaration: &ast::Declaration, all: &mut Vec<Stmt>) {
        self.check_order(&declaration.ty.qualifiers);
        let mut storage = Storage::Plain;
        for &(qualifier, span) in &declaration.ty.qualifiers {
            match qualifier {
                Qualifier::Const => storage = Storage::Const,
                Qualifier::Precision(_) => {}
                Qualifier::Attribute
                | Qualifier::Varying
                | Qualifier::Uniform
                | Qualifier::In
                | Qualifier::Out
                | Qualifier::Inout
                | Qualifier::Centroid
                | Qualifier::Invariant
                | Qualifier::Smooth
                | Qualifier::Flat
                | Qualifier::NoPerspective
                | Qualifier::OriginUpperLeft
                | Qualifier::PixelCenterInteger
                | Qualifier::Location(_)
                | Qualifier::Index(_)
                | Qualifier::Binding(_)
                | Qualifier::Depth(_)
                | Qualifier::Block(_)
                | Qualifier::Primitive(_)
                | Qualifier::MaxVertices(_) => {
                    let rule = format!("{} section 4.3", self.version.title());
                    let message = "a variable in a function can only be `const`";
                    self.log.push(Diagnostic::error(span, message).rule(rule));
                }
            }
        }
        self.precision_of(&declaration.ty);
        if declaration.names.is_empty() {
            let _ = self.type_of(&declaration.ty.ty, &[]);
        }
        for declared in &declaration.names {
            let ty = self.type_of(&declaration.ty.ty, &declared.array);
            let init = declared.init.as_ref().map(|init| self.initializer(init, &ty));
            let ty = self.sized_by(ty, init.as_ref(), declared.name.span);
            if let Some(var) = self.completes_array(declared, &ty) {
                if let (Some(init), VarRef::Local(local)) = (init, var) {
                    let init = self.implicit_conversion(init, &ty, "initialize with");
                    all.push(Stmt::Declare(local, Some(init)));
                }
                continue;
            }
            self.check_new(&declared.name);
            let mut variable = self.new_variable(declared, ty, storage);
            self.initialize(&mut variable, init, declared.name.span);
            self.check_sized(&variable);
            let init = variable.init.take();
            let Some(body) = &mut self.body else { return };
            let local = body.locals.len() as u32;
            body.locals.push(variable);
            let var = VarRef::Local(local);
            self.scopes.add(declared.name.text.clone(), Symbol::Variable(var));
            all.push(Stmt::Declare(local, init));
        }
    }

    fn return_statement(&mut self, value: Option<&ast::Expr>, span: Span, all: &mut Vec<Stmt>) {
        let value = value.map(|value| self.expr(value));
        let result = self.result_type().cloned().unwrap_or(Type::Void);
        if let Some(body) = &mut self.body {
            body.returns = true;
        }
        let value = match (value, &result) {
            (None, Type::Void | Type::Error) => None,
            (None, ty) => {
                self.error(span, "6.4", format!("the function returns {ty}: a value is missing"));
                None
            }
            (Some(value), Type::Void) => {
                if !value.is_error() {
                    self.error(value.span, "6.4", "the function returns nothing");
                }
                None
            }
            (Some(value), ty) => Some(self.returned(value, ty)),
        };
        all.push(Stmt::Return(value));
    }

    /// The value of a `return`, which is not converted.
    fn returned(&mut self, value: Expr, ty: &Type) -> Expr {
        let relaxed = self.language.has(Availability::RELAXED);
        if relaxed || value.ty == *ty || !converts(&value.ty, ty, self.version) {
            return self.implicit_conversion(value, ty, "return");
        }
        let message = format!("cannot return {} where {ty} is needed", value.ty);
        let text = self.source.slice(value.span);
        let problem = Diagnostic::error(value.span, message)
            .rule("GLSL 4.20 is the first to convert what is returned (section 4.1.10)")
            .fix(format!("write `{ty}({text})`"), value.span, format!("{ty}({text})"));
        let span = value.span;
        self.log.push(problem);
        Expr::error(span)
    }

    fn switch(&mut self, selector: &ast::Expr, body: &[ast::Stmt], all: &mut Vec<Stmt>) {
        let selector = self.expr(selector);
        let integer = matches!(selector.ty, Type::Vector(Scalar::Int | Scalar::Uint, 1));
        if !integer && !selector.is_error() {
            let message = format!("`switch` chooses by an integer, not {}", selector.ty);
            self.log.push(Diagnostic::error(selector.span, message).rule(self.rule("6.2")));
        }
        if let Some(body) = &mut self.body {
            body.breakable += 1;
        }
        self.scopes.open();
        let mut cases: Vec<Case> = Vec::new();
        let mut seen = SeenLabels::default();
        for statement in body {
            let label = match &statement.kind {
                StmtKind::Case(label) => self.case_label(label, &selector, &mut seen),
                StmtKind::Default => {
                    if std::mem::replace(&mut seen.default, true) {
                        self.error(statement.span, "6.2", "a second `default`");
                    }
                    Some(CaseLabel::Default)
                }
                StmtKind::Empty
                | StmtKind::Precision(..)
                | StmtKind::Declaration(_)
                | StmtKind::Prototype(_)
                | StmtKind::Expr(_)
                | StmtKind::Block(_)
                | StmtKind::If(..)
                | StmtKind::For(..)
                | StmtKind::While(..)
                | StmtKind::DoWhile(..)
                | StmtKind::Switch(..)
                | StmtKind::Return(_)
                | StmtKind::Break
                | StmtKind::Continue
                | StmtKind::Discard => {
                    let mut block = Vec::new();
                    self.statement(statement, &mut block);
                    match cases.last_mut() {
                        Some(case) => case.body.append(&mut block),
                        None => {
                            let message = "a statement in a `switch` before the first label";
                            let problem = Diagnostic::error(statement.span, message)
                                .rule(self.rule("6.2"))
                                .help("put it behind a `case` or before the `switch`");
                            self.log.push(problem);
                        }
                    }
                    None
                }
            };
            let Some(label) = label else { continue };
            if cases.last().is_none_or(|case| !case.body.is_empty()) {
                cases.push(Case { labels: Vec::new(), default: false, body: Vec::new() });
            }
            if let Some(case) = cases.last_mut() {
                match label {
                    CaseLabel::Value(value) => case.labels.push(value),
                    CaseLabel::Default => case.default = true,
                    CaseLabel::Wrong => {}
                }
            }
        }
        if let (Some(case), Some(last)) = (cases.last(), body.last())
            && case.body.is_empty()
            && !matches!(last.kind, StmtKind::Empty)
        {
            let problem = Diagnostic::error(last.span, "nothing follows the last label")
                .rule(self.rule("6.2"))
                .help("write `break;` after it");
            self.log.push(problem);
        }
        self.scopes.close();
        if let Some(body) = &mut self.body {
            body.breakable -= 1;
        }
        all.push(Stmt::Switch(selector, cases));
    }

    /// The value of a `case`, which must be unique.
    fn case_label(
        &mut self,
        label: &ast::Expr,
        selector: &Expr,
        seen: &mut SeenLabels,
    ) -> Option<CaseLabel> {
        let label = self.expr(label);
        let value = self.evaluate(&label).filter(|_| label.ty == selector.ty);
        match value {
            Some(value) if seen.values.insert(value[0]) => return Some(CaseLabel::Value(value[0])),
            Some(_) => {
                let problem = Diagnostic::error(label.span, "a second `case` with this value");
                self.log.push(problem.rule(self.rule("6.2")));
            }
            None if label.is_error() || selector.is_error() => {}
            None => {
                let message = format!("a label is a constant {}", selector.ty);
                self.log.push(Diagnostic::error(label.span, message).rule(self.rule("6.2")));
            }
        }
        Some(CaseLabel::Wrong)
    }
}

/// A label of a `switch`.
#[derive(Clone, Copy)]
enum CaseLabel {
    /// `case` with its value.
    Value(u32),
    /// `default`.
    Default,
    /// A `case` with an error.
    Wrong,
}

/// The labels of a `switch` so far.
#[derive(Default)]
struct SeenLabels {
    values: BTreeSet<u32>,
    default: bool,
}
