//! L-values (GLSL 1.30 section 5.8).

use super::Checker;
use crate::builtins::variable;
use crate::hir::{Direction, Expr, ExprKind, Storage, Variable};
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use rasterizer::ir::Stage;

impl Checker<'_> {
    /// Checks that `target` is an l-value, and marks its variable as written. `what` is the verb of
    /// the message.
    pub(super) fn check_written(&mut self, target: &Expr, what: &str) {
        if target.is_error() {
            return;
        }
        let mut part = target;
        loop {
            match &part.kind {
                ExprKind::Swizzle(base, components) => {
                    let twice =
                        (1..components.len()).any(|i| components[..i].contains(&components[i]));
                    if twice {
                        let message = "a swizzle that is written cannot name a component twice";
                        self.reject_lvalue(part.span, message);
                        return;
                    }
                    part = base;
                }
                ExprKind::Index(base, _) | ExprKind::Field(base, _) => part = base,
                ExprKind::Var(_) => break,
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
                | ExprKind::Error => {
                    let message = format!("cannot {what} this: it is a value, not a variable");
                    self.reject_lvalue(part.span, message);
                    return;
                }
            }
        }
        let Some(root) = part.root() else { return };
        let variable = self.variable(root);
        if let Some(kind) = self.read_only(variable) {
            let name = variable.name.clone();
            self.reject_lvalue(target.span, format!("cannot {what} `{name}`: it is {kind}"));
            return;
        }
        self.variable_mut(root).written = true;
    }

    fn reject_lvalue(&mut self, span: Span, message: impl Into<String>) {
        let rule = format!("{} section 5.8: what is written is an l-value", self.version.title());
        self.log.push(Diagnostic::error(span, message).rule(rule));
    }

    /// Why a variable is read-only.
    fn read_only(&self, variable: &Variable) -> Option<&'static str> {
        if variable.ty.has_sampler() {
            return Some("a sampler");
        }
        match variable.storage {
            Storage::Const => Some("a constant"),
            Storage::Uniform => Some("a uniform"),
            Storage::Attribute => Some("a vertex attribute"),
            Storage::Input(_) => Some("an input of the fragment stage"),
            Storage::Builtin(builtin) if !variable::is_writable(builtin, self.stage) => {
                Some("read-only")
            }
            Storage::Parameter(Direction::In | Direction::Out | Direction::Inout)
            | Storage::Plain
            | Storage::Output(_)
            | Storage::FragmentOutput
            | Storage::Builtin(_) => None,
        }
    }

    /// Whether this is the vertex stage.
    pub(super) fn is_vertex(&self) -> bool {
        self.stage == Stage::Vertex
    }
}
