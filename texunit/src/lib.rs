//! # texunit: DetGL's texture unit
//!
//! Formats, texel storage, samplers, wrap modes, level of detail, filters and depth compare,
//! over batches of 64 lanes. It does not depend on draws, shaders or GL.
//!
//! The modules are layers: each uses only those above it in this table.
//!
//! | module | contents |
//! |---|---|
//! | [`kernels`] | which kernels ran: a log for tests |
//! | [`lanes`] | batches of 64 lanes, instruction-set dispatch, gathers, exact math; the only `unsafe` |
//! | [`format`](mod@format) | the table of texel formats, and conversions to and from `f32` |
//! | [`pixel`] | pixels in client memory and texels as numbers, 64 at a time: upload, read-back, copy |
//! | [`sampler`] | sampler state: wrap modes, filters, LOD range, compare |
//! | [`image`] | texel storage: levels and faces, shared by reference, copied on write; completeness |
//! | [`mipmap`] | the box filter that makes a level from the next larger one |
//! | [`trace`] | the record of how one lane was sampled |
//! | [`plan`] | how an image is sampled with a sampler: data, decided once per draw |
//! | [`sample`] | the kernels: face → LOD → wrap → fetch → compare → filter → expand |
//!
//! **Invariant: one definition of each number.** The order of scalar `f32` operations in this
//! source is the definition. Every instruction set gives the same bits.

pub mod format;
pub mod image;
pub mod kernels;
pub mod lanes;
pub mod mipmap;
pub mod pixel;
pub mod plan;
pub mod sample;
pub mod sampler;
pub mod trace;

/// The level of optimization that this crate is compiled with, as `opt-level` has it: at `"0"` it is slower by far.
pub const OPT_LEVEL: &str = env!("TEXUNIT_OPT_LEVEL");
