//! Shader modules: generated for the fixed function, and made of linked programs.

pub(crate) mod executable;
pub(crate) mod fixed;
