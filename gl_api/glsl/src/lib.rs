//! The GLSL front end: text in, IR of the rasterizer out.
//!
//! The layers from below; each uses only those above it in this table:
//!
//! | layer | is |
//! |---|---|
//! | [`limits`], [`interface`] | what the language shares with the state of GL |
//! | `text` | source positions, diagnostics, near misses of names |
//! | `language` | versions, extensions, and what each of them has |
//! | `lex`, `preprocess` | text to tokens, directives and macros |
//! | `types` | the types of the language |
//! | `ast`, `parse` | tokens to the syntax tree |
//! | `work` | counts the work of a compilation or a link |
//! | `emit` | appending IR, with constants folded |
//! | `builtins` | the table of built-in functions and variables |
//! | `hir` | the checked shader: typed expressions, resolved names |
//! | `lower` | checked shaders of a stage to a module of IR |
//! | `check` | syntax tree to checked shader |
//! | `program`, `link` | checked shaders to a program |
//! | `compile` | all of it for one shader, with fix-its |

mod ast;
mod builtins;
mod check;
mod compile;
mod emit;
mod hir;
pub mod interface;
mod language;
mod lex;
pub mod limits;
mod link;
mod lower;
mod parse;
mod preprocess;
mod program;
mod text;
mod types;
mod work;

pub use compile::{
    Compiled, ContextLanguage, FixIts, Options, Shader, Strictness, compile, compile_strings,
};
pub use limits::{GATHER_OFFSETS, MAX_UNIFORM_LOCATIONS, TEXEL_OFFSETS};
pub use program::*;
pub use rasterizer::ir::Stage;
use rasterizer::stack::with_large_stack;
use std::sync::Arc;
pub use text::spelling;
pub use types::{Comparison, ComparisonResult, DataType, Dim, MatrixOrder, Sampler, Scalar};

/// A program whose stages are some of those of a pipeline.
#[derive(Clone, Copy, Debug)]
pub struct Part<'a> {
    /// The shaders that it was linked from.
    pub shaders: &'a [Shader],
    /// What it was linked to.
    pub program: &'a Program,
}

/// Links the programs of a pipeline: each keeps its uniforms and blocks, and what passes between them is matched as
/// ARB_separate_shader_objects says. It takes little of the caller's stack.
pub fn link_pipeline(parts: &[Part<'_>], bindings: &Bindings) -> LinkedPipeline {
    let units =
        |part: &Part<'_>| part.shaders.iter().map(|shader| Arc::clone(&shader.unit)).collect();
    let parts: Vec<_> = parts.iter().map(|part| (units(part), part.program)).collect();
    with_large_stack(|| link::link_pipeline(&parts, bindings))
}

/// Links shaders into a program. It takes little of the caller's stack.
pub fn link(shaders: &[&Shader], bindings: &Bindings) -> Linked {
    let units: Vec<_> = shaders.iter().map(|shader| &shader.unit).collect();
    with_large_stack(|| link::link(&units, bindings))
}
