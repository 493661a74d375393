//! Queries and fences.

pub(crate) mod conditional;
pub(crate) mod fences;
pub(crate) mod named;
pub(crate) mod queries;
