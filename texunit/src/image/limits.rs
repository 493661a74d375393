//! The limits of levels.

/// The largest width and height of a level. Byte offsets then fit the 31 bits a gather takes.
pub const MAX_SIZE: u32 = 16_384;
/// The largest width, height and depth of a three-dimensional level.
pub const MAX_SIZE_3D: u32 = 512;
/// The faces of a cube.
pub const FACES: usize = 6;
/// The most layers of an array, of an array of cubes the most faces; also 2048 layers of four samples
/// each, which lie as layers.
pub const MAX_LAYERS: u32 = 8192;

/// How many levels an image of [`MAX_SIZE`] has: 16384 to 1.
pub const MAX_LEVELS: usize = MAX_SIZE.ilog2() as usize + 1;

/// The most bytes of a level: offsets then fit the signed 32 bits that a gather takes.
pub const MAX_LEVEL_BYTES: usize = 1 << 30;

/// Bytes after the last texel, so that gathers of whole words from it stay inside.
pub const PADDING: usize = 3;
