//! Buffer objects: data, mapping, indexed bindings.

pub(crate) mod clear;
pub(crate) mod data;
pub(crate) mod indexed;
pub(crate) mod invalidate;
pub(crate) mod map;
pub(crate) mod named;
