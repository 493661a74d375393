//! The vertex stage: fetch attributes, run the vertex program over 64 vertices at once, and place
//! the results in the window.

mod assemble;
mod fetch;
mod geometry;
mod ids;
mod place;
mod shade;

pub use assemble::{EdgeFlags, Primitive, Primitives, primitives};
pub use geometry::{Geometry, VARYINGS};
pub use ids::{Ids, Wanted, ordinals};
pub use place::{Outcode, snap};
pub use shade::{VertexStage, shade};
