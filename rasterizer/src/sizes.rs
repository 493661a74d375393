//! Sizes that every stage agrees on.

/// The most samples that a pixel can have.
pub const MAX_SAMPLES: usize = 4;

/// Pixels along a side of a tile.
pub const TILE: u32 = 64;

/// Subpixels of a pixel along an axis (`GL_SUBPIXEL_BITS` = 8).
pub const SUBPIXEL: i32 = 256;

/// Window coordinates beyond this many pixels are cut off before they become fixed point: with 8
/// bits of subpixels every edge function then fits its integers ([`crate::raster`]).
pub const GUARD_BAND: f64 = 32768.0;

/// How many clip distances a vertex can have.
pub const MAX_DISTANCES: usize = 8;
