//! Filling: which pixels a shape covers, how values run over it, and the tiles that do the work.
//!
//! A pass is cut into tiles of 64×64 pixels; each thread renders tiles, and within a tile every
//! clear and shape of the pass is done in order, so that the result does not depend on threads.

mod area;
mod batch;
mod block;
mod block_group;
mod budget;
mod clear;
mod edge_functions;
mod fragment_depth;
mod hidden;
mod inputs;
mod interpolate;
mod job;
mod large_triangles;
mod line_rectangle;
mod pack_pixels;
mod perspective;
mod pixel_batch;
mod plane_group;
mod plane_weights;
mod sample_shading;
mod sampled_triangle;
mod shading;
mod shape_cover;
mod shape_lanes;
mod small_triangles;
mod texel_product;
mod tile;
mod tile_planes;
mod watched;
mod window_blocks;

pub use budget::{DrawBudget, FIRST_WAVE, FREE_OPERATIONS, WAVE, free_operations};
pub use clear::ClearJob;
pub use job::{Chunk, DrawJob, PassJob, ShapeLists, TileCommand, TileJob};
pub use tile::TileRenderer;
pub use watched::{Formats, WatchedPixel};
