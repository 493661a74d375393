//! From vertices to what the rasterizer fills: assemble, cut away what cannot be seen, snap to the
//! subpixel grid, cull.

mod assemble;
mod clip;
mod setup;

pub use assemble::{Primitives, primitives};
pub use setup::{Facing, Kind, SUBPIXEL, Setup, Shape, setup, snap};
