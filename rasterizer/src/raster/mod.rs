//! Filling: which pixels a shape covers, how values run over it, and the tiles that do the work.
//!
//! A pass is cut into tiles of 64×64 pixels; each thread takes tiles, and within a tile every
//! clear and shape of the pass is done in order, so that the result does not depend on threads.

mod area;
mod band;
mod batch;
mod block;
mod broad;
mod clear;
mod cover;
mod coverage;
mod depths;
mod group;
mod inputs;
mod interpolate;
mod job;
mod lanes;
mod pack;
mod pixels;
mod product;
mod quotients;
mod run;
mod shading;
mod shares;
mod small;
mod tile;
mod watched;
mod weights;

pub use clear::ClearJob;
pub use job::{Chunk, DrawJob, Entry, PassJob, ShapeLists, TileJob};
pub use tile::Worker;
pub use watched::{Formats, Spot};
