//! # rasterizer: a Vulkan-style software driver
//!
//! Takes immutable pipelines and command buffers, gives pictures. It knows nothing of GL state,
//! GLenums or GLSL text.
//!
//! The modules in the order in which a draw passes through them:
//!
//! | module | is |
//! |---|---|
//! | [`driver`] | device, images, buffers, pipelines, command buffers, queue |
//! | [`ir`] | what a shader is: typed, scalar, structured |
//! | [`shader`] | optimizer, register program, 64-lane interpreter |
#![forbid(unsafe_code)]

pub mod driver;
pub mod ir;
pub mod shader;
