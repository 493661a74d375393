//! From IR to lanes: optimize, lower to a register program, run it over 64 lanes.
//!
//! The modules, in the order in which a shader passes through them:
//!
//! | module | contents |
//! |---|---|
//! | [`optimize`] | passes over the structured IR |
//! | [`lower`] | structured IR → flat [`inst`]ructions over virtual registers |
//! | [`uniformity`] | values and branches that are the same in all lanes and need no mask |
//! | [`exits`] | how lanes leave a statement |
//! | [`maskless_stores`] | variables that only one loop reads: stored without a mask |
//! | [`compute`], [`fuse`] | fused operations: the table, and the search for its trees |
//! | [`preamble`] | values computed once per draw |
//! | [`schedule`] | order of instructions |
//! | [`allocate`] | virtual → real registers |
//! | [`repeated_lookups`] | lookups with the operands of the lookup before |
//! | [`shared_axes`] | lookups in one column or row |
//! | [`product`] | programs that need no interpreter: products of texels |
//! | [`attribute_dependencies`] | which attributes an output of the vertex stage depends on |
//! | [`program`] | the compiled stage, and its per-draw values |
//! | [`facts`] | uniform values and textures of a draw that a program can be compiled for |
//! | [`emission`] | the vertices that a geometry program emits |
//! | [`native`] | machine code for straight runs of instructions |
//! | [`machine`] | the interpreter: 64 lanes for each instruction, with an execution [`mask`] |

mod allocate;
mod attribute_dependencies;
mod compute;
mod constant_outputs;
mod emission;
mod exits;
mod facts;
mod fuse;
mod inst;
mod invocation;
mod lower;
mod machine;
mod mask;
mod maskless_stores;
mod native;
mod optimize;
mod preamble;
mod product;
mod program;
mod repeated_lookups;
mod schedule;
mod shared_axes;
mod uniformity;

pub(crate) use attribute_dependencies::AttributeSet;
pub use emission::Emission;
pub(crate) use facts::{FactSources, Facts};
pub use invocation::{Invocation, OverBudget};
pub use machine::{Machine, Tracer};
pub(crate) use optimize::SideVaryings;
pub use product::{ProductCode, TexelProduct};
#[cfg(test)]
use program::Fusing;
pub(crate) use program::{LevelOfDetail, OptimizedModule};
pub use program::{MAX_REGISTER_FILES, Prepared, Program};

#[cfg(test)]
mod tests;
