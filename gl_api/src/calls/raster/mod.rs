//! Rasterization state: points, lines, polygons, samples.

pub(crate) mod lines;
pub(crate) mod multisample;
pub(crate) mod points;
pub(crate) mod polygon;
