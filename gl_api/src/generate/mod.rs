//! The fixed function as a generator of shaders.

pub(crate) mod executable;
pub(crate) mod fixed;
