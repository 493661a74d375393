//! What every layer needs: GL's constants and types, refusals, limits, and the types of parameters.

pub mod angle;
pub(crate) mod args;
pub(crate) mod arithmetic;
pub(crate) mod assembly_limits;
pub(crate) mod begin_end;
pub(crate) mod client_memory;
pub mod constants;
pub mod error;
pub(crate) mod fallback;
pub(crate) mod limits;
pub(crate) mod params;
pub mod types;
pub(crate) mod value;
pub(crate) mod vector;
