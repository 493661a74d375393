//! The fast path of most textures: two-dimensional, of bytes, sRGB bytes, halves, floats, depths or
//! blocks, where neither the border nor another face is read. Depths are
//! compared by [`LinearCompared`] before a linear filter, by [`super::uniform`] after a nearest one.
//!
//! Same bits as the general filters in [`super::filter`] (a test holds this), in fewer passes: byte
//! offsets in one loop, the two texels of a row in one gather, channels from words in registers.

pub mod blocks;
mod channels;
mod filter;
mod offsets;
mod quad;
mod quad_position;
#[cfg(test)]
mod tests;

pub use channels::{bytes_of_texel, channel_of_texel, channels_of_quad, channels_of_texel};
pub use filter::{LinearCompared, linear, nearest, nearest_along, texels};
pub use offsets::{add_offsets, word_offsets};
pub use quad::{Addresses, QuadLoad, TexelQuad, load_quad};
