//! The shader IR: typed, scalar, structured.
//!
//! A [`Module`] is one shader stage. Everything is scalar: a `vec4` is four values. Control flow is
//! structured: blocks of statements, no jumps. Values live in one arena and are named by handles
//! ([`Value`]); mutable state lives in variables ([`Var`]).
//!
//! # Semantics
//!
//! - **A value is evaluated once**, where its [`Stmt::Eval`] stands, and can be used by any later
//!   statement of the same block or of blocks inside it. Constants, inputs and uniforms need no
//!   `Eval`: they are the same everywhere. Every operand must have been evaluated before.
//! - **Lanes.** A module runs over 64 lanes at once. Each lane sees exactly the control flow it
//!   would see alone. A value is meaningful only in the lanes that were active when it was
//!   evaluated; a store writes only the active lanes.
//! - **Variables start as zero.** An index out of range is clamped to the last element (an `i32` or
//!   `u32` index is compared as unsigned, so a negative one reads the last element too).
//! - **Outputs** are variables: what [`Module::outputs`] names is read when the body has ended.
//! - **Inputs** never change during a run.
//! - **Booleans** are words: `0` or `!0` ([`TRUE`]).
//! - **Operations** ([`Op`]) are pure, total (no operation traps: an integer division by zero is
//!   defined) and the same bits everywhere.
//! - **Derivatives** and implicit-LOD samples read the neighbours of the lane's quad, active or not.
//!   What an inactive neighbour holds is the same on every machine, but not otherwise defined: it
//!   may change with the optimizer (GLSL 1.30, section 8.8, leaves it undefined).
//!
//! [`Module::validate`] checks all of this; the rest of the crate relies on it.

mod build;
mod ops;
mod print;
#[cfg(test)]
mod tests;
mod validate;
mod visit;

pub use build::Builder;
pub use ops::Op;
pub(crate) use ops::{batch, scalar, with_operations};
pub use validate::{IrError, MAX_NESTING, MAX_VALUES, MAX_VARIABLE_WORDS};

/// The word that stands for `true`.
pub const TRUE: u32 = !0;

/// Which stage of the pipeline a module is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stage {
    /// Runs once a vertex.
    Vertex,
    /// Runs once a fragment.
    Fragment,
}

/// The type of a scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Ty {
    /// IEEE single precision.
    F32,
    /// Two's complement, wrapping.
    I32,
    /// Unsigned, wrapping.
    U32,
    /// `0` or [`TRUE`].
    Bool,
}

/// A handle into [`Module::values`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Value(pub u32);

/// A handle into [`Module::variables`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Var(pub u32);

/// A handle into [`Module::textures`]: the slot that a draw binds a texture to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Texture(pub u32);

/// What a shader reads from the pipeline, one scalar at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Input {
    /// Component 0 to 3 of the vertex attribute at a location (`f32`).
    Attribute {
        /// Attribute location.
        location: u8,
        /// 0 to 3 for x, y, z, w.
        component: u8,
    },
    /// The index of the vertex (`i32`).
    VertexId,
    /// The index of the instance (`i32`).
    InstanceId,
    /// A scalar that the vertex stage wrote to the same slot, interpolated (`f32`).
    Varying(u16),
    /// How that scalar changes from pixel to pixel, at this pixel: the exact derivative of its
    /// interpolation, from the planes of the primitive (`f32`).
    Slope {
        /// Of which varying.
        slot: u16,
        /// Along which axis.
        axis: Axis,
    },
    /// `gl_FragCoord`: window x, y, depth, and `1/w` (`f32`).
    FragCoord(u8),
    /// Whether the primitive faces the viewer (`bool`).
    FrontFacing,
    /// Where in a point sprite the fragment is, 0 to 1 (`f32`).
    PointCoord(u8),
    /// The part of the pixel that the primitive covers, 0 to 1; 1 unless its rim is smooth (`f32`).
    Coverage,
}

/// What a shader writes to the pipeline, one scalar at a time. All are `f32`, but the stencil's reference (`i32`) and
/// colours for attachments of integers, which are `i32` or `u32`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Output {
    /// `gl_Position`, in clip coordinates.
    Position(u8),
    /// `gl_PointSize`, in pixels.
    PointSize,
    /// Distance to a user clip plane; negative is cut away.
    ClipDistance(u8),
    /// A scalar for the fragment stage.
    Varying(u16),
    /// Component 0 to 3 of a colour for a render target.
    Color {
        /// Which colour attachment.
        target: u8,
        /// 0 to 3 for red, green, blue, alpha.
        component: u8,
    },
    /// `gl_FragDepth`.
    Depth,
    /// `gl_FragStencilRefARB`: stands in for the reference of the stencil test, of either face; its lowest 8 bits count.
    StencilReference,
}

/// How a varying is interpolated over a primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Interpolation {
    /// Perspective-correct.
    Smooth,
    /// Linear in window coordinates.
    NoPerspective,
    /// The value at the provoking vertex.
    Flat,
}

/// The kind of texture that a slot takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TextureDecl {
    /// The shape of the coordinates.
    pub shape: texunit::image::Shape,
    /// Whether samples are compared against a reference (`sampler2DShadow`).
    pub compare: bool,
    /// What a sample is made of: `f32`, or the integers of an integer texture (`isampler2D`: `i32`,
    /// `usampler2D`: `u32`). A texture of another kind gives its bits.
    pub texels: Ty,
}

impl TextureDecl {
    /// A slot for textures that do not compare and have colours, not integers.
    pub const fn color(shape: texunit::image::Shape) -> Self {
        Self { shape, compare: false, texels: Ty::F32 }
    }
}

/// The level of detail of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Lod {
    /// From the quad's differences, plus a bias. In the vertex stage: the base level plus the bias.
    Implicit {
        /// Added to λ before the clamp.
        bias: Option<Value>,
    },
    /// This λ.
    Explicit(Value),
    /// From these derivatives of s, t, r (as many as the shape has), plus a bias.
    Gradient {
        /// `∂(s, t, r)/∂x`.
        dx: [Value; 3],
        /// `∂(s, t, r)/∂y`.
        dy: [Value; 3],
        /// Added to λ before the clamp.
        bias: Option<Value>,
    },
}

/// What a texture access does (GLSL 1.30, section 8.7).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Access {
    /// `texture` and its kin, with texels added to the coordinates on each level.
    Filter {
        /// Along s, t, r.
        offset: [i32; 3],
    },
    /// `textureGather`: the first component of each of the four texels that a linear filter of the base level would weigh,
    /// of textures with two axes. Its λ is implicit, without a bias, and does not matter. No compare.
    Gather {
        /// Texels added along s, t.
        offset: [i32; 2],
    },
    /// `texelFetch`: coordinates and the level (an explicit λ) are `i32`. No compare.
    Fetch {
        /// Added to the coordinates.
        offset: [i32; 3],
    },
    /// `textureSize`: width, height and depth (or layers, after the sides that are filtered along)
    /// of a level (an explicit λ, `i32`), as `i32`. Coordinates do not matter. No compare.
    Size,
    /// `textureQueryLOD` of the fragment stage: the level that a lookup without explicit λ reads,
    /// with a fraction where it mixes two, and λ before it is held in the sampler's range, as `f32`.
    /// No compare.
    Lod,
}

impl Access {
    /// A filtered sample without offset.
    pub const FILTER: Self = Self::Filter { offset: [0; 3] };
}

/// One texture access.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Sample {
    /// Which texture.
    pub texture: Texture,
    /// What is done.
    pub access: Access,
    /// s, t, r; coordinates that the shape lacks are a constant zero.
    pub coords: [Value; 3],
    /// The layer of an array of cubes, whose coordinates are a direction.
    pub layer: Option<Value>,
    /// The reference for depth compare, when the slot compares.
    pub reference: Option<Value>,
    /// Where the level of detail comes from.
    pub lod: Lod,
}

/// The axis of a derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Axis {
    /// Window x.
    X,
    /// Window y.
    Y,
}

/// How a value comes to be.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Expr {
    /// These bits.
    Const {
        /// The word.
        bits: u32,
        /// What it means.
        ty: Ty,
    },
    /// From the pipeline.
    Input(Input),
    /// Word `word` of the draw's uniform words.
    Uniform {
        /// Index into the draw's words.
        word: u32,
        /// What it means.
        ty: Ty,
    },
    /// Word `base + index` of the draw's uniform words, `index` clamped below `len`.
    UniformAt {
        /// First word.
        base: u32,
        /// How many words can be reached.
        len: u32,
        /// `i32` or `u32`.
        index: Value,
        /// What it means.
        ty: Ty,
    },
    /// The current value of a variable of length 1.
    Load(Var),
    /// The current value of an element of a variable.
    LoadAt {
        /// The array.
        var: Var,
        /// `i32` or `u32`.
        index: Value,
    },
    /// An operation; operands beyond its arity are `Value(0)`.
    Op {
        /// Which.
        op: Op,
        /// Its operands.
        args: [Value; 3],
    },
    /// `dFdx` or `dFdy` of an `f32`.
    Derivative {
        /// Along which axis.
        axis: Axis,
        /// Of what.
        value: Value,
    },
    /// A texture access. Has four results, taken apart by [`Expr::Component`]; no type of its own.
    Sample(Box<Sample>),
    /// Component 0 to 3 of a sample: of the slot's [`TextureDecl::texels`], of a size `i32`.
    Component {
        /// An [`Expr::Sample`].
        sample: Value,
        /// 0 to 3 for red, green, blue, alpha.
        component: u8,
    },
}

/// A run of statements.
pub type Block = Vec<Stmt>;

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Stmt {
    /// Evaluate a value here.
    Eval(Value),
    /// Write a variable of length 1.
    Store {
        /// Which.
        var: Var,
        /// What.
        value: Value,
    },
    /// Write an element of a variable.
    StoreAt {
        /// The array.
        var: Var,
        /// `i32` or `u32`, clamped.
        index: Value,
        /// What.
        value: Value,
    },
    /// Run one of two blocks.
    If {
        /// A `bool`.
        condition: Value,
        /// Where it is true.
        accept: Block,
        /// Where it is false.
        reject: Block,
    },
    /// Run `body`, then `continuing`, again and again until every lane has left by `Break`,
    /// `Leave` or `Discard`.
    Loop {
        /// [`Stmt::Continue`] ends it for this turn.
        body: Block,
        /// Runs after `body` and after a `Continue` (a `for`'s step, a `do`'s condition). May hold
        /// `Break`, not `Continue`.
        continuing: Block,
    },
    /// A region that [`Stmt::Leave`] leaves: the body of an inlined function, or of `main`.
    Scope(Block),
    /// Leave the innermost loop.
    Break,
    /// Go to the innermost loop's `continuing`.
    Continue,
    /// Leave the innermost scope, and the loops inside it.
    Leave,
    /// Throw the fragment away. Fragment stage only.
    Discard,
}

/// Mutable state of a lane: a scalar, or an array of scalars.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// The type of each element.
    pub ty: Ty,
    /// How many elements; 1 for a scalar.
    pub len: u32,
    /// For listings.
    pub name: String,
}

/// One shader stage.
#[derive(Clone, Debug, PartialEq)]
pub struct Module {
    /// Which stage it is.
    pub stage: Stage,
    /// Every value.
    pub values: Vec<Expr>,
    /// Every variable.
    pub variables: Vec<Variable>,
    /// Every texture slot. A draw binds textures by these indices.
    pub textures: Vec<TextureDecl>,
    /// How many uniform words a draw must bring at least.
    pub uniform_words: u32,
    /// Fragment stage: how each varying slot it may read is interpolated. Empty in the vertex stage.
    pub varyings: Vec<Interpolation>,
    /// Fragment stage: the slots that are taken at the centroid of a pixel's covered samples, where a
    /// pixel has several; the others are taken at its centre.
    pub centroids: Vec<u16>,
    /// Fragment stage: the first of two flat varying slots that the driver writes itself: the low and
    /// the high 16 bits of the primitive's number within its instance of the draw
    /// (`EXT_gpu_shader4`: `gl_PrimitiveID`).
    pub primitive_id: Option<u16>,
    /// The variables (of length 1, type `f32`) that hold the outputs at the end.
    pub outputs: Vec<(Output, Var)>,
    /// What runs.
    pub body: Block,
    /// What its maker left out of it and why, for explanations. No meaning.
    pub notes: Vec<String>,
}

impl Input {
    /// The type of the scalar.
    pub fn ty(self) -> Ty {
        match self {
            Self::VertexId | Self::InstanceId => Ty::I32,
            Self::FrontFacing => Ty::Bool,
            Self::Attribute { .. }
            | Self::Varying(_)
            | Self::Slope { .. }
            | Self::FragCoord(_)
            | Self::PointCoord(_)
            | Self::Coverage => Ty::F32,
        }
    }
}

impl Module {
    /// An empty module.
    pub fn new(stage: Stage) -> Self {
        Self {
            stage,
            values: Vec::new(),
            variables: Vec::new(),
            textures: Vec::new(),
            uniform_words: 0,
            varyings: Vec::new(),
            centroids: Vec::new(),
            primitive_id: None,
            outputs: Vec::new(),
            body: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// The expression behind a handle.
    pub fn expr(&self, value: Value) -> &Expr {
        &self.values[value.0 as usize]
    }

    /// The variable behind a handle.
    pub fn variable(&self, var: Var) -> &Variable {
        &self.variables[var.0 as usize]
    }

    /// The word of a value that is constant.
    pub fn constant(&self, value: Value) -> Option<u32> {
        match self.expr(value) {
            Expr::Const { bits, .. } => Some(*bits),
            Expr::Input(_)
            | Expr::Uniform { .. }
            | Expr::UniformAt { .. }
            | Expr::Load(_)
            | Expr::LoadAt { .. }
            | Expr::Op { .. }
            | Expr::Derivative { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => None,
        }
    }

    /// The type of a value; a sample as a whole counts as `F32`.
    pub fn ty(&self, value: Value) -> Ty {
        match self.expr(value) {
            Expr::Const { ty, .. } | Expr::Uniform { ty, .. } | Expr::UniformAt { ty, .. } => *ty,
            Expr::Input(input) => input.ty(),
            Expr::Load(var) | Expr::LoadAt { var, .. } => self.variable(*var).ty,
            Expr::Op { op, .. } => op.result(),
            Expr::Component { sample, .. } => match self.expr(*sample) {
                Expr::Sample(sample) => self.component_ty(sample),
                _ => Ty::F32,
            },
            Expr::Derivative { .. } | Expr::Sample(_) => Ty::F32,
        }
    }

    /// The type of the components of a sample.
    pub fn component_ty(&self, sample: &Sample) -> Ty {
        match sample.access {
            Access::Size => Ty::I32,
            Access::Lod => Ty::F32,
            Access::Filter { .. } | Access::Gather { .. } | Access::Fetch { .. } => {
                self.textures.get(sample.texture.0 as usize).map_or(Ty::F32, |decl| decl.texels)
            }
        }
    }
}
