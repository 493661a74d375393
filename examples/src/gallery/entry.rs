//! An entry of the gallery.

use crate::window::{Program, Rendered};

/// A program and its result.
pub(super) struct Entry {
    pub(super) program: Program,
    pub(super) rendered: Rendered,
    /// The driver's plans of its draws, without duplicates.
    pub(super) plans: Vec<String>,
    /// How one of its pixels came to be.
    pub(super) explained: Option<Explained>,
}

/// A pixel, and how it came to be.
pub(super) struct Explained {
    /// The side of a square picture, in which the pixel is.
    pub(super) size: usize,
    /// Column and row from the upper left.
    pub(super) pixel: [usize; 2],
    /// The explanation.
    pub(super) text: String,
}
