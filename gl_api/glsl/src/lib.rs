//! The GLSL front end: text in, IR of the rasterizer out.
//!
//! The modules in the order in which a shader passes through them: `preprocess` over the tokens of
//! `lexer`, `parser` to the syntax tree of `ast`, `check` to the typed tree of `hir`, which names
//! the rows of `builtins`; then `link` matches the stages and `lower` makes IR of them. What is
//! wrong on the way is a row in the log of `diagnostics`; `repair` applies what it suggests.

mod ast;
mod builtins;
mod check;
mod diagnostics;
mod hir;
pub mod interface;
mod lexer;
pub mod limits;
mod link;
mod lower;
mod parser;
mod preprocess;
mod repair;
mod source;
pub mod spelling;
mod types;
mod version;

use crate::interface::StateBinding;
use diagnostics::{Diagnostic, Log};
pub use limits::{GATHER_OFFSETS, TEXEL_OFFSETS};
use rasterizer::ir::{Interpolation, Module, Output};
use rasterizer::stack::with_large_stack;
use source::{Source, Span};
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

/// The kinds of sampler.
pub use types::{Comparison, Dim, Sampler};

/// Which stage a shader object is for.
pub use rasterizer::ir::Stage;

/// Whether the compiler applies the fixes it suggests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Repairs {
    /// What is wrong is rejected.
    #[default]
    Off,
    /// What has one suggested fix is fixed, and listed in the log as a warning.
    On,
}

/// How to compile.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Whether suggested fixes are applied.
    pub repairs: Repairs,
}

/// A compiled, checked shader object.
#[derive(Clone, Debug)]
pub struct Shader {
    unit: Arc<hir::Unit>,
}

impl Shader {
    /// Whether it declares a global of this name.
    pub fn declares(&self, name: &str) -> bool {
        self.unit.globals.iter().any(|global| &*global.name == name)
    }
}

/// What a compilation gives.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The shader, if there was no error.
    pub shader: Option<Shader>,
    /// What `glGetShaderInfoLog` answers; empty when there is nothing to say.
    pub log: String,
}

/// The type of a uniform or attribute as GL reports it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DataType {
    /// A scalar or vector: what it is made of, and 1 to 4 components.
    Vector(Scalar, u8),
    /// A matrix: columns, rows.
    Matrix(u8, u8),
    /// A sampler.
    Sampler(Sampler),
}

/// What a vector is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Scalar {
    /// `float`.
    Float,
    /// `int`.
    Int,
    /// `uint`.
    Uint,
    /// `bool`.
    Bool,
}

/// An attribute of a linked program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attribute {
    /// Its name.
    pub name: String,
    /// Its type. A matrix takes a location for each column.
    pub ty: DataType,
    /// Its (first) location.
    pub location: u8,
}

/// A uniform of a linked program: a scalar, vector, matrix or sampler, or an array of them.
/// Structures come as their members, named `s.member`, `a[2].member`; arrays of arrays as the arrays
/// in their last dimension, `a[2]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Uniform {
    /// Its name, without a trailing `[0]`.
    pub name: String,
    /// The type of an element.
    pub ty: DataType,
    /// How many elements; `None` when it is no array.
    pub array: Option<u32>,
    /// The location of the first element; the others follow one by one.
    pub location: u32,
    /// Its first word. Elements follow each other without gaps: 1 word a scalar (a `bool` as
    /// [`rasterizer::ir::TRUE`] or 0), 1 to 4 a vector, column by column a matrix, 1 a sampler
    /// (its texture unit).
    pub word: u32,
    /// The initial words (zeros unless the shader has an initializer).
    pub initial: Vec<u32>,
}

/// Which way a matrix lies in a buffer (ARB_uniform_buffer_object, section 2.15.3.1.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MatrixOrder {
    /// Column by column.
    Columns,
    /// Row by row.
    Rows,
}

/// A uniform of a uniform block. It has no location; its value comes from a buffer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Member {
    /// Its name, without a trailing `[0]`.
    pub name: String,
    /// The type of an element.
    pub ty: DataType,
    /// How many elements; `None` when it is no array.
    pub array: Option<u32>,
    /// Which block.
    pub block: u32,
    /// Its first word, counted from the block's; as those of [`Uniform`].
    pub word: u32,
    /// Its first byte in the buffer, counted from the block's.
    pub offset: u32,
    /// Bytes from an element to the next; 0 when it is no array.
    pub array_stride: u32,
    /// Bytes from a column (or a row) to the next; 0 when it is no matrix.
    pub matrix_stride: u32,
    /// Which way a matrix lies.
    pub order: MatrixOrder,
}

/// A uniform block of a linked program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UniformBlock {
    /// Its name.
    pub name: String,
    /// The bytes of a buffer that it needs.
    pub bytes: u32,
    /// Its first word; `None` if no stage reads it.
    pub word: Option<u32>,
    /// Which members it has.
    pub members: std::ops::Range<u32>,
    /// Which stages read it.
    pub stages: Vec<Stage>,
}

/// Built-in state that a program reads, as `glGetActiveUniform` lists it: it has no location.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BuiltinUniform {
    /// Name, such as `gl_FrontMaterial.diffuse`.
    pub name: String,
    /// Type of the variable or of its elements.
    pub ty: DataType,
    /// Number of elements; `None` if it is no array.
    pub array: Option<u32>,
}

/// A texture slot of a module and the uniform that says which unit it samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SamplerSlot {
    /// Which stage's module.
    pub stage: Stage,
    /// Index into that module's `textures`.
    pub slot: u32,
    /// The uniform word that holds the texture unit.
    pub word: u32,
    /// The shape of the textures that it takes.
    pub dim: Dim,
    /// What comes of comparisons.
    pub result: ComparisonResult,
}

/// What a lookup makes of a comparison with a depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ComparisonResult {
    /// Four components, as `GL_DEPTH_TEXTURE_MODE` has them: functions such as `shadow2D`.
    Placed,
    /// One number, whatever the mode is: the functions of GLSL 1.30.
    Scalar,
    /// There is none, whatever the sampler says: assembly programs that do not ask for it.
    Ignored,
}

/// What was asked for with `glBindAttribLocation`, `glBindFragDataLocation` and
/// `glTransformFeedbackVaryings` before the link.
#[derive(Clone, Debug, Default)]
pub struct Bindings {
    /// Attribute name to location.
    pub attributes: BTreeMap<String, u8>,
    /// Fragment output name to colour attachment.
    pub frag_data: BTreeMap<String, u8>,
    /// What transform feedback captures.
    pub capture: Capture,
}

/// How transform feedback fills buffers (GL 3.0 section 2.15).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BufferMode {
    /// All varyings of a vertex one after the other into one buffer.
    #[default]
    Interleaved,
    /// Each varying into a buffer of its own.
    Separate,
}

/// What transform feedback was asked to capture.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Capture {
    /// How it fills buffers.
    pub mode: BufferMode,
    /// The names, in order.
    pub varyings: Vec<CaptureRequest>,
}

/// A name that transform feedback was asked to capture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CaptureRequest {
    /// The variable.
    pub variable: String,
    /// The element of the array, if the name ends in `[n]`.
    pub element: Option<u32>,
}

impl fmt::Display for CaptureRequest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.element {
            Some(element) => write!(f, "{}[{element}]", self.variable),
            None => f.write_str(&self.variable),
        }
    }
}

/// A varying that transform feedback captures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Captured {
    /// Its name, as it was asked for.
    pub name: String,
    /// The type of it or of its elements.
    pub ty: DataType,
    /// How many elements; 1 if it is no array.
    pub size: u32,
    /// Where its scalars are, in order.
    pub scalars: Vec<CapturedScalar>,
}

/// Where a captured scalar is among the outputs of the vertex stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CapturedScalar {
    /// An output as it is.
    Float(Output),
    /// A word whose halves of 16 bits are outputs.
    Word {
        /// The low half.
        low: Output,
        /// The high half.
        high: Output,
    },
}

/// A linked program.
#[derive(Clone, Debug)]
pub struct Program {
    /// The vertex stage; `None` leaves it to the fixed function.
    pub vertex: Option<Module>,
    /// The fragment stage; `None` leaves it to the fixed function.
    pub fragment: Option<Module>,
    /// What it reads per vertex: generic attributes, then the conventional ones, whose locations
    /// begin at [`ATTRIB_VERTEX`](crate::interface::ATTRIB_VERTEX).
    pub attributes: Vec<Attribute>,
    /// What the application sets.
    pub uniforms: Vec<Uniform>,
    /// The members of uniform blocks.
    pub members: Vec<Member>,
    /// The uniform blocks.
    pub blocks: Vec<UniformBlock>,
    /// The built-in uniforms that it names.
    pub builtin_uniforms: Vec<BuiltinUniform>,
    /// The fragment stage's own outputs and the colours they go to.
    pub outputs: Vec<(String, u8)>,
    /// The fragment stage's own varyings: first slot, how many slots, name.
    pub varyings: Vec<(u16, u16, String)>,
    /// What transform feedback captures, and how.
    pub captured: Vec<Captured>,
    /// How it fills buffers.
    pub buffer_mode: BufferMode,
    /// Which texture slots sample which units.
    pub samplers: Vec<SamplerSlot>,
    /// How its shaders say that the colour and the secondary colour are interpolated; `None` leaves
    /// it to the shade model (GLSL 1.30 section 4.3.7).
    pub color_interpolation: [Option<Interpolation>; 2],
    /// GL state that it reads through uniform words.
    pub state: Vec<StateBinding>,
    /// How many uniform words a draw brings: uniforms and state together.
    pub words: u32,
}

/// What a link gives.
#[derive(Clone, Debug)]
pub struct Linked {
    /// The program, if there was no error.
    pub program: Option<Program>,
    /// What `glGetProgramInfoLog` answers.
    pub log: String,
}

/// One run of the compiler over one text.
struct Pass {
    unit: hir::Unit,
    source: Source,
    log: Log,
}

impl Pass {
    /// The shader, if nothing is wrong with it.
    fn shader(self) -> Option<Shader> {
        (!self.log.has_errors()).then(|| Shader { unit: Arc::new(self.unit) })
    }
}

fn compile_once(stage: Stage, text: &str) -> Pass {
    let mut log = Log::default();
    let too_long = text.len() > limits::MAX_SOURCE;
    let mut source = Source::new(if too_long { "" } else { text });
    if too_long {
        let message = format!("the source has more than {} bytes", limits::MAX_SOURCE);
        log.push(Diagnostic::error(Span::default(), message));
    }
    let preprocessed = preprocess::preprocess(&mut source, &mut log);
    let items = parser::parse(&preprocessed.tokens, preprocessed.language, &mut log);
    let mut unit = check::check(&items, stage, preprocessed.language, &source, &mut log);
    unit.all_invariant = preprocessed.all_invariant;
    Pass { unit, source, log }
}

/// Compiles one shader. Any text is fine; it never panics, and takes little of the caller's stack.
pub fn compile(stage: Stage, source: &str, options: &Options) -> Compiled {
    with_large_stack(|| match options.repairs {
        Repairs::Off => {
            let pass = compile_once(stage, source);
            let log = pass.log.render(Some(&pass.source));
            Compiled { shader: pass.shader(), log }
        }
        Repairs::On => repair::compile(stage, source),
    })
}

/// Links shaders into a program. It takes little of the caller's stack.
pub fn link(shaders: &[&Shader], bindings: &Bindings) -> Linked {
    with_large_stack(|| link::link(shaders, bindings))
}
