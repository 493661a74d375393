//! What several test binaries share.

pub mod digest;
pub mod refusal;
pub mod shading;
pub mod state_table;
