//! Texel storage: faces and levels, shared by reference, copied when written.

use crate::format::Format;
use std::sync::Arc;

/// The shape of an image, and of the coordinates that address it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shape {
    /// Two coordinates, one face.
    D2,
    /// A direction, six faces in the order +X, -X, +Y, -Y, +Z, -Z.
    Cube,
}

/// One face of one level. Rows run from t = 0 up, tightly packed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Level {
    /// How its texels are stored.
    pub format: Format,
    /// Texels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The texels, and then three bytes of padding so that a four-byte gather of the last texel
    /// stays inside.
    pub texels: Vec<u8>,
}

/// Faces × levels, each of which may be missing, as GL lets them be specified one by one.
/// Cloning shares the levels.
#[derive(Clone, Debug)]
pub struct Image {
    shape: Shape,
    /// `levels[face][level]`.
    levels: Vec<Vec<Option<Arc<Level>>>>,
}
