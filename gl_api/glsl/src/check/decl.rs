//! Declarations of variables and types (GLSL 1.30 chapter 4).

use super::Checker;
use super::scope::Symbol;
use crate::ast::{self, TypeBase};
use crate::builtins::variable;
use crate::hir::{Expr, ExprKind, InterfaceQualifiers, Storage, VarRef, Variable};
use crate::language::{Availability, Extension, Version};
use crate::limits::{MAX_DIMENSIONS, MAX_NAME_ES_300, MAX_SCALARS, MAX_STRUCT_DEPTH};
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::text::spelling::closest;
use crate::types::{Scalar, Struct, Type};
use std::collections::BTreeSet;
use std::sync::Arc;

impl Checker<'_> {
    /// The type of a declaration, with the array sizes after the name, which are the outer ones
    /// (ARB_arrays_of_arrays).
    pub(super) fn type_of(&mut self, name: &ast::TypeName, after: &[ast::ArraySize]) -> Type {
        let base = match &name.base {
            TypeBase::Struct(declared) => match &self.declared {
                // An earlier name of the same declaration.
                Some((known, ty)) if Arc::ptr_eq(known, declared) => ty.clone(),
                Some(_) | None => {
                    let ty = self.structure(declared, name.span);
                    self.declared = Some((Arc::clone(declared), ty.clone()));
                    ty
                }
            },
            TypeBase::Named(word) => self.named_type(word, name.span),
        };
        let count = name.array.len() + after.len();
        let allowed = match self.language.enabled(Extension::ArraysOfArrays) {
            true => MAX_DIMENSIONS as usize,
            false => 1,
        };
        if let (true, Some(size)) = (count > allowed, after.last().or(name.array.last())) {
            let message = match allowed {
                1 => "arrays of arrays are not in this version".to_owned(),
                _ => format!("an array has {MAX_DIMENSIONS} dimensions at most"),
            };
            self.error(size.span, "4.1.9", message);
            return Type::Error;
        }
        if count > 1
            && let Some(extension) =
                self.language.warns(Availability::extension(Extension::ArraysOfArrays))
        {
            let message = format!("arrays of arrays come from {}", extension.name());
            self.log.push(Diagnostic::warning(name.span, message));
        }
        if base == Type::Void && count > 0 {
            self.error(name.span, "4.1.1", "there are no arrays of void");
            return Type::Error;
        }
        let mut ty = base;
        for size in name.array.iter().rev().chain(after.iter().rev()) {
            ty = self.array_of(ty, size);
        }
        if ty.scalars() > MAX_SCALARS {
            let message = format!("{ty} has more than {MAX_SCALARS} components");
            self.error(name.span, "4.1", message);
            return Type::Error;
        }
        ty
    }

    fn named_type(&mut self, word: &Arc<str>, span: Span) -> Type {
        if let Some(ty) = Type::named(word, self.language) {
            return ty;
        }
        if let Some(Symbol::Struct(structure)) = self.scopes.find(word) {
            return Type::Struct(structure.clone());
        }
        if let Some(ty) = variable::structure(word, self.language) {
            return ty;
        }
        let mut problem =
            Diagnostic::error(span, format!("there is no type `{word}`")).rule(self.rule("4.1"));
        if let Some(since) = Type::availability(word) {
            if let Some(advice) = self.language.advice(since) {
                problem = problem.help(advice);
            }
        } else if let Some(near) = closest(word, Type::names(self.language)) {
            problem = problem.fix(format!("did you mean `{near}`?"), span, near.to_owned());
        }
        self.log.push(problem);
        Type::Error
    }

    pub(super) fn array_of(&mut self, element: Type, size: &ast::ArraySize) -> Type {
        if element == Type::Error {
            return Type::Error;
        }
        let Some(expr) = &size.size else { return Type::Array(Box::new(element), None) };
        let checked = self.expr(expr);
        if checked.is_error() {
            return Type::Error;
        }
        let integer = matches!(checked.ty, Type::Vector(Scalar::Int | Scalar::Uint, 1));
        let value = self.evaluate(&checked).filter(|_| integer);
        let Some(value) = value else {
            let message = "the size of an array is a constant integer";
            let rule = format!("{} section 4.1.9", self.version.title());
            self.log.push(Diagnostic::error(size.span, message).rule(rule));
            return Type::Error;
        };
        match value[0] as i32 {
            len @ 1.. => Type::Array(Box::new(element), Some(len as u32)),
            len => {
                self.error(
                    size.span,
                    "4.1.9",
                    format!("the size of an array is at least 1, not {len}"),
                );
                Type::Error
            }
        }
    }

    fn structure(&mut self, declared: &ast::StructDecl, span: Span) -> Type {
        let mut fields: Vec<(Arc<str>, Type)> = Vec::new();
        let mut names: BTreeSet<String> = BTreeSet::new();
        let mut precisions = Vec::new();
        for (qualified, name, array) in &declared.fields {
            let ty = &qualified.ty;
            if matches!(ty.base, TypeBase::Struct(_)) && self.version != Version::V110 {
                let message = "a structure cannot be declared inside another";
                self.error(ty.span, "4.1.8", message);
                return Type::Error;
            }
            let field = self.type_of(ty, array);
            self.check_reserved(name);
            if !names.insert(name.text.to_string()) {
                self.error(name.span, "4.1.8", format!("a second member `{}`", name.text));
                continue;
            }
            match &field {
                Type::Error => return Type::Error,
                Type::Void => self.error(name.span, "4.1.1", "a member cannot be void"),
                array if array.is_unsized() => {
                    self.error(name.span, "4.1.9", "an array in a structure needs a size");
                }
                Type::Vector(..)
                | Type::Matrix(..)
                | Type::Sampler(_)
                | Type::Struct(_)
                | Type::Array(..) => {}
            }
            fields.push((name.text.clone(), field));
            precisions.push(self.precision_of(qualified));
        }
        if fields.is_empty() {
            self.error(span, "4.1.8", "a structure needs a member");
            return Type::Error;
        }
        let name = declared.name.as_ref().map_or(Arc::from(""), |name| name.text.clone());
        let structure = Struct::new(name.clone(), fields).with_precisions(precisions);
        if structure.scalars > MAX_SCALARS || structure.depth > MAX_STRUCT_DEPTH {
            let message = format!(
                "the structure has more than {MAX_SCALARS} components or {MAX_STRUCT_DEPTH} levels"
            );
            self.error(span, "4.1.8", message);
            return Type::Error;
        }
        let structure = Arc::new(structure);
        if let Some(declared) = &declared.name {
            self.check_new(declared);
            if self.scopes.is_function_apart(&name) {
                self.declared_already(declared, &Symbol::Functions);
            }
            self.scopes.add(name, Symbol::Struct(structure.clone()));
        }
        Type::Struct(structure)
    }

    /// Reports a name that is reserved, or too long.
    pub(super) fn check_reserved(&mut self, name: &ast::Name) {
        let rule = format!("{} section 3.7", self.version.title());
        if name.text.starts_with("gl_") {
            let message = format!("`{}`: names that begin with gl_ are reserved", name.text);
            self.log.push(Diagnostic::error(name.span, message).rule(rule));
        } else if self.version == Version::Es300 && name.text.len() > MAX_NAME_ES_300 {
            let message = format!(
                "a name of {} characters, of which it may have {MAX_NAME_ES_300}",
                name.text.len()
            );
            self.log.push(Diagnostic::error(name.span, message).rule("GLSL ES 3.00 section 3.8"));
        }
    }

    /// Reports a name that the innermost scope already has, or that is reserved.
    pub(super) fn check_new(&mut self, name: &ast::Name) {
        self.check_reserved(name);
        match self.scopes.find_innermost(&name.text).cloned() {
            None | Some(Symbol::Undeclared(_)) => {}
            Some(symbol) => self.declared_already(name, &symbol),
        }
    }

    /// Reports a second declaration.
    pub(super) fn declared_already(&mut self, name: &ast::Name, first: &Symbol) {
        let mut message = format!("`{}` is declared already", name.text);
        if let Symbol::Variable(var) | Symbol::Member(var, _) = first {
            let line = self.source.line_of(self.variable(*var).span.start).1;
            message = format!("{message}, in line {line}");
        }
        self.error(name.span, "4.2.2", message);
    }

    pub(super) fn global_declaration(&mut self, declaration: &ast::Declaration) {
        let Some((storage, interface_qualifiers)) = self.global_storage(&declaration.ty) else {
            return;
        };
        let precision = self.precision_of(&declaration.ty);
        if declaration.names.is_empty() {
            let _ = self.type_of(&declaration.ty.ty, &[]);
            return;
        }
        for declared in &declaration.names {
            let ty = self.type_of(&declaration.ty.ty, &declared.array);
            if self.redeclares_builtin(declared, &ty, storage, interface_qualifiers) {
                continue;
            }
            let init = declared.init.as_ref().map(|init| self.initializer(init, &ty));
            let ty = self.sized_by(ty, init.as_ref(), declared.name.span);
            let ty = self.passed_type(ty, storage, declared.name.span);
            if let Some(var) = self.completes_array(declared, &ty) {
                if init.is_some() {
                    let mut variable = self.variable(var).clone();
                    self.initialize(&mut variable, init, declared.name.span);
                    *self.variable_mut(var) = variable;
                }
                continue;
            }
            self.check_new(&declared.name);
            self.check_interface_type(storage, &ty, declared.name.span);
            self.check_layout(&declared.name, interface_qualifiers);
            self.check_binding(storage, &ty, interface_qualifiers);
            let type_span = (declaration.names.len() == 1).then_some(declaration.ty.ty.span);
            let mut variable = self.new_variable(declared, ty, storage);
            variable.type_span = type_span.filter(|_| declared.array.is_empty());
            variable.interface_qualifiers =
                InterfaceQualifiers { precision, ..interface_qualifiers };
            self.initialize(&mut variable, init, declared.name.span);
            self.check_sized(&variable);
            let var = VarRef::Global(self.unit.globals.len() as u32);
            self.unit.globals.push(variable);
            self.scopes.add(declared.name.text.clone(), Symbol::Variable(var));
        }
    }

    pub(super) fn new_variable(
        &self,
        declared: &ast::Declarator,
        ty: Type,
        storage: Storage,
    ) -> Variable {
        Variable::new(declared.name.text.clone(), ty, storage, declared.name.span)
    }

    /// Checks an initializer and stores it in the variable.
    pub(super) fn initialize(&mut self, variable: &mut Variable, init: Option<Expr>, span: Span) {
        let Some(init) = init else {
            if variable.storage == Storage::Const {
                let message = format!("the constant `{}` needs a value", variable.name);
                let rule = format!("{} section 4.3.2", self.version.title());
                self.log.push(Diagnostic::error(span, message).rule(rule));
            }
            return;
        };
        let unfit = match variable.storage {
            Storage::Plain | Storage::Const => None,
            Storage::Uniform if self.version.is_es() => Some("uniforms take no value in GLSL ES"),
            Storage::Uniform if self.version >= Version::V120 => None,
            Storage::Uniform => Some("uniforms take no value before GLSL 1.20"),
            Storage::Attribute
            | Storage::Output(_)
            | Storage::Input(_)
            | Storage::FragmentOutput
            | Storage::Parameter(_)
            | Storage::Builtin(_) => Some("what passes between stages takes no value"),
        };
        if let Some(message) = unfit {
            self.error(init.span, "6.4", message);
            return;
        }
        if self.version < Version::V120 && variable.ty.has_array() {
            self.error(init.span, "4.3", "arrays take no value before GLSL 1.20");
        }
        let init = self.implicit_conversion(init, &variable.ty.clone(), "initialize with");
        if init.is_error() {
            variable.constant = None;
            variable.init = Some(init);
            return;
        }
        let words = self.evaluate(&init);
        let relaxed = self.body.is_some() && self.language.has(Availability::RELAXED);
        let must_fold = match variable.storage {
            Storage::Const if relaxed => None,
            Storage::Const => Some("a constant"),
            Storage::Uniform => Some("a uniform"),
            // Desktop GLSL runs other initializers before `main` (section 4.3).
            Storage::Plain if self.version.is_es() => {
                self.body.is_none().then_some("a global variable")
            }
            Storage::Plain => None,
            Storage::Attribute
            | Storage::Output(_)
            | Storage::Input(_)
            | Storage::FragmentOutput
            | Storage::Parameter(_)
            | Storage::Builtin(_) => None,
        };
        if let (Some(what), None) = (must_fold, &words) {
            let message = format!("the value of {what} is not a constant expression");
            let rule = format!("{} section 4.3.3", self.version.title());
            self.log.push(Diagnostic::error(init.span, message).rule(rule));
        }
        match (variable.storage, words) {
            (Storage::Const, words) => {
                variable.constant = words;
                variable.init = Some(init);
            }
            // The linker does not have the constants of the unit.
            (Storage::Uniform, Some(words)) => {
                variable.init = Some(Expr { kind: ExprKind::Const(words), ..init });
            }
            _ => variable.init = Some(init),
        }
    }

    /// Reports a variable of type `void`, and a sampler that is no uniform.
    pub(super) fn check_sized(&mut self, variable: &Variable) {
        if variable.ty == Type::Void {
            self.error(variable.span, "4.1.1", format!("`{}` cannot be void", variable.name));
        }
        if variable.ty.has_sampler()
            && !matches!(variable.storage, Storage::Uniform | Storage::Parameter(_))
        {
            let message = format!("the sampler `{}` must be a uniform", variable.name);
            let rule = format!("{} section 4.1.7", self.version.title());
            self.log.push(
                Diagnostic::error(variable.span, message).rule(rule).help("write `uniform` before"),
            );
        }
    }

    /// The type of an array, with the sizes from its initializer. Indices can give the outermost
    /// size later; the inner sizes are required.
    pub(super) fn sized_by(&mut self, ty: Type, init: Option<&Expr>, span: Span) -> Type {
        let ty = match init {
            Some(init) => ty.sized_as(&init.ty),
            None => ty,
        };
        match &ty {
            // GLSL ES 3.00 section 4.1.9; in 1.00 there are none.
            ty if self.version.is_es() && ty.is_unsized() => {
                if !init.is_some_and(Expr::is_error) {
                    self.error(span, "4.1.9", format!("the array needs a size: this is {ty}"));
                }
                Type::Error
            }
            Type::Array(element, _) if element.is_unsized() => {
                if init.is_some_and(Expr::is_error) {
                    return Type::Error;
                }
                let message = format!("{ty}: only the first size of an array may be left out");
                let problem = Diagnostic::error(span, message).rule("ARB_arrays_of_arrays");
                self.log.push(problem.help("write the others, or a value that has them"));
                Type::Error
            }
            _ => ty,
        }
    }
}
