//! The table of built-ins. Each row holds the name, the type or signature, the availability, the
//! stages, and what it is lowered to.

pub mod functions;
mod samplers;
pub mod textures;
pub mod variables;
