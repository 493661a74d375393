//! Vertices: current attributes, immediate mode, vertex arrays, draw calls.

pub(crate) mod array_objects;
pub(crate) mod arrays;
pub(crate) mod bindings;
pub(crate) mod counted;
pub(crate) mod draws;
pub(crate) mod elements;
pub(crate) mod immediate;
pub(crate) mod indices;
pub(crate) mod indirect;
pub(crate) mod interleaved;
pub(crate) mod locked;
pub(crate) mod named;
pub(crate) mod packed;
pub(crate) mod rect;
pub(crate) mod restart;
pub(crate) mod runs;
