//! The vertex stage: fetch attributes, run the vertex program over 64 vertices at once, and place
//! the results in the window.

mod assemble;
mod fetch;
mod geometry;
mod geometry_stage;
mod shade;
mod slices;
mod vertex_list;
mod viewport;

pub use assemble::{EdgeFlags, Primitive, Primitives, primitives};
pub use geometry::{Geometry, VARYINGS};
pub use geometry_stage::{Emitted, GeometryStage, Layers, Viewports};
pub use shade::{Placement, VertexStage, shade};
pub use vertex_list::{VertexIds, VertexList, ordinals};
pub use viewport::{Outcode, snap};
