//! Known mistakes that can be built into the formulas, to prove that the checks can fail.
//!
//! A check compares the driver with an oracle. If the comparison missed differences, it would pass
//! for any driver; so every oracle can be computed with one of the mistakes that implementations
//! make, and the check of that oracle must then fail. [`MUTATIONS`] lists all of them.

mod table;
mod variant;

pub use table::{MUTATIONS, MutationRow};
pub use variant::{Mutation, Variant};
