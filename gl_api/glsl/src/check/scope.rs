//! Scopes, and suggestions for names that are not declared.

use super::Checker;
use crate::builtins::{function, variable};
use crate::hir::{Storage, VarRef};
use crate::language::{Version, stage_name};
use crate::limits::MAX_ERRORS;
use crate::text::diagnostics::{Diagnostic, Edit, Suggestion};
use crate::text::source::Span;
use crate::text::spelling::edit_distance;
use crate::types::Struct;
use rasterizer::ir::Stage;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The meaning of a name.
#[derive(Clone, Debug)]
pub enum Symbol {
    /// A variable.
    Variable(VarRef),
    /// A member of a uniform block, by index.
    Member(VarRef, u32),
    /// A block; only its declaration uses the name.
    Block,
    /// The name behind a block, by index into the list of those.
    Instance(u32),
    /// A structure.
    Struct(Arc<Struct>),
    /// Functions: see [`Scopes::functions`].
    Functions,
    /// An undeclared name, by index into the list of those.
    Undeclared(usize),
}

impl Symbol {
    /// The variable, if it is one.
    pub fn variable(&self) -> Option<VarRef> {
        match self {
            Self::Variable(var) => Some(*var),
            Self::Member(..)
            | Self::Block
            | Self::Instance(_)
            | Self::Struct(_)
            | Self::Functions
            | Self::Undeclared(_) => None,
        }
    }
}

/// The open scopes; the first is the global one.
#[derive(Debug)]
pub struct Scopes {
    open: Vec<BTreeMap<Arc<str>, Symbol>>,
    /// The functions of each name: their indices in the unit.
    functions: BTreeMap<Arc<str>, Vec<u32>>,
    names: FunctionNames,
}

/// Whether functions share their names with variables and structures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FunctionNames {
    /// They do.
    Shared,
    /// They have a name space of their own (GLSL 1.10 section 4.2).
    Apart,
}

impl Scopes {
    /// The global scope.
    pub fn new(version: Version) -> Self {
        let names = match version {
            Version::V110 => FunctionNames::Apart,
            Version::Es100
            | Version::V120
            | Version::V130
            | Version::V140
            | Version::V150
            | Version::V330
            | Version::Es300 => FunctionNames::Shared,
        };
        Self { open: vec![BTreeMap::new()], functions: BTreeMap::new(), names }
    }

    /// Opens a scope.
    pub fn open(&mut self) {
        self.open.push(BTreeMap::new());
    }

    /// Closes the innermost scope.
    pub fn close(&mut self) {
        self.open.pop();
    }

    /// The meaning of a name here.
    pub fn find(&self, name: &str) -> Option<&Symbol> {
        self.open.iter().rev().find_map(|scope| scope.get(name))
    }

    /// The meaning of a name in the innermost scope.
    pub fn find_innermost(&self, name: &str) -> Option<&Symbol> {
        self.open.last().and_then(|scope| scope.get(name))
    }

    /// The meaning of a name in the global scope.
    pub fn find_global(&self, name: &str) -> Option<&Symbol> {
        self.open[0].get(name)
    }

    /// Adds a name to the innermost scope.
    pub fn add(&mut self, name: Arc<str>, symbol: Symbol) {
        if let Some(scope) = self.open.last_mut() {
            scope.insert(name, symbol);
        }
    }

    /// Adds a name to the global scope.
    pub fn add_global(&mut self, name: Arc<str>, symbol: Symbol) {
        self.open[0].insert(name, symbol);
    }

    /// Whether a variable or block of this name hides functions here, built-in functions too.
    pub fn hides_functions(&self, name: &str) -> bool {
        match self.find(name) {
            Some(
                Symbol::Variable(_) | Symbol::Member(..) | Symbol::Block | Symbol::Instance(_),
            ) => self.names == FunctionNames::Shared,
            Some(Symbol::Struct(_) | Symbol::Functions | Symbol::Undeclared(_)) | None => false,
        }
    }

    /// The functions of this name, whether they are hidden or not.
    pub fn functions(&self, name: &str) -> &[u32] {
        self.functions.get(name).map_or(&[], |all| all)
    }

    /// Whether a structure of this name would collide with a function: its constructor is one.
    pub fn is_function_apart(&self, name: &str) -> bool {
        self.names == FunctionNames::Apart
            && self.open.len() == 1
            && self.functions.contains_key(name)
    }

    /// Adds a function or an overload.
    pub fn add_function(&mut self, name: Arc<str>, index: u32) {
        self.functions.entry(name.clone()).or_default().push(index);
        if self.names == FunctionNames::Shared {
            self.add_global(name, Symbol::Functions);
        }
    }

    fn names(&self) -> impl Iterator<Item = (&Arc<str>, &Symbol)> {
        self.open.iter().rev().flatten()
    }
}

/// A variable whose name is close to one that is not declared.
#[derive(Debug)]
struct NearMiss {
    distance: usize,
    name: Arc<str>,
    /// The variable and, if it is local, its function; `None` for a built-in variable.
    declared: Option<(VarRef, Option<usize>)>,
}

/// A name that is used but not declared.
#[derive(Debug)]
pub struct Undeclared {
    name: Arc<str>,
    /// All its uses.
    uses: Vec<Span>,
    candidates: Vec<NearMiss>,
}

impl Checker<'_> {
    /// Records the use of an undeclared name.
    pub(super) fn undeclared(&mut self, name: &Arc<str>, span: Span) {
        if let Some(Symbol::Undeclared(index)) = self.scopes.find(name) {
            if let Some(known) = self.undeclared.get_mut(*index) {
                known.uses.push(span);
            }
            return;
        }
        let limit = (name.len() / 3).clamp(1, 3);
        let function = self.body.as_ref().map(|body| body.function);
        let declared = self.scopes.names().filter_map(|(near, symbol)| match symbol {
            Symbol::Variable(var) => {
                let of = match var {
                    VarRef::Local(_) => function,
                    VarRef::Global(_) => None,
                };
                edit_distance(name, near, limit).map(|distance| NearMiss {
                    distance,
                    name: near.clone(),
                    declared: Some((*var, of)),
                })
            }
            Symbol::Member(..)
            | Symbol::Block
            | Symbol::Instance(_)
            | Symbol::Struct(_)
            | Symbol::Functions
            | Symbol::Undeclared(_) => None,
        });
        let mut candidates: Vec<NearMiss> = declared.collect();
        for near in variable::names(self.stage, self.language) {
            if let Some(distance) = edit_distance(name, near, limit) {
                candidates.push(NearMiss { distance, name: near.into(), declared: None });
            }
        }
        candidates.sort_by_key(|candidate| candidate.distance);
        let index = self.undeclared.len();
        self.undeclared.push(Undeclared { name: name.clone(), uses: vec![span], candidates });
        self.scopes.add_global(name.clone(), Symbol::Undeclared(index));
        if self.undeclared.len() >= MAX_ERRORS {
            self.report_undeclared();
        }
    }

    /// Reports the undeclared names, at the end: only then it is known which variables are unused.
    pub(super) fn report_undeclared(&mut self) {
        for undeclared in std::mem::take(&mut self.undeclared) {
            let Undeclared { name, uses, candidates } = undeclared;
            let mut problem =
                Diagnostic::error(uses[0], format!("`{name}` is not declared"))
                    .rule(format!("{} section 4.2: a name is declared before it is used", {
                        self.version.title()
                    }));
            let unused = candidates.iter().find_map(|candidate| {
                let (var, function) = candidate.declared?;
                let variable = match (var, function) {
                    (VarRef::Global(index), _) => self.unit.globals.get(index as usize),
                    (VarRef::Local(index), Some(function)) => self
                        .unit
                        .functions
                        .get(function)
                        .and_then(|function| function.locals.get(index as usize)),
                    (VarRef::Local(_), None) => None,
                }?;
                let plain = self.source.slice(variable.span) == &*candidate.name;
                // The application refers to uniforms and attributes by name.
                let own = !matches!(variable.storage, Storage::Uniform | Storage::Attribute);
                (variable.references == 0 && plain && own)
                    .then_some((variable.span, candidate.name.clone()))
            });
            let since = variable::availability(&name, self.stage);
            let other =
                [Stage::Vertex, Stage::Geometry, Stage::Fragment].into_iter().find(|stage| {
                    *stage != self.stage && variable::availability(&name, *stage).is_some()
                });
            if let Some(advice) = since.and_then(|since| self.language.advice(since)) {
                problem = problem.help(advice);
            } else if let Some(other) = other {
                problem = problem.note(format!("only the {} stage has it", stage_name(other)));
            } else if let Some((span, near)) = unused {
                let line = self.source.line_of(span.start).1;
                let text = format!(
                    "`{near}`, declared in line {line}, is never used: declare it as `{name}`"
                );
                problem = problem.fix(text, span, name.to_string());
            } else if let Some(candidate) = candidates.first() {
                let near = &candidate.name;
                let plain = |span: &&Span| self.source.slice(**span) == &*name;
                let edit = |span: &Span| Edit { span: *span, text: near.to_string() };
                let edits = uses.iter().filter(plain).map(edit).collect();
                let text = format!("did you mean `{near}`?");
                problem.suggestion = Some(Suggestion { text, edits });
            } else if let Some(advice) = variable::availability(&name, self.stage)
                .and_then(|since| self.language.advice(since))
            {
                problem = problem.help(advice);
            } else if function::find(&name, self.stage, self.language).next().is_some()
                || !self.scopes.functions(&name).is_empty()
            {
                problem = problem.note(format!("`{name}` is a function: it is called with `()`"));
            }
            self.log.push(problem);
        }
    }
}
