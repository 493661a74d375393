//! Evaluators: maps, grids, evaluation.

pub(crate) mod basis;
pub(crate) mod coord;
pub(crate) mod grid;
pub(crate) mod map;
