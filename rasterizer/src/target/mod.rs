//! What a pass draws into: attachments as tiles of 64×64 words in lane order.

mod surface;

pub use surface::{Plane, Surface, TILE};
pub(crate) use surface::{is_attachable, stored_components};
