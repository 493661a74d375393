//! The vertex stage: fetch attributes, run the vertex program over 64 vertices at once, and place
//! the results in the window.

pub(crate) mod fetch;
mod ids;
mod place;
mod shade;

pub use ids::{Ids, Wanted, ordinals};
pub use place::GUARD_BAND;
pub use place::{Outcode, snap};
pub use shade::{Geometry, VARYINGS, VertexStage, shade};
