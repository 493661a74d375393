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
//! | `plan` | every decision of a draw, taken once before its loops |
//! | `vertex` | attributes to lanes, the vertex program, the viewport |
//! | `primitive` | assembly, clipping, snapping, culling |
//! | `raster` | tiles, coverage, interpolation, batches of fragments |
//! | [`ir`], [`shader`] | what a shader is; optimizer, register program, 64-lane interpreter |
//! | `output` | depth test, blending, masks, packing |
//! | `target` | attachments as tiles of words in lane order |
//! | [`trace`] | what happened to a pixel that is watched |
//! | [`stack`] | room for what recurses as deep as shaders nest |
//! | `pool` | what threads work with, kept, and how they share the work |
#![forbid(unsafe_code)]

mod crew;
pub mod driver;
pub mod ir;
mod output;
mod plan;
mod pool;
mod primitive;
mod raster;
pub mod shader;
pub mod stack;
mod target;
pub mod trace;
mod vertex;
