//! What every layer needs: GL's constants and types, refusals, limits, and the types of parameters.

pub(crate) mod answer;
pub(crate) mod clamp;
pub(crate) mod compare;
pub(crate) mod component;
pub(crate) mod convert;
pub(crate) mod inverse;
pub(crate) mod texture_unit;
pub(crate) mod topology;

pub mod angle;
pub(crate) mod args;
pub(crate) mod arithmetic;
pub(crate) mod assembly_limits;
pub mod availability;
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
