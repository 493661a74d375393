//! Locked arrays: `EXT_compiled_vertex_array`. Locking allows a driver to reuse transformed vertices; this one does
//! not.

use crate::base::types::*;

/// The first locked vertex and how many there are; none where the arrays are not locked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct LockedArrays {
    pub first: GLint,
    pub count: GLsizei,
}
