//! What every layer needs: GL's constants and types, errors, limits, conversion tables, and the types of parameters.

pub mod angle;
pub(crate) mod args;
pub(crate) mod assembly_limits;
pub mod availability;
pub(crate) mod begin_end;
pub(crate) mod clamp;
pub(crate) mod client_memory;
pub(crate) mod compare;
pub(crate) mod component;
pub mod constants;
pub(crate) mod convert;
pub(crate) mod core_profile;
pub mod error;
pub(crate) mod float_environment;
pub(crate) mod inverse;
pub(crate) mod limits;
pub(crate) mod memory;
pub(crate) mod params;
pub(crate) mod query_value;
pub(crate) mod refused_result;
pub(crate) mod texture_unit;
pub(crate) mod topology;
pub mod types;
pub(crate) mod vector;
pub(crate) mod version;
