//! The fixed function as a generator of shaders.

pub(crate) mod fixed;
