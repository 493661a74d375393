//! An entry of the gallery.

use crate::window::{Program, Rendered};

/// A program and its result.
pub(super) struct Entry {
    pub(super) program: Program,
    pub(super) rendered: Rendered,
    /// The driver's plans of its draws, without duplicates.
    pub(super) plans: Vec<String>,
}
