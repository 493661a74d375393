//! # rasterizer: a Vulkan-style software driver
//!
//! Takes immutable pipelines and command buffers, gives pictures. It knows nothing of GL state,
//! GLenums or GLSL text.
//!
//! The layers from below; each uses only those above it in this table:
//!
//! | layer | is |
//! |---|---|
//! | [`kernels`] | which ways ran: a log for tests |
//! | `sizes` | sizes that every stage agrees on: tile, subpixel, guard band, samples, clip distances |
//! | `threads` | the thread pool, pools of reusable objects, stacks for deep recursion |
//! | [`ir`] | what a shader is: modules of typed expressions and structured statements |
//! | `desc` | what a client describes: plain data without anything that runs |
//! | [`trace`] | what happened to a watched pixel, as records |
//! | [`shader`] | optimizer, register program, interpreter of 64 lanes |
//! | `attachment` | attachments as tiles of words in lane order, and how texels are encoded in them |
//! | `output` | per-fragment operations: stencil and depth test, blending, logic operations, masks |
//! | `vertex` | input assembly, attribute fetch, the vertex program, the viewport transform |
//! | `primitive` | clipping, snapping, culling, outlines, plane equations |
//! | `plan` | pipelines, and every decision of a draw, taken once before its loops |
//! | `raster` | coverage, interpolation, batches of fragments, the work of a tile |
//! | [`driver`] | device, images, command buffers, queue, passes: what a client calls |
#![forbid(unsafe_code)]

mod attachment;
mod desc;
pub mod driver;
pub mod ir;
pub mod kernels;
mod output;
mod plan;
mod primitive;
mod raster;
pub mod shader;
mod sizes;
mod threads;
pub mod trace;
mod vertex;

pub use threads::stack;

/// The level of optimization that this crate is compiled with, as `opt-level` has it: at `"0"` it is slower by far.
pub const OPT_LEVEL: &str = env!("RASTERIZER_OPT_LEVEL");
