//! Transformation: matrices, viewport, clip planes, texture coordinate generation.

pub(crate) mod clip;
pub(crate) mod matrix;
pub(crate) mod texgen;
pub(crate) mod viewport;
pub(crate) mod viewport_arrays;
