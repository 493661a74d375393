//! Buffer objects: data, mapping, indexed bindings.

pub(crate) mod data;
pub(crate) mod indexed;
pub(crate) mod map;
