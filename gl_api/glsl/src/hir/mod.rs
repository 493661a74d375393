//! A checked shader: every name resolved, every expression typed, every conversion written out.

mod expr;
mod function;
mod recursion;
mod stmt;

use crate::builtins::variable::Builtin;
use crate::language::Version;
use crate::text::source::Span;
use crate::types::{MatrixOrder, Type};
pub use expr::{Expr, ExprKind};
pub use function::Function;
use rasterizer::ir::{Interpolation, Stage};
pub use recursion::recursive_call;
use std::sync::Arc;
pub use stmt::{Case, Loop, Stmt};

/// A checked shader.
#[derive(Clone, Debug)]
pub struct Unit {
    /// Its stage.
    pub stage: Stage,
    /// The version it is written in.
    pub version: Version,
    /// Whether all that it passes on is invariant, by a `#pragma`.
    pub all_invariant: bool,
    /// Its global variables, those of the language that it names among them.
    pub globals: Vec<Variable>,
    /// Its functions, prototypes among them.
    pub functions: Vec<Function>,
    /// The functions that initializers of globals call.
    pub calls: Vec<u32>,
}

/// A variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum VarRef {
    /// Of the unit.
    Global(u32),
    /// Of the function; the parameters come first.
    Local(u32),
}

/// Which way a parameter goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// `in`.
    In,
    /// `out`.
    Out,
    /// `inout`.
    Inout,
}

/// What a variable is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// Read and written.
    Plain,
    /// `const`.
    Const,
    /// A parameter.
    Parameter(Direction),
    /// `uniform`.
    Uniform,
    /// `attribute`, or `in` of the vertex stage.
    Attribute,
    /// `varying` of the vertex stage, or its `out`.
    Output(Interpolation),
    /// `varying` of the fragment stage, or its `in`.
    Input(Interpolation),
    /// `out` of the fragment stage.
    FragmentOutput,
    /// Part of the language.
    Builtin(Builtin),
}

/// The words about how a variable passes between the stages, as written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct InterfaceQualifiers {
    /// `smooth`, `flat` or `noperspective`.
    pub interpolation: Option<Interpolation>,
    /// `invariant`.
    pub invariant: bool,
    /// `centroid`.
    pub centroid: bool,
    /// `layout(origin_upper_left)`.
    pub origin_upper_left: bool,
    /// `layout(pixel_center_integer)`.
    pub pixel_center_integer: bool,
    /// `layout(location = n)`.
    pub location: Option<u32>,
}

/// How a uniform block lies in its buffer (ARB_uniform_buffer_object, section 4.3.5.2). They lie
/// all as `std140` says; what is `packed` and not named is not there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockPacking {
    /// `shared`.
    Shared,
    /// `packed`.
    Packed,
    /// `std140`.
    Std140,
}

/// What makes a uniform that is a structure a uniform block: its members have the names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// The block's name.
    pub name: Arc<str>,
    /// How it lies in its buffer.
    pub packing: BlockPacking,
    /// How the matrices of each member lie.
    pub orders: Vec<MatrixOrder>,
}

/// A variable.
#[derive(Clone, Debug)]
pub struct Variable {
    /// Its name.
    pub name: Arc<str>,
    /// Its type.
    pub ty: Type,
    /// What it is.
    pub storage: Storage,
    /// Where its name is declared.
    pub span: Span,
    /// Where the type stands, if this is the only name declared with it.
    pub type_span: Option<Span>,
    /// Whether anything but its initializer writes it.
    pub written: bool,
    /// Whether it is indexed by what is not constant.
    pub dynamically_indexed: bool,
    /// Of an array: one more than the largest constant index.
    pub min_len: u32,
    /// How often it is named.
    pub references: u32,
    /// How often of these it is an array of which a constant names an element.
    pub constant_index_references: u32,
    /// The words about how it passes between the stages, as written.
    pub interface_qualifiers: InterfaceQualifiers,
    /// Whether the size of the array comes from its largest index alone.
    pub implicitly_sized: bool,
    /// What it is as a uniform block.
    pub block: Option<Arc<Block>>,
    /// Its words, if it is a constant.
    pub constant: Option<Arc<[u32]>>,
    /// The initializer of a global.
    pub init: Option<Expr>,
}

impl Variable {
    /// One that nothing is known of but how it is declared, at `span`.
    pub fn new(name: Arc<str>, ty: Type, storage: Storage, span: Span) -> Self {
        Self {
            name,
            ty,
            storage,
            span,
            type_span: None,
            written: false,
            dynamically_indexed: false,
            min_len: 0,
            references: 0,
            constant_index_references: 0,
            interface_qualifiers: InterfaceQualifiers::default(),
            implicitly_sized: false,
            block: None,
            constant: None,
            init: None,
        }
    }

    /// Whether its value has effects, so that it is worked out even if nobody names the variable.
    pub fn has_effects(&self) -> bool {
        self.storage == Storage::Plain && self.init.as_ref().is_some_and(Expr::has_effects)
    }

    /// How many elements of an array anything names, from the first one on (GL 2.1, section 2.15.3:
    /// the highest index used, plus one); `None` where all may be.
    pub fn used_elements(&self) -> Option<u32> {
        (self.references == self.constant_index_references).then_some(self.min_len)
    }
}
