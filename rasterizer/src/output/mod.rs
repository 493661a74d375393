//! From shaded fragments to the words of the attachments: stencil and depth test, blending, logic
//! operations, masks, packing.

mod blend;
mod color;
mod depth;
mod logic;
mod merge;
mod stencil;

pub use blend::factors as blend_factors;
pub use color::{
    BlockColors, Color, ColorClass, ColorPlan, OpaqueBlocks, pack_colors, store_masked,
};
pub use depth::{DepthPlan, DepthTest};
pub use merge::{Fragments, Tests, store_samples, test, write_blocks, write_samples};
pub use stencil::{BlockStencil, Reference, StencilPlan, StencilUpdate};
