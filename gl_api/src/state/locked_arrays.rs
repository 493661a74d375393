//! Locked arrays: `EXT_compiled_vertex_array`.
//!
//! A client promises not to change some vertices until it unlocks them, so that a driver may keep what
//! it computed of them. A draw computes them anew here, which nobody can tell from outside.

use crate::base::types::*;

/// The first locked vertex and how many there are; none where the arrays are not locked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct LockedArrays {
    pub first: GLint,
    pub count: GLsizei,
}
