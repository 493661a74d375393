//! Why texels could not be stored or reached.

use super::limits::{MAX_LEVEL_BYTES, MAX_LEVELS};
use crate::format::Format;
use thiserror::Error;

/// Why texels could not be stored or reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum ImageError {
    /// A side above the shape's limit, or more bytes than [`MAX_LEVEL_BYTES`].
    #[error(
        "a level of {width}×{height}×{depth} texels is too large: see the limits of its target, \
         and at most {MAX_LEVEL_BYTES} bytes"
    )]
    TooLarge {
        /// Texels in a row.
        width: u32,
        /// Rows.
        height: u32,
        /// Slices or layers.
        depth: u32,
    },
    /// A level of an array of cubes that is not made of whole cubes.
    #[error(
        "a level of {width}×{height} texels in {depth} layers is no array of cubes: faces are \
         squares, and six layers make a cube"
    )]
    NotCubes {
        /// Texels in a row.
        width: u32,
        /// Rows.
        height: u32,
        /// Faces of all cubes.
        depth: u32,
    },
    /// The allocation failed.
    #[error("there is no memory for {bytes} bytes of texels")]
    OutOfMemory {
        /// The bytes requested.
        bytes: usize,
    },
    /// A border that no image of this shape or format has.
    #[error("a border of {border:?} texels along s, t, r does not go with this target or format")]
    WrongBorder {
        /// Texels of border on either side along s, t, r.
        border: [u32; 3],
    },
    /// A slice of texels is shorter than its box.
    #[error("{width}×{height}×{depth} texels take {needed} bytes, the slice has {got}")]
    TooShort {
        /// Texels in a row.
        width: u32,
        /// Rows.
        height: u32,
        /// Slices or layers.
        depth: u32,
        /// Bytes that were needed.
        needed: usize,
        /// Bytes that were given.
        got: usize,
    },
    /// A box reaches outside its level.
    #[error("the box at {at:?} of {size:?} texels reaches outside its level of {level:?}")]
    Outside {
        /// Its lowest corner.
        at: [i32; 3],
        /// Its size.
        size: [u32; 3],
        /// The level's width, height and depth.
        level: [u32; 3],
    },
    /// A box of a compressed level that cuts its blocks of 4×4 texels.
    #[error(
        "the box at {at:?} of {size:?} texels cuts the 4×4 blocks of a compressed image: its \
         corner must be a multiple of 4, its size too or reach the edge"
    )]
    CutsBlocks {
        /// Its lowest corner.
        at: [i32; 3],
        /// Its size.
        size: [u32; 3],
    },
    /// A face or level number that no image of this shape has.
    #[error(
        "there is no face {face}, level {level}: faces are below {faces}, levels below {MAX_LEVELS}"
    )]
    NoSuchLevel {
        /// The face requested.
        face: usize,
        /// The level requested.
        level: usize,
        /// Faces of the shape.
        faces: usize,
    },
    /// A level that is needed was never given.
    #[error("face {face} has no level {level}")]
    Missing {
        /// The face requested.
        face: usize,
        /// The level requested.
        level: usize,
    },
    /// Mipmaps of a format that has no mean: integers and stencil.
    #[error("mipmaps of integers and of stencil values cannot be generated: they are not averaged")]
    NoMean {
        /// The base level's format.
        format: Format,
    },
}
