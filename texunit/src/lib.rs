//! # texunit: DetGL's texture unit
//!
//! Formats, texel storage, samplers, wrap modes, level of detail, filters and depth compare,
//! over batches of 64 lanes. It knows nothing of draws, shaders or GL.
//!
//! The modules in the order in which data passes through them:
//!
//! | module | is |
//! |---|---|
//! | [`lanes`] | the batch of 64, instruction-set dispatch, gather, exact math; the only `unsafe` |
//! | [`format`](mod@format) | the table of texel formats, and their conversions to and from `f32` |
//! | [`pixel`] | pixels in a client's memory and texels as numbers, 64 at a time: uploads, read-back, copies |
//! | [`image`] | levels and faces of texels, shared by reference, copied when written |
//! | [`mipmap`] | the box filter that makes a level from the one before |
//! | [`sampler`] | wrap modes, filters, LOD range, compare: the state beside the texels |
//! | [`plan`] | one decision per draw: which kernels sample this image with this sampler |
//! | `sample` | the steps of a sample: face → LOD → wrap → fetch → compare → filter → expand |
//! | [`trace`] | the same steps of one lane, written down |
//!
//! **Invariant: one definition of each number.** The order of scalar `f32` operations in this
//! source is the definition. Every instruction set gives the same bits.

pub mod format;
pub mod image;
pub mod lanes;
pub mod mipmap;
pub mod pixel;
pub mod plan;
pub mod sample;
pub mod sampler;
pub mod trace;
