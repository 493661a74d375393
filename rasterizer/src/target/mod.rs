//! What a pass draws into: attachments as tiles of 64×64 words in lane order.

mod surface;

pub(crate) use surface::stored_components;
pub use surface::{Plane, Surface, TILE};
