//! From vertices to what the rasterizer fills: assemble, cut away what cannot be seen, snap to the
//! subpixel grid, cull.

mod assemble;
mod clip;
mod line;
mod outline;
mod setup;
mod triangles;
mod unseen;

pub use assemble::{Primitive, Primitives, primitives};
pub use clip::{Corner, MAX_DISTANCES};
pub use line::LineRun;
pub use outline::{rectangle, stipple_lines};
pub use setup::{Facing, Kind, Part, SUBPIXEL, Setup, Shape, setup};
pub use unseen::{Drawn, Reason, Reasons, Side, reasons};
