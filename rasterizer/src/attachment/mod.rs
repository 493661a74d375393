//! What a pass draws into: attachments as tiles of 64×64 words in lane order.

mod batch_layout;
mod depth_format;
mod depth_plane;
mod encode;
mod mask;
mod plane;
mod resolve;
mod surface;
mod words;

pub use batch_layout::{BatchLayout, LoadOp, load, store, with_texels, with_words};
pub use depth_format::{DepthFormat, depth_words};
pub use depth_plane::{BlockDepth, DepthPlanes, clamp_depth, value_at};
pub use encode::{decode_color, encode_color, texel_color, texel_words};
pub use mask::{are_equal, expand_mask};
pub use plane::{BLOCKS, WordPlane};
pub use surface::{RowSpan, RowWriter, Slices, StoreContext, Surface, TileTarget};
pub(crate) use words::is_attachable;
pub use words::{WordMask, all_bits, component_bits};
