//! From shaded fragments to the words of the attachments: depth test, blending, masks, packing.

mod blend;
mod color;
mod depth;

pub use color::{ColorPlan, WriteColor, color_word, expand_mask, pack_mask};
pub use depth::{DepthFormat, DepthPlan, DepthTest};
