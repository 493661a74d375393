//! The short way for most textures: two-dimensional, of bytes, sRGB bytes, halves, floats, depths or
//! blocks, where neither the border nor another face is reached. Nothing is compared here: where the
//! texel that it gives of each lane is all that a comparison needs, [`super::uniform`] makes it.
//!
//! Gives the bits of the general way in `filter` (a test holds this), in fewer passes: whole
//! offsets in one loop, the two texels of a row in one gather, channels from words in registers.

pub mod blocks;
mod channels;
mod filter;
mod offsets;
mod quad;
mod quad_position;
#[cfg(test)]
mod tests;

pub use channels::channels_of_texel;
pub use filter::{linear, nearest, texels};
pub use offsets::word_offsets;
pub use quad::{Places, QuadLoad, TexelQuad, load_quad};
