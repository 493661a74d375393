//! Pictures: read, written, and drawn by formula.
//!
//! Every picture file that a lecture's program reads has a procedural replacement, so that the gallery
//! needs no files. All arithmetic is `+ - * /` and `sqrt` on `f64`: the same bits on every machine.

pub mod demon;
mod file;
pub mod ground;
mod image;
pub mod night;
pub mod noise;
pub mod normals;
pub mod sky;
pub mod solid;
pub mod wall;
pub mod window_glass;

pub use file::{load, save, stand_in};
pub use image::{Color, Picture, add, dim, disc, mix, packed_pixel_t, painting, smooth, stroke};
