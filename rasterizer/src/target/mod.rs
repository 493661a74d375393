//! What a pass draws into: attachments as tiles of 64×64 words in lane order.

mod place;
mod plane;
mod resolve;
mod surface;
mod words;

pub use place::{Old, Place, with_texels, with_words};
pub use plane::{BLOCKS, Plane};
pub use surface::{MAX_SAMPLES, Part, Put, Slices, Storing, Surface, TILE, TileTarget};
pub(crate) use words::is_attachable;
pub use words::{WordMask, all_bits, component_bits};
