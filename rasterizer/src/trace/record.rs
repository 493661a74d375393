//! The records of a watched pixel: events, fragments, steps of the shader, tests, writes.

use crate::desc::{Blend, DepthWrite, Facing, LogicOp, StencilFace};
use crate::ir::{Access, Axis, Input, Op, Output, Ty};
use texunit::format::Format;
use texunit::sampler::Compare;
use texunit::trace::SampleTrace;

/// Something that happened to the pixel.
#[derive(Clone, Debug)]
pub enum PixelEvent {
    /// A clear that reached it.
    Clear(Clear),
    /// A shape that covered it.
    Fragment(Box<Fragment>),
}

/// What a clear writes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cleared {
    /// A colour attachment.
    Color(usize),
    /// The depths of the depth attachment.
    Depth,
    /// Its stencils.
    Stencil,
}

/// A clear.
#[derive(Clone, Debug)]
pub struct Clear {
    /// The [`super::Watch::label`] that was set when it was recorded.
    pub label: u32,
    /// Of what.
    pub target: Cleared,
    /// What the first sample holds afterwards.
    pub after: Texel,
}

/// A texel of an attachment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Texel {
    /// Its words in the attachment; of a depth, the integer or the bits of the float, then the
    /// stencil.
    pub words: [u32; 4],
    /// What they mean as red, green, blue, alpha; of a depth, its first number is the depth.
    pub color: [f32; 4],
}

/// A fragment: what a shape made of the pixel.
#[derive(Clone, Debug)]
pub struct Fragment {
    /// The [`super::Watch::label`] of its draw.
    pub label: u32,
    /// Which of the draw's shapes, in order; what was culled or clipped away is not counted.
    pub shape: usize,
    /// Its primitive's vertices: three of a triangle, two of a line, one of a point.
    pub vertices: Vec<Vertex>,
    /// The facing of the primitive.
    pub facing: Facing,
    /// Which samples are covered, bit by sample, and of how many.
    pub samples: (u8, usize),
    /// What the shader reads.
    pub inputs: Vec<InputValue>,
    /// What it computed, in order; at most [`MAX_STEPS`].
    pub steps: Vec<Step>,
    /// How many more steps there were.
    pub more_steps: usize,
    /// The outputs that it wrote and that are used.
    pub outputs: Vec<(Output, Operand)>,
    /// The stencil and depth tests, by sample.
    pub tests: Vec<Test>,
    /// How it ended.
    pub fate: Fate,
    /// What it wrote, by attachment and sample.
    pub writes: Vec<Write>,
}

/// The most steps of a shader that are recorded.
pub const MAX_STEPS: usize = 4096;

/// How a fragment ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// In the attachments.
    Written,
    /// No sample passed the stencil and depth tests.
    TestFailed,
    /// The shader threw it away (`discard`, the alpha test, alpha to coverage).
    Discarded,
    /// Only the tests mattered: the draw writes no colour.
    NoColor,
    /// The shader ran past the device's budget; its draw was dropped.
    OverBudget,
}

/// A vertex of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Clip coordinates.
    pub clip: [f32; 4],
    /// Window x and y; meaningless unless `w > 0`.
    pub window: [f64; 2],
}

/// A shader input of the pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct InputValue {
    /// Which.
    pub input: Input,
    /// Its bits.
    pub bits: u32,
    /// How it came to be.
    pub source: InputSource,
}

/// How an input came to be.
#[derive(Clone, Debug, PartialEq)]
pub enum InputSource {
    /// `(v/w) / (1/w)` (GL 2.1, equations 3.6 and 3.8); each is a plane of the primitive at the pixel,
    /// or, of a centroid varying, at the centroid of the covered samples.
    Perspective {
        /// At each vertex.
        vertices: Vec<f32>,
        /// `v/w`.
        numerator: f32,
        /// `1/w`, or 1 where all vertices have the same `w`.
        denominator: f32,
    },
    /// Linear in the window, from these values at the vertices; none where it is no varying.
    Linear(Vec<f32>),
    /// The value of the provoking vertex.
    Flat,
    /// The derivative of a quotient of planes: `(n' - n/d · d') / d`.
    Gradient,
    /// Of the pixel or the primitive itself.
    Pixel,
}

/// A value by its origin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Name {
    /// The same for the whole draw: a constant, a uniform, or made of those.
    Draw,
    /// An input.
    Input(Input),
    /// A component of a texture access, by the number of its step.
    Texel(u32, u8),
    /// The result of a step, by its number.
    Step(u32),
}

/// A value that a step reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Operand {
    /// Where it comes from.
    pub name: Name,
    /// What it is.
    pub ty: Ty,
    /// Its bits.
    pub bits: u32,
}

/// What a step computes.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A value.
    Operand(Operand),
    /// An operation, each rounded by itself.
    Apply(Op, Vec<Self>),
    /// The difference to the pixel's neighbour in its quad.
    Derivative(Axis, Operand),
    /// A function of a byte, from a table.
    OfByte(Operand),
    /// A power with this exponent.
    Power(Operand, f32),
}

/// A step of the shader.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// A value.
    Value {
        /// Its number.
        number: u32,
        /// What it is made of.
        expression: Expression,
        /// What it is.
        ty: Ty,
        /// Its bits.
        bits: u32,
    },
    /// A texture access.
    Lookup(Box<Lookup>),
    /// The fragment is thrown away.
    Discard,
}

/// A texture access.
#[derive(Clone, Debug, PartialEq)]
pub struct Lookup {
    /// Its number.
    pub number: u32,
    /// The slot of the stage's textures.
    pub slot: u32,
    /// What is done.
    pub access: Access,
    /// The texture and how it is sampled; why it is not, if it is not complete.
    pub texture: String,
    /// Where its coordinates come from.
    pub coords: [Operand; 3],
    /// The steps of a filtered sample of a complete texture.
    pub trace: Option<SampleTrace>,
    /// Red, green, blue, alpha; `None` for components that are not used.
    pub result: [Option<u32>; 4],
}

/// The stencil and depth tests of a sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Test {
    /// Which sample.
    pub sample: usize,
    /// When it was made.
    pub when: When,
    /// The depth of the fragment there, in [0, 1].
    pub depth: f32,
    /// `new OP stored`, and whether a new depth is written.
    pub depth_test: Option<(Compare, DepthWrite)>,
    /// The stencil test of its face, if any.
    pub stencil: Option<StencilFace>,
    /// What was stored.
    pub before: Texel,
    /// What is stored now.
    pub after: Texel,
    /// Whether it passed both.
    pub passed: bool,
}

/// When tests are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// Before shading, as nothing that the shader does can matter.
    Early,
    /// After it.
    Late,
}

/// What a fragment wrote to one sample of one colour attachment.
#[derive(Clone, Debug)]
pub struct Write {
    /// Which attachment.
    pub target: usize,
    /// Which sample.
    pub sample: usize,
    /// How its texels are written.
    pub format: Format,
    /// The shader's colour.
    pub color: [f32; 4],
    /// Blending, if any.
    pub blend: Option<Blending>,
    /// The logical operation, if any.
    pub logic_op: Option<LogicOp>,
    /// Bits of the words that are written.
    pub mask: [u32; 4],
    /// What was stored.
    pub before: Texel,
    /// What is stored now.
    pub after: Texel,
}

/// The arithmetic of blending (GL 2.1, section 4.1.8), component by component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blending {
    /// Equations and factors.
    pub state: Blend,
    /// The source colour, clamped to what the attachment can hold.
    pub source: [f32; 4],
    /// The second source colour, clamped in the same way, if a factor is made of it.
    pub second: Option<[f32; 4]>,
    /// The destination colour.
    pub destination: [f32; 4],
    /// What the source is multiplied by.
    pub source_factor: [f32; 4],
    /// What the destination is multiplied by.
    pub destination_factor: [f32; 4],
    /// The blended colour, unclamped.
    pub result: [f32; 4],
}
