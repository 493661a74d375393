//! One shader: its text through the preprocessor, the parser and the checker.

#[cfg(test)]
mod builtins_test;
mod fix_its;

use crate::hir::Unit;
pub use crate::language::ContextLanguage;
use crate::language::Version;
pub use crate::text::diagnostics::Strictness;
use crate::text::diagnostics::{Diagnostic, Log};
use crate::text::source::{Source, Span};
use crate::{check, limits, parse, preprocess};
use rasterizer::ir::Stage;
use rasterizer::stack::with_large_stack;
use std::sync::Arc;

/// Whether the compiler applies the fix-its of its diagnostics.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FixIts {
    /// They are suggested in the log; the shader is rejected.
    #[default]
    Suggest,
    /// They are applied, and listed in the log as warnings.
    Apply,
}

/// Options of the compiler.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Whether fix-its are applied.
    pub fix_its: FixIts,
    /// Whether what all drivers accept, and the shader's version does not have, is accepted.
    pub strictness: Strictness,
    /// What the context offers.
    pub context: ContextLanguage,
}

/// A compiled, checked shader object.
#[derive(Clone, Debug)]
pub struct Shader {
    pub(crate) unit: Arc<Unit>,
}

impl Shader {
    /// Whether it declares a global of this name.
    pub fn declares(&self, name: &str) -> bool {
        self.unit.globals.iter().any(|global| &*global.name == name)
    }
}

/// The result of a compilation.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Compiled {
    /// The shader, if there was no error.
    pub shader: Option<Shader>,
    /// The answer of `glGetShaderInfoLog`; empty if there is nothing to report.
    pub log: String,
}

/// One run of the compiler over one text.
struct Pass {
    unit: Unit,
    source: Source,
    log: Log,
}

impl Pass {
    /// The shader, if there was no error.
    fn shader(self) -> Option<Shader> {
        (!self.log.has_errors()).then(|| Shader { unit: Arc::new(self.unit) })
    }
}

fn compile_once(stage: Stage, text: &str, strings: &[u32], options: &Options) -> Pass {
    let mut log = Log::new(options.strictness);
    let too_long = text.len() > limits::MAX_SOURCE;
    let mut source = if too_long { Source::new("", &[]) } else { Source::new(text, strings) };
    if too_long {
        let message = format!("the source has more than {} bytes", limits::MAX_SOURCE);
        log.push(Diagnostic::error(Span::default(), message));
    }
    let preprocessed = preprocess::preprocess(&mut source, options.context, &mut log);
    if preprocessed.all_invariant
        && stage == Stage::Fragment
        && preprocessed.language.version == Version::Es300
    {
        let message = "`#pragma STDGL invariant(all)` is not for the fragment stage";
        let problem = Diagnostic::error(Span::default(), message);
        log.push(problem.rule("GLSL ES 3.00 section 4.6.1"));
    }
    let items = parse::parse(&preprocessed.tokens, preprocessed.language, &mut log);
    let mut unit = check::check(&items, stage, preprocessed.language, &source, &mut log);
    unit.all_invariant = preprocessed.all_invariant;
    Pass { unit, source, log }
}

/// Compiles one shader. Any text is accepted; it never panics, and needs little of the caller's
/// stack.
pub fn compile(stage: Stage, source: &str, options: &Options) -> Compiled {
    compile_strings(stage, source, &[], options)
}

/// [`compile`] of strings that were joined; `strings` has the offsets at which all but the first of them begin, in order.
/// `__FILE__`, `__LINE__` and the log count them.
pub fn compile_strings(stage: Stage, source: &str, strings: &[u32], options: &Options) -> Compiled {
    with_large_stack(|| match options.fix_its {
        FixIts::Suggest => {
            let pass = compile_once(stage, source, strings, options);
            let log = pass.log.render(Some(&pass.source));
            Compiled { shader: pass.shader(), log }
        }
        FixIts::Apply => fix_its::compile(stage, source, strings, options),
    })
}
