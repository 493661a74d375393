//! The vertex stage: fetch attributes, run the vertex program over 64 vertices at once, and place
//! the results in the window.

mod fetch;
mod ids;
mod shade;

pub use ids::{Ids, Unique, ordinals};
pub use shade::{GUARD_BAND, Geometry, Outcode, VertexStage, shade};
