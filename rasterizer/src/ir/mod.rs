//! The shader IR: typed, scalar, structured.
//!
//! A [`Module`] is one shader stage. Everything is scalar: a `vec4` is four values. Control flow is
//! structured: blocks of statements, no jumps. Values live in one arena and are named by handles
//! ([`Value`]); mutable state lives in variables ([`Var`]).
//!
//! # Semantics
//!
//! - **A value is evaluated once**, at its [`Stmt::Eval`], and can be used by any later
//!   statement of the same block or of blocks inside it. Constants, inputs and uniforms need no
//!   `Eval`: they are the same everywhere. Every operand must have been evaluated before.
//! - **Lanes.** A module runs over 64 lanes at once. Each lane sees exactly the control flow it
//!   would see alone. A value is meaningful only in the lanes that were active when it was
//!   evaluated; a store writes only the active lanes.
//! - **Variables start as zero.** An index out of range is clamped to the last element (an `i32` or
//!   `u32` index is compared as unsigned, so a negative one reads the last element too).
//! - **Outputs** are variables: those of [`Module::outputs`] are read when the body has ended.
//! - **Geometry programs** have no such outputs: [`Stmt::EmitVertex`] appends a vertex of the values that it has to the
//!   strip of the lane, [`Stmt::EndPrimitive`] begins another strip.
//! - **Inputs** never change during a run.
//! - **Booleans** are words: `0` or `!0` ([`TRUE`]).
//! - **Operations** ([`Op`]) are pure, total (no operation traps: an integer division by zero is
//!   defined) and the same bits everywhere.
//! - **Derivatives** and implicit-LOD samples read the neighbours of the lane's quad, active or not.
//!   The value of an inactive neighbour is the same on every machine, but not otherwise defined: it
//!   may change with the optimizer (GLSL 1.30, section 8.8, leaves it undefined).
//!
//! [`Module::validate`] checks all of this; the rest of the crate relies on it.

mod build;
mod byte_table;
mod effect;
mod function_table;
mod geometry;
mod interface;
mod module;
mod ops;
mod print;
#[cfg(test)]
mod tests;
mod texture;
mod types;
mod validate;
mod visit;
mod word;

pub use build::Builder;
pub use byte_table::ByteTable;
pub use effect::{Effect, Factors};
pub use function_table::FunctionTable;
pub use geometry::{
    GeometryInput, GeometryInterface, GeometryOutput, MAX_GEOMETRY_COMPONENTS,
    MAX_GEOMETRY_VERTICES,
};
pub use interface::{Input, Interpolation, Output, Stage};
pub use module::{Block, Expr, Module, Stmt, Variable};
pub use ops::Op;
pub(crate) use ops::{batch, scalar, with_operations};
pub use texture::{Access, Lod, Sample, TextureDecl};
pub use types::{Axis, TRUE, Texture, Ty, Value, Var};
pub use validate::{IrError, MAX_NESTING, MAX_VALUES, MAX_VARIABLE_WORDS};
