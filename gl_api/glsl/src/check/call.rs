//! Calls: overload resolution (GLSL 1.30 section 6.1).

use super::Checker;
use super::expr::convert;
use super::operators::converts;
use super::scope::Symbol;
use crate::ast::{self, BinaryOp};
use crate::builtins::function::{self, FunctionRow, Lowering, Pattern};
use crate::builtins::texture_lookup::{LodSource, Lookup, TexelOffset};
use crate::hir::{Direction, Expr, ExprKind, VarRef};
use crate::language::{Extension, Version, stage_name};
use crate::limits::{GATHER_OFFSETS, TEXEL_OFFSETS};
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::text::spelling::closest;
use crate::types::Type;
use rasterizer::ir::Stage;

/// The steps of a candidate of a call.
const CANDIDATE: usize = 4;

/// The function that a candidate stands for.
#[derive(Clone, Debug)]
enum CallTarget {
    User(u32),
    Builtin(&'static FunctionRow),
}

#[derive(Clone, Debug)]
pub(super) struct Candidate {
    target: CallTarget,
    parameters: Vec<Type>,
    directions: Vec<Direction>,
    result: Type,
}

impl Candidate {
    /// A candidate for a built-in function.
    pub(super) fn builtin(row: &'static FunctionRow, parameters: Vec<Type>, result: Type) -> Self {
        let direction =
            |p: &Pattern| if *p == Pattern::OutGen { Direction::Out } else { Direction::In };
        let directions = row.parameters.iter().map(direction).collect();
        Self { target: CallTarget::Builtin(row), parameters, directions, result }
    }

    /// Whether the shader declares it.
    fn is_user(&self) -> bool {
        matches!(self.target, CallTarget::User(_))
    }

    /// The number of arguments that need a conversion; `None` if one does not fit.
    fn conversions(&self, arguments: &[Expr], version: Version) -> Option<usize> {
        if arguments.len() != self.parameters.len() {
            return None;
        }
        let mut count = 0;
        for ((argument, parameter), direction) in
            arguments.iter().zip(&self.parameters).zip(&self.directions)
        {
            if argument.ty == *parameter {
                continue;
            }
            // The value of an `out` parameter is converted to the type of the argument (GLSL 1.30
            // section 6.1).
            let fits = match direction {
                Direction::In => converts(&argument.ty, parameter, version),
                Direction::Out => converts(parameter, &argument.ty, version),
                Direction::Inout => false,
            };
            if !fits {
                return None;
            }
            count += 1;
        }
        Some(count)
    }

    fn signature(&self, name: &str) -> String {
        let types: Vec<String> = self.parameters.iter().map(ToString::to_string).collect();
        format!("{name}({})", types.join(", "))
    }
}

impl Checker<'_> {
    pub(super) fn call(&mut self, name: &ast::Name, arguments: &[ast::Expr], span: Span) -> Expr {
        if let Some(Symbol::Struct(structure)) = self.scopes.find(&name.text).cloned() {
            let arguments: Vec<Expr> = arguments.iter().map(|a| self.expr(a)).collect();
            return self.construct_struct(&structure, arguments, span);
        }
        let arguments: Vec<Expr> = arguments.iter().map(|a| self.expr(a)).collect();
        if arguments.iter().any(Expr::is_error) {
            return Expr::error(span);
        }
        if let Some(void) = arguments.iter().find(|argument| argument.ty == Type::Void) {
            self.error(void.span, "6.1", "an argument has no value");
            return Expr::error(span);
        }
        let candidates = self.candidates(name, |parameters| parameters == arguments.len());
        self.log.work.add(CANDIDATE * candidates.len());
        if self.log.work.is_over() {
            self.log.push(Diagnostic::too_much_work(name.span));
            return Expr::error(span);
        }
        let version = self.version;
        let fits = |candidate: &&Candidate| candidate.conversions(&arguments, version);
        let mut fitting: Vec<&Candidate> =
            candidates.iter().filter(|c| fits(c).is_some()).collect();
        // A user function hides all built-in functions of its name, which lie in a scope around the
        // global one. Before 1.20, it hides only the one with the same parameters.
        let hides = version >= Version::V120;
        if hides && fitting.iter().any(|c| c.is_user()) {
            fitting.retain(|c| c.is_user());
        }
        let Some(&best) = fitting.iter().min_by_key(|c| fits(c)) else {
            let candidates = self.candidates(name, |_| true);
            if candidates.is_empty() {
                self.unknown_function(name);
                return Expr::error(span);
            }
            if let Some(function) = self.integer_candidate(name, &arguments) {
                return self.finish_call(name, function, arguments, span);
            }
            self.no_match(name, &arguments, &candidates);
            return Expr::error(span);
        };
        if fits(&best) != Some(0) && fitting.len() > 1 {
            let list: Vec<String> = fitting.iter().map(|c| c.signature(&name.text)).collect();
            let message = format!("the call of `{}` fits more than one function", name.text);
            let problem = Diagnostic::error(name.span, message).rule(self.rule("6.1"));
            self.log.push(problem.note(format!("there are: {}", list.join(", "))));
            return Expr::error(span);
        }
        if hides && !best.is_user() && !self.scopes.functions(&name.text).is_empty() {
            let message = format!("the shader's own `{0}` hides the language's `{0}`", name.text);
            let problem = Diagnostic::warning(name.span, message).rule(self.rule("4.2"));
            self.log.push(problem.help("name it otherwise: other compilers refuse this call"));
        }
        let best = best.clone();
        self.finish_call(name, best, arguments, span)
    }

    /// The candidates of a name that have so many parameters: the functions of the shader, and the built-in functions with
    /// other parameters.
    fn candidates(
        &mut self,
        name: &ast::Name,
        has_count: impl Fn(usize) -> bool,
    ) -> Vec<Candidate> {
        if self.scopes.hides_functions(&name.text) {
            return Vec::new();
        }
        let own = self.scopes.functions(&name.text).iter().filter_map(|&index| {
            let function = &self.unit.functions[index as usize];
            has_count(function.directions.len()).then(|| Candidate {
                target: CallTarget::User(index),
                parameters: function.parameters().cloned().collect(),
                directions: function.directions.clone(),
                result: function.result.clone(),
            })
        });
        let mut candidates: Vec<Candidate> = own.collect();
        let rows = function::find(&name.text, self.stage, self.language);
        for row in rows.filter(|row| has_count(row.parameters.len())) {
            for (parameters, result) in row.signatures() {
                if candidates.iter().any(|candidate| candidate.parameters == parameters) {
                    continue;
                }
                candidates.push(Candidate::builtin(row, parameters, result));
            }
        }
        candidates
    }

    fn unknown_function(&mut self, name: &ast::Name) {
        let text = &name.text;
        if let Some(Symbol::Variable(_) | Symbol::Member(..)) = self.scopes.find(text) {
            self.error(name.span, "6.4", format!("`{text}` is a variable, not a function"));
            return;
        }
        let mut problem = Diagnostic::error(name.span, format!("there is no function `{text}`"));
        let other = match self.stage {
            Stage::Vertex | Stage::Geometry => Stage::Fragment,
            Stage::Fragment => Stage::Vertex,
        };
        let known: Vec<&FunctionRow> = function::named(text).collect();
        let here = |row: &&&FunctionRow| row.stages.has(self.stage);
        if let Some(row) = known.iter().find(here) {
            if let Some(advice) = self.language.advice(row.availability) {
                problem = problem.help(advice);
            }
        } else if !known.is_empty() {
            let stage = stage_name(other);
            problem = problem.note(format!("only the {stage} stage has it"));
        } else {
            let user = self.unit.functions.iter().map(|function| &*function.name);
            let builtin: Vec<&str> = function::names(self.stage, self.language).collect();
            let names = user.chain(builtin);
            if let Some(near) = closest(text, names) {
                problem =
                    problem.fix(format!("did you mean `{near}`?"), name.span, near.to_owned());
            }
        }
        self.log.push(problem);
    }

    /// Reports why no candidate takes the arguments.
    fn no_match(&mut self, name: &ast::Name, arguments: &[Expr], candidates: &[Candidate]) {
        let types: Vec<String> = arguments.iter().map(|a| a.ty.to_string()).collect();
        let message = format!("no `{}` takes ({})", name.text, types.join(", "));
        let rule = format!("{} section 6.1", self.version.title());
        let mut problem = Diagnostic::error(name.span, message).rule(rule);
        let same_length = |c: &&Candidate| c.parameters.len() == arguments.len();
        let mut shown: Vec<&Candidate> = candidates.iter().filter(same_length).collect();
        if shown.is_empty() {
            shown = candidates.iter().collect();
        }
        let list: Vec<String> = shown.iter().take(6).map(|c| c.signature(&name.text)).collect();
        let more = if shown.len() > 6 { ", ..." } else { "" };
        problem = problem.note(format!("there are: {}{more}", list.join(", ")));

        // Points at the argument, if a single one does not fit.
        let mut wrong = None;
        for candidate in candidates.iter().filter(same_length) {
            let fits = |index: usize| {
                let (ty, parameter) = (&arguments[index].ty, &candidate.parameters[index]);
                ty == parameter || converts(ty, parameter, self.version)
            };
            let mut misfits = (0..arguments.len()).filter(|&index| !fits(index));
            if let (Some(index), None) = (misfits.next(), misfits.next()) {
                wrong = wrong.or(Some((index, candidate.parameters[index].clone())));
            }
        }
        if let Some((index, parameter)) = wrong {
            let argument = &arguments[index];
            problem.span = Some(argument.span);
            problem = problem.label(format!("{}, not {parameter}", argument.ty));
            if matches!((&argument.ty, &parameter), (Type::Sampler(_), Type::Sampler(_))) {
                problem = self.with_sampler_fix(problem, argument, &parameter);
            } else if parameter == crate::types::FLOAT && argument.ty == crate::types::INT {
                problem = self.with_float_fix(problem, argument);
            }
        }
        self.log.push(problem);
    }

    /// A fix-it for a sampler of the wrong type: declare it with the type that is needed.
    fn with_sampler_fix(&self, problem: Diagnostic, argument: &Expr, needed: &Type) -> Diagnostic {
        let ExprKind::Var(VarRef::Global(index)) = argument.kind else { return problem };
        let variable = &self.unit.globals[index as usize];
        let Some(span) = variable.type_span else { return problem };
        if self.source.slice(span) != argument.ty.to_string() {
            return problem;
        }
        let line = self.source.line_of(span.start).1;
        let text = format!("declare `{}` in line {line} as `{needed}`", variable.name);
        problem.fix(text, span, needed.to_string())
    }

    fn finish_call(
        &mut self,
        name: &ast::Name,
        best: Candidate,
        arguments: Vec<Expr>,
        span: Span,
    ) -> Expr {
        let mut converted = Vec::new();
        for ((argument, parameter), direction) in
            arguments.into_iter().zip(&best.parameters).zip(&best.directions)
        {
            match direction {
                Direction::In => converted.push(convert(argument, parameter)),
                Direction::Out | Direction::Inout => {
                    self.check_written(&argument, "pass as an `out` argument");
                    converted.push(argument);
                }
            }
        }
        let ty = best.result;
        match best.target {
            CallTarget::User(index) => {
                match &mut self.body {
                    Some(body) => body.calls.push((index, name.span)),
                    // Initializers run before `main`; those of GLSL ES are constant.
                    None if !self.version.is_es() => self.unit.calls.push(index),
                    None => {
                        let message =
                            "functions of the shader cannot be called outside of functions";
                        self.error(span, "6.1", message);
                        return Expr::error(span);
                    }
                }
                Expr { ty, span, constant: false, kind: ExprKind::Call(index, converted) }
            }
            CallTarget::Builtin(row) => self.finish_builtin(row, ty, name, converted, span),
        }
    }

    fn finish_builtin(
        &mut self,
        row: &'static FunctionRow,
        ty: Type,
        name: &ast::Name,
        arguments: Vec<Expr>,
        span: Span,
    ) -> Expr {
        match row.lowering {
            Lowering::Ftransform => {
                let matrix = self.builtin_expr("gl_ModelViewProjectionMatrix", span);
                let vertex = self.builtin_expr("gl_Vertex", span);
                return self.binary(BinaryOp::Mul, matrix, vertex, span);
            }
            Lowering::Texture(lookup) => {
                if !self.check_lookup(lookup, name, &arguments) {
                    return Expr::error(span);
                }
            }
            Lowering::PerComponent(_)
            | Lowering::Expand(_)
            | Lowering::ExpandAtRunTime(_)
            | Lowering::Derivative(_)
            | Lowering::EmitVertex
            | Lowering::EndPrimitive
            | Lowering::Modf => {}
        }
        if let Some(extension) = self.language.warns(row.availability) {
            let message = format!("`{}` comes from {}", name.text, extension.name());
            self.log.push(Diagnostic::warning(name.span, message));
        }
        // From ES 1.00 (section 5.10) and 1.20 (section 4.3.3) on, a call with constant arguments
        // is constant.
        let constant = row.folds()
            && self.version >= Version::Es100
            && arguments.iter().all(|argument| argument.constant);
        Expr { ty, span, constant, kind: ExprKind::Builtin(row, arguments) }
    }

    /// Checks of a texture lookup beyond the types of its arguments; whether it is valid.
    fn check_lookup(&mut self, lookup: Lookup, name: &ast::Name, arguments: &[Expr]) -> bool {
        let explicit = matches!(lookup, Lookup::Sample(_, LodSource::Explicit, _));
        let is_old = self.version < Version::V130 && !self.version.is_es();
        if explicit && !self.is_vertex() && is_old {
            let message = format!("`{}` in the fragment stage is an extension", name.text);
            let problem = Diagnostic::deviation(self.log.strictness, name.span, message)
                .help("write `#extension GL_ARB_shader_texture_lod : enable` first");
            let known = [Extension::ShaderTextureLod, Extension::GpuShader4];
            if !known.iter().any(|known| self.language.enabled(*known)) {
                self.log.push(problem);
            }
        }
        let shift = match lookup {
            Lookup::Sample(_, form, TexelOffset::Constant) => {
                arguments.len().checked_sub(if form == LodSource::Bias { 2 } else { 1 })
            }
            Lookup::Fetch(TexelOffset::Constant) | Lookup::Gather(TexelOffset::Constant) => {
                arguments.len().checked_sub(1)
            }
            Lookup::Sample(_, _, TexelOffset::None)
            | Lookup::Gather(TexelOffset::None)
            | Lookup::Fetch(TexelOffset::None)
            | Lookup::Size
            | Lookup::QueryLevels
            | Lookup::QueryLod => None,
        };
        if let Some(offset) = shift.and_then(|index| arguments.get(index)) {
            let gathers = matches!(lookup, Lookup::Gather(_));
            let range = if gathers { GATHER_OFFSETS } else { TEXEL_OFFSETS };
            let words = self.evaluate(offset);
            let fits = words
                .as_ref()
                .is_some_and(|words| words.iter().all(|&word| range.contains(&(word as i32))));
            if !fits {
                let (low, high) = (range.start(), range.end());
                let message = format!("an offset is a constant expression from {low} to {high}");
                let rule = if gathers { "ARB_texture_gather".into() } else { self.rule("8.7") };
                let problem = Diagnostic::error(offset.span, message).rule(rule);
                self.log.push(problem);
                return false;
            }
        }
        true
    }
}
