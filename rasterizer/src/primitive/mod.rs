//! From vertices to what the rasterizer fills: assemble, cut away what cannot be seen, snap to the
//! subpixel grid, cull.

mod clip;
mod line;
mod outline;
mod planes;
mod setup;
mod triangles;
mod unseen;

pub use line::LineRun;
pub use outline::{rectangle, stipple_lines};
pub use planes::{Across, DepthSetup, Inverse, Plane, Rows, point_coord};
pub use setup::{Kind, Part, Setup, Shape, setup};
pub use unseen::{Drawn, Reason, Reasons, Side, reasons};
