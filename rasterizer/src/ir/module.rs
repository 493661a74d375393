//! A module: expressions, statements, variables.

use super::function_table::FunctionTable;
use super::geometry::GeometryInterface;
use super::interface::{Input, Interpolation, Output, Stage};
use super::ops::Op;
use super::texture::{Access, Lod, Sample, TextureDecl};
use super::types::{Axis, Ty, Value, Var};

/// The definition of a value.
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
    /// A function of one number.
    Tabulated {
        /// An `f32`.
        value: Value,
        /// The function.
        table: FunctionTable,
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
        /// [`Stmt::Continue`] ends this iteration of it.
        body: Block,
        /// Runs after `body` and after a `Continue` (a `for`'s step, a `do`'s condition). May hold
        /// `Break`, not `Continue`.
        continuing: Block,
    },
    /// A region that [`Stmt::Leave`] leaves: the body of an inlined function, or of `main`.
    Scope(Block),
    /// Leave the innermost loop.
    Break,
    /// Continue with the `continuing` block of the innermost loop.
    Continue,
    /// Leave the innermost scope, and the loops inside it.
    Leave,
    /// Throw the fragment away. Fragment stage only.
    Discard,
    /// Append a vertex to the strip of the lane: a value for each of [`GeometryInterface::outputs`]. Geometry stage
    /// only; no effect beyond [`GeometryInterface::max_vertices`].
    EmitVertex(Vec<Value>),
    /// The next vertex begins another strip. Geometry stage only.
    EndPrimitive,
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
    /// Geometry stage: its primitives and its outputs.
    pub geometry: Option<GeometryInterface>,
    /// Fragment stage: how each varying slot it may read is interpolated. Empty in the other stages.
    pub varyings: Vec<Interpolation>,
    /// Fragment stage: the slots that are evaluated at the centroid of a pixel's covered samples, where a
    /// pixel has several; the others are taken at its centre.
    pub centroids: Vec<u16>,
    /// Fragment stage: the first of two flat varying slots that the driver writes itself: the low and
    /// the high 16 bits of the primitive's number within its instance of the draw
    /// (`EXT_gpu_shader4`: `gl_PrimitiveID`), or of what the geometry stage wrote to [`Output::PrimitiveId`].
    pub primitive_id: Option<u16>,
    /// The variables (of length 1, type `f32`) that hold the outputs at the end. Empty in the geometry stage.
    pub outputs: Vec<(Output, Var)>,
    /// The statements.
    pub body: Block,
    /// What the front end left out and why, for explanations. No effect on the result.
    pub notes: Vec<String>,
}

impl Module {
    /// Whether a lookup has an implicit level of detail.
    pub(crate) fn has_implicit_lod(&self) -> bool {
        let is_implicit = |sample: &Sample| matches!(sample.lod, Lod::Implicit { .. });
        self.values.iter().any(|expr| match expr {
            Expr::Sample(sample) => is_implicit(sample),
            Expr::Const { .. }
            | Expr::Input(_)
            | Expr::Uniform { .. }
            | Expr::UniformAt { .. }
            | Expr::Op { .. }
            | Expr::Load(_)
            | Expr::LoadAt { .. }
            | Expr::Derivative { .. }
            | Expr::Tabulated { .. }
            | Expr::Component { .. } => false,
        })
    }

    /// An empty module.
    pub fn new(stage: Stage) -> Self {
        Self {
            stage,
            values: Vec::new(),
            variables: Vec::new(),
            textures: Vec::new(),
            uniform_words: 0,
            geometry: None,
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
            | Expr::Tabulated { .. }
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
            Expr::Derivative { .. } | Expr::Tabulated { .. } | Expr::Sample(_) => Ty::F32,
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
