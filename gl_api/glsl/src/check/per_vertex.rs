//! The built-in block `gl_PerVertex` and its redeclarations (GLSL 1.50 section 7.1).

use super::Checker;
use super::scope::Symbol;
use crate::ast::{self, Qualifier};
use crate::builtins::variable::{ALSO_PER_VERTEX, PER_VERTEX};
use crate::hir::{InterfaceQualifiers, VarRef};
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::types::Type;
use rasterizer::ir::Stage;
use std::collections::BTreeSet;
use std::sync::Arc;

const SECTION: &str = "7.1";

impl Checker<'_> {
    /// Whether a redeclaration of the block leaves a variable out. Members of `gl_in` are written
    /// with it before their names.
    pub(super) fn leaves_out(&self, name: &str) -> bool {
        let (member, left) = match name.strip_prefix("gl_in.") {
            Some(member) => (member, &self.unit.per_vertex.inputs),
            None => (name, &self.unit.per_vertex.outputs),
        };
        PER_VERTEX.contains(&member) && left.as_ref().is_some_and(|left| !left.contains(member))
    }

    /// The redeclaration of `gl_PerVertex`.
    pub(super) fn per_vertex(&mut self, declared: &ast::BlockDecl, way: Qualifier, span: Span) {
        let name = &declared.name;
        let is_input = way == Qualifier::In;
        let instance = declared.instance.as_ref();
        let fits = match (self.stage, is_input) {
            (Stage::Vertex, false) => instance.is_none(),
            (Stage::Geometry, false) => instance.is_none(),
            (Stage::Geometry, true) => instance.is_some_and(|instance| {
                &*instance.name.text == "gl_in" && instance.array.len() == 1
            }),
            (Stage::Vertex, true) | (Stage::Fragment, _) => {
                let way = if is_input { "input" } else { "output" };
                let message = format!("this stage has no block `gl_PerVertex` as {way}");
                self.error(span, SECTION, message);
                return;
            }
        };
        if !fits {
            let message = match is_input {
                true => "the block of inputs is `gl_in`, an array without a size",
                false => "the block of outputs has no name behind it",
            };
            self.error(name.span, SECTION, message);
            return;
        }
        let prefix = if is_input { "gl_in." } else { "" };
        let known =
            if is_input { &self.unit.per_vertex.inputs } else { &self.unit.per_vertex.outputs };
        if known.is_some() {
            self.declared_already(name, &Symbol::Block);
            return;
        }
        let used = self.unit.globals.iter().find(|global| {
            let member = global.name.strip_prefix(prefix);
            member.is_some_and(|member| PER_VERTEX.contains(&member))
                && (global.references > 0 || global.redeclared)
        });
        if let Some(used) = used {
            let message = format!("`{}` is used before `gl_PerVertex` is redeclared", used.name);
            let problem = Diagnostic::error(name.span, message).rule(self.rule(SECTION));
            self.log.push(problem.help("put the redeclaration first"));
            return;
        }
        if let Some(instance) = instance {
            let mut ty = Type::Array(Box::new(Type::Error), None);
            if let [size] = &instance.array[..] {
                ty = self.array_of(crate::types::FLOAT, size);
            }
            self.per_vertex_type(ty, name.span);
        }
        let mut left: BTreeSet<Arc<str>> = BTreeSet::new();
        for declaration in &declared.members {
            for member in &declaration.names {
                let ty = self.type_of(&declaration.ty.ty, &member.array);
                if self.per_vertex_member(member, &declaration.ty, (way, span), prefix, &ty)
                    && !ALSO_PER_VERTEX.contains(&&*member.name.text)
                {
                    left.insert(member.name.text.clone());
                }
            }
        }
        match is_input {
            true => self.unit.per_vertex.inputs = Some(left),
            false => self.unit.per_vertex.outputs = Some(left),
        }
    }

    /// Whether a member of the redeclaration is one of the block.
    fn per_vertex_member(
        &mut self,
        member: &ast::Declarator,
        declared: &ast::QualifiedType,
        (way, span): (Qualifier, Span),
        prefix: &str,
        ty: &Type,
    ) -> bool {
        let text = &member.name.text;
        let full = format!("{prefix}{text}");
        let is_member = PER_VERTEX.contains(&&**text)
            || self.stage == Stage::Vertex && ALSO_PER_VERTEX.contains(&&**text);
        let known = match is_member {
            true => self.scopes.find_global(&full).and_then(Symbol::variable),
            false => None,
        };
        let known = known.or_else(|| match is_member {
            true => self.builtin_variable(&full),
            false => None,
        });
        let Some(var) = known else {
            let message = format!("`{text}` is no member of `gl_PerVertex`");
            self.error(member.name.span, SECTION, message);
            return false;
        };
        let mut qualified = declared.clone();
        if !qualified.qualifiers.iter().any(|(qualifier, _)| *qualifier == way) {
            let before = |(other, _): &&(Qualifier, Span)| other.rank() < way.rank();
            let at = qualified.qualifiers.iter().take_while(before).count();
            qualified.qualifiers.insert(at, (way, span));
        }
        let Some((_, interface_qualifiers)) = self.global_storage(&qualified) else { return false };
        self.resize_per_vertex(var, member, ty, prefix, interface_qualifiers)
    }

    fn resize_per_vertex(
        &mut self,
        var: VarRef,
        member: &ast::Declarator,
        ty: &Type,
        prefix: &str,
        interface_qualifiers: InterfaceQualifiers,
    ) -> bool {
        let known = self.variable(var).ty.clone();
        // Of `gl_in`, the type of an element.
        let inner = if let (Type::Array(element, _), "gl_in.") = (&known, prefix) {
            (**element).clone()
        } else {
            known.clone()
        };
        if !self.resizes(&inner, ty, 0) {
            let message = format!("`{}` is {inner}, not {ty}", member.name.text);
            self.error(member.name.span, SECTION, message);
            return false;
        }
        let variable = self.variable_mut(var);
        variable.interface_qualifiers = interface_qualifiers;
        if matches!(ty, Type::Array(_, Some(_))) {
            let own = ty.clone();
            variable.ty = if let (Type::Array(_, len), "gl_in.") = (known, prefix) {
                Type::Array(Box::new(own), len)
            } else {
                own
            };
        }
        true
    }

    /// Reports a variable that the redeclared block leaves out.
    pub(super) fn left_out(&mut self, name: &str, span: Span) {
        let message = format!("`{name}` is not in the redeclared `gl_PerVertex`");
        let problem = Diagnostic::error(span, message).rule(self.rule(SECTION));
        self.log.push(problem.help("add it to that block"));
    }
}
