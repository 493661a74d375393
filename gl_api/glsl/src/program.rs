//! Input and result of a link: the bindings that the application set, and the linked program.

use crate::interface::StateBinding;
use crate::types::{ComparisonResult, DataType, Dim, MatrixOrder};
use rasterizer::ir::{Interpolation, Module, Output, Stage};
use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

/// An attribute of a linked program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attribute {
    /// Its name.
    pub name: String,
    /// The type of it or of its elements. A matrix takes a location for each column.
    pub ty: DataType,
    /// How many elements; `None` when it is no array.
    pub array: Option<u32>,
    /// Its (first) location.
    pub location: u8,
}

/// A colour that the fragment stage gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FragmentColor {
    /// Its draw buffer.
    pub location: u8,
    /// Which colour of the blend function it is: 0, or 1 (GL 3.3, section 4.1.7).
    pub index: u8,
}

/// An output of the fragment stage of a linked program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FragmentOutput {
    /// Its name.
    pub name: String,
    /// Its (first) colour attachment.
    pub color: u8,
    /// Which colour of the blend function it is: 0, or 1 (GL 3.3, section 4.1.7).
    pub index: u8,
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
    /// Its first word, relative to the block's; as those of [`Uniform`].
    pub word: u32,
    /// Its first byte in the buffer, relative to the block's.
    pub offset: u32,
    /// Bytes from an element to the next; 0 when it is no array.
    pub array_stride: u32,
    /// Bytes from a column (or a row) to the next; 0 when it is no matrix.
    pub matrix_stride: u32,
    /// The order of a matrix.
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
    /// The binding that the shader gives it.
    pub binding: u32,
    /// The range of its members in [`Program::members`].
    pub members: Range<u32>,
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
    /// The stage of the module.
    pub stage: Stage,
    /// Index into that module's `textures`.
    pub slot: u32,
    /// The uniform word that holds the texture unit.
    pub word: u32,
    /// The shape of the textures that it takes.
    pub dim: Dim,
    /// The result of its comparisons.
    pub result: ComparisonResult,
}

/// What the application set before the link with `glBindAttribLocation`, `glBindFragDataLocationIndexed`
/// and `glTransformFeedbackVaryings`.
#[derive(Clone, Debug, Default)]
pub struct Bindings {
    /// Attribute name to location.
    pub attributes: BTreeMap<String, u8>,
    /// Fragment output name to its colour.
    pub frag_data: BTreeMap<String, FragmentColor>,
    /// What transform feedback captures.
    pub capture: Capture,
    /// Whether the stages of the program may be combined with those of others.
    pub separable: Separable,
}

/// `GL_PROGRAM_SEPARABLE`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Separable {
    /// The program is used as a whole.
    #[default]
    No,
    /// Its stages can be those of program pipelines (ARB_separate_shader_objects).
    Yes,
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

/// What the application set for transform feedback to capture.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Capture {
    /// How it fills buffers.
    pub mode: BufferMode,
    /// The names, in order.
    pub varyings: Vec<CaptureRequest>,
}

/// A name that transform feedback is to capture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CaptureRequest {
    /// An output.
    Varying {
        /// The variable.
        variable: String,
        /// The element of the array, if the name ends in `[n]`.
        element: Option<u32>,
    },
    /// Components that keep what the buffer has: `gl_SkipComponents1` to `4` (`ARB_transform_feedback3`).
    Gap(u8),
    /// The names after it are captured into the next buffer: `gl_NextBuffer`.
    NextBuffer,
}

impl fmt::Display for CaptureRequest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Varying { variable, element: Some(element) } => {
                write!(f, "{variable}[{element}]")
            }
            Self::Varying { variable, element: None } => f.write_str(variable),
            Self::Gap(components) => write!(f, "gl_SkipComponents{components}"),
            Self::NextBuffer => f.write_str("gl_NextBuffer"),
        }
    }
}

/// A varying that transform feedback captures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Captured {
    /// Its name, as the application gave it.
    pub name: String,
    /// What it is.
    pub item: CapturedItem,
    /// How many elements, 1 if it is no array; how many components of a gap.
    pub size: u32,
    /// Its scalars among the outputs of the vertex stage, in order.
    pub scalars: Vec<CapturedScalar>,
}

/// What a name of [`Captured`] stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CapturedItem {
    /// An output, by the type of it or of its elements.
    Varying(DataType),
    /// Components of the buffer that are left as they are.
    Gap,
    /// `gl_NextBuffer`: the names after it are captured into the next buffer.
    NextBuffer,
}

/// A captured scalar among the outputs of the vertex stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CapturedScalar {
    /// A component of the buffer that is left as it is.
    Gap,
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
    /// The vertex stage; `None` if it is fixed function.
    pub vertex: Option<Module>,
    /// The geometry stage; `None` if there is none.
    pub geometry: Option<Module>,
    /// The fragment stage; `None` if it is fixed function.
    pub fragment: Option<Module>,
    /// What it reads per vertex: generic attributes, then the conventional ones, whose locations
    /// begin at [`ATTRIB_VERTEX`](crate::interface::ATTRIB_VERTEX).
    pub attributes: Vec<Attribute>,
    /// The names of the integers that its vertex stage reads and no array holds: `gl_VertexID` and `gl_InstanceID`, which are
    /// active attributes too (GL 3.3 section 2.11.3).
    pub vertex_numbers: Vec<String>,
    /// What the application sets.
    pub uniforms: Vec<Uniform>,
    /// The locations that `layout(location = n)` gives, also to uniforms that are not active.
    pub explicit_locations: Vec<Range<u32>>,
    /// The members of uniform blocks.
    pub members: Vec<Member>,
    /// The uniform blocks.
    pub blocks: Vec<UniformBlock>,
    /// The built-in uniforms that it references.
    pub builtin_uniforms: Vec<BuiltinUniform>,
    /// The user-defined outputs of the fragment stage.
    pub outputs: Vec<FragmentOutput>,
    /// The user-defined varyings of the fragment stage: first slot, number of slots, name.
    pub varyings: Vec<(u16, u16, String)>,
    /// The varyings that transform feedback captures.
    pub captured: Vec<Captured>,
    /// How it fills buffers.
    pub buffer_mode: BufferMode,
    /// The texture slots, with the uniforms that hold their units.
    pub samplers: Vec<SamplerSlot>,
    /// The interpolation of the colour and the secondary colour that its shaders declare; `None`
    /// leaves it to the shade model (GLSL 1.30 section 4.3.7).
    pub color_interpolation: [Option<Interpolation>; 2],
    /// GL state that it reads through uniform words.
    pub state: Vec<StateBinding>,
    /// The number of uniform words of a draw: uniforms and state together.
    pub words: u32,
}

impl Program {
    /// The scalars that are captured for a vertex, by buffer.
    pub fn captured_by_buffer(&self) -> Vec<Vec<CapturedScalar>> {
        let of_name = |captured: &Captured| captured.scalars.clone();
        match self.buffer_mode {
            BufferMode::Separate => self.captured.iter().map(of_name).collect(),
            BufferMode::Interleaved => {
                let buffers = self.captured.split(|name| name.item == CapturedItem::NextBuffer);
                buffers.map(|names| names.iter().flat_map(of_name).collect()).collect()
            }
        }
    }

    /// Whether a uniform, active or not, declares this location.
    pub fn is_explicit_location(&self, location: i32) -> bool {
        let is_in =
            |range: &Range<u32>| u32::try_from(location).is_ok_and(|at| range.contains(&at));
        self.explicit_locations.iter().any(is_in)
    }
}

/// Uniform words of a pipeline that are those of one of its programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WordsOfPart {
    /// The index of the program.
    pub part: usize,
    /// The first word there.
    pub from: u32,
    /// The first word in the pipeline.
    pub to: u32,
    /// How many.
    pub count: u32,
}

/// The programs of a pipeline, linked.
#[derive(Clone, Debug)]
pub struct LinkedPipeline {
    /// The program of all stages.
    pub linked: Linked,
    /// Where its uniforms come from.
    pub words: Vec<WordsOfPart>,
    /// For each of its uniform blocks the program that it comes from, and the index there.
    pub blocks: Vec<(usize, usize)>,
}

/// The result of a link.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Linked {
    /// The program, if there was no error.
    pub program: Option<Program>,
    /// The answer of `glGetProgramInfoLog`.
    pub log: String,
}
