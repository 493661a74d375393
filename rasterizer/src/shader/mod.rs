//! From IR to lanes: optimize, lower to a register program, run it over 64 lanes.
//!
//! The modules in the order in which a shader passes through them:
//!
//! | module | is |
//! |---|---|
//! | [`optimize`] | passes over the structured IR |
//! | [`lower`] | structured IR → flat [`inst`]ructions over virtual registers |
//! | [`alike`] | what all lanes do alike: no mask is looked at |
//! | [`exits`] | how lanes leave a statement |
//! | [`owned`] | the variables that only one loop reads: stored without a mask |
//! | [`compute`] | what an instruction computes: an operation, or a tree of them |
//! | [`fuse`] | several operations as one instruction |
//! | [`preamble`] | the values that a draw computes once |
//! | [`allocate`] | real registers for virtual ones |
//! | [`repeat`] | lookups at the points of the one before |
//! | [`product`] | the programs that need no interpreter |
//! | [`machine`] | the interpreter: 64 lanes an instruction, with an execution [`mask`] |

mod alike;
mod allocate;
mod compute;
mod exits;
mod fuse;
mod inst;
mod lower;
mod machine;
mod mask;
mod optimize;
mod owned;
mod preamble;
mod product;
mod program;
mod repeat;
mod run;
mod schedule;
mod sources;

pub use machine::{Machine, Tracer};
pub use product::{Part, Product};
pub(crate) use program::Draft;
#[cfg(test)]
use program::Fusing;
pub use program::{BANKS, Prepared, Program};
pub use run::{OverBudget, Run};
pub(crate) use sources::Sources;

#[cfg(test)]
mod tests;
