//! Syntax tree to checked shader: names, types, qualifiers, constants (GLSL 1.30 chapters 4 to 6).

mod binding;
mod call;
mod construct;
mod decl;
mod expr;
mod functions;
mod geometry;
mod initializer;
mod integer_overloads;
mod interface_block;
mod interface_types;
mod lvalue;
mod operators;
mod per_vertex;
mod precision;
mod qualifiers;
mod redeclare;
mod scope;
mod selection;
mod stmt;
mod uniform_block;

use crate::ast::{Item, StructDecl};
use crate::hir::{
    Expr, GeometryLayout, PerVertex, Stmt, Storage, Unit, VarRef, Variable, recursive_call,
};
use crate::language::{Extension, Language, Version};
use crate::text::diagnostics::{Diagnostic, Log};
use crate::text::source::{Source, Span};
use crate::types::Type;
use interface_block::Instance;
use precision::DefaultPrecisions;
use rasterizer::ir::Stage;
use redeclare::settle_arrays;
use scope::{Scopes, Undeclared};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use uniform_block::BlockDefaults;

/// The state while the body of a function is checked.
#[derive(Debug, Default)]
struct Body {
    /// The function's index in the unit.
    function: usize,
    /// What it returns.
    result: Option<Type>,
    /// Parameters and local variables so far.
    locals: Vec<Variable>,
    /// How many loops are open.
    loops: u32,
    /// How many loops and switches are open: what `break` can leave.
    breakable: u32,
    /// The functions called.
    calls: Vec<(u32, Span)>,
    /// The globals named.
    globals: BTreeSet<u32>,
    /// Whether a `return` was seen.
    returns: bool,
}

/// The state of the checker.
struct Checker<'a> {
    source: &'a Source,
    log: &'a mut Log,
    stage: Stage,
    language: Language,
    version: Version,
    /// The default precisions here.
    precisions: DefaultPrecisions,
    /// Whether a missing precision was reported: once is enough.
    reported_missing_precision: bool,
    unit: Unit,
    /// The default layout of uniform blocks.
    block_layout: BlockDefaults,
    /// The structure that was declared last.
    declared: Option<(Arc<StructDecl>, Type)>,
    scopes: Scopes,
    /// The blocks that have instance names.
    instances: Vec<Instance>,
    /// How many vertices the inputs of the geometry stage have, if a declaration says it.
    input_len: Option<u32>,
    /// The names of the blocks of uniforms, inputs and outputs.
    block_names: BTreeSet<(&'static str, Arc<str>)>,
    /// The functions of the unit by signature.
    signatures: BTreeMap<String, usize>,
    undeclared: Vec<Undeclared>,
    body: Option<Body>,
    /// The globals that initializers of globals reference.
    initializer_globals: BTreeSet<u32>,
}

/// Checks a shader; errors are in the log.
pub fn check(
    items: &[Item],
    stage: Stage,
    language: Language,
    source: &Source,
    log: &mut Log,
) -> Unit {
    let version = language.version;
    let (globals, functions, calls) = (Vec::new(), Vec::new(), Vec::new());
    let geometry = GeometryLayout::default();
    let per_vertex = PerVertex::default();
    let all_invariant = false;
    let unit =
        Unit { stage, version, all_invariant, geometry, per_vertex, globals, functions, calls };
    let mut checker = Checker {
        source,
        log,
        stage,
        language,
        version,
        precisions: DefaultPrecisions::new(version, stage),
        reported_missing_precision: false,
        unit,
        block_layout: BlockDefaults::default(),
        declared: None,
        scopes: Scopes::new(version),
        instances: Vec::new(),
        input_len: None,
        block_names: BTreeSet::new(),
        signatures: BTreeMap::new(),
        undeclared: Vec::new(),
        body: None,
        initializer_globals: BTreeSet::new(),
    };
    for item in items {
        match item {
            Item::Declaration(declaration) => checker.global_declaration(declaration),
            Item::Block(block) => checker.block(block),
            Item::LayoutDefaults(words) => checker.layout_defaults(words),
            Item::Function(function) => checker.function(function),
            Item::Invariant(names) => checker.invariant(names),
            Item::Precision(precision, ty) => checker.default_precision(*precision, ty),
        }
        if checker.log.is_full() {
            break;
        }
    }
    checker.finish()
}

impl Checker<'_> {
    fn finish(mut self) -> Unit {
        self.report_undeclared();
        settle_arrays(&mut self.unit.globals);
        if let Some((name, span)) = recursive_call(&self.unit.functions) {
            let message = format!("`{name}` calls itself, directly or through others");
            let rule = "GLSL 1.30 section 6.1: recursion is not allowed";
            self.log.push(Diagnostic::error(span, message).rule(rule));
        }
        if !self.log.has_errors() {
            self.both_color_outputs();
            self.outputs_without_location();
        }
        self.unit
    }

    /// A shader writes only one of `gl_FragColor`, `gl_FragData` and its own outputs (GLSL 1.30
    /// section 7.2).
    fn both_color_outputs(&mut self) {
        let written = |name: &str| {
            self.unit.globals.iter().any(|global| &*global.name == name && global.written)
        };
        let own =
            self.unit.globals.iter().find(|v| v.written && v.storage == Storage::FragmentOutput);
        // Of these, the second colour goes with the first (EXT_blend_func_extended).
        let ways = [
            ["gl_FragColor", "gl_SecondaryFragColorEXT"],
            ["gl_FragData", "gl_SecondaryFragDataEXT"],
        ];
        let written: Vec<&str> = ways
            .into_iter()
            .filter_map(|names| names.into_iter().find(|name| written(name)))
            .chain(own.map(|own| &*own.name))
            .collect();
        if let [first, second, ..] = written[..] {
            let message = format!("`{first}` and `{second}` are both written");
            let span = Span::default();
            self.log.push(Diagnostic::error(span, message).rule("GLSL 1.30 section 7.2"));
        }
    }

    /// Of several outputs of a fragment shader, each has a location (GLSL ES 3.00 section 4.3.8.2).
    fn outputs_without_location(&mut self) {
        let is_output = |v: &&Variable| v.storage == Storage::FragmentOutput;
        let outputs: Vec<&Variable> = self.unit.globals.iter().filter(is_output).collect();
        // The application may bind them (EXT_blend_func_extended).
        if self.language.enabled(Extension::EsBlendFuncExtended) {
            return;
        }
        let missing = outputs.iter().find(|v| v.interface_qualifiers.location.is_none());
        if let (Version::Es300, [_, _, ..], Some(output)) = (self.version, &outputs[..], missing) {
            let message =
                format!("there are several outputs, and `{}` has no location", output.name);
            let problem = Diagnostic::error(output.span, message).rule(self.rule("4.3.8.2"));
            self.log.push(problem.help("write `layout(location = 0)` and so on before each"));
        }
    }

    /// A section of the specification of the shader's version, as messages cite it.
    fn rule(&self, section: &str) -> String {
        format!("{} section {section}", self.version.title())
    }

    /// Reports a violation of a section of the specification.
    fn error(&mut self, span: Span, section: &str, message: impl Into<String>) {
        let rule = self.rule(section);
        self.log.push(Diagnostic::error(span, message).rule(rule));
    }

    fn variable(&self, var: VarRef) -> &Variable {
        match var {
            VarRef::Global(index) => &self.unit.globals[index as usize],
            VarRef::Local(index) => match &self.body {
                Some(body) => &body.locals[index as usize],
                None => unreachable!("locals are named in bodies only"),
            },
        }
    }

    fn variable_mut(&mut self, var: VarRef) -> &mut Variable {
        match var {
            VarRef::Global(index) => &mut self.unit.globals[index as usize],
            VarRef::Local(index) => match &mut self.body {
                Some(body) => &mut body.locals[index as usize],
                None => unreachable!("locals are named in bodies only"),
            },
        }
    }

    /// Counts a reference to a variable.
    fn note_use(&mut self, var: VarRef) {
        self.variable_mut(var).references += 1;
        if let VarRef::Global(index) = var {
            match &mut self.body {
                Some(body) => body.globals.insert(index),
                None => self.initializer_globals.insert(index),
            };
        }
    }

    /// The words of a constant expression, from the lowering itself: the same bits as at run time.
    fn evaluate(&mut self, expr: &Expr) -> Option<Arc<[u32]>> {
        if !expr.constant || expr.is_error() || self.log.work.is_over() {
            return None;
        }
        let locals = self.body.as_ref().map_or(&[][..], |body| &body.locals);
        let (globals, work) = (&self.unit.globals, &mut self.log.work);
        let words = crate::lower::constant(expr, globals, locals, work).map(Arc::from);
        if self.log.work.is_over() {
            self.log.push(Diagnostic::too_much_work(expr.span));
        }
        words
    }

    /// Checks statements in a scope of their own.
    fn scoped(&mut self, check: impl FnOnce(&mut Self) -> Vec<Stmt>) -> Vec<Stmt> {
        let precisions = self.precisions.open();
        self.scopes.open();
        let statements = check(self);
        self.scopes.close();
        self.precisions.close(precisions);
        statements
    }
}
