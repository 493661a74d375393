//! Assembly programs: ARB_vertex_program, ARB_fragment_program, ARB_fragment_program_shadow.
//!
//! The modules in the order in which a program passes through them: `lexer`, `parser` (with
//! `declaration`, `operand`, `state` and `counts`) to the instructions of `program`, then `lower`, which makes IR
//! of them with `arithmetic` and puts their parameters into the uniform words of `layout`. What
//! comes out is what the GLSL linker gives, a stage with its words; the draw layer fills these in, where
//! the program in use lacks the stage.

mod arithmetic;
mod counts;
mod declaration;
pub(crate) mod layout;
mod lexer;
pub(crate) mod lower;
mod operand;
mod parser;
pub(crate) mod program;
mod state;

use crate::glsl;
use crate::glsl::BufferMode;
use crate::glsl::spelling::closest;
use layout::Row;
pub(crate) use program::{Counts, Target};
use rasterizer::ir::IrError;

/// Why a program does not load.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Failure {
    /// Where, in bytes.
    pub position: usize,
    pub message: String,
}

impl Failure {
    fn at<T>(position: usize, message: impl Into<String>) -> Result<T, Self> {
        Err(Self { position, message: message.into() })
    }

    /// The failure for an unknown name, which suggests similar known ones.
    #[cold]
    fn unknown(position: usize, message: String, name: &str, known: &[&str]) -> Self {
        let message = match closest(name, known.iter().copied()) {
            Some(near) => format!("{message}: did you mean {near}?"),
            None => message,
        };
        Self { position, message }
    }

    /// The message with its position and the text there.
    pub(crate) fn in_text(&self, text: &str) -> String {
        /// How much of a line is shown to either side.
        const SHOWN: usize = 40;
        let position = text.floor_char_boundary(self.position);
        let (before, after) = text.split_at(position);
        let line = 1 + before.matches('\n').count();
        let before = before.rsplit('\n').next().unwrap_or_default();
        let after = after.split(['\r', '\n']).next().unwrap_or_default();
        let column = 1 + before.chars().count();
        let first = before.ceil_char_boundary(before.len().saturating_sub(SHOWN));
        let last = after.floor_char_boundary(SHOWN);
        let excerpt = format!("{}{}", &before[first..], &after[..last]);
        let quoted = match excerpt.trim() {
            "" => String::new(),
            excerpt => format!(", in \"{excerpt}\""),
        };
        format!("line {line}, column {column}{quoted}: {}", self.message)
    }
}

type Parsed<T> = Result<T, Failure>;

/// Whether a vertex program's position is the fixed function's (`ARB_position_invariant`), which
/// user clip planes cut; other positions they leave alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Position {
    Invariant,
    Computed,
}

/// A loaded program: the stage that a linker would give, and what only an assembly program has.
#[derive(Debug)]
pub(crate) struct Loaded {
    pub program: glsl::Program,
    /// The values of its words before a draw fills in state and parameters.
    pub initial: Vec<u32>,
    /// The words that a draw fills in beside the state, by their first words.
    pub rows: Vec<(u32, Row)>,
    pub counts: Counts,
    pub position: Position,
}

/// Why a program whose text is valid does not load: its module has too many values.
pub(crate) fn too_large(text: &str, error: &IrError) -> Failure {
    Failure { position: text.len(), message: format!("the program is too large: {error}") }
}

/// Loads a program. It never panics, whatever the text.
///
/// # Errors
/// The first error in the text.
pub(crate) fn load(text: &str, target: Target) -> Parsed<Loaded> {
    let program = parser::parse(text, target)?;
    let lower::Lowered { module, layout, samplers } = lower::lower(&program);
    let (vertex, fragment) = match target {
        Target::Vertex => (Some(module), None),
        Target::Fragment => (None, Some(module)),
    };
    let linked = glsl::Program {
        vertex,
        geometry: None,
        fragment,
        attributes: Vec::new(),
        vertex_numbers: Vec::new(),
        uniforms: Vec::new(),
        explicit_locations: Vec::new(),
        members: Vec::new(),
        blocks: Vec::new(),
        builtin_uniforms: Vec::new(),
        outputs: Vec::new(),
        varyings: Vec::new(),
        captured: Vec::new(),
        buffer_mode: BufferMode::Interleaved,
        samplers,
        color_interpolation: [None; 2],
        words: layout.len(),
        state: layout.state,
    };
    let position = match program.options.position_invariant {
        true => Position::Invariant,
        false => Position::Computed,
    };
    Ok(Loaded {
        program: linked,
        initial: layout.initial,
        rows: layout.rows,
        counts: program.counts,
        position,
    })
}
