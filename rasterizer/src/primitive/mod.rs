//! From vertices to what the rasterizer fills: assemble, cut away what cannot be seen, snap to the
//! subpixel grid, cull.

mod clip;
mod invisible;
mod line;
mod outline;
mod planes;
mod setup;
mod triangles;

pub use invisible::{InvisibleReason, InvisibleReasons, PrimitiveKind, ViewVolumeSide, reasons};
pub use line::LineFragments;
pub use outline::{rectangle, stipple_lines};
pub use planes::{
    ConstantDirection, DepthSetup, InverseMatrix, Plane, VertexPlanes, line_direction, point_coord,
};
pub use setup::{Clipping, EMPTY_BOUNDS, Setup, Shape, ShapeKind, setup};
