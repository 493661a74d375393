//! Per-fragment operations: tests, blending, masks, clamping.

pub(crate) mod blend;
pub(crate) mod clamp;
pub(crate) mod masks;
pub(crate) mod stencil;
pub(crate) mod tests;
