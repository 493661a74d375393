//! Functions: prototypes, definitions, parameters (GLSL 1.30 section 6.1).

use super::redeclare::settle_arrays;
use super::scope::Symbol;
use super::{Body, Checker};
use crate::ast::{self, Qualifier};
use crate::builtins::function::{self, FunctionRow};
use crate::hir::{Direction, Function, Storage, VarRef, Variable};
use crate::language::Version;
use crate::text::diagnostics::Diagnostic;
use crate::types::Type;

impl Checker<'_> {
    /// GLSL ES has no structures that are defined in the head of a function.
    fn no_structure(&mut self, ty: &ast::QualifiedType) {
        if self.version.is_es() && matches!(ty.ty.base, ast::TypeBase::Struct(_)) {
            let message = "a structure is not defined in the head of a function";
            let problem = Diagnostic::error(ty.ty.span, message).rule(self.rule("6.1"));
            self.log.push(problem.help("define it before the function, and name it here"));
        }
    }

    pub(super) fn function(&mut self, declared: &ast::Function) {
        self.no_structure(&declared.ty);
        self.precision_of(&declared.ty);
        let result = self.type_of(&declared.ty.ty, &[]);
        for (qualifier, span) in &declared.ty.qualifiers {
            if !matches!(qualifier, Qualifier::Precision(_)) {
                self.error(*span, "6.4", "what a function returns takes no such word");
            }
        }
        let no_array = self.version == Version::Es100 && result.has_array();
        if result.has_sampler() || result.is_unsized() || no_array {
            self.error(declared.ty.ty.span, "6.4", format!("a function cannot return {result}"));
        }
        let mut directions = Vec::new();
        let mut locals = Vec::new();
        for parameter in &declared.parameters {
            let (direction, variable) = self.parameter(parameter);
            directions.push(direction);
            locals.push(variable);
        }
        let function = Function {
            name: declared.name.text.clone(),
            directions,
            result,
            locals,
            body: None,
            span: declared.name.span,
            line: self.source.line_of(declared.name.span.start).1,
            calls: Vec::new(),
            globals: Vec::new(),
        };
        if &*declared.name.text == "main"
            && (function.result != Type::Void || !function.directions.is_empty())
        {
            let rule = format!("{} section 6.1: `void main()`", self.version.title());
            let message = "`main` returns nothing and takes nothing";
            self.log.push(Diagnostic::error(declared.name.span, message).rule(rule));
        }
        let Some(index) = self.declare_function(declared, function) else { return };
        if let Some(body) = &declared.body {
            self.function_body(index, body, declared);
        }
    }

    fn parameter(&mut self, parameter: &ast::Parameter) -> (Direction, Variable) {
        self.check_order(&parameter.ty.qualifiers);
        let mut direction = Direction::In;
        for (qualifier, span) in &parameter.ty.qualifiers {
            match qualifier {
                Qualifier::In => direction = Direction::In,
                Qualifier::Out => direction = Direction::Out,
                Qualifier::Inout => direction = Direction::Inout,
                Qualifier::Const | Qualifier::Precision(_) => {}
                Qualifier::Attribute
                | Qualifier::Varying
                | Qualifier::Uniform
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
                    self.error(*span, "6.1", "a parameter is `in`, `out`, `inout` or `const in`");
                }
            }
        }
        self.no_structure(&parameter.ty);
        self.precision_of(&parameter.ty);
        let ty = self.type_of(&parameter.ty.ty, &parameter.array);
        let span = parameter.name.as_ref().map_or(parameter.ty.ty.span, |name| name.span);
        if ty == Type::Void || ty.is_unsized() {
            self.error(span, "6.1", format!("a parameter cannot be {ty}"));
        }
        if ty.has_sampler() && direction != Direction::In {
            self.error(span, "6.1", "a sampler cannot be an `out` parameter");
        }
        // In GLSL ES, arrays are l-values for this purpose alone (section 5.8).
        if ty.has_array() && direction != Direction::In && self.version == Version::V110 {
            let message = "an array cannot be an `out` parameter: it is no l-value";
            self.error(span, "5.8", message);
        }
        let constant = parameter.ty.qualifiers.iter().any(|(q, _)| *q == Qualifier::Const);
        if constant && direction != Direction::In {
            self.error(span, "6.1", "a `const` parameter cannot be `out` or `inout`");
        }
        let storage = if constant { Storage::Const } else { Storage::Parameter(direction) };
        let name = parameter.name.as_ref().map_or("".into(), |name| name.text.clone());
        let mut variable = Variable::new(name, ty, storage, span);
        variable.written = direction != Direction::In;
        (direction, variable)
    }

    /// Adds a function to the unit, or finds its prototype there.
    fn declare_function(&mut self, declared: &ast::Function, new: Function) -> Option<usize> {
        let name = &declared.name;
        let known = self.scopes.find_global(&name.text).cloned();
        let taken = match &known {
            Some(Symbol::Functions | Symbol::Undeclared(_)) | None => None,
            Some(Symbol::Struct(_)) => known,
            Some(
                Symbol::Variable(_) | Symbol::Member(..) | Symbol::Block | Symbol::Instance(_),
            ) => known.filter(|_| self.scopes.hides_functions(&name.text)),
        };
        if let Some(symbol) = taken {
            self.declared_already(name, &symbol);
            return None;
        }
        self.check_reserved(name);
        let is_builtin = || function::find(&name.text, self.stage, self.language).next().is_some();
        if self.version == Version::Es300 && is_builtin() {
            let message = format!("`{}` is built in, and cannot be overloaded", name.text);
            self.error(name.span, "6.1", message);
            return None;
        }
        if self.version == Version::Es100 && self.is_builtin(&name.text, &new) {
            let message = format!("`{}` is built in with these parameters", name.text);
            let problem = Diagnostic::error(name.span, message).rule("GLSL ES 1.00 chapter 8");
            self.log.push(problem.help("give it another name, or other types of parameters"));
            return None;
        }
        let signature = new.signature();
        let known = self.signatures.get(&signature).copied();
        let same =
            known.filter(|&index| self.unit.functions[index].parameters().eq(new.parameters()));
        if let Some(index) = same {
            let other = &self.unit.functions[index];
            let problem = if other.result != new.result
                || !other.parameter_storages().eq(new.parameter_storages())
            {
                Some(("differs from its declaration", &*name.text))
            } else if other.body.is_some() && declared.body.is_some() {
                Some(("is defined already,", &*signature))
            } else if self.version == Version::Es100
                && other.body.is_none()
                && declared.body.is_none()
            {
                // GLSL ES 1.00 allows one prototype besides the definition (section 4.2.7); GLSL ES 3.00 any number
                // (section 4.2.3).
                Some(("is declared already,", &*signature))
            } else {
                None
            };
            if let Some((problem, what)) = problem {
                let line = self.source.line_of(other.span.start).1;
                self.error(name.span, "6.1", format!("`{what}` {problem} in line {line}"));
                return None;
            }
            if declared.body.is_some() {
                self.unit.functions[index] = new;
            }
            return Some(index);
        }
        let index = self.unit.functions.len();
        self.unit.functions.push(new);
        self.signatures.insert(signature, index);
        self.scopes.add_function(name.text.clone(), index as u32);
        Some(index)
    }

    /// Whether a built-in function has these parameters.
    fn is_builtin(&self, name: &str, new: &Function) -> bool {
        let new: Vec<&Type> = new.parameters().collect();
        function::find(name, self.stage, self.language)
            .flat_map(FunctionRow::signatures)
            .any(|(parameters, _)| parameters.iter().eq(new.iter().copied()))
    }

    fn function_body(&mut self, index: usize, body: &[ast::Stmt], declared: &ast::Function) {
        let function = &self.unit.functions[index];
        let (locals, result) = (function.locals.clone(), function.result.clone());
        self.body =
            Some(Body { function: index, result: Some(result.clone()), locals, ..Body::default() });
        let precisions = self.precisions.open();
        self.scopes.open();
        for (number, parameter) in declared.parameters.iter().enumerate() {
            if let Some(name) = &parameter.name {
                self.check_new(name);
                let var = VarRef::Local(number as u32);
                self.scopes.add(name.text.clone(), Symbol::Variable(var));
            }
        }
        // In GLSL ES 1.00 the body has a scope inside of that of the parameters (section 4.2.2).
        let nested = self.version == Version::Es100;
        if nested {
            self.scopes.open();
        }
        let statements = self.statements(body);
        if nested {
            self.scopes.close();
        }
        self.scopes.close();
        self.precisions.close(precisions);
        let Some(mut body) = self.body.take() else { return };
        settle_arrays(&mut body.locals);
        if result != Type::Void && result != Type::Error && !body.returns {
            let message = format!("`{}` never returns a value", declared.name.text);
            let rule = format!("{} section 6.1", self.version.title());
            self.log.push(Diagnostic::error(declared.name.span, message).rule(rule));
        }
        let function = &mut self.unit.functions[index];
        function.locals = body.locals;
        function.body = Some(statements);
        function.calls = body.calls;
        function.globals = body.globals.into_iter().collect();
    }

    /// The result type of the function being checked.
    pub(super) fn result_type(&self) -> Option<&Type> {
        self.body.as_ref().and_then(|body| body.result.as_ref())
    }
}
