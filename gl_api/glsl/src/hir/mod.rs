//! The checked shader: all names resolved, all expressions typed, all conversions explicit.

mod expr;
mod function;
mod recursion;
mod stmt;

use crate::ast::{DepthLayout, Precision};
use crate::builtins::variable::Builtin;
use crate::language::Version;
use crate::text::source::Span;
use crate::types::{MatrixOrder, Type};
pub use expr::{Expr, ExprKind};
pub use function::Function;
use rasterizer::ir::{GeometryInput, GeometryOutput, Interpolation, Stage};
pub use recursion::recursive_call;
use std::collections::BTreeSet;
use std::sync::Arc;
pub use stmt::{Case, Loop, Stmt};

/// A checked shader.
#[derive(Clone, Debug)]
pub struct Unit {
    /// Its stage.
    pub stage: Stage,
    /// The version it is written in.
    pub version: Version,
    /// Whether `#pragma STDGL invariant(all)` makes all outputs invariant.
    pub all_invariant: bool,
    /// The layouts of the geometry stage.
    pub geometry: GeometryLayout,
    /// Its redeclarations of `gl_PerVertex`.
    pub per_vertex: PerVertex,
    /// Its global variables, with the built-in variables that it references.
    pub globals: Vec<Variable>,
    /// Its functions, prototypes among them.
    pub functions: Vec<Function>,
    /// The functions that initializers of globals call.
    pub calls: Vec<u32>,
}

/// What a shader has of the block `gl_PerVertex`, for inputs and for outputs; `None`: it does not
/// redeclare it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PerVertex {
    /// The members of `gl_in`.
    pub inputs: Option<BTreeSet<Arc<str>>>,
    /// Those of the outputs.
    pub outputs: Option<BTreeSet<Arc<str>>>,
}

/// The layouts that a shader of the geometry stage declares.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GeometryLayout {
    /// What it takes.
    pub input: Option<GeometryInput>,
    /// What it makes.
    pub output: Option<GeometryOutput>,
    /// `max_vertices`.
    pub max_vertices: Option<u32>,
}

/// A variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum VarRef {
    /// A global of the unit.
    Global(u32),
    /// A local of the function; the parameters come first.
    Local(u32),
}

/// The direction of a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// `in`.
    In,
    /// `out`.
    Out,
    /// `inout`.
    Inout,
}

/// Where a variable is stored, or what it stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// A variable that is read and written.
    Plain,
    /// `const`.
    Const,
    /// A parameter.
    Parameter(Direction),
    /// `uniform`.
    Uniform,
    /// `attribute`, or `in` of the vertex stage.
    Attribute,
    /// `varying` of the vertex stage, or `out` of it or of the geometry stage.
    Output(Interpolation),
    /// `varying` of the fragment stage, or `in` of it or of the geometry stage, there an array with an
    /// element for each vertex.
    Input(Interpolation),
    /// `out` of the fragment stage.
    FragmentOutput,
    /// A built-in variable.
    Builtin(Builtin),
}

/// Interpolation, invariance and layout qualifiers, as written.
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
    /// `layout(index = n)`.
    pub index: Option<u32>,
    /// `layout(binding = n)`, and where it stands.
    pub binding: Option<(u32, Span)>,
    /// `layout(depth_less)` and the like.
    pub depth: Option<DepthLayout>,
    /// The precision, of its own or by default.
    pub precision: Option<Precision>,
}

impl InterfaceQualifiers {
    /// The number of `layout(binding = n)`.
    pub fn bound(self) -> Option<u32> {
        self.binding.map(|(binding, _)| binding)
    }

    /// The layout of `gl_FragCoord`.
    pub fn coordinates(self) -> [bool; 2] {
        [self.origin_upper_left, self.pixel_center_integer]
    }
}

/// The packing of a uniform block (ARB_uniform_buffer_object, section 4.3.5.2). All are laid out
/// like `std140`; blocks that are `packed` and not referenced are not active.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockPacking {
    /// `shared`.
    Shared,
    /// `packed`.
    Packed,
    /// `std140`.
    Std140,
}

/// The block of a uniform whose type is the structure of the block's members.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// The block's name.
    pub name: Arc<str>,
    /// Whether its members are written with the name of an instance.
    pub is_named: bool,
    /// Its packing.
    pub packing: BlockPacking,
    /// The matrix order of each member.
    pub orders: Vec<MatrixOrder>,
}

/// A block of inputs or outputs, as its declaration has it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InterfaceBlock {
    /// The block's name.
    pub name: Arc<str>,
    /// Whether its members are written with the name of an instance.
    pub is_named: bool,
    /// How many dimensions the array of instances has; 0 of one instance.
    pub dimensions: usize,
    /// The names of its members.
    pub members: Vec<Arc<str>>,
}

/// A variable.
#[derive(Clone, Debug)]
pub struct Variable {
    /// Its name.
    pub name: Arc<str>,
    /// Its type.
    pub ty: Type,
    /// Where it is stored.
    pub storage: Storage,
    /// Where its name is declared.
    pub span: Span,
    /// Where its type stands, if this is the only name of the declaration.
    pub type_span: Option<Span>,
    /// Whether anything but its initializer writes it.
    pub written: bool,
    /// Whether an index that is not constant selects an element.
    pub dynamically_indexed: bool,
    /// Of an array: one more than the largest constant index.
    pub min_len: u32,
    /// The same of an array in an array ([`Variable::inner_depth`]).
    pub inner_min_len: u32,
    /// How many references to it there are.
    pub references: u32,
    /// How many of these select an element of an array by a constant index.
    pub constant_index_references: u32,
    /// Its interpolation, invariance and layout qualifiers.
    pub interface_qualifiers: InterfaceQualifiers,
    /// Whether it is built in and declared again.
    pub redeclared: bool,
    /// Whether the size of the array comes from its largest index alone.
    pub implicitly_sized: bool,
    /// The same of an array in an array.
    pub inner_implicitly_sized: bool,
    /// The uniform block that it is.
    pub block: Option<Arc<Block>>,
    /// The block of inputs or outputs that it is a member of.
    pub member_of: Option<Arc<InterfaceBlock>>,
    /// Its words, if it is a constant.
    pub constant: Option<Arc<[u32]>>,
    /// The initializer of a global.
    pub init: Option<Expr>,
}

impl Variable {
    /// How many arrays are around the inner array whose size may come from its indices: those of a block's instances, or the
    /// vertices.
    pub fn inner_depth(&self) -> usize {
        self.member_of.as_ref().map_or(1, |block| block.dimensions.max(1))
    }

    /// A variable without references, declared at `span`.
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
            inner_min_len: 0,
            references: 0,
            constant_index_references: 0,
            interface_qualifiers: InterfaceQualifiers::default(),
            redeclared: false,
            inner_implicitly_sized: false,
            implicitly_sized: false,
            block: None,
            member_of: None,
            constant: None,
            init: None,
        }
    }

    /// The name that an input or output has in the other stage. A block may be both an input and
    /// an output of the geometry stage, whose inputs are named `in block.member`.
    pub fn passed_name(&self) -> &str {
        self.name.strip_prefix("in ").unwrap_or(&self.name)
    }

    /// Its name for the application: that of a member without its block, if the block has no
    /// instance name (GL 3.2 section 2.11.4).
    pub fn public_name(&self) -> &str {
        match &self.member_of {
            Some(block) if !block.is_named => {
                self.name.rsplit_once('.').map_or(&*self.name, |(_, member)| member)
            }
            Some(_) | None => &self.name,
        }
    }

    /// Whether its initializer has effects, so that it must run even if nothing references the
    /// variable.
    pub fn has_effects(&self) -> bool {
        self.storage == Storage::Plain && self.init.as_ref().is_some_and(Expr::has_effects)
    }

    /// The number of elements of an array that are used, from the first one on (GL 2.1, section
    /// 2.15.3: the highest index used, plus one); `None` if all may be.
    pub fn used_elements(&self) -> Option<u32> {
        (self.references == self.constant_index_references).then_some(self.min_len)
    }
}
