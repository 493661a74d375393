//! From IR to lanes: optimize, lower to a register program, run it over 64 lanes.
//!
//! The modules in the order in which a shader passes through them:
//!
//! | module | is |
//! |---|---|
//! | [`optimize`] | passes over the structured IR |
//! | [`lower`] | structured IR → flat [`inst`]ructions over virtual registers |
//! | [`uniformity`] | what all lanes do alike: no mask is looked at |
//! | [`exits`] | how lanes leave a statement |
//! | [`maskless_stores`] | the variables that only one loop reads: stored without a mask |
//! | [`compute`] | what an instruction computes: an operation, or a tree of them |
//! | [`fuse`] | several operations as one instruction |
//! | [`preamble`] | the values that a draw computes once |
//! | [`allocate`] | real registers for virtual ones |
//! | [`repeated_lookups`] | lookups at the points of the one before |
//! | [`product`] | the programs that need no interpreter |
//! | [`machine`] | the interpreter: 64 lanes an instruction, with an execution [`mask`] |

mod allocate;
mod attribute_dependencies;
mod compute;
mod exits;
mod fuse;
mod inst;
mod lower;
mod machine;
mod mask;
mod maskless_stores;
mod optimize;
mod preamble;
mod product;
mod program;
mod repeated_lookups;
mod run;
mod schedule;
mod uniformity;

pub(crate) use attribute_dependencies::AttributeSet;
pub use machine::{Machine, Tracer};
pub use product::{ProductCode, TexelProduct};
#[cfg(test)]
use program::Fusing;
pub(crate) use program::OptimizedModule;
pub use program::{MAX_REGISTER_FILES, Prepared, Program};
pub use run::{OverBudget, Run};

#[cfg(test)]
mod tests;
